/*
 * measure.h: the measures of a body taken on its written OBJ file.
 *
 * The body gives the planes (the contours of its measures) and the numbers that were asked; every figure comes from the
 * file.
 */
#ifndef MUS_TESTS_OUTSIDE_MEASURE_H
#define MUS_TESTS_OUTSIDE_MEASURE_H

#include "muslin/body.h"
#include "muslin/exchange.h"
#include "ruler.h"

/* measures that a ruler finds on a mesh: girths, heights, lengths */
typedef struct outside_row {
    int32_t measure;
    char kind;            /* g girth of the torso, l of a limb, h height, s length along the skin */
    const char *contour;  /* of a girth */
    int32_t limb;         /* of a girth; the left one of two */
    double most;          /* what it may be off by: girths 1 mm, heights 2 mm, across_back and bust_span 2 mm [m] */
    bool known;           /* it is known to be beyond that: fillets and details move the skin after it is measured */
} outside_row;

#define OUTSIDE_ROWS 24
extern const outside_row outside_rows[OUTSIDE_ROWS];

/* write the skin of a body to `path` as OBJ. Inline, so that a test that calls it names the writer itself: a build
 * without the writers leaves the test out */
static inline mus_status outside_write(mus_context *context, const mus_body *body, const char *path)
{
    mus_mesh_view view;
    mus_mesh_view_init(&view, sizeof view);
    view.name = "body";
    view.vertex_count = mus_body_vertex_count(body), view.positions = mus_body_vertices(body);
    view.triangle_count = mus_body_triangle_count(body), view.triangles = mus_body_triangles(body);
    return mus_mesh_write_obj(context, path, 1, &view);
}

/* read the OBJ file of a body and measure it: made (OUTSIDE_ROWS) [m] or [rad], NaN where the body has no such measure.
 * false: the file cannot be read */
bool outside_measure(const mus_body *body, const char *path, double *made);

#define OUTSIDE_CLOSE 5e-4 /* [m] what cloth touches is what is drawn up to this */

/* how far the skin lies off what cloth touches */
typedef struct outside_gap {
    int64_t points, far;         /* points that are seen, and how many of them are further off than OUTSIDE_CLOSE */
    double outside, inside;      /* largest distance of a point outside what cloth touches, and of one within it [m] */
    double at_outside[3], at_inside[3];
} outside_gap;

/* compare the skin with the radius fields at `each` points of every triangle */
void outside_touch(const mus_body *body, int32_t each, outside_gap *out);

#endif
