/*
 * seam_weights.c: weights of the features of a sewing, and of the confidence. Written by `make seams
 * SEAMS='--fit lib/seam/seam_weights.c'`; do not edit.
 */
#include "seam/seam_find.h"

const double mus__seam_weights[MUS__SEAM_FEATURES] = {
    -0.82208, /* a seam */
    -0.476579, /* logarithm of the lengths' ratio, 1.5 at most */
    0.470484, /* lengths within 0.2 % */
    0.252177, /* lengths within 1 % */
    0.290236, /* lengths within 5 % */
    -0.149267, /* lengths within 20 % */
    0.56227, /* share of this mate among mates of equal length */
    -0.0759745, /* rank of the length among all, 8 at most */
    0.235274, /* turns that differ as of complementary curves [rad] */
    -0.289144, /* turns that differ from complementary and from equal [rad] */
    0.843966, /* a convex edge to a concave one */
    -0.155504, /* both straight */
    -0.92868, /* normals are mirror images */
    0.358901, /* normals are opposite */
    0.205518, /* the better agreement of the normals */
    0.0184823, /* sum of the normals' heights */
    -0.119201, /* corners that add up to a straight line, 0 to 2 */
    -0.710214, /* one panel */
    0.784313, /* neighbours of one panel with a narrow wedge */
    0.784313, /* the same of equal length */
    -0.860345, /* edges of one panel of equal length */
    -0.107977, /* left to right */
    0.308329, /* left to left, right to right */
    -0.64993, /* front to back */
    -0.172146, /* front to front, back to back */
    1.10021, /* front to back with mirrored normals */
    -1.16721, /* an edge to its own mirror image */
    0.424165, /* the same, upright */
    -0.0483565, /* panels of equal edges */
    -0.313089, /* panels of equal edges, lengths within 0.2 % */
    -3.70512, /* notches agree in number and kind */
    3.50949, /* notches agree in place */
    -1.41936, /* notches disagree */
    0.14246, /* panels of one label */
    -0.157048, /* share of common words of the panels' names */
    0.0329518, /* names that differ by one in a number */
    0.130897, /* difference of the heights within the panels */
    -0.231015, /* upright seam of front and back: equal lengths, mirrored normals */
    0.542928, /* two panels: lengths within 1 %, mirrored normals */
    0.0949962, /* two panels: lengths within 1 %, opposite normals */
    0.701854, /* one panel: equal lengths, mirrored normals */
    -0.190831, /* lengths within 1 % and equal turns, both curved */
    -0.466954, /* lengths within 5 %, a convex edge to a concave one */
    -0.0899592, /* turns that differ where lengths do */
    -0.189394, /* an edge that looks down to one that looks up */
    0.377978, /* the same of panels on one side, front or back */
    -0.293357, /* both look down */
    0.293108, /* both look up */
    0.0279147, /* lengths beyond 5 %, edges that look sideways */
    1.17779, /* length of the shorter by the longest of the pattern */
    0.231156, /* turn of a free edge [rad] */
    -0.484748, /* a free edge that is concave */
    -0.339847, /* a free edge that looks down */
    0.0564789, /* a free edge that looks up */
    0.667207, /* length of a free edge by the longest of the pattern */
    -0.158607, /* a free edge with notches */
    -0.365451, /* height of a free edge within its panel, 0 to 1 */
    0.143059, /* a free edge with an equal one other than its image */
    -0.221849, /* a free edge with an equal mirror image alone */
    0.256557, /* a free edge that looks down at the bottom of its panel */
    0.249935, /* a free edge that looks up at the top */
    0.491049, /* a concave free edge in the upper half */
    -0.113541, /* a free edge that looks sideways */
    0.0266904, /* the same where others have its length */
    -0.253849, /* a free edge whose length no other has within 1 % */
    -0.213677, /* tip of a dart */
    -0.515786, /* closed vertex of 2 corners */
    0.765273, /* closed vertex of 3 corners */
    0.610074, /* closed vertex of 4 corners */
    0.276273, /* closed vertex of 5 corners */
    0.929749, /* closed vertex of more corners */
    0.186525, /* angle of 2 corners from the full turn, 2 rad at most */
    -0.448685, /* angle of 3 and more corners from the full turn */
    1.23899, /* 2 corners that make a full turn */
    0.103685, /* 3 and more corners that make a full turn */
    -0.0350327, /* corner between two free edges */
    0.177394, /* vertex of an opening of 2 corners */
    0.583843, /* vertex of an opening of 3 corners */
    0.689941, /* vertex of an opening of 4 corners */
    1.02801, /* vertex of an opening of more corners */
    0.00074705, /* angle of 2 corners from the half turn, 1.5 rad at most */
    -0.137519, /* angle of 3 and more corners from the half turn */
    -0.0670197, /* 2 corners that make a half turn */
    -1.02805, /* 3 and more corners that make a half turn */
    0.0653273, /* vertex of an opening of more than 220 degrees */
    0.620344, /* garments beyond the first */
    -0.70656, /* handles */
    -0.420179, /* openings */
    0.0236432, /* openings shorter than 0.15 m */
    -0.039545, /* seams whose mirror image is none */
};

/* factor and constant of the margin */
const double mus__seam_confidence[2] = {3.33742, -0.756142};
