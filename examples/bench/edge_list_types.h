/* edge_list_types.h: the types and functions of edge_list.h in one precision (PLAIN_REAL, PLAIN). */

typedef struct PLAIN(list) {
    int32_t n, springs, stencils;
    int32_t *spring;                    /* (springs x 2) */
    int32_t *stencil;                   /* (stencils x 3) */
    PLAIN_REAL *k, *rest, *bend;        /* (springs), (springs), (stencils) */
    PLAIN_REAL *mass;                   /* (n) [kg]; 0: a fixed node */
    PLAIN_REAL *y;                      /* (6 n) positions, then velocities, xyz together */
    PLAIN_REAL *f;                      /* (3 n) */
    PLAIN_REAL *stage, *sum, *rate;     /* (6 n) */
    PLAIN_REAL drag, gravity;
} PLAIN(list);

/* Makes the list, with nodes at rest at (c cell[0], r cell[1], 0). Returns 0, or -1 without memory; must be freed in
 * either case. */
int PLAIN(make)(const plain_lattice *lattice, PLAIN(list) *out);
void PLAIN(free)(PLAIN(list) *list);
/* Computes f, the forces of springs and stencils at the positions x (3 n). */
void PLAIN(force)(PLAIN(list) *list, const PLAIN_REAL *x);
/* Makes one RK4 step of length h [s], with gravity along -y. */
void PLAIN(rk4)(PLAIN(list) *list, PLAIN_REAL h);
