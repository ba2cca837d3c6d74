/*
 * designs.c: muslin designs, which lists the named designs, and muslin draft, which drafts one.
 */
#include <stdio.h>

#include "commands.h"
#include "json.h"
#include "scene.h"


int command_designs(int argc, char **argv)
{
    bool as_json = false;
    const option options[] = {{"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("designs", "List the named designs.", options, argc, argv)) return EXIT_INPUT;

    json j = {0};
    json_open(&j, NULL, '[');
    for (int32_t d = 0; d < mus_design_count(); d++) {
        const int32_t groups = mus_design_groups(d);
        if (!as_json)
            printf("%-28s %-12s %c%c%c  %s\n", mus_design_name(d), mus_design_family(d),
                   groups & MUS_GROUP_WOMEN ? 'w' : '-', groups & MUS_GROUP_MEN ? 'm' : '-',
                   groups & MUS_GROUP_CHILDREN ? 'c' : '-', mus_design_title(d));
        json_open(&j, NULL, '{');
        json_text(&j, "name", mus_design_name(d));
        json_text(&j, "family", mus_design_family(d));
        json_text(&j, "title", mus_design_title(d));
        json_text(&j, "words", mus_design_words(d));
        json_open(&j, "groups", '[');
        if (groups & MUS_GROUP_WOMEN) json_text(&j, NULL, "women");
        if (groups & MUS_GROUP_MEN) json_text(&j, NULL, "men");
        if (groups & MUS_GROUP_CHILDREN) json_text(&j, NULL, "children");
        json_close(&j, ']');
        json_close(&j, '}');
    }
    json_close(&j, ']');
    const bool written = !as_json || json_write(&j, "designs", "-");
    json_free(&j);
    return written ? EXIT_DONE : EXIT_FAILED;
}


int command_draft(int argc, char **argv)
{
    source from = {0};
    const char *out = NULL;
    const option options[] = {{"--design", OPTION_TEXT, &from.design, 0, 0, "NAME  a named design"},
                              {"--words", OPTION_TEXT, &from.words, 0, 0,
                               "WORDS  a design in words: \"dress neck=v sleeve=puff\""},
                              SOURCE_TAPE(from),
                              {"-o", OPTION_OUTPUT, &out, 0, 0,
                               "FILE  write the pattern as muslin JSON; - for standard output"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("draft", "Draft a design to a tape.", options, argc, argv)) return EXIT_INPUT;
    if (out == NULL) return complain(EXIT_INPUT, "draft", "no output is given: -o FILE");

    scene s;
    int code = scene_open(&s, "draft");
    if (code == EXIT_DONE) code = scene_tape(&s, &from);
    if (code == EXIT_DONE) code = scene_pattern(&s, &from);
    if (code == EXIT_DONE) {
        const mus_status status = mus_pattern_write(s.pattern, out);
        if (status != MUS_OK) code = scene_fail_output(&s, status);
    }
    scene_close(&s);
    return code;
}
