/*
 * thread.c: the map of a cloth's seams and stitches, from lines in the planes of its panels.
 *
 * The panels lie side by side in one texture, TEXEL apart. A texel holds how near it is to the nearest line of each
 * kind: 255 on the line, 0 at RENDER_THREAD_RANGE and beyond. Distances are smooth, so lines are as sharp as the screen
 * at any zoom, whatever the mesh (Green, Improved Alpha-Tested Magnification for Vector Textures, 2007).
 *
 *     channel 0  seams          1  stitches          2  free edges          3  place along the stitches, 0..255..0
 */
#include "render_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TEXEL 0.001                  /* [m] side of a texel; chosen: finer than a stitch line is wide */
#define TEXELS_MOST 3e7              /* of a map: 120 MB, 240 more while it is made; a larger cloth has larger texels */
#define SIDE_MOST 8192               /* of a texture, in texels: what OpenGL 3.3 devices have room for */
#define APART 4                      /* texels between panels, so that none shows at the rim of another */
#define STITCH 0.004                 /* [m] from stitch to stitch: 2.5 to the centimetre, as topstitches are */
#define RANGE RENDER_THREAD_RANGE
#define FAR 1e9f                     /* [m] not measured */

/* where a panel lies in the map */
typedef struct thread_island {
    double low[2], high[2]; /* of its vertices, in its plane [m] */
    int32_t at[2];          /* of its low corner [texels] */
} thread_island;

typedef struct thread_map {
    int32_t islands;
    thread_island *island;
    double texel;
    int32_t side[2];
    unsigned char *rgba;
    float *away;  /* (texels) of the line that is drawn: distance from its points, negative beyond its ends [m] */
    float *along; /* (texels) and length of the line up to there [m] */
} thread_map;


/* the boxes of the panels from the places of their vertices; -1 without memory */
static int thread_boxes(thread_map *map, const render_mesh *m)
{
    for (int32_t i = 0; i < m->vertex_count; i++)
        if (m->panels[i] >= map->islands) map->islands = m->panels[i] + 1;
    map->island = calloc((size_t)map->islands + 1, sizeof *map->island);
    if (!map->island) return -1;
    for (int32_t i = 0; i < map->islands; i++)
        for (int k = 0; k < 2; k++) map->island[i].low[k] = 1e30, map->island[i].high[k] = -1e30;
    for (int32_t i = 0; i < m->vertex_count; i++)
        for (int k = 0; k < 2 && m->panels[i] >= 0; k++) {
            thread_island *island = &map->island[m->panels[i]];
            island->low[k] = fmin(island->low[k], m->texcoords[2 * i + k]);
            island->high[k] = fmax(island->high[k], m->texcoords[2 * i + k]);
        }
    return 0;
}


/* puts the panels in rows, in their order; false when they take more than the texture has */
static int thread_pack(thread_map *map)
{
    double area = 0.0, widest = 0.0;
    for (int32_t i = 0; i < map->islands; i++) {
        const thread_island *a = &map->island[i];
        if (a->high[0] < a->low[0]) continue;
        area += (a->high[0] - a->low[0]) * (a->high[1] - a->low[1]);
        widest = fmax(widest, a->high[0] - a->low[0]);
    }
    const int32_t width = (int32_t)ceil(fmax(1.2 * sqrt(area), widest) / map->texel) + 2 * APART;
    int32_t x = APART, y = APART, row = 0;
    for (int32_t i = 0; i < map->islands; i++) {
        thread_island *a = &map->island[i];
        if (a->high[0] < a->low[0]) continue;
        const int32_t w = (int32_t)ceil((a->high[0] - a->low[0]) / map->texel) + APART;
        const int32_t h = (int32_t)ceil((a->high[1] - a->low[1]) / map->texel) + APART;
        if (x + w > width) x = APART, y += row, row = 0;
        a->at[0] = x, a->at[1] = y;
        x += w;
        row = h > row ? h : row;
    }
    map->side[0] = width, map->side[1] = y + row + APART;
    return map->side[0] <= SIDE_MOST && map->side[1] <= SIDE_MOST &&
           (double)map->side[0] * map->side[1] <= TEXELS_MOST;
}


/* one chord of a line */
typedef struct thread_chord {
    double from[2], to[2];
    double before;       /* length of the line before the chord [m] */
    int32_t first, last; /* nonzero: the line ends there */
} thread_chord;


/* the texels of a panel within `reach` of a chord: low and high corner */
static void thread_reach(const thread_map *map, const thread_island *island, const thread_chord *c, double reach,
                         int32_t *low, int32_t *high)
{
    for (int k = 0; k < 2; k++) {
        const double most = (island->high[k] - island->low[k]) / map->texel + 1.0;
        const double a = (fmin(c->from[k], c->to[k]) - reach - island->low[k]) / map->texel;
        const double b = (fmax(c->from[k], c->to[k]) + reach - island->low[k]) / map->texel;
        low[k] = (int32_t)fmin(fmax(floor(a), -1.0), most), high[k] = (int32_t)fmax(fmin(ceil(b), most), -1.0);
    }
}


/* the distances of texels from the line, as far as this chord is the nearest; negative beyond its ends */
static void thread_chord_measure(thread_map *map, const thread_island *island, const thread_chord *c, double reach)
{
    const double d[2] = {c->to[0] - c->from[0], c->to[1] - c->from[1]}, length = hypot(d[0], d[1]);
    int32_t low[2], high[2];
    thread_reach(map, island, c, reach, low, high);
    for (int32_t y = low[1]; y <= high[1] && length > 0.0; y++)
        for (int32_t x = low[0]; x <= high[0]; x++) {
            const double p[2] = {island->low[0] + x * map->texel - c->from[0],
                                 island->low[1] + y * map->texel - c->from[1]};
            const double foot = (p[0] * d[0] + p[1] * d[1]) / (length * length), t = fmin(fmax(foot, 0.0), 1.0);
            const float away = (float)hypot(p[0] - t * d[0], p[1] - t * d[1]);
            const size_t at = (size_t)(island->at[1] + y) * (size_t)map->side[0] + (size_t)(island->at[0] + x);
            if (away >= fabsf(map->away[at])) continue;
            const int beyond = (c->first && foot < 0.0) || (c->last && foot > 1.0);
            map->away[at] = beyond ? -away : away;
            map->along[at] = (float)(c->before + t * length);
        }
}


/* draws what has been measured near a chord, and forgets it */
static void thread_chord_draw(thread_map *map, const thread_island *island, const thread_chord *c,
                              const render_line *line)
{
    int32_t low[2], high[2];
    thread_reach(map, island, c, line->offset + RANGE, low, high);
    for (int32_t y = low[1]; y <= high[1]; y++)
        for (int32_t x = low[0]; x <= high[0]; x++) {
            const size_t at = (size_t)(island->at[1] + y) * (size_t)map->side[0] + (size_t)(island->at[0] + x);
            const float away = map->away[at];
            const double distance = fabs(fabsf(away) - line->offset);
            map->away[at] = FAR;
            if (away == FAR || distance >= RANGE || (away < 0.0f && line->offset > 0.0)) continue;
            const unsigned char near = (unsigned char)(255.0 * (1.0 - distance / RANGE) + 0.5);
            unsigned char *rgba = map->rgba + 4 * at;
            if (line->kind == RENDER_LINE_STITCH && near > rgba[line->kind])
                rgba[3] = (unsigned char)(255.0 * fabs(2.0 * fmod(map->along[at], STITCH) / STITCH - 1.0));
            if (near > rgba[line->kind]) rgba[line->kind] = near;
        }
}


static void thread_line_draw(thread_map *map, const render_line *line)
{
    const double *xy = line->points;
    const int closed = line->count > 2 && xy[0] == xy[2 * line->count - 2] && xy[1] == xy[2 * line->count - 1];
    if (line->panel < 0 || line->panel >= map->islands) return;
    const thread_island *island = &map->island[line->panel];
    for (int pass = 0; pass < 2; pass++) {
        thread_chord c = {.before = 0.0};
        for (int32_t i = 0; i + 1 < line->count; i++) {
            memcpy(c.from, xy + 2 * i, sizeof c.from);
            memcpy(c.to, xy + 2 * i + 2, sizeof c.to);
            c.first = i == 0 && !closed, c.last = i + 2 == line->count && !closed;
            if (pass == 0) thread_chord_measure(map, island, &c, line->offset + RANGE);
            else thread_chord_draw(map, island, &c, line);
            c.before += hypot(c.to[0] - c.from[0], c.to[1] - c.from[1]);
        }
    }
}


/* where each vertex lies in the map, 0..1 */
static void thread_places(const thread_map *map, const render_mesh *m, render_part *part)
{
    for (int32_t i = 0; i < m->vertex_count; i++)
        for (int k = 0; k < 2 && m->panels[i] >= 0; k++) {
            const thread_island *a = &map->island[m->panels[i]];
            const double at = a->at[k] + 0.5 + (m->texcoords[2 * i + k] - a->low[k]) / map->texel;
            part->v[i].thread[k] = (float)(at / map->side[k]);
        }
}


static void thread_upload(render *r, const thread_map *map, render_part *part)
{
    const render_gl *gl = &r->gl;
    gl->GenTextures(1, &part->thread);
    gl->BindTexture(GL_TEXTURE_2D, part->thread);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, map->side[0], map->side[1], 0, GL_RGBA, GL_UNSIGNED_BYTE, map->rgba);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}


int render_thread_make(render *r, const render_mesh *m, render_part *part, render_error *error)
{
    thread_map map = {.texel = TEXEL};
    int rc = -1;
    if (thread_boxes(&map, m)) goto done;
    for (int32_t i = 0; i < map.islands; i++)
        for (int k = 0; k < 2; k++)
            map.texel = fmax(map.texel, (map.island[i].high[k] - map.island[i].low[k]) / SIDE_MOST);
    while (!thread_pack(&map)) map.texel *= 1.25;
    const size_t texels = (size_t)map.side[0] * (size_t)map.side[1];
    map.rgba = calloc(texels, 4);
    map.away = malloc(texels * sizeof *map.away);
    map.along = malloc(texels * sizeof *map.along);
    if (!map.rgba || !map.away || !map.along) goto done;
    for (size_t i = 0; i < texels; i++) map.away[i] = FAR;
    for (int32_t i = 0; i < m->line_count; i++) thread_line_draw(&map, &m->lines[i]);
    thread_places(&map, m, part);
    thread_upload(r, &map, part);
    part->texel = (float)map.texel;
    rc = 0;
done:
    free(map.island);
    free(map.rgba);
    free(map.away);
    free(map.along);
    return rc ? render_fail(error, "no picture: out of memory for the seams") : 0;
}
