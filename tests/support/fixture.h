/* One drawn map and one run of it: what tests of the public interface share. setUp and tearDown
 * come with it. */
#ifndef SUPPORT_FIXTURE_H
#define SUPPORT_FIXTURE_H

#include "run.h"
#include "sketch.h"

enum { SCALE = 8 /* cells along a character */, RESOLUTION_MM = 50 };

extern roomseg_config config; /* the default one at the start of a test */
extern sketch s;              /* freed at the end of a test, as is the run */
extern run r;

/* Draws the rows and runs them under the config; one character is 0.4 m. */
void segment(const char *const *rows);

/* Label in the middle of a character. */
uint16_t at(uint32_t column, uint32_t row);

#endif
