#!/usr/bin/env python3
"""Which lines and branches of src/ the tests reach.

    tests/coverage.py [--ctest ARGUMENTS]

Builds the library and the tests for gcov in build/coverage, runs the tests (by default those of
stages, interface and limits, not the ones on simulated and real maps) and prints a table of the
files of src/, then each line and each branch that was never taken. Exit code 1 when less than
100 % of the lines or 95 % of the branches were reached.
"""

import argparse
import collections
import json
import os
import pathlib
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "coverage"
LEAST_BRANCHES = 95.0
USUAL = "-L stage|api|limits"


def build() -> None:
    # Without optimisation, so that a line of the source is one of the program.
    subprocess.run(
        ["cmake", "-S", ROOT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Debug",
         "-DCMAKE_C_COMPILER=gcc", "-DCMAKE_C_FLAGS=--coverage -O0"],
        check=True, stdout=subprocess.DEVNULL)
    jobs = str(os.cpu_count() or 2)
    subprocess.run(["cmake", "--build", BUILD, "-j", jobs], check=True,
                   stdout=subprocess.DEVNULL)


def run_tests(arguments: list[str]) -> None:
    for old in BUILD.rglob("*.gcda"):
        old.unlink()
    subprocess.run(["ctest", "--test-dir", BUILD, "-j", str(os.cpu_count() or 2),
                    "--output-on-failure", "--progress", *arguments], check=True)


class Counts:
    """How often each line and each of its branches was taken, over all programs."""

    def __init__(self) -> None:
        self.lines: collections.Counter[int] = collections.Counter()
        self.branches: dict[int, list[int]] = {}

    def add(self, line: dict) -> None:
        number = line["line_number"]
        self.lines[number] += line["count"]
        counts = [branch["count"] for branch in line["branches"]]
        before = self.branches.get(number, [])
        if len(before) == len(counts):
            counts = [a + b for a, b in zip(before, counts)]
        self.branches[number] = counts


def read_counts() -> dict[str, Counts]:
    files: dict[str, Counts] = collections.defaultdict(Counts)
    # The library itself and its second build for tests/limits/test_cancel.c.
    data = sorted(path for path in BUILD.rglob("*.gcda") if path.parent.name == "src")
    for gcda in data:
        text = subprocess.run(["gcov", "--branch-probabilities", "--json-format", "--stdout", gcda],
                              check=True, capture_output=True, cwd=BUILD).stdout
        for record in json.loads(text)["files"]:
            path = pathlib.Path(record["file"])
            path = path if path.is_absolute() else ROOT / path
            if path.parent == ROOT / "src":
                for line in record["lines"]:
                    files[path.name].add(line)
    return files


def percent(reached: int, count: int) -> float:
    return 100.0 * reached / count if count else 100.0


def report(files: dict[str, Counts]) -> bool:
    total = [0, 0, 0, 0]
    print(f"{'file':24}{'lines':>14}{'branches':>16}")
    for name in sorted(files):
        counts = files[name]
        branches = [taken for line in counts.branches.values() for taken in line]
        row = [sum(c > 0 for c in counts.lines.values()), len(counts.lines),
               sum(c > 0 for c in branches), len(branches)]
        total = [a + b for a, b in zip(total, row)]
        print(f"{name:24}{row[0]:7}/{row[1]:<6}{row[2]:8}/{row[3]:<6}")
    lines, branches = percent(*total[:2]), percent(*total[2:])
    print(f"{'all':24}{lines:12.2f} %{branches:13.2f} %  "
          f"({total[0]}/{total[1]} lines, {total[2]}/{total[3]} branches)")
    return total[0] == total[1] and branches >= LEAST_BRANCHES


def report_missed(files: dict[str, Counts]) -> None:
    print("\nnever taken:")
    for name in sorted(files):
        source = (ROOT / "src" / name).read_text(encoding="utf-8").splitlines()
        counts = files[name]
        for number in sorted(counts.lines):
            if counts.lines[number] == 0:
                print(f"  {name}:{number}: line: {source[number - 1].strip()}")
            elif 0 in counts.branches.get(number, []):
                missed = [str(i) for i, c in enumerate(counts.branches[number]) if c == 0]
                print(f"  {name}:{number}: branch {','.join(missed)} of "
                      f"{len(counts.branches[number])}: {source[number - 1].strip()}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ctest", default=USUAL, help="which tests, in ctest's words")
    arguments = parser.parse_args()
    build()
    run_tests(shlex.split(arguments.ctest))
    files = read_counts()
    good = report(files)
    report_missed(files)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
