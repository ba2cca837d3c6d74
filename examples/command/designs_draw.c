/*
 * designs_draw.c: muslin designs --png: a contact sheet: the pieces of each design, flat, its name under them.
 *
 * A tile draws each piece of the paper once, grain up, all at one scale, in rows. It is filled by its even-odd rule and
 * lined at SAMPLES x SAMPLES samples a pixel. A design takes the time of its draft, some milliseconds; worn pictures
 * take seconds each (muslin sheet).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "designs.h"
#include "letters.h"
#include "muslin/print.h"
#include "render/render.h"

#define TILE_WIDE 240 /* [pixels] */
#define TILE_HIGH 260 /* [pixels] with the name */
#define NAME_HIGH 20  /* [pixels] of the name */
#define MARGIN 8      /* [pixels] round the pieces */
#define SAMPLES 4
#define ACROSS (TILE_WIDE * SAMPLES)              /* samples of a tile */
#define DOWN ((TILE_HIGH - NAME_HIGH) * SAMPLES)
#define CHORDS 12      /* of a curved piece of an edge: a hem of half a circle is off by less than a pixel */
#define GAP 0.04       /* [m] between pieces */
#define LINE 2         /* half the width of a line [samples] */
#define POINTS_MOST 4096
#define EDGES_MOST 1024

/* what a sample shows */
enum { PAPER, CLOTH, INK };
static const unsigned char tile_colours[3][3] = {{250, 249, 246}, {196, 207, 222}, {44, 56, 78}};

/* one piece as a polygon, and where its box lies on the tile [m] */
typedef struct flat {
    double (*at)[2]; /* (count) */
    int32_t count;
    double low[2], high[2], place[2];
} flat;


/* The rim of a piece, turned as on paper. Returns false when there is no memory or the pattern fails. */
static bool flat_make(const mus_pattern *pattern, const mus_sheet_piece *piece, flat *out)
{
    int32_t n, count, edges[EDGES_MOST], directions[EDGES_MOST];
    double xy[2 * POINTS_MOST];
    out->at = calloc(POINTS_MOST, sizeof *out->at);
    if (out->at == NULL || mus_pattern_rim(pattern, piece->panel, edges, directions, EDGES_MOST, &n) != MUS_OK ||
        n > EDGES_MOST)
        return false;
    for (int32_t d = 0; d < 2; d++) out->low[d] = 1e9, out->high[d] = -1e9;
    for (int32_t e = 0; e < n; e++) {
        if (mus_pattern_edge_polyline(pattern, edges[e], CHORDS, xy, POINTS_MOST, &count) != MUS_OK) return false;
        for (int32_t i = 0; i < count - 1 && i < POINTS_MOST && out->count < POINTS_MOST; i++) {
            const double *p = xy + 2 * (directions[e] > 0 ? i : count - 1 - i);
            double *to = out->at[out->count++];
            to[0] = piece->turn[0] * p[0] + piece->turn[1] * p[1];
            to[1] = piece->turn[2] * p[0] + piece->turn[3] * p[1];
            for (int32_t d = 0; d < 2; d++) {
                out->low[d] = fmin(out->low[d], to[d]);
                out->high[d] = fmax(out->high[d], to[d]);
            }
        }
    }
    return out->count > 2;
}


/* Lays the boxes in rows of at most `wide` [m]. Returns the width and height that they take. */
static void flats_row(flat *flats, int32_t n, double wide, double *size)
{
    double x = 0.0, row = 0.0;
    size[0] = size[1] = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double w = flats[i].high[0] - flats[i].low[0], h = flats[i].high[1] - flats[i].low[1];
        if (x > 0.0 && x + w > wide) x = 0.0, size[1] += row + GAP, row = 0.0;
        flats[i].place[0] = x, flats[i].place[1] = size[1];
        x += w + GAP;
        size[0] = fmax(size[0], x - GAP);
        row = fmax(row, h);
    }
    size[1] += row;
}


/* Lays the pieces in rows of the width that gives the largest scale. Returns it [samples/m]; *size [m]. */
static double flats_lay(flat *flats, int32_t n, double *size)
{
    const double across = ACROSS - 2 * MARGIN * SAMPLES, down = DOWN - 2 * MARGIN * SAMPLES;
    double best = 0.0, wide = 0.0;
    for (double w = 0.2; w < 6.0; w *= 1.1) {
        flats_row(flats, n, w, size);
        const double scale = fmin(across / size[0], down / size[1]);
        if (scale > best) best = scale, wide = w;
    }
    flats_row(flats, n, wide, size);
    return best;
}


/* ---- samples ---- */

static void sample_line(unsigned char *tile, const double *a, const double *b)
{
    const double length = fmax(fabs(b[0] - a[0]), fabs(b[1] - a[1]));
    const int32_t steps = (int32_t)length + 1;
    for (int32_t k = 0; k <= steps; k++) {
        const int32_t x = (int32_t)(a[0] + (b[0] - a[0]) * k / steps), y = (int32_t)(a[1] + (b[1] - a[1]) * k / steps);
        for (int32_t j = y - LINE; j <= y + LINE; j++)
            for (int32_t i = x - LINE; i <= x + LINE; i++)
                if (i >= 0 && i < ACROSS && j >= 0 && j < DOWN) tile[(size_t)j * ACROSS + (size_t)i] = INK;
    }
}


/* Fills a polygon by its even-odd rule: each row of samples is turned at each crossing with an edge. */
static void sample_fill(unsigned char *tile, const flat *f)
{
    for (int32_t y = 0; y < DOWN; y++) {
        bool turned[ACROSS + 1] = {false}, inside = false;
        for (int32_t i = 0; i < f->count; i++) {
            const double *a = f->at[i], *b = f->at[(i + 1) % f->count], level = y + 0.5;
            if ((a[1] <= level) == (b[1] <= level)) continue;
            const double x = a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            const int32_t from = x < 0.0 ? 0 : x > ACROSS ? ACROSS : (int32_t)x;
            turned[from] = !turned[from];
        }
        for (int32_t x = 0; x < ACROSS; x++) {
            inside ^= turned[x];
            if (inside) tile[(size_t)y * ACROSS + (size_t)x] = CLOTH;
        }
    }
}


static void tile_sample(flat *flats, int32_t n, unsigned char *tile)
{
    double size[2];
    const double scale = flats_lay(flats, n, size);
    for (int32_t p = 0; p < n; p++) {
        for (int32_t i = 0; i < flats[p].count; i++) {
            double *at = flats[p].at[i];
            at[0] = 0.5 * (ACROSS - scale * size[0]) + scale * (flats[p].place[0] + at[0] - flats[p].low[0]);
            at[1] = 0.5 * (DOWN - scale * size[1]) + scale * (flats[p].place[1] + flats[p].high[1] - at[1]);
        }
        sample_fill(tile, &flats[p]);
        for (int32_t i = 0; i < flats[p].count; i++)
            sample_line(tile, flats[p].at[i], flats[p].at[(i + 1) % flats[p].count]);
    }
}


/* Writes the mean of the samples of each pixel, and the name, to a tile of the picture. */
static void tile_write(const unsigned char *tile, const char *name, letters_page *page, int32_t x0, int32_t y0)
{
    for (int32_t y = 0; y < TILE_HIGH - NAME_HIGH; y++)
        for (int32_t x = 0; x < TILE_WIDE; x++) {
            int32_t sum[3] = {0, 0, 0};
            for (int32_t k = 0; k < SAMPLES * SAMPLES; k++) {
                const int32_t j = y * SAMPLES + k / SAMPLES, i = x * SAMPLES + k % SAMPLES;
                for (int32_t c = 0; c < 3; c++) sum[c] += tile_colours[tile[(size_t)j * ACROSS + (size_t)i]][c];
            }
            unsigned char *to = page->rgba + 4 * ((size_t)(y0 + y) * (size_t)page->width + (size_t)(x0 + x));
            for (int32_t c = 0; c < 3; c++) to[c] = (unsigned char)(sum[c] / (SAMPLES * SAMPLES));
        }
    const int32_t wide = (LETTER_WIDE + 1) * (int32_t)strlen(name);
    letters_say(page, x0 + (wide < TILE_WIDE ? (TILE_WIDE - wide) / 2 : 0), y0 + TILE_HIGH - NAME_HIGH + 4, name);
}


/* Drafts a design and samples its pieces. Returns an exit code. */
static int tile_make(const source *from, int32_t design, unsigned char *tile)
{
    scene s;
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    int32_t n = 0;
    const bool given = from->tape != NULL || from->size != NULL;
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_ROLL;
    int code = scene_open(&s, "designs");
    if (code == EXIT_DONE) code = design_draft(&s, design, given ? from : &(source){0});
    if (code == EXIT_DONE) {
        /* the garment, without facings and small parts */
        mus_status status = mus_pattern_set_cut_only(s.pattern, NULL);
        if (status == MUS_OK) status = mus_sheet_create(s.context, s.pattern, &def, &sheet);
        if (status != MUS_OK) code = scene_fail(&s, status);
    }
    const int32_t pieces = code == EXIT_DONE ? mus_sheet_piece_count(sheet) : 0;
    flat *flats = calloc((size_t)pieces + 1, sizeof *flats);
    for (; flats != NULL && n < pieces; n++) {
        mus_sheet_piece piece;
        mus_sheet_piece_init(&piece, sizeof piece);
        if (mus_sheet_piece_get(sheet, n, &piece) != MUS_OK || !flat_make(s.pattern, &piece, &flats[n])) break;
    }
    if (code == EXIT_DONE && n < pieces) code = complain(EXIT_FAILED, "designs", "no memory for a picture");
    memset(tile, PAPER, (size_t)ACROSS * DOWN);
    if (code == EXIT_DONE) tile_sample(flats, n, tile);
    for (int32_t i = 0; flats != NULL && i < pieces; i++) free(flats[i].at);
    free(flats);
    mus_sheet_destroy(sheet);
    scene_close(&s);
    return code;
}


int designs_draw(const int32_t *designs, int32_t count, const source *from, const char *path)
{
    const int32_t columns = (int32_t)ceil(sqrt(1.4 * count)), rows = (count + columns - 1) / columns;
    letters_page page = {columns * TILE_WIDE, rows * TILE_HIGH, 1, NULL};
    unsigned char *tile = malloc((size_t)ACROSS * DOWN);
    page.rgba = malloc((size_t)page.width * (size_t)page.height * 4);
    int code = EXIT_DONE;
    if (tile == NULL || page.rgba == NULL) code = complain(EXIT_FAILED, "designs", "no memory for a picture");
    for (size_t i = 0; code == EXIT_DONE && i < (size_t)page.width * (size_t)page.height; i++) {
        memcpy(page.rgba + 4 * i, tile_colours[PAPER], 3);
        page.rgba[4 * i + 3] = 255;
    }
    for (int32_t i = 0; i < count && code == EXIT_DONE; i++) {
        code = tile_make(from, designs[i], tile);
        if (code != EXIT_DONE) break;
        tile_write(tile, mus_design_name(designs[i]), &page, i % columns * TILE_WIDE, i / columns * TILE_HIGH);
    }
    render_error error;
    if (code == EXIT_DONE && render_png_write(path, page.width, page.height, page.rgba, &error) != 0)
        code = complain(EXIT_FAILED, "designs", "%s", error.text);
    free(tile);
    free(page.rgba);
    return code;
}
