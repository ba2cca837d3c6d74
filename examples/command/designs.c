/*
 * designs.c: muslin designs, which lists, searches, shows and draws the named designs, and muslin draft, which drafts
 * one.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "designs.h"
#include "json.h"
#include "language.h"
#include "muslin/language.h"
#include "scene.h"

#define MOST_LISTED 20 /* matches of a search that are printed without --most */
#define MOST_DRAWN 200 /* designs of a picture: 20 rows of ten */

/* the designs asked for, the best first */
typedef struct found {
    int32_t count, total; /* those listed; those that match */
    int32_t *design;      /* (count) */
    double *score;        /* (count), or NULL: the whole list */
} found;


/* Joins the words of the command line to a phrase of at most `size` bytes with the end. Returns an exit code. */
static int phrase_join(const texts *words, char *phrase, size_t size)
{
    phrase[0] = '\0';
    for (int32_t i = 0; i < words->count; i++) {
        const size_t n = strlen(phrase);
        const int more = snprintf(phrase + n, size - n, "%s%s", i > 0 ? " " : "", words->at[i]);
        if (more < 0 || (size_t)more >= size - n)
            return complain(EXIT_INPUT, "designs", "the words have more than %zu letters", size - 1);
    }
    return EXIT_DONE;
}


/* Lists all designs, or those that the words find, at most `most`. Returns an exit code. */
static int designs_find(const scene *s, const texts *words, int32_t most, found *out)
{
    char phrase[512];
    const int32_t all = mus_design_count();
    out->design = malloc((size_t)all * sizeof *out->design);
    out->score = malloc((size_t)all * sizeof *out->score);
    if (out->design == NULL || out->score == NULL) return complain(EXIT_FAILED, "designs", "no memory for the list");
    const int code = phrase_join(words, phrase, sizeof phrase);
    if (code != EXIT_DONE) return code;
    if (words->count == 0) {
        free(out->score);
        out->score = NULL;
        for (int32_t d = 0; d < all; d++) out->design[d] = d;
        out->total = all;
    } else {
        const mus_status status = mus_design_search(s->context, phrase, all, out->design, out->score, &out->total);
        if (status != MUS_OK) return scene_fail(s, status);
        if (out->total == 0) return complain(EXIT_FAILED, "designs", "no design is like \"%s\"", phrase);
    }
    out->count = most < out->total ? most : out->total;
    return EXIT_DONE;
}


static void designs_print(const found *list, int32_t language)
{
    for (int32_t i = 0; i < list->count; i++) {
        const int32_t d = list->design[i], groups = mus_design_groups(d);
        char title[256];
        mus_language_compose(language, "title", mus_design_title(d), title, sizeof title);
        printf("%-28s %-12s %c%c%c  %s\n", mus_design_name(d), mus_design_family(d),
               groups & MUS_GROUP_WOMEN ? 'w' : '-', groups & MUS_GROUP_MEN ? 'm' : '-',
               groups & MUS_GROUP_CHILDREN ? 'c' : '-', title);
    }
    if (list->count < list->total)
        printf("%d more of %d that match: --most %d lists them\n", (int)(list->total - list->count), (int)list->total,
               (int)list->total);
}


void design_json_head(int32_t design, json *j)
{
    const int32_t groups = mus_design_groups(design);
    json_text(j, "name", mus_design_name(design));
    json_text(j, "family", mus_design_family(design));
    json_text(j, "title", mus_design_title(design));
    json_text(j, "words", mus_design_words(design));
    json_text(j, "fabric", mus_design_fabric(design));
    json_open(j, "groups", '[');
    if (groups & MUS_GROUP_WOMEN) json_text(j, NULL, "women");
    if (groups & MUS_GROUP_MEN) json_text(j, NULL, "men");
    if (groups & MUS_GROUP_CHILDREN) json_text(j, NULL, "children");
    json_close(j, ']');
}


static void designs_json(const found *list, json *j)
{
    json_open(j, NULL, '[');
    for (int32_t i = 0; i < list->count; i++) {
        json_open(j, NULL, '{');
        design_json_head(list->design[i], j);
        if (list->score != NULL) json_number(j, "score", list->score[i]);
        json_close(j, '}');
    }
    json_close(j, ']');
}


int command_designs(int argc, char **argv)
{
    bool as_json = false;
    texts words = {0};
    const char *png = NULL, *show = NULL, *asked = NULL;
    double most = 0.0;
    source from = {0};
    const option options[] = {
        {"[WORDS...]", OPTION_REST, &words, 0, 0, "what it is called: pencil skirt, long sleeve tee, length=midi"},
        {"--most", OPTION_WHOLE, &most, 1, 10000, "N  number of matches listed, default 20; 12 in a picture"},
        {"--png", OPTION_OUTPUT, &png, 0, 0, "FILE  draw their pieces, the name under each"},
        {"--show", OPTION_TEXT, &show, 0, 0, "NAME  tell all of one: axes, cloth, ease, pieces, metres of cloth"},
        SOURCE_TAPE(from),
        LANGUAGE_OPTION(asked),
        {"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("designs", "List, search, show and draw the named designs.", options, argc, argv)) return EXIT_INPUT;
    const int32_t language = language_read("designs", asked);
    if (language == MUS_NONE) return EXIT_INPUT;
    if (show != NULL && (words.count > 0 || png != NULL))
        return complain(EXIT_INPUT, "designs", "--show NAME goes without words and --png");
    if (show != NULL) return design_show(show, &from, language, as_json);

    scene s;
    found list = {0};
    json j = {0};
    int code = scene_open(&s, "designs");
    const double usual = png != NULL ? 12.0 : words.count > 0 && !as_json ? MOST_LISTED : mus_design_count();
    if (code == EXIT_DONE) code = designs_find(&s, &words, (int32_t)(most > 0.0 ? most : usual), &list);
    if (code == EXIT_DONE && png != NULL && list.count > MOST_DRAWN)
        code = complain(EXIT_INPUT, "designs", "a picture of %d designs, at most %d", (int)list.count, MOST_DRAWN);
    if (code == EXIT_DONE && png != NULL) code = designs_draw(list.design, list.count, &from, png);
    if (code == EXIT_DONE && !as_json && !is_stdout(png)) designs_print(&list, language);
    if (code == EXIT_DONE && as_json) {
        designs_json(&list, &j);
        if (!json_write(&j, "designs", "-")) code = EXIT_FAILED;
    }
    json_free(&j);
    free(list.design);
    free(list.score);
    scene_close(&s);
    return code;
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
