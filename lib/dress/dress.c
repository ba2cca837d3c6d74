/*
 * dress.c: mus_dress(): from a pattern and a body to a garment at rest, with the starts that are tried.
 *
 * Where a stranger starts in this room, which holds the runs that dress a body: dress_start.c (one start), sew.c
 * (mus_drape_sew) with seam_route.c and layers.c, settle.c (mus_drape_settle) with slid_off.c, untangle.c
 * (mus_drape_untangle), the relaxation that all three share (dynamic_relaxation.c), progress calls (progress.c), and
 * why a run ended as it did (diagnosis.c).
 *
 * A start is a placement of the panels, and the patience of sewing. An impatient start gives up when the first way of
 * sewing does not close the coarsest cut; a patient one goes on with other ways and with finer cuts, which takes long.
 * A placement from which the coarsest cut does not close is seldom a good one. Three placements are sewn impatiently:
 *
 *   1. that of the pattern      (patient when no other placement may be tried; then the only start)
 *   2. the one that is found round the body
 *   3. the one that is found round the body with its arms horizontal, where cloth lies beside an arm
 *
 * The first that is sewn with every limb in its opening and no cloth through cloth is settled; a success ends the
 * search. Else, as long as none succeeds: those that are sewn with cloth through cloth are settled, the one with the
 * fewest crossings first, and no one with more than another has at rest; where none got through settling, those that
 * ended with an open seam are sewn patiently; and the one that got farthest is returned, settled if it is sewn.
 *
 * A start whose settle ends while its cloth is still on its way is settled once more (dress_start.c). One whose garment
 * comes to rest but is not worn (mus_fit_worn()) has failed too. Cloth through the skin fails no start, but a limb that
 * goes through the cloth does. A body that the call cannot tell by fails none.
 *
 * Garments are made by public functions; of the drape's own header only the clock and the sizes of defs are used.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/drape_state.h"
#include "dress/dress_start.h"
#include "dress/progress.h"
#include "muslin/fit.h"
#include "muslin/pose.h"

/* [bytes] of mus_dress_def when ABI 1 was recorded first, the smallest that mus_dress() takes */
#define DRESS_DEF_FIRST offsetof(mus_dress_def, progress_seconds)

#define STARTS 3 /* placements, in the order in which they are tried */
#define NEAR_DEPTH 1e-3 /* [m] by which depths in two poses of the body differ beside a limb that moved; chosen */


void mus_dress_def_init(mus_dress_def *def, size_t size)
{
    mus_dress_def own = {0};
    own.spacing = 0.01;
    own.threads = 1;
    own.friction = NAN;
    own.progress_seconds = 0.1;
    own.place = MUS_DRESS_PLACE_BOTH;
    own.retry = 1;
    own.nodes_most = MUS_CLOTH_NODES;
    mus__def_init(def, size, &own, sizeof own);
}


void mus_dress_report_init(mus_dress_report *report, size_t size)
{
    mus_dress_report own = {.kept = MUS_NONE};
    mus__def_init(report, size, &own, sizeof own);
}


/* does any panel of the pattern have a placement of its own? */
static bool dress_is_placed(const mus_pattern *pattern)
{
    mus_placement none, own;
    mus_placement_init(&none, sizeof none);
    mus_placement_init(&own, sizeof own);
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++)
        if (mus_pattern_placement(pattern, p, &own) == MUS_OK && memcmp(&own, &none, sizeof own) != 0) return true;
    return false;
}


/* may another placement help? Not where the input is at fault, the motion diverged, or the caller stopped the run */
static bool dress_failed_at_start(const mus__dress_start *start)
{
    const int32_t kind = start->reason.kind;
    if (start->status == MUS_OK || start->status == MUS_ERR_STOPPED || start->drape == NULL) return false;
    if (start->refused) return kind == MUS_REASON_START_TANGLED;
    return kind == MUS_REASON_SEAM_OPEN || kind == MUS_REASON_TANGLED || kind == MUS_REASON_SLID_OFF ||
           kind == MUS_REASON_NOT_SETTLED || kind == MUS_REASON_NOT_WORN;
}


/* does a start end the search? So it does for want of memory, also where that was before the start had a number */
static bool dress_ends(const mus__dress_start *start)
{
    if (start->status == MUS_ERR_MEMORY) return true;
    return start->index != MUS_NONE && (start->status == MUS_OK || start->status == MUS_ERR_STOPPED);
}


/* keep a failure before a start had a number, if it ends the search */
static void dress_keep_failure(const mus__dress *call, mus_status status, mus__dress_start *start)
{
    if (status != MUS_ERR_MEMORY) return;
    start->status = status;
    snprintf(start->text, sizeof start->text, "%s", mus_context_error(call->context));
}


/* sew from a placement and, unless the start waits, settle */
static void dress_try(mus__dress *call, const mus_pattern *pattern, int32_t place, bool patient,
                      mus__dress_start *start)
{
    mus__dress_sew(call, pattern, place, patient, start);
    if (start->status == MUS_OK) mus__dress_settle(call, start);
}


/* try the placement that is found round the body, or round the body `raised` with its arms horizontal, which the start
 * takes (NULL: the body as it stands): a start more. *found gets the pattern with it */
static void dress_find(mus__dress *call, const mus_pattern *pattern, mus_body *raised, mus__dress_start *start,
                       mus_pattern **found)
{
    const double time = mus__progress_time();
    start->raised = raised;
    mus_status status = mus_pattern_copy(pattern, found);
    if (status == MUS_OK) status = mus_arrange_pattern(*found, raised != NULL ? raised : call->body);
    call->report.place_seconds += mus__progress_time() - time;
    if (status == MUS_OK)
        dress_try(call, *found, raised != NULL ? MUS_DRESS_PLACE_RAISED : MUS_DRESS_PLACE_FOUND, false, start);
    else
        dress_keep_failure(call, status, start);
}


/* how far a start that failed got: the farther the greater */
static int32_t dress_rank(const mus__dress_start *start)
{
    static const int32_t kinds[] = {MUS_REASON_SEAM_OPEN, MUS_REASON_SLID_OFF, MUS_REASON_NOT_WORN, MUS_REASON_TANGLED,
                                    MUS_REASON_NOT_SETTLED};
    if (start->index == MUS_NONE || start->drape == NULL || start->refused) return 0;
    for (int32_t k = (int32_t)(sizeof kinds / sizeof *kinds) - 1; k >= 0; k--)
        if (start->reason.kind == kinds[k]) return k + 2;
    return 1;
}


/* did start a get farther than start b? Of two with cloth through cloth the one at rest, then the one with fewer
 * crossings */
static bool dress_farther(const mus__dress_start *a, const mus__dress_start *b)
{
    const int32_t of_a = dress_rank(a), of_b = dress_rank(b);
    if (of_a != of_b || of_a == 0 || a->reason.kind != MUS_REASON_TANGLED) return of_a > of_b;
    return a->waits != b->waits ? b->waits : a->reason.count < b->reason.count;
}


/* is any node of a start within 5 cm of an arm? There the body and the body with its arms horizontal have not the same
 * depth (mus_body_depth()); a node that is farther from both has none */
static mus_status dress_near_arms(const mus__dress *call, const mus_body *raised, const mus__dress_start *start,
                                  bool *near)
{
    const int32_t n = start->drape != NULL ? mus_cloth_node_count(start->cloth) : 0;
    double *depth = mus__new(call->context, 2 * (int64_t)n, sizeof *depth);
    if (n > 0 && depth == NULL) return mus__fail_memory(call->context, "the cloth beside the arms");
    mus_status status = MUS_OK;
    const double *x = n > 0 ? mus_drape_positions(start->drape) : NULL;
    if (n > 0) status = mus_body_depth(call->body, n, x, depth, NULL);
    if (n > 0 && status == MUS_OK) status = mus_body_depth(raised, n, x, depth + n, NULL);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) *near = *near || fabs(depth[i] - depth[n + i]) > NEAR_DEPTH;
    mus__free(call->context, depth);
    return status;
}


/* did any start fail in a way that arms out of the way may mend? Seams that are open, cloth through cloth, a limb that
 * is not in its opening or goes through the cloth, with cloth beside an arm. `raised`: the body with its arms
 * horizontal */
static mus_status dress_wants_room(const mus__dress *call, const mus_body *raised, const mus__dress_start *start,
                                   bool *wants)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < STARTS && status == MUS_OK && !*wants; i++) {
        const mus_reason *why = &start[i].reason;
        if (start[i].index == MUS_NONE) continue;
        if (why->kind == MUS_REASON_SEAM_OPEN || why->kind == MUS_REASON_TANGLED ||
            why->kind == MUS_REASON_START_TANGLED ||
            (why->kind == MUS_REASON_NOT_WORN &&
             (why->value <= MUS_WORN_INSIDE_OUT || why->value >= MUS_WORN_THROUGH)))
            status = dress_near_arms(call, raised, &start[i], wants);
    }
    return status;
}


/* the body with its arms horizontal, where a start failed in a way that this may mend; else, or after an error, NULL.
 * `next` is the start that would take it */
static mus_body *dress_room(mus__dress *call, const mus__dress_start *start, mus__dress_start *next)
{
    const double time = mus__progress_time();
    mus_body *raised = NULL;
    mus_pose pose;
    bool wants = false;
    mus_status status = mus__dress_raise(call->body, &pose, &raised);
    if (status == MUS_OK) status = dress_wants_room(call, raised, start, &wants);
    call->report.place_seconds += mus__progress_time() - time;
    if (status == MUS_OK && wants) return raised;
    dress_keep_failure(call, status, next);
    mus_body_destroy(raised);
    return NULL;
}


/* the start to settle next of those that wait with cloth through cloth: the one with the fewest crossings, if these are
 * fewer than any start has that came to rest with crossings. MUS_NONE without any */
static int32_t dress_least_crossed(const mus__dress_start *start)
{
    int32_t best = MUS_NONE, least = INT32_MAX;
    for (int32_t i = 0; i < STARTS; i++)
        if (start[i].index != MUS_NONE && !start[i].waits && start[i].reason.kind == MUS_REASON_TANGLED)
            least = start[i].reason.count < least ? start[i].reason.count : least;
    for (int32_t i = 0; i < STARTS; i++)
        if (start[i].waits && start[i].reason.kind == MUS_REASON_TANGLED && start[i].reason.count < least)
            best = i, least = start[i].reason.count;
    return best;
}


/* did any start go through settling with all its seams closed, its limbs in their openings and its place kept, though
 * some cloth crosses cloth or it found no rest? Patience with an open seam seldom gets as far */
static bool dress_settled_any(const mus__dress_start *start)
{
    for (int32_t i = 0; i < STARTS; i++) {
        const int32_t kind = start[i].reason.kind;
        if (start[i].index == MUS_NONE || start[i].waits) continue;
        if (kind == MUS_REASON_TANGLED || kind == MUS_REASON_NOT_SETTLED) return true;
    }
    return false;
}


/* when no impatient start succeeded: the others of the head comment. Returns the one that is given back */
static int32_t dress_insist(mus__dress *call, mus__dress_start *start)
{
    for (int32_t i; (i = dress_least_crossed(start)) != MUS_NONE;) {
        mus__dress_settle(call, &start[i]);
        if (dress_ends(&start[i])) return i;
    }
    for (int32_t i = 0; i < STARTS && !dress_settled_any(start); i++) {
        if (start[i].index == MUS_NONE || start[i].refused || start[i].reason.kind != MUS_REASON_SEAM_OPEN) continue;
        const int32_t place = call->report.start_place[start[i].index];
        const mus_pattern *pattern = start[i].pattern;
        mus_body *raised = start[i].raised;
        start[i].raised = NULL;
        mus__dress_start_free(&start[i]);
        start[i].raised = raised;
        dress_try(call, pattern, place, true, &start[i]);
        if (dress_ends(&start[i])) return i;
    }
    int32_t best = 0;
    for (int32_t i = 1; i < STARTS; i++)
        if (dress_farther(&start[i], &start[best])) best = i;
    if (start[best].waits) mus__dress_settle(call, &start[best]);
    return best;
}


/* the starts of the head comment: *kept is the one that is given back */
static void dress_starts(mus__dress *call, const mus_pattern *pattern, bool other, mus__dress_start *kept)
{
    mus__dress_start start[STARTS];
    mus_pattern *found[STARTS] = {NULL};
    int32_t best = 0;
    for (int32_t i = 0; i < STARTS; i++) start[i] = (mus__dress_start){.index = MUS_NONE};
    dress_try(call, pattern, call->report.found ? MUS_DRESS_PLACE_FOUND : MUS_DRESS_PLACE_PATTERN, !other, &start[0]);
    if (other && dress_failed_at_start(&start[0])) {
        for (int32_t i = call->report.found ? 2 : 1; i < STARTS && !dress_ends(&start[best]); i++) {
            mus_body *raised = i == 2 ? dress_room(call, start, &start[i]) : NULL;
            if (i < 2 || raised != NULL) dress_find(call, pattern, raised, &start[i], &found[i]);
            if (dress_ends(&start[i])) best = i;
        }
        if (!dress_ends(&start[best])) best = dress_insist(call, start);
    }
    *kept = start[best];
    start[best] = (mus__dress_start){.index = MUS_NONE};
    for (int32_t i = 0; i < STARTS; i++) {
        mus__dress_start_free(&start[i]);
        mus_pattern_destroy(found[i]);
    }
    mus_body_destroy(kept->raised);
    call->report.kept = kept->index;
    if (kept->index != MUS_NONE)
        call->report.found = call->report.start_place[kept->index] != MUS_DRESS_PLACE_PATTERN;
}


/* the pattern that the first start takes: the caller's, or a copy (*own) with closures open or with the found
 * placement */
static mus_status dress_prepare(mus__dress *call, const mus_pattern **pattern, mus_pattern **own)
{
    const mus_dress_def *def = &call->def;
    const bool find = def->place == MUS_DRESS_PLACE_FOUND ||
                      (def->place == MUS_DRESS_PLACE_BOTH && call->body != NULL && !dress_is_placed(*pattern));
    mus_status status = MUS_OK;
    if (find || def->open_closures) status = mus_pattern_copy(*pattern, &*own);
    if (*own != NULL) *pattern = *own;
    if (status == MUS_OK && def->open_closures) status = mus_pattern_open_closures(*own, 1, NULL);
    if (status == MUS_OK && find) {
        const double start = mus__progress_time();
        status = mus_arrange_pattern(*own, call->body);
        call->report.place_seconds = mus__progress_time() - start;
    }
    call->report.found = find;
    return status;
}


/* read the caller's options; the drape's are those of def.drape, or its defaults with those that stand here */
static mus_status dress_options(mus__dress *call, const mus_dress_def *def)
{
    mus_dress_def_init(&call->def, sizeof call->def);
    mus_status status = mus__def_read(call->context, &call->def, sizeof call->def, DRESS_DEF_FIRST, def, "dress def");
    if (status != MUS_OK) return status;
    mus_drape_def_init(&call->drape, sizeof call->drape);
    call->drape.precision = call->def.precision;
    call->drape.threads = call->def.threads;
    call->drape.friction = call->def.friction;
    call->drape.self_contact = call->def.self_contact;
    call->drape.progress_seconds = call->def.progress_seconds;
    status = mus__def_read(call->context, &call->drape, sizeof call->drape, MUS__DRAPE_DEF_FIRST,
                           call->def.drape, "drape def");
    const int32_t place = call->def.place;
    if (status == MUS_OK && (place < MUS_DRESS_PLACE_BOTH || place > MUS_DRESS_PLACE_FOUND))
        status = mus__fail(call->context, MUS_ERR_ARG, "dress: place is %d, expected %d to %d", (int)place,
                           MUS_DRESS_PLACE_BOTH, MUS_DRESS_PLACE_FOUND);
    if (status == MUS_OK && !(call->def.seconds_most >= 0.0 && mus__finite(call->def.seconds_most)))
        status = mus__fail(call->context, MUS_ERR_ARG, "dress: seconds_most is %g, expected 0 or more",
                           call->def.seconds_most);
    return status;
}


/* the caller's structs begin with a size that this library knows */
static mus_status dress_check_sizes(mus_context *context, const mus_dress_report *report, const mus_reason *reason)
{
    if (report != NULL && report->size != sizeof *report)
        return mus__fail(context, MUS_ERR_VERSION, "dress report: size unknown; use mus_dress_report_init");
    if (reason != NULL && reason->size != sizeof *reason)
        return mus__fail(context, MUS_ERR_VERSION, "reason: size unknown; use mus_reason_init");
    return MUS_OK;
}


mus_status mus_dress(mus_context *context, const mus_pattern *pattern, const mus_body *body, const mus_dress_def *def,
                     mus_dress_report *report, mus_reason *reason, mus_cloth **cloth, mus_drape **drape)
{
    if (cloth != NULL) *cloth = NULL;
    if (drape != NULL) *drape = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (pattern == NULL || drape == NULL)
        return mus__fail(context, MUS_ERR_ARG, "dress: the %s is NULL", pattern == NULL ? "pattern" : "output");
    mus_status status = dress_check_sizes(context, report, reason);
    if (status != MUS_OK) return status;

    mus__dress call = {.context = context, .body = body, .start = mus__progress_time()};
    mus__dress_start kept = {.status = MUS_OK};
    mus_pattern *own = NULL;
    mus_dress_report_init(&call.report, sizeof call.report);
    mus_reason_init(&kept.reason, sizeof kept.reason);
    status = dress_options(&call, def);
    if (status == MUS_OK) status = dress_prepare(&call, &pattern, &own);
    if (status == MUS_OK) {
        const bool other = call.def.place == MUS_DRESS_PLACE_BOTH && call.def.retry && body != NULL;
        dress_starts(&call, pattern, other, &kept);
        status = kept.status;
        if (status != MUS_OK) mus_context_fail(context, status, kept.text);
    } else {
        kept.reason.kind = MUS_REASON_BAD_INPUT;
        snprintf(kept.reason.text, sizeof kept.reason.text, "%.255s", mus_context_error(context));
    }
    mus_pattern_destroy(own);
    if (status == MUS_ERR_MEMORY) {
        mus_drape_destroy(kept.drape);
        mus_cloth_destroy(kept.cloth);
        kept.drape = NULL, kept.cloth = NULL;
    }
    if (report != NULL) *report = call.report;
    if (reason != NULL) *reason = kept.reason;
    if (cloth != NULL)
        *cloth = kept.cloth;
    else
        mus_cloth_destroy(kept.cloth);
    *drape = kept.drape;
    return status;
}
