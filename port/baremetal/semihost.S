/* uintptr_t semihost_call(uintptr_t operation, const void *argument): both are where the ABI of
 * semihosting wants them already, and so is what comes back. */
#if defined(__arm__)
    .syntax unified
    .section .text.semihost_call, "ax", %progbits
    .global semihost_call
    .type semihost_call, %function
#if defined(__thumb__)
    .thumb
    .thumb_func
semihost_call:
    bkpt #0xAB
    bx lr
#else
    .arm
semihost_call:
    push {r4, lr} /* the call is an exception into the mode we are in: it takes lr */
    svc #0x123456
    pop {r4, pc}
#endif
    .size semihost_call, . - semihost_call
#elif defined(__riscv)
    .section .text.semihost_call, "ax", %progbits
    .global semihost_call
    .type semihost_call, %function
    /* The trap is told from a breakpoint by the instructions around it, which must be
     * uncompressed and lie in one page. */
    .option push
    .option norvc
    .balign 16
semihost_call:
    slli zero, zero, 0x1f
    ebreak
    srai zero, zero, 7
    ret
    .option pop
    .size semihost_call, . - semihost_call
#else
#error no semihosting for this CPU
#endif

    .section .note.GNU-stack, "", %progbits
