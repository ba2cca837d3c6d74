/*
 * style_axes.h: a style: one option on each axis of words ("neck=v sleeve=puff"). The axes with their options are the
 * table below; their rules are in lib/design/word_rules.c, their meaning in the man page mus_design(3).
 */
#ifndef MUS_HALF_STYLE_AXES_H
#define MUS_HALF_STYLE_AXES_H

#include <stdbool.h>
#include <stdint.h>

/* axis, its word, its options in the order of their enum. The first option is the default */
#define MUS__AXES(X)                                                                                                   \
    X(GARMENT, "garment", "top", "skirt", "trousers", "dress", "jumpsuit", "cape")                                     \
    X(NECK, "neck", "jewel", "scoop", "v", "deep_v", "square", "boat", "sweetheart", "keyhole", "halter", "strapless") \
    X(SLEEVE, "sleeve", "none", "cap", "short", "elbow", "three_quarter", "long", "puff", "bishop", "bell", "raglan",  \
      "dolman", "gigot", "tee")                                                                                        \
    X(SHAPE, "shape", "side_waist", "waist", "shoulder_waist", "french", "princess_shoulder", "princess_armhole",      \
      "neck_gathers", "cf_gathers", "empire", "boxy")                                                                  \
    X(COLLAR, "collar", "none", "mandarin", "shirt", "peter_pan", "turtleneck", "hood", "shawl", "sailor")             \
    X(CLOSURE, "closure", "none", "front", "back", "side", "seams", "wrap")                                            \
    X(TOP_LENGTH, "top_length", "hip", "crop", "waist", "tunic")                                                       \
    X(SKIRT, "skirt", "straight", "pencil", "a_line", "gored4", "gored6", "gored8", "quarter", "half",                 \
      "three_quarter", "full", "gathered", "knife", "box", "tiered", "wrap", "godet", "trumpet", "block", "plain")     \
    X(LENGTH, "length", "knee", "mini", "midi", "maxi", "hi_low")                                                      \
    X(LEG, "leg", "straight", "tapered", "bootcut", "flare", "wide", "culotte", "jogger", "harem")                     \
    X(LEG_LENGTH, "leg_length", "full", "short", "bermuda", "capri", "ankle")                                          \
    X(BAND, "band", "straight", "contour", "facing", "elastic", "none")                                                \
    X(RISE, "rise", "natural", "low", "high")                                                                          \
    X(EASE, "ease", "regular", "slim", "loose", "coat", "block")                                                       \
    X(CLOTH, "cloth", "woven", "knit")                                                                                 \
    X(CUFF, "cuff", "none", "cuff", "rib")                                                                             \
    X(YOKE, "yoke", "none", "yoke")                                                                                    \
    X(POCKET, "pocket", "none", "patch", "welt", "flap", "kangaroo")                                                   \
    X(HEM, "hem", "turned", "ribbed")

enum {
#define MUS__AXIS_ENUM(name, ...) MUS__AXIS_##name,
    MUS__AXES(MUS__AXIS_ENUM)
#undef MUS__AXIS_ENUM
        MUS__AXIS_COUNT
};

enum { MUS__GARMENT_TOP, MUS__GARMENT_SKIRT, MUS__GARMENT_TROUSERS, MUS__GARMENT_DRESS, MUS__GARMENT_JUMPSUIT,
       MUS__GARMENT_CAPE };
enum { MUS__NECK_JEWEL, MUS__NECK_SCOOP, MUS__NECK_V, MUS__NECK_DEEP_V, MUS__NECK_SQUARE, MUS__NECK_BOAT,
       MUS__NECK_SWEETHEART, MUS__NECK_KEYHOLE, MUS__NECK_HALTER, MUS__NECK_STRAPLESS };
enum { MUS__SLEEVE_NONE, MUS__SLEEVE_CAP, MUS__SLEEVE_SHORT, MUS__SLEEVE_ELBOW, MUS__SLEEVE_THREE_QUARTER,
       MUS__SLEEVE_LONG, MUS__SLEEVE_PUFF, MUS__SLEEVE_BISHOP, MUS__SLEEVE_BELL, MUS__SLEEVE_RAGLAN,
       MUS__SLEEVE_DOLMAN, MUS__SLEEVE_GIGOT, MUS__SLEEVE_TEE };
enum { MUS__SHAPE_SIDE_WAIST, MUS__SHAPE_WAIST, MUS__SHAPE_SHOULDER_WAIST, MUS__SHAPE_FRENCH,
       MUS__SHAPE_PRINCESS_SHOULDER, MUS__SHAPE_PRINCESS_ARMHOLE, MUS__SHAPE_NECK_GATHERS, MUS__SHAPE_CF_GATHERS,
       MUS__SHAPE_EMPIRE, MUS__SHAPE_BOXY };
enum { MUS__COLLAR_NONE, MUS__COLLAR_MANDARIN, MUS__COLLAR_SHIRT, MUS__COLLAR_PETER_PAN, MUS__COLLAR_TURTLENECK,
       MUS__COLLAR_HOOD, MUS__COLLAR_SHAWL, MUS__COLLAR_SAILOR };
enum { MUS__CLOSURE_NONE, MUS__CLOSURE_FRONT, MUS__CLOSURE_BACK, MUS__CLOSURE_SIDE, MUS__CLOSURE_SEAMS,
       MUS__CLOSURE_WRAP };
enum { MUS__TOP_LENGTH_HIP, MUS__TOP_LENGTH_CROP, MUS__TOP_LENGTH_WAIST, MUS__TOP_LENGTH_TUNIC };
enum { MUS__SKIRT_STRAIGHT, MUS__SKIRT_PENCIL, MUS__SKIRT_A_LINE, MUS__SKIRT_GORED4, MUS__SKIRT_GORED6,
       MUS__SKIRT_GORED8, MUS__SKIRT_QUARTER, MUS__SKIRT_HALF, MUS__SKIRT_THREE_QUARTER, MUS__SKIRT_FULL,
       MUS__SKIRT_GATHERED, MUS__SKIRT_KNIFE, MUS__SKIRT_BOX, MUS__SKIRT_TIERED, MUS__SKIRT_WRAP, MUS__SKIRT_GODET,
       MUS__SKIRT_TRUMPET, MUS__SKIRT_BLOCK, MUS__SKIRT_PLAIN };
enum { MUS__LENGTH_KNEE, MUS__LENGTH_MINI, MUS__LENGTH_MIDI, MUS__LENGTH_MAXI, MUS__LENGTH_HI_LOW };
enum { MUS__LEG_STRAIGHT, MUS__LEG_TAPERED, MUS__LEG_BOOTCUT, MUS__LEG_FLARE, MUS__LEG_WIDE, MUS__LEG_CULOTTE,
       MUS__LEG_JOGGER, MUS__LEG_HAREM };
enum { MUS__LEG_LENGTH_FULL, MUS__LEG_LENGTH_SHORT, MUS__LEG_LENGTH_BERMUDA, MUS__LEG_LENGTH_CAPRI,
       MUS__LEG_LENGTH_ANKLE };
enum { MUS__BAND_STRAIGHT, MUS__BAND_CONTOUR, MUS__BAND_FACING, MUS__BAND_ELASTIC, MUS__BAND_NONE };
enum { MUS__RISE_NATURAL, MUS__RISE_LOW, MUS__RISE_HIGH };
enum { MUS__EASE_REGULAR, MUS__EASE_SLIM, MUS__EASE_LOOSE, MUS__EASE_COAT, MUS__EASE_BLOCK };
enum { MUS__CLOTH_WOVEN, MUS__CLOTH_KNIT };
enum { MUS__CUFF_NONE, MUS__CUFF_CUFF, MUS__CUFF_RIB };
enum { MUS__YOKE_NONE, MUS__YOKE_YOKE };
enum { MUS__POCKET_NONE, MUS__POCKET_PATCH, MUS__POCKET_WELT, MUS__POCKET_FLAP, MUS__POCKET_KANGAROO };
enum { MUS__HEM_TURNED, MUS__HEM_RIBBED };

typedef struct mus__style {
    int32_t option[MUS__AXIS_COUNT];
} mus__style;

/* Whether a garment has an axis: a skirt has no sleeve. */
bool mus__style_has(int32_t garment, int32_t axis);
/* The word of an option ("puff"), of an axis ("sleeve"); NULL outside. */
const char *mus__style_word(int32_t axis, int32_t option);
const char *mus__style_axis(int32_t axis);

#endif
