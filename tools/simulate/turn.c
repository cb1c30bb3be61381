#include "turn.h"

/* Sine of quarter / TURN_QUARTER right angles, quarter 0..TURN_QUARTER, times 65536: the
 * power series in z = quarter / TURN_QUARTER up to z^9, its factors (pi/2)^n / n! in units
 * of 2^-30. What is cut off is below 4e-6. */
static int32_t sin_quarter(int32_t quarter) {
    static const int64_t factors[] = {172272, 5026995, 85569306, 693598668, 1686629713};
    int64_t z = (int64_t)quarter << 16;
    int64_t z2 = (z * z) >> 30;
    int64_t sum = 0;
    for (int i = 0; i < 5; i++) {
        sum = factors[i] - ((sum * z2) >> 30);
    }
    int64_t sine = ((sum * z) >> 30) + (1 << 13);
    return (int32_t)(sine >> 14);
}

int32_t turn_sin(int32_t angle) {
    uint32_t a = (uint32_t)angle & (TURN_FULL - 1);
    int32_t low = (int32_t)(a & (TURN_QUARTER - 1));
    switch (a / TURN_QUARTER) {
    case 0:
        return sin_quarter(low);
    case 1:
        return sin_quarter(TURN_QUARTER - low);
    case 2:
        return -sin_quarter(low);
    default:
        return -sin_quarter(TURN_QUARTER - low);
    }
}

int32_t turn_cos(int32_t angle) {
    return turn_sin((int32_t)((uint32_t)angle & (TURN_FULL - 1)) + TURN_QUARTER);
}
