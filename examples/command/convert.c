/*
 * convert.c: muslin convert: a pattern or tape file to another form, by its extension.
 *
 * Patterns: muslin JSON, GarmentCode, DXF, SVG, Valentina or Seamly in, muslin JSON, _specification.json
 * (GarmentCode), .panels.svg (an SVG that is read back), .svg, .pdf, .dxf or .plt out. Tapes: any tape in, .tape out.
 * --to names the form where the name of the file does not say it ("-" is standard output). Each thing of the pattern
 * that the form cannot hold is told in one line on standard error.
 */
#include <string.h>

#include "commands.h"
#include "convert_loss.h"
#include "muslin/print.h"
#include "print_dxf.h"
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


/* What convert is asked for; texts are NULL when not given. */
typedef struct convert_ask {
    const char *in, *out, *row, *to, *dialect, *rules, *size, *measures;
} convert_ask;


/* Reads the pattern: a DXF also in another size, with the rules beside it. */
static mus_status read_any(scene *s, const convert_ask *ask)
{
    if (ask->measures != NULL) {
        mus_pattern_val val;
        mus_pattern_val_init(&val, sizeof val);
        val.path = ask->in;
        val.measures_path = ask->measures;
        val.size_name = ask->size;
        return mus_pattern_read_val(s->context, &val, &s->pattern);
    }
    if (ask->rules == NULL && ask->size == NULL) return mus_pattern_read(s->context, ask->in, &s->pattern);
    mus_pattern_dxf from;
    mus_pattern_dxf_init(&from, sizeof from);
    from.path = ask->in;
    from.rules_path = ask->rules;
    from.size_name = ask->size;
    return mus_pattern_read_dxf(s->context, &from, &s->pattern);
}


static mus_status write_sheet(scene *s, const convert_ask *ask, const char *form)
{
    mus_sheet *sheet = NULL;
    mus_sheet_dxf dxf;
    mus_sheet_dxf_init(&dxf, sizeof dxf);
    dxf.dialect = print_dxf_dialect(ask->dialect);
    mus_status status = mus_sheet_create(s->context, s->pattern, NULL, &sheet);
    if (status == MUS_OK && strcmp(form, "svg") == 0) status = mus_sheet_write_svg(sheet, ask->out);
    if (status == MUS_OK && strcmp(form, "pdf") == 0) status = mus_sheet_write_pdf(sheet, ask->out);
    if (status == MUS_OK && strcmp(form, "dxf") == 0) status = mus_sheet_write_dxf(sheet, &dxf, ask->out);
    if (status == MUS_OK && strcmp(form, "plt") == 0) status = mus_sheet_write_plt(sheet, NULL, ask->out);
    mus_sheet_destroy(sheet);
    return status;
}


static int convert_pattern(scene *s, const convert_ask *ask)
{
    static const char *const forms[] = {"svg", "pdf", "dxf", "plt", "garmentcode", "panels"};
    const char *form = NULL;
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++)
        if (is_form(ask->out, ask->to, forms[i])) form = forms[i];
    if (ask->to == NULL && ends_with(ask->out, "_specification.json")) form = forms[4];
    if (ask->to == NULL && ends_with(ask->out, ".panels.svg")) form = forms[5];
    if (form == NULL && !is_form(ask->out, ask->to, "json") && (ask->to != NULL || !is_stdout(ask->out)))
        return complain(EXIT_INPUT, "convert",
                        "%s: a pattern is written as json, garmentcode, panels, svg, pdf, dxf or plt",
                        ask->to != NULL ? ask->to : ask->out);
    mus_status status = read_any(s, ask);
    if (status != MUS_OK) return scene_fail(s, status);
    if (form == NULL) status = mus_pattern_write(s->pattern, ask->out);
    else if (form == forms[4]) status = mus_pattern_write_garmentcode(s->pattern, ask->out);
    else if (form == forms[5]) status = mus_pattern_write_svg(s->pattern, ask->out);
    else status = write_sheet(s, ask, form);
    if (status == MUS_OK && form != NULL) convert_tell_losses(s->pattern, form);
    return status == MUS_OK ? EXIT_DONE : scene_fail_output(s, status);
}


int command_convert(int argc, char **argv)
{
    convert_ask ask = {0};
    const option options[] = {
        {"IN", OPTION_PLAIN, &ask.in, 0, 0, "a pattern or a tape"},
        {"OUT", OPTION_PLAIN, &ask.out, 0, 0, "the file to write, its form by its extension; - for standard output"},
        {"--to", OPTION_TEXT, &ask.to, 0, 0, "FORM  json, garmentcode, panels, svg, pdf, dxf or plt; tape or txt"},
        {"--dialect", OPTION_TEXT, &ask.dialect, 0, 0, "NAME  of a DXF that is written: astm (default) or aama"},
        {"--rul", OPTION_TEXT, &ask.rules, 0, 0, "FILE  the grade rules of a DXF that is read"},
        {"--size", OPTION_TEXT, &ask.size, 0, 0, "NAME  the size of a DXF that is read; without it the sample size"},
        {"--measures", OPTION_TEXT, &ask.measures, 0, 0, "FILE  .vit, .smis or .vst of a .val or .sm2d that is read"},
        {"--row", OPTION_TEXT, &ask.row, 0, 0, "NAME  the row of a .csv"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("convert", "Convert a pattern or a tape.", options, argc, argv)) return EXIT_INPUT;
    if (ask.in == NULL || ask.out == NULL) return complain(EXIT_INPUT, "convert", "two files are needed: IN OUT");
    if (ask.row != NULL && !is_tape(ask.in))
        return complain(EXIT_INPUT, "convert", "--row %s: %s is no tape", ask.row, ask.in);
    if (print_dxf_dialect(ask.dialect) == MUS_NONE)
        return complain(EXIT_INPUT, "convert", "--dialect %s: expected astm or aama", ask.dialect);
    if (!output_check("convert", ask.out)) return EXIT_INPUT;

    scene s;
    int code = scene_open(&s, "convert");
    if (code == EXIT_DONE)
        code = is_tape(ask.in) ? convert_tape(&s, ask.in, ask.row, ask.out, ask.to) : convert_pattern(&s, &ask);
    scene_close(&s);
    return code;
}
