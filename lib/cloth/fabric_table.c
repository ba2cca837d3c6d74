/*
 * fabric_table.c: named fabrics, each value with where it comes from.
 *
 * Only figures that may be given on are here. Units of the sources: stretch from KES-FB1 is C11 = 490.33 N/m / EMT (the
 * secant at 500 gf/cm; a 5 cm long and 20 cm wide piece cannot narrow); shear 1 gf/(cm deg) = 56.188 N/m; bending
 * 1 gf cm^2/cm = 9.80665e-5 N m. "assumed" marks what nobody measured for us: it stands for the class of fabric.
 *
 * No open source gives bending along warp, weft and bias apart, so the three are alike. Where only the drape
 * coefficient (30 cm on 18 cm) is known, bending is chosen to give it: it then stands for stiffness and inner friction
 * together. tests/study/fabric measures it on discs of 10 and 5 mm spacing.
 */
#include <string.h>

#include "cloth/cloth_internal.h"
#include "cloth/fabric.h"

/* what a text of a source speaks of: weight, stretch, shear, bending, damping, friction, thickness, bend hysteresis,
 * contraction */
#define FABRIC_TEXTS 9

typedef struct fabric_row {
    const char *name, *source, *text[FABRIC_TEXTS];
    double weight, stretch[2], shear, bend, friction, thickness, hysteresis, contraction;
} fabric_row;

/* text of each value of fabric_value.c */
static const int32_t fabric_text[] = {0, 1, 1, 2, 3, 3, 3, 4, 5, 6, 7, 8};

#define FABRIC_DAMPING 0.1 /* damping ratio of every fabric of the table; assumed, as muslin_fabric(5) says */

/* one row: name, what it is; then each value with its source; FABRIC has neither friction of bending nor a measured
 * contraction */
#define FABRIC_ALL(name, what, weight, from_weight, warp, weft, from_stretch, shear, from_shear, bend, from_bend, \
                   friction, from_friction, thickness, from_thickness, hysteresis, from_hysteresis, contraction, \
                   from_contraction) \
    { \
        name, \
        what ". Weight: " from_weight "; stretch: " from_stretch "; shear: " from_shear "; bending: " from_bend \
             ", alike in warp, weft and bias; damping: assumed; friction: " from_friction \
             "; thickness: " from_thickness "; bend hysteresis: " from_hysteresis \
             "; contraction: " from_contraction ".", \
        {from_weight, from_stretch, from_shear, from_bend ", alike in warp, weft and bias", "assumed", from_friction, \
         from_thickness, from_hysteresis, from_contraction}, \
        weight, {warp, weft}, shear, bend, friction, thickness, hysteresis, contraction \
    }
#define AS_SPRINGS "not measured, as its springs give"
#define FABRIC(...) FABRIC_ALL(__VA_ARGS__, 0.0, "left out", 0.0, AS_SPRINGS)
#define FABRIC_LOOP(...) FABRIC_ALL(__VA_ARGS__, 0.0, AS_SPRINGS)

#define COTTON_ON_SKIN "mean of cotton on chest 0.90 and forearm 0.31, static (Temel 2022, Tribology Letters 70)"
#define PENAVA "Penava 2014"
#define MATSUDAIRA "Matsudaira et al. 2015, J. Textile Eng. 61(6)"
#define DENIM_PAPER "J. Textiles 2016, 4614168, table 5"
#define DENIM_WEIGHT "assumed 12 oz/yd2 (the column of the paper cannot be right)"
#define DENIM_EMT(emt) "from EMT " emt " %, " DENIM_PAPER ", both ways the same"
#define SUITING "middle of the good band for men's suiting, Fan, Yu and Hunter, table 1.12"
#define CONTROL_COTTON "from EMT 2.29 % of a control cotton, Polymers 17(15):2013, both ways the same"
#define DRAPE_PAPER "Fibres and Textiles 1/2018, 30/18 cm"
#define DRAPE_FIT(percent) "assumed, so that it drapes to the measured " percent " % (" DRAPE_PAPER ")"

/* clang-format off */
static const fabric_row fabric_table[] = {
    FABRIC_LOOP("jersey", "Single jersey, a light T-shirt knit",
           0.16, "assumed", 300.0, 200.0, "assumed, at small strain", 40.0, "assumed, 0.7 gf/(cm deg)",
           5e-6, "assumed", 0.6, COTTON_ON_SKIN, 0.6e-3, "assumed",
           0.294e-3, "assumed, 0.03 gf cm/cm"),
    FABRIC_ALL("cotton", "Plain woven cotton",
           0.1503, PENAVA, 21412.0, 21412.0, CONTROL_COTTON, 60.0, "assumed",
           11.57e-6, MATSUDAIRA ", broadcloth", 0.6, COTTON_ON_SKIN, 0.318e-3, PENAVA,
           0.0, "left out", 0.243, PENAVA),
    FABRIC("denim", "Denim A of its paper",
           0.40, DENIM_WEIGHT, 8915.0, 8915.0, DENIM_EMT("5.5"), 122.0, DENIM_PAPER,
           16.9e-6, DENIM_PAPER, 0.45, "assumed", 1.07e-3, DENIM_PAPER),
    FABRIC_ALL("wool", "Wool suiting",
           0.2348, PENAVA, 10433.0, 3846.0, SUITING ": EM 4.3-5.1 % warp, 7.5-18 % weft", 32.5, SUITING,
           6.57e-6, MATSUDAIRA ", wool tropical", 0.4, "assumed", 0.568e-3, PENAVA,
           0.0, "left out", 0.277, PENAVA),
    FABRIC("silk", "Light plain silk",
           0.065, "assumed", 5000.0, 5000.0, "assumed", 15.0, "assumed",
           2e-6, "assumed, a bending length of 1.5 cm, as published drape coefficients of 20-40 % ask",
           0.25, "assumed", 0.15e-3, "assumed"),
    FABRIC_ALL("polyester", "Woven polyester",
           0.1646, PENAVA, 8000.0, 8000.0, "assumed", 30.0, "assumed",
           1.86e-6, MATSUDAIRA ", faille", 0.3, "assumed", 0.252e-3, PENAVA,
           0.0686e-3, MATSUDAIRA ", faille", 0.381, PENAVA),
    FABRIC("denim_b", "Denim B of its paper",
           0.40, DENIM_WEIGHT, 8550.0, 8550.0, DENIM_EMT("5.735"), 86.4, DENIM_PAPER,
           14.1e-6, DENIM_PAPER, 0.45, "assumed", 1.188e-3, DENIM_PAPER),
    FABRIC("denim_c", "Denim C of its paper, the stiffest",
           0.40, DENIM_WEIGHT, 10444.0, 10444.0, DENIM_EMT("4.695"), 190.9, DENIM_PAPER,
           22.3e-6, DENIM_PAPER, 0.45, "assumed", 0.801e-3, DENIM_PAPER),
    FABRIC("denim_d", "Denim D of its paper",
           0.40, DENIM_WEIGHT, 9549.0, 9549.0, DENIM_EMT("5.135"), 90.6, DENIM_PAPER,
           14.4e-6, DENIM_PAPER, 0.45, "assumed", 1.040e-3, DENIM_PAPER),
    FABRIC("denim_e", "Denim E of its paper",
           0.40, DENIM_WEIGHT, 10410.0, 10410.0, DENIM_EMT("4.710"), 86.4, DENIM_PAPER,
           20.3e-6, DENIM_PAPER, 0.45, "assumed", 0.887e-3, DENIM_PAPER),
    FABRIC("denim_f", "Denim F of its paper",
           0.40, DENIM_WEIGHT, 8989.0, 8989.0, DENIM_EMT("5.455"), 84.3, DENIM_PAPER,
           14.5e-6, DENIM_PAPER, 0.45, "assumed", 0.973e-3, DENIM_PAPER),
    FABRIC_LOOP("broadcloth", "Cotton broadcloth, a stiff shirting (drape coefficient 82.9 % measured)",
           0.120, "assumed", 21412.0, 21412.0, CONTROL_COTTON, 60.0, "assumed",
           11.57e-6, MATSUDAIRA, 0.6, COTTON_ON_SKIN, 0.497e-3, MATSUDAIRA,
           1.216e-3, MATSUDAIRA),
    FABRIC_LOOP("tropical", "Wool tropical, a summer suiting",
           0.17, "assumed", 10433.0, 3846.0, SUITING ": EM 4.3-5.1 % warp, 7.5-18 % weft", 32.5, SUITING,
           6.57e-6, MATSUDAIRA, 0.4, "assumed", 0.35e-3, "assumed",
           0.3236e-3, MATSUDAIRA),
    FABRIC("shirting", "Cotton shirting, a control cotton",
           0.158, "Polymers 17(15):2013", 21412.0, 21412.0, CONTROL_COTTON, 60.0, "assumed",
           11.57e-6, "assumed as of broadcloth, " MATSUDAIRA, 0.6, COTTON_ON_SKIN, 0.318e-3, "assumed as of cotton"),
    FABRIC("stretch_twill", "Twill of cotton, polyester and elastane, the elastane in the weft",
           0.2266, "Materials 11(12):2466", 28343.0, 4386.0,
           "from EMT 1.73 % warp, 11.18 % weft, Materials 11(12):2466", 60.0, "assumed",
           14e-6, "assumed", 0.45, "assumed", 0.50e-3, "assumed"),
    FABRIC_ALL("wool_lycra", "Wool with Lycra in the weft",
           0.1782, PENAVA, 10433.0, 2724.0, SUITING ": EM 4.7 % warp; weft assumed at its upper end, 18 %", 32.5,
           SUITING, 6.57e-6, "assumed as of wool tropical, " MATSUDAIRA, 0.4, "assumed", 0.328e-3, PENAVA,
           0.0, "left out", 0.071, PENAVA),
    FABRIC("pc_plain", "Polyester and cotton, plain weave, 46 x 20 threads a cm",
           0.2215, DRAPE_PAPER, 15000.0, 15000.0, "assumed", 60.0, "assumed",
           52e-6, DRAPE_FIT("80.4"), 0.45, "assumed", 0.48e-3, DRAPE_PAPER),
    FABRIC("pc_twill", "Polyester and cotton, twill 3/1",
           0.2489, DRAPE_PAPER, 15000.0, 15000.0, "assumed", 60.0, "assumed",
           57e-6, DRAPE_FIT("79.8"), 0.45, "assumed", 0.50e-3, DRAPE_PAPER),
    FABRIC("pc_panama", "Polyester and cotton, panama weave",
           0.2418, DRAPE_PAPER, 15000.0, 15000.0, "assumed", 45.0, "assumed",
           51e-6, DRAPE_FIT("76.6"), 0.45, "assumed", 0.60e-3, DRAPE_PAPER),
    FABRIC("satin", "Five-end satin, the lightest of its paper",
           0.186, DRAPE_PAPER, 8000.0, 8000.0, "assumed", 30.0, "assumed",
           6.6e-6, DRAPE_FIT("43.0"), 0.25, "assumed", 0.30e-3, "assumed"),
};
/* clang-format on */

enum { FABRIC_COUNT = sizeof fabric_table / sizeof *fabric_table };


static void fabric_fill(const fabric_row *row, mus_fabric *out)
{
    out->weight = row->weight;
    memcpy(out->stretch, row->stretch, sizeof out->stretch);
    out->shear = row->shear;
    for (int k = 0; k < 3; k++) out->bend[k] = row->bend;
    out->damping = FABRIC_DAMPING;
    out->friction = row->friction;
    out->thickness = row->thickness;
    out->bend_hysteresis = row->hysteresis;
    out->contraction = row->contraction;
}


void mus_fabric_init(mus_fabric *fabric, size_t size)
{
    mus_fabric own = {0};
    fabric_fill(&fabric_table[0], &own);
    own.bend_hysteresis = 0.0; /* a sheet that is stepped in real time does without, and steps faster */
    mus__def_init(fabric, size, &own, sizeof own);
}


int32_t mus_fabric_count(void)
{
    return FABRIC_COUNT;
}


const char *mus_fabric_name(int32_t index)
{
    return index >= 0 && index < FABRIC_COUNT ? fabric_table[index].name : NULL;
}


const char *mus_fabric_source(int32_t index)
{
    return index >= 0 && index < FABRIC_COUNT ? fabric_table[index].source : NULL;
}


const char *mus_fabric_value_source(int32_t index, int32_t value)
{
    if (index < 0 || index >= FABRIC_COUNT || value < 0 || value >= mus_fabric_value_count()) return NULL;
    return fabric_table[index].text[fabric_text[value]];
}


mus_status mus_fabric_find(const char *name, mus_fabric *out)
{
    if (name == NULL || out == NULL) return MUS_ERR_ARG;
    if (out->size != sizeof *out && out->size != MUS__FABRIC_FIRST) return MUS_ERR_VERSION;
    for (int32_t i = 0; i < FABRIC_COUNT; i++)
        if (strcmp(name, fabric_table[i].name) == 0) {
            mus_fabric own = {.size = out->size};
            fabric_fill(&fabric_table[i], &own);
            memcpy(out, &own, out->size);
            return MUS_OK;
        }
    return MUS_ERR_ARG;
}
