/*
 * seam_weights.c: weights of the features of a sewing, and of the confidence. Written by `make seams
 * SEAMS='--fit lib/seam/seam_weights.c'`; do not edit.
 */
#include "seam/seam_find.h"

const double mus__seam_weights[MUS__SEAM_FEATURES] = {
    -0.647257, /* a seam */
    -2.26877, /* logarithm of the lengths' ratio, 1.5 at most */
    0.318803, /* lengths within 0.2 % */
    1.45801, /* lengths within 1 % */
    -0.151927, /* lengths within 5 % */
    0.321172, /* lengths within 20 % */
    -1.26925, /* share of this mate among mates of equal length */
    -0.943642, /* rank of the length among all, 8 at most */
    -0.135882, /* turns that differ as of complementary curves [rad] */
    0.605533, /* turns that differ from complementary and from equal [rad] */
    2.32951, /* a convex edge to a concave one */
    0.490402, /* normals are mirror images */
    1.03365, /* normals are opposite */
    0.189595, /* sum of the normals' heights */
    0.110302, /* corners that add up to a straight line, 0 to 2 */
    -1.39989, /* one panel */
    0.649019, /* left to right, both edges towards the centre */
    -1.46663, /* left to right otherwise */
    -1.64207, /* left leg to right leg in the lower half: the inner leg, not the crotch */
    -0.450132, /* both on one half of the body */
    -0.254237, /* front to back on one half: both towards the centre or both away */
    -0.952513, /* front to back on one half: one towards the centre, one away */
    2.63736, /* neighbours of one panel with a narrow wedge */
    0.405424, /* the same, open downwards */
    0.515132, /* front to back */
    1.12404, /* front to front, back to back */
    -1.52866, /* an edge to its own mirror image */
    -0.169498, /* panels of equal edges */
    0.865176, /* notches agree in number and kind */
    0.950468, /* notches agree in place */
    -0.836917, /* notches disagree */
    -0.384447, /* share of common words of the panels' names */
    0.234254, /* names that differ by one in a number */
    0.323337, /* difference of the heights within the panels */
    0.260115, /* lengths within 1 % and equal turns, both curved */
    -0.383833, /* turns that differ where lengths do */
    -0.51965, /* edges that leave one of equal length, 0 to 2 */
    0.299948, /* length of the shorter by the longest of the pattern */
    0.440967, /* a kind of seam */
    -0.0037425, /* a kind of seam */
    -0.00125938, /* a kind of seam */
    -0.336538, /* a kind of seam */
    -0.401092, /* a kind of seam */
    -0.0189988, /* a kind of seam */
    -0.386997, /* a kind of seam */
    -0.0427085, /* a kind of seam */
    -0.071704, /* a kind of seam */
    0.264744, /* a kind of seam */
    0.339833, /* a kind of seam */
    -0.196927, /* a kind of seam */
    -1.10787, /* a kind of seam */
    -0.00868211, /* a kind of seam */
    -0.0230935, /* a kind of seam */
    0.0181818, /* a kind of seam */
    -0.0343341, /* a kind of seam */
    0.170326, /* a kind of seam */
    0.595821, /* a kind of seam */
    -0.2439, /* a kind of seam */
    -0.293028, /* a kind of seam */
    -0.472968, /* a kind of seam */
    -0.00488648, /* a kind of seam */
    -0.0835886, /* a kind of seam */
    -0.494486, /* a kind of seam */
    -0.000272052, /* a kind of seam */
    -0.0162384, /* a kind of seam */
    -0.535184, /* a kind of seam */
    -0.0119515, /* a kind of seam */
    -0.132481, /* a kind of seam */
    -0.00177108, /* a kind of seam */
    -0.151099, /* a kind of seam */
    0.062552, /* a kind of seam */
    -0.06195, /* a kind of seam */
    -0.0274874, /* a kind of seam */
    -0.0870677, /* a kind of seam */
    0.370923, /* a kind of seam */
    1.06216, /* a kind of seam */
    1.13422, /* a kind of seam */
    0.721329, /* a kind of seam */
    1.51897, /* a kind of seam */
    0.0536667, /* a kind of seam */
    0.68188, /* a kind of seam */
    -0.166, /* a kind of seam */
    0.145164, /* a kind of seam */
    -0.956106, /* a kind of seam */
    -0.31293, /* a kind of seam */
    -1.09567, /* a kind of seam */
    0.11018, /* a kind of seam */
    -0.23093, /* a kind of seam */
    -0.359573, /* a kind of seam */
    -0.67264, /* a kind of seam */
    -0.753417, /* a kind of seam */
    -0.736107, /* a kind of seam */
    1.14257, /* a kind of seam */
    -1.10809, /* a kind of seam */
    -0.905221, /* a kind of seam */
    -0.406046, /* a kind of seam */
    -0.440106, /* a kind of seam */
    -0.426209, /* a kind of seam */
    -0.925664, /* a kind of seam */
    -0.00304532, /* a kind of seam */
    -0.417597, /* a kind of seam */
    1.63234, /* a kind of seam */
    1.48189, /* a kind of seam */
    0.947124, /* a kind of seam */
    0.906351, /* a kind of seam */
    -1.23639, /* a kind of seam */
    1.02332, /* a kind of seam */
    -0.208267, /* a kind of seam */
    0.307472, /* a kind of seam */
    0.833052, /* a kind of seam */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0.341384, /* parts of a garment */
    0.184497, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0.430532, /* parts of a garment */
    0.657378, /* parts of a garment */
    -0.0188057, /* parts of a garment */
    0.788286, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -1.01118, /* parts of a garment */
    -0.358973, /* parts of a garment */
    0.534282, /* parts of a garment */
    -0.476426, /* parts of a garment */
    -0.000196658, /* parts of a garment */
    -0.436629, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.915297, /* parts of a garment */
    0.0349408, /* parts of a garment */
    -0.0185459, /* parts of a garment */
    -8.29956e-05, /* parts of a garment */
    -0.000139326, /* parts of a garment */
    -0.0190423, /* parts of a garment */
    -0.0276907, /* parts of a garment */
    0.0456403, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.564295, /* parts of a garment */
    -0.285715, /* parts of a garment */
    -5.67426e-06, /* parts of a garment */
    -3.18438e-06, /* parts of a garment */
    -0.00467303, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.00391355, /* parts of a garment */
    1.17065, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0.66371, /* parts of a garment */
    0.123433, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.00257177, /* parts of a garment */
    -3.15717e-06, /* parts of a garment */
    -1.55324e-08, /* parts of a garment */
    -6.37176e-06, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.0651228, /* parts of a garment */
    0.534902, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0.495635, /* parts of a garment */
    -0.216738, /* parts of a garment */
    -0.139743, /* parts of a garment */
    -0.000211921, /* parts of a garment */
    -0.0339859, /* parts of a garment */
    -0.0754777, /* parts of a garment */
    -0.000841055, /* parts of a garment */
    -0.00451926, /* parts of a garment */
    0.0797343, /* parts of a garment */
    -0.0194649, /* parts of a garment */
    0.866438, /* parts of a garment */
    -0.687131, /* parts of a garment */
    -0.473334, /* parts of a garment */
    -0.844722, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.00560895, /* parts of a garment */
    -0.203891, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.00432142, /* parts of a garment */
    -0.487424, /* parts of a garment */
    -0.0013581, /* parts of a garment */
    -0.00103112, /* parts of a garment */
    -0.107365, /* parts of a garment */
    1.31744, /* parts of a garment */
    -8.37327e-05, /* parts of a garment */
    -1.03412, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0.0907107, /* parts of a garment */
    -1.30454, /* parts of a garment */
    -1.48659e-07, /* parts of a garment */
    -8.29257e-05, /* parts of a garment */
    0.0906348, /* parts of a garment */
    1.4095, /* parts of a garment */
    -0.00242919, /* parts of a garment */
    -0.000266388, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.706413, /* parts of a garment */
    -0.323332, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    0, /* parts of a garment */
    -0.453567, /* parts of a garment */
    0.834345, /* parts of a garment */
    -0.0885822, /* turn of a free edge [rad] */
    0.219824, /* length of a free edge by the longest of the pattern */
    -0.0896097, /* a free edge with notches */
    0.394247, /* a free edge that looks down at the bottom of its panel */
    0.55637, /* a free edge that looks up at the top */
    0.250131, /* a concave free edge in the upper half */
    -0.258883, /* a free edge whose length no other has within 1 % */
    0.264348, /* tip of a dart */
    1.57345, /* closed vertex of 2 corners */
    2.37657, /* closed vertex of 3 corners */
    0.635088, /* closed vertex of 4 corners */
    -0.168345, /* closed vertex of 5 corners */
    -0.764372, /* closed vertex of more corners */
    -1.64172, /* angle of 2 corners from the full turn, 2 rad at most */
    -1.05246, /* angle of 3 and more corners from the full turn */
    -2.25026, /* 2 corners that make a full turn */
    0.339972, /* 3 and more corners that make a full turn */
    -0.320034, /* corner between two free edges */
    0.554451, /* vertex of an opening of 2 corners */
    0.283668, /* vertex of an opening of 3 corners */
    0.270287, /* vertex of an opening of 4 corners */
    0.506143, /* vertex of an opening of more corners */
    -0.126428, /* angle of a corner between free edges from the half turn, 1.5 rad at most */
    -0.212655, /* angle of 2 corners from the half turn, 1.5 rad at most */
    -0.541201, /* angle of 3 and more corners from the half turn */
    -0.455417, /* 2 corners that make a half turn */
    0.252243, /* 3 and more corners that make a half turn */
    1.07932, /* seams that go on in one another */
    -1.05798, /* the same, ratios of the lengths within 1 % */
    1.26991, /* the same of unequal lengths */
    -1.47258, /* difference of the ratios' logarithms, 0.5 at most */
    0.392424, /* flat points of an outline at which a seam ends */
    -1.88036, /* garments beyond the first */
    -3.64537, /* handles */
    -0.255918, /* garments of less than two openings */
    -0.684803, /* garments of 2 openings */
    -0.697434, /* garments of 3 openings */
    0.160619, /* garments of 4 openings */
    0.366928, /* openings beyond the fifth */
    0.637435, /* openings less than the parts of a garment have: neck, waist, hem, two for arms, legs */
    -3.10838, /* openings more than that */
    -0.522488, /* openings shorter than 0.15 m */
    -0.115888, /* a free edge towards the centre, of a left or right panel */
    -0.166943, /* free edges of a panel more or less than those of another of its shape */
    -1.17757, /* seams whose mirror image is none, of panels of which it is known */
    -0.571595, /* free edges whose mirror image is sewn, likewise */
    0, /* a kind of free edge */
    -0.255623, /* a kind of free edge */
    0, /* a kind of free edge */
    0.367242, /* a kind of free edge */
    -1.13106, /* a kind of free edge */
    0.0217464, /* a kind of free edge */
    0.600873, /* a kind of free edge */
    0.0488808, /* a kind of free edge */
    -0.209654, /* a kind of free edge */
    -0.095469, /* a kind of free edge */
    0.946252, /* a kind of free edge */
    0.299725, /* a kind of free edge */
    0, /* a kind of free edge */
    0, /* a kind of free edge */
    0.0292959, /* a kind of free edge */
    -0.138457, /* a kind of free edge */
    -0.465675, /* a kind of free edge */
    0.304781, /* a kind of free edge */
    0.0327765, /* a kind of free edge */
    0.643796, /* a kind of free edge */
    -0.328861, /* a kind of free edge */
    -0.0198335, /* a kind of free edge */
    -1.20063, /* a kind of free edge */
    0, /* a kind of free edge */
    0.444566, /* a kind of free edge */
    0.585184, /* a kind of free edge */
    0.831329, /* a kind of free edge */
    -0.115203, /* a kind of free edge */
    0.266742, /* a kind of free edge */
    -0.437207, /* a kind of free edge */
    -0.417856, /* a kind of free edge */
    -0.19874, /* a kind of free edge */
    0, /* a kind of free edge */
    0.372128, /* a kind of free edge */
    0.361469, /* a kind of free edge */
    0.151997, /* a kind of free edge */
    0, /* a free edge of a part */
    0, /* a free edge of a part */
    0, /* a free edge of a part */
    0, /* a free edge of a part */
    -0.0714056, /* a free edge of a part */
    0.133872, /* a free edge of a part */
    0.456482, /* a free edge of a part */
    0.799194, /* a free edge of a part */
    -1.8313, /* a free edge of a part */
    0.0131696, /* a free edge of a part */
    -0.342032, /* a free edge of a part */
    -0.365891, /* a free edge of a part */
    -0.346948, /* a free edge of a part */
    0.803482, /* a free edge of a part */
    0.402584, /* a free edge of a part */
    -0.037406, /* a free edge of a part */
    0.545821, /* a free edge of a part */
    -0.349535, /* a free edge of a part */
    0.694044, /* a free edge of a part */
    0, /* a free edge of a part */
    -0.0184589, /* a free edge of a part */
    -1.21981, /* a free edge of a part */
    0.726198, /* a free edge of a part */
    -0.535249, /* a free edge of a part */
    -0.326754, /* a free edge of a part */
    1.37595, /* a free edge of a part */
    -1.12768, /* a free edge of a part */
    -0.792808, /* a free edge of a part */
    0.548867, /* a free edge of a part */
    -0.205237, /* a free edge of a part */
    -0.116231, /* a free edge of a part */
    0.934948, /* a free edge of a part */
    0.614199, /* a free edge of a part */
    0, /* a free edge of a part */
    0.667222, /* a free edge of a part */
    0.280554, /* a free edge of a part */
    0.328389, /* a free edge of a part */
    0.328559, /* a free edge of a part */
    -0.372267, /* a free edge of a part */
    -0.300011, /* a free edge of a part */
};

/* factor and constant of the margin */
const double mus__seam_confidence[2] = {0.507068, 0.685254};
