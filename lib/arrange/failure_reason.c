/*
 * failure_reason.c: reasons, a closed list of kinds with a sentence and a place, and the reason that a pattern cannot
 * be cut.
 */
#include <stdio.h>

#include "arrange/failure_reason.h"
#include "muslin/topology.h"

static const char *const reason_names[MUS_REASON_COUNT] = {
    "nothing asked",     "settled",       "twisted seam", "panel crosses itself",
    "seam cannot close", "start tangled", "slid off",     "tangled",
    "not settled",       "unstable",      "bad input",    "stopped",
    "not worn"};


void mus_reason_init(mus_reason *reason, size_t size)
{
    mus_reason own = {.panel = MUS_NONE, .seam = MUS_NONE, .node = MUS_NONE};
    mus__def_init(reason, size, &own, sizeof own);
}


const char *mus_reason_name(int32_t kind)
{
    return kind >= 0 && kind < MUS_REASON_COUNT ? reason_names[kind] : NULL;
}


void mus__reason_write(mus_reason *out, int32_t kind, const char *text)
{
    mus_reason_init(out, sizeof *out);
    out->kind = kind;
    snprintf(out->text, sizeof out->text, "%s", text);
}


void mus__reason_start_tangled(mus_reason *out, int32_t panel, int32_t seam, const char *text)
{
    mus__reason_write(out, MUS_REASON_START_TANGLED, text);
    out->panel = panel, out->seam = seam;
}


/* to a caller's struct of this size */
mus_status mus__reason_give(mus_context *context, const mus_reason *own, mus_reason *out)
{
    if (out == NULL || out->size != sizeof *out)
        return mus__fail(context, MUS_ERR_VERSION, "reason: size unknown; use mus_reason_init");
    *out = *own;
    out->size = sizeof *out;
    return MUS_OK;
}


mus_status mus_pattern_reason(const mus_pattern *pattern, mus_reason *out)
{
    mus_reason own;
    mus_faults *faults = NULL;
    int32_t count = 0, kind, panel, seam;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    mus__reason_write(&own, MUS_REASON_NONE, "");
    const mus_status status = mus_pattern_check(pattern, &count, &faults);
    if (status == MUS_OK && count > 0) {
        mus_faults_item(faults, 0, &kind, &panel, NULL, &seam);
        mus__reason_write(&own,
                          kind == MUS_FAULT_CROSSING       ? MUS_REASON_PANEL_CROSSES
                          : kind == MUS_FAULT_TWISTED_SEAM ? MUS_REASON_TWISTED_SEAM
                                                           : MUS_REASON_BAD_INPUT,
                          mus_faults_text(faults, 0));
        own.panel = panel, own.seam = seam;
    }
    mus_faults_destroy(faults);
    return status == MUS_OK ? mus__reason_give(context, &own, out) : status;
}
