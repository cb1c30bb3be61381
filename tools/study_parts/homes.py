"""Simulated homes: as many as one likes, with a truth that nobody had to draw."""
from .text import mean, percent, table, verdict

KINDS = (("small", "--furnished"), ("medium", "--furnished"), ("large", "--furnished"),
         ("medium", "--empty"))
TARGET_V = 0.95
TARGET_F1 = 0.95
WORST = 12  # homes that are named

INTRODUCTION = """\
Seeds %s of `roomseg simulate --seed N --size SIZE --furnished -o FOLDER/N`, scored by `roomseg
bench FOLDER`. Seeds from 5000 on are kept for this table; to improve rules, use others. F1: rooms
found, a room counting as found when it and a label share more than half of the area that they cover
together. Means in %%.
"""


def summary(title, scores):
    keys = ("v", "completeness", "homogeneity", "strict_v", "room_f1")
    figures = {key: mean(s[key] for s in scores) for key in keys}
    figures["rooms_found"] = mean(s["rooms_found"] for s in scores)
    figures["rooms_true"] = mean(s["rooms_true"] for s in scores)
    row = [title, str(len(scores))] + [percent(figures[key]) for key in keys]
    row += ["%.1f" % figures["rooms_found"], "%.1f" % figures["rooms_true"]]
    return row, figures


def worst_homes(homes):
    rows = []
    for size, s in sorted(homes, key=lambda home: home[1]["v"])[:WORST]:
        rows.append(["`--seed %s --size %s`" % (s["name"], size), percent(s["v"]),
                     percent(s["completeness"]), percent(s["homogeneity"]),
                     percent(s["room_f1"]), str(s["rooms_found"]), str(s["rooms_true"])])
    return table(["furnished home", "V", "C", "H", "F1", "rooms", "true"], rows)


def run(bench):
    folders = [(bench.simulated(*kind),) for kind in KINDS]
    results = bench.in_parallel("homes", bench.scores, folders)
    rows, figures, furnished = [], {}, []
    for (size, furniture), scores in zip(KINDS, results):
        title = "%s, %s" % (size, furniture[2:])
        row, figures[title] = summary(title, scores)
        rows.append(row)
        if furniture == "--furnished":
            furnished += [(size, s) for s in scores]
    row, total = summary("all furnished", [s for _, s in furnished])
    figures["all furnished"] = total
    header = ["homes", "number", "V", "C", "H", "strict V", "F1", "rooms", "true"]
    text = [INTRODUCTION % bench.seed_range(), "\n", table(header, [row] + rows),
            "\nAim: V at least %s: %s; F1 at least %s: %s.\n"
            % (percent(TARGET_V, 1), verdict(total["v"] >= TARGET_V),
               percent(TARGET_F1, 1), verdict(total["room_f1"] >= TARGET_F1)),
            "\nThe worst of them:\n\n", worst_homes(furnished)]
    return "".join(text), figures
