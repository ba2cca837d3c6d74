/*
 * dress_start.c: one start of mus_dress(), from cutting the cloth to rest, or to the reason why not.
 *
 * Settling takes most of the time of a start, so a start that is sewn is looked at first: every limb goes through its
 * opening and none through the cloth (mus__fit_worn()), and no cloth crosses cloth. A limb that went into no opening
 * while seams were open seldom finds it afterwards, and crossings that were not drawn apart then stay. Such a start
 * waits: mus_dress() settles it only if no other start is better. An opening that is far too small for its limb is told
 * before anything is sewn.
 *
 * A start with raised arms is sewn round the body with horizontal arms. They are taken back to where the body has them
 * while the cloth, which is on by then, steps in time; then it settles as any other. A hood that would hang over the
 * face is drawn back before that (hood_back.c), and held until the garment is let down.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/drape_state.h"
#include "dress/dress_start.h"
#include "dress/dynamic_relaxation.h"
#include "dress/hood_back.h"
#include "dress/progress.h"
#include "fit/worn_check.h"
#include "geom/vec.h"
#include "muslin/pose.h"

#define LOWER_SECONDS 1.0 /* [s] of cloth time in which arms come down; chosen: a person who lets them down */
#define LOWER_FRAMES 60   /* parts of it, after each of which the progress function is called */


/* the caller's progress function, and a look at the time; remembers that either stopped the run */
static int32_t start_progress(void *user, const mus_progress *progress)
{
    mus__dress *call = user;
    const double most = call->def.seconds_most;
    if (call->stopped == 0 && call->def.progress != NULL)
        call->stopped = call->def.progress(call->def.progress_user, progress);
    if (call->stopped == 0) call->stopped = call->late = most > 0.0 && mus__progress_time() - call->start > most;
    return call->stopped;
}


/* what the runs of a start call, NULL: nothing */
static mus_progress_fn start_listener(const mus__dress *call)
{
    return call->def.progress != NULL || call->def.seconds_most > 0.0 ? start_progress : NULL;
}


mus_status mus__dress_raise(const mus_body *body, mus_pose *pose, mus_body **out)
{
    static const int32_t shoulders[2] = {MUS_JOINT_SHOULDER_LEFT, MUS_JOINT_SHOULDER_RIGHT};
    *out = NULL;
    mus_pose_init(pose, sizeof *pose);
    mus_status status = mus_body_stance(body, pose);
    if (status != MUS_OK) return status;
    for (int32_t i = 0; i < 2; i++) {
        memset(pose->angle[shoulders[i]], 0, sizeof pose->angle[shoulders[i]]);
        pose->angle[shoulders[i]][MUS_POSE_ABDUCTION] = 0.5 * MUS_PI;
    }
    return mus_body_pose(body, pose, out);
}


/* the floor under the body: a plane at the height 0 of the body frame, or where a body reaches lower, under that */
static mus_status start_floor(const mus__dress *call, mus_drape *drape)
{
    const double *x = mus_body_vertices(call->body);
    mus_plane floor;
    mus_plane_init(&floor, sizeof floor);
    floor.normal[1] = 1.0, floor.normal[0] = floor.normal[2] = 0.0;
    for (int32_t i = 0; i < mus_body_vertex_count(call->body); i++)
        floor.point[1] = fmin(floor.point[1], x[3 * (int64_t)i + 1]);
    return mus_drape_add_plane(drape, &floor, NULL);
}


/* cut the cloth and put it round the body, before the first step */
static mus_status start_cut(mus__dress *call, bool patient, mus__dress_start *start)
{
    const double time = mus__progress_time();
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = call->def.spacing;
    cut.fabric = call->def.fabric;
    cut.nodes_most = call->def.nodes_most;
    mus_status status = mus_cloth_create(call->context, start->pattern, &cut, &start->cloth);
    call->report.cut_seconds += mus__progress_time() - time;
    if (status != MUS_OK) return status;
    call->drape.sew_once = !patient;
    status = mus_drape_create(call->context, start->cloth, call->body, &call->drape, &start->drape);
    if (status == MUS_OK && call->body != NULL) status = start_floor(call, start->drape);
    if (status == MUS_OK) status = mus_drape_place(start->drape);
    if (status != MUS_OK || start->raised == NULL) return status;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    status = mus_body_stance(start->raised, &pose);
    return status == MUS_OK ? mus_drape_pose_body(start->drape, &pose, 0.0) : status;
}


/* MUS_ERR_UNSETTLED with the reason when the garment is not worn, by `checks` (MUS__WORN_*) alone. `settled`: round the
 * body as it stands, not with its arms raised */
static mus_status start_worn(const mus__dress *call, int32_t checks, bool settled, mus__dress_start *start)
{
    mus_worn worn;
    mus_worn_init(&worn, sizeof worn);
    if (call->body == NULL) return MUS_OK;
    const mus_body *body = !settled && start->raised != NULL ? start->raised : call->body;
    const mus_status status = mus__fit_worn(start->drape, start->pattern, body, checks, &worn);
    if (status != MUS_OK) return status;
    if (worn.kind == MUS_WORN_YES || worn.kind == MUS_WORN_UNKNOWN) return MUS_OK;
    mus_reason *why = &start->reason;
    mus_reason_init(why, sizeof *why);
    why->kind = MUS_REASON_NOT_WORN, why->panel = worn.panel, why->node = worn.node, why->value = worn.kind;
    memcpy(why->place, worn.place, sizeof why->place);
    memcpy(why->text, worn.text, sizeof why->text);
    return mus__fail(call->context, MUS_ERR_UNSETTLED, "%s", worn.text);
}


/* refuse a start that is faulty, or a garment that is too tight, before anything is sewn */
static mus_status start_look(const mus__dress *call, mus__dress_start *start)
{
    mus_reason_init(&start->reason, sizeof start->reason);
    mus_status status = mus_drape_start(start->drape, &start->reason);
    if (status == MUS_OK && start->reason.kind != MUS_REASON_NONE) status = MUS_ERR_SEW;
    if (status == MUS_OK) status = start_worn(call, MUS__WORN_GIRTHS, false, start);
    start->refused = status == MUS_ERR_SEW || status == MUS_ERR_UNSETTLED;
    return status;
}


/* MUS_ERR_TANGLED with the reason when cloth crosses cloth after sewing */
static mus_status start_crossed(const mus__dress *call, mus__dress_start *start)
{
    int64_t count = 0;
    if (!call->drape.self_contact) return MUS_OK;
    const mus_status status = mus_drape_crossings(start->drape, 0, NULL, &count);
    if (status != MUS_OK || count == 0) return status;
    mus_reason *why = &start->reason;
    mus_reason_init(why, sizeof *why);
    why->kind = MUS_REASON_TANGLED, why->count = count < INT32_MAX ? (int32_t)count : INT32_MAX;
    snprintf(why->text, sizeof why->text, "tangled: %lld crossings of cloth once it is sewn", (long long)count);
    return mus__fail(call->context, MUS_ERR_TANGLED, "%s", why->text);
}


/* the reason why a start ended as it did, when mus_drape_start() found no fault */
static void start_reason(mus__dress_start *start)
{
    mus_reason *why = &start->reason;
    mus_reason_init(why, sizeof *why);
    if (start->drape != NULL)
        mus_drape_reason(start->drape, why);
    else if (start->status == MUS_ERR_PATTERN)
        start->status = mus_pattern_reason(start->pattern, why) == MUS_ERR_MEMORY ? MUS_ERR_MEMORY : start->status;
    if (start->status == MUS_OK && why->kind == MUS_REASON_TANGLED) start->status = MUS_ERR_TANGLED;
    if (start->status == MUS_OK)
        why->kind = MUS_REASON_SETTLED;
    else if (start->status == MUS_ERR_DIVERGED)
        why->kind = MUS_REASON_UNSTABLE;
    else if (why->kind == MUS_REASON_NONE || why->kind == MUS_REASON_SETTLED)
        why->kind = MUS_REASON_BAD_INPUT;
}


/* the sentence of a failure: that of the context's error, but where the reason says more; and the reason's own. Notes
 * the end in the report, and the time since `time` */
static void start_note(mus__dress *call, double time, mus__dress_start *start)
{
    mus_reason *why = &start->reason;
    snprintf(start->text, sizeof start->text, "%s", mus_context_error(call->context));
    if (start->status == MUS_ERR_STOPPED && call->late) {
        snprintf(start->text, sizeof start->text, "no end after %.9g s", call->def.seconds_most);
        why->text[0] = '\0';
    }
    if (start->refused || start->status == MUS_ERR_TANGLED || why->kind == MUS_REASON_NOT_WORN)
        snprintf(start->text, sizeof start->text, "%s", why->text);
    if (start->status != MUS_OK && why->text[0] == '\0') snprintf(why->text, sizeof why->text, "%.255s", start->text);
    call->report.start_end[start->index] = why->kind;
    call->report.start_seconds[start->index] += mus__progress_time() - time;
}


void mus__dress_sew(mus__dress *call, const mus_pattern *pattern, int32_t place, bool patient, mus__dress_start *start)
{
    const double time = mus__progress_time();
    start->pattern = pattern;
    start->index = call->report.starts++;
    call->report.start_place[start->index] = place;
    call->report.start_patient[start->index] = patient;
    start->status = start_cut(call, patient, start);
    if (start->status == MUS_OK) start->status = start_look(call, start);
    if (start->status == MUS_OK) {
        const double began = mus__progress_time();
        start->status = mus_drape_sew(start->drape, start_listener(call), call);
        call->report.sew_seconds += mus__progress_time() - began;
    }
    if (start->status != MUS_OK) {
        if (!start->refused) start_reason(start);
    } else if (!patient) {
        start->status = start_worn(call, MUS__WORN_OPENINGS, false, start);
        if (start->status == MUS_OK) start->status = start_crossed(call, start);
        start->waits = start->status == MUS_ERR_UNSETTLED || start->status == MUS_ERR_TANGLED;
    }
    start_note(call, time, start);
}


/* take the arms back to where the body has them, with the garment on */
static mus_status start_lower(mus__dress *call, mus__dress_start *start)
{
    const double frame = LOWER_SECONDS / LOWER_FRAMES;
    mus_drape *drape = start->drape;
    mus__progress run;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    mus_status status = mus_body_stance(call->body, &pose);
    if (status != MUS_OK) return status;
    status = mus__progress_start(&run, drape, "settle", start_listener(call), call);
    if (status != MUS_OK) return status;
    status = mus_drape_pose_body(drape, &pose, LOWER_SECONDS);
    for (int32_t k = 0; k < LOWER_FRAMES && status == MUS_OK && !run.stop; k++) {
        const int32_t steps = (int32_t)ceil(frame / (0.9 * mus_drape_step_bound(drape)));
        status = mus_drape_step(drape, steps, frame / steps);
        mus__progress_report(&run, drape, (double)k / LOWER_FRAMES);
    }
    if (status == MUS_OK && !run.stop) status = mus_drape_pose_body(drape, &pose, 0.0);
    return mus__progress_end(&run, drape, status, false);
}


/* draw a hood back that would hang over the face, and hold it: *hood. Where that diverges, here and below, the start
 * goes on from the last good state */
static mus_status start_hood(mus__dress *call, mus__dress_start *start, mus__hood_edge *hood)
{
    mus__progress run;
    hood->count = 0;
    if (call->body == NULL) return MUS_OK;
    mus_progress_fn progress = start_listener(call);
    mus_status status = mus__progress_start(&run, start->drape, "settle", progress, call);
    if (status != MUS_OK) return status;
    status = mus__hood_back(start->drape, start->pattern, call->body, &run, hood);
    return mus__progress_end(&run, start->drape, status == MUS_ERR_DIVERGED ? MUS_OK : status, false);
}


/* let the garment down while the hood is held, then let go of it; `status`: of the start so far */
static mus_status start_let_go(mus__dress *call, mus_status status, mus__dress_start *start, mus__hood_edge *hood)
{
    mus__progress run;
    mus_progress_fn progress = start_listener(call);
    if (status == MUS_OK) status = mus__progress_start(&run, start->drape, "settle", progress, call);
    if (status == MUS_OK) {
        status = mus__settle_roughly(start->drape, &run);
        status = mus__progress_end(&run, start->drape, status == MUS_ERR_DIVERGED ? MUS_OK : status, false);
    }
    const mus_status own = mus__hood_release(start->drape, hood);
    return status == MUS_OK ? own : status;
}


/* settle; and once more where the cloth still drifts with its forces balanced, or goes on in the direction in which it
 * came, as long folds do: it is on its way, and nearer to rest than another start is */
static mus_status start_settle(mus__dress *call, mus__dress_start *start)
{
    mus_progress_fn progress = start_listener(call);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_status status = mus_drape_settle(start->drape, progress, call);
    if (status != MUS_ERR_UNSETTLED || mus_drape_report_get(start->drape, &report) != MUS_OK) return status;
    mus_drape_reason(start->drape, &start->reason);
    const bool goes = report.residual <= call->drape.settle_residual || start->drape->relax.goes != 0;
    return goes && start->reason.kind == MUS_REASON_NOT_SETTLED ? mus_drape_settle(start->drape, progress, call)
                                                                : status;
}


void mus__dress_settle(mus__dress *call, mus__dress_start *start)
{
    const double time = mus__progress_time();
    start->waits = 0;
    mus__hood_edge hood;
    start->status = start_hood(call, start, &hood);
    if (start->status == MUS_OK && start->raised != NULL) start->status = start_lower(call, start);
    if (hood.count > 0) start->status = start_let_go(call, start->status, start, &hood);
    if (start->status == MUS_OK) start->status = start_settle(call, start);
    call->report.settle_seconds += mus__progress_time() - time;
    start_reason(start);
    if (start->status == MUS_OK) start->status = start_worn(call, MUS__WORN_OPENINGS | MUS__WORN_HANGS, true, start);
    start_note(call, time, start);
}


void mus__dress_start_free(mus__dress_start *start)
{
    mus_drape_destroy(start->drape);
    mus_cloth_destroy(start->cloth);
    mus_body_destroy(start->raised);
    *start = (mus__dress_start){.index = MUS_NONE};
}
