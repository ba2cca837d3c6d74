/*
 * svg_path.c: the data of an SVG path (lines, quadratic and cubic Beziers, circular arcs) and the transforms above it.
 *
 * An arc of a circle stays an arc, when its transform is a similarity; so it comes back as it was written. An ellipse
 * is refused: drawing programs convert it to Beziers. Source: W3C, SVG 1.1, sections 7.6, 8.3 and F.6.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "trade/dxf_file.h"
#include "trade/svg_path.h"

#define PATH_POINTS 20000 /* most points of a path; as of an outline of a DXF */
#define PATH_JOINED 1e-6  /* [unit of the file] a piece shorter than this is left out */
#define PLACE_MOST 1e3    /* [m] of a point from the origin; chosen: written in mm it is below the 1e7 that is read */
#define CIRCLE_OFF 1e-6   /* relative difference of the radii of an arc that is circular */

typedef struct path_reader {
    const mus__source *source;
    int64_t line;
    const char *at;
    const double *m;
    mus__svg_path *out;
    double pen[2], first[2], control[2]; /* in the unit of the path; control: the last one, for S and T */
    char last;                           /* command before this one, a capital */
} path_reader;


void mus__svg_apply(const double *m, const double *p, double *out)
{
    const double x = m[0] * p[0] + m[2] * p[1] + m[4], y = m[1] * p[0] + m[3] * p[1] + m[5];
    out[0] = x;
    out[1] = y;
}


void mus__svg_path_free(mus_context *context, mus__svg_path *path)
{
    mus_context_alloc(context, path->kinds, 0);
    mus_context_alloc(context, path->xy, 0);
    memset(path, 0, sizeof *path);
}


/* ---- numbers ---- */

static void skip_blanks(const char **at)
{
    while (**at != '\0' && strchr(" \t\r\n,", **at) != NULL) (*at)++;
}


/* the number at *at behind blanks and commas; false without one */
static bool take_number(const char **at, double *out)
{
    skip_blanks(at);
    const size_t n = mus__number_span(*at);
    if (n == 0) return false;
    *out = strtod(*at, NULL);
    *at += n;
    return fabs(*out) <= 1e7;
}


static bool take_flag(const char **at, double *out)
{
    skip_blanks(at);
    if (**at != '0' && **at != '1') return false;
    *out = *(*at)++ - '0';
    return true;
}


static mus_status path_fail(const path_reader *r, char command, const char *expected)
{
    return mus__source_fail(r->source, r->line, MUS_ERR_FORMAT, "path: %c: expected %s, got \"%.20s\"", command,
                            expected, r->at);
}


/* ---- pieces ---- */

static mus_status add_point(path_reader *r, const double *p)
{
    mus__svg_path *out = r->out;
    if (out->nxy >= PATH_POINTS)
        return mus__source_fail(r->source, r->line, MUS_ERR_LIMIT, "path: more than %d points", PATH_POINTS);
    mus_status status =
        mus__source_reserve(r->source, &out->xy, &out->xy_room, (int64_t)out->nxy + 1, 2 * sizeof *out->xy);
    if (status != MUS_OK) return status;
    double *at = out->xy + 2 * (size_t)out->nxy++;
    mus__svg_apply(r->m, p, at);
    if (!(fabs(at[0]) <= PLACE_MOST && fabs(at[1]) <= PLACE_MOST))
        return mus__source_fail(r->source, r->line, MUS_ERR_LIMIT,
                                "path: a point at %.6g, %.6g m; expected at most %g m from the origin", at[0], at[1],
                                PLACE_MOST);
    return MUS_OK;
}


/* a piece from the pen: its control points, then its end, `points` of them in p */
static mus_status add_piece(path_reader *r, int32_t kind, int32_t points, const double *p)
{
    mus__svg_path *out = r->out;
    double reach = 0.0;
    for (int32_t i = 0; i < 2 * points; i++) reach = fmax(reach, fabs(p[i] - r->pen[i % 2]));
    if (reach <= PATH_JOINED) return MUS_OK;
    mus_status status =
        mus__source_reserve(r->source, &out->kinds, &out->piece_room, (int64_t)out->npiece + 1, sizeof *out->kinds);
    if (status == MUS_OK && out->nxy == 0) status = add_point(r, r->pen);
    if (status != MUS_OK) return status;
    out->kinds[out->npiece++] = kind;
    for (int32_t i = 0; i < points && status == MUS_OK; i++) status = add_point(r, p + 2 * i);
    memcpy(r->pen, p + 2 * points - 2, sizeof r->pen);
    return status;
}


/* an arc of radius q[0] = q[1] to q[5], q[6]; q[3] the long way round, q[4] with growing angles (SVG 1.1, F.6.5) */
static mus_status add_arc(path_reader *r, const double *q)
{
    double radius = fabs(q[0]), dx = q[5] - r->pen[0], dy = q[6] - r->pen[1], chord = sqrt(dx * dx + dy * dy), p[4];
    const double *m = r->m, scale = m[0] * m[0] + m[1] * m[1];
    const bool similar = fabs(scale - m[2] * m[2] - m[3] * m[3]) <= CIRCLE_OFF * scale &&
                         fabs(m[0] * m[2] + m[1] * m[3]) <= CIRCLE_OFF * scale;
    if (radius <= PATH_JOINED) return add_piece(r, MUS_PIECE_LINE, 1, q + 5);
    if (fabs(fabs(q[1]) - radius) > CIRCLE_OFF * radius || !similar)
        return mus__source_fail(r->source, r->line, MUS_ERR_UNSUPPORTED,
                                "path: an arc of an ellipse; expected a circle or Bezier curves");
    if (chord <= PATH_JOINED) return MUS_OK;
    radius = fmax(radius, 0.5 * chord);
    const double leg = sqrt(fmax(0.0, radius * radius - 0.25 * chord * chord));
    const double sign = q[4] > 0.0 ? 1.0 : -1.0, sagitta = q[3] > 0.0 ? radius + leg : radius - leg;
    p[0] = 0.5 * (r->pen[0] + q[5]) + sign * sagitta * dy / chord;
    p[1] = 0.5 * (r->pen[1] + q[6]) - sign * sagitta * dx / chord;
    p[2] = q[5];
    p[3] = q[6];
    return add_piece(r, sagitta > 1e-9 * chord ? MUS_PIECE_ARC : MUS_PIECE_LINE, sagitta > 1e-9 * chord ? 2 : 1,
                     sagitta > 1e-9 * chord ? p : p + 2);
}


/* ---- commands ---- */

static int32_t count_of(char command)
{
    switch (command) {
    case 'M':
    case 'L':
    case 'T': return 2;
    case 'H':
    case 'V': return 1;
    case 'C': return 6;
    case 'S':
    case 'Q': return 4;
    case 'A': return 7;
    default: return 0;
    }
}


/* the numbers of a command, absolute, those of H and V as a point, S and T with their first control point */
static bool take_numbers(path_reader *r, char command, bool relative, double *q)
{
    const int32_t n = count_of(command);
    double *to = q;
    if (command == 'S' || command == 'T') {
        const bool smooth = command == 'S' ? r->last == 'C' : r->last == 'Q';
        for (int32_t k = 0; k < 2; k++) q[k] = smooth ? 2.0 * r->pen[k] - r->control[k] : r->pen[k];
        to = q + 2;
    }
    for (int32_t i = 0; i < n; i++) {
        const bool flag = command == 'A' && (i == 3 || i == 4);
        if (!(flag ? take_flag(&r->at, &to[i]) : take_number(&r->at, &to[i]))) return false;
        if (!relative || (command == 'A' && i < 5)) continue;
        to[i] += command == 'V' ? r->pen[1] : command == 'H' ? r->pen[0] : r->pen[command == 'A' ? (i + 1) % 2 : i % 2];
    }
    if (command == 'V') {
        q[1] = q[0];
        q[0] = r->pen[0];
    } else if (command == 'H') {
        q[1] = r->pen[1];
    }
    return true;
}


static mus_status run_command(path_reader *r, char command, bool relative)
{
    double q[8] = {0.0};
    if (!take_numbers(r, command, relative, q)) return path_fail(r, command, "numbers within 1e7");
    const char curve = command == 'S' ? 'C' : command == 'T' ? 'Q' : command;
    const double control[2] = {curve == 'C' ? q[2] : q[0], curve == 'C' ? q[3] : q[1]};
    mus_status status = MUS_OK;
    switch (curve) {
    case 'M':
        if (r->out->npiece > 0)
            return mus__source_fail(r->source, r->line, MUS_ERR_UNSUPPORTED,
                                    "path: a second subpath; expected one line a path (break it apart)");
        memcpy(r->pen, q, sizeof r->pen);
        memcpy(r->first, q, sizeof r->first);
        break;
    case 'C': status = add_piece(r, MUS_PIECE_CUBIC, 3, q); break;
    case 'Q': status = add_piece(r, MUS_PIECE_QUADRATIC, 2, q); break;
    case 'A': status = add_arc(r, q); break;
    default: status = add_piece(r, MUS_PIECE_LINE, 1, q); break;
    }
    memcpy(r->control, control, sizeof r->control);
    r->last = curve;
    return status;
}


mus_status mus__svg_path_read(const mus__source *source, int64_t line, const char *d, const double *m,
                              mus__svg_path *out)
{
    path_reader r = {.source = source, .line = line, .at = d, .m = m, .out = out};
    mus_status status = MUS_OK;
    char command = 'M'; /* as in the points of a polygon */
    bool relative = false;
    for (skip_blanks(&r.at); *r.at != '\0' && status == MUS_OK; skip_blanks(&r.at)) {
        const char letter = *r.at, capital = letter >= 'a' && letter <= 'z' ? (char)(letter - 32) : letter;
        if (capital >= 'A' && capital <= 'Z') {
            r.at++;
            if (capital == 'Z') {
                status = add_piece(&r, MUS_PIECE_LINE, 1, r.first);
                out->closed = true;
                command = 'Z';
                continue;
            }
            if (count_of(capital) == 0) return path_fail(&r, letter, "a command of SVG");
            command = capital;
            relative = letter != capital;
        } else if (command == 'Z') {
            return path_fail(&r, 'Z', "a command");
        }
        status = run_command(&r, command, relative);
        if (command == 'M') command = 'L';
    }
    if (status == MUS_OK && out->npiece > 0 && fabs(r.pen[0] - r.first[0]) + fabs(r.pen[1] - r.first[1]) <= PATH_JOINED)
        out->closed = true;
    /* a path of one point is a drill hole */
    if (status == MUS_OK && out->nxy == 0) status = add_point(&r, r.pen);
    return status;
}


/* ---- transforms ---- */

static void multiply(double *m, const double *n)
{
    const double p[6] = {m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1],        m[0] * n[2] + m[2] * n[3],
                         m[1] * n[2] + m[3] * n[3], m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5]};
    memcpy(m, p, sizeof p);
}


/* the matrix of a transform from its name and its n numbers; false for an unknown one */
static bool transform_of(const char *name, size_t length, int32_t n, const double *q, double *out)
{
    const double one[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    memcpy(out, one, sizeof one);
    if (length == 6 && memcmp(name, "matrix", 6) == 0 && n == 6) {
        memcpy(out, q, 6 * sizeof *q);
    } else if (length == 9 && memcmp(name, "translate", 9) == 0 && (n == 1 || n == 2)) {
        out[4] = q[0];
        out[5] = n == 2 ? q[1] : 0.0;
    } else if (length == 5 && memcmp(name, "scale", 5) == 0 && (n == 1 || n == 2)) {
        out[0] = q[0];
        out[3] = n == 2 ? q[1] : q[0];
    } else if (length == 6 && memcmp(name, "rotate", 6) == 0 && (n == 1 || n == 3)) {
        const double c = mus__cos(q[0] * MUS__DEGREE), s = mus__sin(q[0] * MUS__DEGREE);
        const double x = n == 3 ? q[1] : 0.0, y = n == 3 ? q[2] : 0.0;
        const double turn[6] = {c, s, -s, c, x - c * x + s * y, y - s * x - c * y};
        memcpy(out, turn, sizeof turn);
    } else {
        return false;
    }
    return true;
}


mus_status mus__svg_transform(const mus__source *source, int64_t line, const char *text, double *m)
{
    for (const char *at = text; skip_blanks(&at), *at != '\0';) {
        const size_t length = strspn(at, "abcdefghijklmnopqrstuvwxyzXY");
        const char *name = at;
        double q[6], own[6];
        int32_t n = 0;
        at += length;
        while (*at == ' ') at++;
        if (*at++ != '(') return mus__source_fail(source, line, MUS_ERR_FORMAT, "transform: expected NAME(numbers)");
        while (n < 6 && take_number(&at, &q[n])) n++;
        skip_blanks(&at);
        if (*at != ')' || !transform_of(name, length, n, q, own))
            return mus__source_fail(source, line, MUS_ERR_FORMAT,
                                    "transform: expected matrix, translate, scale or rotate with its numbers, got "
                                    "\"%.30s\"",
                                    name);
        at++;
        multiply(m, own);
    }
    return MUS_OK;
}
