/*
 * grade.c: muslin grade: drafts one design in several sizes; prints ease, seams, and the grade rules from each size to
 * the next.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "scene.h"

#define GRADE_MOST 32

static const char *const grade_levels[MUS_EASE_COUNT] = {"bust", "waist", "hip"};

typedef struct grade_size {
    char name[32];
    mus_tape *tape;
    mus_pattern *pattern;
    double ease[MUS_EASE_COUNT];
    double seam;    /* largest difference of the two lengths of a seam, less its ease [m] */
    double *rules;  /* (points x 2) displacements to the next size [m]; NULL for the last size */
    int32_t points; /* number of points that have a rule */
} grade_size;


/* Makes the tapes of a list of table sizes, "W38,W40,W42". */
static int grade_read_sizes(scene *s, const char *list, grade_size *sizes, int *count)
{
    *count = 0;
    while (*list != '\0') {
        const size_t n = strcspn(list, ",");
        grade_size *size = &sizes[*count];
        if (*count == GRADE_MOST)
            return complain(EXIT_INPUT, "grade", "--sizes: more than %d sizes", GRADE_MOST);
        if (n == 0 || n >= sizeof size->name) return complain(EXIT_INPUT, "grade", "--sizes %s: no size", list);
        memcpy(size->name, list, n);
        size->name[n] = '\0';
        ++*count;
        mus_status status = mus_tape_create(s->context, &size->tape);
        if (status == MUS_OK) status = mus_tape_set_size(size->tape, size->name);
        if (status == MUS_OK) status = mus_tape_complete(size->tape);
        if (status != MUS_OK) return scene_fail(s, status);
        list += n + (list[n] == ',');
    }
    return *count > 0 ? EXIT_DONE : complain(EXIT_INPUT, "grade", "--sizes: no size is given");
}


static double grade_seams(const mus_pattern *pattern)
{
    double most = 0.0;
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(pattern, i, &seam) != MUS_OK) continue;
        const double a = mus_pattern_edge_length(pattern, seam.edge_a);
        const double b = mus_pattern_edge_length(pattern, seam.edge_b);
        most = fmax(most, fabs(b - a - seam.ease));
    }
    return most;
}


/* Drafts each size, then computes the rules from each to the next. */
static int grade_draft(scene *s, const source *from, grade_size *sizes, int count)
{
    for (int i = 0; i < count; i++) {
        s->tape = sizes[i].tape;
        const int code = scene_pattern(s, from);
        sizes[i].pattern = s->pattern;
        s->tape = NULL;
        s->pattern = NULL;
        if (code != EXIT_DONE) return code;
        sizes[i].seam = grade_seams(sizes[i].pattern);
        const mus_status status = mus_design_ease(sizes[i].pattern, sizes[i].tape, sizes[i].ease);
        if (status != MUS_OK) return scene_fail(s, status);
    }
    for (int i = 0; i + 1 < count; i++) {
        const size_t points = (size_t)mus_pattern_point_count(sizes[i].pattern);
        sizes[i].rules = malloc(2 * points * sizeof *sizes[i].rules);
        if (sizes[i].rules == NULL) return complain(EXIT_FAILED, "grade", "no memory");
        mus_design_grade(sizes[i].pattern, sizes[i + 1].pattern, sizes[i].rules, &sizes[i].points);
    }
    return EXIT_DONE;
}


/* ---- output ---- */

static void grade_print(const grade_size *sizes, int count)
{
    printf("%-8s %7s %7s %9s %9s %9s %12s\n", "size", "panels", "seams", "bust", "waist", "hip", "seams off by");
    for (int i = 0; i < count; i++) {
        printf("%-8s %7d %7d", sizes[i].name, (int)mus_pattern_panel_count(sizes[i].pattern),
               (int)mus_pattern_seam_count(sizes[i].pattern));
        for (int k = 0; k < MUS_EASE_COUNT; k++) {
            if (isnan(sizes[i].ease[k])) printf(" %9s", "-");
            else printf(" %6.1f cm", 100.0 * sizes[i].ease[k]);
        }
        printf(" %9.3f mm\n", 1e3 * sizes[i].seam);
    }
    for (int i = 0; i + 1 < count; i++) {
        const int32_t points = mus_pattern_point_count(sizes[i].pattern);
        double most = 0.0;
        for (int32_t p = 0; p < points; p++)
            if (!isnan(sizes[i].rules[2 * p]))
                most = fmax(most, hypot(sizes[i].rules[2 * p], sizes[i].rules[2 * p + 1]));
        printf("%s to %s: %d of %d points have a rule, at most %.2f cm\n", sizes[i].name, sizes[i + 1].name,
               (int)sizes[i].points, (int)points, 100.0 * most);
    }
}


/* Prints a rule for each point at which an edge of an outline starts. */
static void grade_json_rules(json *j, const grade_size *from, const grade_size *to)
{
    json_open(j, NULL, '{');
    json_text(j, "from", from->name);
    json_text(j, "to", to->name);
    json_open(j, "rules", '[');
    for (int32_t p = 0; p < mus_pattern_panel_count(from->pattern); p++) {
        const int32_t *edges, *forward;
        int32_t n;
        if (mus_pattern_outline(from->pattern, p, &n, &edges, &forward) != MUS_OK) continue;
        for (int32_t i = 0; i < n; i++) {
            int32_t ends[2];
            mus_pattern_edge_ends(from->pattern, edges[i], &ends[0], &ends[1]);
            const double *rule = from->rules + 2 * ends[forward[i] > 0 ? 0 : 1];
            json_open(j, NULL, '{');
            json_text(j, "panel", mus_pattern_panel_name(from->pattern, p));
            json_text(j, "edge", mus_pattern_edge_name(from->pattern, edges[i]));
            json_number(j, "dx_m", rule[0]);
            json_number(j, "dy_m", rule[1]);
            json_close(j, '}');
        }
    }
    json_close(j, ']');
    json_close(j, '}');
}


static bool grade_json(const grade_size *sizes, int count)
{
    json j = {0};
    json_open(&j, NULL, '{');
    json_open(&j, "sizes", '[');
    for (int i = 0; i < count; i++) {
        json_open(&j, NULL, '{');
        json_text(&j, "size", sizes[i].name);
        json_int(&j, "panels", mus_pattern_panel_count(sizes[i].pattern));
        json_int(&j, "seams", mus_pattern_seam_count(sizes[i].pattern));
        json_open(&j, "ease_m", '{');
        for (int k = 0; k < MUS_EASE_COUNT; k++) json_number(&j, grade_levels[k], sizes[i].ease[k]);
        json_close(&j, '}');
        json_number(&j, "seams_off_m", sizes[i].seam);
        json_close(&j, '}');
    }
    json_close(&j, ']');
    json_open(&j, "steps", '[');
    for (int i = 0; i + 1 < count; i++) grade_json_rules(&j, &sizes[i], &sizes[i + 1]);
    json_close(&j, ']');
    json_warnings(&j);
    json_close(&j, '}');
    const bool written = json_write(&j, "grade", "-");
    json_free(&j);
    return written;
}


int command_grade(int argc, char **argv)
{
    source from = {0};
    const char *list = NULL;
    bool as_json = false;
    const option options[] = {{"--design", OPTION_TEXT, &from.design, 0, 0, "NAME  a named design"},
                              {"--words", OPTION_TEXT, &from.words, 0, 0,
                               "WORDS  a design in words: \"dress neck=v sleeve=puff\""},
                              {"--sizes", OPTION_TEXT, &list, 0, 0, "LIST  table sizes: W36,W38,W40"},
                              {"--json", OPTION_STDOUT, &as_json, 0, 0, "ease, seams and rules as JSON"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("grade", "Draft a design in several sizes; print ease, seams and grade rules.", options, argc, argv))
        return EXIT_INPUT;
    if (list == NULL) return complain(EXIT_INPUT, "grade", "no sizes are given: --sizes W36,W38,W40");

    scene s;
    static grade_size sizes[GRADE_MOST];
    int count = 0, code = scene_open(&s, "grade");
    if (code == EXIT_DONE) code = grade_read_sizes(&s, list, sizes, &count);
    if (code == EXIT_DONE) code = grade_draft(&s, &from, sizes, count);
    if (code == EXIT_DONE && as_json && !grade_json(sizes, count)) code = EXIT_FAILED;
    if (code == EXIT_DONE && !as_json) grade_print(sizes, count);
    for (int i = 0; i < count; i++) {
        mus_pattern_destroy(sizes[i].pattern);
        mus_tape_destroy(sizes[i].tape);
        free(sizes[i].rules);
    }
    scene_close(&s);
    return code;
}
