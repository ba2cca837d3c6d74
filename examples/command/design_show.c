/*
 * design_show.c: muslin designs --show: all of one design: axes, cloth, ease, pieces and their cloth.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "designs.h"
#include "json.h"
#include "muslin/language.h"
#include "muslin/print.h"

#define CLOTH_WIDE 1.40 /* [m] width of the cloth that metres are told for: the common width of dress cloth */
#define PIECES_MOST 256

/* pieces of a design on cloth, told and written */
typedef struct shown {
    int32_t design;
    char words[512];         /* spelled in full, without the axes at their first option */
    double ease[MUS_EASE_COUNT];
    int32_t pieces;
    mus_sheet_piece piece[PIECES_MOST];
    double area, metres;     /* of all pieces inside their seam lines [m2]; length of cloth CLOTH_WIDE wide that their
                              * boxes need, NaN: a box is wider */
} shown;

static const char *const levels[MUS_EASE_COUNT] = {"bust", "waist", "hip"};


const char *design_size(int32_t design)
{
    const int32_t groups = mus_design_groups(design);
    return groups & MUS_GROUP_WOMEN ? "W40" : groups & MUS_GROUP_MEN ? "M50" : "C116";
}


int design_draft(scene *s, int32_t design, const source *from)
{
    source own = *from;
    own.design = mus_design_name(design);
    if (own.tape == NULL && own.size == NULL) own.size = design_size(design);
    const int code = scene_tape(s, &own);
    return code == EXIT_DONE ? scene_pattern(s, &own) : code;
}


/* Writes the option of an axis to `out` (64); false when the garment does not have the axis. `words`: spelled. */
static bool axis_option(const scene *s, const char *words, int32_t axis, char *out)
{
    char key[48], asked[640], full[640];
    snprintf(key, sizeof key, " %s=", mus_design_axis_name(axis));
    const char *given = strstr(words, key);
    if (given != NULL) {
        given += strlen(key);
        snprintf(out, 64, "%.*s", (int)strcspn(given, " "), given);
        return true;
    }

    /* left out: the first option, if the words go with it */
    snprintf(out, 64, "%s", mus_design_option_name(axis, 0));
    snprintf(asked, sizeof asked, "%s%s%s", words, key, out);
    return mus_design_spell(s->context, asked, full, sizeof full) == MUS_OK;
}


/* Length of cloth that holds the boxes of all copies, the grain along its length: the tallest first, each in the first
 * shelf with room (first fit decreasing height; Coffman, Garey, Johnson, Tarjan, 1980). NaN: one is wider. */
static double cloth_length(const shown *sh)
{
    double high[PIECES_MOST], wide[PIECES_MOST], shelf[PIECES_MOST], length = 0.0;
    int32_t n = 0, shelves = 0;
    for (int32_t p = 0; p < sh->pieces; p++)
        for (int32_t c = 0; c < sh->piece[p].materials[MUS_MATERIAL_MAIN] && n < PIECES_MOST; c++, n++) {
            const double *box = sh->piece[p].box, h = box[3] - box[1];
            int32_t at = n;
            for (; at > 0 && high[at - 1] < h; at--) high[at] = high[at - 1], wide[at] = wide[at - 1];
            high[at] = h, wide[at] = box[2] - box[0];
        }
    for (int32_t i = 0; i < n; i++) {
        int32_t k = 0;
        if (wide[i] > CLOTH_WIDE) return NAN;
        while (k < shelves && shelf[k] + wide[i] > CLOTH_WIDE) k++;
        if (k == shelves) shelf[shelves++] = 0.0, length += high[i];
        shelf[k] += wide[i];
    }
    return length;
}


static mus_status shown_make(const scene *s, int32_t design, shown *out)
{
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    out->design = design;
    mus_status status = mus_design_spell(s->context, mus_design_words(design), out->words, sizeof out->words);
    if (status == MUS_OK) status = mus_design_ease(s->pattern, s->tape, out->ease);
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_ROLL;
    if (status == MUS_OK) status = mus_sheet_create(s->context, s->pattern, &def, &sheet);
    for (int32_t p = 0; status == MUS_OK && p < mus_sheet_piece_count(sheet) && p < PIECES_MOST; p++) {
        mus_sheet_piece *piece = &out->piece[out->pieces++];
        mus_sheet_piece_init(piece, sizeof *piece);
        status = mus_sheet_piece_get(sheet, p, piece);
        /* the panels that are cut and not draped follow those of the pattern; names live longer than the sheet */
        const int32_t own = mus_pattern_panel_count(s->pattern), panel = piece->panel - (piece->panel < own ? 0 : own);
        const mus_pattern *pattern = piece->panel < own ? s->pattern : mus_pattern_cut_only(s->pattern);
        piece->name = mus_pattern_panel_name(pattern, panel);
        out->area += piece->materials[MUS_MATERIAL_MAIN] * mus_pattern_panel_area(pattern, panel);
    }
    mus_sheet_destroy(sheet);
    out->metres = cloth_length(out);
    return status;
}


/* "collar 2 + 1 interfacing", "sleeve_left 2 mirrored" */
static void shown_piece(const mus_sheet_piece *piece, bool comma)
{
    printf("%s %s", comma ? "," : "", piece->name);
    for (int32_t m = 0, n = 0; m < MUS_MATERIAL_COUNT; m++)
        if (piece->materials[m] > 0)
            printf("%s %d%s%s", n++ > 0 ? " +" : "", (int)piece->materials[m], m > 0 ? " " : "",
                   m > 0 ? mus_material_name(m) : "");
    printf("%s", piece->mirrored ? " mirrored" : "");
}


static void shown_print(const scene *s, const shown *sh, int32_t language)
{
    const int32_t d = sh->design, groups = mus_design_groups(d);
    char one[64], title[256];
    mus_language_compose(language, "title", mus_design_title(d), title, sizeof title);
    printf("%s: %s\n  family  %s\n  fabric  %s\n  for    %s%s%s\n  words   %s\n  axes   ", mus_design_name(d), title,
           mus_design_family(d), mus_design_fabric(d), groups & MUS_GROUP_WOMEN ? " women" : "",
           groups & MUS_GROUP_MEN ? " men" : "",
           groups & MUS_GROUP_CHILDREN ? " children" : "", mus_design_words(d));
    for (int32_t a = 1; a < mus_design_axis_count(); a++)
        if (axis_option(s, sh->words, a, one)) printf(" %s=%s", mus_design_axis_name(a), one);
    printf("\n  ease   ");
    for (int32_t e = 0; e < MUS_EASE_COUNT; e++)
        if (isfinite(sh->ease[e]))
            printf(" %s %.1f cm", levels[e], fabs(sh->ease[e]) < 5e-4 ? 0.0 : 100.0 * sh->ease[e]);
    printf("   on %s\n  pieces ", mus_tape_name(s->tape));
    for (int32_t p = 0; p < sh->pieces; p++)
        shown_piece(&sh->piece[p], p > 0);
    printf("\n  cloth   %.2f m2 inside the seams", sh->area);
    if (isfinite(sh->metres))
        printf("; the boxes of all pieces fit on %.2f m of cloth %.2f m wide", sh->metres, CLOTH_WIDE);
    else
        printf("; a piece is wider than cloth of %.2f m", CLOTH_WIDE);
    printf("\n");
}


static void shown_json(const scene *s, const shown *sh, json *j)
{
    char one[64];
    json_open(j, NULL, '{');
    design_json_head(sh->design, j);
    json_open(j, "axes", '{');
    for (int32_t a = 1; a < mus_design_axis_count(); a++)
        if (axis_option(s, sh->words, a, one)) json_text(j, mus_design_axis_name(a), one);
    json_close(j, '}');
    json_text(j, "tape", mus_tape_name(s->tape));
    json_open(j, "ease_m", '{');
    for (int32_t e = 0; e < MUS_EASE_COUNT; e++) json_number(j, levels[e], sh->ease[e]);
    json_close(j, '}');
    json_open(j, "pieces", '[');
    for (int32_t p = 0; p < sh->pieces; p++) {
        const double *box = sh->piece[p].box;
        json_open(j, NULL, '{');
        json_text(j, "name", sh->piece[p].name);
        json_int(j, "copies", sh->piece[p].copies);
        json_bool(j, "mirrored", sh->piece[p].mirrored != 0);
        json_open(j, "materials", '{');
        for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++)
            if (sh->piece[p].materials[m] > 0) json_int(j, mus_material_name(m), sh->piece[p].materials[m]);
        json_close(j, '}');
        json_number(j, "width_m", box[2] - box[0]);
        json_number(j, "height_m", box[3] - box[1]);
        json_close(j, '}');
    }
    json_close(j, ']');
    json_number(j, "area_m2", sh->area);
    json_number(j, "cloth_width_m", CLOTH_WIDE);
    json_number(j, "cloth_length_m", sh->metres);
    json_close(j, '}');
}


int design_show(const char *name, const source *from, int32_t language, bool as_json)
{
    scene s;
    shown sh = {0};
    json j = {0};
    const int32_t design = design_named("designs", "--show", name);
    if (design == MUS_NONE) return EXIT_INPUT;
    int code = scene_open(&s, "designs");
    if (code == EXIT_DONE) code = design_draft(&s, design, from);
    if (code == EXIT_DONE) {
        const mus_status status = shown_make(&s, design, &sh);
        if (status != MUS_OK) code = scene_fail(&s, status);
    }
    if (code == EXIT_DONE && as_json) {
        shown_json(&s, &sh, &j);
        if (!json_write(&j, "designs", "-")) code = EXIT_FAILED;
    } else if (code == EXIT_DONE) {
        shown_print(&s, &sh, language);
    }
    json_free(&j);
    scene_close(&s);
    return code;
}
