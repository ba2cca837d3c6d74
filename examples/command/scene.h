/* scene.h: shared by the subcommands: the context, tape and pattern from the options, wall time, exit codes. */
#ifndef MUSLIN_SCENE_H
#define MUSLIN_SCENE_H

#include "muslin/exchange.h"
#include "muslin/muslin.h"

#include "args.h"

typedef struct scene {
    const char *command;
    mus_context *context;
    mus_tape *tape;       /* NULL when not asked for */
    mus_pattern *pattern; /* NULL when not asked for */
    double draft_seconds;
} scene;

/* The sources of tape and pattern: options, NULL when not given. */
typedef struct source {
    const char *tape, *row, *size;
    const char *design, *words, *pattern;
    double stoop, head_forward, sway; /* posture [mm] */
} source;

/* The options of a source, for the tables of subcommands. */
#define SOURCE_TAPE(s)                                                                                           \
    {"--tape", OPTION_TEXT, &(s).tape, 0, 0, "FILE  the tape: .tape, GarmentCode .yaml, .vit, a row of a .csv"}, \
        {"--row", OPTION_TEXT, &(s).row, 0, 0, "NAME  the row of a .csv"},                                       \
        {"--size", OPTION_TEXT, &(s).size, 0, 0, "SIZE  a table size in place of a tape: W40, M50, C116"}
#define SOURCE_POSTURE(s)                                                                                             \
    {"--stoop", OPTION_NUMBER, &(s).stoop, -100, 200, "MM  nape forwards of the upright posture; negative: erect"},   \
        {"--head-forward", OPTION_NUMBER, &(s).head_forward, -100, 200, "MM  head forwards of the base of the neck"}, \
        {"--sway", OPTION_NUMBER, &(s).sway, -100, 200, "MM  hollow back: waist forwards of chest and hip"}
#define SOURCE_PATTERN(s)                                                                                     \
    {"--design", OPTION_TEXT, &(s).design, 0, 0, "NAME  a named design (muslin designs lists them)"},         \
        {"--words", OPTION_TEXT, &(s).words, 0, 0, "WORDS  a design in words: \"dress neck=v sleeve=puff\""}, \
        {"--pattern", OPTION_TEXT, &(s).pattern, 0, 0, "FILE  a pattern: muslin .json or GarmentCode specification"}

/* Makes a context whose warnings go to standard error. Returns an exit code. */
int scene_open(scene *s, const char *command);
void scene_close(scene *s);

/* Reads the tape and completes it. Returns an exit code: EXIT_INPUT when none is given. */
int scene_tape(scene *s, const source *from);
/* Makes the body of the tape in the posture of the options; `def` may be NULL. */
mus_status scene_body(const scene *s, const source *from, const mus_body_def *def, mus_body **out);
/* Refuses options of posture together with a mesh: prints a line and returns EXIT_INPUT. */
int scene_upright(const source *from, const char *command);
/* Number of a named design; prints a line with near names and returns MUS_NONE when there is none. `flag`: for the
 * line, "--design". */
int32_t design_named(const char *command, const char *flag, const char *name);
/* Drafts the design or reads the pattern. Returns an exit code. */
int scene_pattern(scene *s, const source *from);
/* Adds garments over the first, from inside to outside: each a named design, a file, or words. */
int scene_over(scene *s, const texts *over);

/* Returns the exit code for a status other than MUS_OK. */
int failure_code(mus_status status);

/* Prints one line for a status other than MUS_OK, and returns its exit code. */
int scene_fail(const scene *s, mus_status status);

/* The same after an output could not be written: a full device is a run that failed, not bad input. */
int scene_fail_output(const scene *s, mus_status status);

/* Returns the wall time since an arbitrary start [s]. */
double seconds(void);

#endif
