/* The documented range of each numeric field of roomseg_config. */
#ifndef SUPPORT_CONFIG_FIELDS_H
#define SUPPORT_CONFIG_FIELDS_H

#include "roomseg/roomseg.h"

typedef struct config_field {
    const char *name;
    size_t offset;
    size_t size;        /* 1 or 4 bytes */
    uint32_t low, high; /* the range, both ends inside */
} config_field;

extern const config_field config_fields[];
extern const size_t config_field_count;

void config_field_set(roomseg_config *config, const config_field *field, uint32_t value);

/* Calls `visit` with the default config and one field just outside of its range, for each end
 * of each field that has a value beyond it. */
void config_each_invalid(void (*visit)(const roomseg_config *config, const char *field));

/* The same with one field at each end of its range, the others adjusted where they have to be. */
void config_each_extreme(void (*visit)(const roomseg_config *config, const char *field));

#endif
