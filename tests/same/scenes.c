/*
 * scenes.c: rows "scenes/...": garments placed, sewn and settled; and "fit/...": how some of them fit.
 *
 * Lattices are coarse and most bodies have one garment each, so that all families of designs, all groups of sizes and
 * all ways that a drape can take are there and most rows take half a second. Garments over one another take longest: of
 * many pairs these three take the least, 5 to 7 s each.
 */
#include "scene.h"

#include <stdio.h>
#include <string.h>

#define SPEC(number, body) "garmentcode/specs/d11_" number "_" body "_specification.json", body
#define MEN "m_smpl_average_A40"

static const same_scene scenes[] = {
    {NULL, "tshirt", "W40", 30, 0, NULL},
    {NULL, "tshirt", "W40", 20, 0, NULL},
    {NULL, "tshirt", "W40", 30, SCENE_SELF, NULL},
    {NULL, "tshirt", "W40", 30, SCENE_DOUBLE, NULL},
    {NULL, "tshirt", "W40", 30, SCENE_PAPER, NULL},
    {NULL, "tshirt", "W40", 20, SCENE_ONE_CUT, NULL},
    {NULL, "tshirt", "W40", 30, SCENE_FOUND, NULL},
    {NULL, "tshirt", "W40", 30, SCENE_SELF | SCENE_DOUBLE, NULL},
    {NULL, "tshirt", "W52", 40, 0, NULL},
    {NULL, "tshirt", "M50", 30, 0, NULL},
    {NULL, "tshirt", "C116", 25, 0, NULL},
    {NULL, "tshirt", "C68", 20, 0, NULL},
    {"tshirt-denim", "tshirt", "W40", 30, 0, "denim"},
    {NULL, "sleeveless", "W36", 30, 0, NULL},
    {NULL, "sleeveless", "M46", 30, SCENE_SELF, NULL},
    {NULL, "bodice", "W40", 25, 0, NULL},
    {NULL, "bodice", "W34", 25, SCENE_SELF, NULL},
    {NULL, "skirt", "W40", 30, 0, NULL},
    {NULL, "skirt", "W40", 20, 0, NULL},
    {NULL, "skirt", "W46", 30, SCENE_SELF, NULL},
    {NULL, "skirt", "W40", 30, SCENE_SELF | SCENE_FOUND, NULL},
    {NULL, "tee_v", "W44", 30, 0, NULL},
    {NULL, "tee_v", "M56", 30, SCENE_SELF, NULL},
    {NULL, "oxford_shirt", "M50", 40, 0, NULL},
    {NULL, "oxford_shirt", "W40", 40, SCENE_SELF, NULL},
    {NULL, "shirt_short", "M50", 40, SCENE_SELF | SCENE_ONCE, "cotton"},
    {NULL, "shirt_long", "W40", 40, SCENE_OPEN, NULL},
    {NULL, "sheath", "W38", 30, 0, NULL},
    {NULL, "sheath", "W48", 30, SCENE_SELF, NULL},
    {NULL, "jeans", "W40", 40, 0, "denim"},
    {NULL, "jeans", "M52", 40, SCENE_SELF, "denim"},
    {NULL, "coat", "W40", 40, 0, NULL},
    {NULL, "coat", "W42", 40, SCENE_SELF, NULL},
    {NULL, "hoodie", "M50", 40, 0, NULL},
    {NULL, "hoodie", "W40", 40, SCENE_SELF, NULL},
    {NULL, "cape_hood_knee", "W40", 40, 0, NULL},
    {NULL, "cape_mini", "W40", 40, SCENE_SELF, NULL},
    {NULL, "wrap_dress", "W40", 40, 0, NULL},
    {NULL, "wrap_skirt_knee", "W40", 40, SCENE_SELF, NULL},
    {NULL, "quarter_skirt_midi", "W40", 40, 0, NULL},
    {NULL, "half_skirt_knee", "W40", 40, SCENE_SELF, NULL},
    {NULL, "gathered_skirt_knee", "W40", 30, 0, NULL},
    {NULL, "gored6_skirt_knee", "W40", 40, SCENE_SELF, NULL},
    {NULL, "kilt", "W40", 30, 0, NULL},
    {NULL, "kilt", "W40", 40, SCENE_SELF, NULL},
    {NULL, "tiered_skirt_mini", "W40", 40, 0, NULL},
    {NULL, "blouse_mandarin_long", "W40", 40, 0, NULL},
    {NULL, "blouse_peter_pan_short", "W40", 40, SCENE_SELF, NULL},
    {NULL, "blouse_jewel_puff", "W40", 40, 0, NULL},
    {NULL, "blouse_jewel_raglan", "W40", 40, SCENE_SELF, NULL},
    {NULL, "kimono_top", "W40", 40, 0, NULL},
    {NULL, "boiler_suit", "M50", 50, 0, NULL},
    {NULL, "jumpsuit_v_wide", "W40", 40, SCENE_SELF, NULL},
    {NULL, "romper", "W40", 40, 0, NULL},
    {NULL, "child_gathered_short", "C104", 30, 0, NULL},
    {NULL, "child_half_long", "C140", 40, SCENE_SELF, NULL},
    {NULL, "corset_top", "W40", 30, 0, NULL},
    {NULL, "halter_waist_waist", "W40", 30, SCENE_SELF, NULL},
    {NULL, "leggings", "W40", 40, 0, NULL},
    {NULL, "joggers", "M58", 40, SCENE_SELF, NULL},
    {NULL, "straight_shorts", "C128", 30, 0, NULL},
    {NULL, "harem_elastic", "W40", 40, 0, NULL},
    {NULL, "ball_gown", "W40", 50, 0, NULL},
    {NULL, "nightgown", "W50", 50, SCENE_SELF, NULL},
    {NULL, "apron_dress", "W40", 40, 0, NULL},
    {NULL, "poncho_hood", "W40", 50, SCENE_SELF, NULL},
    {NULL, "waistcoat", "M50", 30, SCENE_SELF, NULL},
    {NULL, "pyjama_trousers", "C152", 40, 0, NULL},
    {"full_skirt_midi", "full_skirt_midi", "W40", 40, SCENE_SELF, NULL},
    {"full_skirt_mini", "full_skirt_mini", "W36", 30, SCENE_SELF, NULL},
    {"kilt-self", "kilt", "W40", 40, SCENE_SELF, NULL},
    {"box_skirt_mini", "box_skirt_mini", "W36", 30, 0, NULL},
    {"words-boxy", "top neck=square sleeve=long shape=boxy", "W40", 40, 0, NULL},
    {"over-bodice-waistcoat", "bodice+waistcoat", "W40", 30, SCENE_SELF, NULL},
    {"over-sleeveless-waistcoat", "sleeveless+waistcoat", "W40", 30, SCENE_SELF, NULL},
    {"over-leggings-skirt", "leggings+skirt", "W40", 30, SCENE_SELF, NULL},
    {"spec-000", SPEC("000", "mean_all"), 40, 0, NULL},
    {"spec-003", SPEC("003", "mean_all"), 30, SCENE_SELF, NULL},
    {"spec-006", SPEC("006", "mean_all"), 40, 0, NULL},
    {"spec-012", SPEC("012", MEN), 40, SCENE_SELF, NULL},
    {"spec-016", SPEC("016", MEN), 40, 0, NULL},
    {"spec-023", SPEC("023", MEN), 40, SCENE_FOUND, NULL},
    {"spec-027", SPEC("027", "mean_all"), 40, SCENE_FOUND, NULL},
    {"spec-030", SPEC("030", "mean_female"), 40, SCENE_SELF, NULL},
    {"spec-036", SPEC("036", MEN), 40, SCENE_FOUND | SCENE_SELF, NULL},
    {"spec-043", SPEC("043", "mean_female"), 40, 0, NULL},
    {"spec-046", SPEC("046", "mean_female"), 40, SCENE_FOUND, NULL},
    {"spec-049", SPEC("049", "mean_female"), 40, 0, NULL},
    {"spec-pencil", "garmentcode/originals/dress_pencil_specification.json", "mean_all", 30, 0, NULL},
    {"spec-shirt", "garmentcode/originals/shirt_mean_specification.json", "mean_all", 30, SCENE_SELF, NULL},
    {"scan-tshirt", "tshirt", "mean_female", 30, SCENE_SCAN, NULL},
    {"scan-skirt", "skirt", "mean_all", 30, SCENE_SCAN | SCENE_SELF, NULL},
    {"scan-spec-043", SPEC("043", "mean_female"), 40, SCENE_SCAN, NULL},
    {"scan-trousers", "straight_trousers", MEN, 40, SCENE_SCAN, NULL},
};

static const same_scene fits[] = {
    {NULL, "tshirt", "W40", 25, 0, NULL},
    {NULL, "skirt", "W44", 25, 0, NULL},
    {NULL, "bodice", "W40", 25, SCENE_SELF, NULL},
    {NULL, "leggings", "W40", 40, 0, NULL},
    {"over-bodice-waistcoat", "bodice+waistcoat", "W40", 30, SCENE_SELF, NULL},
    {"spec-030", SPEC("030", "mean_female"), 40, 0, NULL},
};


static void make_scene(same_run *run, const void *what, int32_t index)
{
    (void)index;
    const same_dressed d = same_place(run, what);
    same_text(run, mus_drape_skipped(d.drape));
    same_wear(run, &d);
    same_drape(run, d.drape, d.cloth);
}


static void make_fit(same_run *run, const void *what, int32_t index)
{
    (void)index;
    const same_dressed d = same_place(run, what);
    same_wear(run, &d);
    same_fit(run, &d);
}


/* the row of a scene: garment, tape, spacing and flags are its name */
static void add_scene(same_list *list, const char *group, const same_scene *scene,
                      void (*make)(same_run *run, const void *what, int32_t index))
{
    static const char *const words[] = {"self", "found", "double", "scan", "open", "paper", "one_cut", "once"};
    const char *name = scene->name != NULL ? scene->name : scene->garment;
    same_row *row = same_add(list, make, "%s/%s-%s-%.0fmm", group, name, scene->tape, scene->spacing);
    for (int i = 0; i < 8; i++) {
        const size_t length = strlen(row->name);
        if (scene->flags & (1 << i)) snprintf(row->name + length, sizeof row->name - length, "-%s", words[i]);
    }
    row->what = scene;
    row->data = scene->tape[0] >= 'a';
}


void same_scenes(same_list *list)
{
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) add_scene(list, "scenes", &scenes[i], make_scene);
    for (size_t i = 0; i < sizeof fits / sizeof *fits; i++) add_scene(list, "fit", &fits[i], make_fit);
}
