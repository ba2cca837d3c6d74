/*
 * check_pattern.c: is a pattern fit to cut and sew? Each fault has the cell that it is at and a sentence for the person
 * at the table. Faults come in the order of panels, edges, seams, the garment as a whole (check_garment.c).
 *
 * The check stands in lib/topology, not in lib/pattern, because loose edges, twisted seams and all faults of a garment
 * are questions about the quotient. It reads the pattern and changes nothing in it.
 */
#include <math.h>
#include <stdio.h>

#include "topology/faults.h"

/* [m2] least area of a panel, 1 cm2: below any panel that is cut, above the area that a slip of the pencil encloses */
#define SMALLEST_AREA 1e-4
/* [m] error of a length */
#define LENGTH_SLACK 1e-9


static mus_status fault_panel(const mus_pattern *pattern, int32_t panel, mus_faults *faults)
{
    const mus__panel *own = &pattern->panel[panel];
    mus__fault *fault;
    if (own->noutline == 0) {
        fault = mus__fault_add(faults, MUS_FAULT_OPEN_OUTLINE, panel, MUS_NONE, MUS_NONE);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "panel %s: it has no closed outline", own->name);
        return MUS_OK;
    }

    bool crosses;
    int32_t a, b;
    mus_status status = mus__panel_crosses(pattern, panel, &crosses, &a, &b);
    if (status != MUS_OK) return status;
    if (crosses) {
        char title[2][2 * MUS__NAME_BYTES];
        mus__pattern_edge_title(pattern, a, title[0]);
        mus__pattern_edge_title(pattern, b, title[1]);
        fault = mus__fault_add(faults, MUS_FAULT_CROSSING, panel, a, MUS_NONE);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "panel %s: its outline crosses or touches itself: edges %s and %s",
                 own->name, title[0], title[1]);
    }

    double area = mus_pattern_panel_area(pattern, panel);
    if (area < SMALLEST_AREA) {
        char number[32];
        fault = mus__fault_add(faults, MUS_FAULT_SMALL_PANEL, panel, MUS_NONE, MUS_NONE);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "panel %s: its area is %s cm2, pieces below 1 cm2 cannot be sewn",
                 own->name, mus__fault_number(area * 1e4, 3, number));
    }
    return MUS_OK;
}


static mus_status fault_edge(const mus_pattern *pattern, const mus__quotient *q, int32_t edge, mus_faults *faults)
{
    const mus__edge *own = &pattern->edge[edge];
    char title[2 * MUS__NAME_BYTES];
    mus__pattern_edge_title(pattern, edge, title);
    if (q->place[edge] == MUS_NONE) {
        mus__fault *fault = mus__fault_add(faults, MUS_FAULT_LOOSE_EDGE, own->panel, edge, own->seam);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "edge %s: it is part of no outline", title);
    }
    int32_t laid = 0;
    for (int32_t i = 0; i < pattern->nseam && own->nseam > 1; i++)
        laid += pattern->seam[i].laid && (pattern->seam[i].edge_a == edge || pattern->seam[i].edge_b == edge);
    if (own->nseam - laid > 1 || laid > 2) {
        mus__fault *fault = mus__fault_add(faults, MUS_FAULT_SEWN_TWICE, own->panel, edge, own->seam);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "edge %s: it is in %d seams, one is the most; the first is seam %d",
                 title, (int)own->nseam, (int)own->seam);
    }
    return MUS_OK;
}


/* |length b - length a - ease| <= tolerance */
static mus_status fault_seam_length(const mus_pattern *pattern, int32_t seam, mus_faults *faults)
{
    const mus_seam_def *def = &pattern->seam[seam];
    double a = mus_pattern_edge_length(pattern, def->edge_a), b = mus_pattern_edge_length(pattern, def->edge_b);
    double more = b - a;
    if (fabs(more - def->ease) <= def->tolerance + LENGTH_SLACK) return MUS_OK;

    char title[2][2 * MUS__NAME_BYTES], number[5][32], allowed[80];
    mus__pattern_edge_title(pattern, def->edge_a, title[0]);
    mus__pattern_edge_title(pattern, def->edge_b, title[1]);
    mus__fault_number(a, 3, number[0]);
    mus__fault_number(b, 3, number[1]);
    mus__fault_number(def->ease == 0.0 ? 1e3 * fabs(more) : 1e3 * more, 1, number[2]);
    mus__fault_number(1e3 * (def->ease + def->tolerance), 1, number[3]);
    mus__fault_number(1e3 * (def->ease - def->tolerance), 1, number[4]);
    if (def->ease == 0.0)
        snprintf(allowed, sizeof allowed, "%s mm", number[3]);
    else
        snprintf(allowed, sizeof allowed, "%s to %s mm", number[4], number[3]);

    mus__fault *fault = mus__fault_add(faults, MUS_FAULT_SEAM_LENGTH, MUS_NONE, def->edge_a, seam);
    if (fault == NULL) return MUS_ERR_MEMORY;
    snprintf(fault->text, sizeof fault->text, "seam %d: %s %s m and %s %s m differ by %s mm, ease allows %s", (int)seam,
             title[0], number[0], title[1], number[1], number[2], allowed);
    return MUS_OK;
}


static mus_status fault_twisted(const mus_pattern *pattern, int32_t seam, int32_t edge, mus_faults *faults)
{
    char title[2][2 * MUS__NAME_BYTES];
    int32_t a = seam != MUS_NONE ? pattern->seam[seam].edge_a : edge;
    mus__pattern_edge_title(pattern, a, title[0]);
    mus__fault *fault = mus__fault_add(faults, MUS_FAULT_TWISTED_SEAM, MUS_NONE, a, seam);
    if (fault == NULL) return MUS_ERR_MEMORY;
    if (seam == MUS_NONE) {
        snprintf(fault->text, sizeof fault->text, "edge %s: its panel meets itself there with the wrong side out",
                 title[0]);
        return MUS_OK;
    }
    mus__pattern_edge_title(pattern, pattern->seam[seam].edge_b, title[1]);
    snprintf(fault->text, sizeof fault->text,
             "seam %d: %s and %s are sewn with a twist, the garment has no inside and outside", (int)seam, title[0],
             title[1]);
    return MUS_OK;
}


/* all faults, in the order of panels, edges, seams, garment */
static mus_status fault_collect(const mus_pattern *pattern, mus__quotient *q, int32_t *twisted, mus_faults *faults)
{
    mus_status status = MUS_OK;
    int32_t bridge;
    for (int32_t i = 0; i < pattern->npanel && status == MUS_OK; i++) status = fault_panel(pattern, i, faults);
    for (int32_t i = 0; i < pattern->nedge && status == MUS_OK; i++) status = fault_edge(pattern, q, i, faults);
    mus__quotient_sides(pattern, q, twisted, &bridge);
    if (bridge != MUS_NONE && status == MUS_OK) status = fault_twisted(pattern, MUS_NONE, bridge, faults);
    for (int32_t i = 0; i < pattern->nseam && status == MUS_OK; i++) {
        status = fault_seam_length(pattern, i, faults);
        if (status == MUS_OK && twisted[i]) status = fault_twisted(pattern, i, MUS_NONE, faults);
    }
    return status == MUS_OK ? mus__garment_faults(pattern, q, faults) : status;
}


mus_status mus_pattern_check(const mus_pattern *pattern, int32_t *count, mus_faults **out)
{
    if (count != NULL) *count = 0;
    if (out != NULL) *out = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (count == NULL && out == NULL) return mus__fail(context, MUS_ERR_ARG, "check: count and out are both NULL");

    mus__quotient q;
    mus_status status = mus__quotient_make(pattern, true, &q);
    if (status != MUS_OK) return status;
    mus_faults *faults = mus__new(context, 1, sizeof *faults);
    int32_t *twisted = mus__new(context, pattern->nseam, sizeof *twisted);
    if (faults != NULL) faults->context = context;
    status = faults != NULL && twisted != NULL ? fault_collect(pattern, &q, twisted, faults) : MUS_ERR_MEMORY;
    mus__free(context, twisted);
    mus__free(context, q.block);
    if (status == MUS_OK && count != NULL) *count = faults->count;
    if (status == MUS_OK && out != NULL)
        *out = faults;
    else
        mus_faults_destroy(faults);
    return status == MUS_ERR_MEMORY ? mus__fail_memory(context, "the check of a pattern") : status;
}
