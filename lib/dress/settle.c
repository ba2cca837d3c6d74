/*
 * settle.c: mus_drape_settle(): relaxation to rest under gravity, coarse to fine.
 *
 * A cloth that is far from rest falls on its coarsest cut first; each finer cut starts where the coarser one came to.
 * On each cut: relaxation (dynamic_relaxation.c) with a drag that is critical for the slowest motion left, measured
 * from check to check. Kinetic damping, which halts all nodes at peaks of the kinetic energy, was measured and dropped:
 * it let cloth slip that friction holds (by 9 mm on the T-shirt). After the fall the nodes have inertia tensors
 * (drape/inertia.c), but not with self-contact: quick nodes beside sheets that touch kept a long skirt trembling.
 *
 * A cloth is at rest when two things are small at the mean place of the last steps, in which the rounding of a float
 * state averages out:
 *
 *   residual   the force that springs, gravity, contact and friction leave at a node over its weight, rms over nodes
 *   drift      the speed of the mean place from one check to the next, of the fastest node
 *
 * In float, where stiff cloth feels its own rounding, a residual within that rounding and a slower drift end a settle
 * as well. Energy never decides. A component that leaves its place on the body ends the run (slid_off.c).
 *
 * Where cloth lies on cloth, a step of h brings the two nearer by h^2 F/m and contact takes that back: places ripple by
 * that distance, and forces with them. The mean is then taken over a time, not over a number of steps, and a residual
 * that no longer falls halves the step, and at the smallest step doubles the time of the mean, over which what trembles
 * averages out. A cloth that lies still with force left halves it too. When little force is left and the cloth still
 * drifts, or goes on in the direction in which it came, the step is doubled again; where that brings the ripples back,
 * it takes twice as long the next time. A cloth that is caught on a hook (much force left, none lost, no drift, the
 * smallest step) is given up early.
 *
 * Nodes alone meet the skin. Where it bulges between them they are lifted until their triangles are off it too
 * (chord_lift.c), and before the first step cloth that a hand or a foot goes through is drawn off over its end
 * (draw_off.c).
 *
 * Two sheets of full thickness and the skin on both sides may have no room, as between the legs. The thickness of nodes
 * there, and of those that cloth presses deep into the body, yields near rest. It does not yield while seams close,
 * because cloth that is drawn through a narrow place needs all of it.
 */
#include <math.h>
#include <string.h>

#include "drape/coarse_drape.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/chord_lift.h"
#include "dress/diagnosis.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"

/* All numbers below are chosen; the table of `make corpus` (at rest, crossings, seconds) shows what they change. */

#define CHECK_SECONDS 0.1 /* [s] of cloth time between two checks */
/* full steps between two checks after the fall, at most, and as many more of smaller steps: those of stiff cloth are
 * 10 us */
#define CHECK_STEPS_MOST 512
#define MEAN_STEPS 96     /* steps averaged before a check: all of them, since a sample would alias with ripples */
#define MEAN_SECONDS 0.05 /* [s] averaged instead where cloth lies on cloth */
#define LONGEST_CHECK 8   /* times as long, both, at most, where cloth trembles on cloth with the smallest step */

/* the step, as a share of the bound of symplectic Euler */
#define SAFETY_STEP 0.75  /* the largest */
#define RIPPLE_SAFETY 0.2 /* the smallest while ripples leave more than RIPPLE_FAR times the residual allowed */
#define LEAST_SAFETY 0.1  /* the smallest otherwise */
#define RIPPLE_FAR 10.0   /* times the residual allowed: far from equilibrium */
#define STILL_CHECKS 4    /* checks with force left and none lost, after which the step is halved */
#define MOVING_CHECKS 3   /* checks with motion and no rest, after which the step is doubled for the first time */
#define STUCK_CHECKS 12   /* checks caught on a hook, after which the run is given up */
#define PART_CHECKS 20    /* checks in which frozen nodes are put apart, at most */
#define STALE_SHARE 0.9   /* of the least residual so far: a larger residual counts as no gain */

#define SETTLE_SPEED 4.0 /* [m/s] speed limit of a node */
#define LAYER_PUSH_SPEED                                                                                               \
    0.1 /* [m/s] with self-contact, at which a node leaves the body: cloth between body and cloth                      \
         * is shaken when it leaves faster */
#define LAYER_DEEP_RATE 100.0 /* [1/s] additional speed over depth of a node deeper than MUS__CACHE_DEEP */
#define LOOSE_SECONDS 1.0     /* [s] of cloth time in which a loose garment drops onto the body */

#define FALL_SECONDS 0.8 /* [s] of cloth time that cloth falls first */
#define FALL_DRAG 4.0    /* [1/s] meanwhile: near critical for the swing of a garment */
#define START_DRAG 20.0  /* [1/s] of a cloth near rest, before the first measurement; and the most on cloth */
#define DRAG_LEAST 1.0   /* [1/s] */
#define DRAG_GROWTH 1.5  /* largest growth of the drag from one check to the next */
#define DRAG_FALL 0.75   /* factor where nothing is to be damped, down to FALL_DRAG */
#define DRAG_STEP 1e-3   /* share of its speed that cloth loses in a step at least there, with tensors */

#define REST_DRIFT 0.002 /* [m/s] drift at rest */
#define GIVE_DRIFT 0.02  /* [m/s] below it thickness may yield; faster, springs press through the cloth that is left */
/* [s] of cloth time after the fall in which lifts are taken anew at each check: then cloth lies nearly, and they are
 * taken where it would be at rest */
#define LIFT_SECONDS 1.5
#define ROUNDING_DRIFT 0.25 /* of the drift allowed, by the rule of rounding */

/* a coarse cut gives the place, not the folds */
#define ROUGH_RESIDUAL 0.1 /* of a node's weight */
#define ROUGH_DRIFT 0.01   /* [m/s] */
#define ROUGH_SECONDS 4.0  /* [s] on the coarsest cut, fall included */
#define MIDDLE_SECONDS 0.6 /* [s] on the cuts between */

/* the goal on one cut */
typedef struct settling {
    double fall;            /* time of falling first [s] */
    double seconds;         /* budget of cloth time [s] */
    double residual, drift; /* at rest; [m/s] */
} settling;

/* how the cloth lies, from check to check */
typedef struct lying {
    double drag;    /* from now on [1/s] */
    double h;       /* step of the last batch [s] */
    bool tensors;   /* that batch had inertia tensors */
    double move;    /* farthest move of a mean place since the check before [m] */
    double drift;   /* that over the time between [m/s] */
    double best;    /* least residual since the step was halved */
    double safety;  /* share of the bound, for the steps */
    int32_t longer; /* a check takes so many times CHECK_SECONDS: what trembles averages out */
    int32_t still;  /* checks with force left and nothing gained */
    int32_t stuck;  /* checks caught on a hook */
    int32_t parted; /* checks with frozen nodes */
    int32_t moving; /* checks with the residual reached, or on the way, but not at rest */
    int32_t wait;   /* so many of them, and the step is doubled: twice as many each time that it is halved again */
    bool tried;     /* it was doubled since it was halved */
} lying;


/* whether cloth lies on cloth */
static bool on_cloth(const mus_drape *drape)
{
    return drape->self != NULL && drape->self->close > 0;
}


/* whether other cloth gave the node force in the steps of the last mean */
static bool touches_cloth(const mus_drape *drape, int32_t i)
{
    double force[3] = {0.0};
    return mus__drape_self_force(drape, i, force) != 0;
}


/* d.M d for a tensor m of xx, yy, zz, xy, yz, zx */
static double tensor_square(const double *m, const double *d)
{
    return m[0] * d[0] * d[0] + m[1] * d[1] * d[1] + m[2] * d[2] * d[2] +
           2.0 * (m[3] * d[0] * d[1] + m[4] * d[1] * d[2] + m[5] * d[2] * d[0]);
}


/*
 * Drag [1/s] that is critical for the slowest motion left; `now` is the drag so far, h the step [s]. Between two checks
 * the mean place moved by d and the force left changed by g. The Rayleigh quotient  w^2 = - d.g / d.M d, M the inertia
 * of the steps, is a mean of the squared rates of what moved, weighted by how far it moved, so that slow motion rules
 * it; critical drag is 2 w (Underwood 1983). It grows slowly: quick ripples after a change of cut must not freeze the
 * folds. Nodes that touch cloth are left out, because contact is stiffer than any motion to be damped; where cloth lies
 * on cloth the drag is at most START_DRAG, because ripples look like quick motion. Where nodes moved along with their
 * force (a fold that snaps over) there is nothing to measure: the drag falls towards FALL_DRAG, or, with tensors, whose
 * soft directions are quick, it takes DRAG_STEP of the speed in a step at least.
 */
static double critical_drag(const mus_drape *drape, bool tensors, double h, double now)
{
    const mus__relaxation *relax = &drape->relax;
    double work = 0.0, moved = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        double d[3];
        if (drape->mass[i] <= 0.0 || drape->pinned[i] || touches_cloth(drape, i)) continue;
        for (int32_t k = 0; k < 3; k++) {
            const int64_t at = 3 * (int64_t)i + k;
            d[k] = relax->mean[at] - relax->before[at];
            work -= d[k] * (relax->force[at] - relax->left[at]);
        }
        moved += tensors ? tensor_square(relax->inertia + 6 * (int64_t)i, d)
                         : drape->mass[i] * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    if (!(moved > 0.0)) return now;
    if (!(work > 0.0)) return tensors ? fmax(now, DRAG_STEP / h) : fmax(DRAG_FALL * now, fmin(now, FALL_DRAG));
    const double most = on_cloth(drape) ? fmin(DRAG_GROWTH * now, START_DRAG) : DRAG_GROWTH * now;
    return fmin(fmax(2.0 * sqrt(work / moved), DRAG_LEAST), most);
}


/* largest distance [m] of a node between the places a and b (n x 3) */
static double farthest(const mus_drape *drape, const double *a, const double *b)
{
    double most2 = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        double far2 = 0.0;
        for (int64_t k = 3 * (int64_t)i; k < 3 * (int64_t)i + 3; k++) far2 += (a[k] - b[k]) * (a[k] - b[k]);
        if (drape->mass[i] > 0.0 && far2 > most2) most2 = far2;
    }
    return sqrt(most2);
}


/* whether the mean place went on since the check before in the direction in which it came there, within 45 degrees by
 * the masses: cloth on its way. What trembles comes back. Keeps the move for the next check */
static bool goes_on(const mus_drape *drape)
{
    const mus__relaxation *relax = &drape->relax;
    double along = 0.0, now2 = 0.0, last2 = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        for (int64_t k = 3 * (int64_t)i; k < 3 * (int64_t)i + 3; k++) {
            const double move = relax->mean[k] - relax->before[k], last = relax->went[k];
            along += drape->mass[i] * move * last;
            now2 += drape->mass[i] * move * move, last2 += drape->mass[i] * last * last;
            relax->went[k] = move;
        }
    }
    return along > 0.0 && along * along > 0.5 * now2 * last2;
}


/* copies places or forces (n x 3) */
static void settle_keep(const mus_drape *drape, const double *from, double *to)
{
    memcpy(to, from, 3 * (size_t)drape->n * sizeof *to);
}


/* distance [m] still to go if moves go on shrinking as from `last` to `move`; ten moves when they do not shrink */
static double expected_distance(double move, double last)
{
    const double ratio = last > 0.0 ? move / last : 1.0;
    return ratio < 0.9 ? move * ratio / (1.0 - ratio) : 10.0 * move;
}


/* the step of the next batch: halved where a smaller step may take force away, doubled where the cloth still moves.
 * gains: the residual fell; gives: some thickness yielded; goes: the cloth is on its way */
static void choose_safety(const mus_drape *drape, const settling *goal, double t, bool gains, bool gives, bool goes,
                          lying *now)
{
    const double residual = drape->relax.residual;
    const bool ripples = on_cloth(drape) && t > goal->fall && goal->residual < ROUGH_RESIDUAL && !goes;
    now->still = now->drift <= goal->drift || (ripples && !gains) ? now->still + 1 : 0;
    if (gains || t <= goal->fall) now->best = residual;
    now->moving = (residual <= goal->residual || goes) && now->drift > goal->drift ? now->moving + 1 : 0;
    const double least = ripples && residual > RIPPLE_FAR * goal->residual ? RIPPLE_SAFETY : LEAST_SAFETY;
    if (now->moving >= now->wait && now->safety < SAFETY_STEP) {
        now->safety *= 2.0;
        now->moving = 0;
        now->tried = true;
    } else if (now->still >= STILL_CHECKS && now->safety > least) {
        now->safety *= 0.5;
        if (now->tried) now->wait *= 2;
        now->tried = false;
        now->still = 0;
        now->best = residual;
    } else if (now->still >= STILL_CHECKS && ripples && now->longer < LONGEST_CHECK) {
        now->longer *= 2;
        now->still = 0;
    }
    const bool caught = residual > RIPPLE_FAR * goal->residual && now->drift <= goal->drift && now->safety <= least;
    now->stuck = caught && !gives && !gains ? now->stuck + 1 : 0;
}


/* lifts nodes off the skin for the sake of the triangles between them. On a coarse cut it is done over hands and feet
 * alone, which would come through it: elsewhere the finer cut lies nearer to the skin. Nonzero when one rose by more
 * than what a triangle is to be off the skin: the cloth is not at rest then */
static bool lift_nodes(mus_drape *drape, const settling *goal, double t)
{
    const bool rest = t > goal->fall + LIFT_SECONDS, thin = goal->residual >= ROUGH_RESIDUAL;
    if (drape->sim.lift == NULL || (rest && !drape->relax.settled)) return false;
    const double rise = mus__chord_lift(drape, drape->relax.mean, thin, rest);
    return rise > MUS__LIFT_CLEAR;
}


/* a check after steps that took `seconds`, `t` in all: how the cloth lies, whether it is at rest, steps and drag from
 * now on */
static void check_rest(mus_drape *drape, const settling *goal, double t, double seconds, lying *now)
{
    mus__relaxation *relax = &drape->relax;
    relax->residual = mus__residual(drape, relax->mean);
    now->drag = t < goal->fall ? FALL_DRAG : critical_drag(drape, now->tensors, now->h, now->drag);
    const double last = now->move;
    now->move = farthest(drape, relax->mean, relax->before);
    now->drift = now->move / seconds;
    const bool goes = goes_on(drape) && now->drift > goal->drift;
    relax->goes = goes;
    const bool slow = goal->residual < ROUGH_RESIDUAL && now->drift < GIVE_DRIFT;
    const bool gives = slow && mus__drape_self_give_way(drape);
    settle_keep(drape, relax->mean, relax->before);
    settle_keep(drape, relax->force, relax->left);
    relax->rest_distance = expected_distance(now->move, last);

    const double residual = relax->residual;
    const double rounding = drape->def.precision == 32 ? mus__residual_rounding(drape) : 0.0;
    relax->settled = (residual <= goal->residual && now->drift <= goal->drift) ||
                     (residual <= rounding && now->drift <= ROUNDING_DRIFT * goal->drift);
    if (gives) relax->settled = 0;
    if (lift_nodes(drape, goal, t)) relax->settled = 0;
    choose_safety(drape, goal, t, residual < STALE_SHARE * now->best || residual <= goal->residual, gives, goes, now);
}


/* the state of the checks at the beginning; `fall`: how long the cloth falls first [s] */
static lying lie_down(mus_drape *drape, double fall)
{
    mus__relaxation *relax = &drape->relax;
    relax->settled = relax->goes = 0;
    settle_keep(drape, drape->x, relax->before);
    memset(relax->went, 0, 3 * (size_t)drape->n * sizeof *relax->went);
    relax->residual = mus__residual(drape, drape->x);
    settle_keep(drape, relax->force, relax->left);
    return (lying){.drag = fall > 0.0 ? FALL_DRAG : START_DRAG,
                   .safety = SAFETY_STEP,
                   .best = relax->residual,
                   .longer = 1,
                   .wait = MOVING_CHECKS};
}


/* puts nodes a little apart that are too near to other cloth to move; the cloth does not count as at rest then */
static mus_status free_frozen(mus_drape *drape, lying *now)
{
    const double residual = drape->relax.residual;
    const mus_status status = mus__untangle_part(drape);
    drape->relax.residual = residual;
    drape->relax.settled = 0;
    now->parted++;
    return status;
}


/* one batch of steps, `*t` [s] so far, and its check */
static mus_status settle_batch(mus_drape *drape, mus__progress *run, const settling *goal, double *t, lying *now)
{
    const bool layers = drape->self != NULL;
    now->tensors = *t >= goal->fall && !layers;
    mus__relax_rule rule = {.drag = now->drag,
                            .tensors = now->tensors,
                            .speed_limit = SETTLE_SPEED,
                            .grip = 1.0,
                            .push_speed = layers ? LAYER_PUSH_SPEED : 0.0,
                            .deep_rate = layers ? LAYER_DEEP_RATE : 0.0};
    memcpy(rule.gravity, drape->def.gravity, sizeof rule.gravity);
    const double h = now->h = mus__relax_step(drape, now->safety, 0.0);
    const double most = now->tensors ? CHECK_STEPS_MOST * SAFETY_STEP / now->safety : 1e6;
    int32_t batch = (int32_t)fmin(fmax(now->longer * CHECK_SECONDS / h, 2.0 * MEAN_STEPS), most);
    mus_status status = mus__relax_ready(drape, &rule, h);
    if (status != MUS_OK) return status;
    const double mean = on_cloth(drape) ? fmin(fmax(now->longer * MEAN_SECONDS / h, MEAN_STEPS), batch) : MEAN_STEPS;
    status = mus__relax_run(drape, run, h, &batch, (int32_t)mean);
    if (status != MUS_OK) return status;
    mus__drape_tick(drape, batch, h, 1);
    *t += batch * h;
    drape->counters.settle_time += batch * h;
    if (run->stop) {
        drape->relax.residual = NAN; /* of a check, which this batch has not reached */
        return MUS_OK;
    }
    check_rest(drape, goal, *t, batch * h, now);
    run->slid = mus__slid_off(drape, drape->relax.mean, *t > LOOSE_SECONDS);
    return now->parted < PART_CHECKS && mus__drape_self_frozen(drape) > 0 ? free_frozen(drape, now) : MUS_OK;
}


/* lets hands and feet in, and draws cloth apart that crosses other cloth by that */
static mus_status let_in(mus_drape *drape)
{
    mus__drape_publish(drape);
    if (mus__draw_off(drape) == 0) return MUS_OK;
    const mus_status status = mus__untangle(drape);
    return status == MUS_OK ? mus__drape_plane_cache(drape) : status;
}


/* on this cut, from where it is. MUS_OK: at rest, or the caller stopped the run */
static mus_status settle_here(mus_drape *drape, mus__progress *run, const settling *goal)
{
    const bool first = drape->relax.mean == NULL;
    mus_status status = mus__relax_create(drape);
    if (status == MUS_OK) status = mus__drape_plane_cache(drape);
    if (status == MUS_OK) status = mus__chord_lift_create(drape);
    if (status == MUS_OK) status = mus__slid_off_start(drape, drape->x);
    if (status == MUS_OK) status = let_in(drape);
    if (status != MUS_OK && first) {
        mus__relax_clear(drape);
        mus__drape_lift_clear(drape);
    }
    if (status != MUS_OK) return status;
    lying now = lie_down(drape, goal->fall);
    for (double t = 0.0; t < goal->seconds && now.stuck < STUCK_CHECKS;) {
        if (drape->relax.settled || run->stop || run->slid) break;
        status = settle_batch(drape, run, goal, &t, &now);
        if (status != MUS_OK || run->stop) break;
        mus__progress_report(run, drape, t / goal->seconds);
    }
    drape->sim.plane_cache = NULL;
    if (status != MUS_OK) return status;
    if (drape->relax.settled || run->stop) return MUS_OK;
    if (run->slid) return mus__fail(drape->context, MUS_ERR_UNSETTLED, "%s", drape->reason.text);
    return mus__fail(
        drape->context, MUS_ERR_UNSETTLED,
        "not at rest after %.2f s: residual %.3g of a node's weight (%.3g allowed), drift %.2g mm/s (%.2g)",
        drape->counters.settle_time, drape->relax.residual, goal->residual, 1e3 * now.drift, 1e3 * goal->drift);
}


/* coarser cuts first; a coarse cut that diverges or slides off is not followed */
static mus_status settle_cuts(mus_drape *drape, mus__progress *run, const settling *goal)
{
    mus_drape *coarse;
    mus_status status = mus__coarse_create(drape, &coarse);
    if (status != MUS_OK) return status;
    settling own = *goal;
    if (coarse != NULL) {
        const double most = coarse->cloth->coarse != NULL ? MIDDLE_SECONDS : ROUGH_SECONDS;
        const settling rough = {FALL_SECONDS, most, fmax(ROUGH_RESIDUAL, goal->residual), ROUGH_DRIFT};
        if (!drape->coarse.as_sewn) {
            mus__coarse_restrict(drape);
            status = mus__untangle(coarse);
            if (status != MUS_OK) return status;
        }
        status = settle_cuts(coarse, run, &rough);
        if (status == MUS_ERR_MEMORY || run->stop) return status;
        if (!run->slid && (status == MUS_OK || status == MUS_ERR_UNSETTLED)) {
            mus__coarse_prolong(drape);
            own.fall = 0.0;
            drape->coarse.as_sewn = 0;
            status = mus__untangle(drape);
            if (status != MUS_OK) return status;
        }
        run->slid = 0;
    }
    status = settle_here(drape, run, &own);
    mus__drape_publish(drape);
    return status;
}


mus_status mus__settle_let_down(mus_drape *drape, mus__progress *run)
{
    const settling rough = {FALL_SECONDS, ROUGH_SECONDS, ROUGH_RESIDUAL, ROUGH_DRIFT};
    const mus_status status = settle_here(drape, run, &rough);
    mus__drape_publish(drape);
    return status == MUS_ERR_UNSETTLED && !run->slid ? MUS_OK : status;
}


mus_status mus__settle_roughly(mus_drape *drape, mus__progress *run)
{
    const settling rough = {FALL_SECONDS, ROUGH_SECONDS, ROUGH_RESIDUAL, ROUGH_DRIFT};
    const mus_status status = settle_cuts(drape, run, &rough);
    if (status == MUS_OK || status == MUS_ERR_UNSETTLED) drape->relax.far = 0;
    return status == MUS_ERR_UNSETTLED && !run->slid ? MUS_OK : status;
}


mus_status mus_drape_settle(mus_drape *drape, mus_progress_fn progress, void *user)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_status status = mus__scene_require_rest(drape, "settle");
    if (status != MUS_OK) return status;
    const settling goal = {drape->relax.far ? FALL_SECONDS : 0.0, drape->def.settle_seconds, drape->def.settle_residual,
                           REST_DRIFT};
    mus__progress run;
    status = mus__progress_start(&run, drape, "settle", progress, user);
    if (status != MUS_OK) return status;
    mus_reason_init(&drape->reason, sizeof drape->reason);
    if (drape->relax.far) {
        status = settle_cuts(drape, &run, &goal);
    } else {
        if (drape->sim.lift == NULL) status = mus__chord_lift_begin(drape);
        if (status == MUS_OK) status = settle_here(drape, &run, &goal);
        mus__drape_publish(drape);
    }
    if (status == MUS_OK || status == MUS_ERR_UNSETTLED) drape->relax.far = 0;
    status = mus__progress_end(&run, drape, status, drape->relax.settled);
    return mus__diagnosis_status(drape, status);
}
