/* Start-up of a Cortex-A7 on one core: vectors, floating-point unit, stack, bss, main(). MMU and
 * caches stay off. */
    .syntax unified
    .arm
    .section .text.start, "ax", %progbits
    .global start
    .type start, %function
start:
    ldr r0, =vectors
    mcr p15, 0, r0, c12, c0, 0 /* VBAR */
    ldr sp, =stack_top
#ifdef __ARM_FP
    mrc p15, 0, r0, c1, c0, 2 /* CPACR: coprocessors 10 and 11 */
    orr r0, r0, #(0xF << 20)
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #(1 << 30) /* FPEXC.EN */
    vmsr fpexc, r0
#endif
    ldr r0, =bss_start
    ldr r1, =bss_end
    mov r2, #0
clear:
    cmp r0, r1
    bhs cleared
    str r2, [r0], #4
    b clear
cleared:
    bl main
    bl platform_exit
    .size start, . - start

    .balign 32
vectors:
    b start
    b platform_fault /* undefined instruction */
    b platform_fault /* supervisor call: the emulator takes semihosting's before it gets here */
    b platform_fault /* prefetch abort */
    b platform_fault /* data abort */
    b platform_fault
    b platform_fault /* interrupt */
    b platform_fault /* fast interrupt */

    .section .note.GNU-stack, "", %progbits
