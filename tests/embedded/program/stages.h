/* Marks where one stage ends and the next begins, for an emulator that counts instructions. */
#ifndef EMBEDDED_STAGES_H
#define EMBEDDED_STAGES_H

#include "roomseg/roomseg.h"

/* Called at the begin of a run, at each change of stage and at the end; does nothing. The
 * emulator's plugin notes how many instructions were executed whenever it is reached. */
void stages_mark(void);

void stages_begin(void);
int stages_hook(void *user, roomseg_stage stage, unsigned permille);
void stages_end(void);

/* " marks: " and what each mark since stages_begin() began, in order. */
void stages_write(void);

#endif
