/* The flat YAML that map files are written in: one `key: value` a line. */
#ifndef ROOMSEG_TOOLS_YAML_H
#define ROOMSEG_TOOLS_YAML_H

#include <stddef.h>

#include "tool_error.h"

#define YAML_MAX_ENTRIES 64
#define YAML_MAX_ITEMS 8

typedef struct yaml_entry {
    const char *key;
    const char *items[YAML_MAX_ITEMS]; /* a scalar is items[0] with is_list 0 */
    int item_count;                    /* more than YAML_MAX_ITEMS are counted, not kept */
    int is_list;
    int nested; /* holds a mapping, whose contents were passed over */
    int line;   /* of the key, from 1 */
} yaml_entry;

/* A parsed document; the strings lie in the text that it was parsed from. */
typedef struct yaml {
    yaml_entry entries[YAML_MAX_ENTRIES];
    int count;
} yaml;

/* Parses a text in place, which it changes. Understood: scalars, plain or in single or
 * double quotes; lists, `[a, b]` on one line or several or `- a` lines; comments; a byte
 * order mark; `---` and `...`; `%` directives. A mapping below a key is passed over.
 * Fails iff: a line has none of these forms, a key comes twice, a quote or a list stays
 * open, or there are more than YAML_MAX_ENTRIES keys. Returns 0, or -1 with *error set,
 * which names the line. */
int yaml_parse(char *text, const char *name, yaml *out, tool_error *error);

/* The entry of that key, or NULL. */
const yaml_entry *yaml_find(const yaml *doc, const char *key);

#endif
