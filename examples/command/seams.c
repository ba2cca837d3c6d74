/*
 * seams.c: muslin seams: the seams of a pattern whose file has none, proposed with a confidence; a pattern with them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "muslin/exchange.h"
#include "scene.h"
#include "seams_pieces.h"

/* What is asked for, and the proposals of the library. */
typedef struct seams_work {
    const char *in, *out, *size;
    double least; /* confidence of a seam that is sewn */
    texts pieces, splits;
    bool json;
    int32_t count, *edges, *chosen;
    double *confidence;
} seams_work;


static mus_status seams_read(scene *s, const seams_work *w)
{
    if (w->size == NULL) return mus_pattern_read(s->context, w->in, &s->pattern);
    mus_pattern_dxf from;
    mus_pattern_dxf_init(&from, sizeof from);
    from.path = w->in;
    from.size_name = w->size;
    return mus_pattern_read_dxf(s->context, &from, &s->pattern);
}


static mus_status seams_propose(scene *s, seams_work *w)
{
    const size_t room = 2 * (size_t)mus_pattern_edge_count(s->pattern) + 1;
    w->edges = calloc(2 * room, sizeof *w->edges);
    w->chosen = calloc(room, sizeof *w->chosen);
    w->confidence = calloc(room, sizeof *w->confidence);
    if (w->edges == NULL || w->chosen == NULL || w->confidence == NULL) return MUS_ERR_MEMORY;
    return mus_pattern_propose_seams(s->pattern, w->edges, w->chosen, w->confidence, (int32_t)room, &w->count);
}


/* Sews the proposals that are sure enough; *sewn is how many. */
static mus_status seams_sew(scene *s, const seams_work *w, int32_t *sewn)
{
    mus_status status = MUS_OK;
    *sewn = 0;
    for (int32_t i = 0; i < w->count && status == MUS_OK; i++) {
        if (!w->chosen[i] || w->confidence[i] < w->least) continue;
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = w->edges[2 * i];
        def.edge_b = w->edges[2 * i + 1];
        def.ease = mus_pattern_edge_length(s->pattern, def.edge_b) - mus_pattern_edge_length(s->pattern, def.edge_a);
        status = mus_pattern_add_seam(s->pattern, &def, NULL);
        *sewn += status == MUS_OK;
    }
    return status;
}


static const char *panel_of(const mus_pattern *pattern, int32_t edge)
{
    return mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, edge));
}


static void seams_print(const scene *s, const seams_work *w)
{
    for (int32_t i = 0; i < w->count; i++) {
        const int32_t a = w->edges[2 * i], b = w->edges[2 * i + 1];
        if (i > 0 && w->chosen[i - 1] && !w->chosen[i]) printf("second choices:\n");
        print_line("%4.2f  %s edge %d (%.1f mm) - %s edge %d (%.1f mm)", w->confidence[i], panel_of(s->pattern, a),
                   (int)a, 1e3 * mus_pattern_edge_length(s->pattern, a), panel_of(s->pattern, b), (int)b,
                   1e3 * mus_pattern_edge_length(s->pattern, b));
    }
}


static bool seams_json(const scene *s, const seams_work *w)
{
    json j = {0};
    json_open(&j, NULL, '{');
    json_open(&j, "seams", '[');
    for (int32_t i = 0; i < w->count; i++) {
        const int32_t a = w->edges[2 * i], b = w->edges[2 * i + 1];
        json_open(&j, NULL, '{');
        json_text(&j, "panel_a", panel_of(s->pattern, a));
        json_int(&j, "edge_a", a);
        json_text(&j, "panel_b", panel_of(s->pattern, b));
        json_int(&j, "edge_b", b);
        json_bool(&j, "chosen", w->chosen[i]);
        json_number(&j, "confidence", w->confidence[i]);
        json_close(&j, '}');
    }
    json_close(&j, ']');
    json_warnings(&j);
    json_close(&j, '}');
    const bool done = json_write(&j, "seams", "-");
    json_free(&j);
    return done;
}


static int seams_run(scene *s, seams_work *w)
{
    int32_t sewn = 0;
    mus_status status = seams_read(s, w);
    if (status != MUS_OK) return scene_fail(s, status);
    if (seams_pieces(s->pattern, &w->splits, &w->pieces) != MUS_OK) return EXIT_INPUT;
    status = seams_propose(s, w);
    if (status != MUS_OK) return scene_fail(s, status);
    if (w->json && !seams_json(s, w)) return EXIT_FAILED;
    if (!w->json && !is_stdout(w->out)) seams_print(s, w);
    if (w->out == NULL) return EXIT_DONE;
    status = seams_sew(s, w, &sewn);
    if (status == MUS_OK) status = mus_pattern_write(s->pattern, w->out);
    if (status != MUS_OK) return scene_fail_output(s, status);
    fprintf(stderr, "muslin seams: %d seams sewn; look at them before you dress the pattern\n", (int)sewn);
    return EXIT_DONE;
}


int command_seams(int argc, char **argv)
{
    seams_work w = {.least = 0.5};
    const option options[] = {
        {"IN", OPTION_PLAIN, &w.in, 0, 0, "a pattern without seams, or with some of them"},
        {"-o", OPTION_OUTPUT, &w.out, 0, 0, "FILE  write the pattern with the seams as muslin JSON"},
        {"--least", OPTION_NUMBER, &w.least, 0, 1, "P  smallest confidence of a seam that -o sews, 0.5 by default"},
        {"--size", OPTION_TEXT, &w.size, 0, 0, "NAME  the size of a DXF; without it the sample size"},
        {"--piece", OPTION_LIST, &w.pieces, 0, 0,
         "'NAME[=NEW] [leave|fold|fold:EDGE|pair] [LABEL]'  what the file does not tell of a panel; repeatable"},
        {"--split", OPTION_LIST, &w.splits, 0, 0, "EDGE:MM,MM ...  part an edge so far from its start; repeatable"},
        {"--json", OPTION_STDOUT, &w.json, 0, 0, "print JSON"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("seams", "Propose the seams of a pattern.", options, argc, argv)) return EXIT_INPUT;
    if (w.in == NULL) return complain(EXIT_INPUT, "seams", "a pattern is needed");

    scene s;
    int code = scene_open(&s, "seams");
    if (code == EXIT_DONE) code = seams_run(&s, &w);
    free(w.edges);
    free(w.chosen);
    free(w.confidence);
    scene_close(&s);
    return code;
}
