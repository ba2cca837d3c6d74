/*
 * seam_weights.c: weights of the features of a sewing, and of the confidence. Written by `make seams
 * SEAMS='--fit lib/seam/seam_weights.c'`; do not edit.
 */
#include "seam/seam_find.h"

const double mus__seam_weights[MUS__SEAM_FEATURES] = {
    -0.748169, /* a seam */
    -1.82404, /* logarithm of the lengths' ratio, 1.5 at most */
    0.640942, /* lengths within 0.2 % */
    0.556572, /* lengths within 1 % */
    0.0300082, /* lengths within 5 % */
    -0.302664, /* lengths within 20 % */
    -0.807655, /* share of this mate among mates of equal length */
    -1.10885, /* rank of the length among all, 8 at most */
    0.567422, /* turns that differ as of complementary curves [rad] */
    0.974971, /* turns that differ from complementary and from equal [rad] */
    2.95935, /* a convex edge to a concave one */
    -0.37883, /* both straight */
    -0.23315, /* normals are mirror images */
    -0.0906823, /* normals are opposite */
    0.962788, /* the better agreement of the normals */
    0.354887, /* sum of the normals' heights */
    0.171292, /* corners that add up to a straight line, 0 to 2 */
    -1.3544, /* one panel */
    1.65214, /* neighbours of one panel with a narrow wedge */
    1.65214, /* the same of equal length */
    0.099153, /* edges of one panel of equal length */
    -1.71746, /* left to right */
    0.984684, /* left to left, right to right */
    -0.837799, /* front to back */
    0.325118, /* front to front, back to back */
    1.05585, /* front to back with mirrored normals */
    -1.24843, /* an edge to its own mirror image */
    0.685066, /* the same, upright */
    -0.182337, /* panels of equal edges */
    -0.287491, /* panels of equal edges, lengths within 0.2 % */
    0.303497, /* notches agree in number and kind */
    0.364742, /* notches agree in place */
    -1.54244, /* notches disagree */
    0.796816, /* panels of one label */
    -0.453749, /* share of common words of the panels' names */
    1.89202, /* names that differ by one in a number */
    1.44484, /* difference of the heights within the panels */
    -0.652174, /* upright seam of front and back: equal lengths, mirrored normals */
    0.324996, /* two panels: lengths within 1 %, mirrored normals */
    1.98162, /* two panels: lengths within 1 %, opposite normals */
    0.157051, /* one panel: equal lengths, mirrored normals */
    0.60254, /* lengths within 1 % and equal turns, both curved */
    -0.00632466, /* lengths within 5 %, a convex edge to a concave one */
    -1.01914, /* turns that differ where lengths do */
    -0.645044, /* an edge that looks down to one that looks up */
    1.91294, /* the same of panels on one side, front or back */
    -0.236538, /* both look down */
    0.044742, /* both look up */
    0.231525, /* lengths beyond 5 %, edges that look sideways */
    -0.280455, /* edges that leave one of equal length, 0 to 2 */
    1.17351, /* length of the shorter by the longest of the pattern */
    0.809412, /* a kind of seam */
    -0.000829119, /* a kind of seam */
    -0.824507, /* a kind of seam */
    -0.464517, /* a kind of seam */
    -0.60242, /* a kind of seam */
    -0.194547, /* a kind of seam */
    0.899492, /* a kind of seam */
    -0.118841, /* a kind of seam */
    -0.0166782, /* a kind of seam */
    0.599349, /* a kind of seam */
    -0.000629493, /* a kind of seam */
    -0.0995386, /* a kind of seam */
    -1.89586, /* a kind of seam */
    -0.00017749, /* a kind of seam */
    -0.0114901, /* a kind of seam */
    0.0177632, /* a kind of seam */
    -0.0102702, /* a kind of seam */
    0.559889, /* a kind of seam */
    1.76366, /* a kind of seam */
    -0.00117778, /* a kind of seam */
    1.86657, /* a kind of seam */
    2.08765, /* a kind of seam */
    -0.000403498, /* a kind of seam */
    -0.000441309, /* a kind of seam */
    1.2473, /* a kind of seam */
    -0.00073978, /* a kind of seam */
    -0.000125314, /* a kind of seam */
    -0.976977, /* a kind of seam */
    -1.20377e-05, /* a kind of seam */
    -0.000279182, /* a kind of seam */
    -1.00462e-05, /* a kind of seam */
    -0.000344822, /* a kind of seam */
    -0.000923191, /* a kind of seam */
    -0.00455502, /* a kind of seam */
    -0.000525415, /* a kind of seam */
    -0.00275385, /* a kind of seam */
    -0.23982, /* a kind of seam */
    0.835648, /* a kind of seam */
    0.0817497, /* a kind of seam */
    0.338577, /* a kind of seam */
    1.32, /* a kind of seam */
    -0.588056, /* a kind of seam */
    1.96101, /* a kind of seam */
    1.1519, /* a kind of seam */
    -1.46113, /* a kind of seam */
    -1.7435, /* a kind of seam */
    -0.131704, /* a kind of seam */
    -0.320147, /* a kind of seam */
    -0.143808, /* a kind of seam */
    -0.207946, /* a kind of seam */
    -0.0876504, /* a kind of seam */
    -0.59739, /* a kind of seam */
    -0.816626, /* a kind of seam */
    -0.188911, /* a kind of seam */
    -0.558931, /* a kind of seam */
    -1.74883, /* a kind of seam */
    -0.185338, /* a kind of seam */
    -1.09016, /* a kind of seam */
    -1.08654, /* a kind of seam */
    -0.134802, /* a kind of seam */
    -2.86782, /* a kind of seam */
    -0.00375423, /* a kind of seam */
    -0.635837, /* a kind of seam */
    0.326215, /* a kind of seam */
    2.22428, /* a kind of seam */
    -0.0433964, /* a kind of seam */
    1.79522, /* a kind of seam */
    -0.825492, /* a kind of seam */
    0.63593, /* a kind of seam */
    -0.621364, /* a kind of seam */
    -0.585506, /* a kind of seam */
    0.874239, /* a kind of seam */
    0.359375, /* turn of a free edge [rad] */
    0.220081, /* length of a free edge by the longest of the pattern */
    0.0883315, /* a free edge with notches */
    0.49124, /* a free edge that looks down at the bottom of its panel */
    -0.583456, /* a free edge that looks up at the top */
    0.951857, /* a concave free edge in the upper half */
    -0.364269, /* a free edge whose length no other has within 1 % */
    0.288081, /* tip of a dart */
    3.34511, /* closed vertex of 2 corners */
    2.39496, /* closed vertex of 3 corners */
    0.185961, /* closed vertex of 4 corners */
    0.544372, /* closed vertex of 5 corners */
    0.702257, /* closed vertex of more corners */
    -2.36216, /* angle of 2 corners from the full turn, 2 rad at most */
    -0.874228, /* angle of 3 and more corners from the full turn */
    -3.86955, /* 2 corners that make a full turn */
    -0.0285598, /* 3 and more corners that make a full turn */
    -0.469542, /* corner between two free edges */
    1.43416, /* vertex of an opening of 2 corners */
    0.411003, /* vertex of an opening of 3 corners */
    0.463057, /* vertex of an opening of 4 corners */
    -0.342342, /* vertex of an opening of more corners */
    0.873106, /* angle of a corner between free edges from the half turn, 1.5 rad at most */
    -0.248964, /* angle of 2 corners from the half turn, 1.5 rad at most */
    -0.162773, /* angle of 3 and more corners from the half turn */
    -0.500379, /* 2 corners that make a half turn */
    -0.480759, /* 3 and more corners that make a half turn */
    -0.137299, /* vertex of an opening of more than 220 degrees */
    1.42335, /* seams that go on in one another */
    -0.906922, /* the same, ratios of the lengths within 1 % */
    1.19337, /* the same of unequal lengths */
    -2.57307, /* difference of the ratios' logarithms, 0.5 at most */
    0.26559, /* flat points of an outline at which a seam ends */
    -2.21097, /* garments beyond the first */
    -1.15799, /* handles */
    -0.54931, /* garments of less than two openings */
    0.11751, /* garments of 2 openings */
    0.525109, /* garments of 3 openings */
    1.16159, /* garments of 4 openings */
    -0.608812, /* openings beyond the fifth */
    -1.77182, /* openings shorter than 0.15 m */
    -1.69776, /* seams whose mirror image is none, of panels of which it is known */
    -0.448646, /* free edges whose mirror image is sewn, likewise */
    0, /* a kind of free edge */
    -1.06302, /* a kind of free edge */
    0, /* a kind of free edge */
    1.49064, /* a kind of free edge */
    -1.65867, /* a kind of free edge */
    -0.512767, /* a kind of free edge */
    0.532294, /* a kind of free edge */
    -0.715067, /* a kind of free edge */
    -0.75449, /* a kind of free edge */
    -0.0587307, /* a kind of free edge */
    1.62172, /* a kind of free edge */
    1.21267, /* a kind of free edge */
    0, /* a kind of free edge */
    0, /* a kind of free edge */
    1.21503, /* a kind of free edge */
    0.151848, /* a kind of free edge */
    0.338272, /* a kind of free edge */
    0.621237, /* a kind of free edge */
    -0.273823, /* a kind of free edge */
    -0.552246, /* a kind of free edge */
    -0.106826, /* a kind of free edge */
    -0.00651433, /* a kind of free edge */
    -0.0631174, /* a kind of free edge */
    0, /* a kind of free edge */
    0.285561, /* a kind of free edge */
    0.472931, /* a kind of free edge */
    0.708891, /* a kind of free edge */
    -0.601923, /* a kind of free edge */
    -0.407933, /* a kind of free edge */
    -0.905287, /* a kind of free edge */
    -0.293665, /* a kind of free edge */
    -0.509952, /* a kind of free edge */
    0, /* a kind of free edge */
    0.375319, /* a kind of free edge */
    0.684617, /* a kind of free edge */
    0.269343, /* a kind of free edge */
};

/* factor and constant of the margin */
const double mus__seam_confidence[2] = {0.495074, -0.722236};
