#include "report.h"

void report_labels_pgm(const map *m, const segmentation *s, FILE *stream) {
    int wide = s->result.room_count > 255;
    fprintf(stream, "P5\n%u %u\n%d\n", (unsigned)m->width, (unsigned)m->height,
            wide ? 65535 : 255);
    size_t count = (size_t)m->width * m->height;
    for (size_t i = 0; i < count; i++) {
        uint16_t label = s->labels[i];
        if (wide) {
            putc(label >> 8, stream);
        }
        putc(label & 255, stream);
    }
}
