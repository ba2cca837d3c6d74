/*
 * sew.c: seams pulled shut by elastic force, then welded (paper 4.3).
 *
 * Gravity is off. The pull starts gentle, so that panels travel to the body without folding over, and grows until the
 * last pair is home; a pair within the collision distance is stitched: it moves as one from then on, and its
 * neighbours follow as in a zip. When all are stitched they are welded. Where cloth meets cloth, some sheets of it may
 * hold the last pairs apart; they are welded so, and what then crosses is drawn apart (untangle.c). Not through worn
 * layers: a weld that leaves cloth through those is taken back, and the pull goes on to its end.
 *
 * Pull on a pair that stands for length L of seam:  min(k d, p(t) L),  p(t) = p_end min(1, e^{(t - T)/tau}).
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "drape/coarse_drape.h"
#include "drape/diagnosis.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "geom/vec.h"

#define CHECK_STEPS 64
#define SAFETY 0.7      /* of the bound of symplectic Euler, 2/2.62 of that of RK4 */
#define SEW_DRAG 8.0    /* [1/s]: a panel's speed follows its pull */
#define SEW_SPEED 3.0   /* [m/s] limit: a step then moves a node less than the clearance */
#define SEW_GRIP 0.5    /* of the friction: panels slide round the body, yet do not slip down a tapering limb */
#define RAMP_START 0.02 /* of the full pull at the beginning */
#define RAMP_SECONDS 1.5
#define RAMP_MOST 8.0   /* times the full pull at the very end: a tight seam gets what it needs */
#define STIFF_MOST 16.0 /* times a pair's stiffness at the end: in the last millimetres that is what pulls */
#define SEW_HOLD                                                                                                       \
    0.1               /* of what held edges pull with: gravity is off, and a tight seam under them must close. Nothing \
                         at the armpits: it would go up over the arms */
#define PASS_LATE 0.4 /* of the budget past the rise: pairs still open may be drawn through cloth */
#define PASS_PART 0.05  /* of all pairs, when there are no more than these */
#define PASS_LEAST 4.0  /* or these */
#define NEAR_SHEETS 5.0 /* thicknesses */
#define NEAR_LATE 0.3   /* of the budget past the rise: a gap of so little is closed by welding */
#define CARRY_GAP 0.5   /* spacings: narrower gaps are left to the finer cut */
#define CARRY_PART 0.5  /* of a short budget: the finer cut has the rest */
#define PASS_REACH 2.5  /* spacings round an open pair */


/* the way of pairs: straight; round what is between; so, and what straps hang by first */
enum { SEW_STRAIGHT, SEW_ROUND, SEW_HUNG };


/* how late it is at time t of a budget of `all` seconds: 0 while the pull rises, 1 at the end */
static double lateness(double t, double all)
{
    const double late = (t - RAMP_SECONDS) / (all > RAMP_SECONDS ? all - RAMP_SECONDS : 1.0);
    return fmin(fmax(late, 0.0), 1.0);
}


/* pull at time t of that budget [N/m] */
static double pull_at(double full, double t, double all)
{
    const double rise = t / RAMP_SECONDS;
    if (rise < 1.0) return full * RAMP_START * pow(1.0 / RAMP_START, rise);
    return full * pow(RAMP_MOST, lateness(t, all));
}


/* pairs that are nearly home and tight get stiffer with time */
static void stiffen(mus_drape *drape, double t, double all)
{
    const double k = mus__weld_pair_stiffness(drape) * pow(STIFF_MOST, lateness(t, all));
    for (int32_t p = 0; p < drape->program.npair; p++) drape->program.pair[p].k = k;
}


static int32_t count_open(const mus__program *program)
{
    int32_t open = 0;
    for (int32_t p = 0; p < program->npair; p++) open += !program->pair[p].stitched;
    return open;
}


/* does worn cloth lie between the nodes of a pair that is open? */
static bool worn_between(const mus_drape *drape)
{
    const mus__program *program = &drape->program;
    for (int32_t p = 0; p < program->npair && program->open_from > 0; p++) {
        const mus__seam_pair *pair = &program->pair[p];
        if (!pair->stitched && mus__layers_between(drape, pair->a, pair->b)) return true;
    }
    return false;
}


/* are all pairs within the collision distance? */
static bool is_home(const mus_drape *drape)
{
    return mus__weld_gap(drape, NULL) <= drape->def.collision_distance;
}


/* the sentence for seams that stayed open */
static mus_status fail_open(mus_drape *drape, bool worn)
{
    int32_t seam;
    const double gap = mus__weld_gap(drape, &seam);
    const bool far = gap >= 0.1;
    return mus__fail(drape->context, MUS_ERR_SEW, "seam %d cannot close: gap %.*f %s after %.2f s, %.1f mm allowed%s",
                     (int)seam, far ? 3 : 1, far ? gap : 1e3 * gap, far ? "m" : "mm", drape->counters.sew_time,
                     1e3 * drape->def.collision_distance, worn ? "; worn cloth lies between" : "");
}


/* cloth near the last pairs may go through cloth: it is what holds them apart; untangling has the rest. Not through
 * layers that are worn: what is drawn through those all round is not untangled */
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


/* whether cloth alone, a few sheets of it, still holds the last pairs apart: welding draws it aside. Not where both
 * nodes of a pair are held: they stay where they are, and the seam is open. Nor where worn cloth lies between them: it
 * would be gone through, and what is through it all round is not untangled */
static bool near_home(const mus_drape *drape)
{
    const mus__program *program = &drape->program;
    if (drape->self == NULL || !(mus__weld_gap(drape, NULL) <= NEAR_SHEETS * drape->def.thickness)) return false;
    for (int32_t p = 0; p < program->npair; p++) {
        const mus__seam_pair *pair = &program->pair[p];
        if (!pair->stitched && (drape->pinned[pair->a] & drape->pinned[pair->b] & MUS__PINNED)) return false;
    }
    return !worn_between(drape);
}


/* pull and stitch on this cut, as from time *time of the pull, until all pairs are home; or, not `patient`, until only
 * cloth holds the last ones apart */
static mus_status sew_pull(mus_drape *drape, mus__progress *run, int32_t way, bool patient, double *time)
{
    mus__sim *sim = &drape->sim;
    const double all = drape->def.sew_seconds;
    double t = *time;
    mus_status status = mus__drape_plane_cache(drape);
    if (status != MUS_OK) return status;
    memset(sim->gravity, 0, sizeof sim->gravity);
    sim->drag = SEW_DRAG;
    sim->speed_limit = SEW_SPEED;
    sim->dashpots = 0;
    for (int32_t i = 0; i < drape->program.nattachment; i++)
        drape->program.attachment[i].share = drape->program.attachment[i].level == MUS_HOLD_ARMPIT ? 0.0 : SEW_HOLD;
    if (way != SEW_STRAIGHT) mus__seam_route_start(drape);

    const int32_t pairs = drape->program.npair;
    int32_t open = pairs, check = 0;
    while (open > 0 && t < all && !run->stop && status == MUS_OK) {
        mus__drape_publish(drape);
        if (way != SEW_STRAIGHT) mus__seam_route(drape, way == SEW_HUNG && t < RAMP_SECONDS, check++);
        stiffen(drape, t, all);
        const double h = SAFETY * (2.0 / 2.62) * mus__drape_inertia(drape, 1), travel = SEW_SPEED * h;
        sim->rule = (mus__contact_rule){.clearance = drape->def.clearance,
                                        .friction = SEW_GRIP * drape->scene.friction,
                                        .push = 2.0 * travel,
                                        .travel = travel,
                                        .slip = h,
                                        .step = h,
                                        .cache_radius = MUS__CACHE_RADIUS,
                                        .slick = 1.0 - SEW_GRIP};
        drape->program.seam_pull = pull_at(drape->def.seam_pull, t, all);
        if (!run->sleeved && lateness(t, all) > PASS_LATE && open <= fmax(PASS_LEAST, PASS_PART * pairs))
            let_pass(drape);
        status = mus__drape_self_ready(drape, h);
        if (status != MUS_OK) break;
        for (int32_t i = 0; i < CHECK_STEPS; i++) sim->ops->euler(sim, h);
        status = mus__drape_keep_good(drape);
        if (status == MUS_OK) status = mus__drape_self_fits(drape);
        mus__drape_tick(drape, CHECK_STEPS, h, 1);
        t += CHECK_STEPS * h;
        drape->counters.sew_time += CHECK_STEPS * h;
        open = count_open(&drape->program);
        if (!patient && lateness(t, all) > NEAR_LATE && near_home(drape)) break;
        mus__progress_report(run, 1.0 - (double)open / pairs);
    }
    *time = t;
    sim->plane_cache = NULL;
    for (int32_t i = 0; i < drape->program.nattachment; i++) drape->program.attachment[i].share = 1.0;
    if (drape->self != NULL) memset(drape->self->pass, 0, (size_t)drape->n);
    if (drape->self != NULL) drape->self->invalid = 1;
    mus__drape_publish(drape);
    if (status != MUS_OK || run->stop) return status;
    if (open > 0 && !is_home(drape) && !near_home(drape)) return fail_open(drape, worn_between(drape));
    int32_t strap;
    if (mus__seam_route_straps(drape, &strap) == MUS__STRAPS_OFF)
        return mus__fail(drape->context, MUS_ERR_SEW, "seam %d is under the arm, not over the shoulder, after %.2f s",
                         (int)strap, drape->counters.sew_time);
    return MUS_OK;
}


/* the memory of sewing, kept until the drape is destroyed; give it back */
mus_status mus__sew_create(mus_drape *drape)
{
    const int64_t n3 = 3 * (int64_t)drape->n;
    if (drape->sewing.start_x != NULL) return MUS_OK;
    drape->sewing.start_x = mus__new(drape->context, 3 * n3, sizeof *drape->sewing.start_x);
    if (drape->sewing.start_x == NULL) return mus__fail_memory(drape->context, "a sewing");
    drape->sewing.unwelded_x = drape->sewing.start_x + n3;
    drape->sewing.outward = drape->sewing.unwelded_x + n3;
    return MUS_OK;
}


static void sew_clear(mus_drape *drape)
{
    mus__free(drape->context, drape->sewing.start_x);
    memset(&drape->sewing, 0, sizeof drape->sewing);
}


/* weld, and draw apart what then crosses. Pairs that were not home over what is worn are opened again where that leaves
 * them through it: *clear is false */
static mus_status sew_weld(mus_drape *drape, bool *clear)
{
    const int32_t worn = is_home(drape) ? 0 : drape->program.open_from;
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


/* pull, stitch and weld on this cut, as from time `t` of the pull. Where the weld leaves cloth through worn cloth, the
 * pull goes on to its end, which may bring the pairs home */
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


/* on the cut at hand from where it is, then again from there in another way where that does not close a seam: round
 * what is between, straps first if there are any, straight. Over what is worn, which is round enough, straight first */
static mus_status sew_tries(mus_drape *drape, mus__progress *run)
{
    const bool first = drape->sewing.start_x == NULL, body = drape->scene.collider != NULL;
    mus_status status = body ? mus__sew_create(drape) : MUS_OK;
    if (status != MUS_OK) return status;
    if (!body) return sew_here(drape, run, SEW_STRAIGHT, 0.0);
    mus__drape_publish(drape);
    memcpy(drape->sewing.start_x, drape->x, 3 * (size_t)drape->n * sizeof *drape->x);
    const int32_t begin = !drape->welded || run->sleeved ? SEW_ROUND : SEW_STRAIGHT;
    const double near = drape->coarse.parent != NULL && drape->self != NULL ? CARRY_GAP * drape->cloth->spacing : 0.0;
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
 * On the coarser cut first, down to the coarsest; where its seams were welded, the finer cut's pairs lie together as
 * near as the coarse borders follow the fine ones, and are welded as they are. Where some could not be, the finer cut
 * goes on from there if cloth meets cloth: what a coarse cut has no room for, a finer one may have. Where cloth may go
 * through cloth, the finer cut tries from its own start. With def.sew_once neither is tried.
 */
static mus_status sew_levels(mus_drape *drape, mus__progress *run)
{
    mus_drape *coarse;
    mus_status status = mus__coarse_create(drape, &coarse);
    if (status != MUS_OK) return status;
    if (coarse != NULL) {
        mus__coarse_restrict(drape);
        status = sew_levels(coarse, run);
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
            const double from = fmin(RAMP_SECONDS, CARRY_PART * drape->def.sew_seconds);
            return status == MUS_OK ? sew_here(drape, run, SEW_STRAIGHT, from) : status;
        }
    }
    return sew_tries(drape, run);
}


mus_status mus_drape_sew(mus_drape *drape, mus_progress_fn progress, void *user)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if ((drape->welded && drape->program.open_from == 0) || drape->cloth->npair == 0) return MUS_OK;
    const mus_status status = mus__scene_require_rest(drape, "sew");
    if (status != MUS_OK) return status;
    mus__progress run;
    mus__progress_start(&run, "sew", progress, user);
    mus_reason_init(&drape->reason, sizeof drape->reason);
    const mus__placed_cloth placed = mus__drape_placed(drape);
    mus__arrange_check(&placed, &drape->start);
    mus_status done = MUS_OK;
    if (mus__layers_needed(drape)) {
        done = mus__layers_sew(drape, &run, sew_levels, sew_tries);
    } else {
        if (drape->self != NULL && drape->clock.count == 0) {
            bool moved;
            if (mus__arrange_fans(&placed)) mus__drape_push(drape);
            done = mus__arrange_separate(&placed, &moved);
            if (done == MUS_OK && moved) mus__drape_push(drape);
        }
        if (done == MUS_OK) done = sew_levels(drape, &run);
    }
    mus__diagnosis_status(drape, done);
    return done;
}
