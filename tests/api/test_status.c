/* roomseg_status_text, roomseg_stage_name, roomseg_config_default. */
#include <string.h>

#include "roomseg/roomseg.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_each_status_has_a_text_of_its_own(void)
{
    for (int status = 0; status >= ROOMSEG_ERR_CANCELLED; status--) {
        const char *text = roomseg_status_text(status);
        TEST_ASSERT_NOT_NULL(text);
        TEST_ASSERT_GREATER_THAN_size_t(0, strlen(text));
        TEST_ASSERT_NOT_EQUAL_INT(0, strcmp(text, "unknown status"));
        for (int other = 0; other > status; other--) {
            TEST_ASSERT_NOT_EQUAL_INT(0, strcmp(text, roomseg_status_text(other)));
        }
    }
}

static void test_other_numbers_are_an_unknown_status(void)
{
    const int others[] = {1, 2, 100, ROOMSEG_ERR_CANCELLED - 1, -1000, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        TEST_ASSERT_EQUAL_STRING("unknown status", roomseg_status_text(others[i]));
    }
}

static void test_each_stage_has_a_name_in_lower_case(void)
{
    for (int stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
        const char *name = roomseg_stage_name(stage);
        TEST_ASSERT_GREATER_THAN_size_t(1, strlen(name));
        TEST_ASSERT_EQUAL_size_t(strlen(name), strspn(name, "abcdefghijklmnopqrstuvwxyz_- "));
        for (int other = 0; other < stage; other++) {
            TEST_ASSERT_NOT_EQUAL_INT(0, strcmp(name, roomseg_stage_name(other)));
        }
    }
}

static void test_other_numbers_are_no_stage(void)
{
    TEST_ASSERT_EQUAL_STRING("?", roomseg_stage_name(-1));
    TEST_ASSERT_EQUAL_STRING("?", roomseg_stage_name(ROOMSEG_STAGE_COUNT));
    TEST_ASSERT_EQUAL_STRING("?", roomseg_stage_name(INT32_MAX));
    TEST_ASSERT_EQUAL_STRING("?", roomseg_stage_name(INT32_MIN));
}

static void test_the_default_config_is_the_documented_one(void)
{
    roomseg_config config = roomseg_config_default();
    TEST_ASSERT_EQUAL_UINT(51, config.free_max);
    TEST_ASSERT_EQUAL_UINT(204, config.occupied_min);
    TEST_ASSERT_EQUAL_UINT(96000, config.speck_mm2);
    TEST_ASSERT_EQUAL_UINT(1500, config.clutter_mm);
    TEST_ASSERT_EQUAL_UINT(1000000, config.smallest_room_mm2);
    TEST_ASSERT_EQUAL_UINT(10, config.isolated_permille);
    TEST_ASSERT_EQUAL_UINT(3000000, config.niche_mm2);
    TEST_ASSERT_EQUAL_UINT(83, config.room_opening_percent);
    TEST_ASSERT_EQUAL_UINT(41, config.passage_opening_percent);
    TEST_ASSERT_EQUAL_UINT(3, config.passage_min_neighbours);
    TEST_ASSERT_EQUAL_UINT(1000, config.shared_wall_mm);
    TEST_ASSERT_EQUAL_UINT(3, config.lived_in_permille);
    TEST_ASSERT_EQUAL_UINT(50, config.open_plan_percent);
    TEST_ASSERT_EQUAL_UINT(950, config.door_mm);
    TEST_ASSERT_EQUAL_UINT(1600, config.hall_mm);
    TEST_ASSERT_EQUAL_UINT(50, config.unwalled_percent);
    TEST_ASSERT_EQUAL_UINT(1024, config.max_regions);
    TEST_ASSERT_EQUAL_UINT(255, config.max_rooms);
    TEST_ASSERT_TRUE(config.progress == NULL);
    TEST_ASSERT_NULL(config.progress_user);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_status_has_a_text_of_its_own);
    RUN_TEST(test_other_numbers_are_an_unknown_status);
    RUN_TEST(test_each_stage_has_a_name_in_lower_case);
    RUN_TEST(test_other_numbers_are_no_stage);
    RUN_TEST(test_the_default_config_is_the_documented_one);
    return UNITY_END();
}
