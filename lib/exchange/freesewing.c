/*
 * freesewing.c: read a draft of FreeSewing, dumped as "freesewing-dump-1", as a pattern.
 *
 * A part of a dump is a set of named paths of lines and cubics, in millimetres, y down. Its outline is the path "seam",
 * or, without such a path, the first visible path of fabric, lining or interfacing that is not a seam allowance. A part
 * cut on the fold is drawn as a half. The half is unfolded at the straight segment of its outline on the fold line, and
 * the outline then runs counter-clockwise. A dump does not say which edges are sewn together, so the caller adds the
 * seams. Edges end where the outline turns by more than 15 degrees. They are named by the points at their ends
 * ("hps-shoulder"); the mirrored half adds "_m".
 *
 * Snippets: notch is a single notch and bnotch a double one, at the nearest point of the outline. Snippets off the
 * outline (buttons, buttonholes, eyelets) are marks; logos are left out. A fold without a grain line is the grain.
 * Source of the form: the data's own description; FreeSewing 4 (freesewing.org).
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/json_path.h"
#include "exchange/pattern_readers.h"

#define FS_MILLIMETRE 1e-3  /* [m] unit of the file */
#define FS_PIECES_MOST 4096 /* most segments of an outline in the file; chosen: bounds memory and time */
#define FS_TINY 1e-9        /* [m] a shorter segment is left out; chosen: far below any drawing */
#define FS_GAP 1e-6         /* [m] largest gap between two segments; chosen: the rounding of the file */
#define FS_ON_FOLD 1e-5     /* [m] a point nearer to the fold line is on it; chosen: above the rounding of a dump */
/* [m] a notch nearer to the outline is on it; chosen: above the rounding of a dump, below the width of a line */
#define FS_ON_EDGE 1e-4
#define FS_CORNER 0.96593   /* a corner turns by more than this cosine: 15 degrees. Chosen */
/* points of an edge tried in each round of the search for a notch; chosen: fewer could miss the nearest part of a
 * curve */
#define FS_SAMPLES 48
/* rounds of the search, each 24 times finer than the last; chosen: the place is right to 1e-7 of the edge */
#define FS_ROUNDS 5

/* a segment of the outline: start, control points of a cubic, end [m], y up */
struct fs_piece {
    int32_t kind;
    double p[8];
};

struct fs_part {
    const mus__json_at *at;
    mus_pattern *pattern;
    int32_t panel;
    struct fs_piece *piece; /* (3 room); the last third is scratch for unfolding and reversing */
    int32_t n, room;
    bool folded;
    double fold[4]; /* a point of the fold line [m], and its direction, a unit vector */
};


/* read a point in millimetres, y down, as metres, y up */
static mus_status fs_point(const mus__json_at *at, double *out)
{
    const mus_status status = mus__json_numbers(at, 2, out);
    out[0] *= FS_MILLIMETRE;
    out[1] *= -FS_MILLIMETRE;
    return status;
}


static mus_status fs_member_point(const mus__json_at *at, const char *key, double *out)
{
    const mus__json_at member = mus__json_member(at, key);
    return fs_point(&member, out);
}


static const double *fs_end(const struct fs_piece *piece)
{
    return piece->p + (piece->kind == MUS_PIECE_CUBIC ? 6 : 2);
}


static double fs_far(const double *a, const double *b)
{
    return mus__hypot(a[0] - b[0], a[1] - b[1]);
}


/* ---- the outline as the file has it ---- */

static mus_status fs_segment(struct fs_part *part, const mus__json_at *at)
{
    const char *type;
    struct fs_piece piece = {.kind = MUS_PIECE_LINE};
    const mus__json_at which = mus__json_member(at, "type");
    mus_status status = mus__json_text(&which, &type);
    if (status != MUS_OK) return status;
    if (strcmp(type, "cubic") == 0)
        piece.kind = MUS_PIECE_CUBIC;
    else if (strcmp(type, "line") != 0)
        return mus__json_fail(&which, MUS_ERR_FORMAT, "expected line or cubic, got \"%.40s\"", type);
    status = fs_member_point(at, "from", piece.p);
    if (status == MUS_OK && piece.kind == MUS_PIECE_CUBIC) status = fs_member_point(at, "cp1", piece.p + 2);
    if (status == MUS_OK && piece.kind == MUS_PIECE_CUBIC) status = fs_member_point(at, "cp2", piece.p + 4);
    if (status == MUS_OK) status = fs_member_point(at, "to", piece.p + (piece.kind == MUS_PIECE_CUBIC ? 6 : 2));
    if (status != MUS_OK) return status;
    if (part->n > 0 && fs_far(fs_end(&part->piece[part->n - 1]), piece.p) > FS_GAP)
        return mus__json_fail(at, MUS_ERR_FORMAT, "starts %g mm from where the outline was, expected no gap",
                              fs_far(fs_end(&part->piece[part->n - 1]), piece.p) / FS_MILLIMETRE);
    if (fs_far(piece.p, fs_end(&piece)) > FS_TINY) part->piece[part->n++] = piece;
    return MUS_OK;
}


/* true when `word` is one of the words of `text` */
static bool fs_has_word(const char *text, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = strstr(text, word); at != NULL; at = strstr(at + 1, word)) {
        const bool starts = at == text || at[-1] == ' ';
        if (starts && (at[length] == ' ' || at[length] == '\0')) return true;
    }
    return false;
}


/* find the path that is the outline of a part; its json is NULL when there is none */
static mus__json_at fs_outline_path(const mus__json_at *paths)
{
    mus__json_at found = mus__json_member(paths, "seam");
    if (found.json != NULL) return found;
    for (void *i = json_object_iter((json_t *)(uintptr_t)paths->json); i != NULL;
         i = json_object_iter_next((json_t *)(uintptr_t)paths->json, i)) {
        const json_t *path = json_object_iter_value(i);
        const char *words = json_string_value(json_object_get(path, "class"));
        if (words == NULL || json_is_true(json_object_get(path, "hidden")) || fs_has_word(words, "sa")) continue;
        if (fs_has_word(words, "fabric") || fs_has_word(words, "lining") || fs_has_word(words, "interfacing"))
            return mus__json_member(paths, json_object_iter_key(i));
    }
    return found;
}


static mus_status fs_outline(struct fs_part *part)
{
    const mus__json_at paths = mus__json_member(part->at, "paths");
    mus_status status = mus__json_expect(&paths, JSON_OBJECT);
    if (status != MUS_OK) return status;
    const mus__json_at path = fs_outline_path(&paths);
    if (path.json == NULL)
        return mus__json_fail(&paths, MUS_ERR_FORMAT, "expected a path \"seam\" or a visible path of fabric, got none");
    size_t count;
    const mus__json_at segments = mus__json_member(&path, "segments");
    status = mus__json_array(&segments, 1, FS_PIECES_MOST, &count);
    if (status != MUS_OK) return status;
    part->room = (int32_t)count + 1;
    mus_context *context = part->at->source->context;
    part->piece = mus_context_alloc(context, NULL, 3 * (size_t)part->room * sizeof *part->piece);
    if (part->piece == NULL) return mus__json_fail(&segments, MUS_ERR_MEMORY, "no memory for %zu segments", count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        const mus__json_at segment = mus__json_element(&segments, i);
        status = fs_segment(part, &segment);
    }
    if (status == MUS_OK && (part->n < 2 || fs_far(fs_end(&part->piece[part->n - 1]), part->piece[0].p) > FS_GAP))
        status = mus__json_fail(&path, MUS_ERR_FORMAT, "expected a closed outline");
    return status;
}


/* ---- unfolded, and counter-clockwise ---- */

/* mirror image of a point in the fold line */
static void fs_mirror(const double *fold, const double *p, double *out)
{
    const double rx = p[0] - fold[0], ry = p[1] - fold[1], along = rx * fold[2] + ry * fold[3];
    out[0] = fold[0] + 2.0 * along * fold[2] - rx;
    out[1] = fold[1] + 2.0 * along * fold[3] - ry;
}


static void fs_turn_round(const struct fs_piece *piece, struct fs_piece *out)
{
    const int32_t points = piece->kind == MUS_PIECE_CUBIC ? 4 : 2;
    out->kind = piece->kind;
    for (int32_t i = 0; i < points; i++) memcpy(out->p + 2 * i, piece->p + 2 * (points - 1 - i), 2 * sizeof *out->p);
}


static bool fs_on_fold(const double *fold, const double *p)
{
    return fabs((p[0] - fold[0]) * fold[3] - (p[1] - fold[1]) * fold[2]) <= FS_ON_FOLD;
}


/* remove the longest straight segment on the fold line, and append the mirror image of the rest */
static mus_status fs_unfold(struct fs_part *part, const mus__json_at *at)
{
    double end[2], longest = 0.0;
    mus_status status = fs_member_point(at, "from", part->fold);
    if (status == MUS_OK) status = fs_member_point(at, "to", end);
    if (status != MUS_OK) return status;
    const double length = fs_far(part->fold, end);
    if (!(length > FS_TINY)) return mus__json_fail(at, MUS_ERR_FORMAT, "expected a fold line, got a point");
    for (int32_t d = 0; d < 2; d++) part->fold[2 + d] = (end[d] - part->fold[d]) / length;

    int32_t gone = MUS_NONE;
    for (int32_t i = 0; i < part->n; i++) {
        const struct fs_piece *piece = &part->piece[i];
        const double wide = fs_far(piece->p, fs_end(piece));
        if (piece->kind != MUS_PIECE_LINE || wide <= longest || !fs_on_fold(part->fold, piece->p) ||
            !fs_on_fold(part->fold, fs_end(piece)))
            continue;
        longest = wide;
        gone = i;
    }
    if (gone == MUS_NONE)
        return mus__json_fail(at, MUS_ERR_FORMAT, "expected a straight piece of the outline on the fold, got none");

    /* move the ends onto the fold line, so that both halves meet exactly */
    const int32_t half = part->n - 1;
    struct fs_piece *to = part->piece + 2 * (size_t)part->room;
    for (int32_t i = 0; i < half; i++) to[i] = part->piece[(gone + 1 + i) % part->n];
    double *ends[2] = {to[0].p, to[half - 1].p + (to[half - 1].kind == MUS_PIECE_CUBIC ? 6 : 2)};
    for (int32_t e = 0; e < 2; e++) {
        double image[2];
        fs_mirror(part->fold, ends[e], image);
        for (int32_t d = 0; d < 2; d++) ends[e][d] = 0.5 * (ends[e][d] + image[d]);
    }
    memcpy(part->piece, to, (size_t)half * sizeof *to);
    for (int32_t i = 0; i < half; i++) {
        struct fs_piece *image = &part->piece[half + i];
        fs_turn_round(&to[half - 1 - i], image);
        for (int32_t k = 0; k < 4; k++) {
            double p[2];
            fs_mirror(part->fold, image->p + 2 * k, p);
            memcpy(image->p + 2 * k, p, sizeof p);
        }
    }
    part->n = 2 * half;
    part->folded = true;
    return MUS_OK;
}


/* twice the signed area of the polygon of ends and control points [m2]; positive: counter-clockwise */
static double fs_winding(const struct fs_part *part)
{
    double sum = 0.0;
    for (int32_t i = 0; i < part->n; i++) {
        const struct fs_piece *piece = &part->piece[i];
        const int32_t last = piece->kind == MUS_PIECE_CUBIC ? 3 : 1;
        for (int32_t k = 0; k < last; k++) {
            const double *a = piece->p + 2 * k, *b = a + 2;
            sum += a[0] * b[1] - a[1] * b[0];
        }
    }
    return sum;
}


static void fs_counter_clockwise(struct fs_part *part)
{
    if (fs_winding(part) >= 0.0) return;
    for (int32_t i = 0, j = part->n - 1; i <= j; i++, j--) {
        struct fs_piece first, last;
        fs_turn_round(&part->piece[i], &first);
        fs_turn_round(&part->piece[j], &last);
        part->piece[i] = last;
        part->piece[j] = first;
    }
}


/* ---- edges ---- */

/* true when the outline has a corner before segment i */
static bool fs_corner(const struct fs_part *part, int32_t i)
{
    const struct fs_piece *in = &part->piece[(i + part->n - 1) % part->n], *out = &part->piece[i];
    double a[2] = {0, 0}, b[2] = {0, 0};
    const int32_t last = in->kind == MUS_PIECE_CUBIC ? 3 : 1, end = out->kind == MUS_PIECE_CUBIC ? 3 : 1;
    for (int32_t k = last - 1; k >= 0 && mus__hypot(a[0], a[1]) <= FS_TINY; k--)
        for (int32_t d = 0; d < 2; d++) a[d] = in->p[2 * last + d] - in->p[2 * k + d];
    for (int32_t k = 1; k <= end && mus__hypot(b[0], b[1]) <= FS_TINY; k++)
        for (int32_t d = 0; d < 2; d++) b[d] = out->p[2 * k + d] - out->p[d];
    return a[0] * b[0] + a[1] * b[1] < FS_CORNER * mus__hypot(a[0], a[1]) * mus__hypot(b[0], b[1]);
}


/* name of the draft's point at p, or that of the point at the mirror image of p with "_m", or "". out (64) */
static void fs_name_of(const struct fs_part *part, const double *p, char *out)
{
    const mus__json_at points = mus__json_member(part->at, "points");
    double image[2] = {p[0], p[1]};
    out[0] = '\0';
    if (part->folded) fs_mirror(part->fold, p, image);
    for (void *i = json_object_iter((json_t *)(uintptr_t)points.json); i != NULL;
         i = json_object_iter_next((json_t *)(uintptr_t)points.json, i)) {
        const char *name = json_object_iter_key(i);
        const mus__json_at point = mus__json_member(&points, name);
        double place[2];
        if (name[0] == '_' || strlen(name) > 56 || !json_is_array(point.json) || fs_point(&point, place) != MUS_OK)
            continue;
        const bool here = fs_far(place, p) <= FS_GAP;
        if (!here && (out[0] != '\0' || !part->folded || fs_far(place, image) > FS_GAP)) continue;
        memcpy(out, name, strlen(name) + 1);
        if (!here) memcpy(out + strlen(name), "_m", 3);
        if (here) return;
    }
}


/* make one edge of the segments first .. first + count - 1 (cyclic), from point a to point b of the pattern */
static mus_status fs_edge(struct fs_part *part, int32_t first, int32_t count, int32_t a, int32_t b, int32_t *out)
{
    mus_context *context = part->at->source->context;
    int32_t nxy = 0;
    double *xy = mus_context_alloc(context, NULL, (size_t)count * (6 * sizeof *xy + sizeof(int32_t)));
    if (xy == NULL) return mus__json_fail(part->at, MUS_ERR_MEMORY, "no memory for an edge");
    int32_t *kinds = (int32_t *)(xy + 6 * (size_t)count);
    for (int32_t i = 0; i < count; i++) {
        const struct fs_piece *piece = &part->piece[(first + i) % part->n];
        const int32_t points = (piece->kind == MUS_PIECE_CUBIC ? 3 : 1) - (i + 1 == count);
        kinds[i] = piece->kind;
        memcpy(xy + 2 * (size_t)nxy, piece->p + 2, 2 * (size_t)points * sizeof *xy);
        nxy += points;
    }

    char name[160] = "", end[64];
    fs_name_of(part, part->piece[first].p, name);
    fs_name_of(part, fs_end(&part->piece[(first + count - 1) % part->n]), end);
    const size_t length = strlen(name);
    name[length] = '-';
    memcpy(name + length + 1, end, strlen(end) + 1);
    const bool named = length > 0 && end[0] != '\0';
    mus_status status = mus_pattern_add_edge(part->pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                            .name = named ? name : NULL,
                                                                            .start = a, .end = b, .npiece = count,
                                                                            .kinds = kinds, .nxy = nxy,
                                                                            .xy = nxy > 0 ? xy : NULL}, out);
    if (status != MUS_OK) status = mus__json_wrap(part->at, status);
    mus_context_alloc(context, xy, 0);
    return status;
}


/* make a point at each corner, an edge between each two, and the outline */
static mus_status fs_edges(struct fs_part *part)
{
    mus_context *context = part->at->source->context;
    const int32_t n = part->n;
    int32_t corners = 0;
    int32_t *work = mus_context_alloc(context, NULL, 4 * (size_t)n * sizeof *work);
    if (work == NULL) return mus__json_fail(part->at, MUS_ERR_MEMORY, "no memory for %d edges", (int)n);
    int32_t *corner = work, *point = work + n, *edge = work + 2 * n, *forward = work + 3 * n;
    for (int32_t i = 0; i < n; i++)
        if (fs_corner(part, i)) corner[corners++] = i;

    /* an edge has two ends: an outline without corners is split at its first segment and half way round */
    if (corners == 0) corner[corners++] = 0;
    if (corners == 1) {
        corner[1] = (corner[0] + n / 2) % n;
        corners = 2;
        if (corner[1] < corner[0]) {
            const int32_t low = corner[1];
            corner[1] = corner[0];
            corner[0] = low;
        }
    }
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < corners && status == MUS_OK; i++) {
        const double *p = part->piece[corner[i]].p;
        status = mus_pattern_add_point(part->pattern, part->panel, p[0], p[1], &point[i]);
        if (status != MUS_OK) status = mus__json_wrap(part->at, status);
    }
    for (int32_t i = 0; i < corners && status == MUS_OK; i++) {
        const int32_t next = (i + 1) % corners, count = (corner[next] - corner[i] + n) % n;
        status = fs_edge(part, corner[i], count, point[i], point[next], &edge[i]);
        forward[i] = 1;
    }
    if (status == MUS_OK) {
        status = mus_pattern_set_outline(part->pattern, part->panel, corners, edge, forward);
        if (status != MUS_OK) status = mus__json_wrap(part->at, status);
    }
    mus_context_alloc(context, work, 0);
    return status;
}


/* ---- marks, grain, cut ---- */

/* point of an edge nearest to p: its arc length s [m]; returns its distance from p [m] */
static double fs_nearest(const mus_pattern *pattern, int32_t edge, const double *p, double *s)
{
    double t[FS_SAMPLES + 1], xy[2 * (FS_SAMPLES + 1)], low = 0.0, high = 1.0, far = INFINITY;
    const double length = mus_pattern_edge_length(pattern, edge);
    for (int32_t round = 0; round < FS_ROUNDS; round++) {
        int32_t best = 0;
        for (int32_t i = 0; i <= FS_SAMPLES; i++) t[i] = low + (high - low) * i / FS_SAMPLES;
        if (mus_pattern_edge_at(pattern, edge, FS_SAMPLES + 1, t, xy) != MUS_OK) return INFINITY;
        far = INFINITY;
        for (int32_t i = 0; i <= FS_SAMPLES; i++) {
            const double d = fs_far(xy + 2 * i, p);
            if (d >= far) continue;
            far = d;
            best = i;
        }
        *s = t[best] * length;
        if (far > (high - low) * length) return far;
        low = t[best > 0 ? best - 1 : 0];
        high = t[best < FS_SAMPLES ? best + 1 : FS_SAMPLES];
    }
    return far;
}


/* add a notch when p is on the outline, else a mark */
static mus_status fs_mark(const struct fs_part *part, const char *type, const double *p)
{
    const bool back = strcmp(type, "bnotch") == 0, notch = back || strcmp(type, "notch") == 0;
    int32_t n, nearest = MUS_NONE;
    const int32_t *edges;
    double least = FS_ON_EDGE, at = 0.0;
    mus_status status = mus_pattern_outline(part->pattern, part->panel, &n, &edges, NULL);
    for (int32_t i = 0; i < n && notch && status == MUS_OK; i++) {
        double s;
        const double far = fs_nearest(part->pattern, edges[i], p, &s);
        if (far >= least) continue;
        least = far;
        nearest = edges[i];
        at = s;
    }
    if (status == MUS_OK)
        status = nearest != MUS_NONE ? mus_pattern_add_notch(part->pattern, nearest, at,
                                                             back ? MUS_NOTCH_DOUBLE : MUS_NOTCH_SINGLE, NULL)
                                     : mus_pattern_add_mark(part->pattern, part->panel, type, 1, p, NULL);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(part->at, status);
}


static mus_status fs_snippets(const struct fs_part *part)
{
    size_t count;
    const mus__json_at list = mus__json_member(part->at, "snippets");
    if (list.json == NULL) return MUS_OK;
    mus_status status = mus__json_array(&list, 0, FS_PIECES_MOST, &count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        const char *type;
        double p[2], image[2];
        const mus__json_at one = mus__json_element(&list, i), which = mus__json_member(&one, "type");
        status = mus__json_text(&which, &type);
        if (status == MUS_OK) status = fs_member_point(&one, "at", p);
        if (status != MUS_OK || strcmp(type, "logo") == 0) continue;
        status = fs_mark(part, type, p);
        if (status != MUS_OK || !part->folded || fs_on_fold(part->fold, p)) continue;
        fs_mirror(part->fold, p, image);
        status = fs_mark(part, type, image);
    }
    return status;
}


static mus_status fs_grain(const struct fs_part *part)
{
    double way[2] = {0.0, 1.0}, from[2], to[2];
    const mus__json_at line = mus__json_member(part->at, "grainline");
    if (line.json != NULL && !json_is_null(line.json)) {
        mus_status status = fs_member_point(&line, "from", from);
        if (status == MUS_OK) status = fs_member_point(&line, "to", to);
        if (status != MUS_OK) return status;
        for (int32_t d = 0; d < 2; d++) way[d] = to[d] - from[d];
    } else if (part->folded) {
        memcpy(way, part->fold + 2, sizeof way);
    }

    /* the grain line of the file may point either way; the pattern's points upwards */
    const double turn = way[1] < 0.0 || (way[1] == 0.0 && way[0] < 0.0) ? -1.0 : 1.0;
    const mus_status status = mus_pattern_set_grain(part->pattern, part->panel, turn * way[0], turn * way[1]);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(part->at, status);
}


/* set the number of copies and the material, which is fabric when fabric is among the materials */
static mus_status fs_cut(const struct fs_part *part)
{
    size_t count;
    int32_t pieces = 1, times;
    const char *label = "", *material;
    const mus__json_at list = mus__json_member(part->at, "cuts");
    if (list.json == NULL) return MUS_OK;
    mus_status status = mus__json_array(&list, 0, FS_PIECES_MOST, &count);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        const mus__json_at one = mus__json_element(&list, i), of = mus__json_member(&one, "material"),
                          much = mus__json_member(&one, "cut");
        status = mus__json_text(&of, &material);
        if (status == MUS_OK) status = mus__json_integer(&much, 1, 1000, &times);
        if (status != MUS_OK || (label[0] != '\0' && strcmp(material, "fabric") != 0)) continue;
        label = material;
        pieces = times;
    }
    if (status != MUS_OK) return status;
    status = mus_pattern_set_panel_label(part->pattern, part->panel, label);
    if (status == MUS_OK) status = mus_pattern_set_cut(part->pattern, part->panel, pieces, MUS_NONE);
    return status == MUS_OK ? MUS_OK : mus__json_wrap(part->at, status);
}


static mus_status fs_read_part(mus_pattern *pattern, const mus__json_at *at)
{
    const char *name;
    struct fs_part part = {.at = at, .pattern = pattern};
    const mus__json_at which = mus__json_member(at, "name"), fold = mus__json_member(at, "on_fold");
    mus_status status = mus__json_text(&which, &name);
    if (status != MUS_OK) return status;
    status = mus_pattern_add_panel(pattern, name, &part.panel);
    if (status != MUS_OK) return mus__json_wrap(&which, status);
    status = fs_outline(&part);
    if (status == MUS_OK && fold.json != NULL && !json_is_null(fold.json)) status = fs_unfold(&part, &fold);
    if (status == MUS_OK) {
        fs_counter_clockwise(&part);
        status = fs_edges(&part);
    }
    if (status == MUS_OK) status = fs_snippets(&part);
    if (status == MUS_OK) status = fs_grain(&part);
    if (status == MUS_OK) status = fs_cut(&part);
    mus_context_alloc(at->source->context, part.piece, 0);
    return status;
}


mus_status mus__pattern_read_freesewing(const mus__json_at *root, mus_pattern *pattern)
{
    const char *text;
    size_t count = 0;
    const mus__json_at units = mus__json_member(root, "units"), down = mus__json_member(root, "y_axis"),
                      parts = mus__json_member(root, "parts"), name = mus__json_member(root, "design");
    mus_status status = mus__json_text(&units, &text);
    if (status == MUS_OK && strcmp(text, "mm") != 0)
        status = mus__json_fail(&units, MUS_ERR_UNSUPPORTED, "expected \"mm\", got \"%.40s\"", text);
    if (status == MUS_OK) status = mus__json_text(&down, &text);
    if (status == MUS_OK && strcmp(text, "down") != 0)
        status = mus__json_fail(&down, MUS_ERR_UNSUPPORTED, "expected \"down\", got \"%.40s\"", text);
    if (status == MUS_OK) status = mus__json_array(&parts, 1, MUS__FILE_PANELS_MAX, &count);
    if (status == MUS_OK && name.json != NULL) {
        status = mus__json_text(&name, &text);
        if (status == MUS_OK) status = mus_pattern_set_name(pattern, text);
    }
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        const mus__json_at part = mus__json_element(&parts, i);
        status = mus__json_expect(&part, JSON_OBJECT);
        if (status == MUS_OK) status = fs_read_part(pattern, &part);
    }
    return status;
}
