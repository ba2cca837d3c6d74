/*
 * panel_attributes.c: what is said of a panel: its label, sides, grain, cut and layer, and where it stands before
 * sewing. cut_pieces.c says of which materials it is cut.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "pattern/pattern_internal.h"

/* largest error of R^T R - 1 of a placement: files give angles and entries to 6 digits or more */
#define ROTATION_SLACK 1e-6
/* [m] least radius that a panel is rolled on; chosen: below any garment, and above a division by almost 0 */
#define SMALLEST_BEND 0.001


const char *mus_pattern_panel_name(const mus_pattern *pattern, int32_t panel)
{
    return pattern != NULL && panel >= 0 && panel < pattern->npanel ? pattern->panel[panel].name : NULL;
}


mus_status mus_pattern_set_panel_label(mus_pattern *pattern, int32_t panel, const char *label)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK)
        status = mus__pattern_take_name(pattern, "panel label", label, pattern->panel[panel].attr.label);
    if (status == MUS_OK) mus__pattern_edited(pattern);
    return status;
}


const char *mus_pattern_panel_label(const mus_pattern *pattern, int32_t panel)
{
    return pattern != NULL && panel >= 0 && panel < pattern->npanel ? pattern->panel[panel].attr.label : NULL;
}


/* sides without those that come with their opposites */
static int32_t sides_alone(int32_t sides)
{
    static const int32_t opposite[] = {MUS_SIDE_FRONT | MUS_SIDE_BACK, MUS_SIDE_LEFT | MUS_SIDE_RIGHT};
    for (size_t i = 0; i < sizeof opposite / sizeof *opposite; i++)
        if ((sides & opposite[i]) == opposite[i]) sides &= ~opposite[i];
    return sides;
}


/* whether `word`, of small letters, is in a name: it begins the name, follows no letter, or is a capital after a small
 * letter ("FrontSide", "side_front", "sideFront"), and no small letter follows it */
static bool sides_word(const char *name, const char *word)
{
    for (const char *at = name; *at != '\0'; at++) {
        const bool small = *at >= 'a' && *at <= 'z';
        const char before = at == name ? '_' : at[-1];
        if ((before >= 'a' && before <= 'z' && small) || (before >= 'A' && before <= 'Z')) continue;
        size_t k = 0;
        while (word[k] != '\0' && (at[k] | 32) == word[k]) k++;
        if (word[k] == '\0' && !(at[k] >= 'a' && at[k] <= 'z')) return true;
    }
    return false;
}


int32_t mus__sides_named(const char *name)
{
    static const struct {
        const char *word;
        int32_t side;
    } words[] = {
        {"front", MUS_SIDE_FRONT}, {"back", MUS_SIDE_BACK}, {"left", MUS_SIDE_LEFT}, {"right", MUS_SIDE_RIGHT}};
    int32_t sides = 0;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (sides_word(name, words[i].word)) sides |= words[i].side;
    return sides_alone(sides);
}


mus_status mus_pattern_set_panel_sides(mus_pattern *pattern, int32_t panel, int32_t sides)
{
    const int32_t all = MUS_SIDE_FRONT | MUS_SIDE_BACK | MUS_SIDE_LEFT | MUS_SIDE_RIGHT;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    mus__panel *own = &pattern->panel[panel];
    if (sides < 0 || sides > all)
        return mus__fail(pattern->context, MUS_ERR_ARG, "panel %s: sides are %d, expected 0 to %d", own->name,
                         (int)sides, (int)all);
    own->attr.sides = sides_alone(sides);
    mus__pattern_edited(pattern);
    return MUS_OK;
}


int32_t mus_pattern_panel_sides(const mus_pattern *pattern, int32_t panel, int32_t *given)
{
    const bool known = pattern != NULL && panel >= 0 && panel < pattern->npanel;
    const int32_t sides = known ? pattern->panel[panel].attr.sides : MUS_NONE;
    if (given != NULL) *given = sides != MUS_NONE;
    return !known ? 0 : sides != MUS_NONE ? sides : mus__sides_named(pattern->panel[panel].name);
}


mus_status mus_pattern_set_grain(mus_pattern *pattern, int32_t panel, double x, double y)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    double length = mus__hypot(x, y);
    if (!mus__finite(length) || length == 0.0)
        return mus__fail(pattern->context, MUS_ERR_ARG, "grain of panel %s: (%g, %g) is no direction",
                         pattern->panel[panel].name, x, y);

    /* a unit vector is kept as given, so that writing and reading a file changes no bit */
    bool unit = fabs(length - 1.0) < 4.0e-16;
    pattern->panel[panel].attr.grain[0] = unit ? x : x / length;
    pattern->panel[panel].attr.grain[1] = unit ? y : y / length;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_grain(const mus_pattern *pattern, int32_t panel, double *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "grain: out is NULL");
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK) memcpy(out, pattern->panel[panel].attr.grain, 2 * sizeof *out);
    return status;
}


mus_status mus_pattern_set_cut(mus_pattern *pattern, int32_t panel, int32_t count, int32_t mirror_of)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK && mirror_of != MUS_NONE)
        status = mus__pattern_known(pattern, "panel", mirror_of, pattern->npanel);
    if (status != MUS_OK) return status;

    mus__panel *own = &pattern->panel[panel];
    if (count < 0 || count > MUS__CUT_MOST)
        return mus__fail(context, MUS_ERR_ARG, "panel %s: %d pieces to cut is outside 0 to %d", own->name, (int)count,
                         MUS__CUT_MOST);

    /* an image of an image would leave both unprinted */
    if (mirror_of == panel || (mirror_of != MUS_NONE && pattern->panel[mirror_of].mirror_of != MUS_NONE))
        return mus__fail(context, MUS_ERR_ARG, "panel %s: it cannot mirror panel %s, which %s", own->name,
                         pattern->panel[mirror_of].name, mirror_of == panel ? "is itself" : "mirrors another");
    own->attr.cut[MUS_MATERIAL_MAIN] = count;
    own->mirror_of = mirror_of;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_cut(const mus_pattern *pattern, int32_t panel, int32_t *count, int32_t *mirror_of)
{
    if (count != NULL) *count = 0;
    if (mirror_of != NULL) *mirror_of = MUS_NONE;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    if (count != NULL) *count = pattern->panel[panel].attr.cut[MUS_MATERIAL_MAIN];
    if (mirror_of != NULL) *mirror_of = pattern->panel[panel].mirror_of;
    return MUS_OK;
}


void mus__panel_attributes_init(mus__panel_attributes *attr)
{
    *attr = (mus__panel_attributes){.cut = {[MUS_MATERIAL_MAIN] = 1}, .sides = MUS_NONE, .grain = {0.0, 1.0}};
    mus_placement_init(&attr->placement, sizeof attr->placement);
}


void mus_placement_init(mus_placement *placement, size_t size)
{
    mus_placement own = {.rotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
    mus__def_init(placement, size, &own, sizeof own);
}


/* is every number finite, and R^T R = 1 with det R = +1? */
static mus_status placement_check(mus_context *context, const char *name, const mus_placement *p)
{
    mus_status status = mus__check_near(context, 1, 3, p->origin, "placement of panel %s: origin", name);
    if (status == MUS_OK) status = mus__check_near(context, 1, 1, &p->bend_x, "placement of panel %s: bend_x", name);
    if (status != MUS_OK) return status;
    bool finite = mus__finite(p->bend) && mus__finite(p->fold);
    for (int32_t i = 0; i < 9; i++) finite = finite && mus__finite(p->rotation[i]);
    if (!finite) return mus__fail(context, MUS_ERR_ARG, "placement of panel %s: a number is not finite", name);
    if (p->bend != 0.0 && fabs(p->bend) < SMALLEST_BEND)
        return mus__fail(context, MUS_ERR_ARG, "placement of panel %s: a bend of %g m is tighter than %g m", name,
                         p->bend, SMALLEST_BEND);

    if (!(p->fold >= 0.0 && p->fold <= 1.0))
        return mus__fail(context, MUS_ERR_ARG, "placement of panel %s: pleats folded to %g of their depth, not 0 to 1",
                         name, p->fold);

    const double *r = p->rotation;
    double worst = 0.0;
    for (int32_t i = 0; i < 3; i++) {
        for (int32_t j = 0; j < 3; j++) {
            double dot = r[i] * r[j] + r[3 + i] * r[3 + j] + r[6 + i] * r[6 + j];
            worst = fmax(worst, fabs(dot - (i == j ? 1.0 : 0.0)));
        }
    }
    double det =
        r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) + r[2] * (r[3] * r[7] - r[4] * r[6]);
    if (worst > ROTATION_SLACK || det < 0.0)
        return mus__fail(context, MUS_ERR_ARG,
                         "placement of panel %s: the matrix is no rotation (determinant %g, off by %g, limit %g)", name,
                         det, worst, ROTATION_SLACK);
    return MUS_OK;
}


mus_status mus_pattern_set_placement(mus_pattern *pattern, int32_t panel, const mus_placement *placement)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    if (placement == NULL)
        return mus__fail(context, MUS_ERR_ARG, "placement of panel %s: it is NULL", pattern->panel[panel].name);

    mus_placement own;
    mus_placement_init(&own, sizeof own);
    status = mus__def_read(context, &own, sizeof own, sizeof own, placement, "placement");
    if (status == MUS_OK) status = placement_check(context, pattern->panel[panel].name, &own);
    if (status != MUS_OK) return status;
    pattern->panel[panel].attr.placement = own;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


mus_status mus_pattern_placement(const mus_pattern *pattern, int32_t panel, mus_placement *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "placement: out is NULL");
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status != MUS_OK) return status;
    return mus__pattern_give(pattern, out, &pattern->panel[panel].attr.placement, sizeof *out, "placement");
}


mus_status mus__layer_check(const mus_pattern *pattern, int32_t layer)
{
    if (layer >= 0 && layer < MUS_LAYERS_MOST) return MUS_OK;
    return mus__fail(pattern->context, MUS_ERR_ARG, "layer is %d, expected 0 to %d", (int)layer, MUS_LAYERS_MOST - 1);
}


mus_status mus_pattern_set_layer(mus_pattern *pattern, int32_t panel, int32_t layer)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_status status = mus__pattern_known(pattern, "panel", panel, pattern->npanel);
    if (status == MUS_OK) status = mus__layer_check(pattern, layer);
    if (status != MUS_OK) return status;
    pattern->panel[panel].attr.layer = layer;
    mus__pattern_edited(pattern);
    return MUS_OK;
}


int32_t mus_pattern_layer(const mus_pattern *pattern, int32_t panel)
{
    return pattern != NULL && panel >= 0 && panel < pattern->npanel ? pattern->panel[panel].attr.layer : MUS_NONE;
}
