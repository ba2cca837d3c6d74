/*
 * slid_off.c: whether a component of the garment (panels that hang together by seams) has left its place on the body.
 *
 * Cloth that begins above the bust is carried by the shoulders or the bust, cloth that begins lower by the waist or the
 * hip. A component has slid off when its uppermost node is 8 cm lower than its carrier and than where it began:
 * lower than the bust if it began above the bust, lower than the hip if it began between bust and hip, lower than the
 * armpits if it began on the shoulders. Loose cloth has slid off when no node is near the body. A component with
 * attachments does not slide. A sewn component that began 8 cm or more below the bust and now lies wholly above the
 * armpits has rolled up round the neck; attachments do not excuse that.
 */
#include <math.h>
#include <stdio.h>

#include "arrange/arrange_nodes.h"
#include "drape/drape_state.h"
#include "dress/diagnosis.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"

/* all chosen; the corpus of GarmentCode patterns shows which garments are told as slid off when they change */
#define SLID_DEEP 0.08     /* [m] below what carried a component, and below where it began */
#define SLID_TOP 0.02      /* [m] a component that begins at most this far below the bust counts as above it */
#define SLID_STRAP 0.08    /* [m] above the armpits: a component that begins higher hangs on the shoulders */
#define OFF_THE_BODY 0.005 /* [m] from the skin: a node farther off is not carried */


/* heights along `up` of the components at places x: component.high and component.low of each root; and component.panel,
 * the panel of the uppermost node, if `panels` */
static void slid_heights(const mus_drape *drape, const double *x, const double *up, bool panels)
{
    const mus_cloth *cloth = drape->cloth;
    mus__component *component = drape->relax.component;
    for (int32_t p = 0; p < cloth->npanel; p++) component[p].high = -INFINITY, component[p].low = INFINITY;
    for (int32_t i = 0; i < drape->n; i++) {
        mus__component *own = &component[component[cloth->node_panel[i]].root];
        const double height = mus__dot3(up, x + 3 * (int64_t)drape->rep[i]);
        if (height < own->low) own->low = height;
        if (!(height > own->high)) continue;
        own->high = height;
        if (panels) own->panel = cloth->node_panel[i];
    }
}


/* the root of each panel's component: its lowest panel. There are few panels, so sweeps until nothing changes */
static void slid_roots(const mus_cloth *cloth, mus__component *component)
{
    for (int32_t p = 0; p < cloth->npanel; p++) component[p].root = p;
    for (bool changed = true; changed;) {
        changed = false;
        for (int32_t k = 0; k < cloth->npair; k++) {
            int32_t *a = &component[cloth->node_panel[cloth->pair[2 * k]]].root;
            int32_t *b = &component[cloth->node_panel[cloth->pair[2 * k + 1]]].root;
            if (*a == *b) continue;
            *a = *b = *a < *b ? *a : *b;
            changed = true;
        }
    }
}


mus_status mus__slid_off_start(mus_drape *drape, const double *x)
{
    const mus_cloth *cloth = drape->cloth;
    mus__level_plane hip;
    mus__scene_level(drape, MUS_HOLD_HIP, 0, &hip);
    if (!hip.there || cloth->npanel == 0) return MUS_OK;
    double *placed = mus__new(drape->context, 3 * (int64_t)drape->n, sizeof *placed);
    mus__component *component = drape->relax.component;
    if (component == NULL) component = mus__new(drape->context, cloth->npanel, sizeof *component);
    if (placed == NULL || component == NULL) {
        mus__free(drape->context, placed);
        if (drape->relax.component == NULL) mus__free(drape->context, component);
        return mus__fail_memory(drape->context, "the components of a garment");
    }
    drape->relax.component = component;
    slid_roots(cloth, component);
    slid_heights(drape, x, hip.up, true);
    for (int32_t p = 0; p < cloth->npanel; p++) component[p].top = component[p].high;

    /* sewing may have thrown the garment up or let it fall, so it began where the pattern places it. A garment that was
     * worn before began where it hangs, but no higher than that. Attached components do not slide */
    mus__arrange_nodes(cloth, placed);
    slid_heights(drape, placed, hip.up, false);
    for (int32_t p = 0; p < cloth->npanel; p++) {
        component[p].foot = component[p].low;
        component[p].top = drape->relax.far ? component[p].high : fmin(component[p].top, component[p].high);
    }
    for (int32_t h = 0; h < drape->program.nattachment; h++)
        component[component[cloth->node_panel[drape->program.attachment[h].node]].root].top = -INFINITY;
    mus__free(drape->context, placed);
    return MUS_OK;
}


/* writes the reason: the garment, or its panel, and where it is now; where "" is off the body */
static void slid_say(mus_drape *drape, int32_t panel, const char *where)
{
    const mus_cloth *cloth = drape->cloth;
    const char *garment = mus_cloth_name(cloth), *name = panel != MUS_NONE ? mus_cloth_panel_name(cloth, panel) : "";
    const double time = drape->counters.settle_time;
    char text[256];
    snprintf(text, sizeof text, "slid off%s: %.100s%s%.60s at %.1f s", where[0] != '\0' ? "" : " the body",
             garment[0] != '\0' ? garment : name, where[0] != '\0' ? " " : "", where, time);
    mus__diagnosis_set(drape, MUS_REASON_SLID_OFF, panel, MUS_NONE, MUS_NONE, time, text);
}


/* whether nothing is attached or pinned, and no node is near the body any more */
static bool slid_loose(const mus_drape *drape, const double *x)
{
    double normal[3 * MUS__TOUCHING_MAX], friction[MUS__TOUCHING_MAX];
    if (drape->program.nattachment > 0) return false;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->pinned[i]) return false;
        if (drape->mass[i] <= 0.0) continue;
        if (mus__collider_touching(drape->scene.collider, x + 3 * (int64_t)i, OFF_THE_BODY, normal, friction) > 0)
            return false;
    }
    return true;
}


/* where a component whose uppermost node is at `top` now has slid to, NULL while it is worn; heights along the torso */
static const char *slid_where(const mus__component *component, double top, double bust, double armpit, double hip)
{
    const bool high = component->top > bust - SLID_TOP;
    const double carried = high ? bust : hip;
    if (!(component->top > hip)) return NULL;
    if (top < carried - SLID_DEEP && top < component->top - SLID_DEEP) return high ? "below bust" : "below hip";
    return component->top > armpit + SLID_STRAP && top < armpit ? "below armpit" : NULL;
}


/* the first component at x that has left its place, by its root, MUS_NONE without any; *where names where it is */
static int32_t slid_component(const mus_drape *drape, const double *x, const char **where)
{
    const mus_cloth *cloth = drape->cloth;
    mus__level_plane bust, hip, armpit;
    mus__scene_level(drape, MUS_HOLD_BUST, 0, &bust);
    mus__scene_level(drape, MUS_HOLD_HIP, 0, &hip);
    mus__scene_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    if (!bust.there || !hip.there || drape->relax.component == NULL) return MUS_NONE;
    const double breast = mus__dot3(hip.up, bust.point);
    const double under = armpit.there ? mus__dot3(hip.up, armpit.point) : INFINITY;
    slid_heights(drape, x, hip.up, false);
    for (int32_t p = 0; p < cloth->npanel; p++) {
        const mus__component *component = &drape->relax.component[p];
        if (component->root != p) continue;
        *where = slid_where(component, component->high, breast, under, hip.at);
        const bool round = cloth->npair > 0 && component->foot < breast - SLID_DEEP;
        if (*where == NULL && round && component->low > under) *where = "above armpit";
        if (*where != NULL) return p;
    }
    return MUS_NONE;
}


int32_t mus__slid_off(mus_drape *drape, const double *x, int32_t loose)
{
    const char *where = "";
    if (drape->scene.collider == NULL) return 0;
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->pinned[i]) return 0;
    const int32_t root = slid_component(drape, x, &where);
    if (root != MUS_NONE) {
        slid_say(drape, drape->relax.component[root].panel, where);
        return 1;
    }
    if (!loose || !slid_loose(drape, x)) return 0;
    slid_say(drape, MUS_NONE, "");
    return 1;
}
