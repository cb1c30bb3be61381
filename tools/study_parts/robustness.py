"""The same rooms, looked at otherwise."""
import shutil

from .text import mean, percent, table, verdict

# Title, options of `roomseg vary`, least mean V that each set should reach.
CHANGES = (
    ("as they are", (), None),
    ("turned by 17 degrees", ("--turn", "17"), 0.965),
    ("turned by 30 degrees", ("--turn", "30"), 0.965),
    ("turned by 45 degrees", ("--turn", "45"), 0.965),
    ("cells of 2.5 cm", ("--cells", "0.025"), None),
    ("cells of 5 cm", ("--cells", "0.05"), None),
    ("cells of 8 cm", ("--cells", "0.08"), 0.965),
    ("cells of 10 cm", ("--cells", "0.1"), None),
    ("salt and pepper, 1 %", ("--salt", "1"), 0.97),
    ("salt and pepper, 5 %", ("--salt", "5"), None),
    ("clutter, 0.1 a m2", ("--clutter", "0.1"), None),
    ("clutter, 0.3 a m2", ("--clutter", "0.3"), 0.95),
)

INTRODUCTION = """\
Maps and truth changed by `roomseg vary DATASET --set SET OPTIONS -o FOLDER`, then scored by
`roomseg bench FOLDER`. Clutter: squares of 25 to 55 cm that stand free on the floor. Mean V and
strict V in %; the lowest V of a map in brackets.
"""


def score(bench, set_name, options):
    folder = bench.changed(set_name, options)
    scores = bench.scores(folder)
    if options:
        shutil.rmtree(folder)  # turned maps take the most space of all
    return scores


def run(bench):
    tasks = [(bench, name, options) for _, options, _ in CHANGES for name in bench.sets]
    results = iter(bench.in_parallel("robustness", score, tasks))
    header = ["maps", "options"]
    for name in bench.sets:
        header += ["V, " + name, "strict V"]
    rows, figures = [], {}
    for title, options, target in CHANGES:
        row = [title, "`%s`" % " ".join(options) if options else ""]
        lowest = 1.0
        figures[title] = {}
        for name in bench.sets:
            scores = next(results)
            v = mean(s["v"] for s in scores)
            strict = mean(s["strict_v"] for s in scores)
            worst = min(scores, key=lambda s: s["v"])
            figures[title][name] = {"v": v, "strict_v": strict, "lowest_v": worst["v"],
                                    "lowest_map": worst["name"]}
            row += ["%s (%s)" % (percent(v), percent(worst["v"], 1)), percent(strict)]
            lowest = min(lowest, v)
        aim = "" if target is None else "%s: %s" % (percent(target, 1), verdict(lowest >= target))
        rows.append(row + [aim])
    return INTRODUCTION + "\n" + table(header + ["aim"], rows, text_columns=2), figures
