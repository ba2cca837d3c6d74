/*
 * convert.c: muslin convert: a pattern or tape file to another form, by its extension.
 *
 * Patterns: muslin JSON or GarmentCode in, muslin JSON, .svg or .pdf out. Tapes: any tape in, .tape out.
 */
#include <string.h>

#include "commands.h"
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


static int convert_tape(scene *s, const char *in, const char *row, const char *out)
{
    if (!ends_with(out, ".tape") && !ends_with(out, ".txt"))
        return complain(EXIT_INPUT, "convert", "%s: a tape is written as .tape or .txt", out);
    mus_status status = mus_tape_read(s->context, in, row, &s->tape);
    if (status == MUS_OK) status = mus_tape_write(s->tape, out);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


static int convert_pattern(scene *s, const char *in, const char *out)
{
    mus_sheet *sheet = NULL;
    mus_status status = mus_pattern_read(s->context, in, &s->pattern);
    if (status == MUS_OK && (ends_with(out, ".json") || strcmp(out, "-") == 0)) {
        status = mus_pattern_write(s->pattern, out);
    } else if (status == MUS_OK && (ends_with(out, ".svg") || ends_with(out, ".pdf"))) {
        status = mus_sheet_create(s->context, s->pattern, NULL, &sheet);
        if (status == MUS_OK)
            status = ends_with(out, ".svg") ? mus_sheet_write_svg(sheet, out) : mus_sheet_write_pdf(sheet, out);
    } else if (status == MUS_OK) {
        return complain(EXIT_INPUT, "convert", "%s: a pattern is written as .json, .svg or .pdf", out);
    }
    mus_sheet_destroy(sheet);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


int command_convert(int argc, char **argv)
{
    const char *in = NULL, *out = NULL, *row = NULL;
    const option options[] = {{"IN", OPTION_PLAIN, &in, 0, 0, "a pattern or a tape"},
                              {"OUT", OPTION_PLAIN, &out, 0, 0, "the file to write; its extension says the form"},
                              {"--row", OPTION_TEXT, &row, 0, 0, "NAME  which line of a .csv"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("convert", "Convert a pattern or a tape.", options, argc, argv)) return EXIT_INPUT;
    if (in == NULL || out == NULL) return complain(EXIT_INPUT, "convert", "two files are needed: IN OUT");

    scene s;
    int code = scene_open(&s, "convert");
    if (code == EXIT_DONE) code = is_tape(in) ? convert_tape(&s, in, row, out) : convert_pattern(&s, in, out);
    scene_close(&s);
    return code;
}
