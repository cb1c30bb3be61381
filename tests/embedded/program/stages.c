#include "stages.h"

#include "text.h"

#define MAX_STAGES 32u

static struct {
    roomseg_stage entered[MAX_STAGES];
    unsigned count;
} stages;

__attribute__((noinline)) void stages_mark(void)
{
    __asm__ volatile("" ::: "memory");
}

void stages_begin(void)
{
    stages.count = 0;
    stages_mark();
}

int stages_hook(void *user, roomseg_stage stage, unsigned permille)
{
    (void)user;
    (void)permille;
    if (stages.count == 0u || stages.entered[stages.count - 1u] != stage) {
        if (stages.count < MAX_STAGES) {
            stages.entered[stages.count++] = stage;
        }
        stages_mark();
    }
    return 0;
}

void stages_end(void)
{
    stages_mark();
}

void stages_write(void)
{
    text_string(" marks: begin");
    for (unsigned i = 0; i < stages.count; i++) {
        text_string(",");
        text_string(roomseg_stage_name((int)stages.entered[i]));
    }
    text_string("\n");
}
