#!/usr/bin/env python3
"""Prints what roomseg costs a chip - code, stack, memory, instructions - and holds it against
tests/embedded/limits.txt. What exceeds a limit by more than 2 percent fails.

    tools/budget.py             measures and compares
    tools/budget.py --update    writes what was measured as the new limits, and into the tables
                                of docs/embedded.md and README.md

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

DOCS = (ROOT / "docs" / "embedded.md", ROOT / "README.md")
LIMITS = ROOT / "tests" / "embedded" / "limits.txt"
REAL_MAP_TABLES = ("arena", "instructions", "stages")  # have rows of the data set's maps
TOLERANCE = 1.02

SIZE_BUILDS = (("m0plus", "-Os"), ("m4", "-Os"), ("m4", "-O2"), ("m4-soft", "-Os"),
               ("m7", "-O2"), ("rv32", "-Os"))
PATTERNS = ("open", "comb", "cells", "noise", "checker")
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
PROMISE_ARENA = {"default": 4.0, "usual": 2.5}  # bytes a cell of homes: default, usual capacities
PROMISE_DATA = 0  # bytes of .data and .bss, everywhere
PROMISE_PAPER = 12288  # code bytes of the paper profile beside the default one
PROMISE_M7 = {"neato": 500, "worst": 1500}  # executed instructions a cell


class Budget:
    """Measurements by name, in the order in which they were made."""

    def __init__(self):
        self.measured = {}
        self.broken = []
        self.tables = {}

    def note(self, key, value):
        self.measured[key] = value
        promised = STACK_BYTES if PROMISE_STACK.match(key) else PROMISES.get(key, value)
        if value > promised:
            self.broken.append(f"{key}: {value}, promised {promised}")

    def promise(self, holds, text):
        if not holds:
            self.broken.append(text)

    def table(self, key, title, head, rows):
        """Prints a table, and keeps it under the name that it has in the documentation."""
        lines = [head, ["---"] * len(head), *rows]
        text = "\n".join(f"| {' | '.join(map(written, line))} |" for line in lines)
        self.tables[key] = text
        print(f"\n{title}\n\n{text}", flush=True)


def written(cell):
    return f"{cell:,}" if isinstance(cell, int) else str(cell)


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
    rows, short = [], []
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
            rows.append((f"`{name}`", level, kind, size["text"], size["rodata"], code,
                         size["data"], size["bss"], stack))
            if (name, level) == ("m4", "-Os"):
                print(f"deepest on {name} {level} {kind}: {' > '.join(path)}")
                short.append((kind, code, stack))
    budget.table("code", "Code and stack of a program that calls roomseg_run once, in bytes; "
                 "stack by call graph, without the progress hook",
                 ("Target", "", "", ".text", ".rodata", "both", ".data", ".bss", "stack"), rows)
    budget.table("short", "The same of the Cortex-M4 at -Os, short",
                 ("Cortex-M4, gcc -Os", *(kind for kind, _, _ in short)),
                 (("Code and constants [bytes]", *(code for _, code, _ in short)),
                  ("Stack, by call graph [bytes]", *(stack for _, _, stack in short))))


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
    for name in dict.fromkeys(name for name, _ in runs):
        if name not in ("home", "large_furnished") and \
                not name.startswith(("neato", "furnished_")):
            continue
        cells = number_of(runs[(name, "default")][0], "cells")
        arenas = {kind: number_of(runs[(name, kind)][0], "arena") for kind in kinds()}
        for kind, arena in arenas.items():
            budget.note(f"arena {name} {kind}", arena)
        arenas["usual"] = int(runs[(name, "default")][1]["usual"])
        if name == "home" or name.startswith("neato"):
            for kind, most in PROMISE_ARENA.items():
                budget.promise(arenas[kind] <= most * cells,
                               f"arena {kind} {name}: {arenas[kind] / cells:.2f} bytes a cell, "
                               f"promised {most}")
        rows.append((name, cells, *(f"{arenas[kind]:,} ({arenas[kind] / cells:.2f})"
                                    for kind in ("default", "usual", "aligned", "paper"))))
    budget.table("arena", "Arena in bytes, and bytes a cell of the crop",
                 ("Map", "cells of the crop", "default", "usual capacities", "aligned", "paper"),
                 rows)
    numbers = emulate.split_runs(Build(host, HOME_TARGET).run("home"))[("home", "default")][1]
    parts = [int(numbers[part]) for part in ("map", "labels", "arena", "stack")]
    budget.note("home in bytes", sum(parts))
    budget.table("home", "The home of 400 x 300 cells in a Cortex-M4 with 512 KB, in bytes",
                 ("map, 1 byte a cell", "labels, 2 bytes a cell", "arena, 256 regions, 48 rooms",
                  "stack", "together"), [(*parts, f"{sum(parts):,} of {512 * 1024:,}")])


def shown_maps(runs):
    """Maps for the tables, and those whose stages are shown: a home, the furnished set's map of
    median size, the map with the most regions."""
    real = sorted({name for name, _ in runs if name.startswith(("neato", "furnished_"))})
    staged = [name for name in ("neato_10", "furnished_13_office_b") if name in real] or ["home"]
    return ["home", *PATTERNS, *real], [*staged, "checker"]


def measure_target(name, level, counts, runs, budget):
    """{map: (all, {stage: count})} of the default profile, {kind: all} of the home; a cell."""
    per_map, per_kind = {}, {}
    for m in shown_maps(runs)[0]:
        cells = number_of(runs[(m, "default")][0], "cells")
        stages = counts[(m, "default")]
        total = round(sum(stages.values()) / cells)
        budget.note(f"instructions {name} {level} {m} default", total)
        per_map[m] = (total, {stage: round(count / cells) for stage, count in stages.items()})
    for kind in kinds():
        cells = number_of(runs[("home", kind)][0], "cells")
        per_kind[kind] = round(sum(counts[("home", kind)].values()) / cells)
        budget.note(f"instructions {name} {level} home {kind}", per_kind[kind])
    if name == "m7":
        for m, (total, _) in per_map.items():
            promised = PROMISE_M7["neato" if m.startswith("neato") else "worst"]
            budget.promise(total <= promised, f"{m} on {name}: {total} instructions a cell, "
                           f"promised {promised}")
    return per_map, per_kind


def measure_speed(host, budget):
    plugin = build_plugin()
    by_map, by_kind = {}, {}
    for name, level in SPEED_BUILDS:
        counts, runs = count_instructions(Build(host, TARGETS[name], level), plugin)
        note_stack(name, level, runs, budget)
        if any(text != host.runs[key][0] for key, (text, _) in runs.items()):
            raise Failure(f"{name} {level}: other labels or rooms than here")
        by_map[name], by_kind[name] = measure_target(name, level, counts, runs, budget)
    maps, staged = shown_maps(host.runs)
    names = [f"`{name}`" for name in by_map]
    budget.table("instructions", "Executed instructions a cell of the crop at -O2, default profile",
                 ("Map", *names), [(m, *(by_map[name][m][0] for name in by_map)) for m in maps])
    stages = list(by_map["m7"]["home"][1])
    budget.table("stages", "The same by stage", ("Map", "", "all", *stages),
                 [(m, f"`{name}`", by_map[name][m][0], *(by_map[name][m][1][s] for s in stages))
                  for m in staged for name in by_map])
    budget.table("kinds", "The home in each way", ("", *kinds()),
                 [(f"`{name}`", *by_kind[name].values()) for name in by_kind])


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


def write_tables(budget, dataset):
    """Puts the tables where the documentation has them, between two comments."""
    tables = dict(budget.tables)
    if not dataset:
        for key in REAL_MAP_TABLES:
            tables.pop(key, None)
        print(f"not written, for want of the data set (--dataset): {', '.join(REAL_MAP_TABLES)}")
    for file in DOCS:
        text = file.read_text(encoding="utf-8")
        for key, table in tables.items():
            block = rf"(<!-- {key}: tools/budget\.py --update -->\n).*?(<!-- end of {key} -->)"
            text = re.sub(block, lambda found, table=table: f"{found[1]}{table}\n{found[2]}", text,
                          flags=re.S)
        file.write_text(text, encoding="utf-8")


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
        write_tables(budget, options.dataset)
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
