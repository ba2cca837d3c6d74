/*
 * plan.c: from the runs of a cloth to half springs, elements and gather lists.
 *
 * Costs twice the spring arithmetic of a form that writes to both ends, and saves every scatter: measured about 0.9 of
 * its speed in float (reference form 5a against 5b), and threads need no colouring.
 */
#include <math.h>
#include <string.h>

#include "drape/plan.h"


/* row that holds a lattice node, by bisection */
static int32_t row_of(const mus__plan *plan, int32_t node)
{
    int32_t low = 0, high = plan->nrow - 1;
    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;
        if (plan->row[middle].first <= node) low = middle;
        else high = middle - 1;
    }
    return low;
}


/*
 * Visit the parts of owners o .. o+count-1 that lie in one row each. `emit` counts them (plan arrays NULL) or writes.
 */
typedef struct cut {
    int32_t row, offset, count;
} cut;


static int32_t cut_next(const mus__plan *plan, int32_t owner, int32_t count, int32_t done, cut *out)
{
    if (done >= count) return 0;
    out->row = row_of(plan, owner + done);
    out->offset = done;
    const int32_t room = plan->row[out->row].first + plan->row[out->row].count - (owner + done);
    out->count = count - done < room ? count - done : room;
    return 1;
}


/* counts the half runs and half bends of each row (pass 0), or writes them behind the rows' cursors (pass 1) */
static void spread_runs(const mus_cloth *cloth, mus__plan *plan, int32_t write)
{
    for (int32_t r = 0; r < cloth->nrun; r++) {
        const mus__spring_run *run = &cloth->run[r];
        const double mass = cloth->mass[run->a];
        const double dashpot = 2.0 * cloth->fabric.damping * sqrt(0.5 * run->k * mass);
        for (int32_t side = 0; side < 2; side++) {
            const int32_t owner = side ? run->b : run->a, other = side ? run->a : run->b;
            cut part;
            for (int32_t done = 0; cut_next(plan, owner, run->count, done, &part); done += part.count) {
                mus__plan_row *row = &plan->row[part.row];
                if (write)
                    plan->half_run[row->run + row->nrun] = (mus__half_run){
                        owner + part.offset, other + part.offset, part.count, run->k, run->rest, dashpot};
                row->nrun++;
            }
        }
    }
    for (int32_t r = 0; r < cloth->nbend; r++) {
        const mus__bend_run *bend = &cloth->bend[r];
        const int32_t owners[3] = {bend->a, bend->b, bend->c};
        for (int32_t side = 0; side < 3; side++) {
            cut part;
            for (int32_t done = 0; cut_next(plan, owners[side], bend->count, done, &part); done += part.count) {
                mus__plan_row *row = &plan->row[part.row];
                const int32_t at = part.offset;
                if (write)
                    plan->half_bend[row->bend + row->nbend] =
                        (mus__half_bend){.o = owners[side] + at,
                                         .a = bend->a + at,
                                         .b = bend->b + at,
                                         .c = bend->c + at,
                                         .count = part.count,
                                         .w = side == 1 ? 2.0 * bend->k : -bend->k};
                row->nbend++;
            }
        }
    }
}


/* the part of `bend` for owners first .. last-1 */
static mus__half_bend slice(mus__half_bend bend, int32_t first, int32_t last)
{
    const int32_t skip = first - bend.o;
    bend.a += skip, bend.b += skip, bend.c += skip, bend.d += skip;
    bend.o = first;
    bend.count = last - first;
    return bend;
}


/* take owners first .. last-1 out of entry i of the list: what is left before it stays, what is behind is appended */
static void take_out(mus__half_bend *list, int32_t *n, int32_t i, int32_t first, int32_t last)
{
    const mus__half_bend whole = list[i];
    const int32_t end = whole.o + whole.count;
    list[i] = slice(whole, whole.o, first);
    if (last < end) list[(*n)++] = slice(whole, last, end);
}


/*
 * Where a node is the end of one stencil, the middle of the next and the start of a third on the same line, the three
 * become one term of five points: half the loads. Makes one such term of entries m, e, s if they fit; returns whether.
 */
static int32_t merge_three(mus__half_bend *list, int32_t *n, int32_t m, int32_t e, int32_t s)
{
    const mus__half_bend middle = list[m], end = list[e], start = list[s];
    if (middle.whole || end.whole || start.whole || middle.o != middle.b || end.o != end.c || start.o != start.a)
        return 0;
    if (end.b - end.o != middle.a - middle.o || start.b - start.o != middle.c - middle.o) return 0;
    if (end.w != start.w || 2.0 * end.w != -middle.w) return 0;

    /* the owners that all three have */
    int32_t first = middle.o, last = middle.o + middle.count;
    if (end.o > first) first = end.o;
    if (start.o > first) first = start.o;
    if (end.o + end.count < last) last = end.o + end.count;
    if (start.o + start.count < last) last = start.o + start.count;
    if (first >= last) return 0;

    mus__half_bend whole = {.o = first, .count = last - first, .whole = 1, .w = -end.w};
    whole.a = first + end.a - end.o, whole.b = first + middle.a - middle.o;
    whole.c = first + middle.c - middle.o, whole.d = first + start.c - start.o;
    take_out(list, n, m, first, last);
    take_out(list, n, e, first, last);
    take_out(list, n, s, first, last);
    list[(*n)++] = whole;
    return 1;
}


static int32_t merge_any(mus__half_bend *list, int32_t *n)
{
    for (int32_t m = 0; m < *n; m++)
        for (int32_t e = 0; e < *n; e++)
            for (int32_t s = 0; s < *n; s++)
                if (merge_three(list, n, m, e, s)) return 1;
    return 0;
}


/* one row's bend terms, merged as far as there is room for the pieces left over; returns how many there are */
static int32_t merge_bends(mus__half_bend *list, int32_t n, int32_t room)
{
    while (n + 4 <= room && merge_any(list, &n)) {
    }
    int32_t kept = 0;
    for (int32_t i = 0; i < n; i++)
        if (list[i].count > 0) list[kept++] = list[i];
    return kept;
}


/* all rows' bend terms through merge_bends, packed */
static mus_status merge_rows(mus_context *context, mus__plan *plan)
{
    int32_t longest = 0;
    for (int32_t r = 0; r < plan->nrow; r++)
        if (plan->row[r].nbend > longest) longest = plan->row[r].nbend;
    mus__half_bend *packed = mus__new(context, 4 * (int64_t)plan->nhalf_bend, sizeof *packed);
    mus__half_bend *list = mus__new(context, 4 * (int64_t)longest, sizeof *list);
    if (packed == NULL || list == NULL) {
        mus__free(context, packed);
        mus__free(context, list);
        return mus__fail_memory(context, "the bending of a drape");
    }
    int32_t total = 0;
    for (int32_t r = 0; r < plan->nrow; r++) {
        mus__plan_row *row = &plan->row[r];
        memcpy(list, plan->half_bend + row->bend, (size_t)row->nbend * sizeof *list);
        const int32_t n = merge_bends(list, row->nbend, 4 * row->nbend);
        memcpy(packed + total, list, (size_t)n * sizeof *list);
        row->bend = total;
        row->nbend = n;
        total += n;
    }
    mus__free(context, list);
    mus__free(context, plan->half_bend);
    plan->half_bend = packed;
    plan->nhalf_bend = total;
    return MUS_OK;
}


static mus_status build_rows(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    plan->nrow = cloth->nrow;
    plan->row = mus__new(context, cloth->nrow, sizeof *plan->row);
    if (plan->row == NULL) return mus__fail_memory(context, "the rows of a drape");
    for (int32_t r = 0; r < cloth->nrow; r++) {
        plan->row[r].first = cloth->row[r].first;
        plan->row[r].count = cloth->row[r].count;
    }
    spread_runs(cloth, plan, 0);

    for (int32_t r = 0; r < plan->nrow; r++) {
        mus__plan_row *row = &plan->row[r];
        row->run = plan->nhalf_run;
        row->bend = plan->nhalf_bend;
        plan->nhalf_run += row->nrun;
        plan->nhalf_bend += row->nbend;
        row->nrun = row->nbend = 0;
    }
    plan->half_run = mus__new(context, plan->nhalf_run, sizeof *plan->half_run);
    plan->half_bend = mus__new(context, plan->nhalf_bend, sizeof *plan->half_bend);
    if (plan->half_run == NULL || plan->half_bend == NULL) return mus__fail_memory(context, "the runs of a drape");
    spread_runs(cloth, plan, 1);
    return merge_rows(context, plan);
}


/* ---- elements and who gathers them ---- */

/* node k of element e (springs 2, hinges 4, pairs 2) and its coefficient; returns 0 past the last */
static int32_t element_node(const mus__plan *plan, int32_t e, int32_t k, int32_t *node, double *coef)
{
    if (e < plan->nspring) {
        if (k > 1) return 0;
        *node = k ? plan->spring[e].b : plan->spring[e].a;
        *coef = k ? -1.0 : 1.0;
    } else if (e < plan->nspring + plan->nhinge) {
        if (k > 3) return 0;
        *node = plan->hinge[e - plan->nspring].node[k];
        *coef = -plan->hinge[e - plan->nspring].coef[k];
    } else {
        if (k > 1) return 0;
        const mus__pair *pair = &plan->pair[e - plan->nspring - plan->nhinge];
        *node = k ? pair->b : pair->a;
        *coef = k ? -1.0 : 1.0;
    }
    return 1;
}


/* gather lists by counting: per node, elements in ascending order. Uses the cloth's row list to know the lattice. */
static void build_gather(const mus_cloth *cloth, mus__plan *plan)
{
    const int32_t nelement = plan->nspring + plan->nhinge + plan->npair;
    int32_t node;
    double coef;

    /* count into slots by node: gather_lattice doubles as the counter over all nodes while we build */
    int32_t *count = plan->gather_lattice;
    memset(count, 0, (size_t)cloth->nnode * sizeof *count);
    for (int32_t e = 0; e < nelement; e++)
        for (int32_t k = 0; element_node(plan, e, k, &node, &coef); k++) count[node]++;

    /* nodes with any, ascending; start of each, kept for the filling pass in slot_of = gather_node by node */
    plan->ngather = 0;
    int32_t total = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        const int32_t n = count[i];
        count[i] = plan->ngather;
        if (n == 0) continue;
        plan->gather_node[plan->ngather] = i;
        plan->gather_start[plan->ngather++] = total;
        total += n;
    }
    plan->gather_start[plan->ngather] = total;

    for (int32_t e = 0; e < nelement; e++)
        for (int32_t k = 0; element_node(plan, e, k, &node, &coef); k++) {
            const int32_t at = plan->gather_start[count[node]]++;
            plan->gather_element[at] = e;
            plan->gather_coef[at] = coef;
        }
    for (int32_t i = plan->ngather; i > 0; i--) plan->gather_start[i] = plan->gather_start[i - 1];
    plan->gather_start[0] = 0;

    /* which gather nodes the row pass has written */
    memset(count, 0, (size_t)cloth->nnode * sizeof *count);
    for (int32_t g = 0, r = 0; g < plan->ngather; g++) {
        const int32_t i = plan->gather_node[g];
        while (r < plan->nrow && plan->row[r].first + plan->row[r].count <= i) r++;
        plan->gather_lattice[g] = r < plan->nrow && i >= plan->row[r].first;
    }
}


static mus_status build_elements(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    plan->spring_capacity = cloth->nspring;
    plan->hinge_capacity = cloth->nhinge + cloth->nseam_hinge;
    plan->gather_capacity = 2 * cloth->nspring + 4 * plan->hinge_capacity + 2 * cloth->npair;
    plan->spring = mus__new(context, plan->spring_capacity, sizeof *plan->spring);
    plan->spring_dashpot = mus__new(context, plan->spring_capacity, sizeof *plan->spring_dashpot);
    plan->hinge = mus__new(context, plan->hinge_capacity, sizeof *plan->hinge);
    plan->pair = mus__new(context, cloth->npair, sizeof *plan->pair);
    plan->gather_node = mus__new(context, cloth->nnode, sizeof *plan->gather_node);
    plan->gather_lattice = mus__new(context, cloth->nnode, sizeof *plan->gather_lattice);
    plan->gather_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *plan->gather_start);
    plan->gather_element = mus__new(context, plan->gather_capacity, sizeof *plan->gather_element);
    plan->gather_coef = mus__new(context, plan->gather_capacity, sizeof *plan->gather_coef);
    if (plan->spring == NULL || plan->spring_dashpot == NULL || plan->hinge == NULL || plan->pair == NULL ||
        plan->gather_node == NULL || plan->gather_lattice == NULL || plan->gather_start == NULL ||
        plan->gather_element == NULL || plan->gather_coef == NULL)
        return mus__fail_memory(context, "the elements of a drape");
    return MUS_OK;
}


mus_status mus__plan_build(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    memset(plan, 0, sizeof *plan);
    mus_status status = build_rows(context, cloth, plan);
    if (status == MUS_OK) status = build_elements(context, cloth, plan);
    if (status != MUS_OK) return status;
    plan->dashpots = cloth->fabric.damping > 0.0;
    for (int32_t s = 0; cloth->dashpot != NULL && s < cloth->nspring; s++)
        if (cloth->dashpot[s] > 0.0) plan->dashpots = 1;
    mus__plan_weld(cloth, NULL, plan);
    return MUS_OK;
}


void mus__plan_clear(mus_context *context, mus__plan *plan)
{
    mus__free(context, plan->row);
    mus__free(context, plan->half_run);
    mus__free(context, plan->half_bend);
    mus__free(context, plan->spring);
    mus__free(context, plan->spring_dashpot);
    mus__free(context, plan->hinge);
    mus__free(context, plan->pair);
    mus__free(context, plan->gather_node);
    mus__free(context, plan->gather_lattice);
    mus__free(context, plan->gather_start);
    mus__free(context, plan->gather_element);
    mus__free(context, plan->gather_coef);
    memset(plan, 0, sizeof *plan);
}


/* append hinges with their nodes renamed; a hinge that welding folded onto itself (two nodes the same) is left out */
static void add_hinges(mus__plan *plan, const mus__hinge *hinges, int32_t n, const int32_t *rep)
{
    for (int32_t h = 0; h < n; h++) {
        mus__hinge hinge = hinges[h];
        if (rep != NULL) {
            int32_t *i = hinge.node;
            for (int32_t k = 0; k < 4; k++) i[k] = rep[i[k]];
            if (i[0] == i[1] || i[2] == i[3] || i[0] == i[2] || i[0] == i[3] || i[1] == i[2] || i[1] == i[3]) continue;
        }
        plan->hinge[plan->nhinge++] = hinge;
    }
}


void mus__plan_weld(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan)
{
    plan->nspring = plan->nhinge = plan->npair = 0;
    for (int32_t s = 0; s < cloth->nspring; s++) {
        mus__spring spring = cloth->spring[s];
        const double mass = 0.5 * (cloth->mass[spring.a] + cloth->mass[spring.b]);
        if (rep != NULL) spring.a = rep[spring.a], spring.b = rep[spring.b];
        if (spring.a == spring.b) continue;
        plan->spring_dashpot[plan->nspring] = cloth->dashpot != NULL
                                                  ? cloth->dashpot[s]
                                                  : 2.0 * cloth->fabric.damping * sqrt(0.5 * spring.k * mass);
        plan->spring[plan->nspring++] = spring;
    }
    add_hinges(plan, cloth->hinge, cloth->nhinge, rep);
    if (rep != NULL) {
        add_hinges(plan, cloth->seam_hinge, cloth->nseam_hinge, rep);
    } else {
        for (int32_t p = 0; p < cloth->npair; p++)
            plan->pair[p] = (mus__pair){cloth->pair[2 * p], cloth->pair[2 * p + 1], 0, 0.0, cloth->pair_length[p]};
        plan->npair = cloth->npair;
    }
    build_gather(cloth, plan);

    /* springs counted once: half runs make two of each, half bends three */
    plan->spring_evaluations = plan->nspring + plan->nhinge + plan->npair;
    for (int32_t r = 0; r < cloth->nrun; r++) plan->spring_evaluations += cloth->run[r].count;
    for (int32_t r = 0; r < cloth->nbend; r++) plan->spring_evaluations += cloth->bend[r].count;
}

