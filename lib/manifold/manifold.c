/*
 * manifold.c: the body as one closed surface. A stranger starts here. In the order of use:
 *
 *     manifold_solid.c          the solids whose union is the body: radius fields of its parts, fingers and toes
 *     manifold_cell.c           cells of a lattice: inside, outside, or near the surface
 *     manifold_grow.c           the part of what is inside that is a ball, where the body touches itself
 *     manifold_lattice.c        which points of the cells are inside, and where edges cross the surface
 *     manifold_snap.c           points moved onto the surface, for well shaped triangles
 *     manifold_mesh.c           the triangles
 *
 * Callers: examples, and whoever prints or carves a body. Nothing in the library needs it.
 */
#include "manifold/manifold_internal.h"

/* web between two digits, in spacings: it fills gaps up to half of it; chosen: a gap of one spacing has points of the
 * lattice in it everywhere */
#define MANIFOLD_WEB 2.4


void mus_manifold_def_init(mus_manifold_def *def, size_t size)
{
    mus_manifold_def own = {.spacing = 0.004, .threads = 1};
    mus__def_init(def, size, &own, sizeof own);
}


/* free the arrays of a manifold, to make them again */
static void manifold_clear(mus_manifold *manifold)
{
    mus__free(manifold->context, manifold->vertex);
    mus__free(manifold->context, manifold->normal);
    mus__free(manifold->context, manifold->triangle);
    *manifold = (mus_manifold){.context = manifold->context};
}


/* the surface of the solids; of the largest part of them that is a ball where `grown`, or where the surface has not the
 * Euler characteristic of a sphere. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
static mus_status manifold_surface(mus__bcc *lattice, bool grown, mus_manifold *out, int32_t *euler)
{
    mus_status status = mus__bcc_sample(lattice);
    if (status != MUS_OK) return status;
    mus__bcc_compare(lattice, MUS__CELLS_SHARED);
    status = mus__bcc_beside(lattice, MUS__CELLS_SHARED);
    if (status == MUS_OK && (grown || mus__bcc_euler(lattice) != 2)) status = mus__bcc_grow(lattice, grown);
    if (status == MUS_OK) status = mus__bcc_cross(lattice);
    if (status == MUS_OK) status = mus__bcc_snap(lattice);
    if (status != MUS_OK) return status;
    mus__bcc_polish(lattice);
    return mus__bcc_mesh(lattice, out, euler);
}


static mus_status manifold_make(mus_context *context, const mus__solids *solids, const mus_manifold_def *def,
                                mus_manifold *out)
{
    mus__pool *pool;
    int32_t euler = 0;
    mus_status status = mus__pool_create(context, def->threads, &pool);
    if (status != MUS_OK) return status;
    for (int grown = 0; grown < 2; grown++) {
        mus__bcc lattice;
        manifold_clear(out);
        status = mus__bcc_make(context, pool, solids, def->spacing, &lattice);
        if (status == MUS_OK) status = manifold_surface(&lattice, grown > 0, out, &euler);
        mus__bcc_free(&lattice);
        if (status != MUS_OK || (out->pieces == 1 && euler == 2)) break;
    }
    if (status == MUS_OK && (out->pieces == 0 || euler != 2 * out->pieces))
        status = mus__fail(context, MUS_ERR_BODY,
                           "a spacing of %g m gives no closed surface of this body; a smaller one may", def->spacing);
    mus__pool_destroy(pool);
    return status;
}


mus_status mus_manifold_create(const mus_body *body, const mus_manifold_def *def, mus_manifold **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (body == NULL) return MUS_ERR_ARG;
    mus_context *context = body->context;
    mus_manifold_def own;
    mus_manifold_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, def, "mus_manifold_def");
    if (status != MUS_OK) return status;
    if (!(own.spacing >= 0.001 && own.spacing <= 0.03))
        return mus__fail(context, MUS_ERR_ARG, "spacing %g m is outside 0.001 to 0.03 m", own.spacing);

    mus_manifold *manifold = mus__new(context, 1, sizeof *manifold);
    mus__solids *solids = mus__new(context, 1, sizeof *solids);
    if (manifold != NULL) manifold->context = context;
    if (manifold == NULL || solids == NULL) {
        status = mus__fail_memory(context, "a manifold");
    } else {
        mus__solids_make(body, MANIFOLD_WEB * own.spacing, solids);
        status = manifold_make(context, solids, &own, manifold);
    }
    mus__free(context, solids);
    if (status == MUS_OK) *out = manifold;
    else mus_manifold_destroy(manifold);
    return status;
}


void mus_manifold_destroy(mus_manifold *manifold)
{
    if (manifold == NULL) return;
    manifold_clear(manifold);
    mus__free(manifold->context, manifold);
}


int32_t mus_manifold_vertex_count(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->vertices : 0;
}


int32_t mus_manifold_triangle_count(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->triangles : 0;
}


int32_t mus_manifold_piece_count(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->pieces : 0;
}


int32_t mus_manifold_cut_count(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->cuts : 0;
}


double mus_manifold_volume(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->volume : 0.0;
}


const double *mus_manifold_vertices(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->vertex : NULL;
}


const double *mus_manifold_normals(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->normal : NULL;
}


const int32_t *mus_manifold_triangles(const mus_manifold *manifold)
{
    return manifold != NULL ? manifold->triangle : NULL;
}
