/*
 * body_surface.c: the surface of the limbs: rings, vertices, triangles and normals, drawn from the radius fields.
 *
 * Every vertex is a point of the surface that contact touches: a ring of a limb is a section of the fields of its parts
 * in `samples` directions. The surface of a limb is an end point, rings, and an end point. There is a ring at every
 * contour; where a fillet or a detail changed a field, one at each of the field's own rings; and between these so many
 * that no sample moves more than ring_spacing from one to the next. A cap has a few rings at equal angles of its
 * ellipse. Two rings are joined by quads cut in two, the ends by fans, so that no triangle has more than two vertices
 * on one contour, and those are neighbours (the two conditions of Metaaphanon and Kanongchaiyos 2005, section 3.3). All
 * triangles wind outwards.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

/* rings of a cap, at equal angles of the quarter of an ellipse; chosen */
#define SURFACE_CAP_RINGS 6

/* [m] ring_spacing up to which each of a field's changed rings is drawn: the default */
#define SURFACE_FINE 0.015

/* [m] between two contours the surface bends off the chords of its rings by no more than about this; chosen: half of
 * what the drawn skin may be off what cloth touches */
#define SURFACE_BULGE 2.5e-4

/* most rings between two contours: bounds the memory */
#define SURFACE_STEPS 200

/* a ring nearer to a contour than this, in distances of the field's rings, is left out; chosen */
#define SURFACE_NEAR 0.3

/* the sampling of a limb: its directions in the tables, and scratch for rings */
typedef struct surface_work {
    int32_t n, angles, *entry;        /* (n), and the steps of the tables */
    double *turn, *share;             /* (n x 2), (n) */
    double *radius, *before, *middle; /* (n) */
    double *stop, *ring;              /* s of the rings that must be there of one limb, and of all rings of all limbs */
    int32_t most;                     /* room for so many rings */
    int32_t later;                    /* of which limbs that have none yet need so many */
} surface_work;


/* the field of the part that contains s of limb l */
static const mus__field *surface_field(const mus_body *body, int32_t l, double s)
{
    int32_t found = MUS_NONE;
    for (int32_t p = 0; p < body->nfield; p++)
        if (body->rig.part[p].limb == l && (found == MUS_NONE || s >= body->rig.part[p].end[0])) found = p;
    return &body->field[found];
}


void mus__body_section(const mus_body *body, int32_t l, double s, int32_t n, const int32_t *entry, const double *share,
                       double *centre, double *radius)
{
    mus__field_ring(surface_field(body, l, s), s, n, entry, share, centre, radius);
}


/* take the directions of limb l */
static void surface_turn(const mus_body *body, int32_t l, surface_work *work)
{
    const int32_t n = body->limb[l].samples, angles = mus__body_angles(body, l);
    if (work->n == n && work->angles == angles) return;
    work->n = n, work->angles = angles;
    mus__field_turns(n, work->turn);
    mus__field_steps(angles, n, work->turn, work->entry, work->share);
}


/* the section of a limb at s in the directions of the surface */
static void surface_section(const mus_body *body, int32_t l, double s, const surface_work *work, double *centre,
                            double *radius)
{
    mus__body_section(body, l, s, work->n, work->entry, work->share, centre, radius);
}


/* whether s is nearer to a contour than `least` [m] */
static bool surface_at_contour(const mus__limb *limb, double s, double least)
{
    for (int32_t i = 0; i < limb->count; i++)
        if (fabs(limb->contour[i].s - s) < least) return true;
    return false;
}


/* whether ring j + 1 of a field lies so near to the chords of the rings about it that it need not be drawn */
static bool surface_flat(const mus__field *field, int32_t j)
{
    const int32_t n = field->nangle;
    const double *low = field->radius + (ptrdiff_t)j * n, *high = low + 2 * (ptrdiff_t)n, ds = field->ds;
    if (j + 2 > field->fine[1]) return false;
    for (int32_t k = 0; k < n; k++) {
        const double bulge = low[n + k] - 0.5 * (low[k] + high[k]), rise = high[k] - low[k];
        if (bulge * bulge * 4.0 * ds * ds > SURFACE_BULGE * SURFACE_BULGE * (rise * rise + 4.0 * ds * ds)) return false;
    }
    return true;
}


/* s of the contours and of changed rings of the fields, ascending; returns their number */
static int32_t surface_stops(const mus_body *body, int32_t l, double *stop)
{
    const mus__limb *limb = &body->limb[l];
    const double low = limb->contour[0].s, high = limb->contour[limb->count - 1].s;
    const int32_t stride = (int32_t)ceil(body->def.ring_spacing / SURFACE_FINE - 1e-9);
    int32_t count = 0, i = 0;
    for (int32_t p = 0; p < body->nfield; p++) {
        const mus__part *part = &body->rig.part[p];
        const mus__field *field = &body->field[p];
        if (part->limb != l) continue;
        const double first = part->round[0] > 0.0 ? part->end[0] : low,
                     last = part->round[1] > 0.0 ? part->end[1] : high;
        for (int32_t j = field->fine[0]; j <= field->fine[1]; j += surface_flat(field, j) ? 2 * stride : stride) {
            const double s = field->s0 + j * field->ds;
            if (s < first || s > last || surface_at_contour(limb, s, SURFACE_NEAR * field->ds)) continue;
            while (i < limb->count && limb->contour[i].s < s) stop[count++] = limb->contour[i++].s;
            stop[count++] = s;
        }
    }
    while (i < limb->count) stop[count++] = limb->contour[i++].s;
    return count;
}


/* s of the rings of the cap at an end of a limb, from its outer end inwards (end 0) or outwards */
static int32_t surface_cap(const mus_body *body, int32_t l, int end, double *out)
{
    const mus__limb *limb = &body->limb[l];
    const mus__contour *last = &limb->contour[end == 0 ? 0 : limb->count - 1];
    const mus__field *field = surface_field(body, l, last->s);
    const double middle = field->middle[end], axis = field->half[end];
    const double most = mus__acos((end == 0 ? middle - last->s : last->s - middle) / axis);
    for (int32_t j = 1; j < SURFACE_CAP_RINGS; j++) {
        const int32_t step = end == 0 ? j : SURFACE_CAP_RINGS - j;
        const double off = axis * mus__cos(most * step / SURFACE_CAP_RINGS);
        out[j - 1] = end == 0 ? middle - off : middle + off;
    }
    return SURFACE_CAP_RINGS - 1;
}


/* s of all rings of a limb into `out`, and the ring of each contour; returns their number */
static int32_t surface_rings(mus_body *body, int32_t l, const surface_work *work, double *out)
{
    const int32_t most_rings = work->most - work->later - (int32_t)(out - work->ring) - SURFACE_CAP_RINGS;
    mus__limb *limb = &body->limb[l];
    const int32_t stops = surface_stops(body, l, work->stop), n = work->n;
    double centre[2], *now = work->radius, *last = work->before;
    int32_t count = surface_cap(body, l, 0, out), contour = 0;
    for (int32_t i = 0; i < stops; i++) {
        const double s = work->stop[i], low = i > 0 ? work->stop[i - 1] : s;
        double most = 0.0, spacing = body->def.ring_spacing;
        surface_section(body, l, s, work, centre, now);
        if (contour > 0 && limb->contour[contour - 1].fine) spacing *= 0.5;
        for (int32_t k = 0; k < n && i > 0; k++) {
            const double off = fabs(now[k] - last[k]);
            most = off > most ? off : most;
        }
        double steps = ceil(sqrt((s - low) * (s - low) + most * most) / spacing), bulge = 0.0;
        if (s - low > 2.5 * surface_field(body, l, low)->ds && spacing < SURFACE_FINE + 1e-9) {
            for (int third = 1; third < 3; third++) { /* an S has no bulge in the middle */
                const double t = third / 3.0;
                surface_section(body, l, low + t * (s - low), work, centre, work->middle);
                for (int32_t k = 0; k < n; k++) {
                    const double rise = now[k] - last[k], off = work->middle[k] - last[k] - t * rise;
                    const double square = off * off * (s - low) * (s - low) / ((s - low) * (s - low) + rise * rise);
                    if (square > bulge) bulge = square;
                }
            }
            steps = fmax(steps, ceil(sqrt(sqrt(bulge) / SURFACE_BULGE)));
        }
        steps = fmin(steps, SURFACE_STEPS);
        for (int32_t j = 1; j < steps && count + stops - i < most_rings; j++)
            out[count++] = low + (s - low) * j / steps;
        if (contour < limb->count && s >= limb->contour[contour].s) limb->contour[contour++].ring = count;
        out[count++] = s;
        double *swap = now;
        now = last, last = swap;
    }
    return count + surface_cap(body, l, 1, out + count);
}


/* the point (3) of a limb at (a, b, s) */
static void surface_point(const mus__limb *limb, double a, double b, double s, double *out)
{
    for (int i = 0; i < 3; i++) out[i] = limb->origin[i] + a * limb->side[i] + b * limb->front[i] + s * limb->axis[i];
}


/* vertices (rings n + 2 x 3) of limb l in the rest pose */
static void surface_vertices(const mus_body *body, int32_t l, const surface_work *work, double *out)
{
    const mus__limb *limb = &body->limb[l];
    const double *s = body->ring + limb->first_ring, *turn = work->turn;
    double centre[2], *radius = work->radius;
    surface_section(body, l, limb->pole[0], work, centre, radius);
    surface_point(limb, centre[0], centre[1], limb->pole[0], out);
    out += 3;
    for (int32_t j = 0; j < limb->rings; j++) {
        const double at = s[j] - mus__relief_short(body, l, s[j]);
        surface_section(body, l, s[j], work, centre, radius);
        for (int32_t k = 0; k < work->n; k++, out += 3)
            surface_point(limb, centre[0] + radius[k] * turn[2 * k], centre[1] + radius[k] * turn[2 * k + 1], at, out);
    }
    surface_section(body, l, limb->pole[1], work, centre, radius);
    surface_point(limb, centre[0], centre[1], limb->pole[1] - mus__relief_short(body, l, limb->pole[1]), out);
}


/* move the rings and end points of limb l to the body's pose */
static void surface_carry(const mus_body *body, int32_t l, const double *s, double *x)
{
    const mus__limb *limb = &body->limb[l];
    const int32_t n = limb->samples;
    mus__frame frame;
    mus__rig_ring(&body->rig, body->frame, l, limb->pole[0], &frame);
    mus__frame_point(&frame, x, x);
    x += 3;
    for (int32_t j = 0; j < limb->rings; j++) {
        mus__rig_ring(&body->rig, body->frame, l, s[j], &frame);
        for (int32_t k = 0; k < n; k++, x += 3) mus__frame_point(&frame, x, x);
    }
    mus__rig_ring(&body->rig, body->frame, l, limb->pole[1], &frame);
    mus__frame_point(&frame, x, x);
}


/* the first ring of limb l at s or above; -1: none is nearer than `near` [m] */
static int32_t surface_ring_at(const mus_body *body, int32_t l, double s, double near)
{
    const mus__limb *limb = &body->limb[l];
    const double *ring = body->ring + limb->first_ring;
    int32_t low = -1, high = limb->rings;
    while (high - low > 1) {
        const int32_t middle = low + (high - low) / 2;
        if (ring[middle] < s - near)
            low = middle;
        else
            high = middle;
    }
    return high < limb->rings && ring[high] < s + near ? high : -1;
}


/* the ring of a contour among those of fillets stands between two of the field's: its normals are blended */
static void surface_contour_normals(mus_body *body, int32_t l, const mus__contour *contour)
{
    const mus__limb *limb = &body->limb[l];
    const mus__field *field = surface_field(body, l, contour->s);
    const double *s = body->ring + limb->first_ring + contour->ring;
    const double low = field->s0 + field->fine[0] * field->ds, high = field->s0 + field->fine[1] * field->ds;
    if (contour->ring < 1 || contour->ring + 1 >= limb->rings || s[-1] < low || s[1] > high) return;
    const ptrdiff_t row = 3 * (ptrdiff_t)limb->samples;
    const double t = (s[0] - s[-1]) / (s[1] - s[-1]);
    double *normal = body->normals + 3 * (ptrdiff_t)(limb->first_vertex + 1) + contour->ring * row;
    for (int32_t k = 0; k < limb->samples; k++, normal += 3) {
        for (int i = 0; i < 3; i++) normal[i] = normal[i - row] + t * (normal[i + row] - normal[i - row]);
        mus__unit3(normal);
    }
}


/* the normals that fillets know, where a ring of the surface is a ring of the field in the same directions. In a pose
 * they turn with their part; a limb with a bent joint gets those of its triangles after that (skin_posed.c) */
static void surface_creases(mus_body *body)
{
    int32_t part = MUS_NONE, row = MUS_NONE, ring = -1;
    for (int32_t i = 0; i < body->creases; i++) {
        const mus__crease *crease = &body->crease[i];
        const mus__field *field = &body->field[crease->part];
        const int32_t l = body->rig.part[crease->part].limb, n = body->limb[l].samples;
        if (crease->part != part || crease->ring != row) {
            part = crease->part, row = crease->ring;
            ring = n == field->nangle ? surface_ring_at(body, l, field->s0 + row * field->ds, 1e-9) : -1;
        }
        if (ring < 0) continue;
        double *normal = body->normals + 3 * (body->limb[l].first_vertex + 1 + (ptrdiff_t)ring * n + crease->entry);
        memcpy(normal, crease->normal, sizeof crease->normal);
        if (body->frame != NULL) mus__frame_turn(&body->frame[crease->part], crease->normal, normal);
    }
    for (int32_t l = 0; l < body->limb_count && body->creases > 0; l++)
        for (int32_t i = 0; i < body->limb[l].count && !body->limb[l].gone; i++)
            surface_contour_normals(body, l, &body->limb[l].contour[i]);
}


/* rings that a limb has at least, or a bound of them: its stops and its caps */
static int32_t surface_least(const mus_body *body, int32_t l)
{
    int32_t rings = body->limb[l].count + 2 * SURFACE_CAP_RINGS;
    for (int32_t p = 0; p < body->nfield; p++)
        if (body->rig.part[p].limb == l) rings += body->field[p].nring;
    return rings;
}


/* scratch for the rings of all limbs. Errors: MUS_ERR_MEMORY */
static mus_status surface_begin(const mus_body *body, surface_work *work)
{
    const int32_t n = body->def.samples;
    int64_t rows = 0;
    for (int32_t p = 0; p < body->nfield; p++) rows += body->field[p].nring;
    work->most = (int32_t)rows;
    work->later = 0;
    for (int32_t l = 0; l < body->limb_count; l++) {
        work->most += SURFACE_STEPS * body->limb[l].count + 2 * SURFACE_CAP_RINGS;
        work->later += surface_least(body, l);
    }
    work->entry = mus__new(body->context, n, sizeof *work->entry);
    work->share = mus__new(body->context, 6 * (int64_t)n, sizeof *work->share);
    work->stop = mus__room(body->context, rows + MUS__LIMB_CONTOURS, sizeof *work->stop);
    work->ring = mus__room(body->context, work->most, sizeof *work->ring);
    if (!work->entry || !work->share || !work->stop || !work->ring)
        return mus__fail_memory(body->context, "the surface of a body");
    work->radius = work->share + n, work->before = work->radius + n, work->middle = work->before + n;
    work->turn = work->middle + n;
    return MUS_OK;
}


static void surface_end(const mus_body *body, surface_work *work)
{
    mus__free(body->context, work->entry);
    mus__free(body->context, work->share);
    mus__free(body->context, work->stop);
    mus__free(body->context, work->ring);
}


/* rings of all limbs into body->ring, and their ranges. Errors: MUS_ERR_MEMORY */
static mus_status surface_ranges(mus_body *body, surface_work *work)
{
    int32_t rings = 0;
    for (int32_t l = 0; l < body->limb_count; l++) {
        mus__limb *limb = &body->limb[l];
        const int32_t n = limb->samples;
        work->later -= surface_least(body, l);
        if (!limb->gone) surface_turn(body, l, work);
        limb->rings = limb->gone ? 0 : surface_rings(body, l, work, work->ring + rings);
        limb->vertices = limb->gone ? 0 : limb->rings * n + 2;
        limb->triangles = 2 * n * limb->rings;
        limb->first_vertex = body->vertex_count;
        limb->first_triangle = body->triangle_count;
        body->vertex_count += limb->vertices;
        body->triangle_count += limb->triangles;
        limb->first_ring = rings;
        rings += limb->rings;
    }
    body->ring = mus__room(body->context, rings, sizeof *body->ring);
    if (body->ring == NULL) return mus__fail_memory(body->context, "the surface of a body");
    memcpy(body->ring, work->ring, (size_t)rings * sizeof *body->ring);
    return MUS_OK;
}


/* the quads about the rings that fillets changed are cut along the diagonal that lies further inwards: where a field
 * bends inwards into the other limb, the flat triangles then do not stand out of it */
static void surface_flip(mus_body *body, int32_t l, int32_t ring)
{
    const mus__limb *limb = &body->limb[l];
    const int32_t n = limb->samples, first = limb->first_vertex + 1 + ring * n;
    int32_t *triangle = body->triangles + 3 * (limb->first_triangle + (ptrdiff_t)n * (1 + 2 * ring));
    const double *x = body->vertices;
    double middle[3] = {0.0, 0.0, 0.0};
    for (int32_t k = 0; k < 2 * n; k += n / 4) /* four vertices of each ring */
        for (int i = 0; i < 3; i++) middle[i] += 0.125 * x[3 * (first + (ptrdiff_t)k) + i];
    for (int32_t k = 0; k < n; k++, triangle += 6) {
        const int32_t a = first + k, b = first + (k + 1) % n, c = a + n, d = b + n;
        double cut = 0.0, other = 0.0;
        for (int i = 0; i < 3; i++) {
            const double p = 0.5 * (x[3 * (ptrdiff_t)b + i] + x[3 * (ptrdiff_t)c + i]) - middle[i];
            const double q = 0.5 * (x[3 * (ptrdiff_t)a + i] + x[3 * (ptrdiff_t)d + i]) - middle[i];
            cut += p * p, other += q * q;
        }
        if (cut <= other) continue;
        const int32_t fresh[6] = {a, b, d, a, d, c};
        memcpy(triangle, fresh, sizeof fresh);
    }
}


/* all quads that touch a ring with an entry of a fillet */
static void surface_flips(mus_body *body)
{
    int32_t part = MUS_NONE, row = MUS_NONE;
    for (int32_t i = 0; i < body->creases; i++) {
        const mus__crease *crease = &body->crease[i];
        const mus__field *field = &body->field[crease->part];
        const int32_t l = body->rig.part[crease->part].limb;
        if (crease->part == part && crease->ring == row) continue;
        part = crease->part, row = crease->ring;
        const int32_t ring = surface_ring_at(body, l, field->s0 + row * field->ds, 1e-9);
        if (ring >= 0 && ring + 1 < body->limb[l].rings) surface_flip(body, l, ring);
    }
}


/* vertices, triangles and normals of all limbs. Errors: MUS_ERR_MEMORY */
static mus_status surface_fill(mus_body *body, surface_work *work)
{
    if (!body->def.plain) mus__digit_counts(body, &body->digit_vertices, &body->digit_triangles);
    const int64_t vertices = (int64_t)body->vertex_count + body->digit_vertices;
    body->vertices = mus__room(body->context, 3 * vertices, sizeof(double));
    body->normals = mus__room(body->context, 3 * vertices, sizeof(double));
    body->triangles =
        mus__room(body->context, 3 * ((int64_t)body->triangle_count + body->digit_triangles), sizeof(int32_t));
    if (!body->vertices || !body->normals || !body->triangles)
        return mus__fail_memory(body->context, "the surface of a body");

    for (int32_t l = 0; l < body->limb_count; l++) {
        mus__limb *limb = &body->limb[l];
        double *x = body->vertices + 3 * (ptrdiff_t)limb->first_vertex;
        if (limb->gone) continue;
        surface_turn(body, l, work);
        surface_vertices(body, l, work, x);
        if (body->frame != NULL) surface_carry(body, l, body->ring + limb->first_ring, x);
        mus__ring_triangles(limb->first_vertex, limb->rings, limb->samples,
                            body->triangles + 3 * (ptrdiff_t)limb->first_triangle);
        mus__ring_normals(x, limb->samples, limb->rings, 0, body->normals + 3 * (ptrdiff_t)limb->first_vertex);
    }
    surface_creases(body);
    surface_flips(body);
    return MUS_OK;
}


mus_status mus__body_surface(mus_body *body)
{
    surface_work work = {0};
    mus_status status = surface_begin(body, &work);
    if (status == MUS_OK) status = surface_ranges(body, &work);
    if (status == MUS_OK) status = surface_fill(body, &work);
    surface_end(body, &work);
    return status;
}
