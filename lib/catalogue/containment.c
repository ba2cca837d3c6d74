/*
 * containment.c: is one pattern, the part, contained in another, the whole?
 *
 * Both are read back from their canonical forms. There each panel is a cyclic word: one letter for each edge, the
 * number of the seam class that the edge belongs to, with the direction. A backtracking search matches the panels of
 * the part to panels of the whole one after another, at every rotation, in the direction of the words or, mirrored,
 * against it. Equal classes of the part have to be equal classes of the whole, with the same directions. The panels of
 * a component stand in the order of a walk over its seams, so each but the first shares a class with an earlier one.
 */
#include <string.h>

#include "catalogue/catalogue_internal.h"

#define PART_PANELS 100000 /* most panels of a form that is read back; chosen: far above any garment */

typedef struct part_side {
    const char *label;
    int32_t class; /* seam class; MUS_NONE for an open edge */
    int32_t along; /* direction in the class, +1 or -1; 0 where the class is folded on itself */
} part_side;

typedef struct part_form {
    mus_context *context;
    int32_t npanel, nside;
    const char **label;  /* (npanel) */
    int32_t *first;      /* (npanel + 1) */
    part_side *side;     /* (nside) */
    const char **labels; /* all labels of the form */
} part_form;

/* bytes of a form while it is read; bad once they are not a form */
typedef struct part_bytes {
    const uint8_t *at, *end;
    bool bad;
} part_bytes;


static int32_t part_number(part_bytes *bytes)
{
    if (bytes->at < bytes->end && *bytes->at < 255) return *bytes->at++;
    if (bytes->end - bytes->at < 5) {
        bytes->bad = true;
        return 0;
    }
    uint32_t value = 0;
    for (int32_t i = 1; i < 5; i++) value = value << 8 | bytes->at[i];
    bytes->at += 5;
    if (value > INT32_MAX) bytes->bad = true;
    return bytes->bad ? 0 : (int32_t)value;
}


static void part_free(part_form *form)
{
    mus_context_alloc(form->context, form->label, 0);
    mus_context_alloc(form->context, form->first, 0);
    mus_context_alloc(form->context, form->side, 0);
    mus_context_alloc(form->context, form->labels, 0);
}


/* read the head and the labels; *nlabel is the number of labels */
static mus_status part_labels(part_form *form, part_bytes *bytes, int32_t *nlabel)
{
    bytes->bad = bytes->end - bytes->at < 3 || bytes->at[0] != 1;
    if (bytes->bad) return MUS_OK;
    bytes->at += 2;
    *nlabel = part_number(bytes);
    if (bytes->bad || *nlabel > bytes->end - bytes->at) {
        bytes->bad = true;
        return MUS_OK;
    }
    form->labels = mus_context_alloc(form->context, NULL, ((size_t)*nlabel + 1) * sizeof *form->labels);
    if (form->labels == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < *nlabel && !bytes->bad; i++) {
        const uint8_t *stop = memchr(bytes->at, 0, (size_t)(bytes->end - bytes->at));
        form->labels[i] = (const char *)bytes->at;
        if (stop == NULL)
            bytes->bad = true;
        else
            bytes->at = stop + 1;
    }
    return MUS_OK;
}


/* read one component and append its panels; its classes are numbered from *base on */
static void part_piece(part_form *form, part_bytes *bytes, int32_t nlabel, int32_t *base, int32_t *most)
{
    int32_t npanel = part_number(bytes), next = *base;
    for (int32_t p = 0; p < npanel && !bytes->bad; p++) {
        int32_t label = part_number(bytes), n = part_number(bytes);
        bytes->bad = bytes->bad || label >= nlabel || n < 1 || form->npanel >= *most || n > *most - form->nside;
        if (bytes->bad) return;
        form->label[form->npanel] = form->labels[label];
        form->first[form->npanel++] = form->nside;
        for (int32_t i = 0; i < n && !bytes->bad; i++) {
            int32_t text = part_number(bytes), way = part_number(bytes);
            int32_t class = way < 4 ? *base + part_number(bytes) : MUS_NONE;
            bytes->bad = bytes->bad || text >= nlabel || way > 4 || class > next || class < MUS_NONE;
            if (bytes->bad) return;
            next += class == next;
            form->side[form->nside++] = (part_side){form->labels[text], class, way == 3 ? 0 : way == 1 ? -1 : 1};
        }
    }
    *base = next;
}


/* read a form; *good is false when the bytes are not a form */
static mus_status part_read(mus_context *context, const uint8_t *data, size_t size, part_form *out, bool *good)
{
    part_bytes bytes = {data, data + size, false};
    int32_t nlabel = 0, base = 0, most = size < PART_PANELS ? (int32_t)size : PART_PANELS;
    *out = (part_form){.context = context};
    mus_status status = part_labels(out, &bytes, &nlabel);
    if (status == MUS_OK && !bytes.bad) {
        /* an edge and a panel take at least two bytes each, which bounds both numbers */
        out->label = mus_context_alloc(context, NULL, ((size_t)most + 1) * sizeof *out->label);
        out->first = mus_context_alloc(context, NULL, ((size_t)most + 1) * sizeof *out->first);
        out->side = mus_context_alloc(context, NULL, ((size_t)most + 1) * sizeof *out->side);
        if (out->label == NULL || out->first == NULL || out->side == NULL) status = MUS_ERR_MEMORY;
    }
    while (status == MUS_OK && !bytes.bad && bytes.at < bytes.end) part_piece(out, &bytes, nlabel, &base, &most);
    if (status != MUS_OK) return mus_context_fail(context, status, "no memory for the canonical form of a pattern");
    *good = !bytes.bad;
    if (*good) out->first[out->npanel] = out->nside;
    return MUS_OK;
}


/* ---- the search ---- */

typedef struct part_search {
    const part_form *part, *whole;
    int32_t *image; /* (part edges) matching edge of the whole */
    int32_t *turn;  /* (part panels) matching panel of the whole and rotation, as one number */
    int32_t *used;  /* (whole panels) nonzero: matched already */
    int32_t way;
} part_search;


static bool part_label_fits(const char *part, const char *whole)
{
    return part[0] == '\0' || strcmp(part, whole) == 0;
}


/* match panel p of the part to panel q of the whole, first edge to edge r; false when they do not fit */
static bool part_lay(part_search *s, int32_t p, int32_t q, int32_t r)
{
    const part_form *a = s->part, *b = s->whole;
    int32_t first = a->first[p], n = a->first[p + 1] - first;
    if (!part_label_fits(a->label[p], b->label[q])) return false;
    for (int32_t i = 0; i < n; i++) {
        int32_t x = first + i, y = b->first[q] + (s->way > 0 ? r + i : r + n - i) % n;
        const part_side *from = &a->side[x], *to = &b->side[y];
        if (!part_label_fits(from->label, to->label)) return false;
        s->image[x] = y;
        if (from->class == MUS_NONE) continue;
        if (to->class == MUS_NONE || (from->along == 0 && to->along != 0)) return false;
        for (int32_t j = 0; j < x; j++) {
            if (a->side[j].class != from->class) continue;
            const part_side *other = &b->side[s->image[j]];
            if (other->class != to->class) return false;
            if (to->along != 0 && from->along != 0 && a->side[j].along * from->along != other->along * to->along)
                return false;
        }
    }
    return true;
}


/* backtracking over the panels of the part in their order; true when all are matched */
static bool part_search_all(part_search *s)
{
    const part_form *a = s->part, *b = s->whole;
    int32_t p = 0;
    for (int32_t i = 0; i < b->npanel; i++) s->used[i] = 0;
    for (int32_t i = 0; i < a->npanel; i++) s->turn[2 * i] = s->turn[2 * i + 1] = 0;
    while (p >= 0 && p < a->npanel) {
        int32_t *q = &s->turn[2 * p], *r = &s->turn[2 * p + 1], n = a->first[p + 1] - a->first[p];
        bool laid = false;
        for (; *q < b->npanel && !laid; ++*q, *r = 0) {
            if (s->used[*q] || b->first[*q + 1] - b->first[*q] != n) continue;
            for (; *r < n && !laid; ++*r) laid = part_lay(s, p, *q, *r);
            if (laid) break;
        }
        if (laid) {
            s->used[*q] = 1;
            p++;
            if (p < a->npanel) s->turn[2 * p] = s->turn[2 * p + 1] = 0;
        } else {
            p--;
            if (p >= 0) s->used[s->turn[2 * p]] = 0;
        }
    }
    return p == a->npanel;
}


mus_status mus__part_inside(mus_context *context, const uint8_t *part, size_t part_size, const uint8_t *whole,
                            size_t whole_size, bool *inside)
{
    part_form a, b = {.context = context};
    bool good[2] = {false, false};
    *inside = false;
    mus_status status = part_read(context, part, part_size, &a, &good[0]);
    if (status == MUS_OK) status = part_read(context, whole, whole_size, &b, &good[1]);
    if (status == MUS_OK && good[0] && good[1] && a.npanel <= b.npanel && a.nside <= b.nside) {
        size_t n = (size_t)a.nside + 2 * (size_t)a.npanel + (size_t)b.npanel + 1;
        int32_t *block = mus_context_alloc(context, NULL, n * sizeof *block);
        part_search s = {&a, &b, block, NULL, NULL, 1};
        if (block != NULL) {
            s.turn = block + a.nside;
            s.used = s.turn + 2 * (size_t)a.npanel;
            *inside = part_search_all(&s);
            s.way = -1;
            if (!*inside) *inside = part_search_all(&s);
        } else {
            status = mus_context_fail(context, MUS_ERR_MEMORY, "no memory for the search for a part of a pattern");
        }
        mus_context_alloc(context, block, 0);
    }
    part_free(&a);
    part_free(&b);
    return status;
}
