/*
 * collar_flat.c: collars that lie on the shoulders: Peter Pan, shawl and sailor.
 *
 * Front and back are laid flat, shoulder to shoulder, and the collar is drawn on them: its neck edge is the neckline,
 * and its outer edge lies at the collar's width from it. When the shoulder points overlap, the neck edge is straighter
 * than the neckline and the collar rolls. The overlap's angle is spread over 4 cm of neckline on both sides of the
 * shoulder: each tangent is turned by its share of the angle, so that the neck edge has the neckline's length and no
 * corner.
 *
 * The collar turns over at the neck, so the right side of its panel continues that of the bodice and becomes the under
 * side. The panel is drawn as seen from below: x to the wearer's left, y to the front, centre back at (0, 0). It is cut
 * twice, an upper and an under collar, and once of interfacing.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "style/collar.h"

#define FLAT_STEPS 96  /* intervals of the integration along the neck edge */
#define FLAT_ABOVE 4.0 /* [cm at size 40] height at which a collar starts above the panels of the bodice */
#define FLAT_TILT 0.7  /* [rad] angle by which the back of a collar starts turned down */
/* radius of the bend of a collar at its start, in radii of the neck; measured: at 2.2 collars stand up after sewing, at
 * 1.1 they are caught on the shoulders */
#define FLAT_BEND 1.6

typedef struct flat_collar {
    double length;          /* [m] of the neck edge, centre back to centre front */
    double ds;
    double xy[FLAT_STEPS + 1][2], tangent[FLAT_STEPS + 1][2];
    double width, wide;     /* [m] width at the centre back; greatest width */
    double taper;           /* [m] arc length of the neck edge along which it narrows, up to the centre front */
    int32_t style;
} flat_collar;


static double flat_step(double t)
{
    t = fmin(fmax(t, 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}


/* Writes the unit tangent of the neck edge at arc length s [m]: that of the neckline, turned by its share of `angle`
 * [rad], which is spread over `reach` [m] on both sides of the shoulder. */
static void flat_tangent(const mus__board *board, const mus__neck *neck, double angle, double reach, double s,
                         double *out)
{
    double xy[2], along[2];
    mus__boundary_at(board, &neck->loop, s, xy, along);
    const double turn = angle * flat_step(0.5 + 0.5 * (s - neck->shoulder) / reach);
    const double x = mus__cos(turn) * along[0] - mus__sin(turn) * along[1],
                 y = mus__sin(turn) * along[0] + mus__cos(turn) * along[1];
    out[0] = -x, out[1] = y;
}


/* Integrates the tangents to the points of the neck edge by Simpson's rule. */
static void flat_neck(const mus__board *board, const mus__neck *neck, double angle, double reach, flat_collar *flat)
{
    flat->length = neck->length;
    flat->ds = neck->length / FLAT_STEPS;
    memset(flat->xy[0], 0, sizeof flat->xy[0]);
    flat_tangent(board, neck, angle, reach, 0.0, flat->tangent[0]);
    for (int32_t i = 1; i <= FLAT_STEPS; i++) {
        double middle[2];
        flat_tangent(board, neck, angle, reach, (i - 0.5) * flat->ds, middle);
        flat_tangent(board, neck, angle, reach, i * flat->ds, flat->tangent[i]);
        for (int32_t c = 0; c < 2; c++)
            flat->xy[i][c] = flat->xy[i - 1][c] +
                             flat->ds / 6.0 * (flat->tangent[i - 1][c] + 4.0 * middle[c] + flat->tangent[i][c]);
    }
}


/* Interpolates point and unit tangent of the neck edge at arc length s [m]. */
static void flat_at(const flat_collar *flat, double s, double *xy, double *tangent)
{
    const double place = fmin(fmax(s / flat->ds, 0.0), (double)FLAT_STEPS);
    const int32_t i = place >= FLAT_STEPS ? FLAT_STEPS - 1 : (int32_t)place;
    const double t = place - i;
    for (int32_t c = 0; c < 2; c++) {
        xy[c] = flat->xy[i][c] + t * (flat->xy[i + 1][c] - flat->xy[i][c]);
        tangent[c] = flat->tangent[i][c] + t * (flat->tangent[i + 1][c] - flat->tangent[i][c]);
    }
    const double length = mus__hypot(tangent[0], tangent[1]);
    tangent[0] /= length, tangent[1] /= length;
}


/* Returns the collar's width [m] at parameter t (0 to 1) of the outer edge, and *s, the arc length on the neck edge
 * there. In the taper (t above 0.5) the end of a Peter Pan collar is a quarter of an ellipse, that of a shawl collar
 * narrows to a point. */
static double flat_width(const flat_collar *flat, double t, double *s)
{
    const double body = flat->length - flat->taper;
    if (t < 0.5) {
        *s = 2.0 * t * body;
        return flat->width + (flat->wide - flat->width) * flat_step(2.0 * t);
    }
    const double u = 2.0 * t - 1.0;
    if (flat->style == MUS__COLLAR_PETER_PAN) {
        *s = body + flat->taper * mus__sin(0.5 * MUS_PI * u);
        return flat->wide * mus__cos(0.5 * MUS_PI * u);
    }
    *s = body + flat->taper * u;
    return flat->wide * (1.0 - u) * (1.0 + 0.35 * u);
}


/* Writes the point of the outer edge at parameter t: the neck edge's point moved outwards along the normal. */
static void flat_outer(const flat_collar *flat, double t, double *out)
{
    double s, xy[2], tangent[2];
    const double width = flat_width(flat, t, &s);
    flat_at(flat, s, xy, tangent);
    out[0] = xy[0] + width * tangent[1], out[1] = xy[1] - width * tangent[0];
}


/* Writes the curve of `point` between parameters t0 and t1 as four cubics. */
static void flat_chain(const flat_collar *flat, void (*point)(const flat_collar *flat, double t, double *out),
                       double t0, double t1, mus__chain *out)
{
    double xy[10], tangent[10], ds[4] = {0.0, 0.0, 0.0, 0.0};
    const double step = (t1 - t0) / 4.0, h = 1e-3 * step;
    for (int32_t i = 0; i <= 4; i++) {
        const double t = t0 + i * step;
        double a[2], b[2];
        point(flat, t, xy + 2 * i);
        point(flat, i == 0 ? t : t - h, a);
        point(flat, i == 4 ? t : t + h, b);
        const double d = mus__dist2(a, b);
        tangent[2 * i] = (b[0] - a[0]) / d, tangent[2 * i + 1] = (b[1] - a[1]) / d;
        for (int32_t j = 1; i > 0 && j <= 16; j++) {
            point(flat, t - step + (j - 1) * step / 16.0, a);
            point(flat, t - step + j * step / 16.0, b);
            ds[i - 1] += mus__dist2(a, b);
        }
    }
    mus__chain_through(out, 5, xy, tangent, ds);
}


static void flat_inner(const flat_collar *flat, double t, double *out)
{
    double tangent[2];
    flat_at(flat, t * flat->length, out, tangent);
}


/* Writes the outer edge of a sailor's collar: a square back of `depth` and half `width` [m], then a line over the
 * shoulder to the front. */
static void flat_sailor(const flat_collar *flat, double depth, double width, mus__chain *back, mus__chain *front)
{
    const double centre[2] = {0.0, -depth}, corner[2] = {width, -depth};
    const double *end = flat->xy[FLAT_STEPS], *along = flat->tangent[FLAT_STEPS];
    const double d = mus__dist2(corner, end);
    double cubic[8];
    mus__cubic_set(cubic, corner, corner[0] + 0.04 * d, corner[1] + 0.5 * d,
                   end[0] - 0.32 * d * along[0] + 0.2 * d * along[1], end[1] - 0.32 * d * along[1] - 0.2 * d * along[0],
                   end);
    mus__chain_line(back, centre, corner);
    mus__chain_cubic(front, cubic);
}


/*
 * Where cloth does not meet cloth, and the collar is sewn with the rest: places it FLAT_ABOVE above the highest panel
 * of the bodice, so that no panel passes through it while the bodice is sewn; it falls onto the shoulders then. A flat
 * collar on the shoulders is a cone, which is stable with its outer edge up or down; one that starts horizontal ends up
 * standing round the neck. So its back starts turned down by FLAT_TILT, and its sides bent down about a line from back
 * to front.
 */
static void flat_place(mus__half *half, const mus__neck *neck, int32_t panel)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK) return;
    const double radius = fmax(half->measures.v[MUS_MEASURE_NECK] / (2.0 * MUS_PI), 0.3 * neck->length);
    const double k = mus__measures_scale(&half->measures), c = mus__cos(FLAT_TILT), s = mus__sin(FLAT_TILT);
    const double turn[9] = {1.0, 0.0, 0.0, 0.0, s, -c, 0.0, c, s};
    double own[2] = {INFINITY, -INFINITY}, body[2] = {INFINITY, half->skeleton.nape};
    mus_placement *place = &board->panel[panel].attr.placement;
    mus_placement_init(place, sizeof *place);
    memcpy(place->rotation, turn, sizeof turn);
    place->origin[2] = half->skeleton.shoulder_z - radius;
    place->bend = -FLAT_BEND * radius;
    for (int32_t p = 0; p < board->npanel; p++) mus__panel_heights(board, p, p == panel ? own : body);
    place->origin[1] = body[1] - own[0] + FLAT_ABOVE * k * MUS__CM;
}


void mus__collar_flat(mus__half *half, mus__neck *neck)
{
    mus__board *board = &half->board;
    const double k = mus__measures_scale(&half->measures);
    const int32_t style = half->style.option[MUS__AXIS_COLLAR];
    const int32_t over = mus__boundary_over(board, &neck->loop, "shoulder");
    const double shoulder =
        over != MUS_NONE ? board->side[neck->loop.over[over]].length : half->measures.v[MUS_MEASURE_SHOULDER];
    const double front = neck->length - neck->shoulder;

    /* overlap of the shoulder points at size 40: Peter Pan 2 cm, shawl 1 cm, sailor 0 */
    const double overlap = style == MUS__COLLAR_SAILOR ? 0.0 : (style == MUS__COLLAR_SHAWL ? 1.0 : 2.0) * k * MUS__CM;
    flat_collar flat = {.style = style};
    const double angle = 2.0 * mus__asin(fmin(0.5, 0.5 * overlap / shoulder));
    flat_neck(board, neck, angle, fmin(4.0 * k * MUS__CM, 0.9 * neck->shoulder), &flat);
    flat.width = (style == MUS__COLLAR_SHAWL ? 7.0 : 6.5) * k * MUS__CM;
    flat.wide = (style == MUS__COLLAR_SHAWL ? 9.0 : 6.5) * k * MUS__CM;
    flat.taper = style == MUS__COLLAR_SHAWL ? 0.62 * front : fmin(flat.wide, 0.6 * front);

    mus__chain inner[2], outer[2], centre;
    const double turn = neck->shoulder / neck->length;
    flat_chain(&flat, flat_inner, turn, 1.0, &inner[0]);
    flat_chain(&flat, flat_inner, 0.0, turn, &inner[1]);
    mus__chain_reverse(&inner[0]);
    mus__chain_reverse(&inner[1]);
    if (style == MUS__COLLAR_SAILOR) {
        double snp[2], along[2];
        flat_at(&flat, neck->shoulder, snp, along);
        flat_sailor(&flat, 15.0 * k * MUS__CM, snp[0] + 0.8 * shoulder, &outer[0], &outer[1]);
    } else {
        flat_chain(&flat, flat_outer, 0.0, 0.5, &outer[0]);
        flat_chain(&flat, flat_outer, 0.5, 1.0, &outer[1]);
    }
    mus__chain_line(&centre, flat.xy[0], outer[0].xy);

    const int32_t panel = mus__board_panel_add(board, "collar", "collar");
    int32_t neck_sides[2];
    neck_sides[0] = mus__chain_side(board, panel, "neckF", NULL, MUS__COLLAR_SEAM, &inner[0]);
    neck_sides[1] = mus__chain_side(board, panel, "neckB", NULL, MUS__COLLAR_SEAM, &inner[1]);
    const int32_t cb =
        mus__chain_side(board, panel, "cb", neck->back_open ? "neck" : "centre", MUS__COLLAR_SEAM, &centre);
    mus__chain_side(board, panel, "outer", "neck", MUS__COLLAR_SEAM, &outer[0]);
    mus__chain_side(board, panel, "front", "neck", MUS__COLLAR_SEAM, &outer[1]);
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    board->panel[panel].attr.layer = MUS__COLLAR_LIES;
    board->side[cb].centre = neck->back_open ? MUS__CENTRE_OPEN : MUS__CENTRE_FOLD;
    mus__board_sew(board, 2, neck_sides, neck->loop.n, neck->loop.side);
    mus__half_cut(half, panel, 2, MUS_MATERIAL_INTERFACING, 1);
    flat_place(half, neck, panel);
}
