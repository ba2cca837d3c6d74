/*
 * cut_only_facing.c: facings and the fly, traced from the edges of the panels that they are sewn to.
 *
 *        A ~~~ neck ~~~ B       A facing has the edges of a run (A to B) as they are, the edges before and after the
 *       /               \       run as far as its width (to A' and E), and the line at that distance from the run
 *      A' ------------- E       between them, in parts where it has corners. Darts in the run are closed: the part
 *                               behind each is turned about the dart's point until its legs lie on each other.
 *
 * The line at a distance is made of points beside the middles of short chords of the run, with an arc at each corner
 * that spreads. Points that are nearer to the run than the width, or outside the lines A'A and BE, are left out. A
 * facing that crosses itself is tried narrower.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "pattern/pattern_internal.h"
#include "finish/cut_only.h"

#define FACING_POINTS 512 /* most chords of a run, and points of its parallel; chosen: chords of 3 mm on 1.5 m */
#define FACING_EDGES 64   /* most edges of a panel that is faced; chosen: twice those of the richest draft */
#define FACING_CORNER 0.15 /* [rad] between two chords: a larger turn is a corner that gets an arc; chosen */
#define FACING_SLACK 5e-4  /* [m] least distance of the parallel from the ends of a facing; chosen: above rounding */
#define FACING_NEAR 2e-5   /* [m] a point of the parallel may be nearer to the run by; the error of its chords */
#define FACING_BEND 0.86602540378443865 /* cosine of 30 degrees: a larger turn of the parallel is a corner (AAMA) */
#define FACING_MOST 0.95   /* share of the edge beside a run that a facing takes at most; chosen: an edge is left */
#define FACING_HALVINGS 30 /* of a quarter of the width: below a nanometre */
#define FACING_TRIES 3     /* widths that are tried, each 0.7 of the one before; chosen */

/* the rim of a panel and the run of it that is faced */
typedef struct facing {
    const mus_pattern *pattern;
    mus_pattern *made;
    int32_t panel, made_panel;
    int32_t n, edge[FACING_EDGES], direction[FACING_EDGES]; /* the rim */
    bool on[FACING_EDGES];                                  /* has the label of the run */
    int32_t first, last;                                    /* of the run, in the rim */
    double turn[6];               /* motion of the part under work: x' = t0 x + t1 y + t4, y' = t2 x + t3 y + t5 */
    int32_t nrun, naside;
    double run[FACING_POINTS + 1][2], aside[FACING_POINTS][2]; /* chords of the run; its parallel [m] */
    int32_t word[FACING_EDGES + 4], nword; /* edges of the facing */
    mus_status status;
} facing;


static void facing_move(const facing *f, const double *p, double *out)
{
    const double x = p[0], y = p[1], *t = f->turn;
    out[0] = t[0] * x + t[1] * y + t[4];
    out[1] = t[2] * x + t[3] * y + t[5];
}


/* the point at arc length s [m] of rim edge i in the direction of the rim, moved with the part under work */
static void facing_at(facing *f, int32_t i, double s, double *out)
{
    const double length = mus_pattern_edge_length(f->pattern, f->edge[i]);
    double t = fmin(fmax(s / length, 0.0), 1.0), p[2] = {0.0, 0.0};
    if (f->direction[i] < 0) t = 1.0 - t;
    if (f->status == MUS_OK) f->status = mus_pattern_edge_at(f->pattern, f->edge[i], 1, &t, p);
    facing_move(f, p, out);
}


/* whether rim edges i and i + 1 are the legs of a dart */
static bool facing_dart(const facing *f, int32_t i)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    const int32_t a = f->edge[i % f->n], b = f->edge[(i + 1) % f->n], of = mus_pattern_edge_seam(f->pattern, a);
    if (of == MUS_NONE || mus_pattern_seam(f->pattern, of, &seam) != MUS_OK || seam.laid) return false;
    return (seam.edge_a == a && seam.edge_b == b) || (seam.edge_a == b && seam.edge_b == a);
}


/* turn the part behind the dart at rim edges i and i + 1 about its point, so that its far leg lies on the near one */
static void facing_close(facing *f, int32_t i)
{
    double near[2], point[2], far[2];
    facing_at(f, i % f->n, 0.0, near);
    facing_at(f, (i + 1) % f->n, 0.0, point);
    facing_at(f, (i + 2) % f->n, 0.0, far);
    const double angle = mus__atan2(near[1] - point[1], near[0] - point[0]) -
                         mus__atan2(far[1] - point[1], far[0] - point[0]);
    const double c = mus__cos(angle), s = mus__sin(angle), *t = f->turn;
    const double turned[6] = {c * t[0] - s * t[2], c * t[1] - s * t[3], s * t[0] + c * t[2], s * t[1] + c * t[3],
                              point[0] + c * (t[4] - point[0]) - s * (t[5] - point[1]),
                              point[1] + s * (t[4] - point[0]) + c * (t[5] - point[1])};
    memcpy(f->turn, turned, sizeof turned);
}


/* ---- the panel of the facing ---- */

static int32_t facing_point(facing *f, const double *p)
{
    int32_t point = MUS_NONE;
    if (f->status == MUS_OK) f->status = mus_pattern_add_point(f->made, f->made_panel, p[0], p[1], &point);
    return point;
}


/* the allowance that a facing has of an edge of the pattern [m]. An edge that buttons goes on as a stand, which is
 * folded back over the end of the facing: that end has the allowance of a seam */
static double facing_allowance(const facing *f, int32_t edge)
{
    const double own = mus_pattern_edge_allowance(f->pattern, edge);
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    const int32_t of = mus_pattern_edge_seam(f->pattern, edge);
    const bool buttons =
        of != MUS_NONE && mus_pattern_seam(f->pattern, of, &seam) == MUS_OK && seam.closure == MUS_CLOSURE_BUTTONS;
    return buttons && own > MUS__SEAM_ALLOWANCE ? MUS__SEAM_ALLOWANCE : own;
}


/* add an edge to the outline; name, label and allowance are those of rim edge i, MUS_NONE: those of the call */
static void facing_edge(facing *f, mus_edge_def *def, int32_t i, double allowance)
{
    int32_t made = MUS_NONE;
    const int32_t of = i != MUS_NONE ? f->edge[i] : MUS_NONE;
    if (of != MUS_NONE) def->name = mus_pattern_edge_name(f->pattern, of);
    if (f->status == MUS_OK) f->status = mus_pattern_add_edge(f->made, def, &made);
    if (f->status != MUS_OK) return;
    f->word[f->nword++] = made;
    if (of != MUS_NONE) allowance = facing_allowance(f, of);
    f->status = mus_pattern_set_edge_allowance(f->made, made, allowance);
    if (f->status == MUS_OK && of != MUS_NONE)
        f->status = mus_pattern_set_edge_label(f->made, made, mus_pattern_edge_label(f->pattern, of));
}


static void facing_line(facing *f, int32_t start, int32_t end, int32_t i)
{
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.start = start, def.end = end;
    facing_edge(f, &def, i, 0.0);
}


/* give the last edge the notches of rim edge i, which it copies: they are sewn notch on notch */
static void facing_notches(facing *f, int32_t i)
{
    const int32_t made = f->nword > 0 ? f->word[f->nword - 1] : MUS_NONE;
    const double length = mus_pattern_edge_length(f->pattern, f->edge[i]);
    for (int32_t k = 0; k < mus_pattern_notch_count(f->pattern) && f->status == MUS_OK; k++) {
        int32_t edge, kind;
        double s;
        f->status = mus_pattern_notch(f->pattern, k, &edge, &s, &kind);
        if (f->status == MUS_OK && edge == f->edge[i])
            f->status = mus_pattern_add_notch(f->made, made, fmax(0.0, f->direction[i] < 0 ? length - s : s), kind,
                                              NULL);
    }
}


/* add rim edge i, whole, with its curves; returns the point at its end, and adds its chords to the run */
static int32_t facing_copy(facing *f, int32_t i, int32_t start)
{
    int32_t npiece = 0, nxy = 0, kinds[FACING_EDGES];
    const int32_t *own;
    const double *xy;
    double moved[3 * FACING_EDGES][2];
    if (f->status == MUS_OK) f->status = mus_pattern_edge_pieces(f->pattern, f->edge[i], &npiece, &own, &nxy, &xy);
    if (f->status == MUS_OK && (npiece > FACING_EDGES || nxy > 3 * FACING_EDGES))
        f->status = mus__fail(mus_pattern_context(f->pattern), MUS_ERR_LIMIT, "facing: an edge of %d pieces",
                              (int)npiece);
    if (f->status != MUS_OK) return MUS_NONE;
    const bool back = f->direction[i] < 0;
    for (int32_t k = 0; k < nxy; k++) facing_move(f, xy + 2 * (back ? nxy - 1 - k : k), moved[k]);
    for (int32_t k = 0; k < npiece; k++) kinds[k] = own[back ? npiece - 1 - k : k];
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.start = start, def.end = facing_point(f, moved[nxy - 1]);
    def.npiece = npiece, def.kinds = kinds, def.nxy = nxy - 2, def.xy = nxy > 2 ? moved[1] : NULL;
    facing_edge(f, &def, i, 0.0);
    facing_notches(f, i);

    const double length = mus_pattern_edge_length(f->pattern, f->edge[i]);
    const int32_t n = (int32_t)fmin(ceil(length / 0.003), (double)(FACING_POINTS - f->nrun));
    if (f->nrun == 0) facing_at(f, i, 0.0, f->run[0]);
    for (int32_t k = 1; k <= n; k++) facing_at(f, i, length * k / n, f->run[++f->nrun]);
    return def.end;
}


/* ---- the parallel ---- */

/* distance of p from the run [m] */
static double facing_distance(const facing *f, const double *p)
{
    double least = HUGE_VAL;
    for (int32_t i = 0; i < f->nrun; i++) {
        const double *a = f->run[i], *b = f->run[i + 1], dx = b[0] - a[0], dy = b[1] - a[1];
        const double t = fmin(fmax(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0), 1.0);
        const double foot[2] = {a[0] + t * dx, a[1] + t * dy};
        least = fmin(least, mus__dist2(p, foot));
    }
    return least;
}


/* arc length [m] of rim edge i, from its end (back) or its start, to where it is `width` from the run, so that the
 * parallel meets it there; most of the edge where it comes no further. The edge is moved with the part under work */
static double facing_reach(facing *f, int32_t i, bool back, double width)
{
    const double length = mus_pattern_edge_length(f->pattern, f->edge[i]), most = FACING_MOST * length;
    double low = 0.0, high = 0.0, p[2];
    for (bool far = false; !far && high < most;) {
        low = high;
        high = fmin(high + 0.25 * width, most);
        facing_at(f, i, back ? length - high : high, p);
        far = facing_distance(f, p) >= width;
    }
    for (int32_t k = 0; k < FACING_HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        facing_at(f, i, back ? length - middle : middle, p);
        if (facing_distance(f, p) < width)
            low = middle;
        else
            high = middle;
    }
    return high;
}


/* add the point at `width` from p in the direction (x, y) left of the run, where it is as far from all of the run and
 * inside the lines along the ends: end (2 x 4), two points of each */
static void facing_aside(facing *f, const double *p, double x, double y, double width, const double *end)
{
    const double q[2] = {p[0] + width * x, p[1] + width * y};
    for (int32_t k = 0; k < 2; k++) {
        const double *a = end + 4 * k, *b = a + 2, *corner = k == 0 ? b : a;
        const double across = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
        if (mus__dist2(corner, q) < 2.0 * width && across < FACING_SLACK * mus__dist2(a, b)) return;
    }
    if (f->naside == FACING_POINTS || facing_distance(f, q) < width - FACING_NEAR) return;
    const double *last = f->naside > 0 ? f->aside[f->naside - 1] : NULL;
    if (last != NULL && (q[0] - last[0]) * y - (q[1] - last[1]) * x <= 0.0) return; /* backwards along the run */
    memcpy(f->aside[f->naside++], q, sizeof q);
}


static void facing_parallel(facing *f, double width, const double *end)
{
    double before = 0.0;
    f->naside = 0;
    for (int32_t i = 0; i < f->nrun; i++) {
        const double *a = f->run[i], *b = f->run[i + 1];
        const double along = mus__atan2(b[1] - a[1], b[0] - a[0]);
        double turn = i > 0 ? along - before : 0.0;
        turn += turn < -MUS_PI ? 2.0 * MUS_PI : turn > MUS_PI ? -2.0 * MUS_PI : 0.0;
        /* a corner to the right spreads: an arc of points round it */
        const int32_t n = turn < -FACING_CORNER ? (int32_t)ceil(-turn / FACING_CORNER) : 0;
        for (int32_t k = 0; k <= n && n > 0; k++)
            facing_aside(f, a, -mus__sin(before + turn * k / n), mus__cos(before + turn * k / n), width, end);
        const double middle[2] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
        facing_aside(f, middle, -mus__sin(along), mus__cos(along), width, end);
        before = along;
    }
}


/* whether the polyline has a corner at q */
static bool facing_bends(const double *p, const double *q, const double *r)
{
    const double u[2] = {q[0] - p[0], q[1] - p[1]}, v[2] = {r[0] - q[0], r[1] - q[1]};
    return u[0] * v[0] + u[1] * v[1] < FACING_BEND * mus__hypot(u[0], u[1]) * mus__hypot(v[0], v[1]);
}


/* add the parallel, against the sense of the run: edge "inner" from point far to near, more where it has corners */
static void facing_inner(facing *f, int32_t far, int32_t near)
{
    double xy[FACING_POINTS + 2][2];
    const int32_t kinds[FACING_POINTS + 1] = {MUS_PIECE_LINE}, last = f->naside + 1;
    char name[24] = "inner";
    if (f->status == MUS_OK) f->status = mus_pattern_point(f->made, far, NULL, xy[0]);
    if (f->status == MUS_OK) f->status = mus_pattern_point(f->made, near, NULL, xy[last]);
    for (int32_t k = 1; k < last; k++) memcpy(xy[k], f->aside[last - 1 - k], sizeof *xy);
    for (int32_t from = 0, at = far, count = 1; from < last && f->status == MUS_OK; count++) {
        int32_t to = from + 1;
        while (to < last && (f->nword > FACING_EDGES || !facing_bends(xy[to - 1], xy[to], xy[to + 1]))) to++;
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        if (count > 1) snprintf(name, sizeof name, "inner_%d", (int)count);
        def.name = name;
        def.start = at, def.end = at = to < last ? facing_point(f, xy[to]) : near;
        def.npiece = to - from, def.kinds = kinds;
        def.nxy = to - from - 1, def.xy = def.nxy > 0 ? xy[from + 1] : NULL;
        facing_edge(f, &def, MUS_NONE, 0.0);
        from = to;
    }
}


/* ---- one facing ---- */

/* draw the facing of the run in a pattern of its own */
static void facing_draw(facing *f, double width)
{
    static const double still[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    double corner[2], end[8];
    const int32_t before = (f->first + f->n - 1) % f->n, after = (f->last + 1) % f->n;
    const double back = mus_pattern_edge_length(f->pattern, f->edge[before]);
    memcpy(f->turn, still, sizeof still);
    f->nrun = f->nword = 0;
    facing_at(f, f->first, 0.0, corner);
    memcpy(end + 2, corner, sizeof corner);
    const int32_t start = facing_point(f, corner);
    int32_t at = start, i = f->first;
    for (;;) {
        at = facing_copy(f, i % f->n, at);
        if (i % f->n == f->last || f->status != MUS_OK) break;
        if (!f->on[(i + 1) % f->n]) {
            facing_close(f, i + 1);
            i += 2;
        }
        i++;
    }
    memcpy(end + 4, f->run[f->nrun], 2 * sizeof *end);
    facing_at(f, after, facing_reach(f, after, false, width), end + 6);
    memcpy(f->turn, still, sizeof still);
    facing_at(f, before, back - facing_reach(f, before, true, width), end);
    const int32_t far = facing_point(f, end + 6), near = facing_point(f, end);
    facing_line(f, at, far, after);
    facing_parallel(f, width, end);
    facing_inner(f, far, near);
    facing_line(f, near, start, before);
}


/* draw the facing, narrower when it crosses itself, and add it to those that are made */
static void facing_add(mus__cut_only *job, facing *f, const char *name, double width)
{
    int32_t along[FACING_EDGES + 4], a, b;
    double grain[2];
    for (int32_t i = 0; i < FACING_EDGES + 4; i++) along[i] = 1;
    for (int32_t try = 0; try < FACING_TRIES && job->status == MUS_OK; try++, width *= 0.7) {
        bool crosses = false;
        job->status = mus_pattern_create(mus_pattern_context(job->made), "facing", &f->made);
        if (job->status != MUS_OK) return;
        f->status = mus_pattern_add_panel(f->made, name, &f->made_panel);
        facing_draw(f, width);
        if (f->status == MUS_OK) f->status = mus_pattern_set_outline(f->made, 0, f->nword, f->word, along);
        if (f->status == MUS_OK) f->status = mus_pattern_grain(f->pattern, f->panel, grain);
        if (f->status == MUS_OK) f->status = mus_pattern_set_grain(f->made, 0, grain[0], grain[1]);
        if (f->status == MUS_OK) f->status = mus_pattern_set_panel_label(f->made, 0, "facing");
        if (f->status == MUS_OK) f->status = mus_pattern_set_material(f->made, 0, MUS_MATERIAL_INTERFACING, 1);
        if (f->status == MUS_OK) f->status = mus__panel_crosses(f->made, 0, &crosses, &a, &b);
        if (f->status == MUS_OK && !crosses) f->status = mus_pattern_join(job->made, f->made, 0);
        job->status = f->status;
        mus_pattern_destroy(f->made);
        if (!crosses) return;
    }
}


/* the facing `made` is the mirror image of the one called `name`: both are cut of that */
static void facing_pair(mus__cut_only *job, int32_t made, const char *name)
{
    const int32_t of = mus_pattern_find_panel(job->made, name);
    if (of == MUS_NONE || of == made || made == MUS_NONE || job->status != MUS_OK) return;
    job->status = mus_pattern_set_cut(job->made, made, 1, of);
    if (job->status == MUS_OK) job->status = mus_pattern_set_cut(job->made, of, 2, MUS_NONE);
    if (job->status == MUS_OK) job->status = mus_pattern_set_material(job->made, of, MUS_MATERIAL_INTERFACING, 2);
}


/* ---- the panels ---- */

/* the last edge of the run that begins at rim edge `first`; MUS_NONE when it goes all round */
static int32_t facing_run(const facing *f, int32_t first)
{
    int32_t i = first;
    for (int32_t steps = 0; steps < f->n; steps++) {
        if (f->on[(i + 1) % f->n]) i++;
        else if (f->on[(i + 3) % f->n] && facing_dart(f, i + 1)) i += 3;
        else return i % f->n;
        if (i >= first + f->n) return MUS_NONE;
    }
    return MUS_NONE;
}


/* whether a run begins at rim edge i: neither an edge of it nor a dart of it is before */
static bool facing_begins(const facing *f, int32_t i)
{
    if (!f->on[i] || f->on[(i + f->n - 1) % f->n]) return false;
    return f->n < 4 || !f->on[(i + f->n - 3) % f->n] || !facing_dart(f, i + f->n - 2);
}


static double facing_length(const facing *f)
{
    double length = 0.0;
    for (int32_t i = f->first;; i = (i + 1) % f->n) {
        if (f->on[i]) length += mus_pattern_edge_length(f->pattern, f->edge[i]);
        if (i == f->last) return length;
    }
}


/* the facings of the runs of one panel; the second of two that are as long is the mirror image of the first */
static void facing_panel(mus__cut_only *job, facing *f, const char *ending)
{
    char name[2 * MUS__NAME_BYTES], first[2 * MUS__NAME_BYTES];
    int32_t of = MUS_NONE, runs = 0;
    double length = 0.0;
    mus_pattern_cut(job->pattern, f->panel, NULL, &of);
    snprintf(first, sizeof first, "%s%s", mus_pattern_panel_name(job->pattern, of != MUS_NONE ? of : f->panel), ending);
    for (int32_t i = 0; i < f->n && job->status == MUS_OK; i++) {
        if (!facing_begins(f, i)) continue;
        f->first = i;
        f->last = facing_run(f, i);
        if (f->last == MUS_NONE) continue;
        const double own = facing_length(f);
        snprintf(name, sizeof name, "%s%s", mus_pattern_panel_name(job->pattern, f->panel), ending);
        if (runs > 0) snprintf(name + strlen(name), sizeof name - strlen(name), "_%d", (int)runs + 1);
        facing_add(job, f, name, MUS__FACING * job->scale);
        if (of != MUS_NONE || (runs == 1 && fabs(own - length) < FACING_SLACK))
            facing_pair(job, mus_pattern_find_panel(job->made, name), first);
        length = own;
        runs++;
    }
}


/* the edge of the facing with `ending` that is part of an edge of the pattern, or MUS_NONE */
static int32_t facing_part(const mus__cut_only *job, int32_t edge, const char *ending)
{
    char name[2 * MUS__NAME_BYTES];
    snprintf(name, sizeof name, "%s%s",
             mus_pattern_panel_name(job->pattern, mus_pattern_edge_panel(job->pattern, edge)), ending);
    return mus_pattern_find_edge(job->made, mus_pattern_find_panel(job->made, name),
                                 mus_pattern_edge_name(job->pattern, edge));
}


/* sew the ends of the facings with `ending` to each other as the edges are sewn that they are parts of; a closure is
 * left to its own facing */
static void facing_sew(mus__cut_only *job, const char *ending)
{
    for (int32_t i = 0; i < mus_pattern_seam_count(job->pattern) && job->status == MUS_OK; i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        job->status = mus_pattern_seam(job->pattern, i, &seam);
        if (job->status != MUS_OK || seam.closure != MUS_CLOSURE_NONE || seam.laid) continue;
        const int32_t a = facing_part(job, seam.edge_a, ending), b = facing_part(job, seam.edge_b, ending);
        if (a == MUS_NONE || b == MUS_NONE || a == b) continue;
        if (fabs(mus_pattern_edge_length(job->made, a) - mus_pattern_edge_length(job->made, b)) > seam.tolerance)
            continue;
        seam.edge_a = a, seam.edge_b = b;
        seam.direction = MUS_SEAM_REVERSED, seam.ease = 0.0;
        job->status = mus_pattern_add_seam(job->made, &seam, NULL);
    }
}


/* read the rim of a panel; false when it is too rich, or the job has failed */
static bool facing_read(mus__cut_only *job, int32_t panel, facing *f)
{
    f->pattern = job->pattern;
    f->panel = panel;
    job->status = mus_pattern_rim(job->pattern, panel, f->edge, f->direction, FACING_EDGES, &f->n);
    return job->status == MUS_OK && f->n <= FACING_EDGES;
}


void mus__cut_facings(mus__cut_only *job, const char *label, const char *ending)
{
    facing f;
    for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern) && job->status == MUS_OK; i++) {
        const char *part = mus_pattern_panel_label(job->pattern, i);
        if (strcmp(part, "collar") == 0 || strcmp(part, "hood") == 0 || strcmp(part, "strap") == 0) continue;
        if (!facing_read(job, i, &f)) continue;
        for (int32_t k = 0; k < f.n; k++) f.on[k] = strcmp(mus_pattern_edge_label(job->pattern, f.edge[k]), label) == 0;
        facing_panel(job, &f, ending);
    }
    facing_sew(job, ending);
}


/* a fly: the zip's part of the centre front, straight beside it, rounded to it over the last third */
void mus__cut_fly(mus__cut_only *job, double width)
{
    facing f;
    const int32_t panel = mus_pattern_find_panel(job->pattern, "leg_front_left");
    if (job->status != MUS_OK || panel == MUS_NONE || !facing_read(job, panel, &f)) return;
    int32_t i = 0;
    while (i < f.n && strcmp(mus_pattern_edge_name(job->pattern, f.edge[i]), "zip") != 0) i++;
    if (i == f.n) return;
    static const double still[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    memcpy(f.turn, still, sizeof still);
    f.status = MUS_OK;
    const double length = mus_pattern_edge_length(job->pattern, f.edge[i]);
    enum { STEPS = 24 };
    double p[STEPS + 1][2], outer[STEPS][2];
    for (int32_t k = 0; k <= STEPS; k++) facing_at(&f, i, length * k / STEPS, p[k]);
    const double round = length / 3.0;
    for (int32_t k = 0; k < STEPS; k++) {
        const double s = length * k / STEPS, u = fmax(0.0, (s - (length - round)) / round);
        const double w = width * sqrt(fmax(0.0, 1.0 - u * u)), d = mus__dist2(p[k], p[k + 1]);
        outer[k][0] = w * (p[k + 1][1] - p[k][1]) / d - p[k][0];
        outer[k][1] = p[k][1] + w * (p[k + 1][0] - p[k][0]) / d;
    }
    job->status = mus_pattern_add_panel(job->made, "fly_facing", &f.made_panel);
    f.made = job->made, f.status = job->status, f.nword = 0;

    /* it lies right side on right side of the left front, so its own right side shows it mirrored */
    double up[STEPS + 1][2];
    for (int32_t k = 0; k <= STEPS; k++) up[k][0] = -p[STEPS - k][0], up[k][1] = p[STEPS - k][1];
    const int32_t top = facing_point(&f, up[STEPS]), low = facing_point(&f, up[0]), side = facing_point(&f, outer[0]);
    int32_t kinds[STEPS] = {MUS_PIECE_LINE}, along[3] = {1, 1, 1};
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    def.npiece = STEPS, def.kinds = kinds, def.nxy = STEPS - 1;
    facing_line(&f, top, side, (i + f.n - 1) % f.n);
    def.start = side, def.end = low, def.xy = outer[1];
    facing_edge(&f, &def, MUS_NONE, 0.0);
    def.start = low, def.end = top, def.xy = up[1];
    facing_edge(&f, &def, i, 0.0);
    if (f.status == MUS_OK) f.status = mus_pattern_set_outline(f.made, f.made_panel, f.nword, f.word, along);
    if (f.status == MUS_OK) f.status = mus_pattern_set_panel_label(f.made, f.made_panel, "fly");
    if (f.status == MUS_OK) f.status = mus_pattern_set_material(f.made, f.made_panel, MUS_MATERIAL_INTERFACING, 1);
    job->status = f.status;
}
