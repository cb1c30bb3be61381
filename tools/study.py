#!/usr/bin/env python3
"""Repeats the study behind the default parameters and writes docs/study.md.

ROOMSEG is the roomseg command, DATASET a folder with maps and truth as `roomseg bench` takes it.
Needs nothing but Python 3.7 and about 300 MB of disk space for a while.
"""
import argparse
import json
import os
import sys
import tempfile

sys.dont_write_bytecode = True  # nothing is left in the source tree
from study_parts import ablation, homes, robustness, validation
from study_parts.bench import Bench, Failure, call

PARTS = {
    "ablation": ("What each rule is worth", ablation.run),
    "validation": ("Maps that nothing was picked on", validation.run),
    "robustness": ("Turned, resampled, noisy and cluttered maps", robustness.run),
    "homes": ("Simulated homes", homes.run),
}

HEAD = """\
# Study of the default parameters

Written by `tools/study.py ROOMSEG DATASET` with %s; not to be edited by hand.
The sets of DATASET with truth: %s.
V, completeness C, homogeneity H, recall, precision, IoU and ARI leave out cells without a label;
the strict V counts them. `tools/metrics.h` defines them all.
"""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0],
                                     epilog=" ".join(__doc__.splitlines()[2:]))
    parser.add_argument("roomseg", metavar="ROOMSEG")
    parser.add_argument("dataset", metavar="DATASET")
    parser.add_argument("--parts", default=",".join(PARTS), metavar="NAMES",
                        help="which, separated by commas; default %(default)s")
    parser.add_argument("--seeds", type=int, default=100, metavar="N",
                        help="simulated homes of each kind; default %(default)s")
    parser.add_argument("--jobs", type=int, default=2, metavar="N",
                        help="runs at a time; default %(default)s")
    parser.add_argument("-o", "--output", metavar="FILE", help="default docs/study.md")
    parser.add_argument("--json", metavar="FILE", help="writes all figures there as well")
    options = parser.parse_args()
    options.parts = options.parts.split(",")
    for part in options.parts:
        if part not in PARTS:
            parser.error("no part '%s'; there are %s" % (part, ", ".join(PARTS)))
    if options.seeds < 1 or options.jobs < 1:
        parser.error("--seeds and --jobs need at least 1")
    if options.output is None:
        top = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
        options.output = os.path.join(top, "docs", "study.md")
    options.roomseg = os.path.abspath(options.roomseg)
    return options


def write(path, text):
    """The whole file or none."""
    folder = os.path.dirname(os.path.abspath(path))
    os.makedirs(folder, exist_ok=True)
    unfinished = "%s.%d.tmp" % (path, os.getpid())
    try:
        with open(unfinished, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(unfinished, path)
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)


def study(options):
    with tempfile.TemporaryDirectory(prefix="roomseg-study-") as folder:
        bench = Bench(options.roomseg, options.dataset, folder, options.jobs, options.seeds)
        text = [HEAD % (call(options.roomseg, "--version").strip(), ", ".join(bench.sets))]
        figures = {"sets": bench.sets, "config": bench.config}
        for part in options.parts:
            title, run = PARTS[part]
            section, figures[part] = run(bench)
            text.append("\n## %s\n\n%s" % (title, section))
    write(options.output, "".join(text))
    if options.json is not None:
        write(options.json, json.dumps(figures, indent=1) + "\n")
    print("written: %s" % options.output)


def main():
    try:
        study(parse_arguments())
    except (Failure, OSError) as failure:
        print("study.py: %s" % failure, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
