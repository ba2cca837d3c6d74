/*
 * dxf_file.c: the text of a DXF file as blocks of entities.
 *
 * A DXF is pairs of lines: a group code, then a value. A pair with code 0 begins an entity, and the pairs behind it are
 * its fields. Points, lines, polylines (with VERTEX entities, or LWPOLYLINE) and texts are kept; tables, attributes and
 * all else are passed over. A curve that is no polyline is refused on a layer that has an outline.
 * Source: Autodesk, DXF Reference, R12, group codes.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "trade/dxf_file.h"

#define COORDINATE_MOST 1e7 /* [unit of the file] chosen: 10 km in mm; far above any piece */
#define NUMBER_MOST 64      /* [bytes] of a number; chosen: 17 digits are exact */
#define INCH 0.0254

typedef enum dxf_type { DXF_NONE, DXF_KEPT, DXF_BLOCK, DXF_VERTEX, DXF_SECTION, DXF_VARIABLE } dxf_type;

/* state of the reader */
typedef struct dxf_text {
    mus__dxf_file *file;
    const char *at;
    int64_t line;
    int64_t code;
    mus__dxf_slice value;
    dxf_type type;           /* of the entity that is being read */
    bool in_blocks;          /* inside BLOCK .. ENDBLK */
    bool in_polyline;        /* between POLYLINE and SEQEND */
    bool light;              /* the entity is an LWPOLYLINE: each code 10 is a point */
    const char *refused;     /* name of a curve that is not read */
    int32_t style, style_n;  /* entities outside blocks: kept apart, since blocks may follow */
    mus__dxf_entity now;
    double p[4];             /* codes 10, 20, 11, 21 */
} dxf_text;


void mus__dxf_unload(mus__dxf_file *file)
{
    mus_context *context = file->source->context;
    mus_context_alloc(context, file->entities, 0);
    mus_context_alloc(context, file->blocks, 0);
    mus_context_alloc(context, file->xy, 0);
}


/* ---- texts and numbers ---- */

static bool slice_is(mus__dxf_slice slice, const char *text)
{
    return slice.length == (int32_t)strlen(text) && memcmp(slice.at, text, (size_t)slice.length) == 0;
}


static int letter_up(char c)
{
    return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
}


bool mus__dxf_same(mus__dxf_slice a, mus__dxf_slice b)
{
    bool same = a.length == b.length;
    for (int32_t i = 0; i < a.length && same; i++) same = letter_up(a.at[i]) == letter_up(b.at[i]);
    return same;
}


static mus__dxf_slice slice_trim(mus__dxf_slice slice)
{
    while (slice.length > 0 && (slice.at[0] == ' ' || slice.at[0] == '\t')) slice.at++, slice.length--;
    for (const char *end = slice.at + slice.length - 1; slice.length > 0 && (*end == ' ' || *end == '\t'); end--)
        slice.length--;
    return slice;
}


mus__dxf_slice mus__dxf_value(const mus__dxf_file *file, const mus__dxf_block *block, const char *key)
{
    const int32_t n = (int32_t)strlen(key);
    for (int32_t i = 0; i < block->n; i++) {
        const mus__dxf_entity *entity = &file->entities[block->first + i];
        mus__dxf_slice text = entity->text;
        if (entity->kind != MUS__DXF_TEXT || text.length <= n) continue;
        if (!mus__dxf_same((mus__dxf_slice){text.at, n}, (mus__dxf_slice){key, n})) continue;
        mus__dxf_slice rest = slice_trim((mus__dxf_slice){text.at + n, text.length - n});
        if (rest.length == 0 || *rest.at != ':') continue;
        return slice_trim((mus__dxf_slice){rest.at + 1, rest.length - 1});
    }
    return (mus__dxf_slice){"", -1};
}


/* the character of "\U+XXXX" at `text`; 0 when it is none */
static uint32_t escape_read(const char *text, int32_t length)
{
    uint32_t code = 0;
    if (length < 7 || memcmp(text, "\\U+", 3) != 0) return 0;
    for (int32_t i = 3; i < 7; i++) {
        const int c = letter_up(text[i]);
        if (!((c >= '0' && c <= '9') || (c >= 'A' && c <= 'F'))) return 0;
        code = 16 * code + (uint32_t)(c <= '9' ? c - '0' : c - 'A' + 10);
    }
    return code >= 0xd800 && code < 0xe000 ? 0 : code;
}


void mus__dxf_copy(mus__dxf_slice slice, char *out, size_t capacity)
{
    size_t used = 0;
    char own[5] = "";
    for (int32_t i = 0; i < slice.length;) {
        uint32_t code = escape_read(slice.at + i, slice.length - i);
        size_t n = code == 0 ? mus__utf8_length(slice.at + i) : 0;
        const char *from = slice.at + i;
        int32_t taken = code != 0 ? 7 : 1;
        if (n > 0 && i + (int32_t)n <= slice.length) {
            taken = (int32_t)n;
        } else {
            if (code == 0) code = (unsigned char)slice.at[i];
            if (code < 0x20 || (code >= 0x7f && code < 0xa0)) code = '?';
            n = 0;
            if (code >= 0x800) own[n++] = (char)(0xe0 | code >> 12), own[n++] = (char)(0x80 | (code >> 6 & 0x3f));
            else if (code >= 0x80) own[n++] = (char)(0xc0 | code >> 6);
            own[n] = (char)(n > 0 ? 0x80 | (code & 0x3f) : code);
            n++;
            from = own;
        }
        if (used + n >= capacity) break;
        memcpy(out + used, from, n);
        used += n;
        i += taken;
    }
    out[used] = '\0';
}


bool mus__dxf_number(mus__dxf_slice slice, double *out)
{
    char text[NUMBER_MOST];
    slice = slice_trim(slice);
    if (slice.length < 1 || slice.length >= NUMBER_MOST) return false;
    memcpy(text, slice.at, (size_t)slice.length);
    text[slice.length] = '\0';
    char *comma = strchr(text, ',');
    if (comma != NULL) *comma = '.';
    if (mus__number_span(text) != strlen(text)) return false;
    *out = strtod(text, NULL);
    return isfinite(*out);
}


/* ---- pairs ---- */

static mus__dxf_slice text_line(dxf_text *t)
{
    const size_t n = strcspn(t->at, "\r\n");
    mus__dxf_slice slice = {t->at, n > INT32_MAX ? 0 : (int32_t)n};
    t->at += n;
    if (*t->at == '\r') t->at++;
    if (*t->at == '\n') t->at++;
    t->line++;
    return slice;
}


bool mus__dxf_begins(const char *text)
{
    text += strspn(text, " \t\r\n");
    size_t digits = strspn(text, "0123456789");
    const char *end = text + digits + strspn(text + digits, " \t");
    const bool code = (digits == 1 && *text == '0') || (digits == 3 && memcmp(text, "999", 3) == 0);
    return code && (*end == '\r' || *end == '\n');
}


/* read the next pair; MUS_ERR_FORMAT when its first line is no group code or the file ends */
static mus_status text_pair(dxf_text *t)
{
    const mus__source *source = t->file->source;
    double code;
    if (*t->at == '\0')
        return mus__source_fail(source, t->line, MUS_ERR_FORMAT,
                                "the file ends; expected \"0\" and \"EOF\" at its end");
    mus__dxf_slice line = text_line(t);
    if (!mus__dxf_number(line, &code) || code != floor(code) || fabs(code) > 9999.0) {
        char got[41];
        mus__dxf_copy(line, got, sizeof got);
        return mus__source_fail(source, t->line, MUS_ERR_FORMAT,
                                "expected a group code (a whole number), got \"%s\"", got);
    }
    if (*t->at == '\0')
        return mus__source_fail(source, t->line, MUS_ERR_FORMAT, "the file ends behind group code %d", (int)code);
    t->code = (int64_t)code;
    t->value = text_line(t);
    return MUS_OK;
}


/* ---- entities ---- */

static mus_status point_add(dxf_text *t, const double *p)
{
    mus__dxf_file *file = t->file;
    if (file->nxy >= MUS__DXF_VERTICES)
        return mus__source_fail(file->source, t->line, MUS_ERR_LIMIT, "more than %d points; expected a pattern",
                                (int)MUS__DXF_VERTICES);
    mus_status status = mus__source_reserve(file->source, &file->xy, &file->xy_room, (int64_t)file->nxy + 1,
                                           2 * sizeof *file->xy);
    if (status != MUS_OK) return status;
    memcpy(file->xy + 2 * (size_t)file->nxy++, p, 2 * sizeof *p);
    return MUS_OK;
}


static mus_status entity_add(dxf_text *t)
{
    mus__dxf_file *file = t->file;
    t->now.n = file->nxy - t->now.first;
    if (file->nentity >= MUS__DXF_ENTITIES)
        return mus__source_fail(file->source, t->now.line, MUS_ERR_LIMIT, "more than %d entities; expected a pattern",
                                (int)MUS__DXF_ENTITIES);
    mus_status status = mus__source_reserve(file->source, &file->entities, &file->entity_room,
                                           (int64_t)file->nentity + 1, sizeof *file->entities);
    if (status == MUS_OK) file->entities[file->nentity++] = t->now;
    return status;
}


/* the entity ends, since another begins: keep what was read of it */
static mus_status entity_end(dxf_text *t)
{
    const int32_t layer = t->now.layer;
    mus_status status = MUS_OK;
    if (t->refused != NULL && t->in_blocks && (layer == 1 || layer == 14))
        return mus__source_fail(t->file->source, t->now.line, MUS_ERR_UNSUPPORTED,
                                "%s on layer %d; expected POLYLINE or LINE", t->refused, (int)layer);
    if (t->type == DXF_VERTEX && t->in_polyline) return point_add(t, t->p);
    if (t->type == DXF_BLOCK) t->file->blocks[t->file->nblock - 1].name = t->now.text;
    if (t->type != DXF_KEPT || t->in_polyline) return MUS_OK;
    if (!t->light) status = point_add(t, t->p);
    if (status == MUS_OK && t->now.kind == MUS__DXF_LINE) status = point_add(t, t->p + 2);
    return status == MUS_OK ? entity_add(t) : status;
}


static mus_status block_begin(dxf_text *t)
{
    mus__dxf_file *file = t->file;
    t->type = DXF_BLOCK;
    t->in_blocks = true;
    mus_status status = mus__source_reserve(file->source, &file->blocks, &file->block_room, (int64_t)file->nblock + 1,
                                           sizeof *file->blocks);
    if (status == MUS_OK) file->blocks[file->nblock++] = (mus__dxf_block){{"", 0}, t->line, file->nentity, 0};
    return status;
}


/* a pair with code 0: what begins */
static mus_status entity_begin(dxf_text *t)
{
    static const char *const curves[] = {"ARC", "CIRCLE", "ELLIPSE", "SPLINE"};
    const mus__dxf_slice name = t->value;
    memset(t->p, 0, sizeof t->p);
    t->type = DXF_NONE;
    t->light = false;
    t->refused = NULL;
    if (slice_is(name, "VERTEX")) {
        t->type = DXF_VERTEX;
        return MUS_OK;
    }
    if (t->in_polyline) {
        t->in_polyline = false;
        if (!slice_is(name, "SEQEND"))
            return mus__source_fail(t->file->source, t->line, MUS_ERR_FORMAT,
                                    "the POLYLINE of line %lld has no end; expected VERTEX or SEQEND, got \"%.*s\"",
                                    (long long)t->now.line, name.length > 20 ? 20 : (int)name.length, name.at);
        return entity_add(t);
    }
    t->now = (mus__dxf_entity){.layer = -1, .first = t->file->nxy, .text = {"", 0}, .line = t->line};
    t->type = DXF_KEPT;
    if (slice_is(name, "POINT")) t->now.kind = MUS__DXF_POINT;
    else if (slice_is(name, "LINE")) t->now.kind = MUS__DXF_LINE;
    else if (slice_is(name, "TEXT") || slice_is(name, "MTEXT")) t->now.kind = MUS__DXF_TEXT;
    else if (slice_is(name, "POLYLINE") || slice_is(name, "LWPOLYLINE")) t->now.kind = MUS__DXF_POLYLINE;
    else t->type = DXF_NONE;
    t->light = slice_is(name, "LWPOLYLINE");
    t->in_polyline = slice_is(name, "POLYLINE");
    for (size_t i = 0; i < sizeof curves / sizeof curves[0]; i++)
        if (slice_is(name, curves[i])) t->refused = curves[i];
    if (slice_is(name, "BLOCK")) return block_begin(t);
    if (slice_is(name, "ENDBLK") && t->in_blocks) {
        mus__dxf_block *block = &t->file->blocks[t->file->nblock - 1];
        block->n = t->file->nentity - block->first;
        t->in_blocks = false;
    }
    return MUS_OK;
}


static mus_status coordinate(dxf_text *t, double *out)
{
    if (mus__dxf_number(t->value, out) && fabs(*out) <= COORDINATE_MOST) return MUS_OK;
    char got[41];
    mus__dxf_copy(t->value, got, sizeof got);
    return mus__source_fail(t->file->source, t->line, MUS_ERR_FORMAT,
                            "group code %d: expected a number within 1e7, got \"%s\"", (int)t->code, got);
}


/* a field of the entity */
static mus_status field(dxf_text *t)
{
    double x = 0.0;
    if (t->type == DXF_NONE && t->refused == NULL) return MUS_OK;
    if (t->code == 2 && t->type == DXF_BLOCK) t->now.text = slice_trim(t->value);
    if (t->code == 1 && t->type == DXF_KEPT) t->now.text = slice_trim(t->value);
    if (t->code == 8 && (t->type == DXF_KEPT || t->refused != NULL))
        t->now.layer = mus__dxf_number(t->value, &x) && x >= 0.0 && x < 1e6 ? (int32_t)x : -1;
    if (t->code == 70 && t->now.kind == MUS__DXF_POLYLINE && t->type == DXF_KEPT && mus__dxf_number(t->value, &x))
        t->now.closed = fmod(floor(fabs(x)), 2.0) == 1.0;
    if (t->code == 50 && t->now.kind == MUS__DXF_POINT && t->type == DXF_KEPT) {
        t->now.angled = true;
        return coordinate(t, &t->now.angle);
    }
    const bool outline = t->in_blocks && (t->now.layer == 1 || t->now.layer == 14);
    if (t->code == 42 && outline && (t->type == DXF_VERTEX || t->light) && mus__dxf_number(t->value, &x) && x != 0.0)
        return mus__source_fail(t->file->source, t->line, MUS_ERR_UNSUPPORTED,
                                "a bulge (group code 42) makes an arc; expected straight chords");
    const int32_t axis = t->code == 10 ? 0 : t->code == 20 ? 1 : t->code == 11 ? 2 : t->code == 21 ? 3 : -1;
    if (axis < 0 || t->type == DXF_BLOCK) return MUS_OK;
    mus_status status = coordinate(t, &t->p[axis]);
    if (status == MUS_OK && t->light && axis == 1) status = point_add(t, t->p);
    return status;
}


/* the unit of the file [m]: "Units: ENGLISH" or METRIC, else $INSUNITS (1 inch, 4 mm, 5 cm, 6 m), else mm */
static void units_read(mus__dxf_file *file, int32_t insunits)
{
    static const char english[] = "ENGLISH", metric[] = "METRIC";
    file->unit = insunits == 1 ? INCH : insunits == 5 ? 0.01 : insunits == 6 ? 1.0 : 1e-3;
    const mus__dxf_block *style = &file->blocks[file->nblock - 1];
    const mus__dxf_slice units = mus__dxf_value(file, style, "Units");
    if (mus__dxf_same(units, (mus__dxf_slice){english, (int32_t)sizeof english - 1})) file->unit = INCH;
    if (mus__dxf_same(units, (mus__dxf_slice){metric, (int32_t)sizeof metric - 1})) file->unit = 1e-3;
}


mus_status mus__dxf_load(const mus__source *source, mus__dxf_file *file)
{
    dxf_text t = {.file = file, .at = source->text, .now = {.layer = -1, .text = {"", 0}}};
    bool insunits = false;
    int32_t unit = 0;
    memset(file, 0, sizeof *file);
    file->source = source;
    if (memchr(source->text, '\0', source->size) != NULL)
        return mus__source_fail(source, 0, MUS_ERR_FORMAT, "a zero byte in the text; expected a DXF in ASCII");
    for (;;) {
        mus_status status = text_pair(&t);
        if (status != MUS_OK) return status;
        if (t.code == 0) {
            insunits = false;
            status = entity_end(&t);
            if (status == MUS_OK && slice_is(t.value, "EOF")) break;
            if (status == MUS_OK) status = entity_begin(&t);
        } else {
            double x;
            if (t.code == 9) insunits = slice_is(t.value, "$INSUNITS");
            if (t.code == 70 && insunits && mus__dxf_number(t.value, &x) && x >= 0.0 && x < 100.0) unit = (int32_t)x;
            status = field(&t);
        }
        if (status != MUS_OK) return status;
    }
    if (t.in_blocks)
        return mus__source_fail(source, t.line, MUS_ERR_FORMAT, "the block of line %lld has no ENDBLK",
                                (long long)file->blocks[file->nblock - 1].line);

    /* the entities behind the last block are those of the drawing and the texts of the style */
    int32_t first = file->nblock > 0 ? file->blocks[file->nblock - 1].first + file->blocks[file->nblock - 1].n : 0;
    mus_status status = mus__source_reserve(source, &file->blocks, &file->block_room, (int64_t)file->nblock + 1,
                                           sizeof *file->blocks);
    if (status != MUS_OK) return status;
    file->blocks[file->nblock++] = (mus__dxf_block){{"", 0}, 0, first, file->nentity - first};
    units_read(file, unit);
    return MUS_OK;
}
