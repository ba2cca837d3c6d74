/*
 * val_read.c: a pattern of Valentina or Seamly, with its measurement file, as a pattern of muslin.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "valentina/val_draw.h"

#define READ_IDS 1000000 /* highest id; chosen: the largest pattern known has 60000. It bounds the memory to 100 MB */


bool mus__val_begins(const char *text)
{
    for (;;) {
        text += strspn(text, " \t\r\n");
        if (strncmp(text, "<?", 2) == 0) text = strstr(text, "?>");
        else if (strncmp(text, "<!--", 4) == 0) text = strstr(text, "-->");
        else break;
        if (text == NULL) return false;
        text += *text == '?' ? 2 : 3;
    }
    return strncmp(text, "<pattern", 8) == 0;
}


/* the k-th id that an element declares (its own, those of true darts, of an operation's copies); -1 without one */
static long read_id(const mus__val_job *job, int32_t e, int32_t k)
{
    static const char *const keys[] = {"id", "idObject", "point1", "point2"};
    const bool darts = k < 2 || mus__val_attribute(&job->xml, e, "name1") != NULL;
    const char *text = darts ? mus__val_attribute(&job->xml, e, keys[k]) : NULL;
    return text != NULL ? strtol(text, NULL, 10) : -1;
}


/* room for the objects of all ids */
static mus_status read_objects(mus__val_job *job)
{
    long highest = 0;
    for (int32_t e = 0; e < job->xml.nelement; e++)
        for (int32_t k = 0; k < 4; k++) {
            const long id = read_id(job, e, k);
            if (id > READ_IDS)
                return mus__source_fail(job->source, job->xml.elements[e].line, MUS_ERR_LIMIT,
                                        "id %ld, expected 0 to %d", id, READ_IDS);
            highest = id > highest ? id : highest;
        }
    mus_context *context = job->source->context;
    job->nobject = (int32_t)highest + 3; /* with the two parts of a curve */
    job->objects = mus_context_alloc(context, NULL, (size_t)job->nobject * sizeof *job->objects);
    job->links = mus_context_alloc(context, NULL, (size_t)job->nobject * sizeof *job->links);
    if (job->objects == NULL || job->links == NULL) {
        job->nobject = job->objects == NULL ? 0 : job->nobject;
        if (job->objects != NULL) memset(job->objects, 0, (size_t)job->nobject * sizeof *job->objects);
        return mus__source_fail(job->source, 0, MUS_ERR_MEMORY, "no memory for %ld objects", highest);
    }
    memset(job->objects, 0, (size_t)job->nobject * sizeof *job->objects);
    for (int32_t i = 0; i < job->nobject; i++) job->links[i] = MUS_NONE;
    for (int32_t e = 0, copies = 0; e < job->xml.nelement; e++) {
        if (strcmp(job->xml.elements[e].tag, "destination") == 0) copies = job->xml.elements[e].end;
        for (int32_t k = 0; k < 4; k++) {
            const long id = k != 1 || e < copies ? read_id(job, e, k) : -1;
            if (id >= 0) job->objects[id].declared = true;
        }
    }
    return MUS_OK;
}


static bool read_lookup(const void *user, const char *name, size_t length, double *out)
{
    const mus__val_name *found = mus__val_find(user, name, length);
    if (found == NULL || found->point != MUS_NONE) return false;
    *out = found->value;
    return true;
}


/* values of the increments, each a formula over the measures and the increments before it. Without `all` those that
 * need the drawing are left out */
static mus_status read_increments(mus__val_job *job, const char *tag, bool all)
{
    const mus__val_xml *xml = &job->xml;
    const int32_t list = mus__val_child(xml, 0, tag, MUS_NONE);
    mus_status status = MUS_OK;
    for (int32_t e = list != MUS_NONE ? mus__val_child(xml, list, NULL, MUS_NONE) : MUS_NONE;
         e != MUS_NONE && status == MUS_OK; e = mus__val_child(xml, list, NULL, e)) {
        const char *name = mus__val_attribute(xml, e, "name"), *text = mus__val_attribute(xml, e, "formula"), *at;
        double value;
        if (name == NULL || text == NULL || text[strspn(text, " \t\r\n")] == '\0') continue; /* a heading */
        const char *wrong = mus__val_evaluate(text, read_lookup, &job->names, &value, &at);
        if (wrong != NULL && !all) continue;
        if (wrong != NULL)
            return mus__source_fail(job->source, xml->elements[e].line, MUS_ERR_FORMAT,
                                    "%.60s: in \"%.120s\" the part \"%.60s\" %s", name, text, at, wrong);
        status = mus__val_set(job->source, &job->names, name, value, MUS_NONE);
    }
    return status;
}


static mus_status read_drawings(mus__val_job *job)
{
    mus_status status = MUS_OK;
    for (int32_t pass = 0; pass < 2; pass++)
        for (int32_t e = mus__val_child(&job->xml, 0, NULL, MUS_NONE); e != MUS_NONE && status == MUS_OK;
             e = mus__val_child(&job->xml, 0, NULL, e)) {
            const char *tag = job->xml.elements[e].tag;
            if (strcmp(tag, "draw") != 0 && strcmp(tag, "draftBlock") != 0) continue;
            status = pass == 0 ? mus__val_draw(job, e) : mus__val_pieces(job, e);
        }
    if (status == MUS_OK && mus_pattern_panel_count(job->pattern) == 0)
        return mus__source_fail(job->source, 0, MUS_ERR_FORMAT, "the pattern has no piece; make one in Valentina");
    return status;
}


static void read_free(mus__val_job *job)
{
    mus_context *context = job->source->context;
    for (int32_t i = 0; job->objects != NULL && i < job->nobject; i++)
        mus_context_alloc(context, job->objects[i].curve.cubic, 0);
    mus_context_alloc(context, job->objects, 0);
    mus_context_alloc(context, job->links, 0);
    while (job->kept != NULL) {
        mus__val_kept *next = job->kept->next;
        mus_context_alloc(context, job->kept, 0);
        job->kept = next;
    }
    mus__val_names_free(&job->names);
    mus__val_xml_free(&job->xml);
}


mus_status mus__val_read(const mus__source *source, const mus__source *measures, const char *size, mus_pattern *pattern)
{
    mus__val_job job = {.source = source, .pattern = pattern, .current = NAN, .allowance = NAN};
    mus_status status = mus__val_xml_load(source, &job.xml);
    if (status == MUS_OK && strcmp(job.xml.elements[0].tag, "pattern") != 0)
        status = mus__source_fail(source, job.xml.elements[0].line, MUS_ERR_FORMAT, "expected <pattern>, got <%.40s>",
                                  job.xml.elements[0].tag);
    if (status == MUS_OK) {
        const int32_t at = mus__val_child(&job.xml, 0, "unit", MUS_NONE);
        job.unit = at != MUS_NONE ? mus__val_unit(mus__val_text(&job.xml, at)) : 0.0;
        if (job.unit <= 0.0) status = mus__source_fail(source, 0, MUS_ERR_FORMAT, "unit: expected mm, cm or inch");
    }
    if (status == MUS_OK && measures != NULL) status = mus__val_measures(measures, &job.names, job.unit, size);
    if (status == MUS_OK) status = read_increments(&job, "increments", true);
    if (status == MUS_OK) status = read_increments(&job, "variables", true); /* Seamly's name of them */
    if (status == MUS_OK) status = read_increments(&job, "previewCalculations", false);
    if (status == MUS_OK) status = read_objects(&job);
    if (status == MUS_OK) status = read_drawings(&job);
    read_free(&job);
    return status;
}
