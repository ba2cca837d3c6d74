/*
 * fitmap.c: the fit of a garment as colours with a legend, and as members of the report.
 *
 * Strain is the greater one of warp and weft, from blue (compressed) over green to red (stretched). Pressure goes from
 * green to red. Ease, the distance to the body, goes from red (0) over green to blue. The legend is written by
 * letters.h.
 */
#include "fitmap.h"

#include "letters.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STOPS 5

/* colours of the scale, linear RGB: blue, cyan, green, yellow, red */
static const double stop[STOPS][3] = {
    {0.03, 0.08, 0.55}, {0.05, 0.45, 0.55}, {0.10, 0.45, 0.10}, {0.80, 0.60, 0.03}, {0.65, 0.03, 0.02}};

/* the maps: their part of the colour scale (0 to 1), and the values at its ends */
static const struct {
    const char *name, *title;
    double low, high, from, to, unit;
    int32_t quantity;
} maps[] = {{"strain", "strain %", -10.0, 10.0, 0.0, 1.0, 100.0, MUS_FIT_STRAIN},
            {"pressure", "pressure kPa", 0.0, 3.0, 0.5, 1.0, 0.001, MUS_FIT_PRESSURE},
            {"ease", "ease cm", 0.0, 6.0, 1.0, 0.0, 100.0, MUS_FIT_GAP}};


/* Returns the map of that name, or -1. */
static int32_t find_map(const char *name)
{
    for (int32_t i = 0; i < (int32_t)(sizeof maps / sizeof *maps); i++)
        if (strcmp(maps[i].name, name) == 0) return i;
    return -1;
}


int fit_map_check(const scene *s, const char *name)
{
    if (name == NULL || find_map(name) >= 0) return EXIT_DONE;
    return complain(EXIT_INPUT, s->command, "--map %s: expected strain, pressure or ease", name);
}


/* Writes the colour at t (0 to 1) of the scale, linear RGB. */
static void ramp(double t, double *out)
{
    const double at = (t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t) * (STOPS - 1);
    const int32_t k = at < STOPS - 1 ? (int32_t)at : STOPS - 2;
    for (int32_t d = 0; d < 3; d++) out[d] = stop[k][d] + (at - k) * (stop[k + 1][d] - stop[k][d]);
}


/* Returns the value of a map at a node: strain [1], pressure [Pa] or ease [m]. */
static double value_of(int32_t map, const mus_fit *fit, int32_t i)
{
    const double warp = mus_fit_warp(fit)[i], weft = mus_fit_weft(fit)[i], gap = mus_fit_gap(fit)[i];
    if (map == 0) return fmax(warp, weft);
    if (map == 1) return mus_fit_pressure(fit)[i];
    return isnan(gap) ? maps[2].high : gap;
}


int fit_map_make(const scene *s, const char *name, const mus_fit *fit, fit_map *out)
{
    const int32_t map = find_map(name), n = mus_fit_node_count(fit);
    memset(out, 0, sizeof *out);
    out->colours = malloc((size_t)n * 3 * sizeof *out->colours + 1);
    if (out->colours == NULL) return complain(EXIT_FAILED, s->command, "no memory for the map");
    snprintf(out->title, sizeof out->title, "%s", maps[map].title);
    out->which = map;
    out->low = maps[map].low, out->high = maps[map].high;
    mus_fit_spread spread;
    mus_fit_spread_init(&spread, sizeof spread);
    if (mus_fit_spread_get(fit, maps[map].quantity, &spread) != MUS_OK)
        return complain(EXIT_FAILED, s->command, "%s", mus_context_error(s->context));
    out->part[0] = maps[map].unit * spread.p50;
    out->part[1] = maps[map].unit * spread.p95;
    out->part[2] = maps[map].unit * spread.p99;
    for (int32_t i = 0; i < n; i++) {
        const double part = (maps[map].unit * value_of(map, fit, i) - out->low) / (out->high - out->low);
        const double t = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
        ramp(maps[map].from + t * (maps[map].to - maps[map].from), out->colours + 3 * (size_t)i);
    }
    return EXIT_DONE;
}


void fit_map_free(fit_map *map)
{
    free(map->colours);
    memset(map, 0, sizeof *map);
}


/* ---- the legend ---- */

/* Converts a linear value (0 to 1) to 8 bits of sRGB. */
static unsigned char eight(double linear)
{
    const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
    return (unsigned char)(255.0 * c + 0.5);
}


void fit_map_legend(const fit_map *map, int32_t width, int32_t height, unsigned char *rgba)
{
    const letters_page p = {width, height, height / 400 > 0 ? height / 400 : 1, rgba};
    const int32_t letter = (LETTER_WIDE + 1) * p.dot, line = (LETTER_HIGH + 3) * p.dot, bar = 12 * p.dot;
    const int32_t high = height / 4, wide = letter * (int32_t)strlen(map->title);
    const int32_t x = width - wide - 4 * p.dot, y = 3 * line;

    /* title, colour bar from the top down, five numbers */
    letters_say(&p, x, y - 2 * line, map->title);
    for (int32_t j = 0; j < high; j++) {
        double linear[3];
        ramp(maps[map->which].from + (1.0 - (double)j / high) * (maps[map->which].to - maps[map->which].from), linear);
        const unsigned char colour[3] = {eight(linear[0]), eight(linear[1]), eight(linear[2])};
        letters_fill(&p, x, y + j, bar, 1, colour);
    }
    for (int32_t k = 0; k <= 4; k++) {
        char number[16];
        const double value = map->high + 0.25 * k * (map->low - map->high);
        snprintf(number, sizeof number, fabs(value - floor(value + 0.5)) < 0.005 ? "%.0f" : "%.1f", value + 0.0);
        letters_say(&p, x + bar + 2 * p.dot, y + k * high / 4 - LETTER_HIGH * p.dot / 2, number);
    }
    static const int32_t percent[] = {50, 95, 99};
    for (int32_t k = 0; k < 3; k++) {
        char row[24];
        snprintf(row, sizeof row, map->part[k] < 9.95 ? "p%d %.2f" : "p%d %.1f", (int)percent[k],
                 map->part[k] + 0.0);
        letters_say(&p, x, height - (5 - k) * line, row);
    }
}


/* ---- the report ---- */

/* Writes the percentiles by area of a quantity, and the extremes of single nodes. */
static void write_spread(json *j, const char *key, const mus_fit *fit, int32_t quantity)
{
    mus_fit_spread spread;
    mus_fit_spread_init(&spread, sizeof spread);
    if (mus_fit_spread_get(fit, quantity, &spread) != MUS_OK) return;
    json_open(j, key, '{');
    json_number(j, "p50", spread.p50);
    json_number(j, "p95", spread.p95);
    json_number(j, "p99", spread.p99);
    json_number(j, "mean", spread.mean);
    json_number(j, "least", spread.least);
    json_number(j, "most", spread.largest);
    json_close(j, '}');
}


void fit_write(const mus_fit *fit, json *j)
{
    json_open(j, "fit", '{');
    json_open(j, "levels", '[');
    for (int32_t k = 0; k < mus_fit_level_count(fit); k++) {
        mus_fit_level level;
        mus_fit_level_init(&level, sizeof level);
        if (mus_fit_level_get(fit, k, &level) != MUS_OK) continue;
        json_open(j, NULL, '{');
        json_text(j, "level", mus_hold_name(level.level));
        if (level.right != MUS_NONE) json_text(j, "side", level.right ? "right" : "left");
        json_number(j, "body_m", level.body);
        json_number(j, "garment_m", level.garment);
        json_number(j, "worn_m", level.worn);
        json_number(j, "ease_m", level.ease);
        json_number(j, "gap_m", level.gap);
        json_close(j, '}');
    }
    json_close(j, ']');
    write_spread(j, "strain_warp", fit, MUS_FIT_WARP);
    write_spread(j, "strain_weft", fit, MUS_FIT_WEFT);
    write_spread(j, "pressure_Pa", fit, MUS_FIT_PRESSURE);
    write_spread(j, "gap_m", fit, MUS_FIT_GAP);
    json_close(j, '}');
    write_spread(j, "strain", fit, MUS_FIT_STRAIN);
    write_spread(j, "pressure_pa", fit, MUS_FIT_PRESSURE);
}
