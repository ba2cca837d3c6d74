/*
 * val_draw.h: a drawing that is evaluated: its objects by id, the values of its formulas, its pieces.
 */
#ifndef MUS_VALENTINA_VAL_DRAW_H
#define MUS_VALENTINA_VAL_DRAW_H

#include "valentina/val_file.h"

#define MUS__VAL_NAME 512 /* [bytes] of a name of a curve: three of a point with its letters */

enum { MUS__VAL_NOTHING, MUS__VAL_POINT, MUS__VAL_CURVE, MUS__VAL_PATH };

typedef struct mus__val_object {
    int32_t kind;
    bool declared; /* the file gives its id to a tool: no part of a curve may take it */
    const char *name;
    const char *ends[2]; /* names of the points where a curve starts and ends */
    const char *title;   /* name of a curve that an operation made; NULL: its kind and ends make it */
    double xy[2];
    mus__val_curve curve;
} mus__val_object;

/* a name that an operation made */
typedef struct mus__val_kept {
    struct mus__val_kept *next;
    char text[];
} mus__val_kept;

typedef struct mus__val_job {
    const mus__source *source;
    mus__val_xml xml;
    mus__val_names names;
    double unit; /* [mm] of the pattern's unit */
    int32_t nobject;
    mus__val_object *objects; /* (nobject) by id */
    int32_t *links;           /* (nobject) id of the object that a node of a piece stands for; MUS_NONE */
    mus__val_kept *kept;
    char missing[512];        /* the first point that has no place, for the message of a piece that needs it */
    double current;           /* CurrentLength: of the line or curve that a tool cuts, in the pattern's unit */
    double allowance;         /* CurrentSeamAllowance: of the piece that is read, in the pattern's unit */
    mus_pattern *pattern;
} mus__val_job;

/* evaluate all tools of a drawing, the element `draw`. A point without a place gets NaN, as does what depends on it */
mus_status mus__val_draw(mus__val_job *job, int32_t draw);
/* the object that an attribute names by its id, of a kind; NULL with a message */
mus__val_object *mus__val_object_of(mus__val_job *job, int32_t element, const char *attribute, int32_t kind,
                                    mus_status *status);
/* the value of a formula in an attribute. *status keeps its first failure; 0 then */
double mus__val_number(mus__val_job *job, int32_t element, const char *attribute, mus_status *status);
/* the same as a length in mm */
double mus__val_length(mus__val_job *job, int32_t element, const char *attribute, mus_status *status);
/* object to fill, with the id and the name; NULL with a message */
mus__val_object *mus__val_new(mus__val_job *job, int32_t element, int64_t id, int32_t kind, const char *name,
                              mus_status *status);
/* fail with the line and tag of an element: what is wrong with it, and a name */
mus_status mus__val_fail(mus__val_job *job, int32_t e, mus_status status, const char *what, const char *name);
/* set the value of the name `head` `name` */
mus_status mus__val_value(mus__val_job *job, const char *head, const char *name, double value);
/* place a point by its tool; false when the type is unknown */
bool mus__val_point(mus__val_job *job, int32_t element, const char *type, double *out, mus_status *status);
/* put the values of a curve under its name: its length, angles and lengths of its controls, lengths of its cubics */
mus_status mus__val_curve_name(mus__val_job *job, mus__val_object *object, const char *name);
/* places where a circle meets the line through a and b: their number */
int32_t mus__val_circle_line(const double *centre, double radius, const double *a, const double *b, double *out);
/* places where two circles meet, the one on the right of the way from c1 to c2 first: their number */
int32_t mus__val_circles(const double *c1, double r1, const double *c2, double r2, double *out);

/* true when a text begins as such a pattern does */
bool mus__val_begins(const char *text);
/* fill an empty pattern; measures NULL: without a measurement file. size: of a .vst, "SIZE_HEIGHT" or NULL */
mus_status mus__val_read(const mus__source *source, const mus__source *measures, const char *size,
                         mus_pattern *pattern);
/* add the pieces of a drawing to the pattern (val_piece.c) */
mus_status mus__val_pieces(mus__val_job *job, int32_t draw);

#endif
