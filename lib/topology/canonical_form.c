/*
 * canonical_form.c: the canonical form of a pattern's sewn complex: bytes that two patterns share exactly when they
 * are the same up to the names and order of panels, edges and seams and to where a word begins; and a hash of 128 bits
 * of them.
 *
 * What counts: panels as cyclic words seen from the right side, labels of panels and edges, which edges are one class
 * and which way they run in it. Lengths do not count. Any number of sheets may meet at an edge.
 *
 * Method: a walk from a position of a word (a flag) writes that panel's word. A class that is met for the first time
 * gets the next number, and the panels behind it are queued, each entered where it lies at the class. So the flag fixes
 * the word of its whole component, and the least word over all flags is canonical. Few flags are tried: positions are
 * coloured by hashes of their neighbours (next, previous, the other sheets), refined until no colour splits, and only
 * flags of the rarest colour are walked. Where three sheets or more meet, panels are taken in the order of their
 * colours. Among panels of equal colour each is tried first; one whose first word equals that of the previous one is
 * its image by symmetry and is skipped. Components are sorted. With `mirror` the words are walked both ways.
 *
 * Source: word of a flag: Brinkmann and McKay, Fast generation of planar graphs, 2007, section 3; passing over twins:
 * McKay, Practical graph isomorphism, 1981.
 */
#include <stdlib.h>
#include <string.h>

#include "topology/canonical_form.h"
#include "base/sort.h"

/* most words tried for one component before it is refused as too symmetric: some seconds of work */
#define FORM_TRIES 200000
/* first byte of the form; a change of the form changes it */
#define FORM_VERSION 1


void mus_form_def_init(mus_form_def *def, size_t size)
{
    mus_form_def own = {.mirror = 1, .labels = 1};
    mus__def_init(def, size, &own, sizeof own);
}


/* hash of two numbers; its last three lines are the finish of MurmurHash3 (Appleby 2011) */
static uint64_t form_mix(uint64_t a, uint64_t b)
{
    uint64_t h = a * UINT64_C(0x9e3779b97f4a7c15) + b;
    h = (h ^ (h >> 33)) * UINT64_C(0xff51afd7ed558ccd);
    h = (h ^ (h >> 33)) * UINT64_C(0xc4ceb9fe1a85ec53);
    return h ^ (h >> 33);
}


static int32_t form_beside(const mus__form *f, int32_t k, int32_t step)
{
    return mus__quotient_next(&f->q, k, step * f->way);
}


/* +1 when positions j and k run alike in their class */
static int32_t form_alike(const mus__form *f, int32_t j, int32_t k)
{
    return f->along[j] * f->along[k];
}


static int form_by_value(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return x < y ? -1 : x > y;
}


/* number of different colours; `sorted` (nword) is scratch */
static int32_t form_count(const mus__form *f)
{
    int32_t count = 0;
    memcpy(f->sorted, f->color, (size_t)f->q.nword * sizeof *f->sorted);
    mus__sort(f->sorted, (size_t)f->q.nword, sizeof *f->sorted, form_by_value);
    for (int32_t k = 0; k < f->q.nword; k++) count += k == 0 || f->sorted[k] != f->sorted[k - 1];
    return count;
}


/* refine f->color until the number of colours stays */
static void form_refine(const mus__form *f)
{
    const mus__quotient *q = &f->q;
    for (int32_t count = 0, more = form_count(f); more > count;) {
        count = more;
        for (int32_t k = 0; k < q->nword; k++) {
            int32_t class = q->root[q->edge[k]];
            uint64_t beside = form_mix(f->color[form_beside(f, k, 1)], f->color[form_beside(f, k, -1)]), sum = 0;
            for (int32_t i = f->member_first[class]; i < f->member_first[class + 1]; i++) {
                int32_t j = f->member[i];
                if (j != k) sum += form_mix(f->color[j], f->folded[class] ? 2 : (uint64_t)(form_alike(f, j, k) > 0));
            }
            f->next_color[k] = form_mix(form_mix(f->color[k], beside), sum);
        }
        memcpy(f->color, f->next_color, (size_t)q->nword * sizeof *f->color);
        more = form_count(f);
    }
}


/* colours of all positions into f->base */
static void form_colors(const mus__form *f)
{
    const mus__quotient *q = &f->q;
    for (int32_t k = 0; k < q->nword; k++) {
        int32_t class = q->root[q->edge[k]], panel = q->panel[k];
        uint64_t color = form_mix((uint64_t)f->edge_label[q->edge[k]], (uint64_t)f->panel_label[panel]);
        color = form_mix(color, (uint64_t)(q->first[panel + 1] - q->first[panel]));
        f->color[k] = form_mix(color, (uint64_t)q->sheets[class] * 2 + (uint64_t)f->folded[class]);
    }
    form_refine(f);
    memcpy(f->base, f->color, (size_t)q->nword * sizeof *f->base);
}


/* ---- the walk ---- */

/* number of members of a class with the least colour whose panels are not entered yet; *pick gets number `choice` of
 * them */
static int32_t form_candidates(const mus__form *f, int32_t class, int32_t choice, int32_t *pick)
{
    uint64_t least = 0;
    int32_t count = 0;
    for (int32_t i = f->member_first[class]; i < f->member_first[class + 1]; i++) {
        int32_t k = f->member[i];
        if (f->entry[f->q.panel[k]] != MUS_NONE || (count > 0 && f->color[k] > least)) continue;
        if (count == 0 || f->color[k] < least) count = 0, least = f->color[k];
        if (count == 0 || count == choice) *pick = k;
        count++;
    }
    return count;
}


/* give a position a colour of its own, and refine */
static void form_mark(mus__form *f, int32_t k)
{
    f->color[k] = form_mix(f->color[k], (uint64_t)(++f->nmark));
    form_refine(f);
}


/* queue the panels behind a class that is met for the first time */
static mus_status form_enter(mus__form *f, int32_t class)
{
    int32_t pick = MUS_NONE, count;
    while ((count = form_candidates(f, class, 0, &pick)) > 0) {
        if (count > 1 && f->nmark == 0) {
            /* mark the start of the walk, which the colours do not tell yet */
            form_mark(f, f->entry[f->order[0]]);
            continue;
        }
        if (count > 1) {
            /* several panels are alike: take the one that this try takes */
            mus_status status =
                mus__reserve(f->context, &f->choice, &f->choice_room, (int64_t)f->nchoice + 1, sizeof *f->choice);
            if (status != MUS_OK) return status;
            mus__form_choice *choice = &f->choice[f->nchoice];
            if (f->nchoice >= f->fixed) choice->taken = 0, choice->first_length = -1;
            choice->options = count;
            form_candidates(f, class, choice->taken, &pick);
            f->nchoice++;
            form_mark(f, pick);
        }
        f->entry[f->q.panel[pick]] = pick;
        f->order[f->norder++] = f->q.panel[pick];
    }
    return MUS_OK;
}


/* write the word of the component of position `start` into f->word, with the first `fixed` choices given: number of
 * panels, then of each panel its label, number of edges and edges */
static mus_status form_walk(mus__form *f, int32_t start)
{
    const mus__quotient *q = &f->q;
    int32_t nclass = 0, n = 1;
    for (int32_t i = 0; i < f->norder; i++) f->entry[f->order[i]] = MUS_NONE;
    for (int32_t i = 0; i < f->nmet; i++) f->class_number[f->met[i]] = MUS_NONE;
    f->norder = f->nmet = f->nchoice = f->nmark = 0;
    memcpy(f->color, f->base, (size_t)q->nword * sizeof *f->color);
    f->entry[q->panel[start]] = start;
    f->order[f->norder++] = q->panel[start];
    for (int32_t i = 0; i < f->norder; i++) {
        int32_t panel = f->order[i], k = f->entry[panel];
        f->word[n++] = f->panel_label[panel];
        f->word[n++] = q->first[panel + 1] - q->first[panel];
        do {
            /* label, class, and direction in it: 0 met first, 1 against the first, 2 along it, 3 folded, 4 a boundary
             * edge */
            int32_t class = q->root[q->edge[k]], number = f->class_number[class], way = 4;
            if (q->sheets[class] > 1) way = f->folded[class] ? 3 : 0;
            if (q->sheets[class] > 1 && number == MUS_NONE) {
                number = f->class_number[class] = nclass++;
                f->class_first[class] = k;
                f->met[f->nmet++] = class;
                mus_status status = form_enter(f, class);
                if (status != MUS_OK) return status;
            } else if (way == 0) {
                way = form_alike(f, f->class_first[class], k) > 0 ? 2 : 1;
            }
            f->word[n++] = f->edge_label[q->edge[k]];
            f->word[n++] = way;
            if (way != 4) f->word[n++] = number;
            k = form_beside(f, k, 1);
        } while (k != f->entry[panel]);
    }
    f->word[0] = f->norder;
    f->nword = n;
    return MUS_OK;
}


static int form_compare(const int32_t *a, int32_t na, const int32_t *b, int32_t nb)
{
    for (int32_t i = 0; i < na && i < nb; i++)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return na < nb ? -1 : na > nb;
}


/* after a walk whose first `fixed` choices were given: set the next choices to try; *more is false after the last */
static mus_status form_next_choice(mus__form *f, bool *more)
{
    /* keep the first word below each new choice */
    int32_t level = f->nchoice - 1, turned = f->fixed - 1;
    for (int32_t i = f->fixed; i < f->nchoice; i++) {
        mus__form_choice *choice = &f->choice[i];
        mus_status status =
            mus__reserve(f->context, &choice->word, &choice->room, (int64_t)f->nword + 1, sizeof *choice->word);
        if (status != MUS_OK) return status;
        memcpy(choice->word, f->word, (size_t)f->nword * sizeof *f->word);
        choice->first_length = f->nword;
    }

    /* the option that was taken last begins with the word of the previous one: an image by symmetry, with nothing new
     * below */
    if (turned >= 0 && turned < f->nchoice) {
        const mus__form_choice *choice = &f->choice[turned];
        if (form_compare(choice->word, choice->first_length, f->word, f->nword) == 0) level = turned;
    }
    while (level >= 0 && f->choice[level].taken + 1 >= f->choice[level].options) level--;
    *more = level >= 0;
    if (*more) f->choice[level].taken++;
    f->fixed = level + 1;
    return MUS_OK;
}


/* compare the least word of a component from position `start` with f->best, and keep the lesser */
static mus_status form_from(mus__form *f, int32_t start)
{
    f->fixed = 0;
    for (bool more = true; more;) {
        if (f->tries++ > FORM_TRIES)
            return mus__fail(f->context, MUS_ERR_LIMIT,
                             "form: more than %d ways to go round panel %s, too many alike sheets meet at an edge",
                             FORM_TRIES, f->pattern->panel[f->q.panel[start]].name);
        mus_status status = form_walk(f, start);
        if (status != MUS_OK) return status;
        if (f->nbest < 0 || form_compare(f->word, f->nword, f->best, f->nbest) < 0) {
            memcpy(f->best, f->word, (size_t)f->nword * sizeof *f->word);
            f->nbest = f->nword;
        }
        status = form_next_choice(f, &more);
        if (status != MUS_OK) return status;
    }
    return MUS_OK;
}


/* the rarest colour of the positions of a component, among equally rare colours the least. Overwrites f->sorted */
static uint64_t form_rarest(const mus__form *f, int32_t npanel, const int32_t *panels)
{
    int32_t n = 0, rarest = 0;
    uint64_t color = 0;
    for (int32_t i = 0; i < npanel; i++)
        for (int32_t k = f->q.first[panels[i]]; k < f->q.first[panels[i] + 1]; k++) f->sorted[n++] = f->base[k];
    mus__sort(f->sorted, (size_t)n, sizeof *f->sorted, form_by_value);
    for (int32_t k = 0, end; k < n; k = end) {
        for (end = k; end < n && f->sorted[end] == f->sorted[k];) end++;
        if (rarest == 0 || end - k < rarest) rarest = end - k, color = f->sorted[k];
    }
    return color;
}


/* write the least word of the component of a panel into f->best */
static mus_status form_piece(mus__form *f, int32_t panel, int32_t *done)
{
    /* its panels, by a walk; copied, since later walks use the same list */
    f->fixed = 0, f->nbest = -1, f->tries = 0;
    mus_status status = form_walk(f, f->q.first[panel]);
    int32_t npanel = f->norder;
    if (status != MUS_OK) return status;
    int32_t *panels = f->piece;
    memcpy(panels, f->order, (size_t)npanel * sizeof *panels);
    for (int32_t i = 0; i < npanel; i++) done[panels[i]] = 1;

    uint64_t color = form_rarest(f, npanel, panels);
    for (int32_t i = 0; i < npanel && status == MUS_OK; i++)
        for (int32_t k = f->q.first[panels[i]]; k < f->q.first[panels[i] + 1] && status == MUS_OK; k++)
            if (f->base[k] == color) status = form_from(f, k);
    return status;
}


/* ---- all components ---- */

static int form_by_word(const void *a, const void *b)
{
    const mus__form_word *x = a, *y = b;
    return form_compare(x->value, x->n, y->value, y->n);
}


/* write the words of all components, sorted, one after another into `out` (total); done (npanel) is scratch */
static mus_status form_pieces(mus__form *f, int32_t *done, int32_t *out, int32_t *total)
{
    mus_context *context = f->context;
    int32_t npanel = f->pattern->npanel, npiece = 0, used = 0;
    mus__form_word *piece = mus__new(context, npanel, sizeof *piece);
    int32_t *all = mus__new(context, f->most, sizeof *all);
    mus_status status = piece != NULL && all != NULL ? MUS_OK : mus__fail_memory(context, "the form of a pattern");
    for (int32_t i = 0; i < npanel; i++) done[i] = 0;
    if (status == MUS_OK) form_colors(f);
    for (int32_t i = 0; i < npanel && status == MUS_OK; i++) {
        if (done[i]) continue;
        status = form_piece(f, i, done);
        if (status != MUS_OK) break;
        memcpy(all + used, f->best, (size_t)f->nbest * sizeof *all);
        piece[npiece++] = (mus__form_word){all + used, f->nbest};
        used += f->nbest;
    }
    if (status == MUS_OK) {
        mus__sort(piece, (size_t)npiece, sizeof *piece, form_by_word);
        *total = 0;
        for (int32_t i = 0; i < npiece; i++) {
            memcpy(out + *total, piece[i].value, (size_t)piece[i].n * sizeof *out);
            *total += piece[i].n;
        }
    }
    mus__free(context, piece);
    mus__free(context, all);
    return status;
}


/* the lesser of the words walked along and, with `mirror`, against; out (f->most), work (f->most) is scratch */
static mus_status form_both(mus__form *f, bool mirror, int32_t *done, int32_t *out, int32_t *work, int32_t *n)
{
    int32_t other = 0;
    f->way = 1;
    mus_status status = form_pieces(f, done, out, n);
    if (status != MUS_OK || !mirror) return status;
    f->way = -1;
    status = form_pieces(f, done, work, &other);
    if (status == MUS_OK && form_compare(work, other, out, *n) < 0) {
        memcpy(out, work, (size_t)other * sizeof *out);
        *n = other;
    }
    return status;
}


/* ---- bytes and hash ---- */

/* output: bytes beyond `capacity` are counted and hashed only */
typedef struct form_sink {
    uint8_t *bytes;
    size_t capacity, count;
    uint64_t hash[2];
} form_sink;


/* FNV-1a (Fowler, Noll, Vo 1991) twice, the second time of complemented bytes */
static void form_put(form_sink *sink, uint8_t byte)
{
    if (sink->bytes != NULL && sink->count < sink->capacity) sink->bytes[sink->count] = byte;
    sink->count++;
    sink->hash[0] = (sink->hash[0] ^ byte) * UINT64_C(1099511628211);
    sink->hash[1] = (sink->hash[1] ^ (uint8_t)~byte) * UINT64_C(1099511628211);
}


/* a number: one byte when below 255, else 255 and four bytes */
static void form_put_number(form_sink *sink, int32_t value)
{
    if (value < 255) {
        form_put(sink, (uint8_t)value);
        return;
    }
    form_put(sink, 255);
    for (int32_t i = 24; i >= 0; i -= 8) form_put(sink, (uint8_t)((uint32_t)value >> i & 255));
}


mus_status mus_pattern_form(const mus_pattern *pattern, const mus_form_def *def, uint8_t *bytes, size_t capacity,
                            size_t *count, uint64_t *hash)
{
    if (count != NULL) *count = 0;
    if (hash != NULL) hash[0] = hash[1] = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_form_def own;
    mus_form_def_init(&own, sizeof own);
    mus_status status = MUS_OK;
    if (def != NULL) status = mus__def_read(pattern->context, &own, sizeof own, sizeof own, def, "mus_form_def");
    if (status != MUS_OK) return status;

    mus__form f;
    int32_t n = 0;
    status = mus__form_make(pattern, own.labels != 0, &f);
    int32_t *work = status == MUS_OK ? mus__new(pattern->context, 2 * f.most + pattern->npanel, sizeof *work) : NULL;
    if (status == MUS_OK && work == NULL) status = mus__fail_memory(pattern->context, "the form of a pattern");
    if (status == MUS_OK) status = form_both(&f, own.mirror != 0, work + 2 * f.most, work, work + f.most, &n);
    if (status == MUS_OK) {
        form_sink sink = {bytes, capacity, 0, {MUS_HASH_START, MUS_HASH_START}};
        form_put(&sink, FORM_VERSION);
        form_put(&sink, (uint8_t)((own.mirror != 0) + 2 * (own.labels != 0)));
        form_put_number(&sink, f.nlabel);
        for (int32_t i = 0; i < f.nlabel; i++)
            for (const char *at = f.label[i], *end = at + strlen(at) + 1; at < end; at++) form_put(&sink, (uint8_t)*at);
        for (int32_t i = 0; i < n; i++) form_put_number(&sink, work[i]);
        if (count != NULL) *count = sink.count;
        for (int32_t i = 0; i < 2 && hash != NULL; i++) hash[i] = form_mix(sink.hash[i], sink.hash[1 - i] >> 32);
    }
    mus__free(pattern->context, work);
    mus__form_free(&f);
    return status;
}
