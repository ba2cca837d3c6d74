/*
 * block_bodice.h: the bodice block, front and back half.
 *
 * Frame of a block: x from the centre line outwards to the side seam, y up, y = 0 on the waist line; lengths in metre,
 * angles in radian. A drawn front half is the wearer's left, a drawn back half the wearer's right.
 */
#ifndef MUS_BLOCK_BODICE_H
#define MUS_BLOCK_BODICE_H

#include "block/block_curve.h"
#include "block/measures.h"

typedef struct mus__bodice_def {
    double bust_ease;  /* ease on the bust girth [m] */
    double waist_ease; /* ease on the waist girth [m] */
    double scye_ease;  /* depth of the armhole less the scye depth [m] */
    double balance;    /* width of the front half less that of the back half, on the bust line [m] */
    double neck_ease;  /* ease on the neck girth [m] */
    bool darts;        /* draws the bust dart and the waist darts */
} mus__bodice_def;

#define MUS__DARTS 2

/* a front or back half of a bodice */
typedef struct mus__bodice_half {
    double slope;    /* angle of the shoulder line below the horizontal [rad] */
    double hold[2];  /* handles of the neck curve: at the centre in neck widths, at the shoulder in neck depths */
    double centre[2], snp[2], tip[2], pitch[2], under[2], side[2]; /* neck at the centre, side neck, shoulder point,
                                                                      arm pitch, underarm, waist at the side */
    double neck[8];     /* centre to snp */
    double arm_high[8]; /* tip to pitch */
    double arm_low[8];  /* pitch to under */
    double theta;       /* angle of the bust dart [rad]; 0: no dart */
    double bust[2];     /* bust point, about which darts are rotated */
    double mouth[4];    /* ends of the bust dart on the side seam: upper, lower */
    double apex[2];     /* sewn point of the bust dart */
    int32_t ndart;      /* waist darts */
    double dart[MUS__DARTS][6]; /* inner mouth, sewn point, outer mouth; from the centre outwards */
    double neck_length, shoulder_length, arm_length, arm_low_length;
    double side_length;  /* of the side seam with the dart closed */
    double waist_length; /* of the waist line with the darts closed */
} mus__bodice_half;

typedef struct mus__bodice {
    mus__bodice_half front, back;
    double underarm;    /* y of the underarm, darts closed */
    double dart_width;  /* of all waist darts of one half */
    double side_in;     /* how far the side seam is taken in at the waist */
    double dart_drop;   /* length that the bust dart adds to the front */
    double front_waist; /* front waist length of the draft */
    double neck_depth;  /* of the front neck, from the side neck point */
} mus__bodice;

/* Drafts front and back halves. On MUS_ERR_DESIGN the message names the step and the measures that leave no room. */
mus_status mus__bodice_draft(mus_context *context, const mus__measures *measures, const mus__bodice_def *def,
                             mus__bodice *out);
/* Sets the eases of a woven bodice for the sex and size of the measures; darts for women. */
void mus__bodice_def_init(mus__bodice_def *def, const mus__measures *measures);
/* Redraws the neck curve with its side neck point moved `along` the shoulder and its centre lowered by `drop` [m]. */
void mus__bodice_lower_neck(mus__bodice_half *half, double along, double drop);

#endif
