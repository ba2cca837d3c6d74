/*
 * scan_limb.c: cuts each limb of the mesh into outlines.
 *
 * The body is the union of its limbs, and each limb is the mesh between planes: the torso inside the walls of both arms
 * and above the crotch, an arm beyond its wall, a leg on its side of the middle plane and below the crotch, a foot
 * below its top. Each limb reaches into its neighbour, so that the union is the mesh wherever sections are star-shaped.
 * A section of several loops (fingers, toes) is replaced by its hull, as of a mitten.
 *
 * The distance of contours is `spacing`, or larger so that at most 128 are needed; they are closer near the ends of the
 * mesh.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

/* distance of the last contour from a flat end, in parts of the spacing; chosen: near enough to keep the end flat */
#define LIMB_FLAT 0.03
/* [m] length of the cap of a limb that ends within another one; chosen: it stays inside the other limb */
#define LIMB_CAP 0.004
/* [m] an arm reaches this far behind its wall, for a stature of 1.7 m; chosen: less leaves a gap at the shoulder */
#define LIMB_LAP 0.06
/* top of a leg above the crotch, in parts of the stature; chosen: less leaves a gap at the hip */
#define LIMB_LEG_UP 0.06
/* bottom of a leg that has a foot, above the floor, in parts of the stature; chosen: within the foot */
#define LIMB_LEG_DOWN 0.030
#define LIMB_ROUND_UP 0.011 /* the torso is rounded up to so far above the crotch, in parts of the stature, */
#define LIMB_ROUND 0.02     /* [m] by at most this; chosen: no edge where a leg is lifted */
/* shoulder joint above the armpit, in parts of the radius of the arm there; chosen: about the middle of the deltoid */
#define LIMB_SHOULDER 1.1
/* [m] an arm begins where it has a part farther out than this behind its wall; chosen: a smaller part is the chest */
#define LIMB_BARE 0.03
/* [m] depth of the upper end of a leg under the torso's skin; chosen: above the error of the depth */
#define LIMB_UNDER 0.0015

static const char *const limb_names[MUS__SCAN_LIMBS] = {"torso",     "arm_left",  "arm_right", "leg_left",
                                                       "leg_right", "foot_left", "foot_right"};

/* the state while a limb is cut */
typedef struct limb_cut {
    mus_context *context;
    const mus_scan_def *def;
    const mus__scan_found *found;
    mus__slicer *slicer;
    mus__scan_limbs *limbs;
    int32_t which, index; /* MUS__LIMB_*, and its index among the limbs */
    const mus__scan_arm *arm;
    double side;
    mus__section piece;
} limb_cut;


/* the part of the section at s that belongs to a limb, into cut->piece */
typedef mus_status limb_part(limb_cut *cut, double s);


/* group of the largest loop on one side of the middle plane; side 0: of all loops */
static int32_t limb_largest(const mus__section *section, double side, double middle)
{
    for (int32_t j = 0; j < section->loops; j++)
        if (side == 0.0 || side * (section->loop[j].centre[0] - middle) > 0.0) return section->loop[j].group;
    return -2;
}


/* torso: inside the walls of the arms above the armpits, and inside a vertical wall just below them, where folds reach
 * down */
static mus_status limb_torso(limb_cut *cut, double s)
{
    const mus__scan_found *found = cut->found;
    double plane[6];
    int32_t planes = 0;
    for (int i = 0; i < 2; i++) {
        const mus__scan_arm *arm = &found->arm[i];
        if (!arm->there || s < arm->armpit[1] - 0.03 * found->stature) continue;
        double *p = plane + 3 * (ptrdiff_t)planes++;
        p[1] = 0.0;
        if (s >= arm->armpit[1])
            p[0] = -arm->wall[0], p[2] = arm->wall[1] * s - arm->wall[3];
        else
            p[0] = -arm->side, p[2] = -arm->side * arm->armpit[0] - 0.003 * found->stature;
    }
    const int32_t group = limb_largest(&cut->slicer->section, 0.0, 0.0);
    return mus__section_take(cut->context, &cut->slicer->section, group, planes, plane, &cut->piece);
}


/* leg: on its side of the middle plane; cut there above the crotch, while thighs that touch below it stay whole */
static mus_status limb_leg(limb_cut *cut, double s)
{
    const mus__scan_found *found = cut->found;
    const bool above = s > found->crotch;
    const double plane[3] = {cut->side, 0.0, cut->side * found->middle};
    const int32_t group = limb_largest(&cut->slicer->section, above ? 0.0 : cut->side, found->middle);
    mus_status status =
        mus__section_take(cut->context, &cut->slicer->section, group, above ? 1 : 0, plane, &cut->piece);
    int32_t kept = 0;
    for (int32_t j = 0; j < cut->piece.loops && !above; j++)
        if (cut->side * (cut->piece.loop[j].centre[0] - found->middle) > 0.0)
            cut->piece.loop[kept++] = cut->piece.loop[j];
    if (!above) cut->piece.loops = kept;
    return status;
}


/* replace several groups by their hull */
static mus_status limb_mitten(limb_cut *cut)
{
    bool several = false;
    for (int32_t j = 1; j < cut->piece.loops; j++)
        several = several || cut->piece.loop[j].group != cut->piece.loop[0].group;
    return several ? mus__section_hull(cut->context, &cut->piece) : MUS_OK;
}


/* foot: below its top, on its side of the middle plane */
static mus_status limb_foot(limb_cut *cut, double s)
{
    (void)s;
    const double plane[6] = {cut->side, 0.0, cut->side * cut->found->middle, 0.0, -1.0, -cut->found->foot};
    mus_status status = mus__section_take(cut->context, &cut->slicer->section, -1, 2, plane, &cut->piece);
    return status == MUS_OK ? limb_mitten(cut) : status;
}


/* keep the loops within `spread` of the axis: all of them, or those of the nearest group */
static void limb_near(mus__section *piece, double spread, bool all)
{
    const int32_t nearest = mus__section_near(piece, spread);
    int32_t kept = 0;
    for (int32_t j = 0; j < piece->loops; j++) {
        const bool near = all ? mus__loop_distance(piece, j) <= spread : piece->loop[j].group == nearest;
        if (near) piece->loop[kept++] = piece->loop[j];
    }
    piece->loops = kept;
}


/* arm: beyond its wall, which is moved inwards by `lap` [m]; before the root also above the line of the arm's underside
 * continued into the torso. Fingers are replaced by their hull */
static mus_status limb_arm_beyond(limb_cut *cut, double s, double lap)
{
    const mus__scan_arm *arm = cut->arm;
    const mus__slicer *along = cut->slicer;
    double at[3], plane[6];
    for (int i = 0; i < 3; i++) at[i] = arm->origin[i] + s * arm->axis[i];
    for (int p = 0; p < 2; p++) {
        const double *normal = p == 0 ? arm->wall : arm->up, *armpit = arm->armpit;
        plane[3 * p] = mus__dot3(normal, along->side), plane[3 * p + 1] = mus__dot3(normal, along->front);
        plane[3 * p + 2] = mus__dot3(normal, armpit) - (p == 0 ? lap : 0.0) - mus__dot3(normal, at);
    }
    const int32_t planes = s > arm->root ? 1 : 2;
    mus_status status = mus__section_take(cut->context, &along->section, -1, planes, plane, &cut->piece);
    if (status != MUS_OK) return status;
    const bool hand = s > arm->wrist;
    limb_near(&cut->piece, (hand ? 0.06 : 0.03) * cut->found->stature, hand);
    return hand ? limb_mitten(cut) : MUS_OK;
}


/* arm at s, for limb_stack() */
static mus_status limb_arm(limb_cut *cut, double s)
{
    return limb_arm_beyond(cut, s, s > cut->arm->root ? 1.0 : LIMB_LAP * cut->found->stature / 1.7);
}


/* shrink the outline of a limb within its neighbour, so that its skin lies under the neighbour's and not on it */
static void limb_under(const limb_cut *cut, double s, int32_t corners, const double *centre, double *outline)
{
    const mus__scan_found *found = cut->found;
    const bool leg = cut->which == MUS__LIMB_LEG_LEFT || cut->which == MUS__LIMB_LEG_RIGHT;
    const double up = found->legs ? (s - found->crotch) / found->stature : INFINITY;
    double under = 0.0;
    if (leg && up > 0.0) under = LIMB_UNDER * up / LIMB_LEG_UP;

    /* the end of the torso between the legs is rounded, so that a lifted leg uncovers no edge */
    if (cut->which == MUS__LIMB_TORSO && up < LIMB_ROUND_UP) {
        const double v = 1.0 - fmax(up, 0.0) / LIMB_ROUND_UP;
        under = LIMB_ROUND * (1.0 - sqrt(1.0 - v * v));
    }
    if (!(under > 0.0)) return;
    for (int32_t k = 0; k < corners; k++, outline += 2) {
        const double r = mus__dist2(centre, outline), part = fmax(1.0 - under / r, 0.5);
        for (int i = 0; i < 2; i++) outline[i] = centre[i] + part * (outline[i] - centre[i]);
    }
}


/* append the contour at s, if the limb has a section there */
static mus_status limb_contour(limb_cut *cut, limb_part *part, double s)
{
    const int32_t corners = cut->def->corners;
    mus_limb *limb = &cut->limbs->limb[cut->index];
    double *row = cut->limbs->row[cut->index] + 6 * (ptrdiff_t)limb->contours, fill;
    double *outline = cut->limbs->outline[cut->index] + 2 * (ptrdiff_t)corners * limb->contours;
    mus_status status = mus__slice(cut->slicer, s, limb_names[cut->which]);
    if (status == MUS_OK) status = part(cut, s);
    if (status != MUS_OK || cut->piece.loops == 0) return status;

    bool made = mus__star(&cut->piece, corners, row + 1, outline, &fill);
    if (!made) {
        /* the centroid of a crescent lies outside: it is replaced by its hull */
        status = mus__section_hull(cut->context, &cut->piece);
        if (status != MUS_OK) return status;
        made = mus__star(&cut->piece, corners, row + 1, outline, &fill);
        fill = INFINITY;
    }
    if (!made) return MUS_OK;
    if (fill > 1e-3) cut->limbs->filled++;
    if (fill > 1e-3 && isfinite(fill)) cut->limbs->deepest = fmax(cut->limbs->deepest, fill);
    limb_under(cut, s, corners, row + 1, outline);
    row[0] = s;
    limb->contours++;
    return MUS_OK;
}


/* whether the end at s is flat: its section is more than 0.8 of one further in */
static mus_status limb_flat(limb_cut *cut, limb_part *part, double s, double spacing, bool *flat)
{
    double area[2] = {0.0, 0.0};
    for (int k = 0; k < 2; k++) {
        const double at = s + (k == 0 ? LIMB_FLAT : 0.3) * spacing;
        mus_status status = mus__slice(cut->slicer, at, limb_names[cut->which]);
        if (status == MUS_OK) status = part(cut, at);
        if (status != MUS_OK) return status;
        for (int32_t j = 0; j < cut->piece.loops; j++) area[k] += cut->piece.loop[j].area;
    }
    *flat = area[0] > 0.8 * area[1];
    return MUS_OK;
}


/* places s of contours from low to high [m]: closer near bare ends, where a round end curves, and at multiples of the
 * spacing between; returns their number */
static int32_t limb_places(double low, double high, double spacing, const bool *bare, const bool *flat, double *out)
{
    static const double near[] = {0.15, 0.40, 0.80};
    const int32_t ends = sizeof near / sizeof *near;
    int32_t count = 0;
    if (!bare[0]) out[count++] = low;
    if (bare[0] && flat[0]) out[count++] = low + LIMB_FLAT * spacing;
    for (int32_t k = 0; k < ends && bare[0]; k++) out[count++] = low + near[k] * spacing;
    const double last = bare[1] ? high - near[ends - 1] * spacing : high;
    for (double k = ceil(out[count - 1] / spacing + 0.25); k * spacing < last - 0.25 * spacing; k += 1.0)
        out[count++] = k * spacing;
    for (int32_t k = ends - 1; k >= 0 && bare[1]; k--)
        if (high - near[k] * spacing > out[count - 1] + 0.1 * spacing) out[count++] = high - near[k] * spacing;
    if (bare[1] && flat[1]) out[count++] = high - LIMB_FLAT * spacing;
    if (!bare[1] && high > out[count - 1]) out[count++] = high;
    return count;
}


/* contours of a limb from low to high [m]; a bare end is an end of the mesh, any other lies in a neighbour */
static mus_status limb_stack(limb_cut *cut, limb_part *part, double low, double high, bool bare_low, bool bare_high)
{
    mus_limb *limb = &cut->limbs->limb[cut->index];
    const bool bare[2] = {bare_low, bare_high};
    bool flat[2] = {false, false};
    double spacing = cut->def->spacing, place[MUS__SCAN_CONTOURS];
    if (cut->which >= MUS__LIMB_FOOT_LEFT) spacing *= 0.6;
    spacing = fmax(spacing, (high - low) / (MUS__SCAN_CONTOURS - 10));
    limb->name = limb_names[cut->which];
    memcpy(limb->origin, cut->slicer->origin, sizeof limb->origin);
    memcpy(limb->axis, cut->slicer->axis, sizeof limb->axis);
    memcpy(limb->side, cut->slicer->side, sizeof limb->side);
    limb->pole[0] = bare_low ? low : low - LIMB_CAP;
    limb->pole[1] = bare_high ? high : high + LIMB_CAP;
    limb->corners = cut->def->corners;
    limb->contour = cut->limbs->row[cut->index];
    limb->outline = cut->limbs->outline[cut->index];

    mus_status status = bare_low ? limb_flat(cut, part, low, spacing, &flat[0]) : MUS_OK;
    if (status == MUS_OK && bare_high) status = limb_flat(cut, part, high, -spacing, &flat[1]);
    const int32_t count = limb_places(low, high, spacing, bare, flat, place);
    for (int32_t k = 0; k < count && status == MUS_OK; k++) status = limb_contour(cut, part, place[k]);
    if (status == MUS_OK && limb->contours < 2)
        return mus__fail(cut->context, MUS_ERR_BODY,
                         "mesh: the %s between %.3f and %.3f m has %d sections, expected 2 or more", limb->name, low,
                         high, (int)limb->contours);
    if (status == MUS_OK) cut->limbs->count++;
    return status;
}


/* arrays for the contours of a limb MUS__LIMB_* */
static mus_status limb_room(limb_cut *cut, int32_t which)
{
    mus__scan_limbs *limbs = cut->limbs;
    cut->which = which;
    cut->index = limbs->count;
    limbs->which[cut->index] = which;
    mus_limb_init(&limbs->limb[cut->index], sizeof limbs->limb[cut->index]);
    limbs->row[cut->index] = mus__new(cut->context, 6 * MUS__SCAN_CONTOURS, sizeof(double));
    limbs->outline[cut->index] =
        mus__new(cut->context, 2 * (int64_t)MUS__SCAN_CONTOURS * cut->def->corners, sizeof(double));
    if (limbs->row[cut->index] == NULL || limbs->outline[cut->index] == NULL)
        return mus__fail_memory(cut->context, "the contours of a mesh");
    return MUS_OK;
}


/* s [m] from which on the arm has a part outside the torso */
static mus_status limb_arm_start(limb_cut *cut, double *start)
{
    const mus__scan_arm *arm = cut->arm;
    mus_status status = MUS_OK;
    *start = arm->root;
    for (double s = arm->root; status == MUS_OK && s > arm->root - 0.25 * cut->found->stature;
         s -= 0.25 * cut->def->spacing) {
        status = mus__slice(cut->slicer, s, limb_names[cut->which]);
        if (status == MUS_OK) status = limb_arm_beyond(cut, s, LIMB_BARE * cut->found->stature / 1.7);
        if (status != MUS_OK || cut->piece.loops == 0) break;
        *start = s;
    }
    return status;
}


/* s of the shoulder joint on the arm's axis [m]: of a horizontal arm at the section of the armpit, of a hanging arm
 * before it by the height of the joint above the armpit. For a body of a tape in a T-pose it is right to 1 cm; the axis
 * of bent arms, such as those of GarmentCode's mean bodies, passes 4 to 5 cm below the joint */
static mus_status limb_shoulder(limb_cut *cut, double *shoulder)
{
    const double s = cut->arm->root + 0.1 * cut->def->spacing;
    mus_status status = mus__slice(cut->slicer, s, limb_names[cut->which]);
    if (status == MUS_OK) status = limb_arm(cut, s);
    if (status != MUS_OK) return status;
    double area = 0.0;
    for (int32_t j = 0; j < cut->piece.loops; j++) area += cut->piece.loop[j].area;
    *shoulder = cut->arm->root - LIMB_SHOULDER * fmax(-cut->arm->axis[1], 0.0) * sqrt(area / MUS_PI);
    return MUS_OK;
}


/* cut arm i, 0 left, 1 right */
static mus_status limb_cut_arm(limb_cut *cut, const mus__scan_mesh *mesh, int i, mus_scan_report *report)
{
    mus__slicer along;
    double start = 0.0;
    cut->arm = &cut->found->arm[i];
    mus_status status = limb_room(cut, MUS__LIMB_ARM_LEFT + i);
    if (status != MUS_OK) return status;
    status = mus__slicer_make(mesh, cut->arm->origin, cut->arm->axis, cut->arm->across, cut->def->gap, &along);
    if (status != MUS_OK) return status;
    cut->slicer = &along;
    status = limb_arm_start(cut, &start);
    if (status == MUS_OK) status = limb_shoulder(cut, &cut->limbs->shoulder[i]);
    if (status == MUS_OK) status = limb_stack(cut, limb_arm, start, cut->arm->tip, false, true);
    report->holes += along.holes;
    report->widest_hole = fmax(report->widest_hole, along.widest);
    mus__slicer_free(&along);
    return status;
}


/* cut both feet from heel to toe, which are the ends of the mesh below the top of the foot */
static mus_status limb_cut_feet(limb_cut *cut, const mus__scan_mesh *mesh, mus_scan_report *report)
{
    const double origin[3] = {0.0, 0.0, 0.0}, axis[3] = {0.0, 0.0, 1.0}, side[3] = {1.0, 0.0, 0.0};
    mus__slicer ahead;
    mus_status status = mus__slicer_make(mesh, origin, axis, side, cut->def->gap, &ahead);
    if (status != MUS_OK) return status;
    for (int i = 0; i < 2 && status == MUS_OK; i++) {
        double low = INFINITY, high = -INFINITY;
        cut->side = i == 0 ? 1.0 : -1.0;
        for (int32_t v = 0; v < mesh->vertices; v++) {
            const double *x = mesh->x + 3 * (ptrdiff_t)v;
            if (x[1] > cut->found->foot || cut->side * (x[0] - cut->found->middle) < 0.0) continue;
            low = fmin(low, x[2]), high = fmax(high, x[2]);
        }
        cut->slicer = &ahead;
        status = limb_room(cut, MUS__LIMB_FOOT_LEFT + i);
        if (status == MUS_OK) status = limb_stack(cut, limb_foot, low, high, true, true);
    }
    report->holes += ahead.holes;
    report->widest_hole = fmax(report->widest_hole, ahead.widest);
    mus__slicer_free(&ahead);
    return status;
}


/* cut all limbs that the mesh has */
static mus_status limb_cut_all(limb_cut *cut, const mus__scan_mesh *mesh, mus__slicer *upright, mus_scan_report *report)
{
    const mus__scan_found *found = cut->found;
    cut->slicer = upright;
    mus_status status = limb_room(cut, MUS__LIMB_TORSO);
    if (status == MUS_OK)
        status = limb_stack(cut, limb_torso, found->legs ? found->crotch : upright->low, upright->high, true, true);
    for (int i = 0; i < 2 && status == MUS_OK; i++)
        if (found->arm[i].there) status = limb_cut_arm(cut, mesh, i, report);
    for (int i = 0; i < 2 && status == MUS_OK && found->legs; i++) {
        const bool foot = found->foot > 0.0;
        cut->side = i == 0 ? 1.0 : -1.0;
        cut->slicer = upright;
        status = limb_room(cut, MUS__LIMB_LEG_LEFT + i);
        if (status != MUS_OK) break;
        status = limb_stack(cut, limb_leg, foot ? LIMB_LEG_DOWN * found->stature : upright->low,
                            found->crotch + LIMB_LEG_UP * found->stature, !foot, false);
    }
    return status == MUS_OK && found->legs && found->foot > 0.0 ? limb_cut_feet(cut, mesh, report) : status;
}


mus_status mus__scan_cut(const mus__scan_mesh *mesh, const mus_scan_def *def, mus__slicer *upright,
                         const mus__scan_found *found, mus_scan_report *report, mus__scan_limbs *out)
{
    limb_cut cut = {.context = mesh->context, .def = def, .found = found, .limbs = out};
    mus_status status = limb_cut_all(&cut, mesh, upright, report);
    report->holes += upright->holes;
    report->widest_hole = fmax(report->widest_hole, upright->widest);
    report->filled = out->filled, report->deepest_fill = out->deepest;
    for (int32_t l = 0; l < out->count; l++) report->contours += out->limb[l].contours;
    mus__section_free(mesh->context, &cut.piece);
    return status;
}


void mus__scan_limbs_free(mus_context *context, mus__scan_limbs *limbs)
{
    for (int l = 0; l < MUS__SCAN_LIMBS; l++) {
        mus__free(context, limbs->row[l]);
        mus__free(context, limbs->outline[l]);
    }
    memset(limbs, 0, sizeof *limbs);
}
