/*
 * room.c: one person, one garment, for the page and for Node: flat calls over the public headers.
 *
 * A host writes a text to room_text(), calls, and reads numbers where room_*() point. room_sew() dresses the body as
 * mus_dress() does; room_warm() puts the new cloth where the last one lies, which can be shown at once, and
 * room_settle() lets it come to rest. A call that fails returns its status; room_error() has the sentence.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "muslin/print.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

static mus_context *context;
static mus_tape *tape;
static mus_body *rest, *body; /* as made, and as it stands */
static mus_pattern *pattern;
static mus_cloth *cloth, *cloth_new;
static mus_drape *drape, *drape_new;
static mus_fit *fit;
static mus_reason reason;
static char *text, *bytes;
static size_t text_room, bytes_size;
static int32_t *found; /* designs of the last search, the best first */
static double *normals;

/* the host's: phase 0 sew, 1 settle; share done; nodes of the cut that moves and their positions. Nonzero: stop */
__attribute__((import_module("host"), import_name("progress"))) extern int32_t host_progress(
    int32_t phase, double share, int32_t nodes, const double *positions);


static int32_t on_progress(void *user, const mus_progress *told)
{
    (void)user;
    return host_progress(strcmp(told->phase, "sew") != 0, told->progress, told->nodes, told->positions);
}


int32_t EXPORT(room_open)(void)
{
    const mus_status status = mus_context_create(NULL, &context);
    mus_reason_init(&reason, sizeof reason);
    return status != MUS_OK ? status : mus_tape_create(context, &tape);
}


/* Room for a text of `size` bytes and a closing 0. */
char *EXPORT(room_text)(int32_t size)
{
    if ((size_t)size + 1 > text_room) {
        free(text);
        text_room = (size_t)size + 1;
        text = malloc(text_room);
    }
    if (text != NULL) text[size] = '\0';
    return text;
}


const char *EXPORT(room_error)(void) { return mus_context_error(context); }
const char *EXPORT(room_reason)(void) { return reason.text; }
int32_t EXPORT(room_reason_kind)(void) { return reason.kind; }


/* ---- names ---- */

const char *EXPORT(room_size_name)(int32_t i) { return mus_tape_size_name(i); }
const char *EXPORT(room_fabric_name)(int32_t i) { return mus_fabric_name(i); }
const char *EXPORT(room_pose_name)(int32_t i) { return mus_pose_name(i); }
int32_t EXPORT(room_design_count)(void) { return mus_design_count(); }
const char *EXPORT(room_design_name)(int32_t i) { return mus_design_name(i); }
const char *EXPORT(room_design_title)(int32_t i) { return mus_design_title(i); }
const char *EXPORT(room_design_family)(int32_t i) { return mus_design_family(i); }
int32_t EXPORT(room_design_groups)(int32_t i) { return mus_design_groups(i); }
const int32_t *EXPORT(room_design_found)(void) { return found; }
const char *EXPORT(room_measure_name)(int32_t i) { return mus_measure_name(i); }


/* ---- tape and body ---- */

/* The table size that the text names. */
int32_t EXPORT(room_size)(void) { return mus_tape_set_size(tape, text); }


/* The tape file that the text is. */
int32_t EXPORT(room_tape)(int32_t size)
{
    mus_tape *read = NULL;
    const mus_status status = mus_tape_read_from(context, text, (size_t)size, "tape.tape", NULL, &read);
    if (status != MUS_OK) return status;
    mus_tape_destroy(tape);
    tape = read;
    return MUS_OK;
}


int32_t EXPORT(room_measure_set)(int32_t i, double value) { return mus_tape_set(tape, i, value, MUS_SOURCE_GIVEN); }
double EXPORT(room_measure)(int32_t i) { return mus_tape_value(tape, i); }
double EXPORT(room_made)(int32_t i) { return rest != NULL ? mus_body_made(rest, i) : NAN; }


/* Makes the body of the tape in a named pose (-1: as made); `samples` and `spacing` of its skin, 0: as the library has
 * them; `plain`: without fingers and toes. */
int32_t EXPORT(room_body)(int32_t samples, double spacing, int32_t plain, int32_t named)
{
    mus_body *made = NULL, *posed = NULL;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    if (samples > 0) def.samples = samples;
    if (spacing > 0.0) def.ring_spacing = spacing;
    def.plain = plain;
    mus_status status = mus_tape_complete(tape);
    if (status == MUS_OK) status = mus_body_create(context, tape, &def, &made);
    if (status == MUS_OK && named >= 0) {
        mus_pose pose;
        mus_pose_init(&pose, sizeof pose);
        const char *name = mus_pose_name(named);
        status = mus_pose_named(context, name, &pose);
        if (status == MUS_OK) status = mus_body_clear_arms(made, &pose, 0.012);
        if (status == MUS_OK) status = mus_body_stand(made, mus_pose_feet(name), &pose);
        if (status == MUS_OK) status = mus_body_pose(made, &pose, &posed);
    }
    if (status != MUS_OK) {
        mus_body_destroy(made);
        return status;
    }
    if (body != rest) mus_body_destroy(body);
    mus_body_destroy(rest);
    rest = made;
    body = posed != NULL ? posed : made;
    return MUS_OK;
}


int32_t EXPORT(room_body_vertices)(void) { return mus_body_vertex_count(body); }
int32_t EXPORT(room_body_triangles)(void) { return mus_body_triangle_count(body); }
const double *EXPORT(room_body_positions)(void) { return mus_body_vertices(body); }
const double *EXPORT(room_body_normals)(void) { return mus_body_normals(body); }
const int32_t *EXPORT(room_body_triangle)(void) { return mus_body_triangles(body); }


/* Searches the designs by the text. Returns how many match, -1 on an error; room_design_found() has their numbers. */
int32_t EXPORT(room_design_search)(void)
{
    int32_t count = 0;
    if (found == NULL) found = malloc((size_t)mus_design_count() * sizeof *found);
    if (found == NULL) return -1;
    return mus_design_search(context, text, mus_design_count(), found, NULL, &count) == MUS_OK ? count : -1;
}


/* ---- pattern ---- */

/* Drafts the design that the text names, or spells in words. */
int32_t EXPORT(room_draft)(void)
{
    mus_pattern *made = NULL;
    const int32_t design = mus_design_find(text);
    mus_status status = mus_tape_complete(tape);
    if (status == MUS_OK)
        status = design != MUS_NONE ? mus_design_draft(context, design, tape, NULL, &made)
                                    : mus_design_draft_words(context, text, tape, NULL, &made);
    mus_pattern_destroy(pattern);
    pattern = status == MUS_OK ? made : NULL;
    return status;
}


/* Writes a file of the pattern or the tape: 0 PDF, 1 SVG, 2 JSON, 3 tape. paper: MUS_PAPER_*; the text is the title. */
int32_t EXPORT(room_write)(int32_t form, int32_t paper)
{
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    mus_status status = MUS_OK;
    mus_context_alloc(context, bytes, 0);
    bytes = NULL, bytes_size = 0;
    if (pattern == NULL && form < 3) return mus_context_fail(context, MUS_ERR_STATE, "no design is drafted");
    if (form < 2) {
        mus_sheet_def_init(&def, sizeof def);
        def.paper = paper;
        if (text != NULL && text[0] != '\0') def.title = text;
        status = mus_sheet_create(context, pattern, &def, &sheet);
        if (status == MUS_OK)
            status = form == 0 ? mus_sheet_write_pdf_bytes(sheet, &bytes, &bytes_size)
                               : mus_sheet_write_svg_bytes(sheet, &bytes, &bytes_size);
        mus_sheet_destroy(sheet);
        return status;
    }
    return form == 2 ? mus_pattern_write_bytes(pattern, &bytes, &bytes_size)
                     : mus_tape_write_bytes(tape, &bytes, &bytes_size);
}


/* Appends to the bytes; nothing when memory is short. */
static void append(const char *more, size_t length)
{
    char *longer = mus_context_alloc(context, bytes, bytes_size + length);
    if (longer == NULL) return;
    memcpy(longer + bytes_size, more, length);
    bytes = longer, bytes_size += length;
}


/* Appends a line of a sheet: number of its piece, then its steps as in SVG, x right, y down [cm]. */
static void append_line(const mus_sheet_line *line)
{
    char word[64];
    const double *p = line->points;
    append(word, (size_t)snprintf(word, sizeof word, "%d ", (int)line->piece));
    for (int32_t i = 0; i < line->op_count; i++) {
        const int32_t n = line->ops[i] == 'c' ? 3 : line->ops[i] == 'z' ? 0 : 1;
        word[0] = (char)(line->ops[i] - 'a' + 'A');
        append(word, 1);
        for (int32_t k = 0; k < n; k++, p += 2)
            append(word, (size_t)snprintf(word, sizeof word, " %.1f %.1f", 100.0 * p[0], -100.0 * p[1]));
    }
    append("\n", 1);
}


/* Writes the sew lines of the pattern's pieces, grain up, as text: a line for each edge, in the order of the outlines.
 */
int32_t EXPORT(room_sketch)(void)
{
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    mus_context_alloc(context, bytes, 0);
    bytes = NULL, bytes_size = 0;
    if (pattern == NULL) return mus_context_fail(context, MUS_ERR_STATE, "no design is drafted");
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_ROLL;
    const mus_status status = mus_sheet_create(context, pattern, &def, &sheet);
    for (int32_t i = 0; status == MUS_OK && i < mus_sheet_line_count(sheet); i++) {
        mus_sheet_line line;
        mus_sheet_line_init(&line, sizeof line);
        if (mus_sheet_line_get(sheet, i, &line) == MUS_OK && line.kind == MUS_LINE_SEW) append_line(&line);
    }
    mus_sheet_destroy(sheet);
    return status;
}


const char *EXPORT(room_bytes)(void) { return bytes; }
int32_t EXPORT(room_bytes_size)(void) { return (int32_t)bytes_size; }


/* ---- cloth ---- */

static void forget_fit(void)
{
    mus_fit_destroy(fit);
    fit = NULL;
}


static void take(mus_cloth *new_cloth, mus_drape *new_drape)
{
    forget_fit();
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    cloth = new_cloth, drape = new_drape;
}


/* fabric: of the list, -1: the default one */
static const mus_fabric *fabric_of(int32_t index, mus_fabric *fabric)
{
    mus_fabric_init(fabric, sizeof *fabric);
    if (index >= 0) mus_fabric_find(mus_fabric_name(index), fabric);
    return fabric;
}


/* Dresses the body anew. */
int32_t EXPORT(room_sew)(double spacing, int32_t index)
{
    mus_fabric fabric;
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = spacing;
    def.fabric = index >= 0 ? fabric_of(index, &fabric) : NULL;
    def.progress = on_progress;
    cloth_new = NULL, drape_new = NULL;
    const mus_status status = mus_dress(context, pattern, body, &def, NULL, &reason, &cloth_new, &drape_new);
    take(cloth_new, drape_new); /* none after a failure to cut: the garment before is not the one that was asked for */
    return status;
}


/* Cuts the pattern anew, and puts the cloth where the last one lies. */
int32_t EXPORT(room_warm)(double spacing, int32_t index)
{
    mus_fabric fabric;
    mus_cloth_def def;
    mus_drape_def how;
    if (drape == NULL) return MUS_ERR_STATE;
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_def_init(&how, sizeof how);
    how.progress_seconds = 0.002; /* [s] the host asks often whether it still wants this drape */
    def.spacing = spacing;
    def.coarser = 0; /* it settles from where it is */
    if (index >= 0) def.fabric = fabric_of(index, &fabric);
    cloth_new = NULL, drape_new = NULL;
    mus_status status = mus_cloth_create(context, pattern, &def, &cloth_new);
    if (status == MUS_OK) status = mus_drape_create(context, cloth_new, body, &how, &drape_new);
    if (status == MUS_OK) status = mus_drape_warm(drape_new, drape);
    if (status == MUS_OK) {
        take(cloth_new, drape_new);
    } else {
        mus_drape_destroy(drape_new);
        mus_cloth_destroy(cloth_new);
    }
    return status;
}


int32_t EXPORT(room_settle)(void)
{
    forget_fit();
    const mus_status status = mus_drape_settle(drape, on_progress, NULL);
    mus_drape_reason(drape, &reason);
    return status;
}


int32_t EXPORT(room_nodes)(void) { return drape != NULL ? mus_drape_node_count(drape) : 0; }
const double *EXPORT(room_positions)(void) { return mus_drape_positions(drape); }
int32_t EXPORT(room_triangles)(void) { return mus_cloth_triangle_count(cloth); }
const int32_t *EXPORT(room_triangle)(void) { return mus_cloth_triangles(cloth); }
const double *EXPORT(room_rest)(void) { return mus_cloth_rest(cloth); }
uint64_t EXPORT(room_hash)(void) { return drape != NULL ? mus_drape_hash(drape) : 0; }


const double *EXPORT(room_normals)(void)
{
    free(normals);
    normals = malloc(sizeof(double) * 3 * (size_t)mus_drape_node_count(drape));
    return normals != NULL && mus_drape_normals(drape, normals) == MUS_OK ? normals : NULL;
}


static const mus_fit *fit_now(void)
{
    if (fit == NULL && drape != NULL) mus_fit_create(drape, rest, &fit);
    return fit;
}


/* 1 strain along the warp, 2 along the weft, 3 pressure [Pa], 4 gap [m] at each node; NULL where there is no fit */
const double *EXPORT(room_map)(int32_t which)
{
    const mus_fit *f = fit_now();
    if (f == NULL) return NULL;
    if (which < 3) return which == 1 ? mus_fit_warp(f) : mus_fit_weft(f);
    return which == 3 ? mus_fit_pressure(f) : mus_fit_gap(f);
}


int32_t EXPORT(room_levels)(void) { return fit_now() != NULL ? mus_fit_level_count(fit) : 0; }


/* A level of the fit: its name; girth of the body and of the garment [m] go to out[0], out[1]; the side to out[2]. */
const char *EXPORT(room_level)(int32_t i, double *out)
{
    mus_fit_level level;
    mus_fit_level_init(&level, sizeof level);
    if (mus_fit_level_get(fit_now(), i, &level) != MUS_OK) return NULL;
    out[0] = level.body, out[1] = level.garment, out[2] = level.right;
    return mus_hold_name(level.level);
}
