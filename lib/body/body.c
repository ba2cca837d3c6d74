/*
 * body.c: a body from a tape, and the getters of a body. A stranger starts here.
 *
 * A body is made once and does not change. Its files in the order of use:
 *
 *     body.c                mus_body_create(): the steps for a tape (this file); getters
 *     body_posture.c        stoop, head and sway: contours moved forwards and backwards
 *     body_fit_lengths.c    bust span and crotch length of the tape, where it gives them
 *     limbs_left_out.c  limbs, or their ends, left out
 *     body_from_limbs.c     limbs given by the caller, with body_outline.c for polygons
 *     body_make.c           options, limbs to radius fields, destruction; for every kind of body
 *     body_measure.c        girths and heights of the finished surface; body_length.c: lengths along it
 *     bones.c, rig.c        joints; rigid parts and their frames in the rest pose (frame.c)
 *     skin_fillet.c, relief.c  fillets where limbs meet; face, feet and seat: written into the radius fields
 *     give.c                contours give way, so that the finished fields have the tape's girths
 *     body_surface.c        rings and triangles drawn from the fields, with ring_mesh.c; fingers_toes.c
 *     body_landmark.c, body_level.c, body_volume.c  queries
 *     body_copy.c           a copy whose parts stand elsewhere, for lib/pose
 *
 * lib/limb makes the contours of each limb and the radius fields; lib/pose turns joints; lib/scan makes a body from a
 * mesh by mus__body_create_jointed(). lib/contact reads the fields.
 *
 * Source: Metaaphanon and Kanongchaiyos, Real-time Cloth Simulation for Garment CAD, 2005, section 3.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"
#include "limb/across.h"

/* distance of rings of the radius fields, in parts of the stature (3.7 mm at 1.68 m); measured: the depth of the
 * surface in its own field then stays below 0.5 mm, also at the steep shoulders */
#define BODY_FIELD_SPACING 0.0022

/* width of a fillet of the skin, in parts of the stature (25 mm at 1.68 m); chosen: in a right-angled crease the fillet
 * lies 6 mm off the crease and reaches 25 mm along both limbs */
#define BODY_FILLET 0.015

/* least distance of two contours, in parts of the stature (1 cm at 1.67 m); chosen */
#define BODY_CONTOUR_GAP 0.006


/* a crotch length of the tape that the finished surface misses by more [m] is followed again, in so many rounds at most
 */
#define BODY_CLOSE 5e-4
#define BODY_ROUNDS 4

/* append the limbs of mus_body_def.limb to those of the tape */
static mus_status body_add(mus_body *body)
{
    mus_status status = MUS_OK;
    for (int32_t l = 0; l < body->def.limbs && status == MUS_OK; l++) {
        mus__limb *limb = &body->limb[MUS__LIMB_COUNT + l];
        status = mus__body_given_limb(body->context, l, &body->def.limb[l], limb);
        for (int32_t i = 0; body->def.ellipse && i < limb->count; i++) limb->contour[i].n = 2.0;
    }
    if (status == MUS_OK) status = mus__body_outlines(body, MUS__LIMB_COUNT, body->def.limbs, body->def.limb);
    body->def.limb = NULL; /* it belongs to the caller */
    return status;
}


/* check the contours of limb l and scale each to its target girth */
static mus_status body_fit(mus_body *body, int32_t l, double *xy, int32_t *work)
{
    const int32_t n = mus__body_samples(body, l);
    double turn[2 * MUS__CONTOUR_SAMPLES];
    mus__field_turns(n, turn);
    mus__limb *limb = &body->limb[l];
    const mus__contour *left = mus__limb_is_right(l) ? body->limb[l - 1].contour : NULL;
    mus_status status = mus__limb_check(body->context, limb, BODY_CONTOUR_GAP * body->skeleton.crown);
    for (int32_t i = 0; i < limb->count && status == MUS_OK; i++) {
        mus__contour *contour = &limb->contour[i];
        if (body->def.ellipse) {
            contour->n = 2.0;
            contour->bump[0] = contour->bump[1] = 0.0;
        }
        if (left != NULL) { /* it has the shape of the left one */
            contour->a = left[i].a, contour->b = left[i].b;
            memcpy(contour->bump, left[i].bump, sizeof contour->bump);
        } else if (contour->target > 0.0)
            mus__contour_fit(contour, contour->target, n, turn, xy, work);
    }
    return status;
}


/* contours of all limbs from the tape, fitted to their girths; the legs take their root from the fitted hip. `more` [m]
 * is what the crotch length lacked before */
static mus_status body_contours(mus_body *body, const mus_tape *tape, double more, const double *turn, double *xy,
                                int32_t *work)
{
    mus__limb *limb = body->limb;
    const mus__skeleton *bone = &body->skeleton;
    mus__limb_torso(tape, bone, &limb[MUS__LIMB_TORSO]);
    mus_status status = body_fit(body, MUS__LIMB_TORSO, xy, work);
    if (status == MUS_OK) status = mus__body_follow(body, tape, more, turn, xy, work);
    if (status != MUS_OK) return status;

    if (!mus__posture_none(&body->def)) mus__posture_torso(&body->def, bone, &limb[MUS__LIMB_TORSO]);

    const mus__contour *hip = &limb[MUS__LIMB_TORSO].contour[0];
    while (hip->girth != MUS_MEASURE_HIP) hip++;
    for (int32_t right = 0; right < 2; right++) {
        mus__limb_arm(tape, bone, right, &limb[MUS__LIMB_ARM_LEFT + right]);
        mus__limb_leg(tape, bone, right, hip, &limb[MUS__LIMB_LEG_LEFT + right]);
        mus__limb_foot(tape, bone, right, &limb[MUS__LIMB_LEG_LEFT + right], &limb[MUS__LIMB_FOOT_LEFT + right]);
    }
    for (int32_t l = MUS__LIMB_TORSO + 1; l < MUS__LIMB_COUNT && status == MUS_OK; l++)
        status = body_fit(body, l, xy, work);
    if (status != MUS_OK) return status;
    mus__body_without(body);
    return MUS_OK;
}


/* breadth of back and chest from arm to arm, in the fields, for a body with an arm */
static void body_across(mus_body *body)
{
    const mus__skeleton *bone = &body->skeleton;
    const int32_t arm = body->limb[MUS__LIMB_ARM_LEFT].gone ? MUS__LIMB_ARM_RIGHT : MUS__LIMB_ARM_LEFT;
    if (body->limb[arm].gone || body->def.ellipse) return;
    const mus__across in = {.torso = &body->limb[MUS__LIMB_TORSO],
                            .arm = &body->limb[arm],
                            .torso_index = MUS__LIMB_TORSO,
                            .arm_index = arm,
                            .fields = body->nfield,
                            .part = body->rig.part,
                            .field = body->field,
                            .side = arm == MUS__LIMB_ARM_LEFT ? 1.0 : -1.0,
                            .back = body->asked[MUS_MEASURE_ACROSS_BACK],
                            .front = body->asked[MUS_MEASURE_ACROSS_FRONT],
                            .range = {bone->bust, bone->shoulder}};
    mus__limb_across(&in);

    /* the girths within the range are kept: rings about their contours give way */
    double turn[2 * MUS__FIELD_MOST], xy[2 * MUS__FIELD_MOST];
    int32_t work[2 * MUS__FIELD_MOST];
    for (int32_t i = 0; i < in.torso->count; i++) {
        const mus__contour *c = &in.torso->contour[i];
        if (c->girth == MUS_NONE || c->s <= in.range[0] || c->s >= in.range[1]) continue;
        for (int32_t p = 0; p < body->nfield; p++) {
            const mus__field *field = &body->field[p];
            const double ring = floor((c->s - field->s0) / field->ds + 0.5);
            if (in.part[p].limb != MUS__LIMB_TORSO || c->s < in.part[p].end[0] || c->s >= in.part[p].end[1]) continue;
            mus__field_turns(field->nangle, turn);
            const double *radius = field->radius + (ptrdiff_t)ring * field->nangle;
            const double made = mus__give_tape(field->nangle, turn, radius, xy, work);
            mus__give_scale(body, MUS__LIMB_TORSO, i, body->asked[c->girth] / made - 1.0, turn);
        }
    }
}


/* fields, fillets and details of the finished contours; then the surface, and what a tape finds on it */
static mus_status body_finish(mus_body *body)
{
    body->fillet = BODY_FILLET * body->skeleton.crown;
    mus__bones_measured(&body->skeleton, body->asked[MUS_MEASURE_FOOT], &body->bones);
    mus_status status = mus__body_fields(body, BODY_FIELD_SPACING * body->skeleton.crown);
    mus__body_find_levels(body);
    if (status == MUS_OK) body_across(body);
    if (status == MUS_OK) status = mus__body_fillets(body, body->fillet);
    if (status != MUS_OK) return status;
    status = mus__body_relief(body);
    if (status != MUS_OK) return status;
    if (mus__body_is_even(body)) mus__body_mirror(body, false);
    status = mus__body_give(body);
    if (mus__body_is_even(body)) mus__body_mirror(body, true);
    if (status == MUS_OK) status = mus__body_surface(body);
    if (status == MUS_OK && body->digit_vertices > 0) mus__digit_make(body);
    if (status == MUS_OK) status = mus__body_remeasure(body);
    return status == MUS_OK ? mus__body_lengths(body) : status;
}


static mus_status body_make(mus_body *body, const mus_tape *tape)
{
    int32_t n = body->def.samples;
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        body->asked[m] = mus_tape_value(tape, m);
        body->source[m] = mus_tape_source(tape, m);
    }
    body->measured = body->jointed = true;
    mus__skeleton_make(tape, &body->skeleton);
    mus_status status = mus__posture_check(body->context, &body->def, body->skeleton.crown);
    if (status != MUS_OK) return status;
    if (!mus__posture_none(&body->def)) mus__posture_bones(&body->def, &body->skeleton);

    double *turn = mus__new(body->context, 4 * (int64_t)n, sizeof(double));
    int32_t *work = mus__new(body->context, 2 * (int64_t)n, sizeof(int32_t));
    if (turn == NULL || work == NULL) {
        status = mus__fail_memory(body->context, "the directions of contours");
    } else {
        mus__field_turns(n, turn);
        double *xy = turn + 2 * (ptrdiff_t)n;
        status = body_add(body);
        double more = 0.0;
        for (int round = 0; round < BODY_ROUNDS && status == MUS_OK; round++) {
            const double last = body->made[MUS_MEASURE_CROTCH_LENGTH];
            mus__body_release(body);
            status = body_contours(body, tape, more, turn, xy, work);
            if (status == MUS_OK) status = body_finish(body);
            const double off = body->asked[MUS_MEASURE_CROTCH_LENGTH] - body->made[MUS_MEASURE_CROTCH_LENGTH];
            const bool stuck = round > 0 && fabs(body->made[MUS_MEASURE_CROTCH_LENGTH] - last) < 0.1 * BODY_CLOSE;
            if (body->source[MUS_MEASURE_CROTCH_LENGTH] != MUS_SOURCE_GIVEN || fabs(off) < BODY_CLOSE || stuck) break;
            more += off;
        }
    }
    mus__free(body->context, turn);
    mus__free(body->context, work);
    return status;
}


mus_status mus_body_create(mus_context *context, const mus_tape *tape, const mus_body_def *def, mus_body **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (tape == NULL) return mus__fail(context, MUS_ERR_ARG, "the tape of a body is NULL");

    mus_body_def own;
    mus_tape *copy = NULL;
    mus_body *body = NULL;
    mus_status status = mus__body_read_def(context, def, &own);
    if (status != MUS_OK) return status;
    if (!mus_tape_is_complete(tape)) {
        status = mus_tape_copy(tape, &copy);
        if (status == MUS_OK) status = mus_tape_complete(copy);
        if (status != MUS_OK) goto fail;
        tape = copy;
    }

    body = mus__new(context, 1, sizeof *body);
    if (body == NULL) {
        status = mus__fail_memory(context, "a body");
        goto fail;
    }
    body->context = context;
    body->def = own;
    status = mus__body_limbs(body, MUS__LIMB_COUNT + own.limbs);
    if (status == MUS_OK) status = body_make(body, tape);
    if (status != MUS_OK) goto fail;
    mus_tape_destroy(copy);
    *out = body;
    return MUS_OK;

fail:
    /* the tape may have another context: its message is copied to the caller's context */
    if (copy != NULL && mus_tape_context(copy) != context)
        mus__fail(context, status, "%s", mus_context_error(mus_tape_context(copy)));
    mus_tape_destroy(copy);
    mus_body_destroy(body);
    return status;
}


int32_t mus_body_limb_count(const mus_body *body)
{
    return body != NULL ? body->limb_count : 0;
}


static const mus__limb *body_limb(const mus_body *body, int32_t limb)
{
    return body != NULL && limb >= 0 && limb < body->limb_count ? &body->limb[limb] : NULL;
}


const char *mus_body_limb_name(const mus_body *body, int32_t limb)
{
    const mus__limb *found = body_limb(body, limb);
    return found != NULL ? found->name : NULL;
}


double mus_body_asked(const mus_body *body, int32_t measure)
{
    return body != NULL && measure >= 0 && measure < MUS_MEASURE_COUNT ? body->asked[measure] : NAN;
}


double mus_body_made(const mus_body *body, int32_t measure)
{
    return body != NULL && measure >= 0 && measure < MUS_MEASURE_COUNT ? body->made[measure] : NAN;
}


int32_t mus_body_source(const mus_body *body, int32_t measure)
{
    return body != NULL && measure >= 0 && measure < MUS_MEASURE_COUNT ? body->source[measure] : MUS_SOURCE_NONE;
}


int32_t mus_body_vertex_count(const mus_body *body)
{
    return body != NULL ? body->vertex_count + body->digit_vertices : 0;
}


int32_t mus_body_triangle_count(const mus_body *body)
{
    return body != NULL ? body->triangle_count + body->digit_triangles : 0;
}


const double *mus_body_vertices(const mus_body *body)
{
    if (body == NULL) return NULL;
    return body->vertices;
}


const double *mus_body_normals(const mus_body *body)
{
    if (body == NULL) return NULL;
    return body->normals;
}


const int32_t *mus_body_triangles(const mus_body *body)
{
    return body != NULL ? body->triangles : NULL;
}


mus_status mus_body_limb_range(const mus_body *body, int32_t limb, int32_t *range)
{
    if (body == NULL) return MUS_ERR_ARG;
    const mus__limb *found = body_limb(body, limb);
    if (found == NULL || range == NULL)
        return mus__fail(body->context, MUS_ERR_ARG, "limb %d is not one of 0 to %d, or range is NULL", (int)limb,
                         (int)body->limb_count - 1);
    range[0] = found->first_vertex, range[1] = found->vertices;
    range[2] = found->first_triangle, range[3] = found->triangles;
    return MUS_OK;
}


int32_t mus_body_contour_count(const mus_body *body, int32_t limb)
{
    const mus__limb *found = body_limb(body, limb);
    return found != NULL && !found->gone ? found->count : 0;
}


const char *mus_body_contour_name(const mus_body *body, int32_t limb, int32_t contour)
{
    const mus__limb *found = body_limb(body, limb);
    return contour >= 0 && contour < mus_body_contour_count(body, limb) ? found->contour[contour].name : NULL;
}


mus_status mus_body_contour_points(const mus_body *body, int32_t limb, int32_t contour, int32_t n, double *out)
{
    if (body == NULL) return MUS_ERR_ARG;
    const mus__limb *found = body_limb(body, limb);
    if (found == NULL || contour < 0 || contour >= mus_body_contour_count(body, limb))
        return mus__fail(body->context, MUS_ERR_ARG, "limb %d has no contour %d", (int)limb, (int)contour);
    if (n < 3 || out == NULL)
        return mus__fail(body->context, MUS_ERR_ARG, "%d points of a contour: at least 3, and room for them", (int)n);

    const mus__contour *c = &found->contour[contour];
    mus__frame frame;
    if (body->frame != NULL) mus__rig_ring(&body->rig, body->frame, limb, c->s, &frame);
    for (int32_t k = 0; k < n; k++) {
        double cosine = mus__cos(2.0 * MUS_PI * k / n), sine = mus__sin(2.0 * MUS_PI * k / n);
        double radius = mus__contour_radius(c, cosine, sine);
        double a = c->ca + radius * cosine, b = c->cb + radius * sine;
        for (int i = 0; i < 3; i++)
            out[3 * (ptrdiff_t)k + i] =
                found->origin[i] + a * found->side[i] + b * found->front[i] + c->s * found->axis[i];
        if (body->frame != NULL) mus__frame_point(&frame, out + 3 * (ptrdiff_t)k, out + 3 * (ptrdiff_t)k);
    }
    return MUS_OK;
}


mus_status mus_body_depth(const mus_body *body, int32_t n, const double *points, double *depth, double *normal)
{
    if (body == NULL) return MUS_ERR_ARG;
    if (n < 0 || (n > 0 && (points == NULL || depth == NULL)))
        return mus__fail(body->context, MUS_ERR_ARG, "%d points, or no room for their depths", (int)n);

    for (int32_t i = 0; i < n; i++) {
        double best = -1e30, at[3] = {0.0, 0.0, 0.0}, here[3];
        for (int32_t l = 0; l < body->nfield; l++) {
            double d = mus__field_depth(&body->field[l], points + 3 * (ptrdiff_t)i, here);
            if (d <= best) continue;
            best = d;
            memcpy(at, here, sizeof at);
        }
        depth[i] = best;
        if (normal != NULL) memcpy(normal + 3 * (ptrdiff_t)i, at, sizeof at);
    }
    return MUS_OK;
}
