/* What tests/support needs of Unity, for a fuzzer: a failed check ends the program, which the
 * fuzzer then reports with its input. */
#ifndef FUZZ_UNITY_H
#define FUZZ_UNITY_H

#include <inttypes.h>
#include <string.h>

#include "fail.h"

#define TEST_ASSERT_TRUE(condition)                                                 \
    do {                                                                            \
        if (!(condition)) {                                                         \
            fail_with("%s:%d: not true: %s", __FILE__, __LINE__, #condition);       \
        }                                                                           \
    } while (0)

#define FUZZ_COMPARE(a, relation, b)                                                \
    do {                                                                            \
        uintmax_t left_ = (uintmax_t)(a), right_ = (uintmax_t)(b);                  \
        if (!(left_ relation right_)) {                                             \
            fail_with("%s:%d: %s = %ju, but %s = %ju", __FILE__, __LINE__, #a, left_, #b, \
                      right_);                                                      \
        }                                                                           \
    } while (0)

#define TEST_ASSERT_NOT_NULL(pointer) TEST_ASSERT_TRUE((pointer) != NULL)
#define TEST_ASSERT_EQUAL_INT(expected, found) FUZZ_COMPARE(found, ==, expected)
#define TEST_ASSERT_EQUAL_UINT(expected, found) FUZZ_COMPARE(found, ==, expected)
#define TEST_ASSERT_EQUAL_UINT64(expected, found) FUZZ_COMPARE(found, ==, expected)
#define TEST_ASSERT_EQUAL_UINT_MESSAGE(expected, found, message) FUZZ_COMPARE(found, ==, expected)
#define TEST_ASSERT_NOT_EQUAL_UINT(unwanted, found) FUZZ_COMPARE(found, !=, unwanted)
#define TEST_ASSERT_GREATER_THAN_UINT(bound, found) FUZZ_COMPARE(found, >, bound)
#define TEST_ASSERT_GREATER_THAN_UINT64(bound, found) FUZZ_COMPARE(found, >, bound)
#define TEST_ASSERT_LESS_THAN_UINT(bound, found) FUZZ_COMPARE(found, <, bound)
#define TEST_ASSERT_EQUAL_STRING(expected, found) TEST_ASSERT_TRUE(strcmp(expected, found) == 0)

#endif
