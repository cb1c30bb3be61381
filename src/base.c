#include "base.h"

bool rs_ticker_enter(rs_ticker *ticker, roomseg_stage stage)
{
    ticker->stage = stage;
    ticker->permille = 0;
    ticker->visits = 0;
    rs_ticker_part(ticker, 0, 1000);
    return rs_ticker_call(ticker, 0, 1);
}

void rs_ticker_part(rs_ticker *ticker, uint32_t from, uint32_t to)
{
    ticker->part_from = from;
    ticker->part_missing = 1000u - (to - from);
}

bool rs_ticker_call(rs_ticker *ticker, uint32_t done, uint32_t total)
{
    uint32_t permille;

    if (ticker->hook == NULL) {
        return false;
    }
    /* done <= total < 2^29, so scale down before the product can exceed 32 bits. */
    while (total >= (1u << 22)) {
        total >>= 1;
        done >>= 1;
    }
    permille = total == 0u ? 1000u : rs_min_u32(done * 1000u / total, 1000u);
    permille = ticker->part_from + permille * (1000u - ticker->part_missing) / 1000u;
    ticker->permille = rs_max_u32(ticker->permille, permille);
    return ticker->hook(ticker->user, ticker->stage, ticker->permille) != 0;
}

uint32_t rs_isqrt(uint32_t n)
{
    uint32_t root = 0;
    uint32_t bit = n < 1u << 16 ? 1u << 14 : 1u << 30;

    while (bit > n) {
        bit >>= 2;
    }
    /* Digit by digit in base 4; n - root^2 >= 0 holds throughout. */
    while (bit != 0u) {
        if (n >= root + bit) {
            n -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
        bit >>= 2;
    }
    return root;
}

uint32_t rs_divide_q8(uint64_t numerator, uint32_t denominator)
{
    uint64_t rest = 0;
    uint32_t quotient = 0;

    /* Schoolbook division, one bit a step: 64 bits of the numerator, then 8 fractional
     * ones. rest stays below 2 * denominator, and bits of the quotient beyond 32 are zero
     * by the precondition. */
    for (int bit = 63 + 8; bit >= 0; bit--) {
        rest <<= 1;
        if (bit >= 8) {
            rest |= numerator >> (bit - 8) & 1u;
        }
        quotient <<= 1;
        if (rest >= denominator) {
            rest -= denominator;
            quotient |= 1u;
        }
    }
    return quotient;
}
