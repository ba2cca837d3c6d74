/*
 * print_sizes.c: muslin print --sizes: the design in several table sizes, as patterns and as one sheet.
 */
#include <string.h>

#include "print_sizes.h"


/* Drafts one size. */
static int draft_size(scene *s, const source *from, const char *size, mus_pattern **out)
{
    mus_tape *tape = s->tape;
    mus_pattern *pattern = s->pattern;
    s->tape = NULL;
    s->pattern = NULL;
    mus_status status = mus_tape_create(s->context, &s->tape);
    if (status == MUS_OK) status = mus_tape_set_size(s->tape, size);
    const int code = status == MUS_OK ? scene_pattern(s, from) : scene_fail(s, status);
    *out = s->pattern;
    mus_tape_destroy(s->tape);
    s->tape = tape;
    s->pattern = pattern;
    return code;
}


/* Adds a size by its name. Returns its index, MUS_NONE after a message. */
static int32_t add_size(print_sizes *out, const char *name, size_t n)
{
    if (out->count == SIZES_MOST) {
        complain(EXIT_INPUT, "print", "--sizes: more than %d sizes", SIZES_MOST);
        return MUS_NONE;
    }
    memcpy(out->names[out->count], name, n);
    out->names[out->count][n] = '\0';
    out->name_list[out->count] = out->names[out->count];
    return out->count++;
}


int print_sizes_draft(scene *s, const source *from, const char *list, bool with_own, print_sizes *out)
{
    int code = EXIT_DONE;
    bool own = false;
    if (from->pattern != NULL) return complain(EXIT_INPUT, "print", "--sizes: needs --design or --words");
    const char *name = from->size != NULL ? from->size : s->tape != NULL ? mus_tape_name(s->tape) : "";
    for (const char *at = list; from->size != NULL && *at != '\0';) {
        const size_t n = strcspn(at, ",");
        own = own || (strlen(name) == n && strncmp(at, name, n) == 0);
        at += n + (at[n] == ',');
    }
    if (with_own && !own) {
        if (*name == '\0') name = "own";
        const size_t n = strlen(name) < sizeof out->names[0] ? strlen(name) : sizeof out->names[0] - 1;
        add_size(out, name, n);
        code = from->size != NULL ? draft_size(s, from, from->size, &out->patterns[0]) : EXIT_DONE;
        if (code == EXIT_DONE && from->size == NULL && mus_pattern_copy(s->pattern, &out->patterns[0]) != MUS_OK)
            code = scene_fail(s, MUS_ERR_MEMORY);
    }
    while (*list != '\0' && code == EXIT_DONE) {
        const size_t n = strcspn(list, ",");
        if (n == 0 || n >= sizeof out->names[0]) return complain(EXIT_INPUT, "print", "--sizes %s: no size", list);
        const bool self = from->size != NULL && strlen(from->size) == n && strncmp(list, from->size, n) == 0;
        const int32_t size = self && !with_own ? MUS_NONE : add_size(out, list, n);
        if (size == MUS_NONE && !self) return EXIT_INPUT;
        if (size != MUS_NONE) code = draft_size(s, from, out->names[size], &out->patterns[size]);
        list += n + (list[n] == ',');
    }
    return code;
}


void print_sizes_free(print_sizes *sizes)
{
    for (int32_t i = 0; i < sizes->count; i++) mus_pattern_destroy(sizes->patterns[i]);
    sizes->count = 0;
}


int print_sizes_sheet(scene *s, const source *from, const char *list, const mus_sheet_def *def, mus_sheet **out)
{
    print_sizes sizes = {0};
    mus_sheet_def own = *def;
    own.person = NULL;
    int code = print_sizes_draft(s, from, list, true, &sizes);
    if (code == EXIT_DONE) {
        const mus_status status = mus_sheet_create_sizes(s->context, sizes.count,
                                                         (const mus_pattern *const *)sizes.patterns, sizes.name_list,
                                                         &own, out);
        if (status != MUS_OK) code = scene_fail(s, status);
    }
    print_sizes_free(&sizes);
    return code;
}
