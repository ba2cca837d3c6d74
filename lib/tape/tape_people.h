/*
 * tape_people.h: how the measures of people go together. Written by tests/study/slips from every second
 * person of 3034 of ANSUR II (Gordon and others 2014; US Army, public domain); tests/study/people/ansur.h has
 * the survey's columns and their offsets. The other half of the people tests the table (`make slips`).
 */
#ifndef MUS_TAPE_TAPE_PEOPLE_H
#define MUS_TAPE_TAPE_PEOPLE_H

#include "muslin/tape.h"

#define MUS__PEOPLE_MEASURES 13

/* the measures of the table */
static const int32_t mus__people_measure[MUS__PEOPLE_MEASURES] = {
    MUS_MEASURE_STATURE,
    MUS_MEASURE_NAPE_HEIGHT,
    MUS_MEASURE_INLEG,
    MUS_MEASURE_BUST,
    MUS_MEASURE_WAIST,
    MUS_MEASURE_HIP,
    MUS_MEASURE_NECK,
    MUS_MEASURE_HEAD,
    MUS_MEASURE_UPPER_ARM,
    MUS_MEASURE_WRIST,
    MUS_MEASURE_THIGH,
    MUS_MEASURE_CALF,
    MUS_MEASURE_ANKLE,
};

/* women, men: geometric mean [cm]; standard deviation of the natural logarithm [%]; correlations of the
 * logarithms [1/1000], row i with columns 0 to i - 1 */
static const struct mus__people {
    double mean[MUS__PEOPLE_MEASURES], deviation[MUS__PEOPLE_MEASURES];
    int16_t correlation[MUS__PEOPLE_MEASURES * (MUS__PEOPLE_MEASURES - 1) / 2];
} mus__people[2] = {
    {{162.80, 139.58, 78.09, 94.20, 77.95, 101.72, 36.95, 55.95, 28.31, 15.43, 61.16, 37.12, 21.48},
     {3.99, 4.31, 6.84, 8.48, 12.21, 7.32, 5.14, 3.44, 10.43, 5.03, 8.82, 7.60, 6.97},
     {985,
      689, 711,
      283, 270, 111,
      248, 249, 100, 848,
      401, 394, 203, 730, 793,
      420, 409, 224, 665, 611, 622,
      299, 292, 265, 213, 192, 236, 353,
      295, 286, 167, 746, 739, 790, 660, 291,
      580, 568, 341, 572, 495, 577, 630, 303, 634,
      342, 340, 190, 685, 745, 940, 589, 280, 808, 566,
      377, 359, 198, 555, 556, 739, 543, 275, 700, 631, 769,
      400, 376, 166, 431, 392, 563, 434, 240, 500, 647, 559, 780}},
    {{175.43, 151.54, 84.52, 105.06, 91.87, 101.29, 43.27, 57.44, 33.55, 17.55, 62.06, 39.05, 22.87},
     {4.00, 4.30, 6.66, 8.36, 12.13, 7.59, 5.88, 2.93, 10.25, 5.12, 9.43, 7.81, 6.51},
     {984,
      733, 744,
      247, 297, 83,
      217, 266, 39, 892,
      360, 397, 154, 838, 872,
      296, 329, 118, 770, 722, 698,
      333, 316, 179, 431, 380, 456, 462,
      192, 231, 87, 793, 695, 745, 695, 397,
      490, 499, 264, 618, 576, 628, 625, 426, 614,
      267, 306, 115, 816, 830, 942, 669, 449, 801, 584,
      266, 286, 91, 734, 706, 789, 612, 459, 710, 642, 810,
      383, 389, 183, 588, 564, 673, 523, 463, 566, 692, 671, 826}},
};

#endif
