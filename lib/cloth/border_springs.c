/*
 * border_springs.c: springs and hinges of the triangles between the full cells and the border, and the limit on
 * stiffness.
 *
 * Each edge of a strip triangle is a spring with k = C(direction) * sum of (area / length^2) over its strip triangles.
 * For triangles that are halves of cells this equals the lattice (fabric.c). An edge shared with a full cell gets half
 * a lattice spring in addition. Each inner edge of a strip triangle is a hinge. With x0 x1 the edge of length l, x2 and
 * x3 the opposite corners, s the positions of their feet along the edge and h their heights,
 *
 *     c = ((l - s2) / h2 + (l - s3) / h3,  s2 / h2 + s3 / h3,  -l / h2,  -l / h3),   sum c_i x_i = l * (angle) *
 * normal, E = 1/2 B / (A2 + A3) |sum c_i x_i|^2.
 *
 * The factor 1 (Bergou et al. print 3) gives a sheet of equilateral triangles the rigidity B (Seung and Nelson 1988:
 * hinge 2 B / sqrt(3)). Measured on cylinders of every direction, the energy is 1.00 of the exact one there, and 0.97
 * to 1.5 on half squares with diagonals in a checkerboard. calibrate_bending.c corrects the sum over the panel.
 * Source: Van Gelder 1998 (springs); Bergou, Wardetzky, Harmon, Zorin and Grinspun 2006 (quadratic hinges).
 */
#include <math.h>

#include "base/elementary.h"
#include "cloth/mesh.h"
#include "geom/vec.h"

/* largest stiffness over mass of a node, as a multiple of that of an inner lattice node; springs of stiffer nodes are
 * softened. The stable step is proportional to 1 / sqrt of it, so the strip makes steps at most 1.5 times smaller than
 * the lattice does. Chosen: a smaller value softens more springs (of 137 GarmentCode patterns at 10 mm, 54 have no node
 * above it), a larger one lets a single edge of half a millimetre set the step of the garment */
#define STRIP_LIMIT 2.25
/* rounds of the iteration for the cap of a node; measured: four reach the final value except in rare fans of triangles.
 * With fewer rounds springs are softer than necessary, never too stiff */
#define STRIP_PASSES 5
/* least area of a triangle with a hinge, over the square of the spacing; the angles of a smaller one are rounding */
#define STRIP_SLIVER 1e-6

/* one side of one triangle, filed under its end with the lower index */
typedef struct strip_half {
    int32_t high, opposite; /* end with the higher index; opposite corner */
    bool strip;             /* whether the triangle is of the strip, not of a full cell */
} strip_half;


static const double *strip_rest(const mus__mesh *mesh, int32_t node)
{
    return mesh->cloth->rest + 2 * (ptrdiff_t)node;
}


/* Writes the foot along the edge a b and the height above it [m] of the opposite corner. */
static void strip_wing(const mus__mesh *mesh, int32_t a, int32_t b, int32_t corner, double *foot, double *height)
{
    const double *p = strip_rest(mesh, a), *q = strip_rest(mesh, b), *r = strip_rest(mesh, corner);
    double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1], length = mus__hypot(ux, uy);
    *foot = (ux * vx + uy * vy) / length;
    *height = fabs(ux * vy - uy * vx) / length;
}


bool mus__mesh_hinge(const mus__mesh *mesh, const int32_t *node, double length, const double *foot,
                     const double *height, double rigidity, mus__hinge *out)
{
    double sliver = STRIP_SLIVER * mesh->cloth->spacing * mesh->cloth->spacing;
    if (!(length * height[0] > sliver && length * height[1] > sliver && rigidity > 0.0)) return false;
    *out = (mus__hinge){.node = {node[0], node[1], node[2], node[3]},
                        .coef = {(length - foot[0]) / height[0] + (length - foot[1]) / height[1],
                                 foot[0] / height[0] + foot[1] / height[1], -length / height[0], -length / height[1]},
                        .k = rigidity / (0.5 * length * (height[0] + height[1])),
                        .area = 0.5 * length * (height[0] + height[1])};
    return true;
}


/*
 * Adds the bending spring of Metaaphanon and Kanongchaiyos 2005 across an edge of length l: it joins the two wings,
 * which are D apart in the flat. A fold by the angle t shortens it by h2 h3 t^2 / (2 D), so its moment is k (h2 h3)^2
 * t^3 / (2 D^2); that of the hinge is 2 B l t / (h2 + h3). k makes them equal at t = K (h2 + h3) / 2, the fold on a
 * cylinder of curvature K.
 */
static mus_status strip_skip(mus__mesh *mesh, int32_t a, int32_t b, double length, const double *height,
                             double rigidity)
{
    mus_cloth *cloth = mesh->cloth;
    double flat = mus__dist2(strip_rest(mesh, a), strip_rest(mesh, b)), wide = height[0] + height[1];
    double product = height[0] * height[1] * mesh->paper;
    double sliver = STRIP_SLIVER * mesh->cloth->spacing * mesh->cloth->spacing;
    if (!(length * height[0] > sliver && length * height[1] > sliver && rigidity > 0.0)) return MUS_OK;
    mus__spring spring = {a, b, MUS__SPRING_SKIP, 0.0, flat};
    spring.k = 16.0 * rigidity * length * flat * flat / (wide * wide * wide * product * product);
    mus_status status =
        mus__reserve(mesh->context, &cloth->spring, &mesh->cap_spring, (int64_t)cloth->nspring + 1, sizeof spring);
    if (status == MUS_OK) cloth->spring[cloth->nspring++] = spring;
    return status;
}


/* Adds the spring of edge a b and, between two triangles, its hinge, from the one or two triangle sides given. */
static mus_status strip_edge(mus__mesh *mesh, const mus__lattice *lattice, int32_t a, int32_t b, const strip_half *half,
                             int32_t nhalf)
{
    mus_cloth *cloth = mesh->cloth;
    const double *p = strip_rest(mesh, a), *q = strip_rest(mesh, b);
    double length = mus__dist2(p, q), foot[2] = {0.0, 0.0}, height[2] = {0.0, 0.0}, shape = 0.0;
    bool rim = false;
    for (int32_t i = 0; i < nhalf; i++) {
        strip_wing(mesh, a, b, half[i].opposite, &foot[i], &height[i]);
        if (half[i].strip)
            shape += 0.5 * height[i] / length;
        else
            rim = true;
    }

    /* direction in the frame of the fabric */
    double x = (q[0] - p[0]) / length, y = (q[1] - p[1]) / length;
    double weft = x * lattice->weft[0] + y * lattice->weft[1], warp = x * lattice->warp[0] + y * lattice->warp[1];
    mus__spring spring = {a, b, MUS__SPRING_BORDER, mus__fabric_stretch(&cloth->fabric, weft, warp) * shape, length};
    if (rim) {
        spring.kind = fabs(warp) > fabs(weft) ? MUS__SPRING_WARP : MUS__SPRING_WEFT;
        spring.k += 0.5 * mesh->constant.k[spring.kind];
    }
    mus_status status =
        mus__reserve(mesh->context, &cloth->spring, &mesh->cap_spring, (int64_t)cloth->nspring + 1, sizeof spring);
    if (status != MUS_OK) return status;
    cloth->spring[cloth->nspring++] = spring;
    if (nhalf < 2) return MUS_OK;

    /* a hinge bends across its edge */
    const int32_t node[4] = {a, b, half[0].opposite, half[1].opposite};
    const double rigidity = mus__fabric_bend(&cloth->fabric, warp, weft);
    if (mesh->paper > 0.0) return strip_skip(mesh, node[2], node[3], length, height, rigidity);
    mus__hinge hinge;
    if (!mus__mesh_hinge(mesh, node, length, foot, height, rigidity, &hinge)) return MUS_OK;
    status = mus__reserve(mesh->context, &cloth->hinge, &mesh->cap_hinge, (int64_t)cloth->nhinge + 1, sizeof hinge);
    if (status == MUS_OK) cloth->hinge[cloth->nhinge++] = hinge;
    return status;
}


/* Notes the opposite corner of a side of one triangle only, which is a border side, for hinges across seams. */
static void strip_border(mus__mesh *mesh, const mus__panel_mesh *panel, int32_t a, int32_t b, int32_t opposite)
{
    int32_t first = panel->first_node + panel->lattice_count;
    mesh->wing[panel->first_border + (b == a + 1 ? a : b) - first] = opposite;
}


/* Sorts triangle sides into buckets by their lower end (start has one entry more than nodes), and within a bucket by
 * their higher end. */
static void strip_sort(const mus__mesh *mesh, const mus__panel_mesh *panel, int32_t nstrip, int32_t *start,
                       strip_half *half)
{
    const int32_t *triangle = mesh->cloth->triangle + 3 * (ptrdiff_t)panel->first_triangle;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t t = 0; t < panel->triangle_count; t++) {
            const int32_t *v = triangle + 3 * (ptrdiff_t)t;
            for (int k = 0; k < 3; k++) {
                int32_t a = v[k], b = v[(k + 1) % 3], low = (a < b ? a : b) - panel->first_node;
                if (pass == 0) {
                    start[low + 1]++;
                    continue;
                }

                /* insertion sort; unused entries are 0 and stop the shift */
                int32_t at = start[low]++, from = low > 0 ? start[low - 1] : 0;
                strip_half own = {a < b ? b : a, v[(k + 2) % 3], t < nstrip};
                for (; at > from && half[at - 1].high > own.high; at--) half[at] = half[at - 1];
                half[at] = own;
            }
        }
        if (pass == 0)
            for (int32_t i = 0; i < panel->node_count; i++) start[i + 1] += start[i];
    }
}


mus_status mus__mesh_strip(mus__mesh *mesh, const mus__lattice *lattice, const mus__panel_mesh *panel, int32_t nstrip)
{
    int32_t *start = mus__new(mesh->context, (int64_t)panel->node_count + 1, sizeof *start);
    strip_half *half = mus__new(mesh->context, 3 * (int64_t)panel->triangle_count, sizeof *half);
    mus_status status = MUS_OK;
    if (start == NULL || half == NULL)
        status = mus__fail_memory(mesh->context, "the sides of a panel's triangles");
    else
        strip_sort(mesh, panel, nstrip, start, half);

    /* after the sort, start[low] is the end of bucket `low` and start[low - 1] its beginning */
    for (int32_t low = 0; status == MUS_OK && low < panel->node_count; low++)
        for (int32_t at = low > 0 ? start[low - 1] : 0; status == MUS_OK && at < start[low];) {
            int32_t n = at + 1 < start[low] && half[at + 1].high == half[at].high ? 2 : 1, a = panel->first_node + low;
            if (half[at].strip || (n == 2 && half[at + 1].strip))
                status = strip_edge(mesh, lattice, a, half[at].high, half + at, n);
            if (n == 1) strip_border(mesh, panel, a, half[at].high, half[at].opposite);
            at += n;
        }
    mus__free(mesh->context, start);
    mus__free(mesh->context, half);
    return status;
}


/* Adds to sum (nnode) [N/m] each node's row sum of the stiffness matrix of the runs and their stencils, which bounds
 * its largest eigenvalue (Gershgorin). */
static void strip_fixed(const mus_cloth *cloth, double *sum)
{
    for (int32_t r = 0; r < cloth->nrun; r++)
        for (int32_t i = 0; i < cloth->run[r].count; i++) {
            sum[cloth->run[r].a + i] += 2.0 * cloth->run[r].k;
            sum[cloth->run[r].b + i] += 2.0 * cloth->run[r].k;
        }
    for (int32_t r = 0; r < cloth->nbend; r++)
        for (int32_t i = 0; i < cloth->bend[r].count; i++) {
            sum[cloth->bend[r].a + i] += 4.0 * cloth->bend[r].k;
            sum[cloth->bend[r].b + i] += 8.0 * cloth->bend[r].k;
            sum[cloth->bend[r].c + i] += 4.0 * cloth->bend[r].k;
        }
}


/* Element e of springs, hinges and seam hinges: *k points to its stiffness; node and part get its nodes and its
 * contribution to the row sum of each [N/m]. Returns the number of nodes. */
static int32_t strip_parts(mus_cloth *cloth, int32_t e, double **k, int32_t *node, double *part)
{
    if (e < cloth->nspring) {
        mus__spring *spring = &cloth->spring[e];
        node[0] = spring->a, node[1] = spring->b;
        part[0] = part[1] = 2.0 * spring->k;
        *k = &spring->k;
        return 2;
    }
    e -= cloth->nspring;
    mus__hinge *hinge = e < cloth->nhinge ? &cloth->hinge[e] : &cloth->seam_hinge[e - cloth->nhinge];
    double size = fabs(hinge->coef[0]) + fabs(hinge->coef[1]) + fabs(hinge->coef[2]) + fabs(hinge->coef[3]);
    for (int i = 0; i < 4; i++) node[i] = hinge->node[i], part[i] = hinge->k * size * fabs(hinge->coef[i]);
    *k = &hinge->k;
    return 4;
}


/*
 * Computes the cap of each node (nnode) [N/m]: when all contributions above the cap are lowered to it, their sum equals
 * `room`, the sum that the node may have. The cap grows from room / number of contributions in each round, because
 * contributions below it leave more to the others. With too few rounds it is too low, never too high.
 */
static void strip_caps(mus_cloth *cloth, const double *room, double *cap, double *low, int32_t *high)
{
    int32_t count = cloth->nspring + cloth->nhinge + cloth->nseam_hinge, node[4];
    double part[4], *k;
    for (int32_t i = 0; i < cloth->nnode; i++) cap[i] = 0.0;
    for (int pass = 0; pass < STRIP_PASSES; pass++) {
        for (int32_t i = 0; i < cloth->nnode; i++) low[i] = 0.0, high[i] = 0;
        for (int32_t e = 0; e < count; e++)
            for (int32_t n = strip_parts(cloth, e, &k, node, part); n-- > 0;) {
                if (part[n] <= cap[node[n]])
                    low[node[n]] += part[n];
                else
                    high[node[n]]++;
            }
        for (int32_t i = 0; i < cloth->nnode; i++)
            cap[i] = high[i] > 0 ? fmax(room[i] - low[i], 0.0) / high[i] : (double)INFINITY;
    }
}


/* Lowers the stiffness of each element to the smallest cap of its nodes. */
static void strip_soften(mus_cloth *cloth, const double *sum, const double *room, const double *cap)
{
    int32_t count = cloth->nspring + cloth->nhinge + cloth->nseam_hinge, node[4];
    double part[4], *k;
    for (int32_t e = 0; e < count; e++) {
        double factor = 1.0;
        for (int32_t n = strip_parts(cloth, e, &k, node, part); n-- > 0;)
            if (sum[node[n]] > room[node[n]] && part[n] > cap[node[n]])
                factor = fmin(factor, cap[node[n]] / part[n]);
        *k *= factor;
    }
}


mus_status mus__mesh_limit(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    const mus__fabric_lattice *c = &mesh->constant;
    const int32_t count = cloth->nspring + cloth->nhinge + cloth->nseam_hinge;
    double *work = mus__new(mesh->context, 4 * (int64_t)cloth->nnode, sizeof *work);
    int32_t *high = mus__new(mesh->context, cloth->nnode, sizeof *high), node[4];
    if (work != NULL && high != NULL) {
        double *room = work, *sum = room + cloth->nnode, *cap = sum + cloth->nnode, *low = cap + cloth->nnode;

        /* row sum of an inner node: 2 springs a direction, 4 diagonals, stencils 4 + 8 + 4 in 4 directions */
        double inner = 4.0 * (c->k[0] + c->k[1]) + 8.0 * c->shear + 16.0 * (c->bend[0] + c->bend[1] + 2.0 * c->cross) +
                       4.0 * (c->skip[0] + c->skip[1]);
        double most = STRIP_LIMIT * inner / (cloth->fabric.weight * cloth->spacing * cloth->spacing);
        strip_fixed(cloth, sum);
        for (int32_t i = 0; i < cloth->nnode; i++) room[i] = fmax(most * cloth->mass[i] - sum[i], 0.0), sum[i] = 0.0;

        /* many cloths have no node above the limit */
        double part[4], *k;
        bool over = false;
        for (int32_t e = 0; e < count; e++)
            for (int32_t n = strip_parts(cloth, e, &k, node, part); n-- > 0;) {
                sum[node[n]] += part[n];
                over = over || sum[node[n]] > room[node[n]];
            }
        if (over) {
            strip_caps(cloth, room, cap, low, high);
            strip_soften(cloth, sum, room, cap);
        }
    }
    bool done = work != NULL && high != NULL;
    mus__free(mesh->context, work);
    mus__free(mesh->context, high);
    return done ? MUS_OK : mus__fail_memory(mesh->context, "the limit on stiffness");
}
