#!/usr/bin/env python3
"""Draws docs/parameters/*.png: what each parameter does to the rooms of a simulated home.

    tools/parameter_pictures.py ROOMSEG [FOLDER]

ROOMSEG is the roomseg command; FOLDER is docs/parameters when it is not given. A picture shows the
same home once for each value of a parameter, in the order of PICTURES. Rooms keep their colour as
far as they stay the same. Python's standard library alone.
"""
import os
import struct
import subprocess
import sys
import tempfile
import zlib

# Field, its values from left to right, the home: size and seed of `roomseg simulate`.
PICTURES = (
    ("speck_mm2", (0, 96000), "medium", 7),
    ("clutter_mm", (0, 1500), "medium", 24),
    ("smallest_room_mm2", (0, 1000000, 4000000), "small", 13),
    ("niche_mm2", (0, 3000000), "small", 19),
    ("room_opening_percent", (60, 83), "medium", 20),
    ("passage_opening_percent", (100, 41), "medium", 24),
    ("shared_wall_mm", (200, 1000), "small", 4),
    ("lived_in_permille", (1000, 3), "medium", 20),
    ("open_plan_percent", (100, 50), "small", 11),
    ("door_mm", (10000, 950, 400), "small", 19),
    ("hall_mm", (0, 1600), "small", 18),
    ("unwalled_percent", (0, 50), "medium", 12),
)

SCALE = 2  # pixels a cell
GAP = 8    # pixels between panels
UNKNOWN, WALL, FLOOR = 0, 1, 2  # places in the palette; rooms come behind
PALETTE = ((224, 224, 224), (40, 40, 40), (255, 255, 255),
           (141, 186, 227), (246, 190, 120), (160, 209, 140), (233, 150, 150),
           (196, 170, 220), (240, 225, 120), (140, 210, 205), (214, 178, 140),
           (235, 170, 210), (178, 190, 130), (120, 150, 200), (205, 205, 245),
           (200, 120, 90), (110, 170, 120), (170, 110, 160))
FIRST_COLOR = 3
COLORS = len(PALETTE) - FIRST_COLOR


def call(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def read_pgm(path):
    """Width, height and the cells of a binary PGM with one byte a cell."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"P5":
            raise ValueError("%s: not a binary PGM" % path)
        words = []
        while len(words) < 3:
            words += file.readline().split(b"#")[0].split()
        width, height, maxval = map(int, words)
        cells = file.read()
    if maxval > 255 or len(cells) != width * height:
        raise ValueError("%s: not a PGM of one byte a cell" % path)
    return width, height, cells


def neighbours(labels, width):
    """Pairs of labels that touch, both ways round."""
    pairs = set(zip(labels, labels[1:])) | set(zip(labels, labels[width:]))
    pairs = {(a, b) for a, b in pairs if a and b and a != b}
    return pairs | {(b, a) for a, b in pairs}


def overlaps(labels, reference):
    """(cells, label, reference label) of all pairs that share cells, largest first."""
    counts = {}
    for pair in zip(labels, reference):
        counts[pair] = counts.get(pair, 0) + 1
    return sorted(((n, a, b) for (a, b), n in counts.items() if a and b), reverse=True)


def color_rooms(labels, width, reference, reference_colors):
    """A colour for each label: that of the reference room which it covers most, if no other
    room covers more of it, else one that no neighbour has."""
    colors = {}
    taken = set()
    for _, label, other in overlaps(labels, reference):
        if label not in colors and other not in taken:
            colors[label] = reference_colors[other]
            taken.add(other)
    touching = neighbours(labels, width)
    for label in sorted(set(labels) - {0} - set(colors)):
        used = set(colors.values())
        near = {colors[b] for a, b in touching if a == label and b in colors}
        free = [c for c in range(COLORS) if c not in used] or \
               [c for c in range(COLORS) if c not in near] or [0]
        colors[label] = free[0]
    return colors


def panel(cells, labels, colors, width, box):
    """Rows of palette indices, a byte a pixel."""
    left, top, right, bottom = box
    rows = []
    for y in range(top, bottom + 1):
        row = bytearray()
        for x in range(left, right + 1):
            i = y * width + x
            if labels[i]:
                index = FIRST_COLOR + colors[labels[i]]
            elif cells[i] <= 51:
                index = FLOOR
            else:
                index = UNKNOWN if cells[i] < 204 else WALL
            row += bytes((index,)) * SCALE
        rows += [bytes(row)] * SCALE
    return rows


def home_box(cells, width, height):
    """Left, top, right, bottom of the free cells, with a little around them. Rows and columns
    with a few free cells are rays that left the home."""
    least = 12
    columns = [x for x in range(width) if sum(c <= 51 for c in cells[x::width]) >= least]
    rows = [y for y in range(height)
            if sum(c <= 51 for c in cells[y * width:(y + 1) * width]) >= least]
    return (max(columns[0] - 6, 0), max(rows[0] - 6, 0),
            min(columns[-1] + 6, width - 1), min(rows[-1] + 6, height - 1))


def write_png(path, rows):
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 3, 0, 0, 0)
    palette = b"".join(bytes(color) for color in PALETTE)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    unfinished = path + ".tmp"
    with open(unfinished, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", palette) +
                   chunk(b"IDAT", pixels) + chunk(b"IEND", b""))
    os.replace(unfinished, path)


def draw(roomseg, field, values, size, seed, folder, work):
    home = os.path.join(work, "home")
    call(roomseg, "simulate", "--seed", str(seed), "--size", size, "--rotate", "0", "-o",
         os.path.join(home, "flat"))
    width, height, cells = read_pgm(os.path.join(home, "flat", "map.pgm"))
    box = home_box(cells, width, height)
    picture = None
    reference, reference_colors = b"", {}
    for value in values:
        call(roomseg, "bench", home, "--reps", "1", "--labels", work, "--config",
             "%s=%d" % (field, value))
        labels = read_pgm(os.path.join(work, "home", "flat.pgm"))[2]
        colors = color_rooms(labels, width, reference, reference_colors)
        rows = panel(cells, labels, colors, width, box)
        between = bytes((FLOOR,)) * GAP
        picture = rows if picture is None else [a + between + b for a, b in zip(picture, rows)]
        reference, reference_colors = labels, colors
    path = os.path.join(folder, field + ".png")
    write_png(path, picture)
    print("%s: %s %s, seed %d" % (path, size, "/".join(map(str, values)), seed))


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        print("usage: parameter_pictures.py ROOMSEG [FOLDER]", file=sys.stderr)
        return 2
    top = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    folder = arguments[1] if len(arguments) == 2 else os.path.join(top, "docs", "parameters")
    try:
        os.makedirs(folder, exist_ok=True)
        for picture in PICTURES:
            with tempfile.TemporaryDirectory(prefix="roomseg-pictures-") as work:
                draw(os.path.abspath(arguments[0]), *picture, folder, work)
    except (OSError, ValueError, subprocess.CalledProcessError) as failure:
        print("parameter_pictures.py: %s" % failure, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
