/* fuzz_calls.c: targets that make calls of the bytes: words of a design, edits, option structs, calls in any order. */
#include "fuzz.h"

#include <math.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/print.h"

#define CALLS 24 /* at most: an input then takes milliseconds, under the sanitizers half a second */
#define SHEETS 2 /* made by an input at most: one takes as long as all other calls */


void fuzz_words(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    char words[200] = "", spelled[512], again[512];
    fuzz_input in = {bytes, size};
    /* either the text itself, or options by number, which are words more often */
    if (fuzz_take(&in, 1) % 2) {
        memcpy(words, in.at, in.left < sizeof words - 1 ? in.left : sizeof words - 1);
    } else {
        for (int32_t i = 0; i < 5 && in.left > 0; i++) {
            const int32_t axis = i == 0 ? 0 : fuzz_below(&in, mus_design_axis_count());
            const char *name = mus_design_axis_name(axis);
            const char *option = mus_design_option_name(axis, fuzz_below(&in, mus_design_option_count(axis)));
            const size_t at = strlen(words);
            if (name && option && at + strlen(name) + strlen(option) + 3 < sizeof words) {
                if (axis > 0) strcat(strcat(strcat(words, " "), name), "=");
                strcat(words, option);
            }
        }
    }
    if (mus_design_spell(context, words, spelled, sizeof spelled) == MUS_OK) {
        fuzz_must(mus_design_spell(context, spelled, again, sizeof again) == MUS_OK, "spelled words are words");
        fuzz_must(strcmp(spelled, again) == 0, "spelling twice is spelling once");
        mus_tape *tape;
        mus_pattern *pattern = NULL;
        fuzz_must(mus_tape_create(context, &tape) == MUS_OK && mus_tape_set_size(tape, "W40") == MUS_OK,
                  "a tape is made");
        if (mus_design_draft_words(context, spelled, tape, NULL, &pattern) != MUS_OK)
            fuzz_must(mus_context_error(context)[0] != '\0', "a refusal has a sentence");
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
    }
    fuzz_context_end(context);
}


/* edits that draw lines: of one to three points and of any kinds of piece */
static mus_status edit_line(mus_pattern *p, fuzz_input *in, int32_t number, int32_t a, int32_t b, double s, double t)
{
    int32_t kinds[4], notch;
    double xy[8];
    mus_cut_def cut;
    mus_cut_def_init(&cut, sizeof cut);
    for (int i = 0; i < 4; i++) kinds[i] = fuzz_below(in, MUS_PIECE_ARC + 1);
    for (int i = 0; i < 8; i++) xy[i] = fuzz_real(in, -0.4, 0.6);
    cut.name = "part", cut.seam_name = "cut";
    cut.edge_a = a, cut.edge_b = b, cut.s_a = s, cut.s_b = t;
    cut.npiece = fuzz_below(in, 4), cut.nxy = fuzz_below(in, 4);
    cut.kinds = kinds, cut.xy = xy;
    switch (number) {
    case 20: return mus_pattern_separate(p, &cut, NULL, NULL);
    case 21: return mus_pattern_dart_to_seam(p, &cut, NULL, &notch);
    case 22: return mus_pattern_redraw_edge(p, a, cut.npiece, kinds, cut.nxy, xy);
    case 23: return mus_pattern_add_patch(p, b, "patch", 4, xy, NULL);
    default: return mus_pattern_move_control(p, a, cut.npiece, xy[0], xy[1]);
    }
}


/* one edit of the number, at cells and places of the bytes */
static mus_status edit(mus_pattern *p, fuzz_input *in)
{
    const int32_t number = (int32_t)fuzz_take(in, 1) % 32, edges = mus_pattern_edge_count(p);
    const int32_t a = fuzz_below(in, edges), b = fuzz_below(in, edges), pair[2] = {b, a};
    const int32_t panel = fuzz_below(in, mus_pattern_panel_count(p)), seam = fuzz_below(in, mus_pattern_seam_count(p));
    const double s = fuzz_real(in, 0.0, 0.5), t = fuzz_real(in, -0.05, 0.3), at[2] = {fuzz_real(in, -0.5, 0.5), s};
    const double two[2] = {s, t}, rest[2] = {t, 0.02};
    double angle, width, depth;
    mus_seam_walk walk;
    switch (number) {
    case 0: return mus_pattern_undo(p);
    case 1: return mus_pattern_redo(p);
    case 2: return mus_pattern_add_dart(p, a, s, t, at, NULL);
    case 3: return mus_pattern_rotate_dart(p, a, b, s, a, t, NULL);
    case 4: return mus_pattern_shorten_dart(p, a, t);
    case 5: return mus_pattern_release_dart(p, a, NULL);
    case 6: return mus_pattern_join_panels(p, seam, NULL);
    case 7: return mus_pattern_mirror_panel(p, panel, "image", NULL);
    case 8: return mus_pattern_unfold(p, a);
    case 9: return mus_pattern_add_facing(p, a, t, "facing", NULL);
    case 10: return mus_pattern_remove_panel(p, panel);
    case 11: return mus_pattern_remove_seam(p, seam);
    case 12: return mus_pattern_spread(p, a, s, b, s, t, t);
    case 13: return mus_pattern_flare(p, a, b, (int32_t)(20.0 * fmin(fmax(s, -1e6), 1e6)), t);
    case 14: return mus_pattern_pleat(p, a, s, b, s, t, t);
    case 15: return mus_pattern_move_point(p, fuzz_below(in, mus_pattern_point_count(p)), at[0], at[1]);
    case 16: return mus_pattern_split_edge(p, a, s, NULL, NULL);
    case 17: return mus_pattern_merge_edges(p, a, NULL);
    case 18: return mus_pattern_true_seam(p, seam, a, b % 2);
    case 19: return mus_pattern_notch_seam(p, a, s, 1);
    case 25: return mus_pattern_split_dart(p, a, 2, pair, two, rest, b, NULL);
    case 26: return mus_pattern_merge_darts(p, a, b, b, NULL);
    case 27: return mus_pattern_lay_pleats(p, a, 2, two, rest);
    case 28: return mus_pattern_lengthen(p, panel, at, two, t);
    case 29: return mus_pattern_fair_edge(p, a, t);
    case 30: return mus_pattern_dart(p, a, &angle, &width, &depth);
    case 31: mus_seam_walk_init(&walk, sizeof walk); return mus_pattern_walk_seam(p, seam, &walk);
    default: return edit_line(p, in, number, a, number == 23 ? panel : b, s, t);
    }
}


/* the pattern's file */
static char *written(const mus_pattern *pattern, size_t *length)
{
    char *text;
    fuzz_must(mus_pattern_write_bytes(pattern, &text, length) == MUS_OK, "an edited pattern is written");
    return text;
}


void fuzz_edits(const uint8_t *bytes, size_t size)
{
    static const char *const designs[] = {"skirt", "tshirt", "jeans", "shirt"};
    mus_context *context = fuzz_context();
    mus_tape *tape;
    mus_pattern *pattern;
    fuzz_input in = {bytes, size};
    const char *design = designs[fuzz_take(&in, 1) % 4];
    fuzz_must(mus_tape_create(context, &tape) == MUS_OK && mus_tape_set_size(tape, "W40") == MUS_OK, "a tape is made");
    fuzz_must(mus_design_draft(context, mus_design_find(design), tape, NULL, &pattern) == MUS_OK,
              "a design is drafted");
    fuzz_must(mus_pattern_keep_history(pattern, CALLS) == MUS_OK, "a history is kept");
    size_t drafted_length, length;
    char *drafted = written(pattern, &drafted_length);
    for (int i = 0; i < CALLS && in.left > 0; i++) {
        const mus_status status = edit(pattern, &in);
        fuzz_must(status == MUS_OK || mus_context_error(context)[0] != '\0', "a refusal has a sentence");
    }
    int32_t faults;
    fuzz_must(mus_pattern_check(pattern, &faults, NULL) == MUS_OK, "an edited pattern can be checked");
    while (mus_pattern_undo_count(pattern) > 0)
        fuzz_must(mus_pattern_undo(pattern) == MUS_OK, "an edit that is counted is undone");
    char *undone = written(pattern, &length);
    fuzz_must(length == drafted_length && memcmp(undone, drafted, length) == 0,
              "all edits undone, the pattern is as it was drafted");
    mus_context_alloc(context, undone, 0);
    mus_context_alloc(context, drafted, 0);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    fuzz_context_end(context);
}


void fuzz_defs(const uint8_t *bytes, size_t size)
{
    const double cell[2] = {0.05, 0.05};
    mus_context *context = fuzz_context();
    fuzz_input in = {bytes, size};
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_fabric fabric;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&def, sizeof def);
    fuzz_spoil(&in, &fabric, sizeof fabric.size, sizeof fabric);
    fuzz_spoil(&in, &cut, sizeof cut.size, sizeof cut);
    cut.fabric = &fabric; /* a pointer is the caller's word */
    fuzz_spoil(&in, &def, sizeof def.size, sizeof def);
    if (def.threads > 2) def.threads = 2;
    if (mus_cloth_create_grid(context, 5, 4, cell, &cut, &cloth) == MUS_OK &&
        mus_drape_create(context, cloth, NULL, &def, &drape) == MUS_OK && mus_drape_place(drape) == MUS_OK) {
        const double dt = fuzz_real(&in, 0.0, 1.2) * mus_drape_step_bound(drape);
        if (mus_drape_step(drape, 3, dt) == MUS_OK)
            for (int32_t i = 0; i < 60; i++)
                fuzz_must(isfinite(mus_drape_positions(drape)[i]), "a node is somewhere after a good step");
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    fuzz_context_end(context);
}


/* objects of every kind, any of them NULL */
typedef struct objects {
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_sheet *sheet;
    int32_t sheets; /* made so far */
} objects;


static void call(mus_context *context, objects *o, fuzz_input *in)
{
    static const double cell[2] = {0.1, 0.1};
    mus_drape_report report;
    mus_cloth_def cut;
    mus_drape_report_init(&report, sizeof report);
    mus_sheet_def paper;
    mus_sheet_def_init(&paper, sizeof paper);
    paper.paper = MUS_PAPER_ROLL; /* tiles are searched for ten times as long; the target print has them */
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.1;
    cut.nodes_most = 1000;
    switch (fuzz_take(in, 1) % 22) {
    case 0:
        if (!o->tape) mus_tape_create(context, &o->tape);
        break;
    case 1: mus_tape_set_size(o->tape, fuzz_take(in, 1) % 2 ? "W40" : "none"); break;
    case 2: mus_tape_complete(o->tape); break;
    case 3:
        if (!o->body) mus_body_create(context, o->tape, NULL, &o->body);
        break;
    case 4:
        if (!o->pattern) mus_design_draft(context, fuzz_below(in, 20), o->tape, NULL, &o->pattern);
        break;
    case 5:
        if (!o->cloth) mus_cloth_create(context, o->pattern, &cut, &o->cloth);
        break;
    case 6:
        if (!o->cloth) mus_cloth_create_grid(context, fuzz_below(in, 9), 4, cell, &cut, &o->cloth);
        break;
    case 7:
        if (!o->drape) mus_drape_create(context, o->cloth, o->body, NULL, &o->drape);
        break;
    case 8: mus_drape_place(o->drape); break;
    case 9: mus_drape_step(o->drape, fuzz_below(in, 5), fuzz_real(in, 0.0, 1e-4)); break;
    case 10: mus_drape_pin(o->drape, fuzz_below(in, 12), 1); break;
    case 11: mus_drape_tack(o->drape, fuzz_below(in, 12), fuzz_below(in, 12), fuzz_real(in, 0.0, 100.0), NULL); break;
    case 12: mus_drape_untack(o->drape, fuzz_below(in, 3)); break;
    case 13: mus_drape_report_get(o->drape, &report); break;
    case 14: mus_drape_hash(o->drape); break;
    case 15:
        if (!o->sheet && o->sheets++ < SHEETS) mus_sheet_create(context, o->pattern, &paper, &o->sheet);
        break;
    case 16: mus_tape_destroy(o->tape), o->tape = NULL; break;
    case 17: mus_body_destroy(o->body), o->body = NULL; break;
    case 18: mus_pattern_destroy(o->pattern), o->pattern = NULL; break;
    case 19: mus_cloth_destroy(o->cloth), o->cloth = NULL; break;
    case 20: mus_drape_destroy(o->drape), o->drape = NULL; break;
    default: mus_sheet_destroy(o->sheet), o->sheet = NULL; break;
    }
}


/* up to CALLS calls of the bytes, and the end of all objects */
static void make_calls(mus_context *context, fuzz_input in)
{
    objects o = {0};
    for (int i = 0; i < CALLS && in.left > 0; i++) call(context, &o, &in);
    mus_sheet_destroy(o.sheet);
    mus_drape_destroy(o.drape);
    mus_cloth_destroy(o.cloth);
    mus_pattern_destroy(o.pattern);
    mus_body_destroy(o.body);
    mus_tape_destroy(o.tape);
}


void fuzz_calls(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    make_calls(context, (fuzz_input){bytes, size});
    fuzz_context_end(context);
}


void fuzz_memory(const uint8_t *bytes, size_t size)
{
    mus_context *context = fuzz_context();
    fuzz_input in = {bytes, size};
    const uint32_t head = fuzz_take(&in, 2);
    fuzz_fail_after(head >> 1, head & 1);
    make_calls(context, in);
    fuzz_fail_never();
    fuzz_must(mus_context_bytes(context) == 0, "a call that failed for want of memory left nothing behind");
    make_calls(context, in);
    fuzz_context_end(context);
}
