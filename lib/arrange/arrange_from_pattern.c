/*
 * arrange_from_pattern.c: reads what a pattern tells of its panels: outlines as seen from outside, seams, labels and
 * sides.
 *
 * Up is as drawn, except on an arm, where it is the direction from the hand to the panel that the sleeve is sewn to, by
 * quarter turns: a sleeve may be drawn along the arm or across it. A collar or hood that is drawn with the edge to the
 * neck above is turned over, so that it stands on that edge: flat collars are drawn as they lie.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_internal.h"
#include "base/elementary.h"
#include "geom/vec.h"

#define READ_SIDE 0.5 /* horizontal component of the unit normal from which on an edge is a side */


/* the limb that a panel goes round, by its label */
static int32_t read_limb(const char *label)
{
    static const struct {
        const char *label;
        int32_t limb;
    } limbs[] = {{"arm", MUS__ARRANGE_ARM},
                 {"neck", MUS__ARRANGE_NECK},
                 {"collar", MUS__ARRANGE_NECK},
                 {"hood", MUS__ARRANGE_NECK}};
    for (size_t i = 0; i < sizeof limbs / sizeof *limbs; i++)
        if (strcmp(label, limbs[i].label) == 0) return limbs[i].limb;
    return MUS__ARRANGE_TRUNK;
}


/* takes the edges of an outline: dots as drawn, lengths; and the signed area */
static mus_status read_panel(mus__arrangement *arrangement, int32_t p)
{
    mus__arranged_panel *panel = &arrangement->panel[p];
    double twice = 0.0, t[MUS__ARRANGE_DOTS];
    for (int32_t i = 0; i < MUS__ARRANGE_DOTS; i++) t[i] = i / (MUS__ARRANGE_DOTS - 1.0);
    mus_status status = mus_pattern_outline(arrangement->pattern, p, &panel->nedge, &panel->edge, &panel->direction);
    for (int32_t i = 0; i < panel->nedge && status == MUS_OK; i++) {
        mus__arranged_edge *edge = &arrangement->edge[panel->edge[i]];
        edge->panel = p;
        edge->length = mus_pattern_edge_length(arrangement->pattern, panel->edge[i]);
        status = mus_pattern_edge_at(arrangement->pattern, panel->edge[i], MUS__ARRANGE_DOTS, t, edge->dot);
        for (int32_t k = 0; k + 1 < MUS__ARRANGE_DOTS; k++) {
            const double *a = edge->dot + 2 * k, *b = a + 2;
            twice += panel->direction[i] * (a[0] * b[1] - a[1] * b[0]);
        }
    }
    panel->sign = twice < 0.0 ? -1.0 : 1.0;
    panel->area = 0.5 * fabs(twice);
    panel->turn[0] = 1.0;
    panel->ring = MUS_NONE;
    panel->limb = read_limb(mus_pattern_panel_label(arrangement->pattern, p));
    panel->says = mus_pattern_panel_sides(arrangement->pattern, p, NULL);
    panel->turned = panel->limb != MUS__ARRANGE_ARM;
    return status;
}


/* turns the dots of a panel to (h, v); takes its box, and the outward normal of each edge */
static void read_turn(mus__arrangement *arrangement, mus__arranged_panel *panel)
{
    const double c = panel->turn[0], s = panel->turn[1];
    for (int32_t k = 0; k < 2; k++) panel->low[k] = 1e30, panel->high[k] = -1e30;
    for (int32_t i = 0; i < panel->nedge; i++) {
        mus__arranged_edge *edge = &arrangement->edge[panel->edge[i]];
        for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++) {
            double *dot = edge->dot + 2 * k;
            const double w = panel->sign * dot[0], y = dot[1];
            dot[0] = c * w + s * y, dot[1] = c * y - s * w;
            for (int32_t d = 0; d < 2; d++) {
                panel->low[d] = fmin(panel->low[d], dot[d]);
                panel->high[d] = fmax(panel->high[d], dot[d]);
            }
        }
        const double *a = edge->dot, *b = edge->dot + 2 * (MUS__ARRANGE_DOTS - 1), chord = mus__dist2(a, b);
        const double along = panel->direction[i] / (chord > 0.0 ? chord : 1.0);
        edge->outward[0] = along * (b[1] - a[1]), edge->outward[1] = along * (a[0] - b[0]);
    }
}


/* out (2) gets the vector from the edges of a panel that are sewn to panels with a known up to its middle, as drawn but
 * seen from outside; other panels of the neck tell a panel of the neck nothing. False without such edges */
static bool read_down(const mus__arrangement *arrangement, int32_t p, double *out)
{
    const mus__arranged_panel *panel = &arrangement->panel[p];
    double sum[2] = {0.0, 0.0}, all = 0.0, low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
    for (int32_t i = 0; i < panel->nedge; i++) {
        const mus__arranged_edge *edge = &arrangement->edge[panel->edge[i]];
        const int32_t seam = edge->seam;
        int32_t other = MUS_NONE;
        if (seam != MUS_NONE) {
            const mus__arranged_seam *own = &arrangement->seam[seam];
            other = arrangement->edge[own->a == panel->edge[i] ? own->b : own->a].panel;
        }
        const bool anchor = other != MUS_NONE && other != p && arrangement->panel[other].turned &&
                            (panel->limb == MUS__ARRANGE_ARM || arrangement->panel[other].limb != panel->limb);
        for (int32_t k = 0; k < MUS__ARRANGE_DOTS; k++)
            for (int32_t d = 0; d < 2; d++) {
                const double x = (d == 0 ? panel->sign : 1.0) * edge->dot[2 * k + d];
                low[d] = fmin(low[d], x), high[d] = fmax(high[d], x);
                if (anchor) sum[d] += edge->length * x;
            }
        if (anchor) all += MUS__ARRANGE_DOTS * edge->length;
    }
    for (int32_t d = 0; d < 2; d++) out[d] = 0.5 * (low[d] + high[d]) - (all > 0.0 ? sum[d] / all : 0.0);
    return all > 0.0;
}


/* turns the panels of arms so that v points away from the hand, beginning with those that are sewn to other panels */
static void read_arms(mus__arrangement *arrangement)
{
    int32_t *now = arrangement->work, n;
    do {
        n = 0;
        for (int32_t p = 0; p < arrangement->npanel; p++) {
            double down[2];
            mus__arranged_panel *panel = &arrangement->panel[p];
            if (panel->turned || !read_down(arrangement, p, down)) continue;

            /* v = cos y - sin w points against `down` */
            const bool across = fabs(down[0]) > fabs(down[1]);
            panel->turn[0] = across ? 0.0 : down[1] > 0.0 ? -1.0 : 1.0;
            panel->turn[1] = across ? (down[0] > 0.0 ? 1.0 : -1.0) : 0.0;
            now[n++] = p;
        }
        for (int32_t i = 0; i < n; i++) arrangement->panel[now[i]].turned = 1;
    } while (n > 0);
}


/* turns collars and hoods that are drawn with the edge to the neck above, so that they stand on it */
static void read_necks(mus__arrangement *arrangement)
{
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        double up[2];
        mus__arranged_panel *panel = &arrangement->panel[p];
        if (panel->limb == MUS__ARRANGE_NECK && read_down(arrangement, p, up) && up[1] < 0.0) panel->turn[0] = -1.0;
    }
}


int32_t mus__arrange_partner(const mus__arrangement *arrangement, const mus__arranged_seam *seam, int32_t i)
{
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    mus_pattern_seam(arrangement->pattern, (int32_t)(seam - arrangement->seam), &def);
    return def.direction == MUS_SEAM_DIRECT ? i : MUS__ARRANGE_DOTS - 1 - i;
}


/* marks a fan of more than half a circle: sides that face right lie to the left of those that face left */
static void read_fan(mus__arrangement *arrangement, int32_t p)
{
    mus__arranged_panel *panel = &arrangement->panel[p];
    double place[2] = {0.0, 0.0}, length[2] = {0.0, 0.0};
    for (int32_t i = 0; i < panel->nedge; i++) {
        const mus__arranged_edge *edge = &arrangement->edge[panel->edge[i]];
        if (edge->seam == MUS_NONE || !(fabs(edge->outward[0]) > READ_SIDE)) continue;
        const mus__arranged_seam *seam = &arrangement->seam[edge->seam];
        const int32_t other = arrangement->edge[seam->a == panel->edge[i] ? seam->b : seam->a].panel;
        if (other == p || arrangement->panel[other].limb != panel->limb) continue;
        const int32_t right = edge->outward[0] > 0.0;
        place[right] += edge->length * edge->dot[2 * (MUS__ARRANGE_DOTS / 2)];
        length[right] += edge->length;
    }
    if (length[0] > 0.0 && length[1] > 0.0) panel->fan = place[1] / length[1] < place[0] / length[0];
}


/* finds a band that goes round the neck: its two sides alone are sewn, to edges that point up, all on one panel or on
 * panels of the front alone or of the back alone. A strap over the shoulder joins front and back */
static void read_halter(mus__arrangement *arrangement, int32_t p)
{
    mus__arranged_panel *panel = &arrangement->panel[p];
    int32_t sides = 0, only = MUS_NONE, says = MUS__ARRANGE_FRONT | MUS__ARRANGE_BACK;
    bool one = true;
    for (int32_t i = 0; i < panel->nedge; i++) {
        const mus__arranged_edge *edge = &arrangement->edge[panel->edge[i]];
        if (edge->seam == MUS_NONE) continue;
        const mus__arranged_seam *seam = &arrangement->seam[edge->seam];
        const mus__arranged_edge *other = &arrangement->edge[seam->a == panel->edge[i] ? seam->b : seam->a];
        if (!(fabs(edge->outward[0]) > READ_SIDE) || !(other->outward[1] > MUS__EDGE_UP) || other->panel == p) return;
        sides |= edge->outward[0] > 0.0 ? 1 : 2;
        one = one && (only == MUS_NONE || only == other->panel);
        only = other->panel;
        says &= arrangement->panel[only].says;
    }
    const bool half = says == MUS__ARRANGE_FRONT || says == MUS__ARRANGE_BACK;
    if (panel->limb == MUS__ARRANGE_TRUNK && sides == 3 && (one || half)) panel->limb = MUS__ARRANGE_NECK;
}


/* takes the step of a seam, and whether it joins two panels side by side: one edge faces right, the other left */
static void read_seam(mus__arrangement *arrangement, mus__arranged_seam *seam)
{
    const mus__arranged_edge *a = &arrangement->edge[seam->a], *b = &arrangement->edge[seam->b];
    const mus__arranged_panel *p = &arrangement->panel[a->panel], *q = &arrangement->panel[b->panel];
    double low = 0.0;
    seam->length = 0.5 * (a->length + b->length);
    for (int32_t i = 0; i < MUS__ARRANGE_DOTS; i++) {
        const int32_t k = mus__arrange_partner(arrangement, seam, i);
        for (int32_t d = 0; d < 2; d++) seam->step[d] += (a->dot[2 * i + d] - b->dot[2 * k + d]) / MUS__ARRANGE_DOTS;
        low += 0.5 * (a->dot[2 * i + 1] - p->high[1] + b->dot[2 * k + 1] - q->high[1]) / MUS__ARRANGE_DOTS;
    }
    seam->high = low;
    if (p->limb != q->limb || p->fan || q->fan) return;
    if (a->outward[0] > READ_SIDE && b->outward[0] < -READ_SIDE) seam->beside = 1;
    if (a->outward[0] < -READ_SIDE && b->outward[0] > READ_SIDE) seam->beside = -1;
}


/* a seam that is divided, by a zip or a notch, places its panels as one that is whole: all parts take the mean step,
 * weighted by length */
static void read_parts(mus__arrangement *arrangement, int32_t first)
{
    const mus__arranged_seam *one = &arrangement->seam[first];
    const int32_t p = arrangement->edge[one->a].panel, q = arrangement->edge[one->b].panel;
    double length = 0.0, step[2] = {0.0, 0.0};
    for (int32_t pass = 0; pass < 2; pass++)
        for (int32_t i = first; i < arrangement->nseam; i++) {
            mus__arranged_seam *seam = &arrangement->seam[i];
            const int32_t a = arrangement->edge[seam->a].panel, b = arrangement->edge[seam->b].panel;
            const double sign = a == p && b == q && seam->beside == one->beside    ? 1.0
                                : a == q && b == p && seam->beside == -one->beside ? -1.0
                                                                                   : 0.0;
            if (sign == 0.0) continue;
            if (pass == 0) length += seam->length;
            for (int32_t d = 0; d < 2; d++) {
                if (pass == 0)
                    step[d] += sign * seam->length * seam->step[d];
                else
                    seam->step[d] = sign * step[d] / length;
            }
        }
}


mus_status mus__arrange_read(mus__arrangement *arrangement)
{
    mus_status status = MUS_OK;
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    for (int32_t i = 0; i < arrangement->nedge; i++) arrangement->edge[i].panel = arrangement->edge[i].seam = MUS_NONE;
    for (int32_t p = 0; p < arrangement->npanel && status == MUS_OK; p++) {
        status = read_panel(arrangement, p);
        if (status == MUS_OK && arrangement->panel[p].nedge == 0)
            status = mus__fail(arrangement->context, MUS_ERR_PATTERN, "place: panel %s has no outline",
                               mus_pattern_panel_name(arrangement->pattern, p));
    }
    for (int32_t i = 0; i < arrangement->nseam && status == MUS_OK; i++) {
        status = mus_pattern_seam(arrangement->pattern, i, &def);
        arrangement->seam[i].a = def.edge_a, arrangement->seam[i].b = def.edge_b;
        if (arrangement->edge[def.edge_a].panel == MUS_NONE || arrangement->edge[def.edge_b].panel == MUS_NONE)
            return mus__fail(arrangement->context, MUS_ERR_PATTERN, "place: seam %d has an edge of no outline", (int)i);
        arrangement->edge[def.edge_a].seam = arrangement->edge[def.edge_b].seam = i;
    }
    if (status != MUS_OK) return status;
    read_arms(arrangement);
    read_necks(arrangement);
    for (int32_t p = 0; p < arrangement->npanel; p++) read_turn(arrangement, &arrangement->panel[p]);
    for (int32_t p = 0; p < arrangement->npanel; p++) read_halter(arrangement, p);
    for (int32_t p = 0; p < arrangement->npanel; p++) read_fan(arrangement, p);
    for (int32_t i = 0; i < arrangement->nseam; i++) read_seam(arrangement, &arrangement->seam[i]);
    for (int32_t i = 0; i < arrangement->nseam; i++)
        if (arrangement->seam[i].beside != 0) read_parts(arrangement, i);
    return MUS_OK;
}


void mus__arrange_point(const mus__arranged_panel *panel, double h, double v, double *out)
{
    double x = h - panel->line, z = 0.0;
    if (panel->bend > 0.0) {
        const double angle = x / panel->bend;
        x = panel->bend * mus__sin(angle), z = panel->bend * (mus__cos(angle) - 1.0);
    }
    for (int32_t d = 0; d < 3; d++) out[d] = panel->at[d] + x * panel->along[d] + v * panel->up[d] + z * panel->out[d];
}
