#include "fixture.h"

#include <string.h>

#include "unity.h"

roomseg_config config;
sketch s;
run r;

void setUp(void)
{
    config = roomseg_config_default();
    memset(&s, 0, sizeof s);
    memset(&r, 0, sizeof r);
}

void tearDown(void)
{
    run_free(&r);
    sketch_free(&s);
}

void segment(const char *const *rows)
{
    run_free(&r);
    sketch_free(&s);
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    r = run_checked(&config, &s.grid);
}

uint16_t at(uint32_t column, uint32_t row)
{
    return run_label(&r, column * SCALE + SCALE / 2, row * SCALE + SCALE / 2);
}
