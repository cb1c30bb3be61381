/* Checks of what the caller hands in. */
#ifndef RS_CONFIG_H
#define RS_CONFIG_H

#include "base.h"

/* ROOMSEG_OK or the documented error of the first field that is out of range. */
int rs_config_check(const roomseg_config *config);
int rs_config_check_resolution(uint32_t resolution_mm);
int rs_config_check_grid(const roomseg_grid *grid);

#endif
