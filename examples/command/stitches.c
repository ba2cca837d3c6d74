/*
 * stitches.c: what sewing leaves to see on a garment, from its pattern.
 *
 * Each edge of an outline is drawn by what it is. A seam is a groove; a zip has a row of stitches on both sides; a
 * front with buttons shows the edge of its lap and, on the other side, its facing's stitches. A free edge is folded
 * and stitched: a hem at the depth of its allowance, a narrow edge close to it. Neighbours of one look are one line.
 * Marks of pockets, welts, flaps and slits are drawn as a seam with stitches. A mark "button" or "buttonhole" becomes
 * a button on the cloth; one on an underlap, which is not draped, is hidden.
 */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "stitches.h"

#define CHORDS 24            /* of a curved edge; chosen: a quarter circle of 30 cm radius is followed within 0.2 mm */
#define LINES_AN_EDGE 3      /* most lines that an edge gives */
#define ALLOWANCE 0.010      /* [m] of an edge without one of its own: that of a sheet */
#define HEM_LEAST 0.015      /* [m] an edge with a wider allowance is a hem, turned up and stitched at that depth */
#define HEM_MOST 0.050       /* [m] a deeper hem is sewn by hand and does not show */
#define HEM_FOLD 0.002       /* [m] from the stitches of a hem to the end of its allowance */
#define EDGE_STITCH 0.006    /* [m] from a narrow finished edge to its stitches: the foot of a sewing machine */
#define ZIP_STITCH 0.007     /* [m] from the middle of a zip to the stitches on its tape */
#define STAND 0.0175         /* [m] half the width of a button stand, as the designs draft it */
#define BUTTON 0.0057        /* [m] radius of a button: size 18, that of shirts (ISO 3635 gives 11.4 mm) */
#define BUTTON_APART (2.0 * BUTTON) /* nearer ones would overlap: both fronts, both ends of a stand mark the same one */
#define BUTTON_OFF 0.003     /* [m] a mark farther off the cloth is on an underlap; chosen: above a curved edge's sag */
#define RAYS 20              /* corners of a button's rims */
#define RINGS 5
#define TURN 6.28318530717958647693 /* [rad] */

/* a button from its middle to its foot: radius over BUTTON, height over the cloth [m] */
static const double button_rings[RINGS][2] = {{0.60, 0.0016}, {0.72, 0.0024}, {0.92, 0.0023}, {1.0, 0.0014},
                                              {1.0, 0.0}};


static void line_add(stitches *s, int32_t panel, int32_t kind, double offset, int32_t first)
{
    render_line *line = &s->lines[s->count++];
    line->panel = panel, line->kind = kind, line->offset = offset;
    line->count = s->point_count - first;
    line->points = s->points + 2 * (ptrdiff_t)first;
}


/* how an edge is to be drawn: up to LINES_AN_EDGE kinds with their offsets */
typedef struct edge_look {
    int32_t count;
    int32_t kind[LINES_AN_EDGE];
    double offset[LINES_AN_EDGE];
} edge_look;


static void look_add(edge_look *look, int32_t kind, double offset)
{
    look->kind[look->count] = kind, look->offset[look->count++] = offset;
}


/* a front that buttons: the left laps over the right, as the designs draft a fly, so the lap ends on the right panel */
static void look_buttons(const mus_pattern *pattern, int32_t panel, edge_look *look)
{
    const int32_t sides = mus_pattern_panel_sides(pattern, panel, NULL);
    if (sides & MUS_SIDE_RIGHT) look_add(look, RENDER_LINE_SEAM, STAND);
    else if (sides & MUS_SIDE_LEFT) look_add(look, RENDER_LINE_STITCH, STAND);
    else look_add(look, RENDER_LINE_SEAM, 0.0);
}


static void look_free(const mus_pattern *pattern, int32_t edge, edge_look *look)
{
    double allowance = mus_pattern_edge_allowance(pattern, edge);
    if (isnan(allowance)) allowance = ALLOWANCE;
    look_add(look, RENDER_LINE_EDGE, 0.0);
    if (allowance >= HEM_LEAST && allowance <= HEM_MOST) look_add(look, RENDER_LINE_STITCH, allowance - HEM_FOLD);
    if (allowance > 0.0 && allowance < HEM_LEAST) look_add(look, RENDER_LINE_STITCH, EDGE_STITCH);
}


static edge_look look_of(const mus_pattern *pattern, int32_t panel, int32_t edge)
{
    edge_look look = {0};
    const int32_t seam = mus_pattern_edge_seam(pattern, edge);
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    if (seam == MUS_NONE) {
        look_free(pattern, edge, &look);
    } else if (mus_pattern_seam(pattern, seam, &def) == MUS_OK && !def.laid) {
        if (def.closure == MUS_CLOSURE_BUTTONS && !def.open) look_buttons(pattern, panel, &look);
        else look_add(&look, RENDER_LINE_SEAM, 0.0);
        if (def.closure == MUS_CLOSURE_ZIP) look_add(&look, RENDER_LINE_STITCH, ZIP_STITCH);
    }
    return look;
}


static bool look_equal(const edge_look *a, const edge_look *b)
{
    bool equal = a->count == b->count;
    for (int32_t i = 0; i < a->count && equal; i++) equal = a->kind[i] == b->kind[i] && a->offset[i] == b->offset[i];
    return equal;
}


/* appends the points of an edge in the direction of the outline; a line that goes on has its first point already */
static void edge_points(stitches *s, const mus_pattern *pattern, int32_t edge, int32_t direction, int32_t first)
{
    double *to = s->points + 2 * (ptrdiff_t)s->point_count;
    int32_t n = 0;
    if (mus_pattern_edge_polyline(pattern, edge, CHORDS, NULL, 0, &n) != MUS_OK ||
        mus_pattern_edge_polyline(pattern, edge, CHORDS, to, n, &n) != MUS_OK)
        return;
    for (int32_t i = 0; direction < 0 && i < n / 2; i++)
        for (int k = 0; k < 2; k++) {
            const double swapped = to[2 * i + k];
            to[2 * i + k] = to[2 * (n - 1 - i) + k];
            to[2 * (n - 1 - i) + k] = swapped;
        }
    if (s->point_count > first) memmove(to, to + 2, (size_t)(2 * (n - 1)) * sizeof *to), n--;
    s->point_count += n;
}


/* whether the outline passes the edge both ways: a bridge to a line inside the panel */
static bool passed_twice(int32_t n, const int32_t *edges, int32_t edge)
{
    int32_t times = 0;
    for (int32_t i = 0; i < n; i++) times += edges[i] == edge;
    return times > 1;
}


static void panel_lines(stitches *s, const mus_pattern *pattern, int32_t panel)
{
    const int32_t *edges = NULL, *directions = NULL;
    int32_t n = 0, from = 0;
    if (mus_pattern_outline(pattern, panel, &n, &edges, &directions) != MUS_OK || n == 0) return;
    edge_look now = look_of(pattern, panel, edges[0]);
    for (int32_t i = n - 1; i > 0 && from == 0; i--) { /* begin where the look changes */
        const edge_look before = look_of(pattern, panel, edges[i]);
        if (!look_equal(&before, &now)) from = (i + 1) % n;
        if (from == 0 && !look_equal(&before, &now)) break;
    }
    int32_t first = s->point_count;
    now = look_of(pattern, panel, edges[from]);
    for (int32_t i = 0; i < n; i++) {
        const int32_t edge = edges[(from + i) % n];
        const edge_look next = look_of(pattern, panel, edges[(from + i + 1) % n]);
        const bool bridge = passed_twice(n, edges, edge) && mus_pattern_edge_seam(pattern, edge) == MUS_NONE;
        if (!bridge) edge_points(s, pattern, edge, directions[(from + i) % n], first);
        if (i + 1 < n && !bridge && look_equal(&now, &next)) continue;
        for (int32_t k = 0; k < now.count && s->point_count - first >= 2; k++)
            line_add(s, panel, now.kind[k], now.offset[k], first);
        first = s->point_count;
        now = next;
    }
}


/* marks of what is seen from outside */
static const char *const seen_marks[] = {"pocket", "pocket opening", "kangaroo pocket", "welt", "flap", "slit"};


static void patch_lines(stitches *s, const mus_pattern *pattern, int32_t mark)
{
    int32_t panel = MUS_NONE, n = 0;
    const char *name = NULL;
    const double *xy = NULL;
    if (mus_pattern_mark(pattern, mark, &panel, &name, &n, &xy) != MUS_OK || n < 2) return;
    bool seen = false;
    for (size_t k = 0; k < sizeof seen_marks / sizeof seen_marks[0] && !seen; k++)
        seen = strcmp(name, seen_marks[k]) == 0;
    if (!seen) return;
    const int32_t first = s->point_count;
    memcpy(s->points + 2 * (ptrdiff_t)first, xy, (size_t)(2 * n) * sizeof *xy);
    s->point_count += n;
    line_add(s, panel, RENDER_LINE_SEAM, 0.0, first);
    line_add(s, panel, RENDER_LINE_STITCH, 0.0, first);
}


/* ---- buttons ---- */

/* place and normal of the cloth at a point of a panel; false where the point lies off the cloth */
static bool cloth_at(const mus_cloth *cloth, const double *x, const double *normals, int32_t panel, const double *xy,
                     double *place, double *normal)
{
    int32_t range[4] = {0};
    double best = -1e30, share[3] = {1.0, 0.0, 0.0};
    const double *rest = mus_cloth_rest(cloth);
    const int32_t *triangles = mus_cloth_triangles(cloth), *found = NULL;
    if (mus_cloth_panel_range(cloth, panel, range) != MUS_OK) return false;
    for (int32_t t = range[2]; t < range[2] + range[3]; t++) {
        const int32_t *c = triangles + 3 * (ptrdiff_t)t;
        const double *a = rest + 2 * (ptrdiff_t)c[0], *b = rest + 2 * (ptrdiff_t)c[1], *d = rest + 2 * (ptrdiff_t)c[2];
        const double area = (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]);
        double w[3];
        w[1] = ((xy[0] - a[0]) * (d[1] - a[1]) - (xy[1] - a[1]) * (d[0] - a[0])) / area;
        w[2] = ((b[0] - a[0]) * (xy[1] - a[1]) - (b[1] - a[1]) * (xy[0] - a[0])) / area;
        w[0] = 1.0 - w[1] - w[2];
        const double inside = fmin(w[0], fmin(w[1], w[2]));
        if (!(inside > best)) continue;
        best = inside, found = c;
        memcpy(share, w, sizeof share);
    }
    for (int k = 0; k < 3 && found != NULL; k++) {
        place[k] = normal[k] = 0.0;
        for (int i = 0; i < 3; i++) {
            place[k] += share[i] * x[3 * (ptrdiff_t)found[i] + k];
            normal[k] += share[i] * normals[3 * (ptrdiff_t)found[i] + k];
        }
    }
    return best * mus_cloth_spacing(cloth) > -BUTTON_OFF;
}


/* the vertices of a button, and its triangles: a middle, and rings of quads */
static void button_add(stitches *s, const double *place, const double *normal)
{
    render_mesh *m = &s->buttons;
    const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double n[3] = {normal[0] / length, normal[1] / length, normal[2] / length};
    const double flat = hypot(n[0], n[2]);
    const double u[3] = {flat > 0.0 ? n[2] / flat : 1.0, 0.0, flat > 0.0 ? -n[0] / flat : 0.0};
    const double v[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
    const int32_t base = m->vertex_count;
    double *to = s->button_places + 3 * (ptrdiff_t)base;
    if (!(length > 0.0)) return;
    for (int k = 0; k < 3; k++) *to++ = place[k] + button_rings[0][1] * n[k];
    for (int32_t r = 0; r < RINGS; r++)
        for (int32_t i = 0; i < RAYS; i++) {
            const double angle = TURN * i / RAYS, radius = BUTTON * button_rings[r][0];
            for (int k = 0; k < 3; k++)
                *to++ = place[k] + button_rings[r][1] * n[k] + radius * (cos(angle) * u[k] + sin(angle) * v[k]);
        }
    int32_t *corner = s->button_triangles + 3 * (ptrdiff_t)m->triangle_count;
    for (int32_t r = -1; r + 1 < RINGS; r++)
        for (int32_t i = 0; i < RAYS; i++) {
            const int32_t j = (i + 1) % RAYS, a = base + 1 + r * RAYS, b = base + 1 + (r + 1) * RAYS;
            const int32_t middle[3] = {base, b + i, b + j}, quad[6] = {a + i, b + i, b + j, a + i, b + j, a + j};
            memcpy(corner, r < 0 ? middle : quad, r < 0 ? sizeof middle : sizeof quad);
            corner += r < 0 ? 3 : 6;
        }
    m->vertex_count += 1 + RINGS * RAYS;
    m->triangle_count += RAYS * (2 * RINGS - 1);
}


static void buttons_make(stitches *s, const mus_pattern *pattern, const mus_cloth *cloth, const double *x,
                         const double *normals)
{
    static const double colour[3] = {0.72, 0.69, 0.62}; /* mother of pearl */
    const int32_t marks = mus_pattern_mark_count(pattern), each = 1 + RINGS * RAYS;
    for (int32_t i = 0; i < marks; i++) {
        int32_t panel = MUS_NONE, n = 0;
        const char *name = NULL;
        const double *xy = NULL;
        double place[3] = {0}, normal[3] = {0};
        if (mus_pattern_mark(pattern, i, &panel, &name, &n, &xy) != MUS_OK || n != 1) continue;
        if (strcmp(name, "button") != 0 && strcmp(name, "buttonhole") != 0) continue;
        if (!cloth_at(cloth, x, normals, panel, xy, place, normal)) continue;
        bool there = false;
        for (int32_t b = 0; b < s->buttons.vertex_count && !there; b += each) {
            const double *other = s->button_places + 3 * (ptrdiff_t)b;
            there = hypot(hypot(other[0] - place[0], other[1] - place[1]), other[2] - place[2]) < BUTTON_APART;
        }
        if (!there) button_add(s, place, normal);
    }
    s->buttons.kind = RENDER_TRIM;
    s->buttons.positions = s->button_places, s->buttons.triangles = s->button_triangles;
    memcpy(s->buttons.colour, colour, sizeof colour);
}


bool stitches_make(const mus_pattern *pattern, const mus_cloth *cloth, const double *positions, const double *normals,
                   stitches *out)
{
    memset(out, 0, sizeof *out);
    const int32_t panels = mus_pattern_panel_count(pattern), marks = mus_pattern_mark_count(pattern);
    if (panels == 0 || panels != mus_cloth_panel_count(cloth)) return true;
    size_t points = 0, lines = 0;
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
        int32_t n = 0;
        if (mus_pattern_edge_polyline(pattern, e, CHORDS, NULL, 0, &n) == MUS_OK) points += 2 * (size_t)n;
        lines += 2 * LINES_AN_EDGE;
    }
    for (int32_t i = 0; i < marks; i++) {
        int32_t n = 0;
        if (mus_pattern_mark(pattern, i, NULL, NULL, &n, NULL) == MUS_OK) points += (size_t)n;
        lines += 2;
    }
    out->lines = malloc(lines * sizeof *out->lines + 1);
    out->points = malloc(2 * points * sizeof *out->points + 1);
    out->button_places = malloc((size_t)(marks * 3 * (1 + RINGS * RAYS)) * sizeof(double) + 1);
    out->button_triangles = malloc((size_t)(marks * 3 * RAYS * (2 * RINGS - 1)) * sizeof(int32_t) + 1);
    if (!out->lines || !out->points || !out->button_places || !out->button_triangles) return false;
    for (int32_t p = 0; p < panels; p++) panel_lines(out, pattern, p);
    for (int32_t i = 0; i < marks; i++) patch_lines(out, pattern, i);
    buttons_make(out, pattern, cloth, positions, normals);
    return true;
}


void stitches_free(stitches *s)
{
    free(s->lines);
    free(s->points);
    free(s->button_places);
    free(s->button_triangles);
    memset(s, 0, sizeof *s);
}
