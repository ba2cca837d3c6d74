/*
 * seam_score.c: the features of a sewing: of each seam, and of the surface that the seams make.
 *
 * A vertex of the sewn surface is an orbit of corners. The corner at the start of edge e is glued across e to the
 * corner at the start of the edge after e's mate. An orbit that comes back to its first corner is a closed vertex; one
 * that ends at two free edges lies on an opening. From vertices, edges, panels and openings follows the number of
 * handles: the Euler characteristic is 2 (components - handles) - openings.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "seam/seam_find.h"
#include "base/elementary.h"

#define NORMALS_SPREAD 0.04 /* 1 less the cosine at which an agreement of normals falls to 1/e: 16 degrees */
#define CORNERS_SPREAD 0.06 /* [rad] the same of corners that add up to a half turn */
#define NOTCHES_SPREAD 0.02 /* relative arc length, the same of notches */
#define ANGLES_SPREAD 0.1   /* [rad] the same of the angle of a vertex */
#define DART_WEDGE 1.2      /* [rad] widest dart; chosen: a quarter more than a bust dart of a large cup */
#define OPENING_SMALL 0.15  /* [m] a shorter opening lets no hand through; chosen: half the girth of a child's wrist */
#define CURVED 0.3          /* [rad] turn of an edge that counts as curved */
#define ALIGNED 0.92        /* cosine of the angle between directions that count as one: 23 degrees */


static double bell(double x, double spread)
{
    const double square = (x / spread) * (x / spread);
    return square < 30.0 ? mus__exp(-square) : 0.0;
}


/* ---- a seam ---- */

static void pair_lengths(const mus__seam_facts *facts, int32_t a, int32_t b, double *out)
{
    const mus__seam_edge *x = &facts->edges[a], *y = &facts->edges[b];
    const double r = fabs(x->log_length - y->log_length);
    const int32_t rank_a = mus__seam_count_near(facts, a, r), rank_b = mus__seam_count_near(facts, b, r);
    out[MUS__SEAM_RATIO] = fmin(r, 1.5);
    out[MUS__SEAM_EQUAL] = r < MUS__SEAM_EQUAL_LENGTHS;
    out[MUS__SEAM_NEAR] = r < 0.01;
    out[MUS__SEAM_CLOSE] = r < 0.05;
    out[MUS__SEAM_EASED] = r < 0.2;
    if (r < MUS__SEAM_EQUAL_LENGTHS) {
        const int32_t na = x->equal, nb = y->equal;
        out[MUS__SEAM_ONLY] = 1.0 / (na > nb ? na > 1 ? na : 1 : nb > 1 ? nb : 1);
    } else
        out[MUS__SEAM_JILTED] = (x->equal > (x->mirror != MUS_NONE && x->mirror != a)) +
                                (y->equal > (y->mirror != MUS_NONE && y->mirror != b));
    out[MUS__SEAM_RANK] = fmin(rank_a > rank_b ? rank_a : rank_b, 8.0) / 8.0;
    out[MUS__SEAM_SHORT] = fmin(x->length, y->length) / facts->longest;
}


static void pair_shape(const mus__seam_edge *x, const mus__seam_edge *y, double *out)
{
    const double sum = fabs(x->turn + y->turn), difference = fabs(x->turn - y->turn);
    const double mirror = -x->normal[0] * y->normal[0] + x->normal[1] * y->normal[1];
    const double opposed = -x->normal[0] * y->normal[0] - x->normal[1] * y->normal[1];
    out[MUS__SEAM_TURN_SUM] = fmin(sum, 1.5);
    out[MUS__SEAM_TURN_BOTH] = fmin(fmin(sum, difference), 1.5);
    out[MUS__SEAM_CONVEX] = fmin(x->turn, y->turn) < -CURVED && fmax(x->turn, y->turn) > CURVED;
    out[MUS__SEAM_MIRROR] = mus__exp((mirror - 1.0) / NORMALS_SPREAD);
    out[MUS__SEAM_OPPOSED] = mus__exp((opposed - 1.0) / NORMALS_SPREAD);
    out[MUS__SEAM_UPWARD] = x->normal[1] + y->normal[1];
    out[MUS__SEAM_CORNER] =
        bell(x->start + y->end - MUS_PI, CORNERS_SPREAD) + bell(x->end + y->start - MUS_PI, CORNERS_SPREAD);
}


static void pair_panel(const mus__seam_facts *facts, int32_t a, int32_t b, double *out)
{
    const mus__seam_edge *x = &facts->edges[a];
    const bool next = x->next == b, prev = x->prev == b;
    const double wedge = 2.0 * MUS_PI - (next ? x->end : x->start);
    out[MUS__SEAM_SAME] = 1.0;
    out[MUS__SEAM_DART] = (next || prev) && wedge < DART_WEDGE;
    out[MUS__SEAM_DART_DOWN] = out[MUS__SEAM_DART] > 0.0 && out[MUS__SEAM_UPWARD] < 0.0;
}


static bool of_arm(const mus__seam_panel *p)
{
    return p->role == MUS__SEAM_ROLE_SLEEVE || p->role == MUS__SEAM_ROLE_CUFF || p->role == MUS__SEAM_ROLE_FLOUNCE;
}


static bool crossed(const mus__seam_panel *p, const mus__seam_panel *q)
{
    const int32_t lateral = MUS_SIDE_LEFT | MUS_SIDE_RIGHT;
    return ((p->sides | q->sides) & lateral) == lateral && (p->sides & lateral) != 0 && (q->sides & lateral) != 0;
}


bool mus__seam_never(const mus__seam_facts *facts, int32_t a, int32_t b)
{
    const mus__seam_panel *p = &facts->panels[facts->edges[a].panel], *q = &facts->panels[facts->edges[b].panel];
    return crossed(p, q) && (of_arm(p) || of_arm(q));
}


/* the halves of the body: a seam crosses the centre only between edges that look to it */
static void pair_halves(const mus__seam_facts *facts, const mus__seam_edge *x, const mus__seam_edge *y, double *out)
{
    const int32_t halves = x->half * y->half, sides = x->inwards * y->inwards;
    const bool front_back = out[MUS__SEAM_FRONT_BACK] > 0.0;
    const mus__seam_panel *p = &facts->panels[x->panel], *q = &facts->panels[y->panel];
    const bool legs = p->role == MUS__SEAM_ROLE_LEG && q->role == MUS__SEAM_ROLE_LEG && crossed(p, q);
    out[MUS__SEAM_CENTRE_SEAM] = halves < 0 && x->inwards > 0 && y->inwards > 0;
    out[MUS__SEAM_CROSSED] = halves < 0 && out[MUS__SEAM_CENTRE_SEAM] <= 0.0;
    out[MUS__SEAM_LEGS_CROSSED] = legs && fmax(x->height, y->height) < 0.5;
    out[MUS__SEAM_ONE_HALF] = halves > 0;
    out[MUS__SEAM_SIDES_AGREE] = halves > 0 && front_back && sides > 0;
    out[MUS__SEAM_SIDES_DIFFER] = halves > 0 && front_back && sides < 0;
}


static double common_words(const mus__seam_panel *p, const mus__seam_panel *q)
{
    int32_t common = 0;
    const int32_t fewer = p->nword < q->nword ? p->nword : q->nword;
    for (int32_t i = 0; i < p->nword; i++)
        for (int32_t k = 0; k < q->nword; k++)
            if (p->words[i] == q->words[k]) {
                common++;
                break;
            }
    return fewer > 0 ? fmin(1.0, (double)common / fewer) : 0.0;
}


static void pair_panels(const mus__seam_panel *p, const mus__seam_panel *q, double *out)
{
    const int32_t along = MUS_SIDE_FRONT | MUS_SIDE_BACK, pa = p->sides & along, qa = q->sides & along;
    out[MUS__SEAM_FRONT_BACK] = pa != 0 && qa != 0 && pa != qa;
    out[MUS__SEAM_FRONT_FRONT] = p != q && pa != 0 && pa == qa;
    out[MUS__SEAM_TWIN] = p != q && p->key == q->key;
    out[MUS__SEAM_WORDS] = p != q ? common_words(p, q) : 0.0;
    out[MUS__SEAM_NUMBERS] = p->number != MUS_NONE && q->number != MUS_NONE && p->stem == q->stem &&
                             (p->number - q->number == 1 || q->number - p->number == 1);
}


static void pair_notches(const mus__seam_facts *facts, const mus__seam_edge *x, const mus__seam_edge *y, double *out)
{
    if (x->nnotch == 0 && y->nnotch == 0) return;
    bool same = x->nnotch == y->nnotch;
    double off = 0.0;
    for (int32_t i = 0; i < x->nnotch && same; i++) {
        const double *s = facts->notches + 2 * (x->notch + i);
        const double *t = facts->notches + 2 * (y->notch + y->nnotch - 1 - i);
        same = fabs(s[1] - t[1]) < 0.5;
        off = fmax(off, fabs(s[0] - (1.0 - t[0])));
    }
    out[MUS__SEAM_NOTCH_OK] = same;
    out[MUS__SEAM_NOTCH_BAD] = !same;
    out[MUS__SEAM_NOTCH_PLACE] = same ? bell(off, NOTCHES_SPREAD) : 0.0;
}


/* how two edges look, of MUS__SEAM_DIRECTIONS */
static int32_t pair_direction(const mus__seam_edge *x, const mus__seam_edge *y)
{
    const double mirror = -x->normal[0] * y->normal[0] + x->normal[1] * y->normal[1];
    const double opposed = -x->normal[0] * y->normal[0] - x->normal[1] * y->normal[1];
    return mirror > ALIGNED && opposed > ALIGNED  ? 0
           : mirror > ALIGNED && x->normal[1] > 0 ? 1
           : mirror > ALIGNED                     ? 2
           : opposed > ALIGNED                    ? 3
           : x->normal[1] * y->normal[1] < 0.0    ? 4
                                                  : 5;
}


/* how two edges turn, of MUS__SEAM_TURNS */
static int32_t pair_turns(const mus__seam_edge *x, const mus__seam_edge *y)
{
    if (fmax(fabs(x->turn), fabs(y->turn)) < CURVED) return 0;
    if (fabs(x->turn + y->turn) < CURVED) return 1;
    return fabs(x->turn - y->turn) < CURVED ? 2 : 3;
}


/* the kind of a seam: relation of the panels, directions of the edges, lengths */
static int32_t pair_kind(const mus__seam_facts *facts, const mus__seam_edge *x, const mus__seam_edge *y,
                         const double *out)
{
    const int32_t relation = x->panel == y->panel                          ? 0
                             : facts->panels[x->panel].image == y->panel   ? 1
                             : out[MUS__SEAM_FRONT_BACK] > 0.0             ? 2
                                                                           : 3;
    const int32_t lengths = out[MUS__SEAM_EQUAL] > 0.0 ? 0 : out[MUS__SEAM_CLOSE] > 0.0 ? 1 : 2;
    return (relation * MUS__SEAM_DIRECTIONS + pair_direction(x, y)) * MUS__SEAM_LENGTHS + lengths;
}


void mus__seam_pair(const mus__seam_facts *facts, int32_t a, int32_t b, double *out)
{
    const mus__seam_edge *x = &facts->edges[a], *y = &facts->edges[b];
    memset(out, 0, MUS__SEAM_PAIRS * sizeof *out);
    out[MUS__SEAM_SEWN] = 1.0;
    pair_lengths(facts, a, b, out);
    pair_shape(x, y, out);
    if (x->panel == y->panel) pair_panel(facts, a, b, out);
    pair_panels(&facts->panels[x->panel], &facts->panels[y->panel], out);
    pair_notches(facts, x, y, out);
    pair_halves(facts, x, y, out);
    out[MUS__SEAM_CURVE_EQUAL] = out[MUS__SEAM_NEAR] > 0.0 && fabs(x->turn) > 0.1 && fabs(x->turn - y->turn) < 0.05;
    out[MUS__SEAM_UNEQUAL_TURN] = out[MUS__SEAM_NEAR] > 0.0 ? 0.0 : out[MUS__SEAM_TURN_BOTH];
    out[MUS__SEAM_CENTRE] = x->mirror == b;
    out[MUS__SEAM_HEIGHT] = x->panel != y->panel ? fabs(x->height - y->height) : 0.0;
    out[MUS__SEAM_KIND + pair_kind(facts, x, y, out)] = 1.0;
    const int32_t p = facts->panels[x->panel].role, q = facts->panels[y->panel].role;
    const int32_t parts = p > q ? p * (p + 1) / 2 + q : q * (q + 1) / 2 + p;
    const int32_t eased = 2 * parts + (out[MUS__SEAM_EASED] > 0.0);
    out[MUS__SEAM_ROLE + eased] = 1.0;
    out[MUS__SEAM_ROLE_WAY + eased * MUS__SEAM_DIRECTIONS + pair_direction(x, y)] = 1.0;
    out[MUS__SEAM_ROLE_TURN + parts * MUS__SEAM_TURNS + pair_turns(x, y)] = 1.0;
}


/* ---- a free edge ---- */

void mus__seam_free_edge(const mus__seam_facts *facts, int32_t a, double *out)
{
    const mus__seam_edge *x = &facts->edges[a];
    const int32_t equal = x->equal, own = x->mirror != MUS_NONE && x->mirror != a;
    const int32_t side = x->normal[1] < -0.9 ? 0 : x->normal[1] > 0.9 ? 1 : fabs(x->normal[0]) > 0.9 ? 2 : 3;
    const int32_t shape = x->turn < -CURVED ? 0 : x->turn > CURVED ? 1 : 2;
    const int32_t rivals = equal > own ? 0 : equal > 0 ? 1 : 2;
    const int32_t kind = (side * 3 + shape) * 3 + rivals, role = facts->panels[x->panel].role;
    memset(out, 0, MUS__SEAM_FREES * sizeof *out);
    out[MUS__SEAM_FREE + kind] = 1.0;
    out[MUS__SEAM_FREE_SIDE + role * MUS__SEAM_SIDES + side] = 1.0;
    out[MUS__SEAM_FREE_ROLE + role * MUS__SEAM_FREE_KINDS + kind] = 1.0;
    out[MUS__SEAM_FREE_TURN] = fmin(fabs(x->turn), 3.0);
    out[MUS__SEAM_FREE_LENGTH] = x->length / facts->longest;
    out[MUS__SEAM_FREE_NOTCH] = x->nnotch > 0;
    out[MUS__SEAM_FREE_DOWN_LOW] = side == 0 && x->height < 0.2;
    out[MUS__SEAM_FREE_UP_HIGH] = side == 1 && x->height > 0.8;
    out[MUS__SEAM_FREE_CONCAVE_HIGH] = shape == 0 && x->height > 0.5;
    out[MUS__SEAM_FREE_ALONE] = x->alone;
    if (x->half == 0 || x->inwards <= 0) return;
    out[MUS__SEAM_FREE_CENTRE] = 1.0;
    out[MUS__SEAM_FREE_CENTRE_2] = x->line == 2;
    out[MUS__SEAM_FREE_CENTRE_3] = x->line > 2;
    out[MUS__SEAM_FREE_INNER + role] = 1.0;
}


/* ---- the whole ---- */

typedef struct surface {
    const mus__seam_facts *facts;
    const int32_t *mate;
    int32_t *seen;  /* (n) corners */
    int32_t *after; /* (n) the free edge that follows a free edge round an opening */
    int32_t *done;  /* (n) free edges */
    int32_t *part;  /* (npanel) parent in the forest of components */
    int32_t *openings; /* (npanel) of the component of which the panel is the root */
    int32_t *free;     /* (npanel) free edges */
    int32_t *roles;    /* (npanel) bits of the roles in the component of which the panel is the root */
    int32_t nvertex, nopening;
    double *out;
} surface;


static void free_edge(const surface *s, int32_t a)
{
    const mus__seam_edge *x = &s->facts->edges[a];
    s->free[x->panel]++;
    s->out[MUS__SEAM_UNEVEN_FREE] +=
        x->mirror != MUS_NONE && s->facts->panels[x->panel].sure && s->mate[x->mirror] != MUS_NONE;
}


static void closed_vertex(double *out, int32_t k, double angle)
{
    const double off = fmin(fabs(angle - 2.0 * MUS_PI), 2.0);
    const double flat = bell(angle - 2.0 * MUS_PI, ANGLES_SPREAD);
    out[MUS__SEAM_CLOSED_1 + (k < 6 ? k : 6) - 1] += 1.0;
    if (k == 2) {
        out[MUS__SEAM_CLOSED_2_OFF] += off;
        out[MUS__SEAM_CLOSED_2_FLAT] += flat;
    } else if (k > 2) {
        out[MUS__SEAM_CLOSED_3_OFF] += off;
        out[MUS__SEAM_CLOSED_3_FLAT] += flat;
    }
}


static void open_vertex(double *out, int32_t k, double angle)
{
    const double off = fmin(fabs(angle - MUS_PI), 1.5), flat = bell(angle - MUS_PI, ANGLES_SPREAD);
    out[MUS__SEAM_OPEN_1 + (k < 5 ? k : 5) - 1] += 1.0;
    if (k == 1) {
        out[MUS__SEAM_OPEN_1_OFF] += off;
    } else if (k == 2) {
        out[MUS__SEAM_OPEN_2_OFF] += off;
        out[MUS__SEAM_OPEN_2_FLAT] += flat;
    } else {
        out[MUS__SEAM_OPEN_3_OFF] += off;
        out[MUS__SEAM_OPEN_3_FLAT] += flat;
    }
}


/* two seams that go on in one another, each given by its edge on one side of the line: their ratios of lengths */
static void join_line(const surface *s, int32_t a, int32_t b)
{
    const mus__seam_edge *e = s->facts->edges;
    const double p = e[s->mate[a]].log_length - e[a].log_length, q = e[s->mate[b]].log_length - e[b].log_length;
    const bool same = fabs(p - q) < MUS__SEAM_EQUAL_RATIOS;
    s->out[MUS__SEAM_LINE] += 1.0;
    s->out[MUS__SEAM_LINE_SAME] += same;
    s->out[MUS__SEAM_LINE_GATHER] += same && fabs(p) > MUS__SEAM_EQUAL_RATIOS;
    s->out[MUS__SEAM_LINE_OFF] += fmin(fabs(p - q), 0.5);
}


/* the vertex of the corner at the start of edge e */
static void walk_vertex(surface *s, int32_t e)
{
    const mus__seam_edge *edges = s->facts->edges;
    int32_t first = e, k = 0, last = MUS_NONE, corner[4], flat = 0;
    while (s->mate[edges[first].prev] != MUS_NONE) {
        first = s->mate[edges[first].prev];
        if (first == e) break;
    }
    const int32_t before = edges[first].prev;
    double angle = 0.0;
    for (int32_t c = first;; c = edges[s->mate[c]].next) {
        if (k > 0 && c == first) break;
        s->seen[c] = 1;
        const int32_t before_c = edges[c].prev;
        if (fabs(edges[c].start - MUS_PI) < MUS__SEAM_FLAT) {
            flat++;
            if (s->mate[c] != MUS_NONE && s->mate[before_c] != MUS_NONE)
                join_line(s, before_c, c);
            else
                s->out[MUS__SEAM_LINE_STOP] += s->mate[c] != s->mate[before_c];
        }
        angle += edges[c].start;
        if (k < 4) corner[k] = c;
        k++;
        last = c;
        if (s->mate[c] == MUS_NONE) break;
    }
    s->nvertex++;
    if (s->mate[last] != MUS_NONE) {
        closed_vertex(s->out, k, angle);
        /* of four seams at a vertex those that face one another are a line: the edges left of it */
        for (int32_t i = 0; k == 4 && flat == 0 && i < 2; i++) join_line(s, s->mate[corner[i]], corner[i + 2]);
        return;
    }
    open_vertex(s->out, k, angle);
    s->after[before] = last;
}


static int32_t part_root(int32_t *part, int32_t p)
{
    while (part[p] != p) p = part[p] = part[part[p]];
    return p;
}


/* openings of each component; the parts of the panels are known */
static void walk_openings(surface *s)
{
    for (int32_t a = 0; a < s->facts->n; a++) {
        if (s->mate[a] != MUS_NONE || s->done[a]) continue;
        double length = 0.0;
        for (int32_t b = a; !s->done[b]; b = s->after[b]) {
            s->done[b] = 1;
            length += s->facts->edges[b].length;
        }
        s->nopening++;
        s->openings[part_root(s->part, s->facts->edges[a].panel)]++;
        s->out[MUS__SEAM_OPENINGS_SMALL] += length < OPENING_SMALL;
    }
}


/* components of the panels with an outline; *faces is how many of these panels there are */
static int32_t count_components(const surface *s, int32_t *faces)
{
    int32_t components = 0;
    for (int32_t p = 0; p < s->facts->npanel; p++) s->part[p] = p;
    for (int32_t a = 0; a < s->facts->n; a++) {
        if (s->mate[a] == MUS_NONE) continue;
        const int32_t p = part_root(s->part, s->facts->edges[a].panel);
        const int32_t q = part_root(s->part, s->facts->edges[s->mate[a]].panel);
        if (p != q) s->part[p] = q;
    }
    *faces = 0;
    for (int32_t p = 0; p < s->facts->npanel; p++) {
        *faces += s->facts->panels[p].n > 0;
        components += s->facts->panels[p].n > 0 && s->part[p] == p;
    }
    return components;
}


/* openings of a garment with these parts: a torso has neck, waist and arms, trousers the waist and two legs, a skirt
 * waist and hem; 0 where no part is known */
static int32_t openings_of(int32_t roles)
{
    const bool torso = (roles & 1 << MUS__SEAM_ROLE_TORSO) != 0, leg = (roles & 1 << MUS__SEAM_ROLE_LEG) != 0;
    if (torso) return leg ? 5 : 4;
    return leg ? 3 : (roles & 1 << MUS__SEAM_ROLE_SKIRT) != 0 ? 2 : 0;
}


static void count_openings(const surface *s)
{
    for (int32_t p = 0; p < s->facts->npanel; p++)
        if (s->facts->panels[p].n > 0) s->roles[part_root(s->part, p)] |= 1 << s->facts->panels[p].role;
    for (int32_t p = 0; p < s->facts->npanel; p++) {
        const int32_t n = s->openings[p];
        s->out[MUS__SEAM_UNLIKE] += abs(s->free[p] - s->free[s->facts->panels[p].like]);
        if (s->facts->panels[p].n == 0 || s->part[p] != p) continue;
        const int32_t expected = openings_of(s->roles[p]);
        s->out[MUS__SEAM_OPENINGS_FEWER] += expected > n ? expected - n : 0;
        s->out[MUS__SEAM_OPENINGS_BEYOND] += expected > 0 && n > expected ? n - expected : 0;
        s->out[MUS__SEAM_SEALED] += n < 2;
        s->out[MUS__SEAM_OPENINGS_2] += n == 2;
        s->out[MUS__SEAM_OPENINGS_3] += n == 3;
        s->out[MUS__SEAM_OPENINGS_4] += n == 4;
        s->out[MUS__SEAM_OPENINGS_MORE] += n > 5 ? n - 5 : 0;
    }
}


static bool is_sure(const mus__seam_facts *facts, int32_t a)
{
    return facts->panels[facts->edges[a].panel].sure;
}


void mus__seam_whole(const mus__seam_facts *facts, const int32_t *mate, int32_t *scratch, double *out)
{
    const int32_t n = facts->n;
    surface s = {.facts = facts,
                 .mate = mate,
                 .seen = scratch,
                 .after = scratch + n,
                 .done = scratch + 2 * n,
                 .part = scratch + 4 * n,
                 .openings = scratch + 4 * n + facts->npanel,
                 .free = scratch + 4 * n + 2 * facts->npanel,
                 .roles = scratch + 4 * n + 3 * facts->npanel,
                 .out = out};
    int32_t seams = 0, faces = 0;
    memset(scratch, 0, 3 * sizeof *scratch * (size_t)n);
    memset(s.openings, 0, 3 * sizeof *scratch * (size_t)facts->npanel);
    memset(out, 0, MUS__SEAM_WHOLES * sizeof *out);
    for (int32_t a = 0; a < n; a++) {
        const int32_t b = mate[a];
        if (!s.seen[a]) walk_vertex(&s, a);
        if (b == MUS_NONE) {
            free_edge(&s, a);
        } else if (a < b) {
            const int32_t c = facts->edges[a].mirror, d = facts->edges[b].mirror;
            seams++;
            if (c != MUS_NONE && d != MUS_NONE && is_sure(facts, a) && is_sure(facts, b))
                out[MUS__SEAM_UNEVEN] += mate[c] != d;
        }
    }
    const int32_t components = count_components(&s, &faces);
    walk_openings(&s);
    count_openings(&s);
    out[MUS__SEAM_COMPONENTS] = components - 1;
    out[MUS__SEAM_HANDLES] = components - 0.5 * (s.nvertex - (n - seams) + faces + s.nopening);
}
