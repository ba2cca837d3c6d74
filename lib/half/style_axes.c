/*
 * style_axes.c: the axes of style_axes.h as texts, and which axes each garment has.
 */
#include "half/style_axes.h"

#include <stddef.h>


#define STYLE_MOST 19 /* options of the longest axis, skirt */
#define STYLE_BIT(x) (UINT32_C(1) << (x))

static const struct {
    const char *name;
    const char *option[STYLE_MOST + 1]; /* NULL after the last */
} style_axes[MUS__AXIS_COUNT] = {
#define STYLE_AXIS(name, word, ...) {word, {__VA_ARGS__}},
    MUS__AXES(STYLE_AXIS)
#undef STYLE_AXIS
};

#define STYLE_TOPS (STYLE_BIT(MUS__GARMENT_TOP) | STYLE_BIT(MUS__GARMENT_DRESS) | STYLE_BIT(MUS__GARMENT_JUMPSUIT))
#define STYLE_LOWERS (STYLE_BIT(MUS__GARMENT_SKIRT) | STYLE_BIT(MUS__GARMENT_TROUSERS))
#define STYLE_CAPE STYLE_BIT(MUS__GARMENT_CAPE)

/* the garments that have an axis */
static const uint32_t style_garments[MUS__AXIS_COUNT] = {
    [MUS__AXIS_GARMENT] = STYLE_TOPS | STYLE_LOWERS | STYLE_CAPE,
    [MUS__AXIS_NECK] = STYLE_TOPS | STYLE_CAPE,
    [MUS__AXIS_SLEEVE] = STYLE_TOPS,
    [MUS__AXIS_SHAPE] = STYLE_TOPS,
    [MUS__AXIS_COLLAR] = STYLE_TOPS | STYLE_CAPE,
    [MUS__AXIS_CLOSURE] = STYLE_TOPS | STYLE_LOWERS | STYLE_CAPE,
    [MUS__AXIS_TOP_LENGTH] = STYLE_BIT(MUS__GARMENT_TOP),
    [MUS__AXIS_SKIRT] = STYLE_BIT(MUS__GARMENT_SKIRT) | STYLE_BIT(MUS__GARMENT_DRESS),
    [MUS__AXIS_LENGTH] = STYLE_BIT(MUS__GARMENT_SKIRT) | STYLE_BIT(MUS__GARMENT_DRESS) | STYLE_CAPE,
    [MUS__AXIS_LEG] = STYLE_BIT(MUS__GARMENT_TROUSERS) | STYLE_BIT(MUS__GARMENT_JUMPSUIT),
    [MUS__AXIS_LEG_LENGTH] = STYLE_BIT(MUS__GARMENT_TROUSERS) | STYLE_BIT(MUS__GARMENT_JUMPSUIT),
    [MUS__AXIS_BAND] = STYLE_LOWERS,
    [MUS__AXIS_RISE] = STYLE_LOWERS,
    [MUS__AXIS_EASE] = STYLE_TOPS | STYLE_LOWERS,
    [MUS__AXIS_CLOTH] = STYLE_TOPS | STYLE_LOWERS | STYLE_CAPE,
    [MUS__AXIS_CUFF] = STYLE_TOPS,
    [MUS__AXIS_YOKE] = STYLE_TOPS | STYLE_BIT(MUS__GARMENT_TROUSERS),
    [MUS__AXIS_POCKET] = STYLE_TOPS | STYLE_LOWERS,
    [MUS__AXIS_HEM] = STYLE_BIT(MUS__GARMENT_TOP),
};


const char *mus__style_axis(int32_t axis)
{
    return axis >= 0 && axis < MUS__AXIS_COUNT ? style_axes[axis].name : NULL;
}


const char *mus__style_word(int32_t axis, int32_t option)
{
    if (axis < 0 || axis >= MUS__AXIS_COUNT || option < 0 || option >= STYLE_MOST) return NULL;
    for (int32_t i = 0; i < option; i++)
        if (style_axes[axis].option[i] == NULL) return NULL;
    return style_axes[axis].option[option];
}


bool mus__style_has(int32_t garment, int32_t axis)
{
    return axis >= 0 && axis < MUS__AXIS_COUNT && (style_garments[axis] & STYLE_BIT(garment)) != 0;
}
