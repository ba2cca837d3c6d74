/*
 * settle.c: to rest under gravity, coarse to fine.
 *
 * A cloth that is far from rest falls on its coarsest cut first; each finer cut starts where the coarser one came to.
 * On each: symplectic Euler with inertia that is raised where the mesh is stiffer than its lattice (rest does not
 * depend on inertia), and air drag that is critical for the slowest motion left, measured from check to check. Why not
 * kinetic damping: halting all nodes at peaks of the kinetic energy lets cloth that friction holds slip (9 mm on the
 * T-shirt).
 *
 * A cloth rests when two things are small, both taken at the mean place of the last steps (so that the rounding of a
 * float state averages out): the residual, which is the force that springs, gravity, contact and friction leave at each
 * node, over the node's weight, rms over the nodes; and the drift of that mean place from one check to the next. In
 * float, where stiff cloth feels its own rounding, a residual within that and a slower drift will do. So does lying
 * still for long where all force that is left is at nodes that touch skin or cloth: contact puts places right, and
 * where surfaces wedge a node, no normals and no friction that are known from its place tell what they carry. Energy
 * never decides. What slides or falls off the body ends the run, with that reason (slide.c).
 *
 * Where cloth lies on cloth each step of h brings the two nearer by h^2 F/m and contact takes that back: places ripple
 * by so much, and forces with them. So the mean is over a time there, not over a number of steps, and a residual that
 * no longer falls halves the step. Any cloth that lies still with force left halves it too. Where little force is left
 * and cloth still goes somewhere, the step is doubled again. What hangs on a hook, far from equilibrium, going
 * nowhere and with no less force than before, will not rest: that is said at once.
 *
 * Two sheets of full thickness and the skin on both sides may have no room, as between legs: a node then lies deep in
 * the body, pressed by cloth. What is left there has to be shared, so the thickness of such nodes yields near
 * rest; not while seams close, for what is drawn through narrow places wants all of it.
 */
#include <math.h>
#include <string.h>

#include "drape/coarse_drape.h"
#include "drape/diagnosis.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "geom/vec.h"

#define CHECK_SECONDS 0.1 /* of cloth time between residuals */
#define MEAN_STEPS 96     /* places averaged before a residual: of every step, or ripples would alias */
#define MEAN_SECONDS 0.05 /* the same where cloth lies on cloth */
#define SAFETY_STEP 0.75  /* of the bound of symplectic Euler, 2/2.62 of that of RK4 */
#define RIPPLE_SAFETY 0.2 /* the same for what cloth on cloth leaves, when it is */
#define RIPPLE_FAR 10.0   /* times what is allowed */
#define RIPPLE_DRIFT 20.0 /* the same: cloth that goes faster may be on its way, not held up by ripples */
#define LEAST_SAFETY 0.1  /* halved down to this while cloth lies still with force left, or ripples on cloth */
#define STILL_CHECKS 4
#define FAST_CHECKS 8
#define STUCK_CHECKS 12       /* with far more force left than is allowed, none gained, no drift, the smallest step */
#define PART_CHECKS 20        /* with nodes that cannot move for cloth that is too near */
#define MOVING_CHECKS 3       /* with the residual reached and no rest: the step is doubled again */
#define STALE_PART 0.9        /* of the least residual so far: more is no gain */
#define SETTLE_SPEED 4.0      /* [m/s] limit */
#define LAYER_PUSH_SPEED 0.1  /* [m/s]: cloth between body and cloth leaves the body no faster, or both would shake it \
                               */
#define LAYER_DEEP_RATE 100.0 /* [1/s]: but what springs pull deeper than MUS__CACHE_DEEP comes out so much faster */
#define FALL_SECONDS 0.8      /* of cloth time in which cloth falls */
#define FALL_DRAG 4.0         /* [1/s] meanwhile: near critical for a garment's swing */
#define START_DRAG 20.0       /* [1/s] before the first measurement of one that is near rest */
#define DRAG_LEAST 1.0
#define DRAG_GROWTH 1.5   /* from one check to the next at most */
#define DRAG_FALL 0.75    /* the same where nothing is to be damped, down to that of a fall */
#define LOOSE_SECONDS 1.0 /* of cloth time in which a loose garment drops onto the body */
#define REST_DRIFT 0.002  /* [m/s]: no node's mean place drifts faster at rest */
#define GIVE_DRIFT 0.02   /* [m/s]: near rest cloth on cloth gives way; before, springs press through what is left */
#define REST_WAY 1e-4     /* [m]: what lies still: no node goes farther, */
#define REST_SECONDS 0.5  /* in so long, nor strays as far from its mean place */

#define ROUNDING_LEFT 0.03  /* of what rounding makes a node feel, in the mean place of the last steps */
#define ROUNDING_DRIFT 0.25 /* of the drift allowed, where rounding hides the residual */

/* what a coarser cut is for: the place, not the folds. Rest of a tenth of a weight, or so much cloth time */
#define ROUGH_RESIDUAL 0.1
#define ROUGH_DRIFT 0.01
#define ROUGH_SECONDS 4.0  /* on the coarsest cut, fall included */
#define MIDDLE_SECONDS 0.6 /* on those between */

typedef struct settling {
    double fall;            /* [s] of falling first */
    double seconds;         /* budget */
    double residual, drift; /* goal */
} settling;

/* how the cloth lies, from check to check */
typedef struct lying {
    double drag;       /* [1/s] from now on */
    double move;       /* farthest that a mean place went since the check before [m] */
    double drift;      /* that over its time [m/s] */
    double stray;      /* farthest that a node is from its mean place [m] */
    double way, quiet; /* farthest that a mean place is from where it began to lie still [m], and how long ago [s] */
    double best;       /* least residual since the step was halved */
    double safety;     /* of the bound, for the steps */
    int32_t still;     /* checks with force left and nothing gained */
    int32_t stuck;     /* checks that have it caught somewhere */
    int32_t parted;    /* checks with nodes that cloth so near let go nowhere */
    int32_t moving;    /* checks with no more force than is allowed, but not at rest yet */
} lying;


/* `steps` steps, with the mean place of the last `last` into drape->relax.mean */
static void advance_mean(mus_drape *drape, int32_t steps, int32_t last, double h)
{
    mus__sim *sim = &drape->sim;
    const int64_t n3 = 3 * (int64_t)drape->n;
    for (int32_t i = 0; i < steps - last; i++) sim->ops->euler(sim, h);
    memset(drape->relax.mean, 0, (size_t)n3 * sizeof *drape->relax.mean);
    mus__drape_self_forget(drape);
    for (int32_t i = 0; i < last; i++) {
        sim->ops->euler(sim, h);
        sim->ops->add(sim, drape->relax.mean);
    }
    for (int64_t k = 0; k < n3; k++) drape->relax.mean[k] = drape->relax.mean[k] / last + sim->origin[k % 3];
    sim->ops->get(sim, drape->x, drape->v);
}


/* cloth lies on cloth */
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


/*
 * Drag that is critical for the slowest motion left. Between two checks the mean place moved by d and the force left
 * over changed by g: the Rayleigh quotient  w^2 = - d.g / d.M d  is a mean of the squared rates of what moved, weighted
 * by how far it moved, so slow motion rules it; critical drag is 2 w. It grows slowly: quick ripples after a change of
 * cut must not freeze the folds. Nodes that touch cloth are left out: contact is stiffer than all that is to be damped.
 * Where cloth lies on cloth, the drag is no more than at the start: its ripples look like quick motion. Where what
 * moved went with its force (a fold that snaps over), there is nothing to measure: drag falls towards that of a fall.
 */
static double critical_drag(const mus_drape *drape, double now)
{
    double work = 0.0, moved = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        double dd = 0.0;
        if (drape->mass[i] <= 0.0 || drape->pinned[i] || touches_cloth(drape, i)) continue;
        for (int64_t k = 3 * (int64_t)i; k < 3 * (int64_t)i + 3; k++) {
            const double d = drape->relax.mean[k] - drape->relax.before[k];
            work -= d * (drape->relax.force[k] - drape->relax.left[k]);
            dd += d * d;
        }
        moved += drape->mass[i] * dd;
    }
    if (!(moved > 0.0)) return now;
    if (!(work > 0.0)) return fmax(DRAG_FALL * now, fmin(now, FALL_DRAG));
    const double most = on_cloth(drape) ? fmin(DRAG_GROWTH * now, START_DRAG) : DRAG_GROWTH * now;
    return fmin(fmax(2.0 * sqrt(work / moved), DRAG_LEAST), most);
}


/* largest distance between two places of a node [m] */
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


/* mean places and forces of this check become those of the last */
static void keep_check(mus_drape *drape)
{
    memcpy(drape->relax.before, drape->relax.mean, 3 * (size_t)drape->n * sizeof *drape->relax.before);
    memcpy(drape->relax.left, drape->relax.force, 3 * (size_t)drape->n * sizeof *drape->relax.left);
}


/* what is still to go if moves go on shrinking as from the last check to this one; all of ten moves when they do not */
static double expected_distance(double move, double last)
{
    const double ratio = last > 0.0 ? move / last : 1.0;
    return ratio < 0.9 ? move * ratio / (1.0 - ratio) : 10.0 * move;
}


/*
 * What the rounding of a float state leaves of the residual, over a node's weight, rms: places are some 3e-8 m off,
 * each by itself, so a node feels about T times that, T its stiffness; the mean over the last steps takes most of it.
 * The part that it leaves was fitted on woven cloths at rest (cotton 0.2, silk 0.1, wool 0.04, denim 0.03), with room.
 */
static double rounding_residual(const mus_drape *drape)
{
    const double *gravity = drape->def.gravity, ulp = drape->def.precision == 32 ? 3e-8 : 0.0;
    const double g = sqrt(gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    double sum = 0.0;
    int64_t count = 0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double felt = drape->stepping.stiffness[i] * ulp / (drape->mass[i] * (g > 0.0 ? g : 9.81));
        sum += felt * felt;
        count++;
    }
    return count > 0 ? ROUNDING_LEFT * sqrt(sum / (double)count) : 0.0;
}


/* after steps that took `seconds`, `t` in all: how it lies, whether it rests, and steps and drag from now on */
static void look_at_rest(mus_drape *drape, const settling *goal, double t, double seconds, lying *now)
{
    double unheld;
    drape->relax.residual = mus__residual(drape, drape->relax.mean, &unheld);
    now->drag = t < goal->fall ? FALL_DRAG : critical_drag(drape, now->drag);
    now->stray = farthest(drape, drape->x, drape->relax.mean);
    const double last = now->move;
    now->move = farthest(drape, drape->relax.mean, drape->relax.before);
    now->drift = now->move / seconds;
    const bool slow = goal->residual < ROUGH_RESIDUAL && now->drift < GIVE_DRIFT;
    const bool gives = slow && mus__drape_self_give_way(drape);
    keep_check(drape);
    drape->relax.rest_distance = expected_distance(now->move, last);

    /* for how long it has lain still */
    now->way = farthest(drape, drape->relax.mean, drape->relax.anchor);
    now->quiet += seconds;
    if (!(now->way <= REST_WAY && now->stray <= REST_WAY)) {
        memcpy(drape->relax.anchor, drape->relax.mean, 3 * (size_t)drape->n * sizeof *drape->relax.anchor);
        now->quiet = 0.0;
    }
    const double residual = drape->relax.residual, rounding = rounding_residual(drape);
    drape->relax.settled = (residual <= goal->residual && now->drift <= goal->drift) ||
                           (residual <= rounding && now->drift <= ROUNDING_DRIFT * goal->drift) ||
                           (unheld <= goal->residual && now->quiet >= REST_SECONDS);
    if (gives) drape->relax.settled = 0;

    /* force that a smaller step may take away */
    const bool ripples = on_cloth(drape) && t > goal->fall && goal->residual < ROUGH_RESIDUAL;
    const bool gains = residual < STALE_PART * now->best || residual <= goal->residual;
    now->still = now->drift <= goal->drift || (ripples && !gains) ? now->still + 1 : 0;
    const int32_t patience = now->drift > RIPPLE_DRIFT * goal->drift ? FAST_CHECKS : STILL_CHECKS;
    if (gains || t <= goal->fall) now->best = residual;
    now->moving = residual <= goal->residual && now->drift > goal->drift ? now->moving + 1 : 0;
    const double least = ripples && residual > RIPPLE_FAR * goal->residual ? RIPPLE_SAFETY : LEAST_SAFETY;
    if (now->moving >= MOVING_CHECKS && now->safety < SAFETY_STEP) {
        now->safety *= 2.0;
        now->moving = 0;
    } else if (now->still >= patience && now->safety > least) {
        now->safety *= 0.5;
        now->still = 0;
        now->best = residual;
    }
    const bool caught = residual > RIPPLE_FAR * goal->residual && now->drift <= goal->drift && now->safety <= least;
    now->stuck = caught && !gives && !gains ? now->stuck + 1 : 0;
}


/* what settling starts from: `fall` it falls first */
static lying lie_down(mus_drape *drape, double fall)
{
    mus__sim *sim = &drape->sim;
    memcpy(sim->gravity, drape->def.gravity, sizeof sim->gravity);
    sim->speed_limit = SETTLE_SPEED;
    sim->dashpots = 0;
    drape->relax.settled = 0;
    memcpy(drape->relax.before, drape->x, 3 * (size_t)drape->n * sizeof *drape->relax.before);
    memcpy(drape->relax.anchor, drape->x, 3 * (size_t)drape->n * sizeof *drape->relax.anchor);
    drape->relax.residual = mus__residual(drape, drape->x, NULL);
    memcpy(drape->relax.left, drape->relax.force, 3 * (size_t)drape->n * sizeof *drape->relax.left);
    return (lying){.drag = fall > 0.0 ? FALL_DRAG : START_DRAG, .safety = SAFETY_STEP, .best = drape->relax.residual};
}


/* what is too near to other cloth to move is put a little off it, and does not count as at rest */
static mus_status free_frozen(mus_drape *drape, lying *now)
{
    const double residual = drape->relax.residual;
    const mus_status status = mus__untangle_part(drape);
    drape->relax.residual = residual;
    drape->relax.settled = 0;
    now->parted++;
    return status;
}


/* on this cut, from where it is. MUS_OK: at rest or stopped */
static mus_status relax(mus_drape *drape, mus__progress *run, const settling *goal)
{
    const bool scratch = drape->relax.mean == NULL;
    mus_status status = mus__relax_create(drape);
    if (status == MUS_OK) status = mus__drape_plane_cache(drape);
    if (status == MUS_OK) status = mus__slid_off_start(drape, drape->x);
    if (status != MUS_OK && scratch) mus__relax_clear(drape);
    if (status != MUS_OK) return status;
    mus__sim *sim = &drape->sim;
    lying now = lie_down(drape, goal->fall);
    for (double t = 0.0; t < goal->seconds && now.stuck < STUCK_CHECKS;) {
        if (drape->relax.settled || run->stop || run->slid) break;
        const double h = now.safety * (2.0 / 2.62) * mus__drape_inertia(drape, 1), travel = SETTLE_SPEED * h;
        const int32_t batch = (int32_t)fmin(fmax(CHECK_SECONDS / h, 2.0 * MEAN_STEPS), 1e6);
        sim->drag = now.drag;
        const bool layers = drape->self != NULL;
        sim->rule = (mus__contact_rule){.clearance = drape->def.clearance,
                                        .friction = drape->scene.friction,
                                        .push = layers ? LAYER_PUSH_SPEED * h : 2.0 * travel,
                                        .deep = layers ? LAYER_DEEP_RATE : 0.0,
                                        .travel = travel,
                                        .slip = h,
                                        .step = h,
                                        .cache_radius = MUS__CACHE_RADIUS};
        status = mus__drape_self_ready(drape, h);
        if (status != MUS_OK) break;
        const double mean = on_cloth(drape) ? fmin(fmax(MEAN_SECONDS / h, MEAN_STEPS), batch) : MEAN_STEPS;
        advance_mean(drape, batch, (int32_t)mean, h);
        status = mus__drape_keep_good(drape);
        if (status == MUS_OK) status = mus__drape_self_fits(drape);
        if (status != MUS_OK) break;
        mus__drape_tick(drape, batch, h, 1);
        t += batch * h;
        drape->counters.settle_time += batch * h;
        look_at_rest(drape, goal, t, batch * h, &now);
        run->slid = mus__slid_off(drape, drape->relax.mean, t > LOOSE_SECONDS);
        if (now.parted < PART_CHECKS && mus__drape_self_frozen(drape) > 0) status = free_frozen(drape, &now);
        if (status != MUS_OK) break;
        mus__progress_report(run, t / goal->seconds);
    }
    sim->plane_cache = NULL;
    if (status != MUS_OK) return status;
    if (drape->relax.settled || run->stop) return MUS_OK;
    if (run->slid) return mus__fail(drape->context, MUS_ERR_UNSETTLED, "%s", drape->reason.text);
    return mus__fail(
        drape->context, MUS_ERR_UNSETTLED,
        "not at rest after %.2f s: residual %.3g of a node's weight (%.3g allowed), drift %.2g mm/s (%.2g)",
        drape->counters.settle_time, drape->relax.residual, goal->residual, 1e3 * now.drift, 1e3 * goal->drift);
}


/* coarser cuts first; one that diverges or slides off is not followed */
static mus_status settle_levels(mus_drape *drape, mus__progress *run, const settling *goal)
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
        status = settle_levels(coarse, run, &rough);
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
    status = relax(drape, run, &own);
    mus__drape_publish(drape);
    return status;
}


mus_status mus__settle_let_down(mus_drape *drape, mus__progress *run)
{
    const settling rough = {FALL_SECONDS, ROUGH_SECONDS, ROUGH_RESIDUAL, ROUGH_DRIFT};
    const mus_status status = relax(drape, run, &rough);
    mus__drape_publish(drape);
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
    mus__progress_start(&run, "settle", progress, user);
    mus_reason_init(&drape->reason, sizeof drape->reason);
    if (drape->relax.far) {
        status = settle_levels(drape, &run, &goal);
    } else {
        status = relax(drape, &run, &goal);
        mus__drape_publish(drape);
    }
    if (status == MUS_OK || status == MUS_ERR_UNSETTLED) drape->relax.far = 0;
    return mus__diagnosis_status(drape, status);
}
