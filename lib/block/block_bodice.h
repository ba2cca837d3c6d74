/*
 * block_bodice.h: the bodice block, front and back half.
 *
 * Frame of a block: x from the centre line outwards to the side seam, y up, y = 0 on the waist line; lengths in metre,
 * angles in radian. A drawn front half is the wearer's left, a drawn back half the wearer's right.
 */
#ifndef MUS_BLOCK_BODICE_H
#define MUS_BLOCK_BODICE_H

#include "block/chain.h"
#include "block/measures.h"

typedef struct mus__bodice_def {
    double bust_ease;  /* total, on the girth */
    double waist_ease; /* total */
    double scye_ease;  /* armhole deeper than the scye depth by */
    double balance;    /* front half wider than the back half by */
    double neck_ease;  /* total */
    bool darts;
} mus__bodice_def;

#define MUS__DARTS 2

/* a front or back half of a bodice */
typedef struct mus__bodice_half {
    double slope;    /* of the shoulder line below the horizontal */
    double hold[2];  /* neck handles: at the centre as part of its width, at the shoulder as part of its depth */
    double centre[2], snp[2], tip[2], pitch[2], under[2], side[2]; /* neck at the centre, side neck, shoulder point,
                                                                      arm pitch, underarm, waist at the side */
    double neck[8];     /* centre to snp */
    double arm_high[8]; /* tip to pitch */
    double arm_low[8];  /* pitch to under */
    double theta;       /* bust dart angle, 0 without */
    double bust[2];     /* bust point: where the darts turn */
    double mouth[4];    /* ends of the bust dart on the side seam: upper, lower */
    double apex[2];     /* sewn point of the bust dart */
    int32_t ndart;      /* waist darts */
    double dart[MUS__DARTS][6]; /* inner mouth, sewn point, outer mouth; from the centre outwards */
    double neck_length, shoulder_length, arm_length, arm_low_length;
    double side_length;  /* dart closed */
    double waist_length; /* darts closed */
} mus__bodice_half;

typedef struct mus__bodice {
    mus__bodice_half front, back;
    double underarm;    /* y */
    double dart_width;  /* waist dart of one half */
    double side_in;     /* side seam taken in at the waist */
    double dart_drop;   /* what the bust dart makes the front longer by */
    double front_waist; /* front waist length of the draft */
    double neck_depth;  /* front, from the side neck */
} mus__bodice;

/* drafts the block; MUS_ERR_DESIGN names the step and the measures that leave no room */
mus_status mus__bodice_draft(mus_context *context, const mus__measures *measures, const mus__bodice_def *def,
                             mus__bodice *out);
/* the house values: woven, darted for women */
void mus__bodice_def_init(mus__bodice_def *def, const mus__measures *measures);
/* redraw a neckline: side neck `along` the shoulder, centre `drop` lower */
void mus__bodice_lower_neck(mus__bodice_half *half, double along, double drop);

#endif
