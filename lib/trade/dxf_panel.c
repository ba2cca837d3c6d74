/*
 * dxf_panel.c: a block of a DXF as a panel: outline with edges and allowances, grain, notches, marks, quantity.
 *
 * The outline is the sew line where the file has one that goes round inside the cut line: layer 14 (or its copy 87),
 * or, as Valentina writes AAMA, the first closed polyline of layer 8. Else it is the boundary of layer 1 (or its copy
 * 84), which is then cut as it is, without allowance. The allowance of an edge is its distance from the cut line.
 *
 * A notch is a point (with its angle inwards, or square to the edge) or a line from the cut line inwards; it goes to
 * the place of the sew line that it points at. Two or three of them side by side are one double or triple notch.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "trade/dxf_panel.h"
#include "base/elementary.h"
#include "base/sort.h"

#define ALLOWANCE_LAYER_8 0.05   /* [m] the same of a line of layer 8, which may be a pocket; chosen: a deep hem */
#define NOTCH_ASIDE 0.0065       /* [m] slits this near are one notch; chosen: a quarter inch, the trade's distance */
#define TEXT_NEAR 5e-4           /* [m] a text this near to a mark is its name; chosen: files round to 0.01 mm */
#define MARKS_MOST 5000          /* most marks, and most notches, of a piece; chosen: bounds the time a file can take */

typedef struct dxf_slit {
    int32_t edge; /* in the order of the outline */
    double s;     /* [m] from the start of the edge in the wanted size */
} dxf_slit;

typedef struct dxf_panel {
    mus__dxf_job *job;
    const mus__dxf_file *file;
    const mus__dxf_block *block;
    mus__ring ring;    /* outline */
    mus__ring cut;     /* boundary of layer 1; n is 0 when the outline is it */
    double axis[4];    /* mirror line of a folded piece */
    bool folded;
    bool reflected;    /* places are read as their images in the mirror line */
    bool mirrored;     /* the panel is the image in x = 0 */
    int32_t sewn_line; /* entity of layer 8 that is the sew line, or MUS_NONE */
    int32_t panel;
    int32_t nedge;
    int32_t *starts;   /* (nedge) point of the ring at which each edge starts */
    int32_t *edges;    /* (nedge) index in the pattern */
    dxf_slit *slits;
    int32_t nslit, slit_room;
} dxf_panel;


static mus_status panel_wrap(const dxf_panel *p, mus_status status)
{
    return status == MUS_OK ? MUS_OK : mus__source_wrap(p->file->source, p->block->line, status);
}


static void panel_place(const dxf_panel *p, const mus__dxf_entity *entity, int32_t i, double *out)
{
    for (int32_t k = 0; k < 2; k++) out[k] = p->file->unit * p->file->xy[2 * (size_t)(entity->first + i) + (size_t)k];
    if (p->reflected) mus__ring_mirror(p->axis, out);
}


/* a direction in the place of its image, as panel_place() takes places */
static void panel_turn(const dxf_panel *p, double *d)
{
    double tip[2] = {p->axis[0] + d[0], p->axis[1] + d[1]};
    if (!p->reflected) return;
    mus__ring_mirror(p->axis, tip);
    for (int32_t k = 0; k < 2; k++) d[k] = tip[k] - p->axis[k];
}


/* true where the other half of a folded piece has an image of an entity: one of its ends lies off the mirror line */
static bool panel_has_image(const dxf_panel *p, const mus__dxf_entity *entity)
{
    bool off = false;
    for (int32_t i = 0; i < entity->n && p->folded; i += entity->n > 1 ? entity->n - 1 : 1) {
        double at[2], image[2];
        panel_place(p, entity, i, at);
        memcpy(image, at, sizeof image);
        mus__ring_mirror(p->axis, image);
        off = off || mus__hypot(image[0] - at[0], image[1] - at[1]) > TEXT_NEAR;
    }
    return off;
}


/* ---- outline ---- */

/* true when the ring lies inside the cut line's box, by at most `most` [m] on each side */
static bool ring_inside(const mus__ring *ring, const mus__ring *cut, double most)
{
    double box[4], outer[4];
    if (ring->n == 0) return false;
    mus__ring_box(ring, box);
    mus__ring_box(cut, outer);
    bool inside = true;
    for (int32_t k = 0; k < 2; k++) {
        const double low = box[k] - outer[k], high = outer[2 + k] - box[2 + k];
        inside = inside && low > -1e-4 && low < most && high > -1e-4 && high < most;
    }
    return inside;
}


bool mus__dxf_is_piece(const mus__dxf_file *file, const mus__dxf_block *block)
{
    if (block->name.length > 0 && (*block->name.at == '$' || *block->name.at == '*')) return false;
    for (int32_t i = block->first; i < block->first + block->n; i++) {
        const mus__dxf_entity *entity = &file->entities[i];
        const bool line = entity->kind == MUS__DXF_LINE || entity->kind == MUS__DXF_POLYLINE;
        if (line && entity->n > 0 && (entity->layer == 1 || entity->layer == 84)) return true;
    }
    return false;
}


/* the sew line: layer 14, its copy 87, or Valentina's on layer 8 */
static mus_status panel_sew(dxf_panel *p)
{
    static const int32_t layers[2] = {14, 87};
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < 2 && status != MUS_ERR_MEMORY; i++) {
        status = mus__ring_make(p->file, p->block, layers[i], MUS_NONE, &p->ring);
        if (status == MUS_OK && ring_inside(&p->ring, &p->cut, MUS__ALLOWANCE_MOST)) return MUS_OK;
        p->ring.n = 0;
    }
    for (int32_t i = p->block->first; i < p->block->first + p->block->n && status != MUS_ERR_MEMORY; i++) {
        const mus__dxf_entity *entity = &p->file->entities[i];
        if (entity->layer != 8 || entity->kind != MUS__DXF_POLYLINE || !entity->closed) continue;
        p->ring.n = 0;
        status = mus__ring_make(p->file, p->block, 8, i, &p->ring);
        if (status == MUS_OK && ring_inside(&p->ring, &p->cut, ALLOWANCE_LAYER_8)) p->sewn_line = i;
        else p->ring.n = 0;
        break; /* those behind it are lines inside */
    }
    return status == MUS_ERR_MEMORY ? status : MUS_OK;
}


static mus_status panel_outline(dxf_panel *p)
{
    mus_status status = mus__ring_make(p->file, p->block, 1, MUS_NONE, &p->cut);
    if (status == MUS_OK && p->cut.n == 0) status = mus__ring_make(p->file, p->block, 84, MUS_NONE, &p->cut);
    if (status != MUS_OK) return status;
    if (p->cut.n == 0)
        return mus__source_fail(p->file->source, p->block->line, MUS_ERR_FORMAT,
                                "the outline on layer 1 has fewer than three points");
    status = panel_sew(p);
    if (status != MUS_OK) return status;
    if (p->ring.n == 0) {
        const mus__ring swap = p->ring;
        p->ring = p->cut;
        p->cut = swap;
    }
    mus__ring_turns(p->file, p->block, &p->ring);
    const mus__dxf_job *job = p->job;
    if (job->rules != NULL) status = mus__ring_grade(p->file, p->block, job->rules, job->size, &p->ring);
    bool folded;
    double axis[4];
    if (status == MUS_OK) status = mus__ring_unfold(p->file, p->block, &p->ring, p->axis, &p->folded);
    if (status == MUS_OK && p->cut.n > 0) status = mus__ring_unfold(p->file, p->block, &p->cut, axis, &folded);
    if (status == MUS_OK && p->ring.n < 3)
        return mus__source_fail(p->file->source, p->block->line, MUS_ERR_FORMAT, "the mirrored outline has no area");
    if (status == MUS_OK) mus__ring_orient(&p->ring);
    return status;
}


/* ---- cells ---- */

/* a place of the ring in the plane of the panel, in the wanted size */
static void panel_point(const dxf_panel *p, int32_t i, double *out)
{
    const mus__ring_point *point = &p->ring.points[(i % p->ring.n + p->ring.n) % p->ring.n];
    out[0] = p->mirrored ? -point->moved[0] : point->moved[0];
    out[1] = point->moved[1];
}


/* the edges start at the turn points; an image runs the other way round */
static mus_status panel_starts(dxf_panel *p)
{
    for (int32_t i = 0; i < p->ring.n; i++) p->nedge += p->ring.points[i].turn;
    const size_t bytes = (size_t)p->nedge * sizeof *p->starts;
    p->starts = mus_context_alloc(p->file->source->context, NULL, bytes);
    p->edges = mus_context_alloc(p->file->source->context, NULL, 2 * bytes);
    if (p->starts == NULL || p->edges == NULL)
        return mus__source_fail(p->file->source, p->block->line, MUS_ERR_MEMORY, "no memory for %d edges", p->nedge);
    for (int32_t i = 0, k = 0; i < p->ring.n; i++)
        if (p->ring.points[i].turn) p->starts[k++] = i;
    return MUS_OK;
}


/* number of sides of the ring in edge k */
static int32_t panel_sides(const dxf_panel *p, int32_t k)
{
    const int32_t n = p->ring.n;
    return (p->starts[(k + 1) % p->nedge] - p->starts[k] + n - 1) % n + 1;
}


static mus_status panel_edge(dxf_panel *p, int32_t k, int32_t start, int32_t end)
{
    const int32_t n = panel_sides(p, k);
    mus_context *context = p->file->source->context;
    mus_edge_def def;
    mus_edge_def_init(&def, sizeof def);
    int32_t *kinds = mus_context_alloc(context, NULL, (size_t)n * sizeof *kinds);
    double *xy = mus_context_alloc(context, NULL, 2 * (size_t)n * sizeof *xy);
    mus_status status = MUS_OK;
    if (kinds == NULL || xy == NULL)
        status = mus__source_fail(p->file->source, p->block->line, MUS_ERR_MEMORY, "no memory for an edge");
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        kinds[i] = MUS_PIECE_LINE;
        if (i > 0) panel_point(p, p->starts[k] + i, xy + 2 * (i - 1));
    }
    def.start = start;
    def.end = end;
    def.npiece = n;
    def.nxy = n - 1;
    def.kinds = kinds;
    def.xy = xy;
    if (status == MUS_OK) status = panel_wrap(p, mus_pattern_add_edge(p->job->pattern, &def, &p->edges[k]));
    mus_context_alloc(context, kinds, 0);
    mus_context_alloc(context, xy, 0);
    return status;
}


static mus_status panel_cells(dxf_panel *p, const char *name)
{
    mus_pattern *pattern = p->job->pattern;
    int32_t first = MUS_NONE, *directions = p->edges + p->nedge;
    mus_status status = panel_wrap(p, mus_pattern_add_panel(pattern, name, &p->panel));
    for (int32_t k = 0; k < p->nedge && status == MUS_OK; k++) {
        double at[2];
        int32_t point;
        panel_point(p, p->starts[k], at);
        status = panel_wrap(p, mus_pattern_add_point(pattern, p->panel, at[0], at[1], &point));
        if (k == 0) first = point;
    }
    for (int32_t k = 0; k < p->nedge && status == MUS_OK; k++) {
        status = panel_edge(p, k, first + k, first + (k + 1) % p->nedge);
        directions[k] = 1;
    }
    /* the image is passed backwards, so that its outline too runs counter-clockwise */
    for (int32_t k = 0; k < p->nedge / 2 && p->mirrored && status == MUS_OK; k++) {
        const int32_t swap = p->edges[k];
        p->edges[k] = p->edges[p->nedge - 1 - k];
        p->edges[p->nedge - 1 - k] = swap;
    }
    for (int32_t k = 0; k < p->nedge && p->mirrored; k++) directions[k] = -1;
    if (status == MUS_OK)
        status = panel_wrap(p, mus_pattern_set_outline(pattern, p->panel, p->nedge, p->edges, directions));
    return status;
}


/* index in the pattern of edge k in the order of the ring */
static int32_t panel_edge_of(const dxf_panel *p, int32_t k)
{
    return p->edges[p->mirrored ? p->nedge - 1 - k : k];
}


/* the allowances of the edges; 0 without a cut line of its own */
static mus_status panel_allowances(dxf_panel *p)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < p->nedge && status == MUS_OK; k++) {
        double allowance = 0.0;
        if (p->cut.n > 0) allowance = mus__ring_allowance(&p->ring, p->starts[k], panel_sides(p, k), &p->cut);
        status = panel_wrap(p, mus_pattern_set_edge_allowance(p->job->pattern, panel_edge_of(p, k), allowance));
    }
    return status;
}


/* ---- notches ---- */

/* note the place of a slit: side `at` of the ring and its part */
static mus_status slit_add(dxf_panel *p, int32_t at, double part)
{
    int32_t k = p->nedge - 1;
    while (k > 0 && p->starts[k] > at) k--;
    if (p->starts[0] > at) k = p->nedge - 1;
    double s = 0.0;
    for (int32_t i = p->starts[k];; i = (i + 1) % p->ring.n) {
        const double *a = p->ring.points[i].moved, *b = p->ring.points[(i + 1) % p->ring.n].moved;
        const double d = mus__hypot(b[0] - a[0], b[1] - a[1]);
        s += i == at ? part * d : d;
        if (i == at) break;
    }
    if (p->nslit == MARKS_MOST)
        return mus__source_fail(p->file->source, p->block->line, MUS_ERR_LIMIT, "more than %d notches", MARKS_MOST);
    mus_status status = mus__source_reserve(p->file->source, &p->slits, &p->slit_room, (int64_t)p->nslit + 1,
                                           sizeof *p->slits);
    if (status == MUS_OK) p->slits[p->nslit++] = (dxf_slit){k, s};
    return status;
}


/* find the place of the sew line that a notch points at */
static mus_status slit_read(dxf_panel *p, const mus__dxf_entity *entity)
{
    static const double range[2] = {2e-3, 1.1 * MUS__ALLOWANCE_MOST};
    double at[2], d[2] = {0.0, 0.0}, part;
    int32_t side;
    panel_place(p, entity, 0, at);
    if (entity->kind == MUS__DXF_POINT && entity->angled) {
        d[0] = mus__cos(entity->angle * MUS__DEGREE);
        d[1] = mus__sin(entity->angle * MUS__DEGREE);
        panel_turn(p, d);
    } else if (entity->n > 1) {
        panel_place(p, entity, 1, d);
        const double length = mus__hypot(d[0] - at[0], d[1] - at[1]);
        for (int32_t k = 0; k < 2; k++) d[k] = length > 0.0 ? (d[k] - at[k]) / length : 0.0;
    }
    const bool points = d[0] != 0.0 || d[1] != 0.0;
    double far = range[1];
    const bool meets = points && mus__ring_meet(&p->ring, at, d, range, &side, &part);
    if (meets) far = mus__ring_away(&p->ring, side, part, at);
    const bool corner = points && mus__ring_corner(&p->ring, at, d, far, &side, &part);
    if (!corner && !meets) mus__ring_nearest(&p->ring, at, &side, &part);
    return slit_add(p, side, part);
}


static int by_edge(const void *a, const void *b)
{
    const dxf_slit *x = a, *y = b;
    if (x->edge != y->edge) return x->edge - y->edge;
    return x->s < y->s ? -1 : x->s > y->s;
}


/* length [m] of edge k in the wanted size */
static double panel_length(const dxf_panel *p, int32_t k)
{
    double length = 0.0;
    const int32_t n = panel_sides(p, k);
    for (int32_t i = p->starts[k]; i < p->starts[k] + n; i++) {
        const double *a = p->ring.points[i % p->ring.n].moved, *b = p->ring.points[(i + 1) % p->ring.n].moved;
        length += mus__hypot(b[0] - a[0], b[1] - a[1]);
    }
    return length;
}


/* a slit at the end of an edge goes to the edge beside, when that one has another slit of the same notch */
static void slit_share(dxf_panel *p, dxf_slit *slit)
{
    const double length = panel_length(p, slit->edge);
    const bool low = slit->s < TEXT_NEAR, high = slit->s > length - TEXT_NEAR;
    if (low == high) return;
    const int32_t beside = (slit->edge + (low ? p->nedge - 1 : 1)) % p->nedge;
    const double end = low ? panel_length(p, beside) : 0.0;
    bool own = false, other = false;
    for (int32_t i = 0; i < p->nslit; i++) {
        const dxf_slit *each = &p->slits[i];
        own = own || (each != slit && each->edge == slit->edge && fabs(each->s - slit->s) < NOTCH_ASIDE);
        other = other || (each->edge == beside && fabs(each->s - end) < NOTCH_ASIDE && fabs(each->s - end) > TEXT_NEAR);
    }
    if (other && !own) *slit = (dxf_slit){beside, end};
}


static mus_status panel_slits(dxf_panel *p)
{
    mus_status status = MUS_OK;
    for (int32_t i = p->block->first; i < p->block->first + p->block->n && status == MUS_OK; i++) {
        const mus__dxf_entity *entity = &p->file->entities[i];
        if (entity->layer != 4 || entity->kind == MUS__DXF_TEXT || entity->n < 1) continue;
        status = slit_read(p, entity);
        p->reflected = panel_has_image(p, entity);
        if (p->reflected && status == MUS_OK) status = slit_read(p, entity);
        p->reflected = false;
    }
    for (int32_t i = 0; i < p->nslit && status == MUS_OK; i++) slit_share(p, &p->slits[i]);
    if (p->nslit > 1) mus__sort(p->slits, (size_t)p->nslit, sizeof *p->slits, by_edge);
    return status;
}


static mus_status panel_notches(dxf_panel *p)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0, end; i < p->nslit && status == MUS_OK; i = end) {
        double sum = p->slits[i].s;
        for (end = i + 1; end < p->nslit && end < i + MUS_NOTCH_TRIPLE; end++) {
            if (p->slits[end].edge != p->slits[i].edge || p->slits[end].s - p->slits[end - 1].s > NOTCH_ASIDE) break;
            sum += p->slits[end].s;
        }
        const int32_t edge = panel_edge_of(p, p->slits[i].edge);
        const double length = mus_pattern_edge_length(p->job->pattern, edge), s = sum / (end - i);
        status = panel_wrap(p, mus_pattern_add_notch(p->job->pattern, edge, s > length ? length : s, end - i, NULL));
    }
    return status;
}


/* ---- marks and grain ---- */

/* point i of an entity in the plane of the panel: moved as the nearest vertex of the outline */
static void panel_mark_point(const dxf_panel *p, const mus__dxf_entity *entity, int32_t i, double *out)
{
    int32_t side;
    double part;
    panel_place(p, entity, i, out);
    if (p->job->rules != NULL) {
        mus__ring_nearest(&p->ring, out, &side, &part);
        const mus__ring_point *near = &p->ring.points[part < 0.5 ? side : (side + 1) % p->ring.n];
        for (int32_t k = 0; k < 2; k++) out[k] += near->moved[k] - near->xy[k];
    }
    if (p->mirrored) out[0] = -out[0];
}


/* the text beside a mark, on its layer; "" without one */
static void mark_name(const dxf_panel *p, const mus__dxf_entity *mark, char *out, size_t capacity)
{
    double at[2], where[2];
    panel_place(p, mark, 0, at);
    *out = '\0';
    for (int32_t i = p->block->first; i < p->block->first + p->block->n; i++) {
        const mus__dxf_entity *text = &p->file->entities[i];
        if (text->kind != MUS__DXF_TEXT || text->layer != mark->layer || text->n < 1) continue;
        panel_place(p, text, 0, where);
        if (mus__hypot(where[0] - at[0], where[1] - at[1]) < TEXT_NEAR) mus__dxf_copy(text->text, out, capacity);
    }
}


static mus_status mark_add(dxf_panel *p, const mus__dxf_entity *entity)
{
    const int32_t n = entity->n + (entity->closed ? 1 : 0);
    char name[128];
    mark_name(p, entity, name, sizeof name);
    double *xy = mus_context_alloc(p->file->source->context, NULL, 2 * (size_t)n * sizeof *xy);
    if (xy == NULL) return mus__source_fail(p->file->source, entity->line, MUS_ERR_MEMORY, "no memory for a mark");
    for (int32_t i = 0; i < n; i++) panel_mark_point(p, entity, i % entity->n, xy + 2 * i);
    mus_status status = mus_pattern_add_mark(p->job->pattern, p->panel, name, n, xy, NULL);
    mus_context_alloc(p->file->source->context, xy, 0);
    return panel_wrap(p, status);
}


/* true for a cut-out (11) beside the sew line: a hole that the allowance leaves where the sew line is near itself */
static bool mark_outside(const dxf_panel *p, const mus__dxf_entity *entity)
{
    double at[2];
    panel_place(p, entity, 0, at);
    return entity->layer == 11 && p->cut.n > 0 && !mus__ring_inside(&p->ring, at);
}


/* lines inside (8, or their copy 85 alone), cut-outs (11), drill points (13) */
static mus_status panel_marks(dxf_panel *p)
{
    int32_t count = 0, inner = 85;
    mus_status status = MUS_OK;
    for (int32_t i = p->block->first; i < p->block->first + p->block->n; i++)
        if (p->file->entities[i].layer == 8) inner = 8;
    for (int32_t i = p->block->first; i < p->block->first + p->block->n && status == MUS_OK; i++) {
        const mus__dxf_entity *entity = &p->file->entities[i];
        const bool point = entity->kind == MUS__DXF_POINT && entity->layer == 13;
        const bool line = (entity->kind == MUS__DXF_LINE || entity->kind == MUS__DXF_POLYLINE) && entity->n > 1 &&
                          (entity->layer == inner || entity->layer == 11);
        if ((!point && !line) || i == p->sewn_line || mark_outside(p, entity)) continue;
        if (++count > MARKS_MOST)
            return mus__source_fail(p->file->source, entity->line, MUS_ERR_LIMIT, "more than %d marks", MARKS_MOST);
        status = mark_add(p, entity);
        p->reflected = panel_has_image(p, entity);
        if (p->reflected && status == MUS_OK) status = mark_add(p, entity);
        p->reflected = false;
    }
    return status;
}


static mus_status panel_grain(dxf_panel *p)
{
    for (int32_t i = p->block->first; i < p->block->first + p->block->n; i++) {
        const mus__dxf_entity *entity = &p->file->entities[i];
        double a[2], b[2];
        if (entity->layer != 7 || entity->n < 2) continue;
        panel_place(p, entity, 0, a);
        panel_place(p, entity, entity->n - 1, b);
        const double dx = p->mirrored ? a[0] - b[0] : b[0] - a[0], dy = b[1] - a[1];
        if (mus__hypot(dx, dy) < 1e-6) continue;
        return panel_wrap(p, mus_pattern_set_grain(p->job->pattern, p->panel, dx, dy));
    }
    return MUS_OK;
}


/* ---- the panel ---- */

static mus_status panel_build(dxf_panel *p, const char *name)
{
    mus_pattern *pattern = p->job->pattern;
    char label[128];
    mus_status status = panel_cells(p, name);
    if (status == MUS_OK) status = panel_allowances(p);
    if (status == MUS_OK) status = panel_notches(p);
    if (status == MUS_OK) status = panel_grain(p);
    if (status == MUS_OK) status = panel_marks(p);
    const mus__dxf_slice category = mus__dxf_piece_value(p->file, p->block, "Category");
    if (status != MUS_OK || category.length <= 0) return status;
    mus__dxf_copy(category, label, sizeof label);
    return panel_wrap(p, mus_pattern_set_panel_label(pattern, p->panel, label));
}


static mus_status panel_pair(dxf_panel *p)
{
    mus_pattern *pattern = p->job->pattern;
    int32_t right, left;
    char name[128];
    mus__dxf_panel_name(p->job, p->block, name, sizeof name);
    mus__panel_name_free(pattern, name, sizeof name);
    mus__dxf_quantity(p->file, p->block, &right, &left);
    mus_status status = panel_build(p, name);
    const int32_t own = p->panel, all = right + left;
    if (status == MUS_OK) status = panel_wrap(p, mus_pattern_set_cut(pattern, own, all > 0 ? all : 1, MUS_NONE));
    if (status != MUS_OK || left == 0 || right == 0) return status;
    p->mirrored = true;
    mus__dxf_name_mirror(name, sizeof name);
    mus__panel_name_free(pattern, name, sizeof name);
    status = panel_build(p, name);
    if (status == MUS_OK) status = panel_wrap(p, mus_pattern_set_cut(pattern, p->panel, left, own));
    return status;
}


mus_status mus__dxf_panel(mus__dxf_job *job, const mus__dxf_block *block)
{
    dxf_panel p = {.job = job, .file = job->file, .block = block, .sewn_line = MUS_NONE};
    mus_context *context = job->file->source->context;
    mus_status status = panel_outline(&p);
    if (status == MUS_OK) status = panel_starts(&p);
    if (status == MUS_OK) status = panel_slits(&p);
    if (status == MUS_OK) status = panel_pair(&p);
    job->npiece++;
    mus__ring_free(context, &p.ring);
    mus__ring_free(context, &p.cut);
    mus_context_alloc(context, p.starts, 0);
    mus_context_alloc(context, p.edges, 0);
    mus_context_alloc(context, p.slits, 0);
    return status;
}
