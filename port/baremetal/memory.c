/* memcpy, memmove and memset for builds with -nostdlib: a word at a time where both ends are
 * aligned. A C library's are faster. Compile with -fno-builtin, or the compiler may turn the
 * loops into calls of the very functions they implement. */
#include <stdint.h>
#include <string.h>

#ifndef __GNUC__
#error "bytes are read as words here, which needs the compiler's word that they may alias"
#endif
typedef uint32_t __attribute__((may_alias)) word;

/* Link-time optimisation makes calls of these only after it dropped what nobody calls. */
#define KEPT __attribute__((used))

static int aligned(const void *p)
{
    return (uintptr_t)p % sizeof(word) == 0u;
}

KEPT void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    unsigned char *out = to;
    const unsigned char *in = from;

    if (aligned(to) && aligned(from)) {
        for (; count >= sizeof(word); count -= sizeof(word)) {
            *(word *)(void *)out = *(const word *)(const void *)in;
            out += sizeof(word);
            in += sizeof(word);
        }
    }
    while (count-- > 0u) {
        *out++ = *in++;
    }
    return to;
}

KEPT void *memmove(void *to, const void *from, size_t count)
{
    unsigned char *out = to;
    const unsigned char *in = from;

    if ((uintptr_t)out - (uintptr_t)in >= count) { /* modulo 2^N: also when out < in */
        while (count-- > 0u) {
            *out++ = *in++;
        }
    } else {
        while (count-- > 0u) {
            out[count] = in[count];
        }
    }
    return to;
}

KEPT void *memset(void *to, int value, size_t count)
{
    unsigned char *out = to;
    word pattern = (unsigned char)value * (word)0x01010101u;

    for (; count > 0u && !aligned(out); count--) {
        *out++ = (unsigned char)value;
    }
    for (; count >= sizeof(word); count -= sizeof(word)) {
        *(word *)(void *)out = pattern;
        out += sizeof(word);
    }
    while (count-- > 0u) {
        *out++ = (unsigned char)value;
    }
    return to;
}

#ifdef __arm__
/* The names that the Arm run-time ABI (document IHI 0043) has for them, which Clang calls.
 * The order of memset's arguments is another. */
#define ALIAS(name, target) __attribute__((alias(#target))) void *name(void *, const void *, size_t)

ALIAS(__aeabi_memcpy, memcpy);
ALIAS(__aeabi_memcpy4, memcpy);
ALIAS(__aeabi_memcpy8, memcpy);
ALIAS(__aeabi_memmove, memmove);
ALIAS(__aeabi_memmove4, memmove);
ALIAS(__aeabi_memmove8, memmove);

void __aeabi_memset(void *to, size_t count, int value);
void __aeabi_memclr(void *to, size_t count);

KEPT void __aeabi_memset(void *to, size_t count, int value)
{
    (void)memset(to, value, count);
}

KEPT void __aeabi_memclr(void *to, size_t count)
{
    (void)memset(to, 0, count);
}

__attribute__((alias("__aeabi_memset"))) void __aeabi_memset4(void *, size_t, int);
__attribute__((alias("__aeabi_memset"))) void __aeabi_memset8(void *, size_t, int);
__attribute__((alias("__aeabi_memclr"))) void __aeabi_memclr4(void *, size_t);
__attribute__((alias("__aeabi_memclr"))) void __aeabi_memclr8(void *, size_t);
#endif
