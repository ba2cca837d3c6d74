/*
 * dress.c: mus_dress(): from a pattern and a body to a garment at rest, with the starts that are tried.
 *
 * Where a stranger starts in this room, which holds the runs that dress a body: sew.c (mus_drape_sew) with seam_route.c
 * and layers.c, settle.c (mus_drape_settle) with slid_off.c, untangle.c (mus_drape_untangle), the relaxation that all
 * three share (dynamic_relaxation.c), progress calls (progress.c), and why a run ended as it did (diagnosis.c).
 *
 * A start is a placement of the panels, and the patience of sewing. An impatient start gives up when the first way of
 * sewing does not close the coarsest cut; a patient one goes on with other ways and with finer cuts, which takes long.
 * A placement from which the coarsest cut does not close is seldom a good one. Order, until one start succeeds:
 *
 *   1. the pattern's placement, impatient     (patient when no other placement may be tried; then the only start)
 *   2. the found placement, impatient
 *   3. the pattern's placement, patient       when start 1 ended with an open seam
 *   4. the found placement, patient           when start 2 ended with an open seam
 *
 * A start whose garment comes to rest but is not worn (mus_fit_worn()) has failed too, and an impatient one ends after
 * sewing when a limb is not in its opening or the cloth is inside out. Cloth through the skin alone, and a body that
 * the call cannot tell by, fail no start.
 *
 * Garments are made by public functions; of the drape's own header only the clock and the sizes of defs are used.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "drape/drape_state.h"
#include "dress/progress.h"
#include "muslin/dress.h"
#include "muslin/fit.h"

/* [bytes] of mus_dress_def when ABI 1 was recorded first, the smallest that mus_dress() takes */
#define DRESS_DEF_FIRST offsetof(mus_dress_def, progress_seconds)

/* the call: what it was given, and its report */
typedef struct dress_call {
    mus_context *context;
    const mus_body *body;
    mus_dress_def def;
    mus_drape_def drape;
    mus_dress_report report;
    mus_pattern *own;   /* copy with closures open or with the found placement, NULL when the caller's serves */
    mus_pattern *found; /* copy with the found placement, of the second start; NULL before it */
    int32_t stopped;    /* nonzero: the progress function stopped the run */
} dress_call;

/* one start and how it ended */
typedef struct dress_trial {
    mus_cloth *cloth;
    mus_drape *drape;
    mus_status status;
    mus_reason reason;
    int32_t refused; /* nonzero: mus_drape_start() found a fault, and nothing was sewn */
    char text[MUS_ERROR_BYTES];
} dress_trial;


void mus_dress_def_init(mus_dress_def *def, size_t size)
{
    mus_dress_def own = {0};
    own.spacing = 0.01;
    own.precision = 32;
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


/* the caller's progress function; remembers that it stopped the run */
static int32_t dress_progress(void *user, const mus_progress *progress)
{
    dress_call *call = user;
    if (call->stopped == 0) call->stopped = call->def.progress(call->def.progress_user, progress);
    return call->stopped;
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


/* cut the cloth and put it round the body, before the first step */
static mus_status dress_cut(dress_call *call, const mus_pattern *pattern, bool patient, dress_trial *trial)
{
    const double start = mus__progress_time();
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = call->def.spacing;
    cut.fabric = call->def.fabric;
    cut.nodes_most = call->def.nodes_most;
    mus_status status = mus_cloth_create(call->context, pattern, &cut, &trial->cloth);
    call->report.cut_seconds += mus__progress_time() - start;
    if (status != MUS_OK) return status;
    call->drape.sew_once = !patient;
    status = mus_drape_create(call->context, trial->cloth, call->body, &call->drape, &trial->drape);
    return status == MUS_OK ? mus_drape_place(trial->drape) : status;
}


/* refuse a start that is faulty before anything is sewn */
static mus_status dress_look(dress_trial *trial)
{
    mus_reason_init(&trial->reason, sizeof trial->reason);
    const mus_status status = mus_drape_start(trial->drape, &trial->reason);
    trial->refused = status == MUS_OK && trial->reason.kind != MUS_REASON_NONE;
    return trial->refused ? MUS_ERR_SEW : status;
}


/* MUS_ERR_UNSETTLED with the reason when the garment is not worn; `sewn`: it has still to settle, so that only
 * openings count */
static mus_status dress_worn(const dress_call *call, const mus_pattern *pattern, bool sewn, dress_trial *trial)
{
    mus_worn worn;
    mus_worn_init(&worn, sizeof worn);
    if (call->body == NULL) return MUS_OK;
    const mus_status status = mus_fit_worn(trial->drape, pattern, call->body, &worn);
    if (status != MUS_OK) return status;
    if (worn.kind == MUS_WORN_YES || worn.kind == MUS_WORN_UNKNOWN || worn.kind == MUS_WORN_THROUGH) return MUS_OK;
    if (sewn && worn.kind != MUS_WORN_OPENING && worn.kind != MUS_WORN_INSIDE_OUT) return MUS_OK;
    mus_reason *why = &trial->reason;
    mus_reason_init(why, sizeof *why);
    why->kind = MUS_REASON_NOT_WORN, why->panel = worn.panel, why->node = worn.node, why->value = worn.kind;
    memcpy(why->place, worn.place, sizeof why->place);
    memcpy(why->text, worn.text, sizeof why->text);
    return MUS_ERR_UNSETTLED;
}


/* sew and settle. An impatient start whose limbs are not in their openings once it is sewn ends there: a limb that went
 * into no opening while seams were open seldom finds it afterwards */
static mus_status dress_sew(dress_call *call, const mus_pattern *pattern, bool patient, dress_trial *trial)
{
    mus_drape *drape = trial->drape;
    const mus_progress_fn progress = call->def.progress != NULL ? dress_progress : NULL;
    double start = mus__progress_time();
    mus_status status = mus_drape_sew(drape, progress, call);
    call->report.sew_seconds += mus__progress_time() - start;
    if (status == MUS_OK && !patient) status = dress_worn(call, pattern, true, trial);
    if (status != MUS_OK) return status;
    start = mus__progress_time();
    status = mus_drape_settle(drape, progress, call);
    call->report.settle_seconds += mus__progress_time() - start;
    return status;
}


/* the reason why a start ended as it did, when mus_drape_start() found no fault */
static void dress_reason(const mus_pattern *pattern, dress_trial *trial)
{
    mus_reason *why = &trial->reason;
    mus_reason_init(why, sizeof *why);
    if (trial->drape != NULL)
        mus_drape_reason(trial->drape, why);
    else if (trial->status == MUS_ERR_PATTERN)
        mus_pattern_reason(pattern, why);
    if (trial->status == MUS_OK && why->kind == MUS_REASON_TANGLED) trial->status = MUS_ERR_TANGLED;
    if (trial->status == MUS_OK)
        why->kind = MUS_REASON_SETTLED;
    else if (trial->status == MUS_ERR_DIVERGED)
        why->kind = MUS_REASON_UNSTABLE;
    else if (why->kind == MUS_REASON_NONE || why->kind == MUS_REASON_SETTLED)
        why->kind = MUS_REASON_BAD_INPUT;
}


/* the sentence of a failure: that of the context's error, but where the reason says more; and the reason's own */
static void dress_text(dress_trial *trial)
{
    mus_reason *why = &trial->reason;
    const char *text = NULL;
    if (trial->refused || trial->status == MUS_ERR_TANGLED || why->kind == MUS_REASON_NOT_WORN) text = why->text;
    if (text != NULL) snprintf(trial->text, sizeof trial->text, "%s", text);
    if (trial->status != MUS_OK && why->text[0] == '\0') snprintf(why->text, sizeof why->text, "%.255s", trial->text);
}


/* one start: from cutting the cloth to rest, or to the reason why not; noted in the report */
static void dress_from(dress_call *call, const mus_pattern *pattern, int32_t place, bool patient, dress_trial *trial)
{
    const double start = mus__progress_time();
    memset(trial, 0, sizeof *trial);
    trial->status = dress_cut(call, pattern, patient, trial);
    if (trial->status == MUS_OK) trial->status = dress_look(trial);
    if (trial->status == MUS_OK) trial->status = dress_sew(call, pattern, patient, trial);
    snprintf(trial->text, sizeof trial->text, "%s", mus_context_error(call->context));
    if (!trial->refused && trial->reason.kind != MUS_REASON_NOT_WORN) dress_reason(pattern, trial);
    if (trial->status == MUS_OK) trial->status = dress_worn(call, pattern, false, trial);
    dress_text(trial);

    mus_dress_report *report = &call->report;
    const int32_t i = report->starts++;
    report->start_place[i] = place;
    report->start_patient[i] = patient;
    report->start_end[i] = trial->reason.kind;
    report->start_seconds[i] = mus__progress_time() - start;
}


static void dress_trial_free(dress_trial *trial)
{
    mus_drape_destroy(trial->drape);
    mus_cloth_destroy(trial->cloth);
}


/* may another placement help? Not where the input is at fault, the motion diverged, or the caller stopped the run */
static bool dress_failed_at_start(const dress_trial *trial)
{
    const int32_t kind = trial->reason.kind;
    if (trial->status == MUS_OK || trial->status == MUS_ERR_STOPPED || trial->drape == NULL) return false;
    if (trial->refused) return kind == MUS_REASON_START_TANGLED;
    return kind == MUS_REASON_SEAM_OPEN || kind == MUS_REASON_TANGLED || kind == MUS_REASON_SLID_OFF ||
           kind == MUS_REASON_NOT_SETTLED || kind == MUS_REASON_NOT_WORN;
}


/* one start more. It takes the place of *kept where it succeeds, is stopped, or `better` says that it does once it is
 * cut. Returns the kind of its end */
static int32_t dress_again(dress_call *call, const mus_pattern *pattern, int32_t place, bool patient, bool better,
                           dress_trial *kept)
{
    dress_trial next;
    dress_from(call, pattern, place, patient, &next);
    const int32_t end = next.reason.kind;
    const bool keep = next.status == MUS_OK || next.status == MUS_ERR_STOPPED || (better && next.drape != NULL);
    dress_trial_free(keep ? kept : &next);
    if (keep) *kept = next, call->report.kept = call->report.starts - 1;
    return end;
}


/* starts 1 to 4 of the head comment */
static void dress_starts(dress_call *call, const mus_pattern *pattern, bool other, dress_trial *kept)
{
    const int32_t first = call->report.found ? MUS_DRESS_PLACE_FOUND : MUS_DRESS_PLACE_PATTERN;
    dress_from(call, pattern, first, !other, kept);
    call->report.kept = 0;
    if (!other || !dress_failed_at_start(kept)) return;

    const bool open = !kept->refused && kept->reason.kind == MUS_REASON_SEAM_OPEN;
    int32_t end = MUS_REASON_NONE;
    const double start = mus__progress_time();
    mus_status status = mus_pattern_copy(pattern, &call->found);
    if (status == MUS_OK) status = mus_arrange_pattern(call->found, call->body);
    call->report.place_seconds += mus__progress_time() - start;
    if (status == MUS_OK) end = dress_again(call, call->found, MUS_DRESS_PLACE_FOUND, false, false, kept);
    if (kept->status != MUS_OK && open && !call->stopped)
        dress_again(call, pattern, MUS_DRESS_PLACE_PATTERN, true, true, kept);
    if (kept->status != MUS_OK && end == MUS_REASON_SEAM_OPEN && !call->stopped)
        dress_again(call, call->found, MUS_DRESS_PLACE_FOUND, true, false, kept);
    call->report.found = call->report.start_place[call->report.kept] == MUS_DRESS_PLACE_FOUND;
}


/* the pattern that the first start takes: the caller's, or a copy with closures open or with the found placement */
static mus_status dress_prepare(dress_call *call, const mus_pattern **pattern)
{
    const mus_dress_def *def = &call->def;
    const bool find = def->place == MUS_DRESS_PLACE_FOUND ||
                      (def->place == MUS_DRESS_PLACE_BOTH && call->body != NULL && !dress_is_placed(*pattern));
    mus_status status = MUS_OK;
    if (find || def->open_closures) status = mus_pattern_copy(*pattern, &call->own);
    if (call->own != NULL) *pattern = call->own;
    if (status == MUS_OK && def->open_closures) status = mus_pattern_open_closures(call->own, 1, NULL);
    if (status == MUS_OK && find) {
        const double start = mus__progress_time();
        status = mus_arrange_pattern(call->own, call->body);
        call->report.place_seconds = mus__progress_time() - start;
    }
    call->report.found = find;
    return status;
}


/* read the caller's options; the drape's are those of def.drape, or its defaults with those that stand here */
static mus_status dress_options(dress_call *call, const mus_dress_def *def)
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

    dress_call call = {.context = context, .body = body};
    dress_trial kept = {.status = MUS_OK};
    mus_dress_report_init(&call.report, sizeof call.report);
    mus_reason_init(&kept.reason, sizeof kept.reason);
    status = dress_options(&call, def);
    if (status == MUS_OK) status = dress_prepare(&call, &pattern);
    if (status == MUS_OK) {
        const bool own = call.def.place == MUS_DRESS_PLACE_BOTH && !call.report.found;
        dress_starts(&call, pattern, own && call.def.retry && body != NULL, &kept);
        status = kept.status;
        if (status != MUS_OK) mus_context_fail(context, status, kept.text);
    } else {
        kept.reason.kind = MUS_REASON_BAD_INPUT;
        snprintf(kept.reason.text, sizeof kept.reason.text, "%.255s", mus_context_error(context));
    }
    mus_pattern_destroy(call.found);
    mus_pattern_destroy(call.own);
    if (report != NULL) *report = call.report;
    if (reason != NULL) *reason = kept.reason;
    if (cloth != NULL)
        *cloth = kept.cloth;
    else
        mus_cloth_destroy(kept.cloth);
    *drape = kept.drape;
    return status;
}
