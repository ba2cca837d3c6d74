/*
 * worn_openings.c: which limbs the pattern has for each boundary loop of the sewn cloth.
 *
 * Within a component of the garment every limb leaves by one loop, its opening. Where panels tell it, they decide: a
 * loop that is for the most part on panels with the label "arm", or with the label "leg" on one side of the wearer,
 * belongs to that limb. Else the arrangement decides: the linking numbers of the loops as the pattern places them.
 * Where these give a limb several loops it has the nearest one (a skirt whose panels start beyond the hands has the
 * arms in its hem, but the armholes are nearer); where they give it none, the longest loop that no limb has and that
 * is nearer to it than to the other limbs (a hood over the head).
 */
#include <string.h>

#include "fit/worn_internal.h"

#define OPENING_MOST 0.5  /* part of a loop's length; chosen: the majority */
#define OPENING_SIDE 0.9  /* part of a loop's length on panels of one side of the wearer; chosen: all but a placket */

typedef struct opening {
    double middle[3];              /* as placed [m] */
    double arm, leg, side[2];      /* parts of the count of its edges on panels: of arms, of legs, left, right */
    int32_t both[MUS_WORN_LIMBS][MUS__WORN_WAYS]; /* linking numbers as placed */
    int32_t link[MUS_WORN_LIMBS];  /* on the first way, the least 0 */
    int32_t labelled;              /* the limb that the panels tell, or MUS_NONE */
} opening;


/* what the panels of a loop tell, and where it is as placed */
static void opening_read(const mus_pattern *pattern, const mus_cloth *cloth, const mus__worn_axes *axes,
                         const double *placed, const mus__worn_loops *loops, int32_t loop, opening *out)
{
    const mus__worn_loop *own = &loops->loop[loop];
    const double part = 1.0 / own->count;
    int32_t least = 0, first = 1;
    memset(out, 0, sizeof *out);
    for (int32_t i = 0; i < own->count; i++) {
        const int32_t node = loops->node[own->first + i], panel = cloth->node_panel[node];
        const char *label = mus_pattern_panel_label(pattern, panel);
        const int32_t sides = mus_pattern_panel_sides(pattern, panel, NULL);
        for (int32_t d = 0; d < 3; d++) out->middle[d] += part * placed[3 * (ptrdiff_t)node + d];
        if (label != NULL && strcmp(label, "arm") == 0) out->arm += part;
        if (label != NULL && strcmp(label, "leg") == 0) out->leg += part;
        if (sides & MUS_SIDE_LEFT) out->side[0] += part;
        if (sides & MUS_SIDE_RIGHT) out->side[1] += part;
    }
    mus__worn_link(axes, loops, loop, placed, out->both);
    for (int32_t a = 0; a < MUS_WORN_LIMBS; a++)
        if (axes->count[a] > 0 && (first || out->both[a][0] < least)) least = out->both[a][0], first = 0;
    for (int32_t a = 0; a < MUS_WORN_LIMBS; a++) out->link[a] = axes->count[a] > 0 ? out->both[a][0] - least : 0;

    /* the side of an arm's panel without a side is that of the nearer arm */
    const int32_t nearer = mus__worn_distance(axes, MUS_WORN_ARM_RIGHT, out->middle) <
                           mus__worn_distance(axes, MUS_WORN_ARM_LEFT, out->middle);
    const int32_t right = out->side[1] > out->side[0] || (out->side[1] == out->side[0] && nearer);
    out->labelled = MUS_NONE;
    if (out->arm > OPENING_MOST) out->labelled = right ? MUS_WORN_ARM_RIGHT : MUS_WORN_ARM_LEFT;
    else if (out->leg > OPENING_MOST && out->side[right] > OPENING_SIDE && out->side[!right] < 1.0 - OPENING_SIDE)
        out->labelled = right ? MUS_WORN_LEG_RIGHT : MUS_WORN_LEG_LEFT;
}


/* the limb whose axis is nearest to a place */
static int32_t opening_nearest(const mus__worn_axes *axes, const double *place)
{
    int32_t best = 0;
    for (int32_t a = 1; a < MUS_WORN_LIMBS; a++)
        if (mus__worn_distance(axes, a, place) < mus__worn_distance(axes, best, place)) best = a;
    return best;
}


/* the loop of a component that is the opening of a limb, MUS_NONE without any. `rank` 2: by the labels of panels (the
 * longest of several); 1: by linking numbers (the nearest of several) */
static int32_t opening_of(const mus__worn_axes *axes, const mus__worn_loops *loops, const opening *of,
                          int32_t component, int32_t limb, int32_t rank)
{
    int32_t best = MUS_NONE;
    double merit = 0.0;
    for (int32_t l = 0; l < loops->nloop; l++) {
        if (loops->loop[l].component != component) continue;
        if (rank == 2 ? of[l].labelled != limb : of[l].link[limb] != 1 || of[l].labelled != MUS_NONE) continue;
        const double own = rank == 2 ? loops->loop[l].length : -mus__worn_distance(axes, limb, of[l].middle);
        if (best == MUS_NONE || own > merit) best = l, merit = own;
    }
    return best;
}


/* the longest loop of a component that no limb has and that is nearest to this limb */
static int32_t opening_spare(const mus__worn_axes *axes, const mus__worn_loops *loops, const opening *of,
                             int32_t component, int32_t limb)
{
    int32_t best = MUS_NONE;
    for (int32_t l = 0; l < loops->nloop; l++) {
        const mus__worn_loop *own = &loops->loop[l];
        if (own->component != component || own->expect != 0 || of[l].labelled != MUS_NONE) continue;
        if (opening_nearest(axes, of[l].middle) != limb) continue;
        if (best == MUS_NONE || own->length > loops->loop[best].length) best = l;
    }
    return best;
}


int32_t mus__worn_agree(const mus__worn_axes *axes, const mus__worn_loop *loop, int32_t sign,
                        int32_t link[MUS_WORN_LIMBS][MUS__WORN_WAYS], int32_t *common)
{
    int32_t most = -1, most_limbs = 0;
    for (int32_t by = 0; by < MUS_WORN_LIMBS * MUS__WORN_WAYS; by++) {
        const int32_t of = by / MUS__WORN_WAYS, way = by % MUS__WORN_WAYS;
        if (axes->count[of] == 0 || !(loop->judged >> of & 1)) continue;
        const int32_t shift = sign * link[of][way] - (loop->expect >> of & 1);
        int32_t count = 0, limbs = 0;
        for (int32_t limb = 0; limb < MUS_WORN_LIMBS; limb++) {
            int32_t right = 0;
            for (int32_t w = 0; w < MUS__WORN_WAYS; w++)
                right |= sign * link[limb][w] - shift == (loop->expect >> limb & 1);
            if (axes->count[limb] > 0 && (loop->judged >> limb & 1) && right) count++, limbs |= 1 << limb;
        }
        if (count > most) most = count, most_limbs = limbs, *common = shift;
    }
    return most_limbs;
}


static int32_t opening_bits(int32_t set)
{
    int32_t n = 0;
    for (; set != 0; set &= set - 1) n++;
    return n;
}


/* whether a loop with these linking numbers is before the face, with cloth over the crown */
static bool opening_over(const mus__worn_axes *axes, const mus__worn_loop *loop,
                         int32_t link[MUS_WORN_LIMBS][MUS__WORN_WAYS])
{
    int32_t common = 0;
    if (!(loop->expect >> MUS_WORN_NECK & 1)) return false;
    mus__worn_agree(axes, loop, loop->sign, link, &common);
    return loop->sign * link[MUS_WORN_NECK][0] == common &&
           (loop->sign * link[MUS_WORN_NECK][1] == common + 1 || loop->sign * link[MUS_WORN_NECK][2] == common + 1);
}


/* sign and over of the loops of a component, by their linking numbers as placed */
static void opening_signs(const mus__worn_axes *axes, const opening *of, int32_t component, mus__worn_loops *loops)
{
    double turned = 0.0, all = 0.0;
    for (int32_t l = 0; l < loops->nloop; l++) {
        mus__worn_loop *own = &loops->loop[l];
        int32_t common = 0, link[MUS_WORN_LIMBS][MUS__WORN_WAYS];
        if (own->component != component) continue;
        memcpy(link, of[l].both, sizeof link);
        const int32_t back = opening_bits(mus__worn_agree(axes, own, -1, link, &common));
        const int32_t plain = opening_bits(mus__worn_agree(axes, own, 1, link, &common));
        own->sign = back > plain ? -1 : 1;
        if (own->expect == 0) continue;
        all += own->length;
        if (own->sign < 0) turned += own->length;
        own->over = opening_over(axes, own, link);
    }
    for (int32_t l = 0; l < loops->nloop && turned > 0.5 * all; l++)
        if (loops->loop[l].component == component) loops->loop[l].sign = -loops->loop[l].sign;
}


mus_status mus__worn_expect(const mus_pattern *pattern, const mus_cloth *cloth, const mus__worn_axes *axes,
                            const double *placed, mus__worn_loops *loops)
{
    opening *of = mus__new(loops->context, loops->nloop + 1, sizeof *of);
    if (of == NULL) return mus__fail_memory(loops->context, "the openings of a garment");
    for (int32_t l = 0; l < loops->nloop; l++) {
        loops->loop[l].expect = 0;
        opening_read(pattern, cloth, axes, placed, loops, l, &of[l]);
    }
    for (int32_t rank = 2; rank >= 0; rank--)
        for (int32_t panel = 0; panel < cloth->npanel; panel++) {
            int32_t taken = 0, here = 0;
            for (int32_t l = 0; l < loops->nloop; l++)
                if (loops->loop[l].component == panel) taken |= loops->loop[l].expect, here++;
            for (int32_t limb = 0; limb < MUS_WORN_LIMBS && here > 0 && (rank > 0 || taken != 0); limb++) {
                if (axes->count[limb] == 0 || (taken >> limb & 1)) continue;
                const int32_t l = rank > 0 ? opening_of(axes, loops, of, panel, limb, rank)
                                           : opening_spare(axes, loops, of, panel, limb);
                if (l != MUS_NONE) loops->loop[l].expect |= 1 << limb;
            }
        }
    for (int32_t l = 0; l < loops->nloop; l++)
        for (int32_t k = 0; k < loops->nloop; k++)
            if (loops->loop[k].component == loops->loop[l].component) loops->loop[l].judged |= loops->loop[k].expect;
    for (int32_t panel = 0; panel < cloth->npanel; panel++) opening_signs(axes, of, panel, loops);
    mus__free(loops->context, of);
    return MUS_OK;
}


void mus__worn_over(const mus__worn_axes *axes, const double *x, mus__worn_loops *loops)
{
    for (int32_t l = 0; l < loops->nloop; l++) {
        mus__worn_loop *own = &loops->loop[l];
        int32_t link[MUS_WORN_LIMBS][MUS__WORN_WAYS];
        if (own->over || !(own->expect >> MUS_WORN_NECK & 1)) continue;
        mus__worn_link(axes, loops, l, x, link);
        own->over = opening_over(axes, own, link);
    }
}
