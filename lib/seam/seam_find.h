/*
 * seam_find.h: the seams of a pattern without seams: facts of its edges, features of a sewing, search for the best.
 *
 * A sewing gives each edge of an outline at most one mate; two mates run against each other (MUS_SEAM_REVERSED). Its
 * score is the scalar product of its features with weights: features of each seam (lengths, curvature, directions,
 * notches, names), of each edge that stays free, of each vertex that the seams close or leave on an opening, of each
 * line of seams (one ratio of lengths goes through), and of the whole (components, handles, openings, mirror symmetry).
 * The weights are in seam_weights.c, which the study tests/study/seams writes: a multinomial logistic regression of the
 * right choice among the sewings that one change makes (conditional logit; McFadden 1974).
 *
 * seam_facts.c reads the facts of the edges from the pattern; seam_score.c has features and score, seam_search.c the
 * search by local changes and simulated annealing, seam_propose.c the public call.
 */
#ifndef MUS_SEAM_FIND_H
#define MUS_SEAM_FIND_H

#include <stdbool.h>
#include "muslin/pattern.h"
#include "seam/seam_features.h"

#define MUS__SEAM_WEIGHT_UNIT 1e-3 /* of mus__seam_weights; chosen: the fit leaves them uncertain by more */
#define MUS__SEAM_IN_NAME 8 /* words of a panel's name that are kept; chosen: names of pieces have up to five */
#define MUS__SEAM_EDGES 500 /* most edges; chosen: bounds the time to a minute; the largest of the data has 176 */

#define MUS__SEAM_FLAT 0.2 /* [rad] a corner nearer to the half turn is flat; chosen: twice what drawings stray */
#define MUS__SEAM_EQUAL_LENGTHS 2e-3 /* relative difference of equal lengths; chosen: 1 mm of a side seam */
#define MUS__SEAM_EQUAL_RATIOS 0.01  /* the same of ratios of lengths along a line of seams; chosen: cuts to 1 mm */

/* one edge of an outline, in the direction of the outline; the panel as its right side is seen, the grain upwards */
typedef struct mus__seam_edge {
    int32_t edge;      /* in the pattern */
    int32_t panel, next, prev; /* next and previous round the outline */
    int32_t mirror;    /* mirror image, MUS_NONE without one */
    int32_t notch, nnotch; /* in the list of notches */
    int32_t line;         /* edges that go on in one another at flat corners, with this one */
    int32_t equal, alone; /* number of other edges of equal length; 1 where none has it within 1 % */
    double length;     /* [m] */
    double log_length;
    double turn;       /* [rad] sum of the exterior angles along it; positive: convex */
    double normal[2];  /* of its chord, outwards */
    double start, end; /* [rad] interior angles of the panel at its ends */
    double height, across; /* of its middle within the panel: 0 (bottom) to 1, -1 to 1 from side to side */
    int32_t half, inwards; /* 1 on the wearer's left, -1 right; 1 looks to the body's centre, -1 away; 0 not known */
} mus__seam_edge;

typedef struct mus__seam_panel {
    int32_t first, n; /* its edges */
    int32_t sides, image, like; /* its MUS_SIDE_*; its mirror image, MUS_NONE without one; first of its shape */
    bool sure;        /* names or shapes leave no other image */
    uint64_t key;     /* equal for panels of equal edges */
    int32_t role;     /* of MUS__SEAM_ROLE_: what part of a garment the name tells, else the label */
    int32_t nword;
    uint32_t words[MUS__SEAM_IN_NAME];
    uint32_t stem;    /* of the name without its number */
    int32_t number;   /* in the name, MUS_NONE without */
} mus__seam_panel;

typedef struct mus__seam_facts {
    mus_context *context;
    int32_t n, npanel, nnotch;
    mus__seam_edge *edges;   /* (n) */
    mus__seam_panel *panels; /* (npanel) */
    double *notches;         /* (nnotch x 2) relative arc length and kind, ascending on each edge */
    double *lengths;         /* (n) logarithms of the lengths, ascending */
    int32_t *fixed;          /* (n) mate by a seam that the pattern has; MUS_NONE */
    double longest;          /* [m] */
} mus__seam_facts;

/* reads the facts of a pattern. Errors: MUS_ERR_LIMIT (MUS__SEAM_EDGES), MUS_ERR_MEMORY; *out is to be freed anyway */
mus_status mus__seam_read(const mus_pattern *pattern, mus__seam_facts *out);
void mus__seam_free(mus__seam_facts *facts);
/* number of other edges whose length differs from that of edge a by less than the ratio */
int32_t mus__seam_count_near(const mus__seam_facts *facts, int32_t a, double ratio);

/* whether no garment has this seam: what is on one arm goes to no panel of the other side */
bool mus__seam_never(const mus__seam_facts *facts, int32_t a, int32_t b);
/* features (MUS__SEAM_PAIRS) of a seam, and (MUS__SEAM_FREES) of an edge that stays free */
void mus__seam_pair(const mus__seam_facts *facts, int32_t a, int32_t b, double *out);
void mus__seam_free_edge(const mus__seam_facts *facts, int32_t a, double *out);
/* scratch memory of mus__seam_whole(), integers */
#define MUS__SEAM_SCRATCH(facts) (4 * (facts)->n + 4 * (facts)->npanel)
/* features (MUS__SEAM_WHOLES) of a sewing, mate (n) */
void mus__seam_whole(const mus__seam_facts *facts, const int32_t *mate, int32_t *scratch, double *out);

typedef struct mus__seam_search {
    const mus__seam_facts *facts;
    const double *weights;  /* (MUS__SEAM_FEATURES) those of a pair, of a free edge, of the whole */
    double *pairs;          /* (n x n) score of each seam; on the diagonal of each free edge */
    int32_t *near, nnear;   /* (n x nnear) mates of highest score, best first */
    int32_t *mate;          /* (n) best sewing found */
    double score;
    int32_t *trial, *keep, *scratch;
} mus__seam_search;

/* a change of a sewing: see mus__seam_change_apply() */
typedef struct mus__seam_change {
    int32_t a, b; /* to sew; b MUS_NONE: a is freed; a MUS_NONE: the mates of panel b and of its image swap */
    bool join;     /* the mates that they had are sewn to one another */
    bool on;       /* the edges beside them are sewn too, as long as the ratio of the lengths stays */
    bool to_end, over; /* the same at any ratio; the same along the outlines, over seams that are there */
    bool mirrored; /* the same is done to the mirror images */
} mus__seam_change;

mus_status mus__seam_begin(const mus__seam_facts *facts, const double *weights, mus__seam_search *out);
void mus__seam_end(mus__seam_search *search);
double mus__seam_score(mus__seam_search *search, const int32_t *mate);
/* *mate changed; false where the change is none, or touches a seam that is fixed */
bool mus__seam_change_apply(const mus__seam_facts *facts, const mus__seam_change *change, int32_t *mate);
/* change number i of all that are tried on a sewing; false: there are no more */
bool mus__seam_change_list(const mus__seam_search *search, int32_t i, mus__seam_change *out);
/* searches for the sewing of highest score from the seams that are fixed; rounds of simulated annealing, 0: none */
void mus__seam_run(mus__seam_search *search, int32_t rounds);
/* score of the sewing less the highest that one change without the seam of edge a has; *other is a's mate in that */
double mus__seam_margin(mus__seam_search *search, int32_t a, int32_t *other);

extern const int16_t mus__seam_weights[MUS__SEAM_FEATURES]; /* in units of MUS__SEAM_WEIGHT_UNIT */
extern const double mus__seam_confidence[2];

#endif
