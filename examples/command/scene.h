/* scene.h: what the subcommands share: the context, tape and pattern of the options, seconds, failing with a line. */
#ifndef MUSLIN_SCENE_H
#define MUSLIN_SCENE_H

#include "muslin/exchange.h"
#include "muslin/muslin.h"

#include "args.h"

typedef struct scene {
    const char *command;
    mus_context *context;
    mus_tape *tape;       /* NULL when none was asked */
    mus_pattern *pattern; /* the same */
    double draft_seconds;
} scene;

/* Where tape and pattern come from: texts of options, NULL when not given. */
typedef struct source {
    const char *tape, *row, *size;
    const char *design, *words, *pattern;
    double stoop, head_forward, sway; /* posture [mm] */
} source;

/* The options of a source, to stand in the tables of subcommands. */
#define SOURCE_TAPE(s)                                                                                         \
    {"--tape", OPTION_TEXT, &(s).tape, 0, 0, "FILE  the tape: .tape, GarmentCode .yaml, .vit, a row of a .csv"}, \
        {"--row", OPTION_TEXT, &(s).row, 0, 0, "NAME  which line of a .csv"},                                   \
        {"--size", OPTION_TEXT, &(s).size, 0, 0, "SIZE  a table size in place of a tape: W40, M50, C116"}
#define SOURCE_POSTURE(s)                                                                                            \
    {"--stoop", OPTION_NUMBER, &(s).stoop, -100, 200, "MM  the nape is before where it is upright; negative: erect"},\
        {"--head-forward", OPTION_NUMBER, &(s).head_forward, -100, 200, "MM  the head is before the neck's base"},   \
        {"--sway", OPTION_NUMBER, &(s).sway, -100, 200, "MM  a hollow back: the waist is before chest and hip"}
#define SOURCE_PATTERN(s)                                                                      \
    {"--design", OPTION_TEXT, &(s).design, 0, 0, "NAME  a named design (muslin designs lists them)"}, \
        {"--words", OPTION_TEXT, &(s).words, 0, 0, "WORDS  a design in words: \"dress neck=v sleeve=puff\""}, \
        {"--pattern", OPTION_TEXT, &(s).pattern, 0, 0, "FILE  a pattern: muslin .json or GarmentCode specification"}

/* Start: a context whose warnings go to standard error. Returns an exit code. */
int scene_open(scene *s, const char *command);
void scene_close(scene *s);

/* Read the tape, completed. EXIT_INPUT when none is given. */
int scene_tape(scene *s, const source *from);
/* The body of the tape in the posture of the options; `def` may be NULL. */
mus_status scene_body(const scene *s, const source *from, const mus_body_def *def, mus_body **out);
/* Is a posture asked? With a mesh that is bad input: a line, and EXIT_INPUT. */
int scene_upright(const source *from, const char *command);
/* Draft the design or read the pattern. */
int scene_pattern(scene *s, const source *from);
/* Garments over that one, from inside to outside: each a named design, a file, or words. */
int scene_over(scene *s, const texts *over);

/* The exit code that fits a status that is not MUS_OK. */
int failure_code(mus_status status);

/* One line for a status that is not MUS_OK, and the exit code that fits it. */
int scene_fail(const scene *s, mus_status status);

/* Wall time in seconds from some start. */
double seconds(void);

#endif
