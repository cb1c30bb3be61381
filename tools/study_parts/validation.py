"""Whether parameters picked on some maps hold on others."""
import collections
import itertools
import random

from .text import mean, percent, setting, table, verdict

# Values to pick from; the default joins them when it is not among them.
GRID = {
    "room_opening_percent": (79, 83, 87),
    "passage_opening_percent": (36, 41, 46),
    "lived_in_permille": (0, 3, 1000),
    "shared_wall_mm": (700, 1000, 1500),
    "niche_mm2": (0, 3000000),
}
SPLITS = 50  # into random halves
TARGET = 0.005  # the left-out figure is at most this much below the tuned one

INTRODUCTION = """\
Parameters are picked from a grid by the mean V of the training maps: all sets, the versions of a
map together, so that the map with furniture never helps to pick for the one without. *Tuned* is
the best of the grid on all maps, *leave-one-out* scores each map with what was picked on the
others, *split-half* scores each half with what was picked on the other, mean of %d random splits.
"""


def values(bench, field):
    return sorted(set(GRID[field]) | {bench.config[field]})


def score_points(bench, points):
    """For each point the V of each map, mean over its versions."""
    folders = [bench.changed(name) for name in bench.sets]
    tasks = [(folder, point) for point in points for folder in folders]
    results = iter(bench.in_parallel("validation", bench.scores, tasks))
    v = []
    for _ in points:
        versions = collections.defaultdict(list)
        for scores in itertools.islice(results, len(folders)):
            for s in scores:
                versions[s["name"]].append(s["v"])
        v.append({name: mean(scores) for name, scores in versions.items()})
    return v


def pick(v, names):
    """Index of the best point on these maps; of equal ones the first."""
    return max(range(len(v)), key=lambda i: (mean(v[i][name] for name in names), -i))


def leave_one_out(v, names):
    """For each map the index of the point that is best on the others."""
    return [pick(v, [n for n in names if n != left_out]) for left_out in names]


def split_half(v, names):
    figures = []
    for seed in range(SPLITS):
        source = random.Random(seed)
        order = [name for _, name in sorted((source.random(), name) for name in names)]
        halves = order[:len(order) // 2], order[len(order) // 2:]
        for training, test in (halves, halves[::-1]):
            chosen = v[pick(v, training)]
            figures.append(mean(chosen[name] for name in test))
    return mean(figures)


def picks_table(bench, points, picks):
    rows = []
    for field in GRID:
        counts = collections.Counter(points[p][field] for p in picks)
        chosen = ", ".join("%d (%d x)" % item for item in sorted(counts.items()))
        rows.append([field, ", ".join(map(str, values(bench, field))),
                     str(bench.config[field]), chosen])
    return table(["field", "grid", "default", "picked in leave-one-out"], rows,
                 text_columns=4)


def lost_table(points, v, names, best, picks):
    """Maps that score less with what was picked without them."""
    rows = []
    for name, p in sorted(zip(names, picks), key=lambda item: v[item[1]][item[0]] -
                          v[best][item[0]]):
        if v[best][name] - v[p][name] >= TARGET:
            others = {f: x for f, x in points[p].items() if x != points[best][f]}
            rows.append([name, percent(v[best][name]), percent(v[p][name]), setting(others)])
    if not rows:
        return ""
    return "\nMaps that lose more than %s points when left out:\n\n%s" % (
        percent(TARGET, 1), table(["map", "tuned", "left out", "picked without it"], rows))


def run(bench):
    axes = [values(bench, field) for field in GRID]
    points = [dict(zip(GRID, point)) for point in itertools.product(*axes)]
    v = score_points(bench, points)
    names = sorted(v[0])
    if len(names) < 2:
        return "Needs at least two maps.\n", {}
    default = points.index({field: bench.config[field] for field in GRID})
    best = pick(v, names)
    picks = leave_one_out(v, names)
    figures = {
        "defaults": mean(v[default].values()),
        "tuned": mean(v[best].values()),
        "leave_one_out": mean(v[p][name] for p, name in zip(picks, names)),
        "split_half": split_half(v, names),
        "tuned_config": points[best],
        "left_out": {name: {"v": v[p][name], "tuned_v": v[best][name], "config": points[p]}
                     for p, name in zip(picks, names)},
    }
    gap = figures["tuned"] - figures["leave_one_out"]
    titles = (("the defaults", "defaults"), ("tuned", "tuned"),
              ("leave-one-out", "leave_one_out"), ("split-half", "split_half"))
    text = [INTRODUCTION % SPLITS, "\n",
            table(["parameters", "mean V"],
                  [[title, percent(figures[key])] for title, key in titles]),
            "\nLeave-one-out is %s points below tuned; aim: at most %s, %s. "
            % (percent(gap), percent(TARGET, 1), verdict(gap <= TARGET)),
            "Best of %d points on all maps: %s.\n\n" % (len(points), setting(points[best])),
            picks_table(bench, points, picks), lost_table(points, v, names, best, picks)]
    return "".join(text), figures
