/* The memory plan: no two buffers that are alive at once share a byte, none reaches beyond the
 * arena, and the arena is what the fullest stage needs. */
#include "plan.h"
#include "plan_paper.h"
#include "unity.h"

#define ROW(S, name, element, count, first, last) {(element) * (count), first, last},

void setUp(void)
{
}

void tearDown(void)
{
}

static size_t fullest_stage(const rs_plan_row *rows, uint32_t count)
{
    size_t most = 0;
    for (int stage = 0; stage < 20; stage++) {
        size_t bytes = 0;
        for (uint32_t i = 0; i < count; i++) {
            bool alive = rows[i].first <= stage && stage <= rows[i].last;
            bytes += alive ? ROOMSEG_PLAN_ALIGN(rows[i].bytes) : 0;
        }
        most = bytes > most ? bytes : most;
    }
    return most;
}

static void check(const rs_plan_row *rows, uint32_t count)
{
    rs_plan plan;
    rs_plan_place(rows, count, &plan);
    TEST_ASSERT_EQUAL_size_t(fullest_stage(rows, count), plan.size);
    for (uint32_t i = 0; i < count; i++) {
        TEST_ASSERT_EQUAL_size_t(0, plan.offset[i] % 8);
        TEST_ASSERT_LESS_OR_EQUAL_size_t(plan.size, plan.offset[i] + rows[i].bytes);
        for (uint32_t j = 0; j < i; j++) {
            bool together = rows[i].first <= rows[j].last && rows[j].first <= rows[i].last;
            bool apart = plan.offset[i] >= plan.offset[j] + rows[j].bytes ||
                         plan.offset[j] >= plan.offset[i] + rows[i].bytes;
            TEST_ASSERT_TRUE_MESSAGE(!together || apart, "two buffers share bytes");
        }
    }
}

/* Every table for a crop, small: cells of the largest obstacle that is dropped. */
static void check_tables(size_t width, size_t height, size_t small, size_t regions, size_t rooms)
{
    size_t wide = ROOMSEG_PLAN_TURNED_WIDTH(width, height);
    size_t high = ROOMSEG_PLAN_TURNED_HEIGHT(width, height);
    size_t inner = ROOMSEG_ARENA_SIZE(wide, high, small, regions, rooms);
    const rs_plan_row by_default[] = {
        ROOMSEG_PLAN_TABLE(ROW, , width, height, small, regions, rooms)};
    const rs_plan_row paper[] = {
        ROOMSEG_PLAN_PAPER_TABLE(ROW, , width, height, small, regions, rooms)};
    const rs_plan_row find[] = {ROOMSEG_PLAN_FIND_TABLE(ROW, , width, height, small)};
    const rs_plan_row turn[] = {
        ROOMSEG_PLAN_TURN_TABLE(ROW, , width, height, wide, high, small, rooms, inner)};

    check(by_default, sizeof by_default / sizeof *by_default);
    check(paper, sizeof paper / sizeof *paper);
    check(find, sizeof find / sizeof *find);
    check(turn, sizeof turn / sizeof *turn);
}

static void test_crops_and_capacities(void)
{
    const size_t sides[] = {1, 2, 3, 10, 63, 400, 3000};
    const size_t capacities[] = {1, 7, 1024, 65532};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t j = 0; j < sizeof sides / sizeof *sides; j++) {
            for (size_t k = 0; k < sizeof capacities / sizeof *capacities; k++) {
                check_tables(sides[i], sides[j], 1, capacities[k], 1);
                check_tables(sides[i], sides[j], 10001, capacities[k], capacities[k] / 4 + 1);
            }
        }
    }
}

static bool together(const rs_plan_row *a, const rs_plan_row *b)
{
    return a->first <= b->last && b->first <= a->last;
}

/* Why the plan holds for all sizes, not only those above. Where a lies above i in the table, at
 * the same end of the arena, and both are alive together, i comes to lie behind a. If then all that
 * is alive with i and stands below it, or at the other end, is alive with a, too, then every chain
 * of buffers that push each other on, from both ends, is alive together in pairs; intervals that
 * meet in pairs have a stage in common; so the chain is no longer than the bytes of that stage. */
static void check_lifetimes(const rs_plan_row *rows, uint32_t count)
{
    int last = 0;
    for (uint32_t i = 0; i < count; i++) {
        last = rows[i].last > last ? rows[i].last : last;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t a = 0; a < i; a++) {
            bool pushes = (rows[a].last == last) == (rows[i].last == last);
            for (uint32_t k = 0; pushes && together(&rows[a], &rows[i]) && k < count; k++) {
                bool behind = k > i || (rows[k].last == last) != (rows[i].last == last);
                TEST_ASSERT_TRUE(!behind || !together(&rows[i], &rows[k]) ||
                                 together(&rows[a], &rows[k]));
            }
        }
    }
}

static void test_lifetimes_leave_no_gaps(void)
{
    const rs_plan_row by_default[] = {ROOMSEG_PLAN_TABLE(ROW, , 1, 1, 1, 1, 1)};
    const rs_plan_row paper[] = {ROOMSEG_PLAN_PAPER_TABLE(ROW, , 1, 1, 1, 1, 1)};
    const rs_plan_row find[] = {ROOMSEG_PLAN_FIND_TABLE(ROW, , 1, 1, 1)};
    const rs_plan_row turn[] = {ROOMSEG_PLAN_TURN_TABLE(ROW, , 1, 1, 1, 1, 1, 1, 1)};
    check_lifetimes(by_default, sizeof by_default / sizeof *by_default);
    check_lifetimes(paper, sizeof paper / sizeof *paper);
    check_lifetimes(find, sizeof find / sizeof *find);
    check_lifetimes(turn, sizeof turn / sizeof *turn);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_crops_and_capacities);
    RUN_TEST(test_lifetimes_leave_no_gaps);
    return UNITY_END();
}
