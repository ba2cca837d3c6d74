/*
 * style.h: what a design is in words: one option of each axis ("neck=v sleeve=puff"), and the half garment that they
 * are made into.
 *
 * A garment is drafted as its left half on a cutting table (pattern/board.h): blocks are drawn, the words work on them
 * by separating and rotating, and at the end the half is doubled. Founding paper, section 5.2; the axes and their rules
 * are those of the table in the man page mus_design(3).
 *
 * Frame of every panel of the half: the blocks' (x from the centre line outwards, y up), as seen from outside: "front"
 * is the wearer's left front with x >= 0 to the side; "back" is the left back, so its x is mirrored: x <= 0 to the
 * side; "sleeve" is the left one, front at x < 0. Words run counter-clockwise.
 *
 * Sides are found by label, since shaping cuts panels apart: a run of sides of one label, in order, is what the next
 * part is sewn to (mus__board_run(), mus__board_sew()):
 *   "neck"     front: from the shoulder to the centre; back: from the centre to the shoulder
 *   "armhole"  front: from the underarm to the shoulder; back: from the shoulder to the underarm
 *   "shoulder", "side", "waist" (where a skirt, trousers or a band is sewn on), "hem", "cuff", "centre" (cf, cb)
 * A label stays on a side that is sewn later; openings are declared by mus__board_opening_add() from what the garment
 * should have (neck, cuffs or armholes, waist, hem or hems).
 *
 * What a cut takes off "front" is called "front_...", off "back" "back_...", and a run may go over several panels:
 * mus__half_rim() follows the rim of what is sewn so far. A closure is drawn done up: a front that buttons, a back or
 * side that zips is a seam (MUS__CENTRE_SEAM), with its extension as allowance, buttons and the zip's end as marks.
 * Openings of a top: neck, two armholes (or cuffs), hem or waist; neck=halter: neck, one "armhole" that runs round both
 * arms and the back, hem or waist; neck=strapless: neck, hem or waist.
 */
#ifndef MUS_STYLE_H
#define MUS_STYLE_H

#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_fullness.h"
#include "board/board_sew.h"
#include "design/design_internal.h"

/* axis, its word, its options in the order of their enum. The first is the default */
#define MUS__AXES(X)                                                                                                  \
    X(GARMENT, "garment", "top", "skirt", "trousers", "dress", "jumpsuit", "cape")                                    \
    X(NECK, "neck", "jewel", "scoop", "v", "deep_v", "square", "boat", "sweetheart", "keyhole", "halter", "strapless") \
    X(SLEEVE, "sleeve", "none", "cap", "short", "elbow", "three_quarter", "long", "puff", "bishop", "bell", "raglan", \
      "dolman", "gigot")                                                                                              \
    X(SHAPE, "shape", "side_waist", "waist", "shoulder_waist", "french", "princess_shoulder", "princess_armhole",     \
      "neck_gathers", "cf_gathers", "empire", "boxy")                                                                 \
    X(COLLAR, "collar", "none", "mandarin", "shirt", "peter_pan", "turtleneck", "hood", "shawl", "sailor")            \
    X(CLOSURE, "closure", "none", "front", "back", "side")                                                            \
    X(TOP_LENGTH, "top_length", "hip", "crop", "waist", "tunic")                                                      \
    X(SKIRT, "skirt", "straight", "pencil", "a_line", "gored4", "gored6", "gored8", "quarter", "half",                \
      "three_quarter", "full", "gathered", "knife", "box", "tiered", "wrap", "godet", "trumpet")                      \
    X(LENGTH, "length", "knee", "mini", "midi", "maxi", "hi_low")                                                     \
    X(LEG, "leg", "straight", "tapered", "bootcut", "flare", "wide", "culotte", "jogger", "harem")                    \
    X(LEG_LENGTH, "leg_length", "full", "short", "bermuda", "capri", "ankle")                                         \
    X(BAND, "band", "straight", "contour", "facing", "elastic")                                                       \
    X(RISE, "rise", "natural", "low", "high")                                                                         \
    X(EASE, "ease", "regular", "slim", "loose", "coat")                                                               \
    X(CLOTH, "cloth", "woven", "knit")                                                                                \
    X(CUFF, "cuff", "none", "cuff", "rib")                                                                            \
    X(YOKE, "yoke", "none", "yoke")                                                                                   \
    X(POCKET, "pocket", "none", "patch")

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
       MUS__SLEEVE_DOLMAN, MUS__SLEEVE_GIGOT };
enum { MUS__SHAPE_SIDE_WAIST, MUS__SHAPE_WAIST, MUS__SHAPE_SHOULDER_WAIST, MUS__SHAPE_FRENCH,
       MUS__SHAPE_PRINCESS_SHOULDER, MUS__SHAPE_PRINCESS_ARMHOLE, MUS__SHAPE_NECK_GATHERS, MUS__SHAPE_CF_GATHERS,
       MUS__SHAPE_EMPIRE, MUS__SHAPE_BOXY };
enum { MUS__COLLAR_NONE, MUS__COLLAR_MANDARIN, MUS__COLLAR_SHIRT, MUS__COLLAR_PETER_PAN, MUS__COLLAR_TURTLENECK,
       MUS__COLLAR_HOOD, MUS__COLLAR_SHAWL, MUS__COLLAR_SAILOR };
enum { MUS__CLOSURE_NONE, MUS__CLOSURE_FRONT, MUS__CLOSURE_BACK, MUS__CLOSURE_SIDE };
enum { MUS__TOP_LENGTH_HIP, MUS__TOP_LENGTH_CROP, MUS__TOP_LENGTH_WAIST, MUS__TOP_LENGTH_TUNIC };
enum { MUS__SKIRT_STRAIGHT, MUS__SKIRT_PENCIL, MUS__SKIRT_A_LINE, MUS__SKIRT_GORED4, MUS__SKIRT_GORED6,
       MUS__SKIRT_GORED8, MUS__SKIRT_QUARTER, MUS__SKIRT_HALF, MUS__SKIRT_THREE_QUARTER, MUS__SKIRT_FULL,
       MUS__SKIRT_GATHERED, MUS__SKIRT_KNIFE, MUS__SKIRT_BOX, MUS__SKIRT_TIERED, MUS__SKIRT_WRAP, MUS__SKIRT_GODET,
       MUS__SKIRT_TRUMPET };
enum { MUS__LENGTH_KNEE, MUS__LENGTH_MINI, MUS__LENGTH_MIDI, MUS__LENGTH_MAXI, MUS__LENGTH_HI_LOW };
enum { MUS__LEG_STRAIGHT, MUS__LEG_TAPERED, MUS__LEG_BOOTCUT, MUS__LEG_FLARE, MUS__LEG_WIDE, MUS__LEG_CULOTTE,
       MUS__LEG_JOGGER, MUS__LEG_HAREM };
enum { MUS__LEG_LENGTH_FULL, MUS__LEG_LENGTH_SHORT, MUS__LEG_LENGTH_BERMUDA, MUS__LEG_LENGTH_CAPRI,
       MUS__LEG_LENGTH_ANKLE };
enum { MUS__BAND_STRAIGHT, MUS__BAND_CONTOUR, MUS__BAND_FACING, MUS__BAND_ELASTIC };
enum { MUS__RISE_NATURAL, MUS__RISE_LOW, MUS__RISE_HIGH };
enum { MUS__EASE_REGULAR, MUS__EASE_SLIM, MUS__EASE_LOOSE, MUS__EASE_COAT };
enum { MUS__CLOTH_WOVEN, MUS__CLOTH_KNIT };
enum { MUS__CUFF_NONE, MUS__CUFF_CUFF, MUS__CUFF_RIB };
enum { MUS__YOKE_NONE, MUS__YOKE_YOKE };
enum { MUS__POCKET_NONE, MUS__POCKET_PATCH };

typedef struct mus__style {
    int32_t option[MUS__AXIS_COUNT];
} mus__style;

/* ---- style.c, style_rules.c ---- */

/* "dress neck=v sleeve=puff": the first word is the garment. An axis that is not named takes its first option, but for
 * closure, shape and neck, which take the first that goes with what is named (a knit top asks for boxy first). Axes
 * that the garment does not have are 0. Errors: MUS_ERR_DESIGN (unknown word: the options are named; two words that
 * exclude one another: both named, and why) */
mus_status mus__style_read(mus_context *context, const char *words, mus__style *out);
/* MUS_OK, or MUS_ERR_DESIGN with the two words that exclude one another, and why */
mus_status mus__style_check(mus_context *context, const mus__style *style);
/* a garment has an axis: a skirt has no sleeve */
bool mus__style_has(int32_t garment, int32_t axis);
/* the word of an option ("puff"), of an axis ("sleeve"); NULL outside */
const char *mus__style_word(int32_t axis, int32_t option);
const char *mus__style_axis(int32_t axis);
/* index of a rule that the style breaks, looking at the axes in the bits of `axes` alone; MUS_NONE if there is none */
int32_t mus__style_broken(const mus__style *style, uint32_t axes);
/* the rule as the context's error; MUS_OK for MUS_NONE */
mus_status mus__style_explain(mus_context *context, const mus__style *style, int32_t rule);
/* all that is not an axis' first option, in words; cut off at `size` bytes with the end */
void mus__style_spell(const mus__style *style, char *text, size_t size);

/* ---- design_words.c ---- */

mus_status mus__style_draft(mus_context *context, const char *name, const mus__style *style, const mus_tape *tape,
                            const mus_draft_def *def, mus_pattern **out);

/* ---- a half garment in the making ---- */

typedef struct mus__half {
    mus_context *context;
    mus__measures measures;
    mus__skeleton skeleton;
    mus_draft_def def; /* the caller's wishes; NaN where there is none */
    mus__style style;
    mus__board board;
    mus__bodice bodice;             /* of a garment with a top */
    double bust_ease;               /* total, of the ease level and the cloth, or the caller's wish for a top */
    double waist_ease, hip_ease;    /* total, one value for top and skirt or trousers, so that they meet. Where a top
                                       has no waist darts, mus__top_draft() sets waist_ease to what it has become */
    double neck_gathers;            /* length that the front neck is gathered to over its own; 0: it is not */
    double waist_level;             /* height above the floor of y = 0 of torso panels [m] */
} mus__half;

/* top.c, neckline.c, shaping.c: the body of a top, dress or jumpsuit: panels "front", "back" (and what shaping cuts
 * off them), sewn at shoulder and side, darts sewn, placed round the torso; without sleeve and collar. Down to the hem
 * (top) or the waist line with label "waist" (dress, jumpsuit) */
void mus__top_draft(mus__half *half);

/* the band that holds the gathers of a neck, when it has any: after the sleeves, of which raglan ones share the neck */
void mus__neck_band_attach(mus__half *half);

/* cape.c: front and back of a cape with their neck runs, sewn on the shoulders; without collar */
void mus__cape_draft(mus__half *half);

/* what concerns one side of the whole garment alone, after mus__board_double(): the end of a side zip */
void mus__closure_finish(mus__half *half);

/* panel_place.c: the open sides of `label` one after the other as the rim of the sewn half runs (cloth to the left),
 * over darts and seams from panel to panel, of the panels whose names begin with `panels` ("" for all): how many; at
 * most `room` are written. So the waist of a front runs from the centre to the side, that of a back from the side to
 * the centre, and "" "armhole" is a ring that begins at the front underarm; "neck" runs from centre back to centre
 * front */
int32_t mus__half_rim(const mus__half *half, const char *panels, const char *label, int32_t *sides, int32_t room);

/* sleeve_style.c: from the armhole runs of the half: the sleeve of its style drafted to their lengths, sewn in,
 * underarm sewn, placed round the arm, with its cuff; raglan and dolman recut front and back */
void mus__sleeve_attach(mus__half *half);

/* collar_style.c: from the neck runs: collar, hood or rib band sewn to them */
void mus__collar_attach(mus__half *half);

/* skirt_style.c: the half of a skirt (front and back, or its gores or sectors) with its top edge labelled "waist"; of a
 * dress, sewn to the waist runs of the bodice that is on the board */
void mus__skirt_attach(mus__half *half);

/* trousers_style.c: the left leg: front and back, inseam, outseam, crotch sides CENTRE_SEAM; of a jumpsuit, sewn to the
 * waist runs of the bodice */
void mus__trousers_attach(mus__half *half);

/* band_style.c: waistband or facing on the waist runs of a skirt or trousers; cuffs; patch pockets */
void mus__band_attach(mus__half *half);
void mus__pocket_attach(mus__half *half);
/* the pockets themselves, on the whole garment, after mus__board_double() */
void mus__pocket_finish(mus__half *half);

/* ---- panel_place.c: round the body, panels of the half (those of the other half are mirrored by the doubling) ---- */

void mus__panel_place_torso(mus__half *half, int32_t panel, bool front, double width, double height);
void mus__panel_place_hips(mus__half *half, int32_t panel, bool front, double width, double height);
void mus__panel_place_arm(mus__half *half, int32_t panel, double crown_x, double crown_y, double width);
/* rolled about an upright axis at the height of neck or waist: a band or collar, x = 0 at centre front or back */
void mus__panel_place_ring(mus__half *half, int32_t panel, bool front, double girth, double height);

#endif
