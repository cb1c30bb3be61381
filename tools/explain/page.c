#include "page.h"

#include "base64.h"
#include "utf8.h"

/* Colours for light and dark; one column on a phone. */
static const char style[] =
    ":root{color-scheme:light dark;--back:#fff;--ink:#212529;--soft:#5c646c;--line:#d5dadf;"
    "--box:#f4f6f8;--mark:#c2255c}\n"
    "@media(prefers-color-scheme:dark){:root{--back:#16191d;--ink:#e6e9ec;--soft:#a3abb3;"
    "--line:#3a4148;--box:#20252a;--mark:#f783ac}}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0 auto;padding:1rem;max-width:72rem;background:var(--back);color:var(--ink);"
    "font:1rem/1.55 system-ui,sans-serif;overflow-wrap:break-word}\n"
    "h1{font-size:1.7rem;line-height:1.2}h2{font-size:1.25rem;margin-top:2.5rem;"
    "border-top:1px solid var(--line);padding-top:1rem}\n"
    "h2 .n{color:var(--mark);margin-right:.5rem}\n"
    "p,ul,table{max-width:46rem}\n"
    "code{font-size:.9em}\n"
    "figure{margin:0}figcaption{color:var(--soft);font-size:.9rem;padding:.35rem 0}\n"
    "figure img{display:block;width:100%;height:auto;border:1px solid var(--line);"
    "border-radius:4px;background:#fff}\n"
    ".figures{display:grid;gap:1rem;margin:1rem 0}.of1{max-width:46rem}\n"
    "@media(min-width:44rem){.of2{grid-template-columns:1fr 1fr}"
    ".of4{grid-template-columns:repeat(4,1fr)}.of5{grid-template-columns:repeat(5,1fr)}}\n"
    "@media(max-width:44rem){.of4,.of5{grid-template-columns:1fr 1fr}}\n"
    ".pipeline{display:flex;flex-wrap:wrap;gap:.6rem 1.7rem;list-style:none;padding:0 1.2rem 0 0;"
    "max-width:none}\n"
    ".pipeline li{position:relative;width:7.6rem;background:var(--box);"
    "border:1px solid var(--line);border-radius:6px;padding:.4rem;text-align:center;"
    "font-size:.8rem;line-height:1.25}\n"
    ".pipeline img{display:block;width:100%;height:5.6rem;object-fit:contain;"
    "margin-bottom:.3rem}\n"
    ".pipeline li:not(:last-child)::after{content:\"\\2192\";position:absolute;right:-1.45rem;"
    "top:2.2rem;font-size:1.2rem;color:var(--mark)}\n"
    "table{border-collapse:collapse;font-size:.9rem;margin:.8rem 0}\n"
    "th,td{border-bottom:1px solid var(--line);padding:.2rem .8rem .2rem 0;text-align:left}\n"
    "td.number,th.number{text-align:right}\n"
    ".swatch{display:inline-block;width:.85em;height:.85em;border-radius:2px;"
    "border:1px solid var(--line);vertical-align:-.08em;margin-right:.25em}\n";

void page_begin(FILE *page, const char *title) {
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>",
          page);
    page_text(page, title);
    fprintf(page, "</title>\n<style>\n%s</style>\n</head>\n<body>\n<h1>", style);
    page_text(page, title);
    fputs("</h1>\n", page);
}

void page_end(FILE *page) {
    fputs("</body>\n</html>\n", page);
}

void page_text(FILE *page, const char *text) {
    const unsigned char *at = (const unsigned char *)text;
    while (*at != '\0') {
        int length = utf8_length(at);
        if (length == 0) {
            fputs("\xEF\xBF\xBD", page);
            length = 1;
        } else if (*at == '<' || *at == '>' || *at == '&' || *at == '"' || *at == '\'') {
            fprintf(page, "&#%u;", (unsigned)*at);
        } else if (*at < 0x20 || *at == 0x7F) {
            putc('?', page);
        } else {
            fwrite(at, 1, (size_t)length, page);
        }
        at += length;
    }
}

void page_section(FILE *page, int *count, const char *title) {
    fprintf(page, "<h2><span class=\"n\">%d</span>%s</h2>\n", ++*count, title);
}

void page_image(FILE *page, const encoded_png *png, const char *alt) {
    fprintf(page, "<img width=\"%u\" height=\"%u\" alt=\"%s\" src=\"data:image/png;base64,",
            (unsigned)png->width, (unsigned)png->height, alt);
    base64_write(page, png->bytes, png->size);
    fputs("\">", page);
}

void page_figures_begin(FILE *page, int columns) {
    fprintf(page, "<div class=\"figures of%d\">\n", columns);
}

void page_figures_end(FILE *page) {
    fputs("</div>\n", page);
}

int page_figure_begin(FILE *page, const album *a, const char *name, const char *alt) {
    const figure *f = album_find(a, name);
    if (f == NULL) {
        return 0;
    }
    fputs("<figure>", page);
    page_image(page, &f->full, alt);
    fputs("\n<figcaption>", page);
    return 1;
}

void page_figure_end(FILE *page) {
    fputs("</figcaption></figure>\n", page);
}

void page_figure(FILE *page, const album *a, const char *name, const char *alt,
                 const char *caption) {
    if (page_figure_begin(page, a, name, alt)) {
        fputs(caption, page);
        page_figure_end(page);
    }
}

void page_pipeline_begin(FILE *page) {
    fputs("<ol class=\"pipeline\">\n", page);
}

void page_pipeline_box(FILE *page, const album *a, const char *name, const char *title) {
    const figure *f = album_find(a, name);
    if (f != NULL) {
        fputs("<li>", page);
        page_image(page, &f->thumbnail, "");
        fprintf(page, "%s</li>\n", title);
    }
}

void page_pipeline_end(FILE *page) {
    fputs("</ol>\n", page);
}

void page_parameters_begin(FILE *page) {
    fputs("<table><tr><th>Parameter</th><th class=\"number\">Value</th>"
          "<th class=\"number\">On this map</th></tr>\n",
          page);
}

void page_parameters_end(FILE *page) {
    fputs("</table>\n", page);
}

static void write_row(FILE *page, const char *field, double value, const char *unit) {
    fprintf(page, "<tr><td><code>%s</code></td><td class=\"number\">%.10g%s</td>", field, value,
            unit);
}

void page_parameter(FILE *page, const char *field, double value, const char *unit) {
    write_row(page, field, value, unit);
    fputs("<td></td></tr>\n", page);
}

void page_length(FILE *page, const char *field, double mm, double cell_mm) {
    write_row(page, field, mm, " mm");
    fprintf(page, "<td class=\"number\">%.3g cells</td></tr>\n", mm / cell_mm);
}

void page_area(FILE *page, const char *field, double mm2, double cell_mm) {
    write_row(page, field, mm2, " mm&#178;");
    fprintf(page, "<td class=\"number\">%.4g cells</td></tr>\n", mm2 / (cell_mm * cell_mm));
}

void page_swatch(FILE *page, color paint) {
    fprintf(page, "<span class=\"swatch\" style=\"background:#%02x%02x%02x\"></span>", paint.r,
            paint.g, paint.b);
}
