/*
 * seam_facts.c: facts of the edges of a pattern, from which its seams are found.
 *
 * A panel is seen from its right side with the grain upwards: one whose outline runs clockwise is mirrored. Panels that
 * are mirror images of one another, or of themselves, give each edge its mirror image; names tell which where several
 * panels have one shape.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "seam/seam_find.h"
#include "base/elementary.h"
#include "base/sort.h"

#define FACTS_CHORDS 8 /* chords of a curve; chosen: directions at its ends are right within 0.1 rad */
#define OFF_CENTRE 0.05 /* half widths of a panel, an edge farther from its middle lies on one side; chosen */
#define INWARDS 0.4     /* cosine to the direction of the centre; chosen: side seams lean by 66 degrees at most */
#define MIRROR_LENGTH 3e-3 /* relative difference of images; chosen: above the rounding of files, below an ease */
#define MIRROR_ANGLE 0.05  /* [rad] the same of corners */
#define MIRROR_NORMAL 0.1  /* the same of normals */
#define FACTS_END 1e-4     /* [m] a notch this near to the end of its edge is at the end; above the rounding of files */

typedef struct facts_work {
    const mus_pattern *pattern;
    mus__seam_facts *facts;
    double *xy; /* (room x 2) polyline of an outline */
    int32_t room, nxy;
    int32_t *from; /* (edges + 1) first point of each edge of the panel */
} facts_work;


static void *facts_new(mus_context *context, int64_t count, size_t size)
{
    return mus_context_alloc(context, NULL, (size_t)(count > 0 ? count : 1) * size);
}


/* ---- names ---- */

static uint32_t text_hash(const char *text, size_t n)
{
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < n; i++) hash = (hash ^ (uint32_t)tolower((unsigned char)text[i])) * 16777619u;
    return hash;
}


static bool word_of_side(const char *word, size_t n)
{
    static const char *const sides[] = {"left", "right", "front", "back", "l", "r", "f", "b"};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        size_t k = 0;
        while (k < n && sides[i][k] == tolower((unsigned char)word[k])) k++;
        if (k == n && sides[i][k] == '\0') return true;
    }
    return false;
}


/* the part of a garment that a text names; of several words the first of the table decides. Letters between other
 * characters are a word. */
static int32_t role_named(const char *text)
{
    static const struct {
        const char *word;
        int32_t role;
    } words[] = {{"cuff", MUS__SEAM_ROLE_CUFF},     {"hood", MUS__SEAM_ROLE_HOOD},
                 {"collar", MUS__SEAM_ROLE_COLLAR}, {"neck", MUS__SEAM_ROLE_COLLAR},
                 {"ins", MUS__SEAM_ROLE_INSERT},    {"insert", MUS__SEAM_ROLE_INSERT},
                 {"godet", MUS__SEAM_ROLE_INSERT},  {"gusset", MUS__SEAM_ROLE_INSERT},
                 {"wb", MUS__SEAM_ROLE_BAND},       {"band", MUS__SEAM_ROLE_BAND},
                 {"waistband", MUS__SEAM_ROLE_BAND}, {"belt", MUS__SEAM_ROLE_BAND},
                 {"sleeve", MUS__SEAM_ROLE_SLEEVE}, {"arm", MUS__SEAM_ROLE_SLEEVE},
                 {"leg", MUS__SEAM_ROLE_LEG},       {"pant", MUS__SEAM_ROLE_LEG},
                 {"pants", MUS__SEAM_ROLE_LEG},     {"trouser", MUS__SEAM_ROLE_LEG},
                 {"pocket", MUS__SEAM_ROLE_POCKET},
                 {"skirt", MUS__SEAM_ROLE_SKIRT},   {"gore", MUS__SEAM_ROLE_SKIRT},
                 {"tier", MUS__SEAM_ROLE_SKIRT},    {"torso", MUS__SEAM_ROLE_TORSO},
                 {"ftorso", MUS__SEAM_ROLE_TORSO},  {"btorso", MUS__SEAM_ROLE_TORSO},
                 {"bodice", MUS__SEAM_ROLE_TORSO},  {"body", MUS__SEAM_ROLE_TORSO},
                 {"yoke", MUS__SEAM_ROLE_TORSO}};
    int32_t role = MUS__SEAM_ROLE_NONE;
    bool leg = false, skirt = false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        for (const char *at = text; *at != '\0';) {
            size_t n = 0, k = 0;
            while (isalpha((unsigned char)at[n])) n++;
            while (k < n && words[i].word[k] == tolower((unsigned char)at[k])) k++;
            if (n > 0 && k == n && words[i].word[k] == '\0') {
                if (role != MUS__SEAM_ROLE_CUFF) role = words[i].role;
                if (role != MUS__SEAM_ROLE_CUFF) return role;
                leg = leg || words[i].role == MUS__SEAM_ROLE_LEG;
                skirt = skirt || words[i].role == MUS__SEAM_ROLE_SKIRT;
            }
            at += n > 0 ? n : 1;
        }
    return skirt ? MUS__SEAM_ROLE_FLOUNCE : leg ? MUS__SEAM_ROLE_LEG_CUFF : role;
}


/* words of a name between other characters, without those of a side; its last number */
static void read_name(const char *name, mus__seam_panel *panel)
{
    panel->number = MUS_NONE;
    panel->stem = 2166136261u;
    for (const char *at = name; *at != '\0';) {
        size_t n = 0;
        while (isalpha((unsigned char)at[n])) n++;
        if (n > 0) {
            const uint32_t word = text_hash(at, n);
            panel->stem = (panel->stem ^ word) * 16777619u;
            if (!word_of_side(at, n) && panel->nword < MUS__SEAM_IN_NAME) panel->words[panel->nword++] = word;
        } else if (isdigit((unsigned char)*at)) {
            int32_t number = 0;
            for (; isdigit((unsigned char)at[n]); n++) number = number < 100000 ? 10 * number + (at[n] - '0') : number;
            panel->number = number;
        } else {
            n = 1;
        }
        at += n;
    }
}


/* ---- edges ---- */

static mus_status read_outline(facts_work *w, int32_t first, int32_t n, const int32_t *directions)
{
    w->nxy = 0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t edge = w->facts->edges[first + i].edge;
        int32_t count = 0;
        mus_status status = mus_pattern_edge_polyline(w->pattern, edge, FACTS_CHORDS, NULL, 0, &count);
        if (status != MUS_OK) return status;
        if (w->nxy + count > w->room) {
            const int32_t room = 2 * (w->nxy + count);
            double *xy = mus_context_alloc(w->facts->context, w->xy, 2 * sizeof *xy * (size_t)room);
            if (xy == NULL) return MUS_ERR_MEMORY;
            w->xy = xy;
            w->room = room;
        }
        double *own = w->xy + 2 * (size_t)w->nxy;
        status = mus_pattern_edge_polyline(w->pattern, edge, FACTS_CHORDS, own, count, &count);
        if (status != MUS_OK) return status;
        for (int32_t k = 0; directions[i] < 0 && k < count / 2; k++)
            for (int32_t c = 0; c < 2; c++) {
                const double t = own[2 * k + c];
                own[2 * k + c] = own[2 * (count - 1 - k) + c];
                own[2 * (count - 1 - k) + c] = t;
            }
        w->from[i] = w->nxy;
        w->nxy += count;
    }
    w->from[n] = w->nxy;
    return MUS_OK;
}


/* turns the outline so that the grain is up, and mirrors it where it runs clockwise */
static void set_upright(const facts_work *w, const double *grain)
{
    double area = 0.0;
    for (int32_t i = 0; i < w->nxy; i++) {
        double *p = w->xy + 2 * (size_t)i;
        const double x = grain[1] * p[0] - grain[0] * p[1], y = grain[0] * p[0] + grain[1] * p[1];
        p[0] = x;
        p[1] = y;
        if (i > 0) area += p[-2] * y - x * p[-1];
    }
    for (int32_t i = 0; i < w->nxy && area < 0.0; i++) w->xy[2 * (size_t)i] *= -1.0;
}


/* [rad] from direction u to v, -pi to pi */
static double turn_of(const double *u, const double *v)
{
    return mus__atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
}


/* the first (or the last) chord of edge i of the panel that has a length */
static void chord_of(const facts_work *w, int32_t i, bool last, double *out)
{
    const double *p = w->xy + 2 * (size_t)w->from[i];
    const int32_t n = w->from[i + 1] - w->from[i];
    out[0] = out[1] = 0.0;
    for (int32_t k = 0; k + 1 < n; k++) {
        const double *q = p + 2 * (last ? n - 2 - k : k);
        out[0] = q[2] - q[0];
        out[1] = q[3] - q[1];
        if (fabs(out[0]) + fabs(out[1]) > 1e-9) return;
    }
}


static void read_shape(const facts_work *w, int32_t i, mus__seam_edge *edge)
{
    const double *p = w->xy + 2 * (size_t)w->from[i];
    const int32_t n = w->from[i + 1] - w->from[i];
    double d[2], before[2] = {0.0, 0.0};
    edge->turn = 0.0;
    for (int32_t k = 0; k + 1 < n; k++) {
        d[0] = p[2 * k + 2] - p[2 * k];
        d[1] = p[2 * k + 3] - p[2 * k + 1];
        if (fabs(d[0]) + fabs(d[1]) <= 1e-9) continue;
        if (before[0] != 0.0 || before[1] != 0.0) edge->turn += turn_of(before, d);
        memcpy(before, d, sizeof d);
    }
    d[0] = p[2 * n - 2] - p[0];
    d[1] = p[2 * n - 1] - p[1];
    const double chord = fmax(1e-9, sqrt(d[0] * d[0] + d[1] * d[1]));
    edge->normal[0] = d[1] / chord;
    edge->normal[1] = -d[0] / chord;
    edge->height = 0.5 * (p[1] + p[2 * n - 1]);
    edge->across = 0.5 * (p[0] + p[2 * n - 2]);
}


static void read_corners(const facts_work *w, int32_t first, int32_t n)
{
    double low = HUGE_VAL, high = -HUGE_VAL, left = HUGE_VAL, right = -HUGE_VAL;
    for (int32_t k = 0; k < w->nxy; k++) {
        left = fmin(left, w->xy[2 * (size_t)k]);
        right = fmax(right, w->xy[2 * (size_t)k]);
        low = fmin(low, w->xy[2 * (size_t)k + 1]);
        high = fmax(high, w->xy[2 * (size_t)k + 1]);
    }
    for (int32_t i = 0; i < n; i++) {
        mus__seam_edge *edge = &w->facts->edges[first + i], *next = &w->facts->edges[edge->next];
        double u[2], v[2];
        read_shape(w, i, edge);
        edge->height = (edge->height - low) / fmax(1e-9, high - low);
        edge->across = 2.0 * (edge->across - left) / fmax(1e-9, right - left) - 1.0;
        chord_of(w, i, true, u);
        chord_of(w, edge->next - first, false, v);
        edge->end = next->start = MUS_PI - turn_of(u, v);
    }
    for (int32_t i = first; i < first + n; i++) {
        const mus__seam_edge *edges = w->facts->edges;
        int32_t count = 1;
        for (int32_t k = i; fabs(edges[k].end - MUS_PI) < MUS__SEAM_FLAT && count < n; k = edges[k].next) count++;
        for (int32_t k = i; fabs(edges[k].start - MUS_PI) < MUS__SEAM_FLAT && count < n; k = edges[k].prev) count++;
        w->facts->edges[i].line = count;
    }
}


/* neighbours round the outline: where an edge does not start at the end of the edge before it, a ring begins */
static void read_ring(const facts_work *w, int32_t first, int32_t n)
{
    int32_t ring = first;
    for (int32_t i = 0; i < n; i++) {
        const double *end = w->xy + 2 * (size_t)(w->from[i + 1] - 1), *start = w->xy + 2 * (size_t)w->from[i + 1];
        const bool whole = i + 1 == n || fabs(end[0] - start[0]) + fabs(end[1] - start[1]) > 1e-6;
        const int32_t next = whole ? ring : first + i + 1;
        w->facts->edges[first + i].next = next;
        w->facts->edges[next].prev = first + i;
        if (whole) ring = first + i + 1;
    }
}


/* where the edges of a panel lie on the body, as far as its sides tell. Seen from outside, the wearer's left is to the
 * right of a front and to the left of a back. */
static void read_places(const mus__seam_facts *facts, const mus__seam_panel *panel)
{
    const int32_t lateral = ((panel->sides & MUS_SIDE_LEFT) != 0) - ((panel->sides & MUS_SIDE_RIGHT) != 0);
    const int32_t along = ((panel->sides & MUS_SIDE_FRONT) != 0) - ((panel->sides & MUS_SIDE_BACK) != 0);
    for (int32_t i = panel->first; i < panel->first + panel->n; i++) {
        mus__seam_edge *edge = &facts->edges[i];
        edge->half = lateral;
        if (lateral == 0) edge->half = along * ((edge->across > OFF_CENTRE) - (edge->across < -OFF_CENTRE));
        const double inwards = -edge->normal[0] * along * edge->half;
        edge->inwards = (inwards > INWARDS) - (inwards < -INWARDS);
    }
}


static mus_status read_panel(facts_work *w, int32_t p, int32_t *directions)
{
    mus__seam_facts *facts = w->facts;
    mus__seam_panel *panel = &facts->panels[p];
    double grain[2];
    mus_status status = mus_pattern_grain(w->pattern, p, grain);
    if (status == MUS_OK) status = read_outline(w, panel->first, panel->n, directions);
    if (status != MUS_OK || panel->n == 0) return status;
    read_ring(w, panel->first, panel->n);
    set_upright(w, grain);
    read_corners(w, panel->first, panel->n);
    panel->key = 0;
    panel->image = MUS_NONE;
    panel->like = p;
    panel->sure = false;
    for (int32_t i = panel->first; i < panel->first + panel->n; i++) {
        mus__seam_edge *edge = &facts->edges[i];
        edge->panel = p;
        edge->mirror = MUS_NONE;
        edge->length = fmax(1e-6, mus_pattern_edge_length(w->pattern, edge->edge));
        edge->log_length = mus__ln(edge->length);
        facts->longest = fmax(facts->longest, edge->length);
        /* a sum, so that the order and the sense of the edges do not count */
        const uint64_t k = (uint64_t)(2e3 * edge->length + 0.5) + 1;
        panel->key += k * k * UINT64_C(0x9E3779B97F4A7C15) + (k ^ (k << 29));
    }
    panel->sides = mus_pattern_panel_sides(w->pattern, p, NULL);
    read_places(facts, panel);
    const char *name = mus_pattern_panel_name(w->pattern, p);
    panel->role = role_named(name);
    if (panel->role == MUS__SEAM_ROLE_NONE) panel->role = role_named(mus_pattern_panel_label(w->pattern, p));
    read_name(name, panel);
    return MUS_OK;
}


/* ---- mirror images ---- */

/* whether edges a and b agree as images; a corner that is flat on both may lie elsewhere along the line */
static bool is_image(const mus__seam_edge *a, const mus__seam_edge *b)
{
    return fabs(a->start - b->end) < MIRROR_ANGLE && fabs(a->end - b->start) < MIRROR_ANGLE &&
           fabs(a->turn - b->turn) < MIRROR_ANGLE && fabs(a->normal[0] + b->normal[0]) < MIRROR_NORMAL &&
           fabs(a->normal[1] - b->normal[1]) < MIRROR_NORMAL;
}


/* the edge of panel q that edge 0 of panel p has as its image, so that all edges agree; MUS_NONE. The lengths between
 * corners agree, not those between flat points: a seam is divided where the other side has its corners. */
static int32_t image_of(const mus__seam_facts *facts, const mus__seam_panel *p, const mus__seam_panel *q)
{
    if (p->n != q->n) return MUS_NONE;
    for (int32_t s = 0; s < p->n; s++) {
        bool same = true;
        int32_t image = q->first + s;
        double ahead = 0.0, first = HUGE_VAL;
        for (int32_t i = 0; i < p->n && same; i++) {
            const mus__seam_edge *a = &facts->edges[p->first + i], *b = &facts->edges[image];
            same = is_image(a, b);
            ahead += a->length - b->length;
            if (fabs(a->end - MUS_PI) >= MIRROR_ANGLE) {
                if (first == HUGE_VAL) first = ahead;
                same = same && fabs(ahead - first) < MIRROR_LENGTH * facts->longest;
            }
            image = b->prev;
        }
        if (same) return q->first + s;
    }
    return MUS_NONE;
}


static bool same_words(const mus__seam_panel *p, const mus__seam_panel *q)
{
    return p->nword == q->nword && memcmp(p->words, q->words, sizeof p->words) == 0;
}


/* how well names agree with q being the image of p: 0 to 4 */
static int32_t image_rank(const mus__seam_panel *p, const mus__seam_panel *q)
{
    const int32_t lateral = MUS_SIDE_LEFT | MUS_SIDE_RIGHT, along = MUS_SIDE_FRONT | MUS_SIDE_BACK;
    const int32_t ps = p->sides & lateral, qs = q->sides & lateral;
    const bool words = same_words(p, q) && (p->sides & along) == (q->sides & along);
    if (p == q) return ps == 0 ? 3 : 0;
    if (ps != 0 && qs != 0 && ps != qs) return words ? 4 : 2;
    return words ? 2 : 1;
}


static void pair_images(mus__seam_facts *facts, int32_t p, int32_t q, int32_t image)
{
    const mus__seam_panel *panel = &facts->panels[p];
    for (int32_t i = 0; i < panel->n; i++) {
        facts->edges[panel->first + i].mirror = image;
        if (p != q) facts->edges[image].mirror = panel->first + i;
        image = facts->edges[image].prev;
    }
}


/* panels of the same edges on the same side of the body */
static int32_t count_alike(const mus__seam_facts *facts, const mus__seam_panel *p)
{
    int32_t count = 0;
    for (int32_t q = 0; q < facts->npanel; q++)
        count += facts->panels[q].key == p->key && facts->panels[q].sides == p->sides;
    return count;
}


static void find_images(mus__seam_facts *facts)
{
    for (int32_t p = 0; p < facts->npanel; p++)
        for (int32_t q = p - 1; q >= 0; q--)
            if (facts->panels[q].n == facts->panels[p].n && facts->panels[q].key == facts->panels[p].key)
                facts->panels[p].like = q;
    for (int32_t rank = 4; rank >= 0; rank--)
        for (int32_t p = 0; p < facts->npanel; p++)
            for (int32_t q = p; q < facts->npanel; q++) {
                mus__seam_panel *a = &facts->panels[p], *b = &facts->panels[q];
                if (a->n == 0 || b->n != a->n || image_rank(a, b) != rank) continue;
                if (facts->edges[a->first].mirror != MUS_NONE || facts->edges[b->first].mirror != MUS_NONE) continue;
                const int32_t image = image_of(facts, a, b);
                if (image == MUS_NONE) continue;
                pair_images(facts, p, q, image);
                a->image = q;
                b->image = p;
                a->sure = b->sure = rank == 4 || (p == q ? count_alike(facts, a) == 1 : rank > 1);
            }
}


/* ---- the whole ---- */

/* number of edges whose logarithm of the length is below x */
static int32_t count_below(const mus__seam_facts *facts, double x)
{
    int32_t low = 0, high = facts->n;
    while (low < high) {
        const int32_t middle = low + (high - low) / 2;
        if (facts->lengths[middle] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}


int32_t mus__seam_count_near(const mus__seam_facts *facts, int32_t a, double ratio)
{
    const double x = facts->edges[a].log_length;
    const int32_t n = count_below(facts, x + ratio) - count_below(facts, x - ratio) - 1;
    return n > 0 ? n : 0;
}


static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}


static mus_status read_edges(facts_work *w, int32_t *place, int32_t *rim, int32_t *directions)
{
    mus__seam_facts *facts = w->facts;
    mus_status status = MUS_OK;
    const int32_t edges = mus_pattern_edge_count(w->pattern);
    for (int32_t p = 0; p < facts->npanel && status == MUS_OK; p++) {
        int32_t n = 0, given = 0;
        facts->panels[p].first = facts->n;
        status = mus_pattern_outline(w->pattern, p, &given, NULL, NULL);
        if (status != MUS_OK || given == 0) continue;
        status = mus_pattern_rim(w->pattern, p, rim, directions, edges, &n);
        for (int32_t i = 0; i < n && status == MUS_OK; i++) {
            place[rim[i]] = facts->n;
            facts->edges[facts->n++].edge = rim[i];
        }
        facts->panels[p].n = status == MUS_OK ? n : 0;
        if (status == MUS_OK) status = read_panel(w, p, directions);
    }
    return status;
}


/* notches of each edge, ascending along the outline. One at an end stands for a joint of the edges that are sewn to it,
 * and is no place of the seam */
static mus_status read_notches(facts_work *w)
{
    mus__seam_facts *facts = w->facts;
    const int32_t count = mus_pattern_notch_count(w->pattern);
    facts->notches = facts_new(facts->context, 2 * (int64_t)count, sizeof *facts->notches);
    if (facts->notches == NULL) return MUS_ERR_MEMORY;
    for (int32_t i = 0; i < facts->n; i++) {
        mus__seam_edge *edge = &facts->edges[i];
        edge->notch = facts->nnotch;
        for (int32_t k = 0; k < count; k++) {
            int32_t own = MUS_NONE, kind = 0, start = 0, at = facts->nnotch;
            double s = 0.0;
            mus_status status = mus_pattern_notch(w->pattern, k, &own, &s, &kind);
            if (status != MUS_OK) return status;
            if (own != edge->edge || at >= count || s < FACTS_END || s > edge->length - FACTS_END) continue;
            int32_t n = 0;
            const int32_t *edges = NULL, *turns = NULL;
            status = mus_pattern_outline(w->pattern, edge->panel, &n, &edges, &turns);
            while (status == MUS_OK && start < n && edges[start] != own) start++;
            if (status == MUS_OK && start < n && turns[start] < 0) s = edge->length - s;
            for (; at > edge->notch && facts->notches[2 * at - 2] > s / edge->length; at--)
                memcpy(facts->notches + 2 * at, facts->notches + 2 * at - 2, 2 * sizeof(double));
            facts->notches[2 * at] = s / edge->length;
            facts->notches[2 * at + 1] = kind;
            facts->nnotch++;
        }
        edge->nnotch = facts->nnotch - edge->notch;
    }
    return MUS_OK;
}


static mus_status read_fixed(facts_work *w, const int32_t *place)
{
    mus__seam_facts *facts = w->facts;
    for (int32_t i = 0; i < facts->n; i++) facts->fixed[i] = MUS_NONE;
    for (int32_t s = 0; s < mus_pattern_seam_count(w->pattern); s++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        mus_status status = mus_pattern_seam(w->pattern, s, &def);
        if (status != MUS_OK) return status;
        const int32_t a = place[def.edge_a], b = place[def.edge_b];
        if (def.laid || a == MUS_NONE || b == MUS_NONE || a == b) continue;
        if (facts->fixed[a] != MUS_NONE || facts->fixed[b] != MUS_NONE) continue;
        facts->fixed[a] = b;
        facts->fixed[b] = a;
    }
    return MUS_OK;
}


mus_status mus__seam_read(const mus_pattern *pattern, mus__seam_facts *out)
{
    const int32_t edges = mus_pattern_edge_count(pattern);
    const mus__seam_facts none = {.context = mus_pattern_context(pattern)};
    *out = none;
    if (edges > MUS__SEAM_EDGES)
        return mus_context_fail(out->context, MUS_ERR_LIMIT,
                                "the pattern has more than 500 edges, the most whose seams are sought");
    out->npanel = mus_pattern_panel_count(pattern);
    out->edges = facts_new(out->context, edges, sizeof *out->edges);
    out->panels = facts_new(out->context, out->npanel, sizeof *out->panels);
    out->lengths = facts_new(out->context, edges, sizeof *out->lengths);
    out->fixed = facts_new(out->context, edges, sizeof *out->fixed);
    int32_t *work = facts_new(out->context, 4 * (int64_t)edges + 1, sizeof *work);
    facts_work w = {.pattern = pattern, .facts = out};
    mus_status status = MUS_ERR_MEMORY;
    if (out->edges != NULL && out->panels != NULL && out->lengths != NULL && out->fixed != NULL && work != NULL) {
        int32_t *place = work + 2 * edges;
        w.from = work + 3 * edges;
        for (int32_t i = 0; i < edges; i++) place[i] = MUS_NONE;
        status = read_edges(&w, place, work, work + edges);
        if (status == MUS_OK) status = read_notches(&w);
        if (status == MUS_OK) status = read_fixed(&w, place);
        for (int32_t i = 0; i < out->n; i++) out->lengths[i] = out->edges[i].log_length;
        mus__sort(out->lengths, (size_t)out->n, sizeof *out->lengths, compare_doubles);
        for (int32_t i = 0; i < out->n; i++) {
            out->edges[i].equal = mus__seam_count_near(out, i, MUS__SEAM_EQUAL_LENGTHS);
            out->edges[i].alone = mus__seam_count_near(out, i, 0.01) == 0;
        }
        find_images(out);
    }
    mus_context_alloc(out->context, w.xy, 0);
    mus_context_alloc(out->context, work, 0);
    if (status == MUS_ERR_MEMORY) mus_context_fail(out->context, status, "no memory for the seams of a pattern");
    return status;
}


void mus__seam_free(mus__seam_facts *facts)
{
    void *const blocks[] = {facts->edges, facts->panels, facts->notches, facts->lengths, facts->fixed};
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++) mus_context_alloc(facts->context, blocks[i], 0);
}
