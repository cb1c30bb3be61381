#include "yaml.h"

#include <string.h>

typedef struct parser {
    const char *name;
    yaml *out;
    yaml_entry *entry; /* the last key, NULL before the first */
    int list_open;     /* inside [ ... */
    int line;
    tool_error *error;
} parser;

static int fail(const parser *p, const char *cause) {
    tool_error_set(p->error, "%s:%d: %s", p->name, p->line, cause);
    return -1;
}

static char *skip_blanks(char *at) {
    return at + strspn(at, " \t");
}

static void trim_end(char *text) {
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t\r", text[length - 1]) != NULL) {
        text[--length] = '\0';
    }
}

/* Position of the quote that closes the one at `open`, or NULL. */
static char *closing_quote(char *open) {
    for (char *at = open + 1; *at != '\0'; at++) {
        if (*open == '"' && *at == '\\' && at[1] != '\0') {
            at++;
        } else if (*at == *open) {
            if (*open == '\'' && at[1] == '\'') {
                at++;
            } else {
                return at;
            }
        }
    }
    return NULL;
}

/* Cuts a comment off the line: a '#' at its beginning or behind a blank, not in quotes.
 * A quote counts only where a scalar can begin. */
static void cut_comment(char *line) {
    for (char *at = line; *at != '\0'; at++) {
        int begins = at == line || strchr(" \t,[", at[-1]) != NULL;
        if (*at == '#' && (at == line || at[-1] == ' ' || at[-1] == '\t')) {
            *at = '\0';
            return;
        }
        if (begins && (*at == '"' || *at == '\'')) {
            char *close = closing_quote(at);
            if (close != NULL) {
                at = close;
            }
        }
    }
}

/* Takes the escapes out of the text between two quotes, in place. */
static int unescape(const parser *p, char *text, char quote) {
    char *to = text;
    for (char *from = text; *from != '\0'; from++) {
        if (quote == '\'' && *from == '\'') {
            from++;
        } else if (quote == '"' && *from == '\\') {
            from++;
            if (*from != '"' && *from != '\\' && *from != '/') {
                return fail(p, "this escape in a quoted text is not understood");
            }
        }
        *to++ = *from;
    }
    *to = '\0';
    return 0;
}

static void add_item(yaml_entry *entry, const char *text) {
    if (entry->item_count < YAML_MAX_ITEMS) {
        entry->items[entry->item_count] = text;
    }
    entry->item_count++;
}

/* Adds the scalar in `text`, which holds nothing else but blanks. */
static int take_scalar(const parser *p, char *text) {
    text = skip_blanks(text);
    trim_end(text);
    if (*text == '"' || *text == '\'') {
        char quote = *text;
        char *close = closing_quote(text);
        if (close == NULL) {
            return fail(p, "a quote stays open");
        }
        if (close[1] != '\0') {
            return fail(p, "there is text behind a quoted text");
        }
        *close = '\0';
        text++;
        if (unescape(p, text, quote) != 0) {
            return -1;
        }
    }
    add_item(p->entry, text);
    return 0;
}

/* Takes list items up to ']' or the end of the line. */
static int take_list_part(parser *p, char *at) {
    for (;;) {
        at = skip_blanks(at);
        char *end = at;
        if (*at == '"' || *at == '\'') {
            end = closing_quote(at);
            if (end == NULL) {
                return fail(p, "a quote stays open");
            }
            end++;
        }
        end += strcspn(end, ",]");
        char mark = *end;
        *end = '\0';
        trim_end(at);
        if (*at != '\0' && take_scalar(p, at) != 0) {
            return -1;
        }
        if (*at == '\0' && mark == ',') {
            return fail(p, "a list item is missing");
        }
        if (mark == '\0') {
            return 0;
        }
        at = end + 1;
        if (mark == ']') {
            p->list_open = 0;
            return *skip_blanks(at) == '\0' ? 0 : fail(p, "there is text behind a list");
        }
    }
}

static int take_value(parser *p, char *text) {
    text = skip_blanks(text);
    if (*text == '\0') {
        return 0;
    }
    if (*text == '[') {
        p->entry->is_list = 1;
        p->list_open = 1;
        return take_list_part(p, text + 1);
    }
    return take_scalar(p, text);
}

/* The colon behind a key: one with a blank or nothing behind it. NULL when there is none. */
static char *key_end(char *text) {
    for (char *at = strchr(text, ':'); at != NULL; at = strchr(at + 1, ':')) {
        if (at[1] == '\0' || at[1] == ' ' || at[1] == '\t') {
            return at;
        }
    }
    return NULL;
}

static int take_key(parser *p, char *text) {
    char *colon = key_end(text);
    if (colon == NULL || colon == text) {
        return fail(p, "neither 'key: value' nor a list item");
    }
    *colon = '\0';
    trim_end(text);
    if (yaml_find(p->out, text) != NULL) {
        tool_error_set(p->error, "%s:%d: key '%s' comes twice", p->name, p->line, text);
        return -1;
    }
    if (p->out->count == YAML_MAX_ENTRIES) {
        return fail(p, "too many keys");
    }
    p->entry = &p->out->entries[p->out->count++];
    memset(p->entry, 0, sizeof *p->entry);
    p->entry->key = text;
    p->entry->line = p->line;
    return take_value(p, colon + 1);
}

/* A line that begins with blanks: it belongs to the key above. */
static int take_nested(parser *p) {
    if (p->entry == NULL || (p->entry->item_count > 0 && !p->entry->nested)) {
        return fail(p, "unexpected indentation");
    }
    p->entry->nested = 1;
    return 0;
}

static int take_line(parser *p, char *line) {
    cut_comment(line);
    trim_end(line);
    char *text = skip_blanks(line);
    if (*text == '\0' || *line == '%' || strcmp(line, "---") == 0 || strcmp(line, "...") == 0) {
        return 0;
    }
    if (p->list_open) {
        return take_list_part(p, text);
    }
    if (p->entry != NULL && p->entry->nested && text != line) {
        return 0;
    }
    if (text[0] == '-' && (text[1] == ' ' || text[1] == '\0')) {
        if (p->entry == NULL || (p->entry->item_count > 0 && !p->entry->is_list)) {
            return fail(p, "a list item without a list");
        }
        p->entry->is_list = 1;
        return take_scalar(p, text + 1);
    }
    return text != line ? take_nested(p) : take_key(p, line);
}

int yaml_parse(char *text, const char *name, yaml *out, tool_error *error) {
    out->count = 0;
    parser p = {name, out, NULL, 0, 0, error};
    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0) {
        text += 3;
    }
    while (text != NULL) {
        char *next = strchr(text, '\n');
        if (next != NULL) {
            *next++ = '\0';
        }
        p.line++;
        if (take_line(&p, text) != 0) {
            return -1;
        }
        text = next;
    }
    if (p.list_open) {
        p.line = p.entry->line;
        return fail(&p, "a list stays open");
    }
    return 0;
}

const yaml_entry *yaml_find(const yaml *doc, const char *key) {
    for (int i = 0; i < doc->count; i++) {
        if (strcmp(doc->entries[i].key, key) == 0) {
            return &doc->entries[i];
        }
    }
    return NULL;
}
