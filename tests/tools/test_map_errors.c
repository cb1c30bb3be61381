/* Maps that must be refused, with one line that names the file and the cause. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "map.h"
#include "scratch.h"
#include "tiny_png.h"
#include "unity.h"

void setUp(void) {
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

static void expect_refusal(const char *path, const char *named, const char *cause) {
    const map_options options = {0, 0};
    map m;
    tool_error error = {""};
    memset(&m, 0xA5, sizeof m);
    TEST_ASSERT_EQUAL_INT_MESSAGE(-1, map_load(path, &options, &m, &error), cause);
    TEST_ASSERT_NULL(m.cells);
    TEST_ASSERT_EQUAL_UINT32(0, m.width);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error.text, cause), error.text);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error.text, named), error.text);
    TEST_ASSERT_NULL_MESSAGE(strchr(error.text, '\n'), error.text);
}

typedef struct bad_file {
    const char *bytes;
    size_t size;
    const char *cause; /* must be in the message */
} bad_file;

#define BAD(bytes, cause) {bytes, sizeof(bytes) - 1, cause}

static const bad_file bad_images[] = {
    /* Nothing at all. */
    BAD("", "empty"),
    /* No format of ours: the beginnings of a JPEG and of a GIF, zeros. */
    BAD("\xff\xd8\xff\xe0\x00\x10JFIF", "neither a PNG or PGM"),
    BAD("GIF89a\x01\x00\x01\x00", "neither a PNG or PGM"),
    BAD("\x00\x00\x00\x00", "neither a PNG or PGM"),
    /* Other netpbm files. */
    BAD("P6 1 1 255 abc", "colour PPM"),
    BAD("P3 1 1 255 1 2 3", "colour PPM"),
    BAD("P4 8 1 \xff", "this kind of netpbm"),
    BAD("P7\nWIDTH 1\n", "this kind of netpbm"),
    /* Headers that end too early, at each place. */
    BAD("P5\n", "no width"),
    BAD("P5 # 1 1 255 a", "no width"),
    BAD("P5 3", "no height"),
    BAD("P5 3 2\n", "no largest value"),
    BAD("P5 3 2 255", "truncated behind its header"),
    BAD("P2 3 2 255", "truncated"),
    /* Header numbers that are none, are too long for 32 bits or are out of range. */
    BAD("P5 x 2 255\nabcdef", "no width"),
    BAD("P5 -3 2 255\nabcdef", "no width"),
    BAD("P5 3 2.0 255\nabcdef", "no height"),
    BAD("P5 3 2 0xff\nabcdef", "no largest value"),
    BAD("P5 4294967297 1 255\na", "no width"),
    BAD("P5 3 2 0\nabcdef", "not within 1..65535"),
    BAD("P5 3 2 65536\nabcdef", "not within 1..65535"),
    BAD("P5 0 2 255\n", "empty"),
    BAD("P5 2 0 255\n", "empty"),
    BAD("P5 65536 1 255\n", "too many"),
    BAD("P5 1 65536 255\n", "too many"),
    BAD("P5 16385 16385 255\n", "too many"),
    /* A huge image in a small file must not be allocated. */
    BAD("P5 16384 16384 255\nabc", "do not fit"),
    BAD("P2 16384 16384 255\n1 2 3", "do not fit"),
    /* Cells missing: one byte of eight bits, one of sixteen. */
    BAD("P5 3 2 255\nabcde", "truncated"),
    BAD("P5 3 1 256\n\x00\x01\x00\x02\x00", "1 bytes of 6 are missing"),
    BAD("P2 3 2 255\n10 20 30 40 50 #60\n", "cell (2, 1): missing"),
    /* Cells left over: a comment behind the header, a second image. */
    BAD("P5 3 1 255\nabcX", "1 bytes too many"),
    BAD("P5 3 1 255\n# made by hand\nabc", "bytes too many"),
    BAD("P2 3 1 255\n1 2 3 4", "behind the PGM's last cell"),
    /* Cells above the maximum, or no numbers. */
    BAD("P5 3 1 100\n\x64\x65\x00", "cell (1, 0): above"),
    BAD("P5 1 1 999\n\x03\xe8", "cell (0, 0): above"),
    BAD("P2 2 2 100\n1 2 3 101", "cell (1, 1): above"),
    BAD("P2 2 2 255\n1 2 three 4", "cell (0, 1): not a number"),
    BAD("P2 2 2 255\n1 -2 3 4", "cell (1, 0): not a number"),
    BAD("P2 2 2 255\n1 2 3 0000000004", "cell (1, 1): not a number"),
    /* Neato comments. */
    BAD("P5\n# Neato metadata: resolution=4O\n1 1 255\nA", "resolution is not a number"),
    BAD("P5\n# Neato metadata: resolution=\n1 1 255\nA", "resolution is not a number"),
    BAD("P5\n# Neato metadata: resolution=nan\n1 1 255\nA", "resolution is not a number"),
    BAD("P5\n# Neato metadata: origin_x=-1e999 resolution=40\n1 1 255\nA", "origin_x is not"),
    BAD("P5\n# Neato metadata: origin_x=0 origin_y=0\n1 1 255\nA", "no resolution above 0"),
    BAD("P5\n# Neato metadata: resolution=-40\n1 1 255\nA", "no resolution above 0"),
    BAD("P5\n# Neato metadata: resolution=400\n1 1 255\nA", "0.4 m a cell is not within"),
    BAD("P5\n# Neato metadata: resolution=5\n1 1 255\nA", "0.005 m a cell is not within"),
    /* PNG: the signature alone; a first chunk cut off; one that is longer than the file. */
    BAD("\x89PNG\r\n\x1a\n", "truncated"),
    BAD("\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHD", "truncated"),
    BAD("\x89PNG\r\n\x1a\n\xff\xff\xff\xffIHDR\x00\x00\x00\x01\x00\x00\x00\x01", "truncated"),
};

static void test_bad_images(void) {
    for (size_t i = 0; i < sizeof bad_images / sizeof bad_images[0]; i++) {
        scratch_close();
        scratch_open();
        const char *path = scratch_write("bad.img", bad_images[i].bytes, bad_images[i].size);
        expect_refusal(path, path, bad_images[i].cause);
    }
}

static const uint8_t row[] = {0, 127, 255};

static void expect_bad_png(const tiny_png *png, size_t size, const char *cause) {
    const char *path = scratch_write("bad.png", png->bytes, size);
    expect_refusal(path, path, cause);
}

static void test_a_png_cut_off_anywhere(void) {
    tiny_png png = tiny_png_make(3, 1, 8, PNG_GRAY, row, 3, 1, NULL, 0);
    for (size_t size = 8; size < png.size; size++) {
        scratch_close();
        scratch_open();
        expect_bad_png(&png, size, "truncated");
    }
}

static void test_a_png_with_any_byte_changed(void) {
    for (size_t i = 8; i < 80; i++) {
        tiny_png png = tiny_png_make(3, 1, 8, PNG_GRAY, row, 3, 1, NULL, 0);
        if (i < png.size) {
            scratch_close();
            scratch_open();
            png.bytes[i] ^= 0x10;
            expect_bad_png(&png, png.size, "the PNG is ");
        }
    }
}

/* All checksums right, the contents wrong. */
static void test_pngs_that_do_not_hold_what_they_say(void) {
    tiny_png png = tiny_png_make(3, 4, 8, PNG_GRAY, row, 3, 1, NULL, 0); /* 3 rows missing */
    expect_bad_png(&png, png.size, "damaged (not enough pixels)");
    png = tiny_png_make(0, 1, 8, PNG_GRAY, row, 3, 1, NULL, 0);
    expect_bad_png(&png, png.size, "empty");
    png = tiny_png_make(1, 65536, 8, PNG_GRAY, row, 3, 1, NULL, 0);
    expect_bad_png(&png, png.size, "too many");
    png = tiny_png_make(0x80000000u, 1, 8, PNG_GRAY, row, 3, 1, NULL, 0);
    expect_bad_png(&png, png.size, "too many");
    png = tiny_png_make(3, 1, 7, PNG_GRAY, row, 3, 1, NULL, 0); /* no such depth */
    expect_bad_png(&png, png.size, "damaged");
    png = tiny_png_make(3, 1, 8, 5, row, 3, 1, NULL, 0); /* no such colour type */
    expect_bad_png(&png, png.size, "damaged");
    png = tiny_png_make(3, 1, 8, PNG_PALETTE, row, 3, 1, NULL, 0); /* palette missing */
    expect_bad_png(&png, png.size, "damaged");
}

/* A deflate stream of zeros, 258 of them for 13 bits: one literal, then copies of the byte
 * before. Returns its size, the checksum behind it included. */
static size_t deflate_zeros(uint8_t *out, size_t copies) {
    size_t bits = 0;
    memset(out, 0, 16 + copies * 2);
    out[0] = 0x78;
    out[1] = 0x01;
    uint8_t *at = out + 2;
    /* Last block, fixed codes; literal 0 is 00110000, length 258 is 11000101, distance 1 is
     * 00000; codes begin with their highest bit. */
    const char *head = "11000110000";
    for (; *head != '\0'; head++, bits++) {
        at[bits / 8] |= (uint8_t)((*head - '0') << bits % 8);
    }
    for (size_t i = 0; i < copies; i++) {
        for (const char *code = "1100010100000"; *code != '\0'; code++, bits++) {
            at[bits / 8] |= (uint8_t)((*code - '0') << bits % 8);
        }
    }
    return 2 + (bits + 7 + 7) / 8 + 4; /* the end code is seven zeros */
}

/* Small files that would fill the memory: many bytes for few cells, many cells of few bytes. */
static void test_pngs_that_swell(void) {
    enum { COPIES = 40000 }; /* 10 MB in 65 kB */
    size_t room = 100 + 16 + 2 * COPIES;
    uint8_t *bytes = malloc(room);
    uint8_t *stream = malloc(16 + 2 * COPIES);
    TEST_ASSERT_TRUE(bytes != NULL && stream != NULL);
    size_t size = deflate_zeros(stream, COPIES);
    size = tiny_png_wrap(1, 1, 8, PNG_GRAY, stream, size, bytes);
    const char *path = scratch_write("swells.png", bytes, size);
    expect_refusal(path, path, "damaged (more bytes than its size needs)");
    size = deflate_zeros(stream, 40);
    size = tiny_png_wrap(16384, 16384, 8, PNG_GRAY, stream, size, bytes);
    path = scratch_write("hollow.png", bytes, size);
    expect_refusal(path, path, "damaged (too short for its size)");
    size = deflate_zeros(stream, 40);
    size = tiny_png_wrap(100, 100, 8, PNG_GRAY, stream, size, bytes);
    path = scratch_write("good.png", bytes, size);
    const map_options options = {0, 0};
    map m;
    TEST_ASSERT_EQUAL_INT(0, map_load(path, &options, &m, NULL));
    map_free(&m);
    free(stream);
    free(bytes);
}

static void test_colour_pngs(void) {
    const uint8_t rgb[] = {10, 10, 10, 10, 11, 10};
    tiny_png png = tiny_png_make(2, 1, 8, PNG_RGB, rgb, 6, 1, NULL, 0);
    expect_bad_png(&png, png.size, "colours");
    const uint8_t palette[] = {0, 0, 0, 255, 0, 0};
    const uint8_t indices[] = {0, 1};
    png = tiny_png_make(2, 1, 8, PNG_PALETTE, indices, 2, 1, palette, 2);
    expect_bad_png(&png, png.size, "colours");
    const uint8_t beyond[] = {0, 200}; /* an entry that the palette does not have */
    png = tiny_png_make(2, 1, 8, PNG_PALETTE, beyond, 2, 1, palette, 1);
    expect_bad_png(&png, png.size, "colours");
}

/* The standard allows chunks of image data without a byte, even as the first. */
static void test_a_png_with_empty_data(void) {
    static const uint8_t empty[12] = {0, 0, 0, 0, 'I', 'D', 'A', 'T', 0x35, 0xAF, 0x06, 0x1E};
    const uint8_t gray[] = {0, 254};
    tiny_png png = tiny_png_make(2, 1, 8, PNG_GRAY, gray, 2, 1, NULL, 0);
    memmove(png.bytes + png.idat + sizeof empty, png.bytes + png.idat, png.size - png.idat);
    memcpy(png.bytes + png.idat, empty, sizeof empty);
    png.size += sizeof empty;
    const char *path = scratch_write("empty_data.png", png.bytes, png.size);
    const map_options options = {0, 0};
    map m;
    TEST_ASSERT_EQUAL_INT(0, map_load(path, &options, &m, NULL));
    TEST_ASSERT_EQUAL_UINT32(2, m.width);
    TEST_ASSERT_NOT_EQUAL_UINT8(m.cells[0], m.cells[1]);
    map_free(&m);
}

#define IMAGE "image: m.pgm\n"
#define RESOLUTION "resolution: 0.05\n"
#define ORIGIN "origin: [0, 0, 0]\n"
#define NEGATE "negate: 0\n"
#define THRESHOLDS "occupied_thresh: 0.65\nfree_thresh: 0.2\n"
#define GOOD IMAGE RESOLUTION ORIGIN NEGATE THRESHOLDS

static const bad_file bad_yamls[] = {
    /* Each key missing; a file that is no YAML of maps. */
    BAD(RESOLUTION ORIGIN NEGATE THRESHOLDS, "key 'image' is missing"),
    BAD(IMAGE ORIGIN NEGATE THRESHOLDS, "key 'resolution' is missing"),
    BAD(IMAGE RESOLUTION NEGATE THRESHOLDS, "key 'origin' is missing"),
    BAD(IMAGE RESOLUTION ORIGIN THRESHOLDS, "key 'negate' is missing"),
    BAD(IMAGE RESOLUTION ORIGIN NEGATE "free_thresh: 0.2\n", "key 'occupied_thresh' is missing"),
    BAD(IMAGE RESOLUTION ORIGIN NEGATE "occupied_thresh: 1\n", "key 'free_thresh' is missing"),
    BAD("# nothing\n", "key 'image' is missing"),
    BAD("Dear robot,\nplease clean.\n", ":1: neither 'key: value'"),
    /* Values of the wrong kind. */
    BAD("image:\n" RESOLUTION ORIGIN NEGATE THRESHOLDS, ":1: image is not a single value"),
    BAD("image: ''\n" RESOLUTION ORIGIN NEGATE THRESHOLDS, ":1: image is not a single value"),
    BAD("image: [m.pgm]\n" RESOLUTION ORIGIN NEGATE THRESHOLDS, "image is not a single"),
    BAD("image:\n  file: m.pgm\n" RESOLUTION ORIGIN NEGATE THRESHOLDS, "not a single value"),
    BAD(IMAGE RESOLUTION "origin: 0\n" NEGATE THRESHOLDS, ":3: origin is not a list"),
    /* Resolutions: not a number, not finite, text behind it, hexadecimal, sign, range. */
    BAD(IMAGE "resolution: fine\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: nan\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: .inf\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: 1e999\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: 0.05 m\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: 0,05\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: 0x1p-4\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not a finite"),
    BAD(IMAGE "resolution: -0.05\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not above 0"),
    BAD(IMAGE "resolution: 0\n" ORIGIN NEGATE THRESHOLDS, ":2: resolution is not above 0"),
    BAD(IMAGE "resolution: 0.5\n" ORIGIN NEGATE THRESHOLDS, "0.5 m a cell is not within"),
    BAD(IMAGE "resolution: 1e300\n" ORIGIN NEGATE THRESHOLDS, "is not within"),
    /* Origins. */
    BAD(IMAGE RESOLUTION "origin: [0, 0]\n" NEGATE THRESHOLDS, ":3: origin does not have"),
    BAD(IMAGE RESOLUTION "origin: [0, 0, 0, 0]\n" NEGATE THRESHOLDS, "origin does not have"),
    BAD(IMAGE RESOLUTION "origin: [0,1,2,3,4,5,6,7,8,9]\n" NEGATE THRESHOLDS, "does not have"),
    BAD(IMAGE RESOLUTION "origin: [0, x, 0]\n" NEGATE THRESHOLDS, "origin holds something"),
    BAD(IMAGE RESOLUTION "origin: [0, , 0]\n" NEGATE THRESHOLDS, ":3: a list item is missing"),
    BAD(IMAGE RESOLUTION "origin: [0, 0, 0\n" NEGATE THRESHOLDS, ":3: a list stays open"),
    BAD(IMAGE RESOLUTION NEGATE THRESHOLDS "origin: [0, 0, 0\n", ":6: a list stays open"),
    BAD(IMAGE RESOLUTION "origin: [0, 0, 0] 1\n" NEGATE THRESHOLDS, "text behind a list"),
    /* Switches and thresholds. */
    BAD(IMAGE RESOLUTION ORIGIN "negate: 2\n" THRESHOLDS, ":4: negate is neither"),
    BAD(IMAGE RESOLUTION ORIGIN "negate: 01\n" THRESHOLDS, ":4: negate is neither"),
    BAD(IMAGE RESOLUTION ORIGIN NEGATE "occupied_thresh: 1.1\nfree_thresh: 0\n",
        ":5: occupied_thresh is not within"),
    BAD(IMAGE RESOLUTION ORIGIN NEGATE "occupied_thresh: 1\nfree_thresh: -0.1\n",
        ":6: free_thresh is not within"),
    BAD(IMAGE RESOLUTION ORIGIN NEGATE "occupied_thresh: 0.2\nfree_thresh: 0.2\n",
        ":6: free_thresh is not below"),
    BAD(GOOD "mode: binary\n", ":7: mode is none of"),
    BAD(GOOD "mode:\n", ":7: mode is not a single value"),
    /* Syntax. */
    BAD(GOOD IMAGE, ":7: key 'image' comes twice"),
    BAD(GOOD "image m.pgm\n", ":7: neither"),
    BAD(GOOD "image:m.pgm\n", ":7: neither"),
    BAD(GOOD ": x\n", ":7: neither"),
    BAD(GOOD ":x: 1:\n:x\n", ":8: neither"),
    BAD(GOOD "note: 'open\n", ":7: a quote stays open"),
    BAD(GOOD "note: \"open\\\"\n", ":7: a quote stays open"),
    BAD(GOOD "note: 'a' b\n", ":7: there is text behind"),
    BAD(GOOD "note: \"a\\x41\"\n", ":7: this escape"),
    BAD(GOOD "note: ['a, b]\n", ":7: a quote stays open"),
    BAD(GOOD "- 1\n", ":7: a list item without a list"),
    BAD("- 1\n" GOOD, ":1: a list item without a list"),
    BAD(" image: m.pgm\n", ":1: unexpected indentation"),
    BAD(GOOD "  more: 1\n", ":7: unexpected indentation"),
};

static void test_bad_yamls(void) {
    for (size_t i = 0; i < sizeof bad_yamls / sizeof bad_yamls[0]; i++) {
        scratch_close();
        scratch_open();
        scratch_write_text("m.pgm", "P2 1 1 255 0");
        const char *path = scratch_write("m.yaml", bad_yamls[i].bytes, bad_yamls[i].size);
        expect_refusal(path, path, bad_yamls[i].cause);
    }
}

static void test_yamls_that_are_too_large(void) {
    static char text[70000];
    memset(text, '#', sizeof text - 1);
    const char *path = scratch_write_text("long.yaml", text);
    expect_refusal(path, path, "neither a PNG or PGM");
    size_t size = 0;
    for (int i = 0; i < 65; i++) {
        text[size++] = (char)(';' + i);
        memcpy(text + size, "x: 1\n", 5);
        size += 5;
    }
    path = scratch_write("wide.yaml", text, size);
    expect_refusal(path, path, "too many keys");
}

static void test_the_image_of_a_yaml_is_named(void) {
    const char *yaml = scratch_write_text("m.yaml", GOOD);
    expect_refusal(yaml, "/m.pgm", "No such file");
    scratch_write_text("m.pgm", GOOD); /* a YAML names a YAML */
    expect_refusal(yaml, "/m.pgm", "neither a PNG nor a PGM");
    scratch_write_text("m.pgm", "P5 2 2 255\nabc");
    expect_refusal(yaml, "/m.pgm", "truncated");
    yaml = scratch_write_text("n.yaml", "image: /\n" RESOLUTION ORIGIN NEGATE THRESHOLDS);
    expect_refusal(yaml, "/", "directory");
}

static void test_files_that_cannot_be_read(void) {
    expect_refusal("no/such/map.png", "no/such/map.png", "No such file");
    expect_refusal(".", ".", "directory");
    expect_refusal("", "", "No such file");
    expect_refusal("line\nbreak.png", "line?break.png", "No such file");
}

static void test_a_long_name_leaves_the_cause(void) {
    char name[1001];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    for (size_t i = 100; i < sizeof name - 1; i += 100) {
        name[i] = '/';
    }
    expect_refusal(name, "nnn/nnn", "nnn: No such file");

    char yaml[1200];
    snprintf(yaml, sizeof yaml, "image: %s\n" RESOLUTION ORIGIN NEGATE THRESHOLDS, name);
    expect_refusal(scratch_write_text("long.yaml", yaml), "nnn/nnn", "nnn: No such file");
}

static void test_a_yaml_cannot_be_inverted(void) {
    const map_options options = {0, 1};
    map m;
    tool_error error;
    scratch_write_text("m.pgm", "P2 1 1 255 0");
    TEST_ASSERT_EQUAL_INT(-1, map_load(scratch_write_text("m.yaml", GOOD), &options, &m, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "negate"));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_bad_images);
    RUN_TEST(test_a_png_cut_off_anywhere);
    RUN_TEST(test_a_png_with_any_byte_changed);
    RUN_TEST(test_pngs_that_do_not_hold_what_they_say);
    RUN_TEST(test_pngs_that_swell);
    RUN_TEST(test_colour_pngs);
    RUN_TEST(test_a_png_with_empty_data);
    RUN_TEST(test_bad_yamls);
    RUN_TEST(test_yamls_that_are_too_large);
    RUN_TEST(test_the_image_of_a_yaml_is_named);
    RUN_TEST(test_files_that_cannot_be_read);
    RUN_TEST(test_a_long_name_leaves_the_cause);
    RUN_TEST(test_a_yaml_cannot_be_inverted);
    return UNITY_END();
}
