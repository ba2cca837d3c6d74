/*
 * convert.c: muslin convert: a pattern or tape file to another form, by its extension.
 *
 * Patterns: muslin JSON, GarmentCode or DXF in, muslin JSON, .svg, .pdf or .dxf out. Tapes: any tape in, .tape out.
 * --to names the form where the name of the file does not say it ("-" is standard output). Each thing of the pattern
 * that the form cannot hold is told in one line on standard error.
 */
#include <string.h>

#include "commands.h"
#include "convert_loss.h"
#include "muslin/print.h"
#include "scene.h"


static bool ends_with(const char *text, const char *end)
{
    const size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}


static bool is_tape(const char *name)
{
    static const char *const ends[] = {".tape", ".txt", ".yaml", ".yml", ".vit", ".csv"};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
        if (ends_with(name, ends[i])) return true;
    return false;
}


/* Whether the output has the form `name` ("json"). */
static bool is_form(const char *out, const char *to, const char *name)
{
    if (to != NULL) return strcmp(to, name) == 0;
    const size_t n = strlen(out), m = strlen(name);
    return n > m && out[n - m - 1] == '.' && strcmp(out + n - m, name) == 0;
}


static int convert_tape(scene *s, const char *in, const char *row, const char *out, const char *to)
{
    if (!is_form(out, to, "tape") && !is_form(out, to, "txt") && (to != NULL || !is_stdout(out)))
        return complain(EXIT_INPUT, "convert", "%s: a tape is written as tape or txt", to != NULL ? to : out);
    mus_status status = mus_tape_read(s->context, in, row, &s->tape);
    if (status != MUS_OK) return scene_fail(s, status);
    status = mus_tape_write(s->tape, out);
    return status == MUS_OK ? EXIT_DONE : scene_fail_output(s, status);
}


static int convert_pattern(scene *s, const char *in, const char *out, const char *to)
{
    const bool svg = is_form(out, to, "svg"), pdf = is_form(out, to, "pdf"), dxf = is_form(out, to, "dxf");
    if (!svg && !pdf && !dxf && !is_form(out, to, "json") && (to != NULL || !is_stdout(out)))
        return complain(EXIT_INPUT, "convert", "%s: a pattern is written as json, svg, pdf or dxf",
                        to != NULL ? to : out);

    mus_sheet *sheet = NULL;
    mus_status status = mus_pattern_read(s->context, in, &s->pattern);
    if (status != MUS_OK) return scene_fail(s, status);
    if (!svg && !pdf && !dxf) status = mus_pattern_write(s->pattern, out);
    if (status == MUS_OK && (svg || pdf || dxf)) status = mus_sheet_create(s->context, s->pattern, NULL, &sheet);
    if (status == MUS_OK && svg) status = mus_sheet_write_svg(sheet, out);
    if (status == MUS_OK && pdf) status = mus_sheet_write_pdf(sheet, out);
    if (status == MUS_OK && dxf) status = mus_sheet_write_dxf(sheet, NULL, out);
    mus_sheet_destroy(sheet);
    if (status == MUS_OK && (svg || pdf || dxf)) convert_tell_losses(s->pattern, svg ? "svg" : pdf ? "pdf" : "dxf");
    return status == MUS_OK ? EXIT_DONE : scene_fail_output(s, status);
}


int command_convert(int argc, char **argv)
{
    const char *in = NULL, *out = NULL, *row = NULL, *to = NULL;
    const option options[] = {
        {"IN", OPTION_PLAIN, &in, 0, 0, "a pattern or a tape"},
        {"OUT", OPTION_PLAIN, &out, 0, 0, "the file to write, its form by its extension; - for standard output"},
        {"--to", OPTION_TEXT, &to, 0, 0, "FORM  json, svg, pdf or dxf; tape or txt"},
        {"--row", OPTION_TEXT, &row, 0, 0, "NAME  the row of a .csv"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("convert", "Convert a pattern or a tape.", options, argc, argv)) return EXIT_INPUT;
    if (in == NULL || out == NULL) return complain(EXIT_INPUT, "convert", "two files are needed: IN OUT");
    if (row != NULL && !is_tape(in)) return complain(EXIT_INPUT, "convert", "--row %s: %s is no tape", row, in);
    if (!output_check("convert", out)) return EXIT_INPUT;

    scene s;
    int code = scene_open(&s, "convert");
    if (code == EXIT_DONE) code = is_tape(in) ? convert_tape(&s, in, row, out, to) : convert_pattern(&s, in, out, to);
    scene_close(&s);
    return code;
}
