/*
 * worn_loops.c: the boundary loops of a cloth with all seams sewn.
 *
 * Nodes that seam pairs join are one class. An edge between two classes that an odd number of triangles have is a
 * border edge: a sheet that goes on beyond it has two of them, so one sheet ends there, as the end that is tied onto a
 * seam does. Border edges are followed from class to class, forwards where the sides of the panels agree. At a class
 * where several loops touch, the walk stays with the panel that it came on.
 */
#include <string.h>

#include "base/sort.h"
#include "fit/worn_internal.h"
#include "geom/union_find.h"
#include "geom/vec.h"
#include "selfcontact/self_contact.h"

typedef struct loop_edge { /* of a triangle, from node to node, right side of the cloth on the left hand */
    int32_t low, high;     /* classes */
    int32_t from, to;      /* nodes */
} loop_edge;


static int loop_by_classes(const void *a, const void *b)
{
    const loop_edge *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    if (p->high != q->high) return p->high < q->high ? -1 : 1;
    return p->from < q->from ? -1 : p->from > q->from;
}


/* of the edges i .. end - 1 of the same classes, an odd number, one that runs as most of them do */
static int32_t loop_odd(const loop_edge *edge, int32_t i, int32_t end, const int32_t *class_of)
{
    int32_t forwards = 0;
    for (int32_t k = i; k < end; k++) forwards += class_of[edge[k].from] == edge[k].low;
    const bool most = 2 * forwards > end - i;
    while ((class_of[edge[i].from] == edge[i].low) != most) i++;
    return i;
}


/* the edges that an odd number of triangles have, in order of their classes; returns how many */
static int32_t loop_border(const mus_cloth *cloth, const int32_t *class_of, loop_edge *edge)
{
    int32_t n = 0, border = 0;
    for (int32_t k = 0; k < 3 * cloth->ntriangle; k++) {
        const int32_t from = cloth->triangle[k], to = cloth->triangle[k % 3 == 2 ? k - 2 : k + 1];
        const int32_t a = class_of[from], b = class_of[to];
        if (a != b) edge[n++] = (loop_edge){a < b ? a : b, a < b ? b : a, from, to};
    }
    mus__sort(edge, (size_t)n, sizeof *edge, loop_by_classes);
    for (int32_t i = 0, next; i < n; i = next) {
        for (next = i + 1; next < n && edge[next].low == edge[i].low && edge[next].high == edge[i].high;) next++;
        if ((next - i) % 2 == 1) edge[border++] = edge[loop_odd(edge, i, next, class_of)];
    }
    return border;
}


/* the border edges at each class, as lists: head (nnode), next (2 x border); entry 2 i + 1 is the end of edge i */
typedef struct loop_net {
    const loop_edge *edge;
    int32_t *head, *next;
    const int32_t *class_of, *panel;
} loop_net;


/* how well entry k goes on after an edge of `panel`: forwards before backwards, the same panel before others */
static int32_t loop_merit(const loop_net *net, int32_t k, int32_t panel)
{
    const loop_edge *edge = &net->edge[k / 2];
    return 2 * (k % 2 == 0) + (net->panel[edge->from] == panel);
}


/* take both entries of an edge out of the lists */
static void loop_take(const loop_net *net, int32_t edge)
{
    for (int32_t end = 0; end < 2; end++) {
        const loop_edge *own = &net->edge[edge];
        int32_t *link = &net->head[net->class_of[end == 0 ? own->from : own->to]];
        while (*link != 2 * edge + end) link = &net->next[*link];
        *link = net->next[*link];
    }
}


/* follow the border edges from edge i until the walk is back, or at its end; returns how many nodes it wrote */
static int32_t loop_follow(const mus_cloth *cloth, const loop_net *net, int32_t i, int32_t *node, double *length)
{
    const int32_t start = net->class_of[net->edge[i].from];
    int32_t count = 0, entry = 2 * i;
    *length = 0.0;
    for (int32_t at = MUS_NONE; at != start;) {
        const loop_edge *one = &net->edge[entry / 2];
        const int32_t from = entry % 2 == 0 ? one->from : one->to, to = entry % 2 == 0 ? one->to : one->from;
        loop_take(net, entry / 2);
        *length += mus__dist2(cloth->rest + 2 * (ptrdiff_t)from, cloth->rest + 2 * (ptrdiff_t)to);
        node[count++] = from;
        at = net->class_of[to], entry = MUS_NONE;
        for (int32_t k = net->head[at]; k != MUS_NONE; k = net->next[k])
            if (entry == MUS_NONE || loop_merit(net, k, net->panel[from]) > loop_merit(net, entry, net->panel[from]))
                entry = k;
        if (entry == MUS_NONE) break;
    }
    return count;
}


/* all loops of at least three nodes; list (nnode + 2 x border) is scratch */
static void loop_walk(const mus_cloth *cloth, const loop_edge *edge, int32_t border, int32_t *list,
                      mus__worn_loops *out)
{
    const loop_net net = {edge, list, list + cloth->nnode, out->class_of, cloth->node_panel};
    int32_t first = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) net.head[i] = MUS_NONE;
    for (int32_t k = 2 * border; k-- > 0;) {
        int32_t *head = &net.head[out->class_of[k % 2 == 0 ? edge[k / 2].from : edge[k / 2].to]];
        net.next[k] = *head, *head = k;
    }
    for (int32_t i = 0; i < border; i++) {
        int32_t left = net.head[out->class_of[edge[i].from]];
        double length;
        while (left != MUS_NONE && left != 2 * i) left = net.next[left];
        if (left == MUS_NONE) continue;
        const int32_t count = loop_follow(cloth, &net, i, out->node + first, &length);
        if (count < 3) continue;
        out->loop[out->nloop++] = (mus__worn_loop){.first = first, .count = count, .length = length};
        first += count;
    }
}


/* component of each loop; root (npanel) is scratch */
static void loop_components(const mus_cloth *cloth, int32_t *root, mus__worn_loops *out)
{
    mus__union_start(cloth->npanel, root, NULL);
    for (int32_t k = 0; k < cloth->npair; k++)
        mus__union_join(root, NULL, cloth->node_panel[cloth->pair[2 * k]], cloth->node_panel[cloth->pair[2 * k + 1]],
                        1);
    for (int32_t l = 0; l < out->nloop; l++)
        out->loop[l].component =
            mus__union_find(root, NULL, cloth->node_panel[out->node[out->loop[l].first]]);
}


mus_status mus__worn_loops_make(mus_context *context, const mus_cloth *cloth, mus__worn_loops *out)
{
    *out = (mus__worn_loops){.context = context};
    loop_edge *edge = mus__new(context, 3 * (int64_t)cloth->ntriangle, sizeof *edge);
    int32_t *work = NULL;
    out->class_of = mus__new(context, cloth->nnode, sizeof *out->class_of);
    mus_status status = edge != NULL && out->class_of != NULL ? MUS_OK : MUS_ERR_MEMORY;
    if (status == MUS_OK) {
        mus__self_classes(cloth->nnode, cloth->npair, cloth->pair, out->class_of);
        const int32_t border = loop_border(cloth, out->class_of, edge);
        out->node = mus__new(context, border + 1, sizeof *out->node);
        out->loop = mus__new(context, border / 3 + 1, sizeof *out->loop);
        work = mus__new(context, (int64_t)cloth->nnode + cloth->npanel + 2 * (int64_t)border, sizeof *work);
        status = out->node != NULL && out->loop != NULL && work != NULL ? MUS_OK : MUS_ERR_MEMORY;
        if (status == MUS_OK) {
            loop_walk(cloth, edge, border, work, out);
            loop_components(cloth, work, out);
        }
    }
    mus__free(context, work);
    mus__free(context, edge);
    return status == MUS_OK ? MUS_OK : mus__fail_memory(context, "the openings of a garment");
}


void mus__worn_loops_free(mus__worn_loops *loops)
{
    mus__free(loops->context, loops->node);
    mus__free(loops->context, loops->class_of);
    mus__free(loops->context, loops->loop);
}
