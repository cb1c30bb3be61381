"""What each rule is worth: the scores without it."""
from .text import COLUMNS, mean, percent, setting, table

# The setting that takes a rule away.
RULES = (
    ("nothing", {}),
    ("room rule", {"room_opening_percent": 100}),
    ("passage rule", {"passage_opening_percent": 100}),
    ("niche rule", {"niche_mm2": 0}),
    ("walls that part rooms", {"shared_wall_mm": 10000000}),
    ("rules for lived-in maps", {"lived_in_permille": 1000}),
    ("open-plan rule", {"open_plan_percent": 100}),
    ("wide openings", {"door_mm": 10000}),
    ("halls", {"hall_mm": 0}),
    ("clutter", {"clutter_mm": 0}),
    ("specks", {"speck_mm2": 0}),
    ("smallest room", {"smallest_room_mm2": 0}),
    ("isolated regions", {"isolated_permille": 0}),
    ("unwalled rooms", {"unwalled_percent": 0}),
)

INTRODUCTION = """\
Each row takes one rule away from the defaults. Means over the maps, in %. A rule that a set does
not need may carry another: furniture is rare in offices, and windows leak on robots' maps alone.
The command is `roomseg bench DATASET --config SETTING`; for the simulated homes see the last part.
"""


def run(bench):
    folders = [(name, bench.changed(name)) for name in bench.sets]
    folders.append(("simulated homes, medium", bench.simulated("medium", "--furnished")))
    tasks = [(folder, config) for _, folder in folders for _, config in RULES]
    results = iter(bench.in_parallel("ablation", bench.scores, tasks))
    text = [INTRODUCTION]
    figures = {}
    for name, _ in folders:
        rows = []
        figures[name] = {}
        for rule, config in RULES:
            scores = next(results)
            means = {key: mean(s[key] for s in scores) for _, key in COLUMNS}
            figures[name][rule] = means
            rows.append([rule, setting(config)] + [percent(means[key]) for _, key in COLUMNS])
        text.append("\n### %s\n\n" % name)
        text.append(table(["without", "setting"] + [title for title, _ in COLUMNS], rows,
                          text_columns=2))
    return "".join(text), figures
