/*
 * seam_kinds.h: the parts of a garment, and the kinds of seams and free edges, each of which has its own weight.
 */
#ifndef MUS_SEAM_KINDS_H
#define MUS_SEAM_KINDS_H

/* parts of a garment, told by the words of a panel's name */
enum {
    MUS__SEAM_ROLE_NONE,
    MUS__SEAM_ROLE_TORSO,
    MUS__SEAM_ROLE_SLEEVE,
    MUS__SEAM_ROLE_CUFF,
    MUS__SEAM_ROLE_COLLAR,
    MUS__SEAM_ROLE_HOOD,
    MUS__SEAM_ROLE_BAND,
    MUS__SEAM_ROLE_SKIRT,
    MUS__SEAM_ROLE_INSERT,
    MUS__SEAM_ROLE_LEG,
    MUS__SEAM_ROLE_LEG_CUFF,
    MUS__SEAM_ROLE_FLOUNCE, /* of a cuff */
    MUS__SEAM_ROLE_POCKET,
    MUS__SEAM_ROLES
};

/* tables of kinds, of which each seam and each free edge has one: see seam_score.c */
#define MUS__SEAM_RELATIONS 4  /* of two panels: one, images of one another, front and back, others */
#define MUS__SEAM_DIRECTIONS 6 /* of two normals */
#define MUS__SEAM_LENGTHS 3    /* of two lengths: within 0.2 %, within 5 %, others */
#define MUS__SEAM_SEAM_KINDS (MUS__SEAM_RELATIONS * MUS__SEAM_DIRECTIONS * MUS__SEAM_LENGTHS)
#define MUS__SEAM_FREE_KINDS 36
#define MUS__SEAM_TWO_ROLES (MUS__SEAM_ROLES * (MUS__SEAM_ROLES + 1) / 2) /* two parts, without order */
#define MUS__SEAM_TURNS 4 /* of two edges: both straight, as of complementary curves, equal, others */
#define MUS__SEAM_SIDES 4 /* to which a free edge looks: down, up, across, between */

#endif
