/*
 * pdf_layers.c: layers (optional content groups) in a PDF of cairo, which knows none: the lines of each size are added
 * as a content stream of their own to each page, by an incremental update.
 *
 *     bytes of cairo | streams | pages, resources, catalogue anew | groups | table of places | trailer with /Prev
 *
 * A page gets /Contents [ q, that of cairo, Q, ours ]; the streams name their groups by /Properties of the page's
 * resources. All groups are visible and printed by default, in the order of the sizes.
 *
 * Source: ISO 32000-1:2008, 7.5.6 (incremental updates), 8.11 (optional content).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "paperfile/pdf_layers.h"

#define POINTS (72.0 / 0.0254) /* [points/m] PostScript points in a metre */
#define ROOT_TAIL 64 /* [bytes] looked at behind a key; chosen: a reference has at most 25 */

/* the dashes of the cut lines of sizes, on and off in turn [m]; chosen: eight that the eye tells apart */
static const double size_dashes[8][4] = {
    {0.0, 0.0, 0.0, 0.0},       {0.010, 0.003, 0.0, 0.0},     {0.004, 0.003, 0.0, 0.0}, {0.010, 0.002, 0.002, 0.002},
    {0.0015, 0.0015, 0.0, 0.0}, {0.016, 0.002, 0.002, 0.002}, {0.006, 0.006, 0.0, 0.0}, {0.006, 0.002, 0.0015, 0.002},
};

/* the file of cairo, and the objects that the update writes */
typedef struct pdf_update {
    const mus_sheet *sheet;
    const char *data;
    size_t size;
    mus__sink *out;
    int32_t objects;   /* number of the next new object */
    int32_t count, room;
    int64_t (*places)[2]; /* (count) number and place of each object that is written */
    mus_status status;
} pdf_update;


const double *mus__size_dashes(int32_t size)
{
    return size_dashes[size % 8];
}


/* ---- what cairo wrote ---- */

/* the text `key` from `from` on; NULL when there is none before `end` */
static const char *pdf_find(const char *from, const char *end, const char *key)
{
    const size_t n = strlen(key);
    for (; from + n <= end; from++)
        if (memcmp(from, key, n) == 0) return from;
    return NULL;
}


/* the number behind the key, between from and end; -1 when there is none */
static int64_t pdf_number(const char *from, const char *end, const char *key)
{
    char text[ROOT_TAIL];
    const char *at = pdf_find(from, end, key);
    if (at == NULL) return -1;
    at += strlen(key);
    size_t n = (size_t)(end - at) < sizeof text - 1 ? (size_t)(end - at) : sizeof text - 1;
    memcpy(text, at, n);
    text[n] = '\0';
    char *stop;
    const long long number = strtoll(text, &stop, 10);
    return stop == text ? -1 : (int64_t)number;
}


/* the last place where the file names `key`; NULL when it does not */
static const char *pdf_last(const pdf_update *u, const char *key)
{
    const char *found = NULL;
    for (const char *at = u->data; (at = pdf_find(at, u->data + u->size, key)) != NULL; at++) found = at;
    return found;
}


/* the text of an object between "N 0 obj" and "endobj"; NULL when the file has none */
static const char *pdf_object(const pdf_update *u, int64_t number, const char **end)
{
    char head[32];
    snprintf(head, sizeof head, "\n%ld 0 obj\n", (long)number);
    const char *at = pdf_find(u->data, u->data + u->size, head);
    if (at == NULL) return NULL;
    at += strlen(head);
    *end = pdf_find(at, u->data + u->size, "endobj");
    return *end != NULL ? at : NULL;
}


/* ---- new objects ---- */

static void pdf_begin(pdf_update *u, int64_t number)
{
    if (u->status == MUS_OK)
        u->status = mus__print_reserve(u->sheet->context, &u->places, &u->room, u->count + 1, sizeof *u->places);
    if (u->status != MUS_OK) return;
    u->places[u->count][0] = number;
    u->places[u->count++][1] = (int64_t)(u->size + u->out->size);
    mus__sink_print(u->out, "%ld 0 obj\n", (long)number);
}


static void pdf_stream(pdf_update *u, int32_t number, const char *data, size_t size)
{
    pdf_begin(u, number);
    mus__sink_print(u->out, "<< /Length %zu >>\nstream\n", size);
    mus__sink_add(u->out, data, size);
    mus__sink_print(u->out, "\nendstream\nendobj\n");
}


/* a text as a PDF string in UTF-16 */
static void pdf_string(mus__sink *out, const char *text)
{
    mus__sink_print(out, "<FEFF");
    while (*text != '\0') {
        const uint32_t code = mus__text_character(&text);
        if (code < 0x10000) mus__sink_print(out, "%04X", (unsigned)code);
        else mus__sink_print(out, "%04X%04X", (unsigned)(0xd7c0 + (code >> 10)), (unsigned)(0xdc00 + (code & 0x3ff)));
    }
    mus__sink_print(out, ">");
}


static void pdf_points(mus__sink *out, double x)
{
    /* mus__print_number writes its argument times 1000 with four decimals */
    mus__print_number(out, 1e-3 * x);
    mus__sink_add(out, " ", 1);
}


static void pdf_layer_path(mus__sink *out, const mus_sheet *sheet, const mus__path *path, double left, double bottom)
{
    const mus__drawing *drawing = &sheet->drawing;
    const mus__pen_style *style = &mus__pen_styles[path->pen];
    const double *xy = drawing->xy + path->at, *dash = style->dash;
    int32_t dashes = dash[0] > 0.0 ? 2 : 0;
    if (path->layer == MUS__LAYER_CUT) {
        dash = mus__size_dashes(path->piece % sheet->nsize);
        dashes = dash[0] == 0.0 ? 0 : dash[2] == 0.0 ? 2 : 4;
    }
    pdf_points(out, style->grey);
    mus__sink_print(out, style->width > 0.0 ? "G " : "g ");
    if (style->width > 0.0) {
        pdf_points(out, style->width * POINTS);
        mus__sink_print(out, "w [ ");
        for (int32_t i = 0; i < dashes; i++) pdf_points(out, dash[i] * POINTS);
        mus__sink_print(out, "] 0 d\n");
    }
    for (int32_t i = 0; i < path->nop; i++) {
        const unsigned char op = drawing->ops[path->op + i];
        const int32_t n = op == 'c' ? 3 : op == 'z' ? 0 : 1;
        for (int32_t k = 0; k < n; k++, xy += 2) {
            pdf_points(out, (xy[0] - left) * POINTS);
            pdf_points(out, (xy[1] - bottom) * POINTS);
        }
        mus__sink_print(out, op == 'z' ? "h\n" : op == 'c' ? "c\n" : op == 'm' ? "m\n" : "l\n");
    }
    mus__sink_print(out, style->width > 0.0 ? "S\n" : "f\n");
}


bool mus__path_layered(const mus_sheet *sheet, const mus__path *path)
{
    return sheet->nsize > 1 && path->piece != MUS_NONE && path->layer != MUS__LAYER_GRAIN &&
           path->layer != MUS__LAYER_LABEL;
}


/* the lines of all sizes on a tile, each size in its layer, clipped to the window */
static mus_status pdf_tile_stream(const mus_sheet *sheet, int32_t tile, mus__sink *out)
{
    double box[4];
    const double margin = sheet->def.margin;
    mus__tile_window(sheet, &sheet->tiles[tile], box);
    mus__sink_print(out, "q 1 j ");
    pdf_points(out, margin * POINTS);
    pdf_points(out, margin * POINTS);
    pdf_points(out, (box[2] - box[0]) * POINTS);
    pdf_points(out, (box[3] - box[1]) * POINTS);
    mus__sink_print(out, "re W n\n");
    for (int32_t k = 0; k < sheet->nsize; k++) {
        mus__sink_print(out, "/OC /S%d BDC\n", (int)k);
        for (int32_t i = 0; i < sheet->drawing.npath; i++) {
            const mus__path *path = &sheet->drawing.paths[i];
            if (path->nop == 0 || !mus__path_layered(sheet, path) || path->piece % sheet->nsize != k) continue;
            const double w = 0.5 * mus__pen_styles[path->pen].width;
            if (path->box[0] - w > box[2] || path->box[2] + w < box[0] || path->box[1] - w > box[3] ||
                path->box[3] + w < box[1])
                continue;
            pdf_layer_path(out, sheet, path, box[0] - margin, box[1] - margin);
        }
        mus__sink_print(out, "EMC\n");
    }
    mus__sink_print(out, "Q");
    return out->status;
}


/* ---- objects of cairo, written anew ---- */

static void pdf_properties(pdf_update *u, int32_t groups)
{
    mus__sink_print(u->out, " /Properties <<");
    for (int32_t k = 0; k < u->sheet->nsize; k++) mus__sink_print(u->out, " /S%d %d 0 R", (int)k, (int)(groups + k));
    mus__sink_print(u->out, " >>");
}


/* write the resources of a page anew, with the groups */
static void pdf_insert(pdf_update *u, int64_t number, int32_t groups)
{
    const char *end = NULL, *at = pdf_object(u, number, &end);
    const char *open = at != NULL ? pdf_find(at, end, "<<") : NULL;
    if (open == NULL) {
        u->status = mus__file_fail(u->sheet->context, MUS_ERR_FILE, "cairo: a page without resources");
        return;
    }
    pdf_begin(u, number);
    mus__sink_add(u->out, at, (size_t)(open + 2 - at));
    pdf_properties(u, groups);
    mus__sink_add(u->out, open + 2, (size_t)(end - open - 2));
    mus__sink_print(u->out, "endobj\n");
}


/* write a page anew: its contents between q and Q, then those of the sizes; and its resources with the groups */
static void pdf_page(pdf_update *u, int64_t number, int32_t before, int32_t groups, int32_t own)
{
    const char *end = NULL, *at = pdf_object(u, number, &end);
    const char *contents = at != NULL ? pdf_find(at, end, "/Contents ") : NULL;
    const int64_t stream = contents != NULL ? pdf_number(contents, end, "/Contents ") : -1;
    const int64_t resources = at != NULL ? pdf_number(at, end, "/Resources ") : -1;
    const char *rest = contents != NULL ? pdf_find(contents, end, " R") : NULL;
    if (stream < 0 || resources < 0 || rest == NULL) {
        u->status = mus__file_fail(u->sheet->context, MUS_ERR_FILE, "cairo: a page without contents");
        return;
    }
    pdf_begin(u, number);
    mus__sink_add(u->out, at, (size_t)(contents - at));
    mus__sink_print(u->out, "/Contents [ %d 0 R %ld 0 R %d 0 R %d 0 R ]", (int)before, (long)stream, (int)before + 1,
                    (int)own);
    mus__sink_add(u->out, rest + 2, (size_t)(end - rest - 2));
    mus__sink_print(u->out, "endobj\n");
    pdf_insert(u, resources, groups);
}


/* write the catalogue anew with the groups, all of them on; the version is that of optional content */
static void pdf_catalogue(pdf_update *u, int64_t root, int32_t groups)
{
    const char *end = NULL, *at = pdf_object(u, root, &end), *open = at != NULL ? pdf_find(at, end, "<<") : NULL;
    if (open == NULL) {
        u->status = mus__file_fail(u->sheet->context, MUS_ERR_FILE, "cairo: a file without a catalogue");
        return;
    }
    pdf_begin(u, root);
    mus__sink_print(u->out, "<< /Version /1.5 /PageMode /UseOC\n/OCProperties <<");
    static const char *const keys[] = {" /OCGs [", " ] /D << /BaseState /ON /ON [", " ] /Order ["};
    for (int32_t i = 0; i < 3; i++) {
        mus__sink_print(u->out, "%s", keys[i]);
        for (int32_t k = 0; k < u->sheet->nsize; k++) mus__sink_print(u->out, " %d 0 R", (int)(groups + k));
    }
    mus__sink_print(u->out, " ] >> >>");
    mus__sink_add(u->out, open + 2, (size_t)(end - open - 2));
    mus__sink_print(u->out, "endobj\n");
}


/* the table of places of the objects that are written anew, and the trailer */
static void pdf_table(pdf_update *u, int64_t root, int64_t info, int64_t previous)
{
    const size_t table = u->size + u->out->size;
    mus__sink_print(u->out, "xref\n");
    for (int32_t i = 0; i < u->count; i++)
        mus__sink_print(u->out, "%ld 1\n%010ld 00000 n \n", (long)u->places[i][0], (long)u->places[i][1]);
    mus__sink_print(u->out, "trailer\n<< /Size %d /Root %ld 0 R /Info %ld 0 R /Prev %ld >>\nstartxref\n%zu\n%%%%EOF\n",
                    (int)u->objects, (long)root, (long)info, (long)previous, table);
}


/* the streams of all tiles, the groups, and what of cairo names them */
static void pdf_layers(pdf_update *u, int64_t root)
{
    const mus_sheet *sheet = u->sheet;
    const int32_t groups = u->objects, before = groups + sheet->nsize;
    u->objects = before + 2;
    for (int32_t k = 0; k < sheet->nsize; k++) {
        pdf_begin(u, groups + k);
        mus__sink_print(u->out, "<< /Type /OCG /Name ");
        pdf_string(u->out, sheet->sizes[k]);
        mus__sink_print(u->out, " /Intent /View /Usage << /View << /ViewState /ON >> /Print << /PrintState /ON >> >> "
                                ">>\nendobj\n");
    }
    pdf_stream(u, before, "q", 1);
    pdf_stream(u, before + 1, "Q", 1);
    const char *end = u->data + u->size, *kids = pdf_find(u->data, end, "/Kids [");
    if (kids == NULL) u->status = mus__file_fail(sheet->context, MUS_ERR_FILE, "cairo: a file without pages");
    else kids += strlen("/Kids [");
    for (int32_t page = 0; page < mus_sheet_page_count(sheet) && u->status == MUS_OK; page++) {
        const int64_t number = pdf_number(kids, end, " ");
        kids = pdf_find(kids, end, "R");
        if (kids == NULL) break;
        kids++;
        if (page < (sheet->cover ? 1 : 0)) continue;
        mus__sink stream;
        mus__sink_init(&stream, sheet->context);
        u->status = pdf_tile_stream(sheet, page - (sheet->cover ? 1 : 0), &stream);
        if (u->status == MUS_OK) pdf_stream(u, u->objects, stream.bytes, stream.size);
        if (u->status == MUS_OK) pdf_page(u, number, before, groups, u->objects);
        u->objects++;
        mus__sink_free(&stream);
    }
    if (u->status == MUS_OK) pdf_catalogue(u, root, groups);
}


mus_status mus__pdf_layers_add(const mus_sheet *sheet, mus__sink *bytes)
{
    mus__sink out;
    mus__sink_init(&out, sheet->context);
    pdf_update u = {sheet, bytes->bytes, bytes->size, &out, 0, 0, 0, NULL, MUS_OK};
    const char *end = u.data + u.size, *trailer = pdf_last(&u, "trailer");
    const int64_t root = trailer != NULL ? pdf_number(trailer, end, "/Root ") : -1;
    const int64_t info = trailer != NULL ? pdf_number(trailer, end, "/Info ") : -1;
    const int64_t count = trailer != NULL ? pdf_number(trailer, end, "/Size ") : -1;
    const int64_t previous = trailer != NULL ? pdf_number(trailer, end, "startxref\n") : -1;
    if (root < 0 || info < 0 || previous < 0 || count < 1 || count > INT32_MAX / 2)
        u.status = mus__file_fail(sheet->context, MUS_ERR_FILE, "cairo: a file without a trailer");
    u.objects = (int32_t)count;
    if (u.status == MUS_OK) pdf_layers(&u, root);
    if (u.status == MUS_OK) pdf_table(&u, root, info, previous);
    if (u.status == MUS_OK) u.status = out.status;
    if (u.status == MUS_OK) {
        mus__sink_add(bytes, out.bytes, out.size);
        u.status = bytes->status;
    }
    mus__print_free(sheet->context, u.places);
    mus__sink_free(&out);
    return u.status;
}
