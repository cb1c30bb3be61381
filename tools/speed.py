#!/usr/bin/env python3
"""Instructions a cell by stage, counted by callgrind: the same on every run, whatever else the
machine does. Growth with the size of the map, and maps that are as bad as can be.

    tools/speed.py stages ROOMSEG DATASET [--set NAME]
    tools/speed.py stages ROOMSEG DATASET --before OLD_ROOMSEG
    tools/speed.py growth ROOMSEG [--map MAP]... [-o growth.svg]
    tools/speed.py worst  ROOMSEG

ROOMSEG is the command line's program; valgrind must be installed. MAP: a binary PGM. A cell is a
cell of the crop, the box around the free cells. Standard library only."""

import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

# Functions of the library in the order in which a run of the default profile calls them.
STAGES = (
    ("crop", ("rs_threshold_crop",)),
    ("threshold", ("rs_threshold_run",)),
    ("components", ("rs_components_clear_small", "rs_components_drop_islands")),
    ("surface", ("rs_distance_run",)),
    ("watershed", ("rs_watershed_run",)),
    ("graph", ("rs_graph_build",)),
    ("merge", ("rs_merge_run", "rs_drop_run")),
    ("rooms", ("rs_rooms_number", "rs_rooms_label", "rs_rooms_connect")),
)
# callgrind counts every turn of `rep stos` as an instruction; without it memset is a loop.
TUNABLES = ("glibc.cpu.x86_rep_stosb_threshold=1000000000:"
            "glibc.cpu.x86_rep_movsb_threshold=1000000000")
FREE, WALL = 0, 255


def callgrind(command: list[str], folder: pathlib.Path) -> tuple[dict[str, int], int]:
    """Instructions of each function with all it calls, inside roomseg_run, and the number of
    runs."""
    counts = folder / "callgrind.out"
    subprocess.run(
        ["valgrind", "--tool=callgrind", "--toggle-collect=roomseg_run",
         f"--callgrind-out-file={counts}", *command],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        env={"GLIBC_TUNABLES": TUNABLES, "PATH": "/usr/bin:/bin"})
    table = subprocess.run(
        ["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--tree=caller",
         str(counts)],
        check=True, capture_output=True, text=True).stdout
    inclusive: dict[str, int] = {}
    runs = 0
    for line in table.splitlines():
        found = re.match(r"\s*([\d,]+) \([ \d.]+%\)\s+(\*|<) +\S*?:(\w+)(?: \((\d+)x\))?", line)
        if found is None:
            continue
        if found[2] == "*":
            inclusive[found[3]] = int(found[1].replace(",", ""))
        elif found[3] in ("segment_again", "main"):
            runs += int(found[4] or 0)
    return inclusive, runs


def by_stage(inclusive: dict[str, int]) -> dict[str, int]:
    """Instructions of each stage, and of all of roomseg_run."""
    parts = {stage: sum(inclusive.get(name, 0) for name in names) for stage, names in STAGES}
    parts["all"] = inclusive["roomseg_run"]
    return parts


def bench_cells(roomseg: str, dataset: str, sets: list[str]) -> float:
    """Crop cells of a data set."""
    answer = subprocess.run([roomseg, "bench", dataset, "--reps", "1", "--json", *sets],
                            check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return sum(m["crop_cells"] for s in json.loads(answer.stdout)["sets"] for m in s["maps"])


def stage_costs(roomseg: str, dataset: str, sets: list[str], folder: pathlib.Path,
                cells: float) -> dict[str, float]:
    """Instructions a cell. The bench runs each map twice: once for its rooms, once timed."""
    inclusive, _ = callgrind([roomseg, "bench", dataset, "--reps", "1", *sets], folder)
    return {stage: count / (2.0 * cells) for stage, count in by_stage(inclusive).items()}


def print_stages(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    sets = ["--set", arguments.set] if arguments.set else []
    cells = bench_cells(arguments.roomseg, arguments.dataset, sets)
    now = stage_costs(arguments.roomseg, arguments.dataset, sets, folder, cells)
    if arguments.before is None:
        print("| stage | instructions a cell |\n|---|---|")
        for stage, count in now.items():
            print(f"| {stage} | {count:.1f} |")
        return
    old = stage_costs(arguments.before, arguments.dataset, sets, folder, cells)
    print("| stage | before | now | |\n|---|---|---|---|")
    for stage, count in now.items():
        share = f"{100.0 * count / old[stage]:.0f} %" if old[stage] else ""
        print(f"| {stage} | {old[stage]:.1f} | {count:.1f} | {share} |")


class Grid:
    """An occupancy grid."""

    def __init__(self, width: int, height: int, value: int) -> None:
        self.width, self.height = width, height
        self.rows = [bytearray([value]) * width for _ in range(height)]

    def fill(self, x: int, y: int, width: int, height: int, value: int) -> None:
        for row in self.rows[max(y, 0):y + height]:
            row[x:x + width] = bytes([value]) * len(row[x:x + width])

    def write(self, path: pathlib.Path) -> None:
        head = f"P5\n{self.width} {self.height}\n255\n".encode()
        path.write_bytes(head + b"".join(bytes(row) for row in self.rows))


def read_pgm(path: str) -> Grid:
    """A binary PGM whose header is without comments."""
    data = pathlib.Path(path).read_bytes()
    head = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
    if head is None:
        sys.exit(f"{path}: no binary PGM of 8 bits without comments")
    grid = Grid(int(head[1]), int(head[2]), 0)
    body = data[head.end():]
    grid.rows = [bytearray(body[y * grid.width:(y + 1) * grid.width])
                 for y in range(grid.height)]
    return grid


def tiled(tile: Grid, side: int) -> Grid:
    """The tile again and again; a wall runs around each."""
    grid = Grid(side, side, WALL)
    for y in range(side):
        row = tile.rows[y % tile.height]
        grid.rows[y][:] = (row * (side // tile.width + 1))[:side]
    return grid


def flat(clutter: int, seed: int = 1) -> Grid:
    """A flat of 260 x 200 cells: ten rooms, doors, and `clutter` chair legs and the like."""
    grid = Grid(260, 200, WALL)
    rng = random.Random(seed)
    for k in range(5):
        for y, height in ((4, 84), (112, 84)):
            grid.fill(4 + 51 * k, y, 47, height, FREE)
            grid.fill(22 + 51 * k, 88 if y == 4 else 108, 16, 4, FREE)
    grid.fill(4, 92, 251, 16, FREE)
    for _ in range(clutter):
        grid.fill(rng.randrange(4, 250), rng.randrange(4, 190), rng.randrange(1, 8),
                  rng.randrange(1, 8), WALL)
    return grid


def comb(side: int, width: int) -> Grid:
    """Corridors side by side, `width` cells wide, open to one at their end."""
    grid = Grid(side, side, WALL)
    for x in range(1, side - width, width + 1):
        grid.fill(x, 1, width, side - 2, FREE)
    grid.fill(1, 1, side - 2, width, FREE)
    return grid


def spiral(side: int, width: int) -> Grid:
    """One corridor from the outside to the middle."""
    grid = Grid(side, side, WALL)
    inset, step = 1, width + 1
    while inset + 2 * step < side - inset:
        length = side - 2 * inset
        grid.fill(inset, inset, length, width, FREE)
        grid.fill(side - inset - width, inset, width, length, FREE)
        grid.fill(inset, side - inset - width, length, width, FREE)
        grid.fill(inset, inset + step, width, length - step, FREE)
        grid.fill(inset, inset + step, step + width, width, FREE)
        grid.fill(inset, inset + width, width, 1, WALL)
        inset += step
    return grid


def noise(side: int, percent: int) -> Grid:
    rng = random.Random(3)
    grid = Grid(side, side, FREE)
    for row in grid.rows:
        row[:] = bytes(WALL if rng.random() * 100.0 < percent else FREE for _ in row)
    return grid


def checkerboard(side: int) -> Grid:
    grid = Grid(side, side, WALL)
    for y, row in enumerate(grid.rows):
        row[y % 2::2] = bytes(len(row[y % 2::2]))
    return grid


def cost(roomseg: str, grid: Grid, folder: pathlib.Path) -> tuple[dict[str, float], str]:
    """Instructions a cell of the crop by stage; what the run found, or why it failed."""
    path = folder / "grid.pgm"
    grid.write(path)
    command = [roomseg, "segment", str(path), "--resolution", "0.05", "-o", str(folder / "out")]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        return {}, answer.stderr.strip().replace(str(path), "map")
    crop = re.search(r"crop of (\d+) x (\d+)", answer.stdout)
    rooms = re.search(r"^(\d+ rooms?|no rooms?)", answer.stdout, re.M)
    cells = int(crop[1]) * int(crop[2]) if crop else 1
    inclusive, runs = callgrind(command, folder)
    costs = {stage: count / cells for stage, count in by_stage(inclusive).items()}
    found = rooms[1] if rooms else "no room"
    return costs, found if runs <= 1 else f"{found}, {runs} runs"


def print_worst(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    side = 600
    cases = (
        ("a home", tiled(flat(60), side)),
        ("all free", Grid(side, side, FREE)),
        ("checkerboard", checkerboard(side)),
        ("noise, 50 %", noise(side, 50)),
        ("noise, 20 %", noise(side, 20)),
        ("noise, 2 %", noise(side, 2)),
        ("comb of corridors 1 cell wide", comb(side, 1)),
        ("comb of corridors 6 cells wide", comb(side, 6)),
        ("spiral 1 cell wide", spiral(side, 1)),
        ("spiral 6 cells wide", spiral(side, 6)),
    )
    home = 0.0
    print("| map of 600 x 600 cells | instructions a cell | of a home's | |\n|---|---|---|---|")
    for name, grid in cases:
        costs, found = cost(arguments.roomseg, grid, folder)
        home = home or costs["all"]
        if costs:
            print(f"| {name} | {costs['all']:.0f} | {costs['all'] / home:.2f} | {found} |")
        else:
            print(f"| {name} | | | {found} |")


def svg(lines: dict[str, list[tuple[int, float]]]) -> str:
    """Curves over the side of the map, each step of the axis twice the last."""
    sides = sorted({side for points in lines.values() for side, _ in points})
    top = max(value for points in lines.values() for _, value in points) * 1.1
    colors = ("#1b6ca8", "#c8553d", "#3d8361", "#7d5ba6")
    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="720" height="360" '
           'font-family="sans-serif" font-size="13">',
           '<rect width="720" height="360" fill="white"/>']

    def place(side: int, value: float) -> tuple[float, float]:
        step = 560.0 / max(len(sides) - 1, 1)
        return 70.0 + step * sides.index(side), 300.0 - 260.0 * value / top

    for tick in range(0, 5):
        value = top * tick / 4.0
        y = 300.0 - 65.0 * tick
        out.append(f'<line x1="70" x2="640" y1="{y:.0f}" y2="{y:.0f}" stroke="#dddddd"/>'
                   f'<text x="62" y="{y + 4:.0f}" text-anchor="end">{value:.0f}</text>')
    for side in sides:
        out.append(f'<text x="{place(side, 0.0)[0]:.0f}" y="320" '
                   f'text-anchor="middle">{side}</text>')
    for i, (name, points) in enumerate(lines.items()):
        path = " ".join(f"{place(*point)[0]:.1f},{place(*point)[1]:.1f}" for point in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colors[i % 4]}" '
                   f'stroke-width="2"/><text x="80" y="{24 + 16 * i}" '
                   f'fill="{colors[i % 4]}">{name}</text>')
    out.append('<text x="355" y="345" text-anchor="middle">cells of a side; '
               'upright: instructions a cell</text></svg>')
    return "\n".join(out) + "\n"


def print_growth(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    tiles = {"simple flat": flat(0), "the same with clutter": flat(150)}
    for path in arguments.map:
        tiles[pathlib.Path(path).stem] = read_pgm(path)
    sides = [side for side in (100, 200, 400, 800, 1600, 3200, 6400, 8192)
             if side <= arguments.largest]
    lines: dict[str, list[tuple[int, float]]] = {name: [] for name in tiles}
    print("| cells | " + " | ".join(tiles) + " |\n|---|" + "---|" * len(tiles))
    for side in sides:
        row = []
        for name, tile in tiles.items():
            costs, found = cost(arguments.roomseg, tiled(tile, side), folder)
            row.append(f"{costs['all']:.1f}" if costs else found)
            if costs:
                lines[name].append((side, costs["all"]))
        print(f"| {side} x {side} | " + " | ".join(row) + " |", flush=True)
    if arguments.output:
        pathlib.Path(arguments.output).write_text(svg(lines), encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("stages", "growth", "worst"):
        commands.add_parser(name).add_argument("roomseg")
    stages = commands.choices["stages"]
    stages.add_argument("dataset")
    stages.add_argument("--set")
    stages.add_argument("--before")
    growth = commands.choices["growth"]
    growth.add_argument("--map", action="append", default=[])
    growth.add_argument("--largest", type=int, default=8192)
    growth.add_argument("-o", "--output")
    arguments = parser.parse_args()
    run = {"stages": print_stages, "growth": print_growth, "worst": print_worst}
    with tempfile.TemporaryDirectory() as folder:
        run[arguments.command](arguments, pathlib.Path(folder))


if __name__ == "__main__":
    main()
