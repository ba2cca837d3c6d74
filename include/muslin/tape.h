/*
 * muslin/tape.h: the tailor's measures of one person.
 *
 * A tape holds up to MUS_MEASURE_COUNT measures; each is unset, given or derived. Set the measures that were taken,
 * then mus_tape_complete() derives the others and checks that they can belong to one body. Bodies and patterns are made
 * from a completed tape.
 *
 * Units:   metre; shoulder_slope and arm_angle in radian
 * Source:  terms of ISO 8559-1:2017; derivations by regression on ANSUR II (Gordon and others 2014) and on size tables
 *          (formulas in man page mus_tape(3))
 */
#ifndef MUSLIN_TAPE_H
#define MUSLIN_TAPE_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The measures. X(NAME, "name", unit, low, high): unit 'm' for a length [m], 'r' for an angle [rad]. From low to high
 * is the range of plausible bodies, from an infant to the tallest adult; mus_tape_set() refuses a value below half of
 * low or above twice high.
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

/* The sex of the person, which selects the derivations. UNSET takes the mean of female and male. */
#define MUS_SEX_UNSET 0
#define MUS_SEX_FEMALE 1
#define MUS_SEX_MALE 2
#define MUS_SEX_CHILD 3

/* The source of a measure: unset, given by the caller, or derived from others. */
#define MUS_SOURCE_NONE 0
#define MUS_SOURCE_GIVEN 1
#define MUS_SOURCE_DERIVED 2

/** The measures of one person. One thread at a time may use a tape and its context. */
typedef struct mus_tape mus_tape;

/** Number of measures of this release: MUS_MEASURE_COUNT at run time. */
MUS_API int32_t mus_measure_count(void);

/** Name of a measure ("waist"); NULL for an index outside 0 to mus_measure_count() - 1. Static text. */
MUS_API const char *mus_measure_name(int32_t measure);

/** Unit of a measure: 'm' for a length [m], 'r' for an angle [rad]; 0 for an unknown index. */
MUS_API int32_t mus_measure_unit(int32_t measure);

/** Index of a measure by its name or by an alias of mus_tape(3) ("chest", "seat"); MUS_NONE for an unknown name. */
MUS_API int32_t mus_measure_find(const char *name);

/** Make an empty tape: no measure set, sex unset, no name. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY. */
MUS_API mus_status mus_tape_create(mus_context *context, mus_tape **out);

/** Copy a tape with its measures, sources, name and warnings. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY. */
MUS_API mus_status mus_tape_copy(const mus_tape *tape, mus_tape **out);

/** Free a tape; NULL is accepted. */
MUS_API void mus_tape_destroy(mus_tape *tape);

/** The context that a tape was made from; NULL for NULL. */
MUS_API mus_context *mus_tape_context(const mus_tape *tape);

/** Set the sex of the person (MUS_SEX_*). The tape is then no longer complete. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_tape_set_sex(mus_tape *tape, int32_t sex);

/** Sex of the person: MUS_SEX_*; MUS_SEX_UNSET for NULL. */
MUS_API int32_t mus_tape_sex(const mus_tape *tape);

/** Give a tape a name for reports and labels ("Ada", "W40"), at most 63 bytes of UTF-8; copied. Errors: MUS_ERR_ARG. */
MUS_API mus_status mus_tape_set_name(mus_tape *tape, const char *name);

/** Name of a tape; "" without a name. Borrowed until the name is set again or the tape destroyed. */
MUS_API const char *mus_tape_name(const mus_tape *tape);

/**
 * Set one measure, or unset it.
 *
 * The tape is then no longer complete. A measure that was set stays as it is when the others are derived.
 *
 * Units:   value [m] or [rad]; NaN unsets the measure
 * Errors:  MUS_ERR_ARG (unknown measure, infinite value, source neither MUS_SOURCE_GIVEN nor MUS_SOURCE_DERIVED);
 *          MUS_ERR_TAPE (value below half the plausible range or above twice of it). The tape is as before the call
 */
MUS_API mus_status mus_tape_set(mus_tape *tape, int32_t measure, double value, int32_t source);

/** Value of a measure [m] or [rad]; NaN for a measure that is unset or unknown. */
MUS_API double mus_tape_value(const mus_tape *tape, int32_t measure);

/** Source of a measure: MUS_SOURCE_*; MUS_SOURCE_NONE for a measure that is unset or unknown. */
MUS_API int32_t mus_tape_source(const mus_tape *tape, int32_t measure);

/**
 * Fill a tape with a table size: "W34" to "W52", "M46" to "M60", or "C56" to "C164" (children, by stature in cm).
 *
 * Replaces all measures and the name: sets the sex, stature, bust, waist and hip of the size (of a child too).
 *
 * Errors:  MUS_ERR_ARG (unknown size; the message lists the sizes)
 * Source:  steps of bust, waist and hip as in EN 13402-3
 */
MUS_API mus_status mus_tape_set_size(mus_tape *tape, const char *size);

/** Number of table sizes. */
MUS_API int32_t mus_tape_size_count(void);

/** Name of a table size ("W40"); NULL for an index outside 0 to mus_tape_size_count() - 1. Static text. */
MUS_API const char *mus_tape_size_name(int32_t index);

/**
 * Derive every measure that is not set, and check the tape.
 *
 * Needs stature, bust, waist and hip; a child's tape needs stature alone. Derived values have the source
 * MUS_SOURCE_DERIVED and are derived anew at each call. Two measures that no body has together are an error; two that
 * hardly any body has together, and a given value that does not fit the others, are warnings (mus_tape_warning()). A
 * warning, and the message of an error, name the likely slip: "digits swapped: 96.0 cm?".
 *
 * Errors:  MUS_ERR_TAPE (a needed measure is missing, or two contradict each other: the message names both);
 *          MUS_ERR_MEMORY. The tape is as before the call
 * Cost:    some microseconds
 * Source:  regressions on ANSUR II; formulas and checks are listed in mus_tape(3)
 */
MUS_API mus_status mus_tape_complete(mus_tape *tape);

/** Nonzero when mus_tape_complete() succeeded and nothing was set since. */
MUS_API int32_t mus_tape_is_complete(const mus_tape *tape);

/** Number of warnings of the last mus_tape_complete(). */
MUS_API int32_t mus_tape_warning_count(const mus_tape *tape);

/** Text of a warning; NULL for an index outside 0 to mus_tape_warning_count() - 1. Borrowed until the tape changes. */
MUS_API const char *mus_tape_warning(const mus_tape *tape, int32_t index);

#ifdef __cplusplus
}
#endif

#endif
