/* seam_features.h: the features of a sewing, in the order of the weights, each with the words of the study's table. */
#ifndef MUS_SEAM_FEATURES_H
#define MUS_SEAM_FEATURES_H

#include "seam/seam_kinds.h"

/* features of a seam, each with a name for the study's table */
#define MUS__SEAM_PAIR(X)                                                                                            \
    X(SEWN, "a seam")                                                                                                \
    X(RATIO, "logarithm of the lengths' ratio, 1.5 at most")                                                         \
    X(EQUAL, "lengths within 0.2 %")                                                                                 \
    X(NEAR, "lengths within 1 %")                                                                                    \
    X(CLOSE, "lengths within 5 %")                                                                                   \
    X(EASED, "lengths within 20 %")                                                                                  \
    X(ONLY, "share of this mate among mates of equal length")                                                        \
    X(RANK, "rank of the length among all, 8 at most")                                                               \
    X(TURN_SUM, "turns that differ as of complementary curves [rad]")                                                \
    X(TURN_BOTH, "turns that differ from complementary and from equal [rad]")                                        \
    X(CONVEX, "a convex edge to a concave one")                                                                      \
    X(MIRROR, "normals are mirror images")                                                                           \
    X(OPPOSED, "normals are opposite")                                                                               \
    X(UPWARD, "sum of the normals' heights")                                                                         \
    X(CORNER, "corners that add up to a straight line, 0 to 2")                                                      \
    X(SAME, "one panel")                                                                                             \
    X(CENTRE_SEAM, "left to right, both edges towards the centre")                                                   \
    X(CROSSED, "left to right otherwise")                                                                            \
    X(LEGS_CROSSED, "left leg to right leg in the lower half: the inner leg, not the crotch")                        \
    X(ONE_HALF, "both on one half of the body")                                                                      \
    X(SIDES_AGREE, "front to back on one half: both towards the centre or both away")                                \
    X(SIDES_DIFFER, "front to back on one half: one towards the centre, one away")                                   \
    X(DART, "neighbours of one panel with a narrow wedge")                                                           \
    X(DART_DOWN, "the same, open downwards")                                                                         \
    X(FRONT_BACK, "front to back")                                                                                   \
    X(FRONT_FRONT, "front to front, back to back")                                                                   \
    X(CENTRE, "an edge to its own mirror image")                                                                     \
    X(TWIN, "panels of equal edges")                                                                                 \
    X(NOTCH_OK, "notches agree in number and kind")                                                                  \
    X(NOTCH_PLACE, "notches agree in place")                                                                         \
    X(NOTCH_BAD, "notches disagree")                                                                                 \
    X(WORDS, "share of common words of the panels' names")                                                           \
    X(NUMBERS, "names that differ by one in a number")                                                               \
    X(HEIGHT, "difference of the heights within the panels")                                                         \
    X(CURVE_EQUAL, "lengths within 1 % and equal turns, both curved")                                                \
    X(UNEQUAL_TURN, "turns that differ where lengths do")                                                            \
    X(JILTED, "edges that leave one of equal length, 0 to 2")                                                        \
    X(SHORT, "length of the shorter by the longest of the pattern")

/* features of a free edge */
#define MUS__SEAM_FREE_EDGE(X)                                                                                       \
    X(FREE_TURN, "turn of a free edge [rad]")                                                                        \
    X(FREE_LENGTH, "length of a free edge by the longest of the pattern")                                            \
    X(FREE_NOTCH, "a free edge with notches")                                                                        \
    X(FREE_DOWN_LOW, "a free edge that looks down at the bottom of its panel")                                       \
    X(FREE_UP_HIGH, "a free edge that looks up at the top")                                                          \
    X(FREE_CONCAVE_HIGH, "a concave free edge in the upper half")                                                    \
    X(FREE_ALONE, "a free edge whose length no other has within 1 %")                                                \
    X(FREE_CENTRE, "a free edge towards the centre, of a left or right panel")                                       \
    X(FREE_CENTRE_2, "the same, of a line of two edges")                                                             \
    X(FREE_CENTRE_3, "the same, of a line of more")

/* features of a whole sewing: vertices, openings, symmetry */
#define MUS__SEAM_WHOLE(X)                                                                                           \
    X(CLOSED_1, "tip of a dart")                                                                                     \
    X(CLOSED_2, "closed vertex of 2 corners")                                                                        \
    X(CLOSED_3, "closed vertex of 3 corners")                                                                        \
    X(CLOSED_4, "closed vertex of 4 corners")                                                                        \
    X(CLOSED_5, "closed vertex of 5 corners")                                                                        \
    X(CLOSED_MORE, "closed vertex of more corners")                                                                  \
    X(CLOSED_2_OFF, "angle of 2 corners from the full turn, 2 rad at most")                                          \
    X(CLOSED_3_OFF, "angle of 3 and more corners from the full turn")                                                \
    X(CLOSED_2_FLAT, "2 corners that make a full turn")                                                              \
    X(CLOSED_3_FLAT, "3 and more corners that make a full turn")                                                     \
    X(OPEN_1, "corner between two free edges")                                                                       \
    X(OPEN_2, "vertex of an opening of 2 corners")                                                                   \
    X(OPEN_3, "vertex of an opening of 3 corners")                                                                   \
    X(OPEN_4, "vertex of an opening of 4 corners")                                                                   \
    X(OPEN_MORE, "vertex of an opening of more corners")                                                             \
    X(OPEN_1_OFF, "angle of a corner between free edges from the half turn, 1.5 rad at most")                        \
    X(OPEN_2_OFF, "angle of 2 corners from the half turn, 1.5 rad at most")                                          \
    X(OPEN_3_OFF, "angle of 3 and more corners from the half turn")                                                  \
    X(OPEN_2_FLAT, "2 corners that make a half turn")                                                                \
    X(OPEN_3_FLAT, "3 and more corners that make a half turn")                                                       \
    X(LINE, "seams that go on in one another")                                                                       \
    X(LINE_SAME, "the same, ratios of the lengths within 1 %")                                                       \
    X(LINE_GATHER, "the same of unequal lengths")                                                                    \
    X(LINE_OFF, "difference of the ratios' logarithms, 0.5 at most")                                                 \
    X(LINE_STOP, "flat points of an outline at which a seam ends")                                                   \
    X(COMPONENTS, "garments beyond the first")                                                                       \
    X(HANDLES, "handles")                                                                                            \
    X(SEALED, "garments of less than two openings")                                                                  \
    X(OPENINGS_2, "garments of 2 openings")                                                                          \
    X(OPENINGS_3, "garments of 3 openings")                                                                          \
    X(OPENINGS_4, "garments of 4 openings")                                                                          \
    X(OPENINGS_MORE, "openings beyond the fifth")                                                                    \
    X(OPENINGS_FEWER, "openings less than the parts of a garment have: neck, waist, hem, two for arms, legs")        \
    X(OPENINGS_BEYOND, "openings more than that")                                                                    \
    X(OPENINGS_SMALL, "openings shorter than 0.15 m")                                                                \
    X(UNLIKE, "free edges of a panel more or less than those of another of its shape")                               \
    X(UNEVEN, "seams whose mirror image is none, of panels of which it is known")                                    \
    X(UNEVEN_FREE, "free edges whose mirror image is sewn, likewise")

#define MUS__SEAM_ENUM(name, text) MUS__SEAM_##name,
enum {
    MUS__SEAM_PAIR(MUS__SEAM_ENUM) MUS__SEAM_KIND,
    MUS__SEAM_ROLE = MUS__SEAM_KIND + MUS__SEAM_SEAM_KINDS,             /* two parts, eased or not */
    MUS__SEAM_ROLE_WAY = MUS__SEAM_ROLE + 2 * MUS__SEAM_TWO_ROLES,      /* the same, directions */
    MUS__SEAM_ROLE_TURN = MUS__SEAM_ROLE_WAY + 2 * MUS__SEAM_TWO_ROLES * MUS__SEAM_DIRECTIONS, /* two parts, turns */
    MUS__SEAM_PAIRS = MUS__SEAM_ROLE_TURN + MUS__SEAM_TWO_ROLES * MUS__SEAM_TURNS
};
enum {
    MUS__SEAM_FREE_EDGE(MUS__SEAM_ENUM) MUS__SEAM_FREE,
    MUS__SEAM_FREE_SIDE = MUS__SEAM_FREE + MUS__SEAM_FREE_KINDS,        /* part, side */
    MUS__SEAM_FREE_ROLE = MUS__SEAM_FREE_SIDE + MUS__SEAM_ROLES * MUS__SEAM_SIDES, /* part, kind */
    MUS__SEAM_FREE_INNER = MUS__SEAM_FREE_ROLE + MUS__SEAM_ROLES * MUS__SEAM_FREE_KINDS, /* part, towards the centre */
    MUS__SEAM_FREES = MUS__SEAM_FREE_INNER + MUS__SEAM_ROLES
};
enum { MUS__SEAM_WHOLE(MUS__SEAM_ENUM) MUS__SEAM_WHOLES };
#define MUS__SEAM_FEATURES (MUS__SEAM_PAIRS + MUS__SEAM_FREES + MUS__SEAM_WHOLES)

#endif
