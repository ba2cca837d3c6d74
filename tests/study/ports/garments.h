/*
 * garments.h: G(design, size, bits of the state): 100 garments that come to rest at the spacing of hashes.c, with and
 * without self-contact. Of 250 designs evenly from the named ones 118 do, on sizes in turn (palazzo, the dirndl and
 * tee_crew on others); these are the 100 that take the least time. The cloth of the others is too coarse for them at
 * that spacing, above all for openings and bands.
 */
#ifndef MUS_PORTS_GARMENTS_H
#define MUS_PORTS_GARMENTS_H

#define GARMENTS(G)                                                                                                    \
    G(tshirt, W40, 32) G(skirt, M46, 64) G(tee_crew, W52, 32) G(corset_top, W34, 64) G(blouse_jewel_elbow, W40, 32)    \
    G(blouse_scoop_sleeveless, W40, 64) G(blouse_v_cap, W34, 64) G(blouse_v_three_quarter, W50, 32)                    \
    G(blouse_boat_short, W40, 64) G(blouse_sweetheart_sleeveless, W40, 32) G(blouse_keyhole_long, W50, 64)             \
    G(blouse_mandarin_sleeveless, W34, 64) G(blouse_mandarin_long, W50, 32) G(blouse_peter_pan_sleeveless, W40, 64)    \
    G(top_waist_scoop_short, W40, 32) G(top_shoulder_waist_jewel_short, W40, 64)                                       \
    G(top_shoulder_waist_square_short, W40, 32) G(top_french_scoop_short, W50, 32)                                     \
    G(top_empire_scoop_sleeveless, W34, 64) G(top_empire_square_sleeveless, W40, 64)                                   \
    G(strapless_side_waist_crop, W34, 32) G(strapless_french_waist, W40, 32)                                           \
    G(strapless_princess_armhole_waist, W34, 64) G(strapless_cf_gathers_waist, W40, 64)                                \
    G(halter_side_waist_waist, W34, 32) G(halter_french_waist, W40, 32) G(halter_princess_armhole_waist, W34, 64)      \
    G(knit_jewel_elbow, W34, 32) G(knit_scoop_short, W40, 32) G(knit_scoop_long, M46, 64)                              \
    G(knit_crop_short, M50, 64) G(knit_waist_short, W34, 32) G(knit_close_short, W40, 32)                              \
    G(knit_close_sleeveless, M46, 64) G(straight_skirt_knee, W40, 64) G(pencil_skirt_mini, W34, 32)                    \
    G(a_line_mini, C116, 64) G(a_line_skirt_maxi, W40, 32) G(gored4_skirt_midi, W34, 64)                               \
    G(gored6_skirt_knee, W50, 32) G(gored8_skirt_mini, W40, 64) G(gored8_skirt_maxi, W34, 32)                          \
    G(quarter_skirt_maxi, W50, 64) G(half_skirt_midi, W40, 32) G(three_quarter_skirt_mini, C116, 64)                   \
    G(poodle_skirt, W40, 64) G(full_skirt_hi_low, W34, 32) G(dirndl_skirt, W40, 64) G(knife_skirt_mini, W40, 32)      \
    G(knife_skirt_maxi, W34, 64) G(box_skirt_midi, W50, 32) G(tiered_skirt_knee, C116, 64)                             \
    G(wrap_skirt_mini, W34, 32) G(sarong, W50, 64) G(godet_skirt_midi, W40, 32) G(trumpet_skirt_midi, W34, 64)         \
    G(straight_skirt_high, W50, 32) G(a_line_skirt_high, W40, 64) G(half_skirt_contour, W34, 32)                       \
    G(box_skirt_high, W50, 64) G(tiered_skirt_elastic_mini, W40, 32) G(full_skirt_elastic_knee, W34, 64)               \
    G(half_skirt_elastic_mini, W50, 32) G(tube_skirt, W40, 64) G(wide_capri, W34, 32) G(straight_bermudas, C116, 64)   \
    G(tapered_capri, M50, 64) G(bootcut_ankle, M58, 64) G(wide_bermudas, W40, 32) G(culotte_bermudas, M46, 64)         \
    G(straight_capri, W40, 64) G(straight_elastic_bermuda, W40, 32) G(wide_elastic_bermuda, C116, 64)           \
    G(little_black_dress, W34, 32) G(pencil_sweetheart_sleeveless, W34, 32) G(a_line_v_sleeveless, W34, 64)            \
    G(swing_square_sleeveless, W34, 64) G(gathered_jewel_sleeveless, W34, 32) G(gathered_scoop_sleeveless, W50, 64)    \
    G(gathered_v_sleeveless, W40, 32) G(gathered_square_sleeveless, W34, 64) G(gathered_boat_sleeveless, W50, 32)      \
    G(gathered_sweetheart_sleeveless, W40, 64) G(pleated_jewel_sleeveless, W34, 32) G(pleated_square_short, W40, 32)   \
    G(pleated_sweetheart_sleeveless, W34, 64) G(princess_a_line_v_sleeveless, W40, 64)                                 \
    G(panel_a_line_scoop_short, W40, 32) G(empire_gathered_v_short, W40, 32)                                           \
    G(empire_gathered_square_sleeveless, W34, 64) G(gown_halter_gored8, W34, 32)                                       \
    G(gown_sweetheart_gathered, W50, 64) G(gown_deep_v_gored8, W34, 64) G(a_line_dress_puff, W40, 64)                  \
    G(romper, W40, 32) G(straight_shorts, W40, 64) G(jumpsuit_strapless_culotte, W34, 32)                      \
    G(palazzo, M46, 64) G(romper_v_wide, W34, 32) G(romper_strapless_straight, W50, 64)

#endif
