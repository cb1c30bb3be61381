/* Work on all cores: everything is done once, and reported in order. */
#include <stdlib.h>

#include "unity.h"
#include "workers.h"

enum { MAX_ITEMS = 500 };

typedef struct ledger {
    int done[MAX_ITEMS];
    size_t reported;
    int in_order;
} ledger;

static ledger book;

void setUp(void) {
    book = (ledger){{0}, 0, 1};
}

void tearDown(void) {
}

/* Early items take longest, so that later ones overtake them. */
static void job(void *user, size_t index) {
    ledger *l = user;
    volatile unsigned long turns = index % 7 == 0 ? 200000 : 10;
    while (turns > 0) {
        turns--;
    }
    l->done[index]++;
}

static void finished(void *user, size_t index) {
    ledger *l = user;
    l->in_order = l->in_order && index == l->reported && l->done[index] == 1;
    l->reported++;
}

static void check(size_t count, int workers) {
    setUp();
    workers_run(count, workers, job, finished, &book);
    TEST_ASSERT_EQUAL_size_t(count, book.reported);
    TEST_ASSERT_TRUE(book.in_order);
    for (size_t i = 0; i < MAX_ITEMS; i++) {
        TEST_ASSERT_EQUAL_INT(i < count, book.done[i]);
    }
}

static void test_every_item_once_and_in_order(void) {
    const int workers[] = {1, 2, 3, 8, WORKERS_MAX};
    for (size_t i = 0; i < sizeof workers / sizeof *workers; i++) {
        check(MAX_ITEMS, workers[i]);
        check(3, workers[i]);
        check(1, workers[i]);
        check(0, workers[i]);
    }
}

static void test_the_default_is_in_range(void) {
    TEST_ASSERT_GREATER_OR_EQUAL_INT(1, workers_default());
    TEST_ASSERT_LESS_OR_EQUAL_INT(WORKERS_MAX, workers_default());
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_every_item_once_and_in_order);
    RUN_TEST(test_the_default_is_in_range);
    return UNITY_END();
}
