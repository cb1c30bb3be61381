#include "check_map.h"

#include <math.h>
#include <string.h>

#include "memory_files.h"
#include "roomseg/roomseg.h"
#include "unity.h"

void check_error(const tool_error *error, const char *name)
{
    TEST_ASSERT_TRUE(strstr(error->text, name) != NULL);
    for (const char *c = error->text; *c != '\0'; c++) {
        TEST_ASSERT_TRUE((unsigned char)*c >= 0x20 && *c != 0x7f);
    }
}

void check_map(const map_options *options, const uint8_t *first, size_t first_size,
               const uint8_t *second, size_t second_size)
{
    map maps[2];
    tool_error errors[2] = {{""}, {""}};
    int rc[2];
    for (int i = 0; i < 2; i++) {
        memory_files_set(first, first_size, second, second_size);
        memset(&maps[i], 0x5A, sizeof maps[i]);
        rc[i] = map_load("folder/input", options, &maps[i], &errors[i]);
    }
    TEST_ASSERT_EQUAL_INT(rc[0], rc[1]);
    TEST_ASSERT_EQUAL_STRING(errors[0].text, errors[1].text);
    if (rc[0] == 0) {
        size_t cells = (size_t)maps[0].width * maps[0].height;
        double mm = round(maps[0].resolution_m * 1000.0);
        TEST_ASSERT_TRUE(cells > 0 && maps[0].width <= IMAGE_MAX_SIDE &&
                         maps[0].height <= IMAGE_MAX_SIDE);
        TEST_ASSERT_TRUE(mm >= ROOMSEG_MIN_RESOLUTION_MM && mm <= ROOMSEG_MAX_RESOLUTION_MM);
        TEST_ASSERT_TRUE(isfinite(maps[0].origin_x_m) && isfinite(maps[0].origin_y_m) &&
                         isfinite(maps[0].origin_yaw_rad));
        TEST_ASSERT_EQUAL_INT(0, memcmp(maps[0].cells, maps[1].cells, cells));
    } else {
        /* "FILE: cause"; a YAML may name any file as its image. */
        check_error(&errors[0], ": ");
        TEST_ASSERT_TRUE(maps[0].cells == NULL && maps[0].width == 0 && maps[0].height == 0);
    }
    map_free(&maps[0]);
    map_free(&maps[1]);
}
