#ifndef FUZZ_PNG_REPAIR_H
#define FUZZ_PNG_REPAIR_H

#include <stddef.h>
#include <stdint.h>

/* Puts the signature and the right checksums into what may be a PNG: a fuzzer does not guess
 * them, and behind them lies the decoder. */
void png_repair(uint8_t *bytes, size_t size);

#endif
