/* Sine, cosine and directions against the C library's. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "trig.h"
#include "unity.h"

static double pi;

void setUp(void)
{
    pi = acos(-1.0);
}

void tearDown(void)
{
}

static void test_every_angle(void)
{
    double worst = 0.0;
    for (int32_t angle = -72000; angle <= 72000; angle++) {
        rs_direction d = rs_trig_direction(angle);
        double radians = angle * pi / 18000.0;
        worst = fmax(worst, fabs((double)d.cos / RS_TRIG_ONE - cos(radians)));
        worst = fmax(worst, fabs((double)d.sin / RS_TRIG_ONE - sin(radians)));
    }
    TEST_ASSERT_TRUE(worst < 1.0 / (1 << 27));
}

static void test_quarter_turns_are_exact(void)
{
    const int32_t cosines[4] = {RS_TRIG_ONE, 0, -RS_TRIG_ONE, 0};
    for (int32_t quarter = -8; quarter <= 8; quarter++) {
        rs_direction d = rs_trig_direction(quarter * 90 * RS_DEGREE);
        TEST_ASSERT_EQUAL_INT32(cosines[(quarter + 8) % 4], d.cos);
        TEST_ASSERT_EQUAL_INT32(cosines[(quarter + 8 + 3) % 4], d.sin);
    }
}

static void expect_angle(int32_t x, int32_t y)
{
    double exact = atan2(y, x) * 18000.0 / pi;
    int32_t found = rs_trig_angle(x, y);
    if (fabs(found - exact) >= 1.1) {
        TEST_FAIL_MESSAGE("an angle is off by more than 0.011 degrees");
    }
}

static void test_angles_of_vectors(void)
{
    for (int32_t x = -60; x <= 60; x++) {
        for (int32_t y = -60; y <= 60; y++) {
            if (x != 0 || y != 0) {
                expect_angle(x, y);
            }
        }
    }
    for (int i = 0; i < 200000; i++) {
        int32_t x = (int32_t)((uint32_t)rand() >> (1 + i % 30)) - (int32_t)(rand() & 0xFFFF);
        int32_t y = (int32_t)((uint32_t)rand() >> (1 + i / 7 % 30)) - (int32_t)(rand() & 0xFFFF);
        if (x != 0 || y != 0) {
            expect_angle(x, y);
        }
    }
    expect_angle(INT32_MAX, INT32_MAX);
    expect_angle(-INT32_MAX, 1);
    expect_angle(1, -INT32_MAX);
}

static void test_axes_are_exact(void)
{
    TEST_ASSERT_EQUAL_INT32(0, rs_trig_angle(0, 0));
    TEST_ASSERT_EQUAL_INT32(0, rs_trig_angle(7, 0));
    TEST_ASSERT_EQUAL_INT32(9000, rs_trig_angle(0, 7));
    TEST_ASSERT_EQUAL_INT32(18000, rs_trig_angle(-7, 0));
    TEST_ASSERT_EQUAL_INT32(-9000, rs_trig_angle(0, -7));
    TEST_ASSERT_EQUAL_INT32(4500, rs_trig_angle(9, 9));
    TEST_ASSERT_EQUAL_INT32(-13500, rs_trig_angle(-9, -9));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_angle);
    RUN_TEST(test_quarter_turns_are_exact);
    RUN_TEST(test_angles_of_vectors);
    RUN_TEST(test_axes_are_exact);
    return UNITY_END();
}
