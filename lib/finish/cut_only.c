/*
 * cut_only.c: the panels that a garment needs to be sewn and that are not draped, by the words of its style:
 *
 *   neck       a knit with a round, V, square or boat neck and no collar: a band of rib; any other neck without a
 *              collar, and a neck with a collar that lies flat: facings
 *   armhole    without a sleeve: of a knit a band of rib, else facings
 *   waist      band=facing: facings
 *   fly        trousers that open in front: fly facing and shield; with a band also belt loops
 *   pocket     a pocket that is marked on a panel and is no panel itself: a patch; one that is a slit: its
 *              welt, flap and bag. A kangaroo pocket. Trousers with pockets have front pockets too: facings and bags
 *   collar     an under-collar
 *   slit       a placket for each slit of a sleeve
 *   buttons    interfacing of the button stand
 *   elastic    every edge with an elastic: its tape
 *   wrap       ties
 *   coat       body and sleeves are cut of lining too
 *
 * All are drawn from the drafted pattern: facings are traced from its edges, strips have the lengths of its edges.
 * Blocks (ease=block, band=none) are drafts to work on, and get none. A rib is as long as MUS__RIB_PART of its edge.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "finish/cut_only.h"


/* whether an edge is free and has the label, on a panel that is no collar or hood; an empty label: any */
static bool cut_free(const mus__cut_only *job, int32_t edge, const char *label)
{
    const char *part = mus_pattern_panel_label(job->pattern, mus_pattern_edge_panel(job->pattern, edge));
    return mus_pattern_edge_seam(job->pattern, edge) == MUS_NONE && strcmp(part, "collar") != 0 &&
           strcmp(part, "hood") != 0 && strcmp(mus_pattern_edge_label(job->pattern, edge), label) == 0;
}


/* length of all free edges with a label [m] */
static double cut_length(const mus__cut_only *job, const char *label)
{
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++)
        if (cut_free(job, i, label)) length += mus_pattern_edge_length(job->pattern, i);
    return length;
}


/* part of the free edges with a label that is on panels called back...: between the ends of a rib that is joined at
 * centre back and its seams */
static double cut_behind(const mus__cut_only *job, const char *label)
{
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++)
        if (cut_free(job, i, label) &&
            strncmp(mus_pattern_panel_name(job->pattern, mus_pattern_edge_panel(job->pattern, i)), "back", 4) == 0)
            length += mus_pattern_edge_length(job->pattern, i);
    return length / fmax(cut_length(job, label), 1e-9);
}


/* the allowance of the free edges with a label [m], which what is sewn to them has too; 0 without one */
static double cut_allowance(const mus__cut_only *job, const char *label)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++)
        if (cut_free(job, i, label)) return fmax(mus_pattern_edge_allowance(job->pattern, i), 0.0);
    return 0.0;
}


/* a band of rib, folded along its middle, its ends sewn to a ring; 2 cm high when folded (chosen). Its ends meet at
 * centre back, or at the underarm; notches are at the seams that it passes and at its middle */
static void cut_rib(mus__cut_only *job, const char *label, const char *name, double length, int32_t count)
{
    const double high = 2.0 * job->scale * MUS__CM, behind = cut_behind(job, label), own = cut_allowance(job, label);
    mus__cut_strip strip = {.name = name,
                            .label = "rib",
                            .length = MUS__RIB_PART * length,
                            .width = high,
                            .seam = own,
                            .turned = high + (own > 0.0 ? own : MUS__SEAM_ALLOWANCE),
                            .material = MUS_MATERIAL_RIB,
                            .count = count};
    if (count == 1) {
        strip.nnotch = 3;
        strip.notch[0] = 0.5 * behind, strip.notch[1] = 0.5, strip.notch[2] = 1.0 - 0.5 * behind;
    } else {
        strip.nnotch = 1;
        strip.notch[0] = behind;
    }
    mus__cut_strip_add(job, &strip);
}


/* what finishes the neck: a band of rib on a knit, facings on a woven or under a collar that lies flat */
static void cut_neck(mus__cut_only *job, const mus__style *style)
{
    const int32_t collar = style->option[MUS__AXIS_COLLAR], neck = style->option[MUS__AXIS_NECK];
    const bool flat = collar == MUS__COLLAR_PETER_PAN || collar == MUS__COLLAR_SHAWL || collar == MUS__COLLAR_SAILOR;
    if (collar != MUS__COLLAR_NONE && !flat) return;
    if (style->option[MUS__AXIS_SHAPE] == MUS__SHAPE_NECK_GATHERS) return;
    if (style->option[MUS__AXIS_CLOTH] == MUS__CLOTH_KNIT && !flat && neck <= MUS__NECK_BOAT)
        cut_rib(job, "neck", "neckband", cut_length(job, "neck"), 1);
    else mus__cut_facings(job, "neck", "_facing");
}


/* what finishes an armhole without a sleeve: a band of rib on a knit, facings on a woven */
static void cut_armhole(mus__cut_only *job, const mus__style *style)
{
    if (style->option[MUS__AXIS_SLEEVE] != MUS__SLEEVE_NONE || style->option[MUS__AXIS_GARMENT] == MUS__GARMENT_CAPE)
        return;
    const bool halter = style->option[MUS__AXIS_NECK] == MUS__NECK_HALTER;
    if (style->option[MUS__AXIS_CLOTH] == MUS__CLOTH_KNIT && !halter)
        cut_rib(job, "armhole", "armhole_band", 0.5 * cut_length(job, "armhole"), 2);
    else mus__cut_facings(job, "armhole", "_armhole_facing");
}


/* height of the waistband, that of its ends at the side [m]; 0 without one */
static double cut_band(const mus__cut_only *job)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        const char *part = mus_pattern_panel_label(job->pattern, mus_pattern_edge_panel(job->pattern, i));
        if ((strcmp(part, "band") == 0 || strcmp(part, "elastic") == 0) &&
            strcmp(mus_pattern_edge_label(job->pattern, i), "side") == 0)
            return mus_pattern_edge_length(job->pattern, i);
    }
    return 0.0;
}


/* A fly facing of 4 cm along the zip; a shield, folded, that lies under it as far as the underlap of the band; and a
 * strip for five belt loops of 1 cm. Each loop is as long as the band is high, with 1.5 cm turned in at both ends. All
 * sizes are chosen, for the scale of an adult. */
static void cut_fly(mus__cut_only *job, const mus__style *style)
{
    const int32_t leg = mus_pattern_find_panel(job->pattern, "leg_front_left");
    const int32_t zip = mus_pattern_find_edge(job->pattern, leg, "zip");
    const double cm = job->scale * MUS__CM, band = cut_band(job), lap = MUS__UNDERLAP * job->scale;
    if (style->option[MUS__AXIS_CLOSURE] != MUS__CLOSURE_FRONT || zip == MUS_NONE) return;
    mus__cut_fly(job, 4.0 * cm);
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "fly_shield", .label = "fly",
                                              .length = mus_pattern_edge_length(job->pattern, zip),
                                              .width = lap, .turned = lap + MUS__SEAM_ALLOWANCE,
                                              .lengthwise = true, .material = MUS_MATERIAL_MAIN, .count = 1});
    if (band > 0.0)
        mus__cut_strip_add(job, &(mus__cut_strip){.name = "belt_loops", .label = "loop",
                                                  .length = 5.0 * (band + 3.0 * cm), .width = 1.0 * cm,
                                                  .lengthwise = true, .material = MUS_MATERIAL_MAIN, .count = 1});
}


/* patches of the pockets that are marks alone */
static void cut_pockets(mus__cut_only *job)
{
    int32_t count = 0, n = 0;
    const double *xy = NULL;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++) {
        const char *name;
        int32_t points;
        const double *own;
        if (mus_pattern_mark(job->pattern, i, NULL, &name, &points, &own) != MUS_OK) continue;
        if (strcmp(name, "pocket") != 0 || points != 5) continue;
        xy = own, n = points;
        count++;
    }
    for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern); i++)
        if (strncmp(mus_pattern_panel_name(job->pattern, i), "pocket_", 7) == 0) count--;
    if (count <= 0 || n == 0) return;
    const double wide = fabs(xy[4] - xy[0]), high = fabs(xy[1] - xy[3]);
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "pocket", .label = "pocket", .length = wide, .width = high,
                                              .turned = MUS__HEM_ALLOWANCE, .material = MUS_MATERIAL_MAIN,
                                              .count = count});
}


/* Welt or flap of each slit that is marked, with its interfacing, and the bag of two layers. A welt is folded along its
 * upper edge; above a flap, which is cut twice, lies one of 1 cm. The bag is a hand deep (chosen) */
static void cut_welts(mus__cut_only *job, const char *mark)
{
    int32_t count = 0;
    double wide = 0.0, high = 0.0;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++) {
        const char *name;
        int32_t n;
        const double *xy;
        if (mus_pattern_mark(job->pattern, i, NULL, &name, &n, &xy) != MUS_OK || n != 5) continue;
        if (strcmp(name, mark) != 0) continue;
        wide = fabs(xy[4] - xy[0]), high = fabs(xy[1] - xy[3]);
        count++;
    }
    const double cm = job->scale * MUS__CM, welt = strcmp(mark, "flap") == 0 ? 1.0 * cm : high;
    if (count == 0) return;
    if (welt < high)
        mus__cut_strip_add(job, &(mus__cut_strip){.name = "flap", .label = "pocket part", .length = wide,
                                                  .width = high, .material = MUS_MATERIAL_MAIN, .count = 2 * count,
                                                  .interfacing = count});
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "welt", .label = "pocket part", .length = wide, .width = welt,
                                              .turned = welt + MUS__SEAM_ALLOWANCE, .material = MUS_MATERIAL_MAIN,
                                              .count = count, .interfacing = count});
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "welt_bag", .label = "bag", .length = wide + 2.0 * cm,
                                              .width = 17.0 * cm, .material = MUS_MATERIAL_LINING,
                                              .count = 2 * count});
}


/* a placket for each slit of a sleeve: a strip round both its edges, 1.25 cm wide when folded (chosen) */
static void cut_plackets(mus__cut_only *job)
{
    int32_t count = 0;
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++) {
        const char *name;
        int32_t n;
        const double *xy;
        if (mus_pattern_mark(job->pattern, i, NULL, &name, &n, &xy) != MUS_OK || n != 2) continue;
        if (strcmp(name, "slit") != 0) continue;
        length = 2.0 * mus__dist2(xy, xy + 2);
        count++;
    }
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "sleeve_placket",
                                              .label = "placket",
                                              .length = length,
                                              .width = 2.5 * job->scale * MUS__CM,
                                              .halved = true,
                                              .lengthwise = true,
                                              .material = MUS_MATERIAL_MAIN,
                                              .count = count});
}


/* ties of a wrap: one goes round the waist and is tied to the other in a bow; 3 cm wide when folded. All chosen */
static void cut_ties(mus__cut_only *job)
{
    const double cm = job->scale * MUS__CM;
    double waist = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        const char *label = mus_pattern_edge_label(job->pattern, i);
        const char *part = mus_pattern_panel_label(job->pattern, mus_pattern_edge_panel(job->pattern, i));
        if (strcmp(part, "skirt") == 0 && (strcmp(label, "waist") == 0 || strcmp(label, "band") == 0))
            waist += mus_pattern_edge_length(job->pattern, i);
    }
    for (int32_t i = 0; i < 2; i++)
        mus__cut_strip_add(job, &(mus__cut_strip){.name = i == 0 ? "tie_long" : "tie_short", .label = "tie",
                                                  .length = i == 0 ? waist + 50.0 * cm : 60.0 * cm, .width = 3.0 * cm,
                                                  .turned = 3.0 * cm + MUS__SEAM_ALLOWANCE, .lengthwise = true,
                                                  .material = MUS_MATERIAL_MAIN, .count = 1});
}


/* a coat is lined: body and sleeves are cut of lining as often as of the cloth */
static void cut_lining(mus__cut_only *job, mus_pattern *pattern)
{
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern) && job->status == MUS_OK; i++) {
        const char *part = mus_pattern_panel_label(pattern, i);
        int32_t main = 0;
        if (strcmp(part, "body") != 0 && strcmp(part, "arm") != 0) continue;
        job->status = mus_pattern_cut(pattern, i, &main, NULL);
        if (job->status == MUS_OK) job->status = mus_pattern_set_material(pattern, i, MUS_MATERIAL_LINING, main);
    }
}


/* strips for the button stand of both fronts; where one side is longer it is an underlap and no stand */
static void cut_stand(mus__cut_only *job)
{
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_seam_count(job->pattern); i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(job->pattern, i, &seam) != MUS_OK || seam.closure != MUS_CLOSURE_BUTTONS) continue;
        const double stand = mus_pattern_edge_allowance(job->pattern, seam.edge_a);
        if (stand == mus_pattern_edge_allowance(job->pattern, seam.edge_b))
            length += mus_pattern_edge_length(job->pattern, seam.edge_a);
    }
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "button_stand",
                                              .label = "closure",
                                              .length = length,
                                              .width = 2.0 * MUS__BUTTON_STAND,
                                              .halved = true,
                                              .lengthwise = true,
                                              .material = MUS_MATERIAL_INTERFACING,
                                              .count = 2});
}


/* The tape of all elastic edges: a ring with 2 cm to lap, or two halves where a closure parts it. It is 1 cm wide
 * (chosen), or as wide as its casing leaves room for. */
static void cut_elastic(mus__cut_only *job)
{
    double length = 0.0, width = 0.01;
    int32_t count = 0, twins = 0;
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        double ratio, stiffness;
        int32_t of = MUS_NONE;
        const int32_t panel = mus_pattern_edge_panel(job->pattern, i);
        if (mus_pattern_edge_elastic(job->pattern, i, &ratio, &stiffness) != MUS_OK || !(stiffness > 0.0)) continue;
        length += ratio * mus_pattern_edge_length(job->pattern, i);
        mus_pattern_cut(job->pattern, panel, NULL, &of);
        count++;
        twins += of != MUS_NONE;
        /* a casing is 5 mm wider than its elastic */
        if (strcmp(mus_pattern_panel_label(job->pattern, panel), "elastic") == 0) width = cut_band(job) - 0.005;
    }
    const int32_t parts = count > 0 && 2 * twins == count ? 2 : 1;
    if (count == 0) return;
    mus__cut_strip_add(job, &(mus__cut_strip){.name = "elastic", .label = "elastic", .length = length / parts + 0.02,
                                              .width = width, .lengthwise = true, .material = MUS_MATERIAL_ELASTIC,
                                              .count = parts});
}


mus_status mus__cut_only_make(const mus__style *style, double scale, mus_pattern *pattern)
{
    const int32_t garment = style->option[MUS__AXIS_GARMENT];
    mus__cut_only job = {.pattern = pattern, .scale = scale};
    if (style->option[MUS__AXIS_EASE] == MUS__EASE_BLOCK) return MUS_OK;
    job.status = mus_pattern_create(mus_pattern_context(pattern), mus_pattern_name(pattern), &job.made);
    if (job.status != MUS_OK) return job.status;
    if (mus__style_has(garment, MUS__AXIS_NECK)) {
        cut_neck(&job, style);
        cut_armhole(&job, style);
    }
    const bool waist = garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_TROUSERS;
    if (waist && style->option[MUS__AXIS_BAND] == MUS__BAND_FACING && !(cut_band(&job) > 0.0))
        mus__cut_facings(&job, "waist", "_waist_facing");
    if (garment == MUS__GARMENT_TROUSERS) cut_fly(&job, style);
    cut_pockets(&job);
    mus__cut_kangaroo(&job);
    cut_welts(&job, "welt");
    cut_welts(&job, "flap");
    if (garment == MUS__GARMENT_TROUSERS && style->option[MUS__AXIS_POCKET] != MUS__POCKET_NONE)
        mus__cut_front_pocket(&job, pattern);
    mus__cut_under_collars(&job, pattern);
    cut_plackets(&job);
    cut_stand(&job);
    cut_elastic(&job);
    if (mus__style_has(garment, MUS__AXIS_SKIRT) && style->option[MUS__AXIS_SKIRT] == MUS__SKIRT_WRAP) cut_ties(&job);
    if (mus__style_has(garment, MUS__AXIS_EASE) && style->option[MUS__AXIS_EASE] == MUS__EASE_COAT)
        cut_lining(&job, pattern);
    if (job.status == MUS_OK && mus_pattern_panel_count(job.made) > 0)
        job.status = mus_pattern_set_cut_only(pattern, job.made);
    mus_pattern_destroy(job.made);
    return job.status;
}
