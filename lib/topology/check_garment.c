/*
 * check_garment.c: the faults of a pattern that declares its openings, as a garment.
 *
 * Euler characteristic, orientation and number of openings do not tell a T-shirt from one with a sleeve left off: an
 * armhole is open in place of a cuff. So a pattern may declare its openings, by the labels of their boundary loops
 * ("hem", "neck", "cuff", "cuff"). A pattern that declares any is checked as a garment: it is connected, it has no
 * handle, no closed bag, and exactly those openings. The label of a loop is the label with the greatest length along
 * it.
 *
 * A patch pocket, which is sewn to a line inside a panel, is a third sheet there and changes no opening and no handle;
 * nor does the layer of a pleat that lies on a sewn layer. Openings and handles are those of the garment without such
 * seams.
 *
 * Panels that are cut mirrored make a handle (genus): right sides are out, and the ends of their seams change places.
 * The fault names a smallest set, of one panel or two, whose turning over removes the handle: turning a set over
 * reverses the direction of each seam between the set and the other panels.
 */
#include <stdio.h>
#include <string.h>

#include "topology/faults.h"

#define GARMENT_PAIRS 64    /* most panels of a pattern whose pairs are tried: 2000 topologies of some 10 us each */
#define GARMENT_SINGLES 500 /* most panels of a pattern whose single panels are tried */
#define GARMENT_NAMED 3     /* cells that a sentence names before it only counts them */


/* the n edges of a loop and its length [m]: a block to free, NULL when *status is not MUS_OK */
static int32_t *garment_loop(const mus_pattern *pattern, int32_t loop, int32_t *n, double *length, mus_status *status)
{
    *n = 0;
    *status = mus_pattern_loop(pattern, loop, NULL, 0, n, NULL);
    if (*status != MUS_OK) return NULL;
    int32_t *edges = mus__new(pattern->context, *n, sizeof *edges);
    *status = edges == NULL ? mus__fail_memory(pattern->context, "the loops of a pattern")
                            : mus_pattern_loop(pattern, loop, edges, *n, n, length);
    return edges;
}


/* the label with the greatest length along a loop, "" when no edge of it has one */
static const char *garment_label(const mus_pattern *pattern, int32_t n, const int32_t *edges)
{
    const char *best = "";
    double most = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const char *label = pattern->edge[edges[i]].attr.label;
        double length = 0.0;
        for (int32_t j = 0; j < n; j++)
            if (strcmp(pattern->edge[edges[j]].attr.label, label) == 0)
                length += mus_pattern_edge_length(pattern, edges[j]);
        if (label[0] == '\0' || length <= most) continue;
        best = label, most = length;
    }
    return best;
}


mus_status mus_pattern_loop_label(const mus_pattern *pattern, int32_t loop, const char **label)
{
    if (label != NULL) *label = NULL;
    if (pattern == NULL) return MUS_ERR_ARG;
    if (label == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "loop label: label is NULL");
    int32_t n;
    mus_status status;
    int32_t *edges = garment_loop(pattern, loop, &n, NULL, &status);
    if (status == MUS_OK) *label = garment_label(pattern, n, edges);
    mus__free(pattern->context, edges);
    return status;
}


/* "a.b, c.d, e.f and 2 more" of edges, or of panels' names; out (MUS__FAULT_BYTES / 2), cut where it is full */
static void garment_list(const mus_pattern *pattern, bool panels, int32_t n, const int32_t *items, char *out)
{
    size_t used = 0, room = MUS__FAULT_BYTES / 2;
    for (int32_t i = 0; i < n && i < GARMENT_NAMED; i++) {
        char title[2 * MUS__NAME_BYTES];
        if (panels)
            snprintf(title, sizeof title, "%s", pattern->panel[items[i]].name);
        else
            mus__pattern_edge_title(pattern, items[i], title);
        int more = snprintf(out + used, room - used, "%s%s", i > 0 ? ", " : "", title);
        used = more < 0 || used + (size_t)more >= room ? room - 1 : used + (size_t)more;
    }
    if (n > GARMENT_NAMED) snprintf(out + used, room - used, " and %d more", (int)(n - GARMENT_NAMED));
}


/* components other than the one with most panels */
static mus_status garment_pieces(const mus_pattern *pattern, mus__quotient *q, mus_faults *faults)
{
    int32_t bridge, main = 0, most = 0;
    mus__quotient_sides(pattern, q, NULL, &bridge);
    int32_t *items = mus__new(pattern->context, pattern->npanel, sizeof *items);
    if (items == NULL) return MUS_ERR_MEMORY;
    for (int32_t pass = 0; pass < 2; pass++) {
        for (int32_t i = 0; i < pattern->npanel; i++) {
            if (q->link[i] != i || (pass == 1 && i == main)) continue;
            int32_t n = 0;
            for (int32_t j = i; j < pattern->npanel; j++)
                if (q->link[j] == i) items[n++] = j;
            if (pass == 0) {
                if (n > most) main = i, most = n;
                continue;
            }
            mus__fault *fault = mus__fault_add(faults, MUS_FAULT_LOOSE_PIECE, i, MUS_NONE, MUS_NONE);
            char names[MUS__FAULT_BYTES / 2];
            garment_list(pattern, true, n, items, names);
            if (fault != NULL)
                snprintf(fault->text, sizeof fault->text, "panels %s: no seam joins them to the rest of the garment",
                         names);
            if (fault == NULL) pass = 2;
        }
    }
    mus__free(pattern->context, items);
    return faults->failed ? MUS_ERR_MEMORY : MUS_OK;
}


/* number of handles of all components together */
static int32_t garment_handles(const mus_topology *t)
{
    return t->components - (t->loops + t->euler) / 2;
}


/* number of handles when panels a and b (MUS_NONE: a alone) are turned over; `seams` (nseam) is scratch */
static mus_status garment_turned(const mus_pattern *pattern, int32_t a, int32_t b, mus_seam_def *seams, int32_t *out)
{
    for (int32_t i = 0; i < pattern->nseam; i++) {
        int32_t p = pattern->edge[pattern->seam[i].edge_a].panel, q = pattern->edge[pattern->seam[i].edge_b].panel;
        seams[i] = pattern->seam[i];
        if ((p == a || p == b) != (q == a || q == b))
            seams[i].direction = seams[i].direction == MUS_SEAM_DIRECT ? MUS_SEAM_REVERSED : MUS_SEAM_DIRECT;
    }
    mus_pattern turned = *pattern;
    turned.seam = seams;
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    mus_status status = mus_pattern_topology(&turned, &t);
    if (status == MUS_OK) *out = garment_handles(&t);
    return status;
}


/* the panels, out (2), whose turning over removes the handles: single panels first, then panels that mirror each other,
 * then any two */
static mus_status garment_mirrored(const mus_pattern *pattern, int32_t *out)
{
    out[0] = out[1] = MUS_NONE;
    mus_seam_def *seams = mus__new(pattern->context, pattern->nseam, sizeof *seams);
    if (seams == NULL) return MUS_ERR_MEMORY;
    mus_status status = MUS_OK;
    for (int32_t pass = 0; pass < 3 && pattern->npanel <= GARMENT_SINGLES; pass++) {
        for (int32_t a = 0; a < pattern->npanel && out[0] == MUS_NONE; a++) {
            for (int32_t b = pass == 0 ? pattern->npanel - 1 : a + 1; b < pattern->npanel && status == MUS_OK; b++) {
                bool twins = pattern->panel[b].mirror_of == a || pattern->panel[a].mirror_of == b;
                int32_t handles = 1;
                if (pass > 0 && twins != (pass == 1)) continue;
                if (pass == 2 && pattern->npanel > GARMENT_PAIRS) continue;
                status = garment_turned(pattern, a, pass == 0 ? MUS_NONE : b, seams, &handles);
                if (status != MUS_OK || handles != 0) continue;
                out[0] = a, out[1] = pass == 0 ? MUS_NONE : b;
                break;
            }
        }
    }
    mus__free(pattern->context, seams);
    return status;
}


static mus_status garment_handle(const mus_pattern *pattern, int32_t handles, mus_faults *faults)
{
    int32_t pair[2];
    mus_status status = garment_mirrored(pattern, pair);
    if (status != MUS_OK) return status;
    mus__fault *fault = mus__fault_add(faults, MUS_FAULT_MIRRORED, pair[0], MUS_NONE, MUS_NONE);
    if (fault == NULL) return MUS_ERR_MEMORY;
    char names[MUS__FAULT_BYTES / 2];
    garment_list(pattern, true, pair[1] == MUS_NONE ? 1 : 2, pair, names);
    if (pair[0] == MUS_NONE)
        snprintf(fault->text, sizeof fault->text,
                 "the garment has %d handles: two openings of one piece are sewn together, or several pieces are cut "
                 "mirrored",
                 (int)handles);
    else
        snprintf(fault->text, sizeof fault->text,
                 "panels %s: cut mirrored or sewn end for end, the garment has a handle that goes when they are turned "
                 "over",
                 names);
    return MUS_OK;
}


/* an opening that is not declared; with `missing`, the label of a declared one that is not there */
static mus_status garment_opening(const mus_pattern *pattern, int32_t loop, const char *missing, mus_faults *faults)
{
    int32_t n;
    double length;
    mus_status status;
    int32_t *edges = garment_loop(pattern, loop, &n, &length, &status);
    if (status == MUS_OK) {
        char names[MUS__FAULT_BYTES / 2], number[32];
        int32_t kind = missing != NULL ? MUS_FAULT_MISSING_PIECE : MUS_FAULT_OPENING;
        mus__fault *fault = mus__fault_add(faults, kind, MUS_NONE, edges[0], MUS_NONE);
        garment_list(pattern, false, n, edges, names);
        mus__fault_number(length, 3, number);
        if (fault == NULL)
            status = MUS_ERR_MEMORY;
        else if (missing != NULL)
            snprintf(fault->text, sizeof fault->text,
                     "a piece with the opening %s is missing: edges %s, %s m round, are open in its place", missing,
                     names, number);
        else
            snprintf(fault->text, sizeof fault->text, "opening %s: edges %s, %s m round, are open and not declared so",
                     garment_label(pattern, n, edges), names, number);
    }
    mus__free(pattern->context, edges);
    return status;
}


/* is an edge in a seam of this pattern? */
static bool garment_sewn(const mus_pattern *pattern, int32_t edge)
{
    for (int32_t i = 0; i < pattern->nseam; i++)
        if (pattern->seam[i].edge_a == edge || pattern->seam[i].edge_b == edge) return true;
    return false;
}


/* is a loop the boundary of a patch, whose seams to a line inside a panel are left out here? */
static bool garment_patch(const mus_pattern *pattern, int32_t n, const int32_t *edges)
{
    bool left = false;
    for (int32_t i = 0; i < n; i++)
        left = left || (pattern->edge[edges[i]].nseam > 0 && !garment_sewn(pattern, edges[i]));
    const mus__panel *panel = &pattern->panel[pattern->edge[edges[0]].panel];
    for (int32_t i = 0; i < panel->noutline && left; i++) left = !garment_sewn(pattern, panel->outline[i]);
    return left;
}


/* compare the loops with the declared openings; taken (nopening) is zero, strange (loops) is scratch */
static mus_status garment_openings(const mus_pattern *pattern, int32_t loops, int32_t *taken, int32_t *strange,
                                   mus_faults *faults)
{
    int32_t left = 0, next = 0;
    for (int32_t loop = 0; loop < loops; loop++) {
        int32_t n;
        mus_status status;
        int32_t *edges = garment_loop(pattern, loop, &n, NULL, &status);
        const bool patch = status == MUS_OK && garment_patch(pattern, n, edges);
        const char *label = status == MUS_OK ? garment_label(pattern, n, edges) : "";
        mus__free(pattern->context, edges);
        if (status != MUS_OK) return status;
        if (patch) continue;
        int32_t k = 0;
        while (k < pattern->nopening && (taken[k] || strcmp(pattern->opening[k].label, label) != 0)) k++;
        if (k < pattern->nopening)
            taken[k] = 1;
        else
            strange[left++] = loop;
    }

    /* a loop that is not declared is reported in place of a declared one that is missing, as long as there are any */
    for (int32_t i = 0; i < left; i++) {
        while (next < pattern->nopening && taken[next]) next++;
        const char *missing = next < pattern->nopening ? pattern->opening[next].label : NULL;
        mus_status status = garment_opening(pattern, strange[i], missing, faults);
        if (status != MUS_OK) return status;
        if (next < pattern->nopening) taken[next] = 1;
    }
    for (int32_t k = 0; k < pattern->nopening; k++) {
        if (taken[k]) continue;
        mus__fault *fault = mus__fault_add(faults, MUS_FAULT_OPENING, MUS_NONE, MUS_NONE, MUS_NONE);
        if (fault == NULL) return MUS_ERR_MEMORY;
        snprintf(fault->text, sizeof fault->text, "opening %s: it is declared, and the sewn garment has none",
                 pattern->opening[k].label);
    }
    return MUS_OK;
}


/* closed bags: nothing can be put into them or through them */
static mus_status garment_bags(const mus_pattern *pattern, mus_faults *faults)
{
    mus_homology h;
    mus_homology_init(&h, sizeof h);
    mus_status status = mus_pattern_homology(pattern, 1, &h, NULL, 0);
    if (status != MUS_OK || h.betti[2] == 0) return status;
    mus__fault *fault = mus__fault_add(faults, MUS_FAULT_CLOSED, MUS_NONE, MUS_NONE, MUS_NONE);
    if (fault == NULL) return MUS_ERR_MEMORY;
    snprintf(fault->text, sizeof fault->text, "the seams close %d %s all round: a pocket or piece without a way in",
             (int)h.betti[2], h.betti[2] == 1 ? "bag" : "bags");
    return MUS_OK;
}


/* handles and openings; the pattern has no seams to lines inside panels */
static mus_status garment_surface(const mus_pattern *pattern, mus_faults *faults)
{
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    mus_status status = mus_pattern_topology(pattern, &t);
    if (status != MUS_OK || !t.manifold) return status;
    if (t.orientable && garment_handles(&t) > 0) status = garment_handle(pattern, garment_handles(&t), faults);
    if (status != MUS_OK) return status;

    int32_t *taken = mus__new(pattern->context, (int64_t)pattern->nopening + t.loops, sizeof *taken);
    if (taken == NULL) return MUS_ERR_MEMORY;
    status = garment_openings(pattern, t.loops, taken, taken + pattern->nopening, faults);
    mus__free(pattern->context, taken);
    return status;
}


mus_status mus__garment_faults(const mus_pattern *pattern, mus__quotient *q, mus_faults *faults)
{
    if (pattern->nopening == 0) return MUS_OK;
    for (int32_t i = 0; i < pattern->npanel; i++)
        if (pattern->panel[i].noutline == 0) return MUS_OK;
    mus_seam_def *seams = mus__room(pattern->context, pattern->nseam, sizeof *seams);
    if (seams == NULL) return MUS_ERR_MEMORY;
    mus_status status = garment_pieces(pattern, q, faults);
    if (status == MUS_OK) status = garment_bags(pattern, faults);
    mus_pattern bare = *pattern;
    bare.seam = seams;
    bare.nseam = 0;
    for (int32_t pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i < pattern->nseam; i++) {
            const mus_seam_def *seam = &pattern->seam[i];
            if ((seam->laid != 0) != (pass == 1) || mus__edge_inner(q, seam->edge_a) ||
                mus__edge_inner(q, seam->edge_b) ||
                (pass == 1 && (garment_sewn(&bare, seam->edge_a) || garment_sewn(&bare, seam->edge_b))))
                continue;
            seams[bare.nseam++] = *seam;
        }
    if (status == MUS_OK) status = garment_surface(&bare, faults);
    mus__free(pattern->context, seams);
    return status;
}
