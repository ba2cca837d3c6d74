/*
 * val_file.h: patterns of Valentina and Seamly (.val, .sm2d): drafted points and curves, whose formulas are evaluated,
 * and the pieces that they make.
 *
 * Order of use: val_read.c (the public call), val_xml.c (text to elements), val_formula.c (an expression to a number),
 * val_names.c (values by name; measurement files .vit, .smis, .vst), val_curve.c (curves of cubics); by val_draw.h:
 * val_objects.c (points and curves by id), val_points.c and val_draw.c (the tools of the drawing in the order of the
 * file), val_piece.c (pieces to panels).
 *
 * Inside the room lengths are millimetres, y runs up, and angles are degrees counter-clockwise from +x.
 */
#ifndef MUS_VALENTINA_VAL_FILE_H
#define MUS_VALENTINA_VAL_FILE_H

#include <stdbool.h>

#include "exchange/file_read.h"

/* ---- elements of the XML (val_xml.c) ---- */

typedef struct mus__val_element {
    const char *tag;
    int64_t line;
    int32_t depth;
    int32_t end;   /* index behind its last descendant */
    int32_t first; /* first of its attributes */
    int32_t n;     /* number of its attributes */
    int32_t text;  /* offset of its text, 0: none */
} mus__val_element;

typedef struct mus__val_xml {
    const mus__source *source;
    int32_t nelement, element_room, nattribute, attribute_room, nbyte, byte_room;
    mus__val_element *elements; /* (nelement) in the order of the file */
    int32_t *attributes;        /* (nattribute x 2) offsets of name and value */
    char *bytes;                /* (nbyte) texts, each with a zero byte at its end */
} mus__val_xml;

/* read all elements; the caller frees `xml`, after a failure too */
mus_status mus__val_xml_load(const mus__source *source, mus__val_xml *xml);
void mus__val_xml_free(mus__val_xml *xml);
/* value of an attribute, NULL without it */
const char *mus__val_attribute(const mus__val_xml *xml, int32_t element, const char *name);
const char *mus__val_text(const mus__val_xml *xml, int32_t element);
/* first child of an element with a tag, MUS_NONE without one; of `after` on unless that is MUS_NONE */
int32_t mus__val_child(const mus__val_xml *xml, int32_t parent, const char *tag, int32_t after);

/* ---- values by name (val_names.c) ---- */

typedef struct mus__val_name {
    int32_t text;  /* offset in the bytes */
    int32_t point; /* object that is a point of this name, MUS_NONE: a value */
    double value;
} mus__val_name;

typedef struct mus__val_names {
    mus_context *context;
    int32_t n, room, nslot, nbyte, byte_room;
    mus__val_name *names; /* (n) */
    int32_t *slots;       /* (nslot, a power of 2) index of a name, MUS_NONE: free */
    char *bytes;
} mus__val_names;

void mus__val_names_free(mus__val_names *names);
/* set a value, or with `point` not MUS_NONE a point, by name; a name that is there gets the new one */
mus_status mus__val_set(const mus__source *source, mus__val_names *names, const char *name, double value,
                        int32_t point);
const mus__val_name *mus__val_find(const mus__val_names *names, const char *name, size_t length);
/* read a measurement file into the names, in a unit of `unit` mm. `size` is "SIZE_HEIGHT" of a .vst, NULL: its base */
mus_status mus__val_measures(const mus__source *source, mus__val_names *names, double unit, const char *size);
/* millimetres of the unit "mm", "cm" or "inch"; 0 for another */
double mus__val_unit(const char *unit);

/* ---- formulas (val_formula.c) ---- */

/* the value of a name that a formula holds; false when it is unknown */
typedef bool (*mus__val_lookup)(const void *user, const char *name, size_t length, double *out);
/* evaluate a formula; NULL, or the fault as a text. `at` gets the place of the fault */
const char *mus__val_evaluate(const char *formula, mus__val_lookup lookup, const void *user, double *out,
                              const char **at);

/* ---- places and curves (val_curve.c) ---- */

/* p moved by a length [mm] at an angle [degrees] */
void mus__val_polar(const double *p, double length, double angle, double *out);
double mus__val_angle(const double *from, const double *to);

typedef struct mus__val_curve {
    int32_t n;      /* cubics */
    int32_t room;
    double *cubic;  /* (n x 8) */
    bool arc;       /* part of a circle */
    double centre[2], radius, angle[2]; /* of an arc */
} mus__val_curve;

mus_status mus__val_curve_add(const mus__source *source, mus__val_curve *curve, const double *cubic);
/* make an arc from angle[0] counter-clockwise to angle[1] */
mus_status mus__val_curve_arc(const mus__source *source, mus__val_curve *curve, const double *centre, double radius,
                              double from, double to);
double mus__val_curve_length(const mus__val_curve *curve);
/* point at the parameter t (0 to n) */
void mus__val_curve_at(const mus__val_curve *curve, double t, double *out);
/* parameter at a length from the start */
double mus__val_curve_along(const mus__val_curve *curve, double length);
/* parameter of the place nearest to p; *away gets its distance */
double mus__val_curve_nearest(const mus__val_curve *curve, const double *p, double *away);
/* add the part of a curve between two parameters to another curve */
mus_status mus__val_curve_part(const mus__source *source, const mus__val_curve *curve, double from, double to,
                               mus__val_curve *out);
void mus__val_curve_reverse(mus__val_curve *curve);
/* place where the line through p at an angle meets the curve: the nearest ahead of p, else the nearest behind */
bool mus__val_curve_meet(const mus__val_curve *curve, const double *p, double angle, double *out);

#endif
