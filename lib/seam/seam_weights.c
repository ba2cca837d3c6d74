/*
 * seam_weights.c: weights of the features of a sewing, and of the confidence. Written by `make seams
 * SEAMS='--fit lib/seam/seam_weights.c'`; do not edit.
 */
#include "seam/seam_find.h"

const double mus__seam_weights[MUS__SEAM_FEATURES] = {
    -0.350474, /* a seam */
    -3.12226, /* logarithm of the lengths' ratio, 1.5 at most */
    0.903004, /* lengths within 0.2 % */
    1.25936, /* lengths within 1 % */
    -0.129704, /* lengths within 5 % */
    -0.647503, /* lengths within 20 % */
    -1.18177, /* share of this mate among mates of equal length */
    -0.56115, /* rank of the length among all, 8 at most */
    0.737987, /* turns that differ as of complementary curves [rad] */
    0.519109, /* turns that differ from complementary and from equal [rad] */
    2.80751, /* a convex edge to a concave one */
    0.608235, /* normals are mirror images */
    1.12237, /* normals are opposite */
    0.0558324, /* sum of the normals' heights */
    0.191202, /* corners that add up to a straight line, 0 to 2 */
    -0.55351, /* one panel */
    0.900344, /* left to right, both edges towards the centre */
    -1.30832, /* left to right otherwise */
    0.276126, /* both on one half of the body */
    -0.0959634, /* front to back on one half: both towards the centre or both away */
    -0.539053, /* front to back on one half: one towards the centre, one away */
    1.91006, /* neighbours of one panel with a narrow wedge */
    0.573421, /* the same, open downwards */
    0.0577396, /* front to back */
    1.17669, /* front to front, back to back */
    -1.11087, /* an edge to its own mirror image */
    -0.94092, /* panels of equal edges */
    0.661876, /* notches agree in number and kind */
    0.744448, /* notches agree in place */
    -1.74605, /* notches disagree */
    0.99509, /* panels of one label */
    -0.0619359, /* share of common words of the panels' names */
    -0.317354, /* names that differ by one in a number */
    0.972079, /* difference of the heights within the panels */
    -0.344247, /* lengths within 1 % and equal turns, both curved */
    -0.939105, /* turns that differ where lengths do */
    -0.227549, /* edges that leave one of equal length, 0 to 2 */
    -0.458547, /* length of the shorter by the longest of the pattern */
    0.389109, /* a kind of seam */
    -0.000563889, /* a kind of seam */
    -0.166048, /* a kind of seam */
    -0.209212, /* a kind of seam */
    -0.282873, /* a kind of seam */
    -0.00395623, /* a kind of seam */
    0.550048, /* a kind of seam */
    -0.0129364, /* a kind of seam */
    -0.0103959, /* a kind of seam */
    0.167413, /* a kind of seam */
    -0.00083109, /* a kind of seam */
    -0.220087, /* a kind of seam */
    -0.706834, /* a kind of seam */
    -0.00057081, /* a kind of seam */
    -0.0077687, /* a kind of seam */
    -0.0198581, /* a kind of seam */
    -0.00498965, /* a kind of seam */
    -0.0131545, /* a kind of seam */
    0.699706, /* a kind of seam */
    -0.0648728, /* a kind of seam */
    -0.252876, /* a kind of seam */
    -0.0173877, /* a kind of seam */
    -9.30893e-08, /* a kind of seam */
    -0.000144417, /* a kind of seam */
    -0.350347, /* a kind of seam */
    -0.000423462, /* a kind of seam */
    -0.00163446, /* a kind of seam */
    -0.871053, /* a kind of seam */
    -0.00066279, /* a kind of seam */
    -0.00810076, /* a kind of seam */
    -0.0013046, /* a kind of seam */
    -0.00314164, /* a kind of seam */
    -0.000725711, /* a kind of seam */
    -0.140143, /* a kind of seam */
    -0.00118973, /* a kind of seam */
    -0.00506457, /* a kind of seam */
    0.728458, /* a kind of seam */
    1.89937, /* a kind of seam */
    1.26514, /* a kind of seam */
    0.302546, /* a kind of seam */
    1.34962, /* a kind of seam */
    0.084309, /* a kind of seam */
    1.00569, /* a kind of seam */
    -0.179741, /* a kind of seam */
    -1.36447, /* a kind of seam */
    -1.65499, /* a kind of seam */
    -0.309615, /* a kind of seam */
    -0.553587, /* a kind of seam */
    -1.11055, /* a kind of seam */
    -0.154334, /* a kind of seam */
    0.105311, /* a kind of seam */
    -0.319156, /* a kind of seam */
    -0.829044, /* a kind of seam */
    -0.20722, /* a kind of seam */
    0.696299, /* a kind of seam */
    -1.70253, /* a kind of seam */
    -0.299829, /* a kind of seam */
    0.613584, /* a kind of seam */
    -1.68019, /* a kind of seam */
    -0.923671, /* a kind of seam */
    -1.9852, /* a kind of seam */
    -0.000470368, /* a kind of seam */
    -0.185163, /* a kind of seam */
    1.70945, /* a kind of seam */
    2.26621, /* a kind of seam */
    0.84331, /* a kind of seam */
    1.9403, /* a kind of seam */
    -0.79079, /* a kind of seam */
    0.426049, /* a kind of seam */
    -0.513568, /* a kind of seam */
    -0.528137, /* a kind of seam */
    1.27901, /* a kind of seam */
    0.0327754, /* turn of a free edge [rad] */
    -0.495083, /* length of a free edge by the longest of the pattern */
    0.708391, /* a free edge with notches */
    0.576128, /* a free edge that looks down at the bottom of its panel */
    -0.169514, /* a free edge that looks up at the top */
    1.04074, /* a concave free edge in the upper half */
    0.203055, /* a free edge whose length no other has within 1 % */
    0.505937, /* tip of a dart */
    4.3338, /* closed vertex of 2 corners */
    3.23847, /* closed vertex of 3 corners */
    0.3573, /* closed vertex of 4 corners */
    0.502057, /* closed vertex of 5 corners */
    -0.476471, /* closed vertex of more corners */
    -2.99237, /* angle of 2 corners from the full turn, 2 rad at most */
    -1.08873, /* angle of 3 and more corners from the full turn */
    -4.9253, /* 2 corners that make a full turn */
    -0.56666, /* 3 and more corners that make a full turn */
    -0.584908, /* corner between two free edges */
    1.32731, /* vertex of an opening of 2 corners */
    0.534064, /* vertex of an opening of 3 corners */
    0.327938, /* vertex of an opening of 4 corners */
    -0.903457, /* vertex of an opening of more corners */
    1.07442, /* angle of a corner between free edges from the half turn, 1.5 rad at most */
    -0.0569442, /* angle of 2 corners from the half turn, 1.5 rad at most */
    -0.175144, /* angle of 3 and more corners from the half turn */
    -0.373829, /* 2 corners that make a half turn */
    0.780513, /* 3 and more corners that make a half turn */
    1.33603, /* seams that go on in one another */
    -0.79925, /* the same, ratios of the lengths within 1 % */
    0.378111, /* the same of unequal lengths */
    -1.67327, /* difference of the ratios' logarithms, 0.5 at most */
    0.536699, /* flat points of an outline at which a seam ends */
    -1.81288, /* garments beyond the first */
    -1.28554, /* handles */
    -0.957509, /* garments of less than two openings */
    -0.293857, /* garments of 2 openings */
    0.394838, /* garments of 3 openings */
    1.09005, /* garments of 4 openings */
    -0.220255, /* openings beyond the fifth */
    -1.02284, /* openings shorter than 0.15 m */
    -0.315356, /* a free edge towards the centre, of a left or right panel */
    -0.162114, /* free edges of a panel more or less than those of another of its shape */
    -1.70151, /* seams whose mirror image is none, of panels of which it is known */
    -0.445118, /* free edges whose mirror image is sewn, likewise */
    0, /* a kind of free edge */
    0.298856, /* a kind of free edge */
    0, /* a kind of free edge */
    1.59623, /* a kind of free edge */
    -1.39211, /* a kind of free edge */
    0.617104, /* a kind of free edge */
    0.356181, /* a kind of free edge */
    -0.750758, /* a kind of free edge */
    -0.774634, /* a kind of free edge */
    0.240662, /* a kind of free edge */
    0.549979, /* a kind of free edge */
    -0.00157841, /* a kind of free edge */
    0, /* a kind of free edge */
    0, /* a kind of free edge */
    0.0604987, /* a kind of free edge */
    -0.284107, /* a kind of free edge */
    -0.673234, /* a kind of free edge */
    -0.0178229, /* a kind of free edge */
    -0.117974, /* a kind of free edge */
    -0.593602, /* a kind of free edge */
    0.0614566, /* a kind of free edge */
    -0.394696, /* a kind of free edge */
    -0.223481, /* a kind of free edge */
    0, /* a kind of free edge */
    0.483199, /* a kind of free edge */
    0.884163, /* a kind of free edge */
    0.23784, /* a kind of free edge */
    -0.0907623, /* a kind of free edge */
    0.00317613, /* a kind of free edge */
    -0.355854, /* a kind of free edge */
    -0.00567648, /* a kind of free edge */
    -0.641264, /* a kind of free edge */
    0, /* a kind of free edge */
    0.774921, /* a kind of free edge */
    0.821784, /* a kind of free edge */
    0.0324465, /* a kind of free edge */
};

/* factor and constant of the margin */
const double mus__seam_confidence[2] = {0.561769, -0.131403};
