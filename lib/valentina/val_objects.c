/*
 * val_objects.c: points and curves of a drawing by id, and the values that formulas take of them: Line_A_B,
 * AngleLine_A_B, Spl_A_B and their like.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "valentina/val_draw.h"


mus_status mus__val_fail(mus__val_job *job, int32_t e, mus_status status, const char *what, const char *name)
{
    return mus__source_fail(job->source, job->xml.elements[e].line, status, "<%.30s>: %s \"%.80s\"",
                            job->xml.elements[e].tag, what, name != NULL ? name : "");
}


/* the two points of "A_B", where names may hold "_" */
static bool objects_pair(const mus__val_job *job, const char *name, size_t length, double (*xy)[2])
{
    for (size_t i = 1; i + 1 < length; i++) {
        if (name[i] != '_') continue;
        const mus__val_name *a = mus__val_find(&job->names, name, i);
        const mus__val_name *b = mus__val_find(&job->names, name + i + 1, length - i - 1);
        if (a == NULL || b == NULL || a->point == MUS_NONE || b->point == MUS_NONE) continue;
        memcpy(xy[0], job->objects[a->point].xy, sizeof xy[0]);
        memcpy(xy[1], job->objects[b->point].xy, sizeof xy[1]);
        return true;
    }
    return false;
}


static bool objects_lookup(const void *user, const char *name, size_t length, double *out)
{
    const mus__val_job *job = user;
    double p[2][2];
    if (length == 13 && memcmp(name, "CurrentLength", 13) == 0) {
        *out = job->current;
        return !isnan(job->current);
    }
    if (length == 20 && memcmp(name, "CurrentSeamAllowance", 20) == 0) {
        *out = job->allowance;
        return !isnan(job->allowance);
    }
    const mus__val_name *found = mus__val_find(&job->names, name, length);
    if (found != NULL && found->point == MUS_NONE) {
        *out = found->value;
        return true;
    }
    if (length > 5 && memcmp(name, "Line_", 5) == 0 && objects_pair(job, name + 5, length - 5, p))
        *out = mus__hypot(p[1][0] - p[0][0], p[1][1] - p[0][1]) / job->unit;
    else if (length > 10 && memcmp(name, "AngleLine_", 10) == 0 && objects_pair(job, name + 10, length - 10, p))
        *out = mus__val_angle(p[0], p[1]);
    else return false;
    return true;
}


double mus__val_number(mus__val_job *job, int32_t element, const char *attribute, mus_status *status)
{
    double value = 0.0;
    const char *at = NULL, *text = mus__val_attribute(&job->xml, element, attribute);
    if (*status != MUS_OK) return 0.0;
    if (text == NULL) {
        *status = mus__val_fail(job, element, MUS_ERR_FORMAT, "lacks the attribute", attribute);
        return 0.0;
    }
    const char *wrong = mus__val_evaluate(text, objects_lookup, job, &value, &at);
    if (wrong != NULL && job->missing[0] != '\0' && strcmp(wrong, "is not finite") == 0) return NAN;
    if (wrong != NULL) {
        *status = mus__source_fail(job->source, job->xml.elements[element].line, MUS_ERR_FORMAT,
                                   "%s: in \"%.120s\" the part \"%.60s\" %s", attribute, text, at, wrong);
        return 0.0;
    }
    return value;
}


double mus__val_length(mus__val_job *job, int32_t element, const char *attribute, mus_status *status)
{
    return mus__val_number(job, element, attribute, status) * job->unit;
}


mus__val_object *mus__val_object_of(mus__val_job *job, int32_t element, const char *attribute, int32_t kind,
                                    mus_status *status)
{
    const char *text = mus__val_attribute(&job->xml, element, attribute);
    const long id = text != NULL ? strtol(text, NULL, 10) : -1;
    if (*status != MUS_OK) return NULL;
    if (id >= 0 && id < job->nobject) {
        mus__val_object *o = &job->objects[id];
        if (o->kind == kind || (kind == MUS__VAL_NOTHING && o->kind != kind)) return o;
    }
    *status = mus__val_fail(job, element, MUS_ERR_FORMAT, kind == MUS__VAL_POINT ? "no point has the id"
                        : kind == MUS__VAL_CURVE ? "no curve has the id" : "no object has the id", text);
    return NULL;
}


mus__val_object *mus__val_new(mus__val_job *job, int32_t element, int64_t id, int32_t kind, const char *name,
                              mus_status *status)
{
    if (*status != MUS_OK) return NULL;
    if (id < 0 || id >= job->nobject || name == NULL) {
        *status = mus__val_fail(job, element, MUS_ERR_FORMAT, "expected an id and a name, got the name", name);
        return NULL;
    }
    mus__val_object *o = &job->objects[id];
    if (o->kind != MUS__VAL_NOTHING) {
        *status = mus__val_fail(job, element, MUS_ERR_FORMAT, "its id is taken; the name is", name);
        return NULL;
    }
    o->kind = kind;
    o->name = name;
    if (kind == MUS__VAL_POINT) *status = mus__val_set(job->source, &job->names, name, 0.0, (int32_t)id);
    return *status == MUS_OK ? o : NULL;
}


mus_status mus__val_value(mus__val_job *job, const char *head, const char *name, double value)
{
    char text[MUS__VAL_NAME + 64];
    snprintf(text, sizeof text, "%s%s", head, name);
    return mus__val_set(job->source, &job->names, text, value, MUS_NONE);
}


mus_status mus__val_curve_name(mus__val_job *job, mus__val_object *object, const char *name)
{
    const mus__val_curve *c = &object->curve;
    mus_status status = mus__val_value(job, "", name, mus__val_curve_length(c) / job->unit);
    if (c->n == 0 || status != MUS_OK) return status;
    const double *first = c->cubic, *last = c->cubic + 8 * (ptrdiff_t)(c->n - 1);
    const double ends[2] = {c->arc ? c->angle[0] : mus__val_angle(first, first + 2),
                            c->arc ? c->angle[1] : mus__val_angle(last + 6, last + 4)};
    const double reach[2] = {mus__hypot(first[2] - first[0], first[3] - first[1]),
                             mus__hypot(last[4] - last[6], last[5] - last[7])};
    status = mus__val_value(job, "Angle1", name, ends[0]);
    if (status == MUS_OK) status = mus__val_value(job, "Angle2", name, ends[1]);
    if (status == MUS_OK && c->arc) return mus__val_value(job, "Radius", name, c->radius / job->unit);
    if (status == MUS_OK) status = mus__val_value(job, "C1Length", name, reach[0] / job->unit);
    if (status == MUS_OK) status = mus__val_value(job, "C2Length", name, reach[1] / job->unit);
    for (int32_t i = 0; i < c->n && c->n > 1 && status == MUS_OK; i++) {
        char part[MUS__VAL_NAME + 32];
        mus__val_object one = {.curve = {.n = 1, .cubic = c->cubic + 8 * (ptrdiff_t)i}};
        snprintf(part, sizeof part, "%.500s_Seg_%d", name, (int)i + 1);
        status = mus__val_curve_name(job, &one, part);
    }
    return status;
}
