/* Start-up of a RISC-V of 32 or 64 bits on one hart, in machine mode. */
    .option arch, +zicsr
    .section .text.start, "ax", %progbits
    .global start
    .type start, %function
start:
    .option push
    .option norelax /* gp is not there yet to relax against */
    la gp, __global_pointer$
    .option pop
    la sp, stack_top
    la t0, trap
    csrw mtvec, t0
    la t0, bss_start
    la t1, bss_end
clear:
    bgeu t0, t1, cleared
    sw zero, 0(t0)
    addi t0, t0, 4
    j clear
cleared:
    call main
    call platform_exit
    .size start, . - start

    .balign 4 /* direct mode: the two low bits are the mode */
trap:
    call platform_fault

    .section .note.GNU-stack, "", %progbits
