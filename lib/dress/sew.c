/*
 * sew.c: mus_drape_sew(): seams pulled shut by elastic force, then welded (Metaaphanon and Kanongchaiyos 2005, 4.3).
 *
 * Gravity is off. The pull starts gently, so that panels travel to the body without folding over, and grows until the
 * last pair is closed. A pair within the collision distance is stitched: its two nodes move as one from then on, and
 * their neighbours follow as in a zip. When all pairs are stitched they are welded. With self-contact, some sheets of
 * cloth may hold the last pairs apart. They are welded all the same, and crossings are drawn apart (untangle.c), but
 * not through worn layers: a weld that leaves cloth through a worn layer is taken back, and the pull goes on to its
 * end.
 *
 * The inertia of stiff cloth is raised such that a step is as long as contact allows, and the pull with it: panels move
 * as those of a soft cloth of the same mass do.
 *
 * Pull on a pair that stands for length L of seam, d apart:  min(k d, p(t) L),  p(t) = p_end min(1, e^{(t - T)/tau}).
 *
 * Order of attempts: coarser cuts first; on a cut round the body, then with straps hung first, then straight.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "base/elementary.h"
#include "contact/hands_feet.h"
#include "drape/coarse_drape.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/diagnosis.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"

/* All numbers below are chosen; the table of `make corpus` (closed seams, crossings, seconds) shows what they change.
 */

#define CHECK_STEPS 64 /* steps of a batch */
#define SEW_SAFETY 0.7 /* the step, as a share of the bound of symplectic Euler */
#define SEW_DRAG 8.0   /* [1/s] the speed of a panel follows its pull */
#define SEW_SPEED 3.0  /* [m/s] speed limit of a node */
#define SEW_TRAVEL 0.5 /* of the clearance: way of a node at that speed in the step of stiff cloth; soft cloth goes 1 */
#define SEW_GRIP 0.5   /* of the friction: panels slide round the body, yet do not slip down a tapering limb */
#define SEW_ATTACH                                                                                                     \
    0.1 /* of the largest force of attachments: gravity is off, and a tight seam under them must close.                \
         * 0 at the armpits, where attachments would draw the garment up over the arms */

/* the pull over time */
#define RAMP_START 0.02  /* of the full pull, at the beginning */
#define RAMP_SECONDS 1.5 /* [s] of the rise to the full pull */
#define RAMP_MOST 8.0    /* times the full pull at the very end, which a tight seam needs */
#define STIFF_MOST 16.0  /* times a pair's stiffness at the end, which rules in the last millimetres */

/* the last pairs; lateness runs from 0 at the end of the rise to 1 at the end of the budget */
/* lateness from which on the cloth round the last open pairs may pass through cloth, and nothing waits for a tube */
#define PASS_LATE 0.4
#define PASS_SHARE 0.05 /* of all pairs: the last ones are no more than these, */
#define PASS_PAIRS 4.0  /* or no more than these */
#define PASS_REACH 2.5  /* spacings round an open pair */
#define NEAR_SHEETS 5.0 /* thicknesses: the largest gap that cloth alone is taken to hold open */
#define NEAR_LATE 0.3   /* lateness from which on such a gap is closed by welding */
#define CARRY_GAP 0.5   /* spacings: a narrower gap of a coarse cut is left to the finer cut */
#define CARRY_SHARE 0.5 /* of a short budget that the finer cut skips, having the coarse cut's places */

/* the way of the pull: straight; round the body; round the body, with straps pulled first */
enum { SEW_STRAIGHT, SEW_ROUND, SEW_HUNG };


/* lateness of time t in a budget of `all` seconds: 0 while the pull rises, 1 at the end */
static double lateness(double t, double all)
{
    const double late = (t - RAMP_SECONDS) / (all > RAMP_SECONDS ? all - RAMP_SECONDS : 1.0);
    return fmin(fmax(late, 0.0), 1.0);
}


/* pull at time t of that budget [N/m] */
static double pull_at(double full, double t, double all)
{
    const double rise = t / RAMP_SECONDS;
    if (rise < 1.0) return full * RAMP_START * mus__pow(1.0 / RAMP_START, rise);
    return full * mus__pow(RAMP_MOST, lateness(t, all));
}


/* sets the stiffness of all pairs, which grows with time */
static void stiffen(mus_drape *drape, double t, double all)
{
    const double k = mus__weld_pair_stiffness(drape) * mus__pow(STIFF_MOST, lateness(t, all));
    for (int32_t p = 0; p < drape->program.npair; p++) drape->program.pair[p].k = k;
}


/* number of pairs that are not stitched */
static int32_t count_open(const mus__program *program)
{
    int32_t open = 0;
    for (int32_t p = 0; p < program->npair; p++) open += !program->pair[p].stitched;
    return open;
}


/* whether a worn layer lies between the nodes of an open pair */
static bool worn_between(const mus_drape *drape)
{
    const mus__program *program = &drape->program;
    for (int32_t p = 0; p < program->npair && program->open_from > 0; p++) {
        const mus__seam_pair *pair = &program->pair[p];
        if (!pair->stitched && mus__layers_between(drape, pair->a, pair->b)) return true;
    }
    return false;
}


/* whether all pairs are within the collision distance */
static bool is_closed(const mus_drape *drape)
{
    return mus__weld_gap(drape, NULL) <= drape->def.collision_distance;
}


/* the error for seams that stayed open; worn: a worn layer lies between */
static mus_status fail_open(mus_drape *drape, bool worn)
{
    int32_t seam;
    const double gap = mus__weld_gap(drape, &seam);
    const bool far = gap >= 0.1;
    return mus__fail(drape->context, MUS_ERR_SEW, "seam %d cannot close: gap %.*f %s after %.2f s, %.1f mm allowed%s",
                     (int)seam, far ? 3 : 1, far ? gap : 1e3 * gap, far ? "m" : "mm", drape->counters.sew_time,
                     1e3 * drape->def.collision_distance, worn ? "; worn cloth lies between" : "");
}


/* marks the nodes near open pairs, which may pass through cloth from now on: cloth holds these pairs apart, and
 * untangling draws apart what crosses. Nodes of worn layers are not marked: a layer that is passed through all round
 * cannot be untangled */
static void let_pass(mus_drape *drape)
{
    mus__self_contact *self = drape->self;
    const int32_t open_from = drape->program.open_from;
    const double reach = PASS_REACH * drape->cloth->spacing;
    if (self == NULL) return;
    memset(self->pass, 0, (size_t)drape->n);
    for (int32_t p = 0; p < drape->program.npair; p++) {
        const mus__seam_pair *pair = &drape->program.pair[p];
        if (pair->stitched) continue;
        const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
        const double gap[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, far = 0.5 * mus__norm3(gap) + reach;
        for (int32_t i = 0; i < drape->n; i++) {
            const double *x = drape->x + 3 * (int64_t)i;
            const double d[3] = {x[0] - 0.5 * (a[0] + b[0]), x[1] - 0.5 * (a[1] + b[1]), x[2] - 0.5 * (a[2] + b[2])};
            self->pass[i] |= mus__cloth_layer(drape->cloth, i) >= open_from && mus__dot3(d, d) < far * far;
        }
    }
    self->invalid = 1;
}


/* whether cloth alone, a few sheets of it, holds the last pairs apart, so that welding may draw it aside. Not where
 * both nodes of a pair are fixed, nor where a worn layer lies between them */
static bool near_closed(const mus_drape *drape)
{
    const mus__program *program = &drape->program;
    if (drape->self == NULL || !(mus__weld_gap(drape, NULL) <= NEAR_SHEETS * drape->def.thickness)) return false;
    for (int32_t p = 0; p < program->npair; p++) {
        const mus__seam_pair *pair = &program->pair[p];
        if (!pair->stitched && (drape->pinned[pair->a] & drape->pinned[pair->b] & MUS__PINNED)) return false;
    }
    return !worn_between(drape);
}


/* limits the force of attachments while sewing, or lets them have all of it again */
static void share_attachments(mus_drape *drape, bool sewing)
{
    mus__attachment *attachment = drape->program.attachment;
    for (int32_t i = 0; i < drape->program.nattachment; i++)
        attachment[i].share = !sewing ? 1.0 : attachment[i].level == MUS_HOLD_ARMPIT ? 0.0 : SEW_ATTACH;
}


double mus__sew_step(mus_drape *drape)
{
    return mus__relax_step(drape, SEW_SAFETY, SEW_TRAVEL * drape->def.clearance / SEW_SPEED);
}


mus_status mus__sew_run(mus_drape *drape, mus__progress *run, double h, int32_t *steps)
{
    static const mus__relax_rule rule = {.drag = SEW_DRAG, .speed_limit = SEW_SPEED, .grip = SEW_GRIP};
    const int32_t asked = *steps;
    *steps = 0;
    mus_status status = mus__relax_ready(drape, &rule, h);
    if (status != MUS_OK) return status;
    *steps = asked;
    status = mus__relax_run(drape, run, h, steps, 0);
    mus__drape_tick(drape, *steps, h, 1);
    return status;
}


/* one batch of steps at time *t of the pull; *open gets the number of open pairs */
static mus_status sew_batch(mus_drape *drape, mus__progress *run, double *t, int32_t *open)
{
    const double all = drape->def.sew_seconds;
    stiffen(drape, *t, all);
    const double h = mus__sew_step(drape);
    drape->program.seam_pull = drape->relax.raised * pull_at(drape->def.seam_pull, *t, all);
    if (!run->sleeved && lateness(*t, all) > PASS_LATE && *open <= fmax(PASS_PAIRS, PASS_SHARE * drape->program.npair))
        let_pass(drape);
    int32_t steps = CHECK_STEPS;
    const mus_status status = mus__sew_run(drape, run, h, &steps);
    *t += steps * h;
    drape->counters.sew_time += steps * h;
    *open = count_open(&drape->program);
    return status;
}


/* pulls and stitches on this cut, from time *time of the pull on, until all pairs are closed; or, without patience,
 * until only cloth holds the last ones apart */
static mus_status sew_pull(mus_drape *drape, mus__progress *run, int32_t way, bool patient, double *time)
{
    const double all = drape->def.sew_seconds;
    const int32_t pairs = drape->program.npair;
    double t = *time;
    mus_status status = mus__drape_plane_cache(drape);
    if (status != MUS_OK) return status;
    share_attachments(drape, true);
    if (drape->scene.collider != NULL) mus__collider_spread(drape->scene.collider, false);
    if (way != SEW_STRAIGHT) mus__seam_route_start(drape);
    int32_t open = pairs, check = 0;
    while (open > 0 && t < all && !run->stop && status == MUS_OK) {
        mus__drape_publish(drape);
        if (way != SEW_STRAIGHT)
            mus__seam_route(drape, way == SEW_HUNG && t < RAMP_SECONDS, lateness(t, all) < PASS_LATE, check++);
        status = sew_batch(drape, run, &t, &open);
        if (run->stop) break;
        if (status == MUS_OK && !patient && lateness(t, all) > NEAR_LATE && near_closed(drape)) break;
        if (status == MUS_OK) mus__progress_report(run, drape, 1.0 - (double)open / pairs);
    }
    *time = t;
    drape->sim.plane_cache = NULL;
    if (drape->scene.collider != NULL) mus__collider_spread(drape->scene.collider, true);
    share_attachments(drape, false);
    if (drape->self != NULL) memset(drape->self->pass, 0, (size_t)drape->n);
    if (drape->self != NULL) drape->self->invalid = 1;
    mus__drape_publish(drape);
    if (status != MUS_OK || run->stop) return status;
    if (open > 0 && !is_closed(drape) && !near_closed(drape)) return fail_open(drape, worn_between(drape));
    int32_t strap;
    if (mus__seam_route_straps(drape, &strap) == MUS__STRAPS_OFF)
        return mus__fail(drape->context, MUS_ERR_SEW, "seam %d is under the arm, not over the shoulder, after %.2f s",
                         (int)strap, drape->counters.sew_time);
    return MUS_OK;
}


mus_status mus__sew_create(mus_drape *drape)
{
    const int64_t n3 = 3 * (int64_t)drape->n;
    if (drape->sewing.start_x != NULL) return MUS_OK;
    drape->sewing.start_x = mus__new(drape->context, 3 * n3 + drape->cloth->npanel, sizeof *drape->sewing.start_x);
    if (drape->sewing.start_x == NULL) return mus__fail_memory(drape->context, "a sewing");
    drape->sewing.unwelded_x = drape->sewing.start_x + n3;
    drape->sewing.outward = drape->sewing.unwelded_x + n3;
    drape->sewing.tube_gap = drape->sewing.outward + n3;
    return MUS_OK;
}


/* gives the memory of sewing back */
static void sew_clear(mus_drape *drape)
{
    mus__free(drape->context, drape->sewing.start_x);
    memset(&drape->sewing, 0, sizeof drape->sewing);
}


/* welds, and draws apart what crosses then. Pairs that were not closed over a worn layer are opened again where the
 * weld leaves them through it: *clear is false */
static mus_status sew_weld(mus_drape *drape, bool *clear)
{
    const int32_t worn = is_closed(drape) ? 0 : drape->program.open_from;
    mus_status status = worn > 0 ? mus__sew_create(drape) : MUS_OK;
    if (status != MUS_OK) return status;
    if (worn > 0) memcpy(drape->sewing.unwelded_x, drape->x, 3 * (size_t)drape->n * sizeof *drape->x);
    mus__weld(drape);
    status = mus__untangle(drape);
    *clear = status != MUS_OK || worn == 0 || mus__layers_crossings(drape, worn) == 0;
    if (*clear) return status;
    drape->program.open_from = worn;
    mus__weld_reopen(drape, drape->sewing.unwelded_x);
    return MUS_OK;
}


/* pulls, stitches and welds on this cut, from time t of the pull on. Where the weld leaves cloth through a worn layer,
 * the pull goes on to its end, which may close the pairs */
static mus_status sew_here(mus_drape *drape, mus__progress *run, int32_t way, double t)
{
    bool clear = true;
    mus_status status = sew_pull(drape, run, way, false, &t);
    if (status == MUS_OK && !run->stop) status = sew_weld(drape, &clear);
    if (clear) return status;
    status = sew_pull(drape, run, SEW_STRAIGHT, true, &t);
    if (status == MUS_OK && !run->stop) status = sew_weld(drape, &clear);
    return clear || status != MUS_OK || run->stop ? status : fail_open(drape, true);
}


/* on this cut from where it is, and again from there in another way where a seam stays open: round the body, with
 * straps first if there are any, straight. Over worn layers, which are round already, straight comes first */
static mus_status sew_ways(mus_drape *drape, mus__progress *run)
{
    const bool first = drape->sewing.start_x == NULL, body = drape->scene.collider != NULL;
    mus_status status = body ? mus__sew_create(drape) : MUS_OK;
    if (status != MUS_OK) return status;
    if (!body) return sew_here(drape, run, SEW_STRAIGHT, 0.0);
    mus__drape_publish(drape);
    memcpy(drape->sewing.start_x, drape->x, 3 * (size_t)drape->n * sizeof *drape->x);
    const int32_t begin = !drape->welded || run->sleeved ? SEW_ROUND : SEW_STRAIGHT;
    const bool leaves = drape->coarse.parent != NULL && drape->self != NULL;
    const double near = leaves ? CARRY_GAP * drape->cloth->spacing : 0.0;
    status = sew_here(drape, run, begin, 0.0);
    const int32_t last = drape->def.sew_once ? SEW_HUNG + 1 : SEW_STRAIGHT;
    for (int32_t way = SEW_HUNG; way >= last && status == MUS_ERR_SEW && !run->stop; way--) {
        const mus__straps straps = mus__seam_route_straps(drape, NULL);
        if (way == begin || (way == SEW_HUNG && straps == MUS__STRAPS_NONE)) continue;
        if (straps != MUS__STRAPS_OFF && mus__weld_gap(drape, NULL) < near) break;
        mus__weld_reopen(drape, drape->sewing.start_x);
        status = sew_here(drape, run, way, 0.0);
    }
    if (status == MUS_ERR_MEMORY && first) sew_clear(drape);
    return status;
}


/*
 * The coarser cut first, down to the coarsest. Where its seams were welded, the pairs of the finer cut lie as near
 * together as the coarse borders follow the fine ones, and are welded as they are. Where some could not be welded, the
 * finer cut goes on from there with self-contact: a finer cut may have room where a coarse one has none. Without
 * self-contact the finer cut tries from its own start. With def.sew_once neither is tried.
 */
static mus_status sew_cuts(mus_drape *drape, mus__progress *run)
{
    mus_drape *coarse;
    mus_status status = mus__coarse_create(drape, &coarse);
    if (status != MUS_OK) return status;
    if (coarse != NULL) {
        mus__coarse_restrict(drape);
        status = sew_cuts(coarse, run);
        if (status == MUS_ERR_MEMORY) return status;
        if (status == MUS_OK) {
            mus__coarse_prolong(drape);
            drape->coarse.as_sewn = drape->self != NULL;
            return mus__untangle(drape);
        }
        if (status == MUS_ERR_SEW && (drape->self != NULL || drape->def.sew_once)) mus__coarse_prolong(drape);
        if (drape->def.sew_once) return status;
        if (status == MUS_ERR_SEW && drape->self != NULL) {
            status = mus__untangle(drape);
            const double from = fmin(RAMP_SECONDS, CARRY_SHARE * drape->def.sew_seconds);
            return status == MUS_OK ? sew_here(drape, run, SEW_STRAIGHT, from) : status;
        }
    }
    return sew_ways(drape, run);
}


/* with self-contact, before the first sew: folds wide fans and moves coplanar panels apart */
static mus_status sew_arrange(mus_drape *drape, const mus__placed_cloth *placed)
{
    bool moved;
    if (mus__arrange_fans(placed)) mus__drape_push(drape);
    const mus_status status = mus__arrange_separate(placed, &moved);
    if (status == MUS_OK && moved) mus__drape_push(drape);
    return status;
}


mus_status mus_drape_sew(mus_drape *drape, mus_progress_fn progress, void *user)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if ((drape->welded && drape->program.open_from == 0) || drape->cloth->npair == 0) return MUS_OK;
    mus_status status = mus__scene_require_rest(drape, "sew");
    if (status != MUS_OK) return status;
    mus__progress run;
    status = mus__progress_start(&run, drape, "sew", progress, user);
    if (status != MUS_OK) return status;
    mus_reason_init(&drape->reason, sizeof drape->reason);
    const mus__placed_cloth placed = mus__drape_placed(drape);
    mus__arrange_check(&placed, &drape->start);
    if (mus__layers_needed(drape)) {
        status = mus__layers_sew(drape, &run, sew_cuts, sew_ways);
    } else {
        if (drape->self != NULL && drape->clock.count == 0) status = sew_arrange(drape, &placed);
        if (status == MUS_OK) status = sew_cuts(drape, &run);
    }
    status = mus__progress_end(&run, drape, status, drape->welded && drape->program.open_from == 0);
    mus__diagnosis_status(drape, status);
    return status;
}
