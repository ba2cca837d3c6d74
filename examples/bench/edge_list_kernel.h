/* edge_list_kernel.h: the body of edge_list.c as a template on the floating type (PLAIN_REAL, PLAIN, PLAIN_SQRT) */

void PLAIN(free)(PLAIN(list) *list)
{
    void *blocks[] = {list->spring, list->stencil, list->k, list->rest,  list->bend, list->mass,
                      list->y,      list->f,       list->sum, list->stage, list->rate};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) free(blocks[i]);
    memset(list, 0, sizeof *list);
}


static void PLAIN(add_spring)(PLAIN(list) *list, int32_t a, int32_t b, double k, double rest)
{
    if (!(k > 0.0)) return;
    list->spring[2 * list->springs] = a;
    list->spring[2 * list->springs + 1] = b;
    list->k[list->springs] = (PLAIN_REAL)k;
    list->rest[list->springs++] = (PLAIN_REAL)rest;
}


static void PLAIN(add_stencil)(PLAIN(list) *list, int32_t middle, int32_t step, double k)
{
    if (!(k > 0.0)) return;
    for (int32_t i = 0; i < 3; i++) list->stencil[3 * list->stencils + i] = middle + (i - 1) * step;
    list->bend[list->stencils++] = (PLAIN_REAL)k;
}


/* Adds the springs that start at node (r, c) and the stencils centred there. */
static void PLAIN(add_node)(const plain_lattice *l, PLAIN(list) *list, int32_t r, int32_t c)
{
    const int32_t n = l->columns, i = r * n + c, right = c + 1 < n, up = r + 1 < l->rows;
    const double row = r == 0 || !up ? 0.5 : 1.0, column = c == 0 || !right ? 0.5 : 1.0;
    const double diagonal = sqrt(l->cell[0] * l->cell[0] + l->cell[1] * l->cell[1]);
    list->y[3 * i] = (PLAIN_REAL)(c * l->cell[0]);
    list->y[3 * i + 1] = (PLAIN_REAL)(r * l->cell[1]);
    list->mass[i] = (PLAIN_REAL)(l->weight * l->cell[0] * l->cell[1] * row * column);
    if (right) PLAIN(add_spring)(list, i, i + 1, l->k[1] * row, l->cell[0]);
    if (up) PLAIN(add_spring)(list, i, i + n, l->k[0] * column, l->cell[1]);
    if (right && up) PLAIN(add_spring)(list, i, i + n + 1, l->shear, diagonal);
    if (right && up) PLAIN(add_spring)(list, i + 1, i + n, l->shear, diagonal);
    const int32_t wide = c > 0 && right, high = r > 0 && up;
    if (wide) PLAIN(add_stencil)(list, i, 1, l->bend[1] * row);
    if (high) PLAIN(add_stencil)(list, i, n, l->bend[0] * column);
    if (wide && high) PLAIN(add_stencil)(list, i, n + 1, l->cross);
    if (wide && high) PLAIN(add_stencil)(list, i, n - 1, l->cross);
}


int PLAIN(make)(const plain_lattice *lattice, PLAIN(list) *out)
{
    memset(out, 0, sizeof *out);
    out->n = lattice->rows * lattice->columns;
    const size_t n = (size_t)out->n, real = sizeof(PLAIN_REAL);
    out->spring = malloc(n * 8 * sizeof *out->spring);
    out->stencil = malloc(n * 12 * sizeof *out->stencil);
    out->k = malloc(n * 4 * real);
    out->rest = malloc(n * 4 * real);
    out->bend = malloc(n * 4 * real);
    out->mass = malloc(n * real);
    out->y = calloc(n * 6, real);
    out->f = malloc(n * 3 * real);
    out->stage = malloc(n * 6 * real);
    out->sum = malloc(n * 6 * real);
    out->rate = malloc(n * 6 * real);
    if (!out->spring || !out->stencil || !out->k || !out->rest || !out->bend || !out->mass || !out->y || !out->f ||
        !out->stage || !out->sum || !out->rate)
        return -1;
    out->drag = (PLAIN_REAL)lattice->drag;
    out->gravity = (PLAIN_REAL)-9.81;
    for (int32_t r = 0; r < lattice->rows; r++)
        for (int32_t c = 0; c < lattice->columns; c++) PLAIN(add_node)(lattice, out, r, c);
    return 0;
}


void PLAIN(force)(PLAIN(list) *list, const PLAIN_REAL *restrict x)
{
    PLAIN_REAL *restrict f = list->f;
    memset(f, 0, (size_t)list->n * 3 * sizeof *f);
    for (int32_t e = 0; e < list->springs; e++) {
        const int32_t a = 3 * list->spring[2 * e], b = 3 * list->spring[2 * e + 1];
        const PLAIN_REAL dx = x[b] - x[a], dy = x[b + 1] - x[a + 1], dz = x[b + 2] - x[a + 2];
        const PLAIN_REAL l = PLAIN_SQRT(dx * dx + dy * dy + dz * dz + (PLAIN_REAL)1e-20);
        const PLAIN_REAL s = list->k[e] - list->k[e] * list->rest[e] / l;
        f[a] += s * dx, f[a + 1] += s * dy, f[a + 2] += s * dz;
        f[b] -= s * dx, f[b + 1] -= s * dy, f[b + 2] -= s * dz;
    }
    for (int32_t e = 0; e < list->stencils; e++) {
        const int32_t *node = list->stencil + 3 * e;
        const int32_t a = 3 * node[0], b = 3 * node[1], c = 3 * node[2];
        for (int32_t d = 0; d < 3; d++) {
            const PLAIN_REAL bend = list->bend[e] * (x[a + d] - 2 * x[b + d] + x[c + d]);
            f[a + d] -= bend, f[b + d] += 2 * bend, f[c + d] -= bend;
        }
    }
}


/* rate = (v, f/m + g - drag v) */
static void PLAIN(rates)(PLAIN(list) *list, const PLAIN_REAL *restrict y, PLAIN_REAL *restrict rate)
{
    const int32_t n = list->n;
    const PLAIN_REAL *restrict f = list->f, *restrict v = y + 3 * n, *restrict mass = list->mass;
    PLAIN(force)(list, y);
    memcpy(rate, v, (size_t)n * 3 * sizeof *rate);
    for (int32_t i = 0; i < n; i++) {
        const PLAIN_REAL free = mass[i] > 0, inverse = mass[i] > 0 ? 1 / mass[i] : 0;
        for (int32_t d = 0; d < 3; d++)
            rate[3 * n + 3 * i + d] = f[3 * i + d] * inverse - list->drag * v[3 * i + d];
        rate[3 * n + 3 * i + 1] += list->gravity * free;
    }
}


void PLAIN(rk4)(PLAIN(list) *list, PLAIN_REAL h)
{
    const int32_t n = 6 * list->n;
    const PLAIN_REAL half = h / 2, sixth = h / 6;
    PLAIN_REAL *restrict y = list->y, *restrict stage = list->stage, *restrict sum = list->sum;
    PLAIN_REAL *restrict k = list->rate;
    PLAIN(rates)(list, y, k);
    for (int32_t i = 0; i < n; i++) sum[i] = k[i], stage[i] = y[i] + half * k[i];
    PLAIN(rates)(list, stage, k);
    for (int32_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + half * k[i];
    PLAIN(rates)(list, stage, k);
    for (int32_t i = 0; i < n; i++) sum[i] += 2 * k[i], stage[i] = y[i] + h * k[i];
    PLAIN(rates)(list, stage, k);
    for (int32_t i = 0; i < n; i++) y[i] += sixth * (sum[i] + k[i]);
}
