#!/usr/bin/env python3
"""Prints what roomseg costs a chip - code, stack, memory, instructions - and holds it against
tests/embedded/limits.txt. What exceeds a limit by more than 2 percent fails.

    tools/budget.py             measures and compares
    tools/budget.py --update    writes what was measured as the new limits

tools/setup.sh embedded installs what it needs. Exit: 0 within the limits, 1 not."""

import argparse
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "embedded"))

import emulate  # noqa: E402
from callgraph import CallGraph, GraphError  # noqa: E402
from emulate import Build, Failure, Host, command  # noqa: E402
from targets import HOME_TARGET, TARGETS  # noqa: E402

LIMITS = ROOT / "tests" / "embedded" / "limits.txt"
TOLERANCE = 1.02

SIZE_BUILDS = (("m0plus", "-Os"), ("m4", "-Os"), ("m4", "-O2"), ("m4-soft", "-Os"),
               ("m7", "-O2"), ("rv32", "-Os"))
SPEED_BUILDS = (("m7", "-O2"), ("m4", "-O2"), ("m0plus", "-O2"), ("rv32", "-O2"))
ARCHIVES = ("m4-soft", "m0plus", "rv32")
# Helpers for what the library must not do: floating point, 64-bit division, the heap, streams.
FORBIDDEN = re.compile(
    r"__aeabi_([fd](?!iv0)|i2[fd]|ui2[fd]|l2[fd]|ul2[fd]|u?ldivmod)|__(add|sub|mul|div)[sd]f3"
    r"|__float|__fix|__u?(div|mod)di[34]|__udivmoddi4"
    r"|^(malloc|calloc|realloc|free|printf|fprintf|sprintf|snprintf|puts|fputs|abort|exit)$")

# What the project promises, whatever the limits say: key -> greatest value.
PROMISES = {"code m4 -Os default": 16384, "home in bytes": 512 * 1024}
PROMISE_STACK = re.compile(r"stack \w+ \S+ \S+ default$")  # on every target
STACK_BYTES = 1024
PROMISE_ARENA = {"arena": 4.0, "usual": 2.5}  # bytes a cell of homes: default, usual capacities
PROMISE_DATA = 0  # bytes of .data and .bss, everywhere
PROMISE_PAPER = 12288  # code bytes of the paper profile beside the default one
PROMISE_M7 = {"neato": 500, "worst": 1500}  # executed instructions a cell


class Budget:
    """Measurements by name, in the order in which they were made."""

    def __init__(self):
        self.measured = {}
        self.broken = []

    def note(self, key, value):
        self.measured[key] = value
        promised = STACK_BYTES if PROMISE_STACK.match(key) else PROMISES.get(key, value)
        if value > promised:
            self.broken.append(f"{key}: {value}, promised {promised}")

    def promise(self, holds, text):
        if not holds:
            self.broken.append(text)


def table(title, head, rows):
    print(f"\n{title}\n\n| {' | '.join(head)} |\n|{'---|' * len(head)}")
    for row in rows:
        print(f"| {' | '.join(str(cell) for cell in row)} |", flush=True)


def kinds():
    """What a firmware may link: {name: (profile, aligner)}."""
    found = {"default": ("roomseg_profile_default", None),
             "aligned": ("roomseg_profile_default", "roomseg_aligner_on")}
    if "ROOMSEG_PROFILE_PAPER" in (ROOT / "include" / "roomseg" / "roomseg.h").read_text():
        found["paper"] = ("roomseg_profile_paper", None)
    return found


def section_sizes(target, program):
    sizes = {}
    for line in command([target.prefix + "size", "-A", program]).splitlines():
        words = line.split()
        if len(words) == 3 and words[1].isdigit():
            sizes[words[0]] = int(words[1])
    total = {name: sum(size for section, size in sizes.items()
                       if re.match(rf"\.s?{name}(\.|$)", section))
             for name in ("text", "rodata", "data", "bss")}
    total["rodata"] += sizes.get(".ARM.exidx", 0)
    return total


def measure_sizes(host, budget):
    rows = []
    for name, level in SIZE_BUILDS:
        target = TARGETS[name]
        build = Build(host, target, level, flags="-fcallgraph-info=su")
        default_code = None
        for kind, (profile, aligner) in kinds().items():
            size = section_sizes(target, build.make(f"size_{kind}"))
            code = size["text"] + size["rodata"]
            default_code = code if kind == "default" else default_code
            files = list(build.folder.glob(f"**/{'size_' + kind}.dir/**/*.ci"))
            files += build.folder.glob("roomseg/**/*.ci")
            stack, path = CallGraph(files, ROOT / "src", profile, aligner).bound("roomseg_run")
            budget.note(f"code {name} {level} {kind}", code)
            budget.note(f"stack bound {name} {level} {kind}", stack)
            budget.promise(size["data"] + size["bss"] == PROMISE_DATA,
                           f"{name} {level} {kind}: .data and .bss are not empty")
            if kind == "paper":
                budget.promise(name != "m4" or level != "-Os" or
                               code - default_code <= PROMISE_PAPER,
                               f"paper profile: {code - default_code} bytes more code")
            rows.append((name, level, kind, size["text"], size["rodata"], code, size["data"],
                         size["bss"], stack))
            if (name, level) == ("m4", "-Os"):
                print(f"deepest on {name} {level} {kind}: {' > '.join(path)}")
    table("Code and stack of a program that calls roomseg_run once, in bytes; stack by call "
          "graph, without the progress hook",
          ("Target", "", "", ".text", ".rodata", "code", ".data", ".bss", "stack"), rows)


def check_archives(host, budget):
    for name in ARCHIVES:
        target = TARGETS[name]
        build = Build(host, target, "-Os", flags="-fcallgraph-info=su")
        archive = build.make("roomseg").parent / "roomseg" / "libroomseg.a"
        wanted = {line.split()[-1] for line in
                  command([target.prefix + "nm", "-u", archive]).splitlines() if " U " in line}
        bad = sorted(symbol for symbol in wanted if FORBIDDEN.search(symbol))
        outside = sorted(symbol for symbol in wanted if not re.match(r"(rs|roomseg)_", symbol))
        budget.promise(not bad, f"{name}: the library calls {', '.join(bad)}")
        print(f"calls from the whole library on {name}: {', '.join(outside)}", flush=True)


def build_plugin():
    source = ROOT / "tests" / "embedded" / "plugin" / "stage_count.c"
    plugin = emulate.WORK / "libstage_count.so"
    command(["cc", "-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-Wall",
             "-Wextra", source, "-o", plugin])
    return plugin


def count_instructions(build, plugin):
    """{run: {stage: instructions}} and what the program wrote."""
    program, out = build.make("program"), build.folder / "marks.txt"
    symbols = command([build.target.prefix + "nm", program])
    mark = re.search(r"^([0-9a-f]+) \w stages_mark$", symbols, re.M)[1]
    text = build.run(more=("-plugin", f"{plugin},mark=0x{mark},out={out}"), timeout=1800)
    counts = [int(line) for line in out.read_text().split()]
    runs, position, key = {}, 0, None
    for line in text.splitlines():
        if line.startswith("run "):
            key = tuple(line.split()[1:3])
        elif " marks: " in line:
            names = line.split(" marks: ")[1].split(",")
            here = counts[position:position + len(names) + 1]
            position += len(names) + 1
            stages = {}
            for i, name in enumerate(names):
                name = "threshold" if name == "begin" else name
                stages[name] = stages.get(name, 0) + here[i + 1] - here[i]
            runs[key] = stages
    if position != len(counts):
        raise Failure(f"{build.title}: {len(counts)} marks, {position} expected")
    return runs, emulate.split_runs(text)


def number_of(text, name):
    words = text.split("\n")[0].split()[3:]
    return int(words[words.index(name) + 1])


def measure_speed(host, budget):
    plugin = build_plugin()
    patterns = ("open", "comb", "cells", "noise", "checker")
    rows, totals = [], []
    for name, level in SPEED_BUILDS:
        counts, runs = count_instructions(Build(host, TARGETS[name], level), plugin)
        note_stack(name, level, runs, budget)
        if any(text != host.runs[key][0] for key, (text, _) in runs.items()):
            raise Failure(f"{name} {level}: other labels or rooms than here")
        shown = [m for m, kind in counts if kind == "default" and
                 (m == "home" or m in patterns or m.startswith(("neato", "furnished_")))]
        worst = 0
        for m in shown:
            cells = number_of(runs[(m, "default")][0], "cells")
            stages = counts[(m, "default")]
            total = round(sum(stages.values()) / cells)
            budget.note(f"instructions {name} {level} {m} default", total)
            rows.append((name, m, total, *(round(count / cells) for count in stages.values())))
            worst = max(worst, total)
            if name == "m7" and m.startswith("neato"):
                budget.promise(total <= PROMISE_M7["neato"],
                               f"{m} on {name}: {total} instructions a cell, promised "
                               f"{PROMISE_M7['neato']}")
        budget.promise(name != "m7" or worst <= PROMISE_M7["worst"],
                       f"worst on {name}: {worst} instructions a cell, promised "
                       f"{PROMISE_M7['worst']}")
        for kind in kinds():
            cells = number_of(runs[("home", kind)][0], "cells")
            total = round(sum(counts[("home", kind)].values()) / cells)
            budget.note(f"instructions {name} {level} home {kind}", total)
            totals.append((name, kind, total))
    table("Executed instructions a cell of the crop at -O2, default profile",
          ("Target", "Map", "all", *stages), rows)
    table("The home, all kinds", ("Target", "", "instructions a cell"), totals)


def note_stack(name, level, runs, budget):
    """The stack that was written, against the bound if there is one of this build."""
    for kind in kinds():
        painted = max(int(values["stack"]) for (_, k), (_, values) in runs.items() if k == kind)
        budget.note(f"stack painted {name} {level} {kind}", painted)
        bound = budget.measured.get(f"stack bound {name} {level} {kind}", painted)
        # The program's own hook lies on top of the library's frames.
        budget.promise(painted <= bound + 32,
                       f"{name} {level} {kind}: stack painted {painted}, bound {bound}")


def measure_memory(host, budget):
    runs = emulate.split_runs(Build(host, TARGETS["m4"], "-Os").run())
    note_stack("m4", "-Os", runs, budget)
    rows = []
    for (name, kind), (text, values) in runs.items():
        cells, arena = number_of(text, "cells"), number_of(text, "arena")
        if name in ("home", "large_furnished") or name.startswith(("neato", "furnished_")):
            usual = int(values["usual"])
            rows.append((name, kind, cells, arena, f"{arena / cells:.2f}",
                         f"{usual / cells:.2f}" if kind == "default" else "", values["stack"]))
            budget.note(f"arena {name} {kind}", arena)
            if kind == "default" and (name == "home" or name.startswith("neato")):
                for what, number in (("arena", arena), ("usual", usual)):
                    budget.promise(number <= PROMISE_ARENA[what] * cells,
                                   f"{what} {name}: {number / cells:.2f} bytes a cell, "
                                   f"promised {PROMISE_ARENA[what]}")
    table("Arena, and the stack that was written on m4 -Os, in bytes",
          ("Map", "", "cells of the crop", "arena", "a cell", "a cell, usual capacities",
           "stack painted"), rows)
    numbers = emulate.split_runs(Build(host, HOME_TARGET).run("home"))[("home", "default")][1]
    parts = ("map", "labels", "arena", "stack")
    total = sum(int(numbers[part]) for part in parts)
    budget.note("home in bytes", total)
    table("The home of 400 x 300 cells in a Cortex-M4 with 512 KB, at most 256 regions, in bytes",
          (*parts, "all"), [[*(numbers[part] for part in parts), total]])


def read_limits():
    if not LIMITS.is_file():
        return {}
    lines = [line.rsplit(" ", 1) for line in LIMITS.read_text().splitlines()
             if line and not line.startswith("#")]
    return {key: int(value) for key, value in lines}


def write_limits(budget):
    limits = read_limits() | budget.measured
    lines = [f"{key} {value}" for key, value in sorted(limits.items())]
    LIMITS.write_text("# Written by tools/budget.py --update: bytes; instructions a cell.\n" +
                      "\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true", help="write the limits anew")
    parser.add_argument("--dataset", type=pathlib.Path, default=emulate.default_dataset(),
                        help="folder with the optional real maps")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    budget = Budget()
    try:
        host = Host(options.dataset, options.jobs)
        measure_sizes(host, budget)
        check_archives(host, budget)
        measure_memory(host, budget)
        measure_speed(host, budget)
    except (Failure, GraphError, subprocess.SubprocessError) as failure:
        print(f"budget.py: {failure}", file=sys.stderr)
        return 1
    limits = read_limits()
    over = [f"{key}: {value}, limit {limits[key]}" for key, value in budget.measured.items()
            if key in limits and value > limits[key] * TOLERANCE]
    over += [f"{key}: no limit is stored" for key in budget.measured if key not in limits]
    print()
    if options.update:
        write_limits(budget)
        over = []
    for line in budget.broken:
        print(f"PROMISE BROKEN  {line}")
    for line in over:
        print(f"OVER THE LIMIT  {line}")
    print(f"{len(budget.measured)} figures, {len(budget.broken)} promises broken, "
          f"{len(over)} over their limits")
    return 1 if budget.broken or over else 0


if __name__ == "__main__":
    sys.exit(main())
