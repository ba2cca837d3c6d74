/*
 * canonical_form_data.c: the quotient of a pattern made ready for the walks of canonical_form.c: labels numbered in
 * the order of their texts, positions listed by class, folded classes marked.
 */
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "topology/canonical_form.h"


static int form_by_text(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}


static int32_t form_label_number(const mus__form *f, const char *text)
{
    const char **at = bsearch(&text, f->label, (size_t)f->nlabel, sizeof *f->label, form_by_text);
    return (int32_t)(at - f->label);
}


/* number all labels of panels and of the edges that a word passes; "" is always there and is 0 */
static mus_status form_labels(mus__form *f, bool labels)
{
    const mus_pattern *pattern = f->pattern;
    f->label = mus__new(f->context, (int64_t)pattern->npanel + f->q.nword + 1, sizeof *f->label);
    if (f->label == NULL) return mus__fail_memory(f->context, "the form of a pattern");
    int32_t n = 0;
    f->label[n++] = "";
    for (int32_t i = 0; i < pattern->npanel && labels; i++) f->label[n++] = pattern->panel[i].attr.label;
    for (int32_t k = 0; k < f->q.nword && labels; k++) f->label[n++] = pattern->edge[f->q.edge[k]].attr.label;
    mus__sort(f->label, (size_t)n, sizeof *f->label, form_by_text);
    f->nlabel = 0;
    for (int32_t i = 0; i < n; i++)
        if (i == 0 || strcmp(f->label[i], f->label[f->nlabel - 1]) != 0) f->label[f->nlabel++] = f->label[i];
    for (int32_t i = 0; i < pattern->npanel && labels; i++)
        f->panel_label[i] = form_label_number(f, pattern->panel[i].attr.label);
    for (int32_t k = 0; k < f->q.nword && labels; k++)
        f->edge_label[f->q.edge[k]] = form_label_number(f, pattern->edge[f->q.edge[k]].attr.label);
    return MUS_OK;
}


/* positions by class in order, and which classes are folded */
static void form_classes(mus__form *f)
{
    const mus__quotient *q = &f->q;
    int32_t nedge = f->pattern->nedge;
    for (int32_t k = 0; k < q->nword; k++) {
        f->along[k] = q->turn[k] * q->sign[q->edge[k]];
        f->member_first[q->root[q->edge[k]] + 1]++;
    }
    for (int32_t i = 0; i < nedge; i++) f->member_first[i + 1] += f->member_first[i];
    for (int32_t k = 0; k < q->nword; k++) {
        int32_t class = q->root[q->edge[k]];
        f->member[f->member_first[class] + f->met[class]++] = k;
    }
    for (int32_t i = 0; i < f->pattern->nseam && q->folded; i++) {
        const mus_seam_def *seam = &f->pattern->seam[i];
        int32_t meant = seam->direction == MUS_SEAM_DIRECT ? 1 : -1;
        if (q->sign[seam->edge_a] * q->sign[seam->edge_b] != meant) f->folded[q->root[seam->edge_a]] = 1;
    }
}


mus_status mus__form_make(const mus_pattern *pattern, bool labels, mus__form *out)
{
    *out = (mus__form){.context = pattern->context, .pattern = pattern, .way = 1};
    mus_status status = mus__quotient_make(pattern, false, &out->q);
    if (status != MUS_OK) return status;

    /* one block of numbers, one of colours */
    int64_t npanel = pattern->npanel, nedge = pattern->nedge, nword = out->q.nword;
    out->most = 3 * npanel + 3 * nword;
    if (out->most > INT32_MAX) return mus__fail(pattern->context, MUS_ERR_LIMIT, "form: the words are beyond 2^31");
    out->block = mus__new(pattern->context, 4 * npanel + 6 * nedge + 1 + 2 * nword + 2 * out->most, sizeof *out->block);
    out->color = mus__new(pattern->context, 4 * nword, sizeof *out->color);
    if (out->block == NULL || out->color == NULL) return mus__fail_memory(pattern->context, "the form of a pattern");
    out->next_color = out->color + nword;
    out->sorted = out->next_color + nword;
    out->base = out->sorted + nword;
    int32_t *at = out->block;
    int32_t **const slot[] = {
        &out->panel_label, &out->order, &out->piece, &out->entry,  &out->edge_label, &out->folded, &out->class_number,
        &out->class_first, &out->met,   &out->along, &out->member, &out->word,       &out->best,   &out->member_first};
    const int64_t size[] = {npanel, npanel, npanel, npanel, nedge,     nedge,     nedge,
                            nedge,  nedge,  nword,  nword,  out->most, out->most, nedge + 1};
    for (size_t i = 0; i < sizeof slot / sizeof slot[0]; i++) {
        *slot[i] = at;
        at += size[i];
    }
    status = form_labels(out, labels);
    if (status != MUS_OK) return status;
    form_classes(out);
    for (int32_t i = 0; i < pattern->npanel; i++) out->entry[i] = MUS_NONE;
    for (int32_t i = 0; i < pattern->nedge; i++) out->class_number[i] = MUS_NONE;
    return MUS_OK;
}


void mus__form_free(mus__form *form)
{
    for (int32_t i = 0; i < form->choice_room; i++) mus__free(form->context, form->choice[i].word);
    mus__free(form->context, form->choice);
    mus__free(form->context, form->label);
    mus__free(form->context, form->color);
    mus__free(form->context, form->block);
    mus__free(form->context, form->q.block);
}
