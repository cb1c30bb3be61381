/* Writes the maps of the embedded tests as a C file:
 *
 *     make_maps FILE.c [--home] [--golden] [--small] [--patterns] [IMAGE...]
 *
 * --home: a home of 20 m x 15 m that fills a grid of 400 x 300 cells. --golden: the golden maps,
 * as they are. --small: a map that a chip with 192 KB segments.
 * --patterns: drawn maps that are hard on single stages. IMAGE: a map file, cropped to the box
 * of its free cells and named after its folder and file. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "golden.h"
#include "map.h"
#include "patterns.h"
#include "simulate/simulate.h"
#include "simulate/turn.h"

#define MAX_MAPS 64
#define HOME_WIDTH 400u
#define HOME_HEIGHT 300u
#define MARGIN 2u /* cells around the free ones that are kept of an image */

typedef struct entry {
    char name[64];
    uint32_t width, height, resolution_mm, max_regions;
} entry;

static entry entries[MAX_MAPS];
static int entry_count;

/* Box of the cells that the default configuration takes for free; right and bottom outside. */
typedef struct free_area {
    uint32_t left, top, right, bottom;
} free_area;

static free_area find_free_area(const uint8_t *cells, uint32_t width, uint32_t height)
{
    const uint8_t free_max = roomseg_config_default().free_max;
    free_area b = {width, height, 0, 0};
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            if (cells[(size_t)y * width + x] <= free_max) {
                b.left = x < b.left ? x : b.left;
                b.right = x >= b.right ? x + 1 : b.right;
                b.top = y < b.top ? y : b.top;
                b.bottom = y + 1;
            }
        }
    }
    return b;
}

/* Writes the window x, y, width, height of the cells and notes the map. */
static int add_map(FILE *out, const char *name, const uint8_t *cells, uint32_t stride, uint32_t x,
                   uint32_t y, entry numbers)
{
    if (entry_count == MAX_MAPS) {
        fprintf(stderr, "make_maps: more than %d maps\n", MAX_MAPS);
        return -1;
    }
    entry *e = &entries[entry_count];
    *e = numbers;
    snprintf(e->name, sizeof e->name, "%s", name);
    /* As text, which compilers read many times faster than a list of numbers. */
    fprintf(out, "static const uint8_t cells_%d[] IN_MAPS =", entry_count);
    for (uint32_t row = 0; row < e->height; row++) {
        const uint8_t *from = cells + (size_t)(y + row) * stride + x;
        fputs("\n\"", out);
        for (uint32_t column = 0; column < e->width; column++) {
            fprintf(out, "\\%03o", from[column]);
        }
        fputc('"', out);
    }
    fputs(";\n", out);
    entry_count++;
    return 0;
}

static int add_simulated(FILE *out, const char *name, const sim_options *options,
                         uint32_t max_regions)
{
    sim_map flat;
    if (sim_run(options, &flat) != 0) {
        fprintf(stderr, "make_maps: %s: cannot simulate it\n", name);
        return -1;
    }
    entry numbers = {"", flat.width, flat.height, (uint32_t)flat.resolution_mm, max_regions};
    int rc = add_map(out, name, flat.cells, flat.width, 0, 0, numbers);
    sim_map_free(&flat);
    return rc;
}

static int add_golden(FILE *out)
{
    for (int i = 0; i < GOLDEN_DEFAULT_COUNT; i++) {
        golden_map golden = golden_map_at(i);
        if (add_simulated(out, golden.name, &golden.options, 0) != 0) {
            return -1;
        }
    }
    return 0;
}

static int add_small(FILE *out)
{
    sim_options options = sim_options_default();
    options.seed = 7;
    options.size = FLAT_SMALL;
    options.resolution_mm = 60;
    return add_simulated(out, "small", &options, 128);
}

/* The largest flat, turned so that it fills the grid; what is still outside is cut off. */
static int add_home(FILE *out)
{
    static uint8_t cells[HOME_WIDTH * HOME_HEIGHT];
    sim_options options = sim_options_default();
    sim_map flat;
    options.seed = 24;
    options.size = FLAT_LARGE;
    options.has_turn = 1;
    options.turn = TURN_FULL / 360 * 80;
    if (sim_run(&options, &flat) != 0) {
        fputs("make_maps: home: cannot simulate it\n", stderr);
        return -1;
    }
    free_area b = find_free_area(flat.cells, flat.width, flat.height);
    uint32_t left = (b.left + b.right) / 2, top = (b.top + b.bottom) / 2;
    for (uint32_t i = 0; i < HOME_WIDTH * HOME_HEIGHT; i++) {
        uint32_t x = left + i % HOME_WIDTH - HOME_WIDTH / 2; /* modulo 2^32 */
        uint32_t y = top + i / HOME_WIDTH - HOME_HEIGHT / 2;
        int inside = x < flat.width && y < flat.height;
        cells[i] = inside ? flat.cells[(size_t)y * flat.width + x] : MAP_UNKNOWN;
    }
    entry numbers = {"", HOME_WIDTH, HOME_HEIGHT, (uint32_t)flat.resolution_mm, 0};
    sim_map_free(&flat);
    return add_map(out, "home", cells, HOME_WIDTH, 0, 0, numbers);
}

static int add_patterns(FILE *out)
{
    static uint8_t cells[PATTERN_SIDE * PATTERN_SIDE];
    for (unsigned p = 0; p < pattern_count; p++) {
        for (uint32_t i = 0; i < PATTERN_SIDE * PATTERN_SIDE; i++) {
            uint32_t x = i % PATTERN_SIDE, y = i / PATTERN_SIDE;
            int wall = x == 0u || y == 0u || x == PATTERN_SIDE - 1u || y == PATTERN_SIDE - 1u;
            cells[i] = wall || !patterns[p].is_free(x, y) ? 255 : 0;
        }
        entry numbers = {"", PATTERN_SIDE, PATTERN_SIDE, PATTERN_RESOLUTION_MM,
                         patterns[p].max_regions};
        if (add_map(out, patterns[p].name, cells, PATTERN_SIDE, 0, 0, numbers) != 0) {
            return -1;
        }
    }
    return 0;
}

/* "FOLDER/NAME.png" -> "folder_name", letters, digits and '_' only. */
static void name_image(const char *path, char *name, size_t size)
{
    size_t end = strlen(path), start, n = 0;
    const char *dot = strrchr(path, '.');
    int slashes = 0;
    if (dot != NULL && strchr(dot, '/') == NULL) {
        end = (size_t)(dot - path);
    }
    for (start = end; start > 0; start--) {
        slashes += path[start - 1] == '/';
        if (slashes == 2) {
            break;
        }
    }
    for (; start < end && n + 1 < size; start++) {
        char c = path[start];
        name[n++] = (char)(isalnum((unsigned char)c) ? tolower((unsigned char)c) : '_');
    }
    name[n] = '\0';
}

static int add_image(FILE *out, const char *path)
{
    map m;
    tool_error error = {""};
    const map_options options = {0, 0};
    char name[64];
    if (map_load(path, &options, &m, &error) != 0) {
        tool_error_print(&error);
        return -1;
    }
    free_area b = find_free_area(m.cells, m.width, m.height);
    b.left -= b.left < MARGIN ? b.left : MARGIN;
    b.top -= b.top < MARGIN ? b.top : MARGIN;
    b.right = b.right + MARGIN < m.width ? b.right + MARGIN : m.width;
    b.bottom = b.bottom + MARGIN < m.height ? b.bottom + MARGIN : m.height;
    name_image(path, name, sizeof name);
    entry numbers = {"", b.right - b.left, b.bottom - b.top,
                     (uint32_t)(m.resolution_m * 1000.0 + 0.5), 0};
    int rc = b.right > b.left ? add_map(out, name, m.cells, m.width, b.left, b.top, numbers) : 0;
    map_free(&m);
    return rc;
}

static int add(FILE *out, const char *what)
{
    if (strcmp(what, "--home") == 0) {
        return add_home(out);
    }
    if (strcmp(what, "--golden") == 0) {
        return add_golden(out);
    }
    if (strcmp(what, "--small") == 0) {
        return add_small(out);
    }
    return strcmp(what, "--patterns") == 0 ? add_patterns(out) : add_image(out, what);
}

static void write_table(FILE *out)
{
    fputs("const test_map test_maps[] = {\n", out);
    for (int i = 0; i < entry_count; i++) {
        const entry *e = &entries[i];
        fprintf(out, "    {\"%s\", cells_%d, %u, %u, %u, %u},\n", e->name, i, (unsigned)e->width,
                (unsigned)e->height, (unsigned)e->resolution_mm, (unsigned)e->max_regions);
    }
    fprintf(out, "};\nconst unsigned test_map_count = %d;\n", entry_count);
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        fputs("usage: make_maps FILE.c [--home] [--golden] [--small] [--patterns] [IMAGE...]\n",
              stderr);
        return 2;
    }
    FILE *out = fopen(argv[1], "w");
    if (out == NULL) {
        fprintf(stderr, "make_maps: %s: cannot be written\n", argv[1]);
        return 1;
    }
    fputs("/* Made by make_maps. */\n#include \"maps.h\"\n\n"
          "#define IN_MAPS __attribute__((section(\".maps\")))\n", out);
    int rc = 0;
    for (int i = 2; i < argc && rc == 0; i++) {
        rc = add(out, argv[i]);
    }
    write_table(out);
    if (ferror(out) != 0) {
        fprintf(stderr, "make_maps: %s: cannot be written\n", argv[1]);
        rc = -1;
    }
    if (fclose(out) != 0 || rc != 0) {
        remove(argv[1]);
        return 1;
    }
    return 0;
}
