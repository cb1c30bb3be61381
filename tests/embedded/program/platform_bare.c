/* The platform of a bare target under emulation: semihosting, the memory between bss and the
 * stack, and the stack itself, all from the linker script. */
#include "platform.h"

#include "semihost.h"

extern uint64_t free_start[], free_end[];
extern uint32_t stack_limit[];

void platform_exit(int status);
void platform_fault(void);

#define PAINT 0xA5C3F00Du

/* The painted part ends where the caller's frame began. */
static uint32_t *painted_end;

static uint32_t *stack_pointer(void)
{
    uint32_t *sp;

#if defined(__riscv)
    __asm__ volatile("mv %0, sp" : "=r"(sp));
#else
    __asm__ volatile("mov %0, sp" : "=r"(sp));
#endif
    return sp;
}

void platform_write(const char *text)
{
    semihost_write(text);
}

void platform_exit(int status)
{
    semihost_exit(status);
}

void platform_fault(void)
{
    semihost_write("FAULT\n");
    semihost_exit(99);
}

void *platform_memory(size_t *size)
{
    *size = (size_t)((uintptr_t)free_end - (uintptr_t)free_start);
    return free_start;
}

/* Registers that the compiler may save below the stack pointer after it was read [words]. */
#define OWN_FRAME 16

/* Below its own frame nothing is alive: interrupts are off. */
__attribute__((noinline)) void platform_stack_paint(void)
{
    uint32_t *sp = stack_pointer();

    for (volatile uint32_t *p = stack_limit; p < sp - OWN_FRAME; p++) {
        *p = PAINT;
    }
    painted_end = sp;
}

__attribute__((noinline)) size_t platform_stack_used(void)
{
    const uint32_t *p = stack_limit;

    while (p < painted_end && *p == PAINT) {
        p++;
    }
    return (size_t)((uintptr_t)painted_end - (uintptr_t)p);
}
