/*
 * scene.c: reads tape, body and pattern by the options that the subcommands share.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "scene.h"

#include <stdbool.h>
#include <string.h>
#include <time.h>


double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


static void log_line(void *user, int32_t level, const char *text)
{
    const scene *s = user;
    if (level <= MUS_LOG_WARNING) doubt(s->command, text);
}


int scene_open(scene *s, const char *command)
{
    memset(s, 0, sizeof *s);
    s->command = command;
    mus_context_def def;
    mus_context_def_init(&def, sizeof def);
    def.log = log_line;
    def.log_user = s;
    if (mus_context_create(&def, &s->context) != MUS_OK) return complain(EXIT_FAILED, command, "no memory");
    return EXIT_DONE;
}


void scene_close(scene *s)
{
    mus_pattern_destroy(s->pattern);
    mus_tape_destroy(s->tape);
    mus_context_destroy(s->context);
}


int failure_code(mus_status status)
{
    const int run = status == MUS_ERR_MEMORY || status == MUS_ERR_DIVERGED || status == MUS_ERR_SEW ||
                    status == MUS_ERR_UNSETTLED || status == MUS_ERR_TANGLED || status == MUS_ERR_STEP ||
                    status == MUS_ERR_STOPPED;
    return run ? EXIT_FAILED : EXIT_INPUT;
}


int scene_fail(const scene *s, mus_status status)
{
    const char *text = mus_context_error(s->context);
    return complain(failure_code(status), s->command, "%s", text[0] != '\0' ? text : mus_status_text(status));
}


int scene_fail_output(const scene *s, mus_status status)
{
    scene_fail(s, status);
    return status == MUS_ERR_FILE ? EXIT_FAILED : failure_code(status);
}


int scene_tape(scene *s, const source *from)
{
    mus_status status;
    if (from->tape != NULL && from->size != NULL)
        return complain(EXIT_INPUT, s->command, "--tape and --size exclude each other");
    if (from->row != NULL && from->tape == NULL)
        return complain(EXIT_INPUT, s->command, "--row %s: goes with --tape FILE.csv", from->row);
    if (from->tape != NULL) {
        status = mus_tape_read(s->context, from->tape, from->row, &s->tape);
    } else if (from->size != NULL) {
        status = mus_tape_create(s->context, &s->tape);
        if (status == MUS_OK) status = mus_tape_set_size(s->tape, from->size);
    } else {
        return complain(EXIT_INPUT, s->command, "no tape is given: --tape FILE or --size SIZE");
    }
    if (status == MUS_OK) status = mus_tape_complete(s->tape);
    if (status != MUS_OK) return scene_fail(s, status);
    for (int32_t i = 0; i < mus_tape_warning_count(s->tape); i++) doubt(s->command, mus_tape_warning(s->tape, i));
    return EXIT_DONE;
}


mus_status scene_body(const scene *s, const source *from, const mus_body_def *def, mus_body **out)
{
    mus_body_def own;
    mus_body_def_init(&own, sizeof own);
    if (def != NULL) own = *def;
    own.stoop = 0.001 * from->stoop;
    own.head_forward = 0.001 * from->head_forward;
    own.sway = 0.001 * from->sway;
    return mus_body_create(s->context, s->tape, &own, out);
}


int scene_upright(const source *from, const char *command)
{
    if (from->stoop == 0.0 && from->head_forward == 0.0 && from->sway == 0.0) return EXIT_DONE;
    return complain(EXIT_INPUT, command, "--stoop, --head-forward and --sway are for a tape: a mesh stands as it does");
}


int32_t design_named(const char *command, const char *flag, const char *name)
{
    const int32_t design = mus_design_find(name);
    if (design != MUS_NONE) return design;

    /* without conditions, which a name cannot have */
    scene s;
    char near[256] = "", phrase[256];
    int32_t found[4], count = 0;
    snprintf(phrase, sizeof phrase, "%s", name);
    for (char *c = phrase; *c != '\0'; c++) *c = *c == '=' ? ' ' : *c;
    if (scene_open(&s, command) == EXIT_DONE) mus_design_search(s.context, phrase, 4, found, NULL, &count);
    for (int32_t i = 0; i < count && i < 4; i++) {
        const size_t n = strlen(near);
        snprintf(near + n, sizeof near - n, "%s%s", i > 0 ? ", " : "; near: ", mus_design_name(found[i]));
    }
    scene_close(&s);
    complain(EXIT_INPUT, command, "%s: no design is called \"%s\"%s", flag, name,
             near[0] != '\0' ? near : "; muslin designs lists them");
    return MUS_NONE;
}


int scene_pattern(scene *s, const source *from)
{
    const double start = seconds();
    mus_status status;
    const int given = (from->design != NULL) + (from->words != NULL) + (from->pattern != NULL);
    if (given > 1) return complain(EXIT_INPUT, s->command, "--design, --words and --pattern exclude one another");
    if (given == 0)
        return complain(EXIT_INPUT, s->command, "no garment is given: --design NAME, --words WORDS or --pattern FILE");
    if (from->pattern != NULL) {
        status = mus_pattern_read(s->context, from->pattern, &s->pattern);
    } else if (from->words != NULL) {
        if (s->tape == NULL) return complain(EXIT_INPUT, s->command, "a design needs --tape FILE or --size SIZE");
        status = mus_design_draft_words(s->context, from->words, s->tape, NULL, &s->pattern);
    } else {
        const int32_t design = design_named(s->command, "--design", from->design);
        if (design == MUS_NONE) return EXIT_INPUT;
        if (s->tape == NULL) return complain(EXIT_INPUT, s->command, "a design needs --tape FILE or --size SIZE");
        status = mus_design_draft(s->context, design, s->tape, NULL, &s->pattern);
    }
    s->draft_seconds = seconds() - start;
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


/* the layer over all that the pattern has */
static int32_t layer_over(const mus_pattern *pattern)
{
    int32_t top = 0;
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++)
        if (mus_pattern_layer(pattern, i) > top) top = mus_pattern_layer(pattern, i);
    return top + 1;
}


int scene_over(scene *s, const texts *over)
{
    for (int32_t i = 0; i < over->count; i++) {
        const char *what = over->at[i], *ending = strrchr(what, '.');
        const int32_t design = mus_design_find(what);
        const bool file = ending != NULL && (strcmp(ending, ".json") == 0 || strcmp(ending, ".yaml") == 0);
        mus_pattern *more = NULL;
        mus_status status;
        if (!file && s->tape == NULL)
            return complain(EXIT_INPUT, s->command, "--over %s: a design needs --tape FILE or --size SIZE", what);
        if (file) status = mus_pattern_read(s->context, what, &more);
        else if (design != MUS_NONE) status = mus_design_draft(s->context, design, s->tape, NULL, &more);
        else status = mus_design_draft_words(s->context, what, s->tape, NULL, &more);
        if (status == MUS_OK) status = mus_pattern_join(s->pattern, more, layer_over(s->pattern));
        mus_pattern_destroy(more);
        if (status != MUS_OK)
            return complain(failure_code(status), s->command, "--over %s: %s", what, mus_context_error(s->context));
    }
    return EXIT_DONE;
}
