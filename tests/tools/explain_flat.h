/* The flat that the tests of the explain command look at: two rooms above a corridor, doors, a
 * speck, a box, a fan of light outside. */
#ifndef TESTS_TOOLS_EXPLAIN_FLAT_H
#define TESTS_TOOLS_EXPLAIN_FLAT_H

#include "map.h"

enum { EXPLAIN_FLAT_WIDTH = 220, EXPLAIN_FLAT_HEIGHT = 140 };

/* At 5 cm a cell; to be freed by map_free. */
map explain_flat(void);

/* Turned clockwise by so many degrees, around a middle that stays inside; 280 x 280 cells. */
map explain_flat_turned(double degrees);

/* Puts the true rooms in place of the cells: white, with the doors shut. */
void explain_flat_truth(map *m);

/* Writes a map as a PGM in the test's own folder; its path, as by scratch_path. */
const char *explain_flat_write(const char *name, const map *m);

#endif
