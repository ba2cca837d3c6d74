/*
 * bench.c: muslin bench: node evaluations a CPU second, compared with the edge-list form (edge_list.h) in the same run,
 * and CPU seconds of whole scenes. Rows also have counts, which are the same on every machine.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>

#include "bench.h"
#include "command/commands.h"
#include "command/scene.h"


static double clock_seconds(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


double bench_cpu(void)
{
    return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}


double bench_wall(void)
{
    return clock_seconds(CLOCK_MONOTONIC);
}


bench_row bench_row_start(const char *name, int32_t precision, int32_t threads)
{
    bench_row row = {.name = name, .precision = precision, .threads = threads};
    row.plain_s = row.cpu_per_second = row.fall = row.strain = row.reaction = NAN;
    row.cpu_frame_ms = row.area = row.step = row.over_off = NAN;
    return row;
}


/* Writes a figure of a row, as a JSON member or as text, unless it is NaN. */
static void write_figure(bench *b, const char *key, const char *format, double value)
{
    if (isnan(value)) return;
    if (b->as_json) {
        json_number(&b->j, key, value);
        return;
    }
    printf("  ");
    printf(format, value);
}


void bench_row_write(bench *b, const bench_row *row)
{
    const double node_evaluations = (double)row->evaluations * row->nodes, rate = node_evaluations / row->cpu_s;
    const double springs = (double)row->evaluations * row->springs / row->cpu_s;
    if (b->as_json) {
        json_open(&b->j, NULL, '{');
        json_text(&b->j, "case", row->name);
        json_int(&b->j, "precision", row->precision);
        json_int(&b->j, "threads", row->threads);
        json_int(&b->j, "nodes", row->nodes);
        json_int(&b->j, "springs", row->springs);
        json_int(&b->j, "evaluations", row->evaluations);
        json_number(&b->j, "cpu_s", row->cpu_s);
        json_number(&b->j, "wall_s", row->wall_s);
        json_number(&b->j, "node_evaluations_per_cpu_s", rate);
        json_number(&b->j, "springs_per_cpu_s", springs);
        json_number(&b->j, "ns_per_node_evaluation", 1e9 / rate);
        if (isnan(row->plain_s)) json_null(&b->j, "ratio_to_edge_list");
    } else {
        printf("%-22s %2d bit %d thread%c %8d nodes %7.2f ns a node evaluation %7.1f M/CPU s %8.0f M springs/CPU s",
               row->name, (int)row->precision, (int)row->threads, row->threads == 1 ? ' ' : 's', (int)row->nodes,
               1e9 / rate, 1e-6 * rate, 1e-6 * springs);
    }
    write_figure(b, "ratio_to_edge_list", "%.2f x edge list", row->plain_s * rate);
    write_figure(b, "cpu_s_per_second", "%.3f CPU s a second", row->cpu_per_second);
    write_figure(b, "cpu_ms_per_frame", "%.1f CPU ms a frame of 20 ms", row->cpu_frame_ms);
    write_figure(b, "area_m2", "%.2f m2", row->area);
    write_figure(b, "step_s", "step %.3g s", row->step);
    write_figure(b, "fall_m", "fallen %.3f m at 0.5 s", row->fall);
    write_figure(b, "max_strain", "strain %.4f at rest", row->strain);
    write_figure(b, "reaction_over_weight", "reaction %.4f of the weight", row->reaction);
    write_figure(b, "ratio_to_off", "%.2f x without", row->over_off);
    if (b->as_json) json_close(&b->j, '}');
    else printf("\n");
    fflush(stdout);
}


/* Whether a part of the table is asked for. */
static bool asked(const char *only, const char *part)
{
    return only == NULL || strcmp(only, part) == 0;
}


int command_bench(int argc, char **argv)
{
    bool as_json = false, all = false;
    const char *only = NULL;
    const option options[] = {{"--all", OPTION_FLAG, &all, 0, 0, "also large cloths, and scenes at rest"},
                              {"--only", OPTION_TEXT, &only, 0, 0,
                               "PART  one part only: speed, contact, body, scenes or layers"},
                              {"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("bench", "Measure speed: node evaluations a CPU second, CPU seconds of whole scenes.", options, argc,
                   argv))
        return EXIT_INPUT;

    if (only != NULL && !asked(only, "speed") && !asked(only, "contact") && !asked(only, "body") &&
        !asked(only, "scenes") && !asked(only, "layers"))
        return complain(EXIT_INPUT, "bench", "--only %s: expected speed, contact, body, scenes or layers", only);

    scene s;
    struct utsname machine;
    int code = scene_open(&s, "bench");
    if (code != EXIT_DONE) return code;
    bench b = {.context = s.context, .as_json = as_json};
    json_open(&b.j, NULL, '{');
    json_text(&b.j, "machine", uname(&machine) == 0 ? machine.machine : "unknown");
    json_open(&b.j, "rows", '[');
    mus_status status = asked(only, "speed") ? bench_speed(&b, all) : MUS_OK;
    if (status == MUS_OK && asked(only, "contact")) status = bench_contact(&b);
    if (status == MUS_OK && asked(only, "contact")) status = bench_worn(&b);
    if (status == MUS_OK && asked(only, "body")) status = bench_body(&b);
    if (status == MUS_OK && asked(only, "scenes")) status = bench_scenes(&b, all);
    if (status == MUS_OK && asked(only, "layers")) status = bench_layers(&b);
    if (status != MUS_OK) code = scene_fail(&s, status);
    json_close(&b.j, ']');
    json_close(&b.j, '}');
    if (code == EXIT_DONE && as_json && !json_write(&b.j, "bench", "-")) code = EXIT_FAILED;
    json_free(&b.j);
    scene_close(&s);
    return code;
}
