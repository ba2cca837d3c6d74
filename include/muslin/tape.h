/*
 * muslin/tape.h: the tailor's measures of one person.
 *
 * A tape holds up to MUS_MEASURE_COUNT measures, each unset, given or derived. Set what the tape measure said, then
 * mus_tape_complete() derives what is missing and checks that the sheet makes sense. Sources: ISO 8559-1 terms;
 * defaults by regression on ANSUR II and clothing tables, as listed in man page mus_tape(3).
 *
 * Units: metre; the three angles in radian.
 */
#ifndef MUSLIN_TAPE_H
#define MUSLIN_TAPE_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The measures. X(NAME, "name", unit, low, high): unit 'm' length or 'r' angle; low and high bound the plausible
 * adult (girths: child) value; a value outside half of low to twice high is an error.
 */
#define MUS_MEASURE_LIST(X)                                                                             \
    X(STATURE, "stature", 'm', 0.45, 2.15)           /* floor to crown, no shoes */                     \
    X(BUST, "bust", 'm', 0.38, 1.80)                 /* girth over the fullest bust or chest */         \
    X(WAIST, "waist", 'm', 0.38, 1.90)               /* girth at the natural waist */                   \
    X(HIP, "hip", 'm', 0.38, 1.90)                   /* girth over the fullest seat */                  \
    X(UNDERBUST, "underbust", 'm', 0.36, 1.60)       /* girth just below the bust */                    \
    X(HIGH_BUST, "high_bust", 'm', 0.36, 1.70)       /* girth high under the arms */                    \
    X(HIGH_HIP, "high_hip", 'm', 0.38, 1.90)         /* girth half way from waist to hip */             \
    X(NECK, "neck", 'm', 0.20, 0.60)                 /* girth round the neck base */                    \
    X(SHOULDER, "shoulder", 'm', 0.04, 0.20)         /* side neck point to shoulder point */            \
    X(SHOULDER_SLOPE, "shoulder_slope", 'r', 0.1745, 0.6109) /* below the horizontal */                 \
    X(ACROSS_BACK, "across_back", 'm', 0.16, 0.55)   /* arm crease to arm crease, back */               \
    X(ACROSS_FRONT, "across_front", 'm', 0.16, 0.55) /* the same, front */                              \
    X(BACK_WAIST, "back_waist", 'm', 0.13, 0.60)     /* nape to waist along the spine */                \
    X(FRONT_WAIST, "front_waist", 'm', 0.15, 0.65)   /* side neck point over bust point to waist */     \
    X(BUST_DEPTH, "bust_depth", 'm', 0.10, 0.50)     /* side neck point to bust point */                \
    X(BUST_SPAN, "bust_span", 'm', 0.07, 0.35)       /* bust point to bust point */                     \
    X(SCYE_DEPTH, "scye_depth", 'm', 0.09, 0.32)     /* nape straight down to the armpit level */       \
    X(ARM, "arm", 'm', 0.14, 0.80)                   /* shoulder point to wrist over the bent elbow */  \
    X(ELBOW, "elbow", 'm', 0.08, 0.48)               /* shoulder point to elbow */                      \
    X(UPPER_ARM, "upper_arm", 'm', 0.12, 0.65)       /* girth, relaxed, thickest */                     \
    X(WRIST, "wrist", 'm', 0.09, 0.26)               /* girth */                                        \
    X(HAND, "hand", 'm', 0.08, 0.30)                 /* girth with the thumb folded in */               \
    X(WAIST_HEIGHT, "waist_height", 'm', 0.28, 1.40) /* waist above the floor */                        \
    X(WAIST_TO_HIP, "waist_to_hip", 'm', 0.05, 0.30) /* waist to hip level */                           \
    X(RISE, "rise", 'm', 0.13, 0.40)                 /* waist height less crotch height */              \
    X(INLEG, "inleg", 'm', 0.14, 1.10)               /* crotch to floor */                              \
    X(CROTCH_LENGTH, "crotch_length", 'm', 0.25, 1.10) /* front waist through the crotch to the back */ \
    X(THIGH, "thigh", 'm', 0.22, 1.10)               /* girth just below the crotch */                  \
    X(KNEE, "knee", 'm', 0.18, 0.65)                 /* girth, mid kneecap */                           \
    X(CALF, "calf", 'm', 0.17, 0.65)                 /* girth, fullest */                               \
    X(ANKLE, "ankle", 'm', 0.13, 0.40)               /* girth, narrowest */                             \
    X(HEAD, "head", 'm', 0.31, 0.66)                 /* girth over the brow */                          \
    X(FOOT, "foot", 'm', 0.07, 0.33)                 /* length */                                       \
    X(NAPE_HEIGHT, "nape_height", 'm', 0.40, 1.90)   /* 7th cervical above the floor */                 \
    X(BUST_HEIGHT, "bust_height", 'm', 0.30, 1.70)   /* bust points above the floor */                  \
    X(ARM_ANGLE, "arm_angle", 'r', 0.35, 1.5708)     /* of the hanging arm below the horizontal: the pose */

#define MUS_MEASURE_ENUM(NAME, name, unit, low, high) MUS_MEASURE_##NAME,
enum { MUS_MEASURE_LIST(MUS_MEASURE_ENUM) MUS_MEASURE_COUNT };
#undef MUS_MEASURE_ENUM

/* Whose body it is: picks the derivations. UNSET takes the mean of female and male. */
#define MUS_SEX_UNSET 0
#define MUS_SEX_FEMALE 1
#define MUS_SEX_MALE 2
#define MUS_SEX_CHILD 3

/* Where a measure came from. */
#define MUS_SOURCE_NONE 0
#define MUS_SOURCE_GIVEN 1
#define MUS_SOURCE_DERIVED 2

typedef struct mus_tape mus_tape;

/** Number of measures of this release. */
MUS_API int32_t mus_measure_count(void);

/** Name of a measure ("waist"), or NULL outside 0 .. count-1. Static text. */
MUS_API const char *mus_measure_name(int32_t measure);

/** 'm' for a length, 'r' for an angle, 0 outside the range. */
MUS_API int32_t mus_measure_unit(int32_t measure);

/** Index of a measure by name; the aliases of man page mus_tape(3) count ("chest", "seat"); MUS_NONE if unknown. */
MUS_API int32_t mus_measure_find(const char *name);

/** Make an empty tape. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY. */
MUS_API mus_status mus_tape_create(mus_context *context, mus_tape **out);

/** Make a copy. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY. */
MUS_API mus_status mus_tape_copy(const mus_tape *tape, mus_tape **out);

/** Free a tape; NULL is accepted. */
MUS_API void mus_tape_destroy(mus_tape *tape);

/** The context that the tape was made from. */
MUS_API mus_context *mus_tape_context(const mus_tape *tape);

/** Set whose tape it is (MUS_SEX_*). Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_tape_set_sex(mus_tape *tape, int32_t sex);

/** MUS_SEX_* of the tape. */
MUS_API int32_t mus_tape_sex(const mus_tape *tape);

/** Give the tape a name for reports and labels ("Ada", "W40"). Copied; at most 63 bytes. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_tape_set_name(mus_tape *tape, const char *name);

/** Name of the tape, "" if none. */
MUS_API const char *mus_tape_name(const mus_tape *tape);

/**
 * Set one measure.
 *
 * Units:   value [m] or [rad]; NaN unsets the measure
 * Errors:  MUS_ERR_ARG (measure unknown, value infinite, source not GIVEN or DERIVED);
 *          MUS_ERR_TAPE (value <= 0, or outside half to twice the plausible range). The tape is as before
 */
MUS_API mus_status mus_tape_set(mus_tape *tape, int32_t measure, double value, int32_t source);

/** Value of a measure [m or rad]; NaN when unset or unknown. */
MUS_API double mus_tape_value(const mus_tape *tape, int32_t measure);

/** MUS_SOURCE_* of a measure. */
MUS_API int32_t mus_tape_source(const mus_tape *tape, int32_t measure);

/**
 * Fill a tape with a standard table size: "W34".."W52", "M46".."M60" or "C56".."C164" (children by stature in cm).
 *
 * Sets sex and the given measures of the size (the rest is derived), and clears what was there.
 * Errors: MUS_ERR_ARG (unknown size; the message lists them). Source: EN 13402-like steps.
 */
MUS_API mus_status mus_tape_set_size(mus_tape *tape, const char *size);

/** Number of table sizes, and the name of one ("W40"), or NULL. */
MUS_API int32_t mus_tape_size_count(void);
MUS_API const char *mus_tape_size_name(int32_t index);

/**
 * Derive every missing measure and check the sheet.
 *
 * Needs stature, bust, waist and hip; a child's tape needs stature alone. Derived values are marked so and are
 * derived anew at each call. Checks that fail are errors with both names in the message; doubtful ones are warnings.
 * Errors:  MUS_ERR_TAPE (missing or contradictory). The tape is as before
 * Source:  derivations and checks as listed in mus_tape(3)
 */
MUS_API mus_status mus_tape_complete(mus_tape *tape);

/** Nonzero after a mus_tape_complete() that succeeded and no change since. */
MUS_API int32_t mus_tape_is_complete(const mus_tape *tape);

/** Warnings of the last mus_tape_complete(): count, and text (NULL outside the range). */
MUS_API int32_t mus_tape_warning_count(const mus_tape *tape);
MUS_API const char *mus_tape_warning(const mus_tape *tape, int32_t index);

#ifdef __cplusplus
}
#endif

#endif
