/* Start-up of a Cortex-M: vector table, memory, floating-point unit, main(). */
#include <stdint.h>

/* From link.ld: addresses, not variables. */
extern uint32_t stack_top[], data_start[], data_end[], data_load[], bss_start[], bss_end[];

int main(void);
/* Given by the program: what happens when main() returns. */
void platform_exit(int status);
/* Given by the program: HardFault and all others that are not handled. */
void platform_fault(void);

void reset_handler(void);

#define CPACR (*(volatile uint32_t *)0xE000ED88u)
#define CPACR_CP10_CP11_FULL (0xFu << 20)

typedef void (*vector)(void);

/* Initial stack pointer, then the 15 exceptions of the architecture; 0 where it reserves them. */
__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    (vector)(uintptr_t)stack_top,
    reset_handler,
    platform_fault, /* NMI */
    platform_fault, /* HardFault */
    platform_fault, /* MemManage */
    platform_fault, /* BusFault */
    platform_fault, /* UsageFault */
    platform_fault, /* SecureFault */
    0,
    0,
    0,
    platform_fault, /* SVCall */
    platform_fault, /* DebugMonitor */
    0,
    platform_fault, /* PendSV */
    platform_fault, /* SysTick */
};

void reset_handler(void)
{
    const uint32_t *from = data_load;

#ifdef __ARM_FP
    /* Compilers save floating-point registers even where no arithmetic is done. */
    CPACR |= CPACR_CP10_CP11_FULL;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    for (uint32_t *to = data_start; to < data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = bss_start; to < bss_end; to++) {
        *to = 0;
    }
    platform_exit(main());
}
