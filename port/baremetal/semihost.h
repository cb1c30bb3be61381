/* Semihosting: the debugger or emulator does input and output for the target. Only for tests;
 * without a debugger each call is a fault. ABI: Arm document IHI 0074, which RISC-V shares. */
#ifndef ROOMSEG_PORT_SEMIHOST_H
#define ROOMSEG_PORT_SEMIHOST_H

#include <stdint.h>

#define SEMIHOST_WRITE0 0x04u        /* argument: a text that ends with 0 */
#define SEMIHOST_EXIT_EXTENDED 0x20u /* argument: reason and exit status */
#define SEMIHOST_EXITED 0x20026u     /* reason: the program ended by itself */

/* In semihost.S. argument: the operation's parameter block. */
uintptr_t semihost_call(uintptr_t operation, const void *argument);

static inline void semihost_write(const char *text)
{
    (void)semihost_call(SEMIHOST_WRITE0, text);
}

static inline void semihost_exit(int status)
{
    const uintptr_t block[2] = {SEMIHOST_EXITED, (uintptr_t)status};

    (void)semihost_call(SEMIHOST_EXIT_EXTENDED, block);
    for (;;) {
    }
}

#endif
