/*
 * layout.c: muslin layout: lays the pieces of a pattern on cloth: metres, a drawing, places as JSON.
 */
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "muslin/print.h"
#include "scene.h"

/* what the options ask for */
typedef struct layout_asked {
    double width, gap, allowance, tolerance, stripe, effort, seed, runs, threads;
    bool fold, nap, as_json;
    const char *material, *svg;
} layout_asked;


/* Writes the options of a layout of one material. */
static void layout_define(const layout_asked *asked, int32_t material, mus_layout_def *def)
{
    mus_layout_def_init(def, sizeof *def);
    def->width = 0.001 * asked->width;
    if (asked->gap >= 0.0) def->gap = 0.001 * asked->gap;
    if (asked->allowance >= 0.0) def->allowance = 0.001 * asked->allowance;
    def->tolerance = asked->tolerance * 3.14159265358979323846 / 180.0;
    def->stripe = 0.001 * asked->stripe;
    def->material = material;
    def->fold = asked->fold;
    def->nap = asked->nap;
    def->steps = (int64_t)(1e9 * asked->effort);
    def->seed = (uint64_t)asked->seed;
    def->runs = (int32_t)asked->runs;
    def->threads = (int32_t)asked->threads;
}


static void layout_json_piece(json *j, const mus_layout *layout, int32_t index)
{
    mus_layout_piece piece;
    mus_layout_piece_init(&piece, sizeof piece);
    if (mus_layout_piece_get(layout, index, &piece) != MUS_OK) return;
    json_open(j, NULL, '{');
    json_text(j, "name", piece.name);
    json_int(j, "panel", piece.panel);
    json_int(j, "layers", piece.layers);
    json_bool(j, "on_fold", piece.on_fold != 0);
    json_bool(j, "mirrored", piece.mirrored != 0);
    json_bool(j, "turned", piece.turned != 0);
    json_bool(j, "spare", piece.spare != 0);
    json_open(j, "turn", '[');
    for (int k = 0; k < 4; k++) json_number(j, NULL, piece.turn[k]);
    json_close(j, ']');
    json_open(j, "shift_m", '[');
    for (int k = 0; k < 2; k++) json_number(j, NULL, piece.shift[k]);
    json_close(j, ']');
    json_open(j, "outline_m", '[');
    for (int32_t k = 0; k < 2 * piece.n; k++) json_number(j, NULL, piece.xy[k]);
    json_close(j, ']');
    json_close(j, '}');
}


/* Writes the figures and pieces of a layout as members. */
static void layout_json(json *j, const mus_layout *layout, int32_t material)
{
    json_text(j, "material", mus_material_name(material));
    json_number(j, "width_m", mus_layout_width(layout));
    json_number(j, "length_m", mus_layout_length(layout));
    json_number(j, "folded_m", mus_layout_folded(layout));
    json_number(j, "utilisation", mus_layout_utilisation(layout));
    json_int(j, "steps", mus_layout_steps(layout));
    json_open(j, "pieces", '[');
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) layout_json_piece(j, layout, i);
    json_close(j, ']');
}


static void layout_line(const mus_layout *layout, int32_t material)
{
    const double folded = mus_layout_folded(layout), length = mus_layout_length(layout);
    char part[80] = "";
    if (folded > 0.0 && folded < length)
        snprintf(part, sizeof part, ", of which %.2f m folded and %.2f m open", folded, length - folded);
    else if (folded > 0.0)
        snprintf(part, sizeof part, ", folded");
    print_line("%s: %.2f m of %.2f m wide%s; %d pieces laid, %.1f %% of the cloth used", mus_material_name(material),
               length, mus_layout_width(layout), part, (int)mus_layout_piece_count(layout),
               100.0 * mus_layout_utilisation(layout));
}


/* The file of a material's drawing: the one asked for, for the first material; then NAME-lining.svg. */
static bool layout_file(const layout_asked *asked, int32_t material, bool first, char *out, size_t size)
{
    const char *dot = strrchr(asked->svg, '.'), *slash = strrchr(asked->svg, '/');
    const size_t stem = dot != NULL && (slash == NULL || dot > slash) ? (size_t)(dot - asked->svg) : strlen(asked->svg);
    const int n =
        first ? snprintf(out, size, "%s", asked->svg)
              : snprintf(out, size, "%.*s-%s%s", (int)stem, asked->svg, mus_material_name(material), asked->svg + stem);
    return n > 0 && (size_t)n < size && (first || !is_stdout(asked->svg));
}


/* Lays one material: adds it to the list of materials, draws it, tells it. Without pieces it is passed over, unless it
 * was asked for by name. */
static int layout_material(const scene *s, const layout_asked *asked, int32_t material, int32_t *laid, json *j)
{
    char path[4096];
    mus_layout_def def;
    mus_layout *layout = NULL;
    layout_define(asked, material, &def);
    mus_status status = mus_layout_create(s->context, s->pattern, &def, &layout);
    if (status != MUS_OK) return scene_fail(s, status);
    int code = EXIT_DONE;
    if (mus_layout_piece_count(layout) > 0 || asked->material != NULL) {
        const bool first = *laid == 0;
        ++*laid;
        if (asked->svg != NULL && layout_file(asked, material, first, path, sizeof path)) {
            status = mus_layout_write_svg(layout, path);
            if (status != MUS_OK) code = scene_fail_output(s, status);
        }
        if (first) layout_json(j, layout, material);
        if (first) json_open(j, "materials", '[');
        json_open(j, NULL, '{');
        layout_json(j, layout, material);
        json_close(j, '}');
        if (code == EXIT_DONE && !asked->as_json && !is_stdout(asked->svg)) layout_line(layout, material);
    }
    mus_layout_destroy(layout);
    return code;
}


static int layout_all(const scene *s, const layout_asked *asked, json *j)
{
    int32_t laid = 0;
    int code = EXIT_DONE;
    json_open(j, NULL, '{');
    for (int32_t material = 0; material < MUS_MATERIAL_COUNT && code == EXIT_DONE; material++) {
        /* elastic is sold by the metre of tape, not of cloth */
        if (asked->material != NULL ? mus_material_find(asked->material) != material : material == MUS_MATERIAL_ELASTIC)
            continue;
        code = layout_material(s, asked, material, &laid, j);
    }
    if (code == EXIT_DONE && laid == 0)
        return complain(EXIT_INPUT, "layout", "no piece of the pattern is cut of cloth");
    json_close(j, ']');
    json_warnings(j);
    json_close(j, '}');
    return code;
}


int command_layout(int argc, char **argv)
{
    source from = {0};
    layout_asked asked = {
        .width = 1400.0, .gap = -1.0, .allowance = -1.0, .effort = 1.0, .seed = 1.0, .runs = 1.0, .threads = 1.0};
    const option options[] = {
        SOURCE_PATTERN(from),
        SOURCE_TAPE(from),
        {"--width", OPTION_NUMBER, &asked.width, 10, 1e5, "MM  of the cloth from selvedge to selvedge, default 1400"},
        {"--fold", OPTION_FLAG, &asked.fold, 0, 0, "the cloth is folded lengthwise and cut through two layers"},
        {"--nap", OPTION_FLAG, &asked.nap, 0, 0, "pile, or a print with an up and a down: no piece is turned round"},
        {"--material", OPTION_TEXT, &asked.material, 0, 0, "NAME  main, lining, interfacing, rib; default: all"},
        {"--gap", OPTION_NUMBER, &asked.gap, 0, 100, "MM  between cut lines, default 2"},
        {"--allowance", OPTION_NUMBER, &asked.allowance, 0, 100, "MM  seam allowance where the pattern has none"},
        {"--tolerance", OPTION_NUMBER, &asked.tolerance, 0, 11, "DEG  by which a piece may leave the grain, default 0"},
        {"--stripe", OPTION_NUMBER, &asked.stripe, 1, 10000, "MM  between stripes across the cloth: hems match"},
        {"--effort", OPTION_NUMBER, &asked.effort, 0.0001, 10000,
         "N  billions of steps, about a second each, default 1"},
        {"--runs", OPTION_WHOLE, &asked.runs, 1, 64, "N  searches, of which the shortest is taken, default 1"},
        {"--threads", OPTION_WHOLE, &asked.threads, 1, 64, "N  that share the runs, default 1; the result is the same"},
        {"--seed", OPTION_WHOLE, &asked.seed, 0, 1e9, "N  of the first run, default 1"},
        {"--svg", OPTION_OUTPUT, &asked.svg, 0, 0, "FILE  draw the layout; further materials as FILE-lining"},
        {"--json", OPTION_STDOUT, &asked.as_json, 0, 0, "print metres, utilisation and places as JSON"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("layout", "Lay the pieces of a pattern on cloth.", options, argc, argv)) return EXIT_INPUT;
    if (asked.material != NULL && mus_material_find(asked.material) == MUS_NONE)
        return complain(EXIT_INPUT, "layout", "--material %s: expected main, lining, interfacing, rib or elastic",
                        asked.material);
    scene s;
    json j = {0};
    int code = scene_open(&s, "layout");
    if (code == EXIT_DONE && (from.tape != NULL || from.size != NULL || from.row != NULL)) code = scene_tape(&s, &from);
    if (code == EXIT_DONE) code = scene_pattern(&s, &from);
    if (code == EXIT_DONE) code = layout_all(&s, &asked, &j);
    if (code == EXIT_DONE && asked.as_json && !json_write(&j, "layout", "-")) code = EXIT_FAILED;
    json_free(&j);
    scene_close(&s);
    return code;
}
