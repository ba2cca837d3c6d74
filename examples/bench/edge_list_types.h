/* edge_list_types.h: the plain form in one precision (PLAIN_REAL, PLAIN): see edge_list.h. */

typedef struct PLAIN(list) {
    int32_t n, springs, stencils;
    int32_t *spring;                    /* (springs x 2) */
    int32_t *stencil;                   /* (stencils x 3) */
    PLAIN_REAL *k, *rest, *bend;        /* (springs), (springs), (stencils) */
    PLAIN_REAL *mass;                   /* (n) 0: held */
    PLAIN_REAL *y;                      /* (6 n) places, then velocities, xyz together */
    PLAIN_REAL *f;                      /* (3 n) */
    PLAIN_REAL *stage, *sum, *rate;     /* (6 n) */
    PLAIN_REAL drag, gravity;
} PLAIN(list);

/* nodes flat at (c cell[0], r cell[1], 0), at rest; returns 0, or -1 without memory. Free it in either case */
int PLAIN(make)(const plain_lattice *lattice, PLAIN(list) *out);
void PLAIN(free)(PLAIN(list) *list);
/* f = forces of springs and stencils at the places x (3 n) */
void PLAIN(force)(PLAIN(list) *list, const PLAIN_REAL *x);
/* a step of RK4, gravity along -y */
void PLAIN(rk4)(PLAIN(list) *list, PLAIN_REAL h);
