/*
 * pleat_folds.c: the fold lines of pleats, for the arrangement of the cloth before sewing.
 *
 * A pleat is three consecutive edges of a rim that laid seams join in turn; the upper edge of the first pair is the
 * visible one. Folds run at right angles to the edge; a fold is stored as its distance along the edge. All pleats of a
 * panel lie on one edge, in order along it.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "cloth/mesh.h"
#include "geom/vec.h"

/* least cosine between edges of consecutive pleats. Chosen: within 8 degrees they count as one straight edge */
#define PLEAT_ALONG 0.99


/* is edge a laid on edge b (+1), or b on a (-1)? */
static int32_t pleat_laid(const mus__mesh *mesh, int32_t a, int32_t b)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    for (int32_t s = 0; s < mus_pattern_seam_count(mesh->pattern); s++) {
        if (mus_pattern_seam(mesh->pattern, s, &seam) != MUS_OK || !seam.laid) continue;
        if (seam.edge_a == a && seam.edge_b == b) return 1;
        if (seam.edge_a == b && seam.edge_b == a) return -1;
    }
    return 0;
}


/* where place i of the rim starts */
static void pleat_corner(const mus__mesh *mesh, int32_t i, double *out)
{
    int32_t ends[2], panel;
    mus_pattern_edge_ends(mesh->pattern, mesh->rim[i], &ends[0], &ends[1]);
    mus_pattern_point(mesh->pattern, ends[mesh->turn[i] > 0 ? 0 : 1], &panel, out);
}


/* the pleat of three places of the rim, before the fourth; false when it is none that goes on from `last` (or NULL) */
static bool pleat_read(const mus__mesh *mesh, const int32_t *place, const mus__pleat *last, mus__pleat *out)
{
    const int32_t first = pleat_laid(mesh, mesh->rim[place[0]], mesh->rim[place[1]]);
    const int32_t second = pleat_laid(mesh, mesh->rim[place[1]], mesh->rim[place[2]]);
    double corner[4][2], along[2];
    if (first == 0 || second != first) return false;
    for (int32_t k = 0; k < 4; k++) pleat_corner(mesh, place[k], corner[k]);
    for (int32_t d = 0; d < 2; d++) along[d] = corner[3][d] - corner[0][d];
    const double length = mus__hypot(along[0], along[1]);
    if (!(length > 0.0)) return false;
    for (int32_t d = 0; d < 2; d++) along[d] /= length;
    if (last != NULL && along[0] * last->along[0] + along[1] * last->along[1] < PLEAT_ALONG) return false;
    memcpy(out->along, last != NULL ? last->along : along, sizeof along);
    double fold[2];
    for (int32_t k = 0; k < 2; k++) fold[k] = corner[1 + k][0] * out->along[0] + corner[1 + k][1] * out->along[1];
    out->outer = fold[first > 0 ? 0 : 1], out->inner = fold[first > 0 ? 1 : 0];
    return last == NULL || fmin(fold[0], fold[1]) >= fmax(last->outer, last->inner);
}


mus_status mus__mesh_pleats(mus__mesh *mesh)
{
    mus_cloth *cloth = mesh->cloth;
    bool any = false;
    for (int32_t s = 0; s < mus_pattern_seam_count(mesh->pattern) && !any; s++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        any = mus_pattern_seam(mesh->pattern, s, &seam) == MUS_OK && seam.laid;
    }
    for (int32_t p = 0; p < cloth->npanel && any; p++) {
        const int32_t from = mesh->first_rim[p], n = mesh->first_rim[p + 1] - from, first = cloth->npleat;
        for (int32_t i = 0; i < n; i++) {
            const int32_t place[4] = {from + i, from + (i + 1) % n, from + (i + 2) % n, from + (i + 3) % n};
            mus__pleat pleat = {.panel = p};
            if (!pleat_read(mesh, place, cloth->npleat > first ? &cloth->pleat[cloth->npleat - 1] : NULL, &pleat))
                continue;
            const mus_status status = mus__reserve(mesh->context, &cloth->pleat, &mesh->cap_pleat,
                                                   (int64_t)cloth->npleat + 1, sizeof pleat);
            if (status != MUS_OK) return status;
            cloth->pleat[cloth->npleat++] = pleat;
        }
    }
    return MUS_OK;
}
