#include "label_image.h"

#include <stdlib.h>
#include <string.h>

#include "image.h"

int label_image_load(const char *path, label_image *out, tool_error *error) {
    image img;
    memset(out, 0, sizeof *out);
    if (image_load(path, &img, error) != 0) {
        return -1;
    }
    size_t cells = (size_t)img.width * img.height;
    out->values = malloc(cells * sizeof *out->values);
    if (out->values == NULL) {
        tool_error_set(error, "%s: out of memory", path);
        image_free(&img);
        return -1;
    }
    out->width = img.width;
    out->height = img.height;
    for (size_t i = 0; i < cells; i++) {
        out->values[i] = img.gray[i];
    }
    image_free(&img);
    return 0;
}

void label_image_clear(label_image *labels, uint32_t value) {
    size_t cells = (size_t)labels->width * labels->height;
    for (size_t i = 0; i < cells; i++) {
        if (labels->values[i] == value) {
            labels->values[i] = 0;
        }
    }
}

void label_image_free(label_image *labels) {
    free(labels->values);
    memset(labels, 0, sizeof *labels);
}
