/*
 * test_mesh_homology.c: the mesh of a pattern, its seam pairs glued, is the same space as the sewn pattern: the same
 * homology over the integers and as many rims; of every named design and of GarmentCode specifications.
 */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/cloth.h"
#include "muslin/design.h"
#include "muslin/exchange.h"
#include "muslin/topology.h"
#include "topology/homology.h"
#include "support.h"


static int32_t root_of(int32_t *parent, int32_t i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}


typedef struct mesh_side {
    int32_t low, high, triangle, along;
} mesh_side;


static int by_ends(const void *a, const void *b)
{
    const mesh_side *s = a, *t = b;
    if (s->low != t->low) return s->low < t->low ? -1 : 1;
    if (s->high != t->high) return s->high < t->high ? -1 : 1;
    return s->triangle < t->triangle ? -1 : 1;
}


/* vertices of a mesh by class: nodes that a pair joins are one */
static int32_t *mesh_classes(const mus_cloth *cloth)
{
    int32_t n = mus_cloth_node_count(cloth), *parent = malloc((size_t)n * sizeof *parent);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    for (int32_t i = 0; i < n; i++) parent[i] = i;
    for (int32_t k = 0; k < mus_cloth_pair_count(cloth); k++) {
        int32_t a = root_of(parent, pairs[2 * k]), b = root_of(parent, pairs[2 * k + 1]);
        parent[a > b ? a : b] = a > b ? b : a;
    }
    for (int32_t i = 0; i < n; i++) parent[i] = root_of(parent, i);
    return parent;
}


/* homology of the mesh, and its number of rims */
static mus_homology mesh_homology(mus_context *context, const mus_cloth *cloth, int32_t *rims)
{
    int32_t n = mus_cloth_node_count(cloth), ntriangle = mus_cloth_triangle_count(cloth), nside = 3 * ntriangle;
    int32_t *class = mesh_classes(cloth), *number = malloc((size_t)n * sizeof *number);
    int32_t *triple[2] = {malloc(6 * (size_t)nside * sizeof(int32_t)), malloc(3 * (size_t)nside * sizeof(int32_t))};
    int32_t *rim = malloc((size_t)n * sizeof *rim), cells[3] = {0, 0, ntriangle}, count[2] = {0, 0};
    mesh_side *side = malloc((size_t)nside * sizeof *side);
    const int32_t *triangles = mus_cloth_triangles(cloth);
    for (int32_t i = 0; i < n; i++) number[i] = MUS_NONE, rim[i] = MUS_NONE;
    for (int32_t k = 0; k < nside; k++) {
        int32_t a = class[triangles[k]], b = class[triangles[k % 3 == 2 ? k - 2 : k + 1]];
        ck_assert_int_ne(a, b);
        side[k] = (mesh_side){a < b ? a : b, a < b ? b : a, k / 3, a < b ? 1 : -1};
        number[a] = number[b] = 0;
    }
    for (int32_t i = 0; i < n; i++)
        if (number[i] == 0) number[i] = cells[0]++;

    /* sides between the same classes are one edge */
    qsort(side, (size_t)nside, sizeof *side, by_ends);
    for (int32_t k = 0, j; k < nside; k = j) {
        int32_t ends[6] = {number[side[k].low], cells[1], -1, number[side[k].high], cells[1], 1};
        memcpy(triple[0] + 3 * count[0], ends, sizeof ends);
        count[0] += 2;
        for (j = k; j < nside && side[j].low == side[k].low && side[j].high == side[k].high; j++) {
            int32_t one[3] = {cells[1], side[j].triangle, side[j].along};
            memcpy(triple[1] + 3 * count[1]++, one, sizeof one);
        }
        cells[1]++;
        if (j > k + 1) continue;

        /* one triangle: a piece of a rim */
        int32_t *end[2] = {&rim[side[k].low], &rim[side[k].high]};
        if (*end[0] == MUS_NONE) *end[0] = side[k].low;
        if (*end[1] == MUS_NONE) *end[1] = side[k].high;
        rim[root_of(rim, side[k].low)] = root_of(rim, side[k].high);
    }
    *rims = 0;
    for (int32_t i = 0; i < n; i++) *rims += rim[i] == i;
    mus_homology h;
    mus_homology_init(&h, sizeof h);
    ck_assert_int_eq(mus__homology(context, cells, count, triple, &h, NULL, 0), MUS_OK);
    free(class), free(number), free(triple[0]), free(triple[1]), free(rim), free(side);
    return h;
}


/* false when the pattern is not fit to be cut: four specifications have outlines that touch themselves */
static bool check_mesh(const mus_pattern *pattern, double spacing, const char *name)
{
    mus_context *context = mus_pattern_context(pattern);
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = spacing;
    mus_cloth *cloth;
    mus_status status = mus_cloth_create(context, pattern, &def, &cloth);
    if (status == MUS_ERR_PATTERN) return false;
    ck_assert_msg(status == MUS_OK, "%s: %s", name, mus_context_error(context));
    mus_homology sewn;
    mus_homology_init(&sewn, sizeof sewn);
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &sewn, NULL, 0), MUS_OK);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    int32_t rims;
    mus_homology mesh = mesh_homology(context, cloth, &rims);
    ck_assert_msg(memcmp(mesh.betti, sewn.betti, sizeof mesh.betti) == 0 && mesh.euler == sewn.euler &&
                      mesh.torsion == sewn.torsion,
                  "%s: mesh %d %d %d, pattern %d %d %d", name, (int)mesh.betti[0], (int)mesh.betti[1],
                  (int)mesh.betti[2], (int)sewn.betti[0], (int)sewn.betti[1], (int)sewn.betti[2]);
    if (t.manifold) ck_assert_msg(rims == t.loops, "%s: mesh %d rims, pattern %d", name, (int)rims, (int)t.loops);
    mus_cloth_destroy(cloth);
    return true;
}


START_TEST(every_design_has_the_homology_of_its_mesh)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    ck_assert_int_eq(status, MUS_OK);
    for (int32_t d = 0; d < mus_design_count(); d += d < 5 ? 1 : 23) {
        mus_pattern *pattern;
        status = mus_design_draft(context, d, tape, NULL, &pattern);
        if (status == MUS_ERR_DESIGN) continue;
        ck_assert_int_eq(status, MUS_OK);
        ck_assert(check_mesh(pattern, 0.04, mus_design_name(d)));
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(specifications_have_the_homology_of_their_meshes)
{
    char path[1024], name[512];
    if (support_data("garmentcode/specs", path, sizeof path) == NULL) return;
    DIR *folder = opendir(path);
    ck_assert_ptr_nonnull(folder);
    int32_t seen = 0;
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        /* the designs on one body */
        if (strstr(entry->d_name, "specification.json") == NULL) continue;
        if (strstr(entry->d_name, "mean_all") == NULL) continue;
        snprintf(name, sizeof name, "garmentcode/specs/%s", entry->d_name);
        ck_assert_ptr_nonnull(support_data(name, path, sizeof path));
        mus_context *context = support_context();
        mus_pattern *pattern;
        ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
        seen += check_mesh(pattern, 0.04, entry->d_name);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
    closedir(folder);
    ck_assert_int_gt(seen, 40);
}
END_TEST


Suite *mus_suite_mesh_homology(void);


Suite *mus_suite_mesh_homology(void)
{
    Suite *suite = suite_create("mesh_homology");
    TCase *tcase = tcase_create("mesh_homology");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, every_design_has_the_homology_of_its_mesh);
    tcase_add_test(tcase, specifications_have_the_homology_of_their_meshes);
    suite_add_tcase(suite, tcase);
    return suite;
}
