/*
 * val_names.c: values and points by name, in a hash table (open addressing, FNV-1a), and measurement files as values.
 *
 * A .vit or .smis has <m name value/>, the value a number or a formula over the names before it. A .vst has a base and
 * two increases for each measure: value = base + (size - base size) / step * size_increase + the same of the height,
 * with a step of 2 cm for sizes and 6 cm for heights (GOST tables, as Valentina 0.7 has them).
 */
#include <string.h>

#include "valentina/val_file.h"

#define NAMES_MOST 1000000 /* most names; chosen: the largest pattern known has 40000 */


void mus__val_names_free(mus__val_names *names)
{
    if (names->context == NULL) return;
    mus_context_alloc(names->context, names->names, 0);
    mus_context_alloc(names->context, names->slots, 0);
    mus_context_alloc(names->context, names->bytes, 0);
    *names = (mus__val_names){0};
}


/* the slot of a name, or the free one where it would be */
static int32_t names_slot(const mus__val_names *names, const char *name, size_t length)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < length; i++) hash = (hash ^ (unsigned char)name[i]) * UINT64_C(0x100000001b3);
    int32_t slot = (int32_t)((hash ^ hash >> 32) & (uint64_t)(names->nslot - 1));
    for (;; slot = (slot + 1) & (names->nslot - 1)) {
        const int32_t at = names->slots[slot];
        if (at == MUS_NONE) return slot;
        const char *own = names->bytes + names->names[at].text;
        if (strncmp(own, name, length) == 0 && own[length] == '\0') return slot;
    }
}


const mus__val_name *mus__val_find(const mus__val_names *names, const char *name, size_t length)
{
    if (names->nslot == 0) return NULL;
    const int32_t at = names->slots[names_slot(names, name, length)];
    return at == MUS_NONE ? NULL : &names->names[at];
}


/* make the table large enough for one more name: at most half full */
static mus_status names_grow(const mus__source *source, mus__val_names *names)
{
    if (2 * (names->n + 1) <= names->nslot) return MUS_OK;
    if (names->n >= NAMES_MOST) return mus__source_fail(source, 0, MUS_ERR_LIMIT, "more than %d names", NAMES_MOST);
    const int32_t nslot = names->nslot > 0 ? 2 * names->nslot : 1024;
    int32_t *slots = mus_context_alloc(names->context, NULL, (size_t)nslot * sizeof *slots);
    if (slots == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for %d names", (int)nslot);
    mus_context_alloc(names->context, names->slots, 0);
    names->slots = slots;
    names->nslot = nslot;
    for (int32_t i = 0; i < nslot; i++) slots[i] = MUS_NONE;
    for (int32_t i = 0; i < names->n; i++) {
        const char *own = names->bytes + names->names[i].text;
        slots[names_slot(names, own, strlen(own))] = i;
    }
    return MUS_OK;
}


mus_status mus__val_set(const mus__source *source, mus__val_names *names, const char *name, double value,
                        int32_t point)
{
    const size_t length = strlen(name);
    names->context = source->context;
    mus_status status = names_grow(source, names);
    if (status != MUS_OK) return status;
    const int32_t slot = names_slot(names, name, length);
    if (names->slots[slot] == MUS_NONE) {
        status = mus__source_reserve(source, &names->names, &names->room, (int64_t)names->n + 1, sizeof *names->names);
        if (status == MUS_OK)
            status = mus__source_reserve(source, &names->bytes, &names->byte_room,
                                        (int64_t)names->nbyte + (int64_t)length + 1, 1);
        if (status != MUS_OK) return status;
        memcpy(names->bytes + names->nbyte, name, length + 1);
        names->names[names->n].text = names->nbyte;
        names->nbyte += (int32_t)length + 1;
        names->slots[slot] = names->n++;
    }
    names->names[names->slots[slot]].value = value;
    names->names[names->slots[slot]].point = point;
    return MUS_OK;
}


double mus__val_unit(const char *unit)
{
    return unit == NULL ? 0.0 : strcmp(unit, "mm") == 0 ? 1.0 : strcmp(unit, "cm") == 0 ? 10.0
           : strcmp(unit, "inch") == 0 ? 25.4 : 0.0;
}


/* ---- measurement files ---- */

static bool measure_lookup(const void *user, const char *name, size_t length, double *out)
{
    const mus__val_name *found = mus__val_find(user, name, length);
    if (found == NULL || found->point != MUS_NONE) return false;
    *out = found->value;
    return true;
}


/* a number in an attribute; 0 without it */
static double measure_number(const mus__val_xml *xml, int32_t element, const char *name)
{
    double value = 0.0;
    const char *text = mus__val_attribute(xml, element, name);
    if (text == NULL || mus__number_read(text, &value) != NULL) return 0.0;
    return value;
}


/* size and height of a .vst, in its unit: those asked as "500_1760", else its base */
static mus_status measure_size(const mus__val_xml *xml, const char *size, double *wanted, double *base)
{
    static const char *const tags[] = {"size", "height"};
    for (int32_t k = 0; k < 2; k++) {
        const int32_t at = mus__val_child(xml, 0, tags[k], MUS_NONE);
        base[k] = at != MUS_NONE ? measure_number(xml, at, "base") : 0.0;
        wanted[k] = base[k];
    }
    if (size == NULL) return MUS_OK;
    const size_t n = strcspn(size, "_");
    char first[32] = "";
    if (n < sizeof first) memcpy(first, size, n);
    if (size[n] != '_' || mus__number_read(first, &wanted[0]) != NULL ||
        mus__number_read(size + n + 1, &wanted[1]) != NULL)
        return mus__source_fail(xml->source, 0, MUS_ERR_ARG, "size \"%.40s\", expected SIZE_HEIGHT, as %g_%g", size,
                                base[0], base[1]);
    return MUS_OK;
}


static mus_status measure_add(const mus__val_xml *xml, int32_t m, mus__val_names *names, double scale,
                              const double *steps)
{
    const char *name = mus__val_attribute(xml, m, "name"), *text = mus__val_attribute(xml, m, "value"), *at;
    const int64_t line = xml->elements[m].line;
    double value = 0.0;
    if (name == NULL) return mus__source_fail(xml->source, line, MUS_ERR_FORMAT, "<m> without a name");
    if (steps != NULL) {
        value = measure_number(xml, m, "base") + steps[0] * measure_number(xml, m, "size_increase") +
                steps[1] * measure_number(xml, m, "height_increase");
    } else if (text != NULL && text[strspn(text, " \t\r\n")] != '\0') {
        /* the names before it are in the pattern's unit: a formula gives that unit too */
        const bool plain = mus__number_read(text, &value) == NULL;
        const char *wrong = plain ? NULL : mus__val_evaluate(text, measure_lookup, names, &value, &at);
        if (wrong != NULL)
            return mus__source_fail(xml->source, line, MUS_ERR_FORMAT, "%.60s: \"%.60s\" %s", name, at, wrong);
        if (!plain) scale = 1.0;
    }
    const char *dimension = mus__val_attribute(xml, m, "dimension");
    const bool angle = strstr(name, "angle") != NULL || (dimension != NULL && strcmp(dimension, "angle") == 0);
    return mus__val_set(xml->source, names, name, angle ? value : scale * value, MUS_NONE);
}


mus_status mus__val_measures(const mus__source *source, mus__val_names *names, double unit, const char *size)
{
    mus__val_xml xml;
    double wanted[2] = {0.0, 0.0}, base[2] = {0.0, 0.0};
    mus_status status = mus__val_xml_load(source, &xml);
    const bool table = status == MUS_OK && strcmp(xml.elements[0].tag, "vst") == 0;
    const char *tag = status == MUS_OK ? xml.elements[0].tag : "";
    if (status == MUS_OK && !table && strcmp(tag, "vit") != 0 && strcmp(tag, "smis") != 0)
        status = mus__source_fail(source, xml.elements[0].line, MUS_ERR_FORMAT,
                                  "expected <vit>, <smis> or <vst>, got <%.40s>", tag);
    double own = 0.0;
    if (status == MUS_OK) {
        const int32_t at = mus__val_child(&xml, 0, "unit", MUS_NONE);
        own = at != MUS_NONE ? mus__val_unit(mus__val_text(&xml, at)) : 0.0;
        if (own <= 0.0) status = mus__source_fail(source, 0, MUS_ERR_FORMAT, "unit: expected mm, cm or inch");
    }
    if (status == MUS_OK && table) status = measure_size(&xml, size, wanted, base);
    const double steps[2] = {(wanted[0] - base[0]) * own / 20.0, (wanted[1] - base[1]) * own / 60.0};
    if (status == MUS_OK && table) {
        status = mus__val_set(source, names, "size", wanted[0] * own / unit, MUS_NONE);
        if (status == MUS_OK) status = mus__val_set(source, names, "height", wanted[1] * own / unit, MUS_NONE);
    }
    const int32_t list = status == MUS_OK ? mus__val_child(&xml, 0, "body-measurements", MUS_NONE) : MUS_NONE;
    for (int32_t m = MUS_NONE; status == MUS_OK && list != MUS_NONE;) {
        m = mus__val_child(&xml, list, "m", m);
        if (m == MUS_NONE) break;
        status = measure_add(&xml, m, names, own / unit, table ? steps : NULL);
    }
    mus__val_xml_free(&xml);
    return status;
}
