#!/usr/bin/env python3
"""Instructions a cell by stage, counted by callgrind: the same on every run, whatever else the
machine does. Growth with the size of the map, and maps that are as bad as can be.

    tools/speed.py stages  ROOMSEG DATASET [--set NAME] [--before OLD_ROOMSEG]
    tools/speed.py growth  ROOMSEG [--map MAP]... [-o growth.svg]
    tools/speed.py regions ROOMSEG
    tools/speed.py worst   ROOMSEG

ROOMSEG is the command line's program; valgrind must be installed. MAP: a gray PNG of 8 bits. A
cell is a cell of the crop, the box around the free cells. Standard library only."""

import argparse
import json
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile
import zlib

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


def callgrind(command: list[str], folder: pathlib.Path) -> dict[str, int]:
    """Instructions of each function with all it calls, inside roomseg_run."""
    counts = folder / "callgrind.out"
    subprocess.run(
        ["valgrind", "--tool=callgrind", "--toggle-collect=roomseg_run",
         f"--callgrind-out-file={counts}", *command],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        env={"GLIBC_TUNABLES": TUNABLES, "PATH": "/usr/bin:/bin"})
    table = subprocess.run(
        ["callgrind_annotate", "--inclusive=yes", "--threshold=100", str(counts)],
        check=True, capture_output=True, text=True).stdout
    inclusive: dict[str, int] = {}
    for line in table.splitlines():
        found = re.match(r"\s*([\d,]+) \([ \d.]+%\)\s+\S*?:(\w+)", line)
        if found is not None:
            inclusive.setdefault(found[2], int(found[1].replace(",", "")))
    return inclusive


def by_stage(inclusive: dict[str, int]) -> dict[str, int]:
    """Instructions of each stage, and of all of roomseg_run."""
    parts = {stage: sum(inclusive.get(name, 0) for name in names) for stage, names in STAGES}
    parts["all"] = inclusive["roomseg_run"]
    return parts


def bench(roomseg: str, dataset: str, *options: str) -> list[dict]:
    """What the bench tells of each map."""
    answer = subprocess.run([roomseg, "bench", dataset, "--json", *options],
                            check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return [m for s in json.loads(answer.stdout)["sets"] for m in s["maps"]]


def stage_costs(roomseg: str, dataset: str, options: list[str], folder: pathlib.Path,
                cells: float) -> dict[str, float]:
    """Instructions a cell. The bench runs each map twice: once for its rooms, once timed."""
    inclusive = callgrind([roomseg, "bench", dataset, "--reps", "1", *options], folder)
    return {stage: count / (2.0 * cells) for stage, count in by_stage(inclusive).items()}


def print_stages(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    """Time and visits as `roomseg bench --stages` tells them, and the instructions."""
    sets = ["--set", arguments.set] if arguments.set else []
    maps = bench(arguments.roomseg, arguments.dataset, "--stages", "-j", "1", *sets)
    cells = sum(m["crop_cells"] for m in maps)
    now = stage_costs(arguments.roomseg, arguments.dataset, sets, folder, cells)
    old = (stage_costs(arguments.before, arguments.dataset, sets, folder, cells)
           if arguments.before else {})
    head = ["stage", "ms a map", "visits a cell", "instructions a cell", "share"]
    head += ["before", "now of before"] if old else []
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for stage, count in now.items():
        told = [m["stages"][stage] for m in maps if stage in m["stages"]]
        row = [stage, "", "", f"{count:.1f}", f"{100.0 * count / now['all']:.1f} %"]
        if told:  # the crop is a part of the threshold's
            row[1] = f"{sum(one['time_ms'] for one in told) / len(maps):.2f}"
            row[2] = f"{sum(one['visits'] for one in told) / cells:.1f}"
        elif stage == "all":
            row[1] = f"{sum(m['time_ms'] for m in maps) / len(maps):.2f}"
        if old:
            row += [f"{old[stage]:.1f}",
                    f"{100.0 * count / old[stage]:.0f} %" if old[stage] else ""]
        print("| " + " | ".join(row) + " |")


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


def unfilter(kind: int, line: bytearray, above: bytearray) -> None:
    """Undoes the filter of a PNG's row of bytes."""
    for x, value in enumerate(line):
        left = line[x - 1] if x else 0
        corner = above[x - 1] if x else 0
        near = left + above[x] - corner
        paeth = min((left, above[x], corner), key=lambda other: abs(near - other))
        line[x] = (value + (0, left, above[x], (left + above[x]) // 2, paeth)[kind]) & 255


def read_png(path: str) -> Grid:
    """The box around the free cells of a gray PNG of 8 bits, and one cell more on each side."""
    data = pathlib.Path(path).read_bytes()
    width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    if (depth, kind, interlaced) != (8, 0, 0):
        sys.exit(f"{path}: no gray PNG of 8 bits")
    at, packed = 8, b""
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if name == b"IDAT" else b""
        at += length + 12
    raw = zlib.decompress(packed)
    rows, above = [], bytearray(width)
    for y in range(height):
        line = bytearray(raw[y * (width + 1) + 1:(y + 1) * (width + 1)])
        if raw[y * (width + 1)] != 0:
            unfilter(raw[y * (width + 1)], line, above)
        rows.append(line)
        above = line
    free = [[x for x, value in enumerate(row) if value <= 51] for row in rows]
    tops = [y for y, found in enumerate(free) if found]
    left = min(found[0] for found in free if found)
    right = max(found[-1] for found in free if found) + 1
    grid = Grid(right - left + 2, tops[-1] - tops[0] + 3, WALL)
    for y in range(tops[0], tops[-1] + 1):
        grid.rows[y - tops[0] + 1][1:-1] = rows[y][left:right]
    return grid


def cluttered(grid: Grid, cells: int) -> Grid:
    """The same with an obstacle of 1 to 7 cells a side for every so many cells."""
    rng = random.Random(5)
    made = Grid(grid.width, grid.height, WALL)
    made.rows = [bytearray(row) for row in grid.rows]
    for _ in range(grid.width * grid.height // cells):
        made.fill(rng.randrange(1, grid.width - 8), rng.randrange(1, grid.height - 8),
                  rng.randrange(1, 8), rng.randrange(1, 8), WALL)
    return made


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


def closets(count: int) -> Grid:
    """A corridor with closets too small for a room on both sides, so many together."""
    pairs = count // 2
    grid = Grid(8 * pairs + 2, 28, WALL)
    grid.fill(1, 8, 8 * pairs, 12, FREE)
    for k in range(pairs):
        for y, door in ((1, 7), (21, 20)):
            grid.fill(2 + 8 * k, y, 6, 6, FREE)
            grid.fill(3 + 8 * k, door, 3, 1, FREE)
    return grid


def chambers(count: int) -> Grid:
    """Rooms of 30 x 30 cells in a square, each with a door to the right and one below."""
    side = round(count ** 0.5)
    grid = Grid(34 * side + 4, 34 * side + 4, WALL)
    for k in range(side * side):
        x, y = 4 + 34 * (k % side), 4 + 34 * (k // side)
        grid.fill(x, y, 30, 30, FREE)
        if k % side < side - 1:
            grid.fill(x + 30, y + 10, 4, 10, FREE)
        if k // side < side - 1:
            grid.fill(x + 10, y + 30, 10, 4, FREE)
    return grid


# With the largest capacities no run has to be repeated for want of them.
WIDE = ("--resolution", "0.05", "--config", "max_regions=65531", "--config", "max_rooms=16384")


def cost(roomseg: str, grid: Grid, folder: pathlib.Path) -> tuple[dict[str, float], int]:
    """Instructions a cell of the crop by stage; the number of rooms."""
    maps = folder / "maps"
    maps.mkdir(exist_ok=True)
    grid.write(maps / "grid.pgm")
    found = bench(roomseg, str(maps), "--reps", "1", *WIDE)[0]
    cells = max(found["crop_cells"], 1)
    return stage_costs(roomseg, str(maps), list(WIDE), folder, cells), found["rooms_found"]


def nanoseconds(roomseg: str, grid: Grid, folder: pathlib.Path) -> float:
    """Median CPU time a cell of the crop."""
    maps = folder / "maps"
    maps.mkdir(exist_ok=True)
    grid.write(maps / "grid.pgm")
    found = bench(roomseg, str(maps), "--reps", "5", *WIDE)[0]
    return 1e6 * found["time_ms"] / found["crop_cells"]


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
    print("| map of 600 x 600 cells | instructions a cell | of a home's | rooms |\n"
          "|---|---|---|---|")
    for name, grid in cases:
        costs, rooms = cost(arguments.roomseg, grid, folder)
        home = home or costs["all"]
        print(f"| {name} | {costs['all']:.0f} | {costs['all'] / home:.2f} | {rooms} |",
              flush=True)


def print_regions(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    print("| map | regions | graph, a cell | merge, a region | all, a cell |\n"
          "|---|---|---|---|---|")
    for name, make in (("rooms side by side", chambers), ("one corridor with closets", closets)):
        for count in (36, 400, 4096):
            grid = make(count)
            costs, _ = cost(arguments.roomseg, grid, folder)
            cells = (grid.width - 2) * (grid.height - 2)
            print(f"| {name} | {count} | {costs['graph']:.1f} | "
                  f"{costs['merge'] * cells / count:.0f} | {costs['all']:.1f} |", flush=True)


def svg(lines: dict[str, list[tuple[int, float]]]) -> str:
    """Curves over the side of the map, each step of the axis twice the last."""
    sides = sorted({side for points in lines.values() for side, _ in points})
    top = max(value for points in lines.values() for _, value in points) * 1.4  # room for the names
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
               'upright: nanoseconds a cell</text></svg>')
    return "\n".join(out) + "\n"


def print_growth(arguments: argparse.Namespace, folder: pathlib.Path) -> None:
    tiles = {"simple flat": flat(0), "the same with clutter": flat(150)}
    for path in arguments.map:
        tile = read_png(path)
        tiles[pathlib.Path(path).stem] = tile
        tiles[pathlib.Path(path).stem + " with clutter"] = cluttered(tile, 800)
    sides = [side for side in (100, 200, 400, 800, 1600, 3200, 6400, 8192)
             if side <= arguments.largest]
    lines: dict[str, list[tuple[int, float]]] = {name: [] for name in tiles}
    print("| cells | " + " | ".join(tiles) + " |\n|---|" + "---|" * len(tiles))
    for side in sides:
        row = []
        for name, tile in tiles.items():
            grid = tiled(tile, side)
            lines[name].append((side, nanoseconds(arguments.roomseg, grid, folder)))
            row.append(f"{lines[name][-1][1]:.1f} ns")
            if side <= arguments.counted:
                row[-1] += f", {cost(arguments.roomseg, grid, folder)[0]['all']:.0f}"
        print(f"| {side} x {side} | " + " | ".join(row) + " |", flush=True)
    if arguments.output:
        pathlib.Path(arguments.output).write_text(svg(lines), encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("stages", "growth", "regions", "worst"):
        commands.add_parser(name).add_argument("roomseg")
    stages = commands.choices["stages"]
    stages.add_argument("dataset")
    stages.add_argument("--set")
    stages.add_argument("--before")
    growth = commands.choices["growth"]
    growth.add_argument("--map", action="append", default=[])
    growth.add_argument("--largest", type=int, default=8192)
    growth.add_argument("--counted", type=int, default=800,
                        help="instructions are counted up to this size")
    growth.add_argument("-o", "--output")
    arguments = parser.parse_args()
    run = {"stages": print_stages, "growth": print_growth, "regions": print_regions,
           "worst": print_worst}
    with tempfile.TemporaryDirectory() as folder:
        run[arguments.command](arguments, pathlib.Path(folder))


if __name__ == "__main__":
    main()
