#include "../../src/base.c"
#include "proof.h"

/* Each digit keeps root^2 <= n, so the result is that of the definition. */
void prove_isqrt(void)
{
    uint32_t n = nondet_u32();
    uint32_t root = rs_isqrt(n);
    PROVE(root <= 65535u);
}

void prove_isqrt_value(void)
{
    uint32_t n = nondet_u32();
    ASSUME(n < 1u << 16);
    uint32_t root = rs_isqrt(n);
    PROVE(root * root <= n && n < (root + 1u) * (root + 1u));
}

void prove_divide_q8(void)
{
    uint64_t n = nondet_u64();
    uint32_t d = nondet_u32();
    ASSUME(d >= 1u && n >> 32 < d);
    rs_divide_q8(n, d);
}

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    (void)user;
    PROVE(permille <= 1000u && (int)stage >= 0);
    return 0;
}

void prove_ticker_call(void)
{
    rs_ticker ticker = {hook, NULL, ROOMSEG_STAGE_GRAPH, 0, nondet_u32(), 0, 0};
    uint32_t from = nondet_u32(), to = nondet_u32(), done = nondet_u32(), total = nondet_u32();
    ASSUME(ticker.permille <= 1000u && from <= to && to <= 1000u);
    ASSUME(total < 1u << 29 && done <= total);
    uint32_t before = ticker.permille;
    rs_ticker_part(&ticker, from, to);
    rs_ticker_call(&ticker, done, total);
    PROVE(ticker.permille >= before);
}
