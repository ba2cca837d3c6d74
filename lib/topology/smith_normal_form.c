/*
 * smith_normal_form.c: the Smith normal form of a sparse integer matrix: its rank and its invariant factors.
 *
 * Called by homology.c for the boundary operators of patterns (tens of rows) and of their meshes (thousands of rows;
 * nearly all entries are 1 or -1, so the rows stay short). Each round takes as pivot p the entry of least absolute
 * value, of the shortest row that has one, in row r and column c. It clears the column by row operations and the row by
 * column operations:
 *
 *     row_i -= floor(a_ic / p) row_r          column_j -= floor(a_rj / p) column_c
 *
 * A remainder is smaller than p and becomes the next pivot (Euclid's algorithm). When p is the only entry of column c,
 * the column operations change no other row. The pivots form a diagonal matrix; replacing diag(a, b) by
 * diag(gcd, lcm) makes each factor divide the next. Source: Munkres, Elements of Algebraic Topology, 1984, section 11.
 */
#include <string.h>

#include "topology/homology.h"

typedef struct smith_cell {
    int32_t column, value;
} smith_cell;

/* a row: n cells in ascending order of columns; n = -1 when the row has been a pivot row */
typedef struct smith_row {
    int32_t n, room;
    smith_cell *cell;
} smith_row;

typedef struct smith {
    mus_context *context;
    int32_t rows;
    smith_row *row, spare;
} smith;


static int32_t smith_size(int32_t value)
{
    return value < 0 ? -value : value;
}


/* Returns the entry of a row at a column; 0 when the row has no cell there. */
static int32_t smith_at(const smith_row *row, int32_t column)
{
    int32_t low = 0, high = row->n;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (row->cell[middle].column < column)
            low = middle + 1;
        else
            high = middle;
    }
    return low < row->n && row->cell[low].column == column ? row->cell[low].value : 0;
}


/* Adds factor times row r to row i. MUS_ERR_LIMIT when an entry does not fit 32 bits. */
static mus_status smith_add(smith *m, int32_t i, int32_t r, int64_t factor)
{
    const smith_row *a = &m->row[i], *b = &m->row[r];
    smith_row *sum = &m->spare;
    mus_status status = mus__reserve(m->context, &sum->cell, &sum->room, (int64_t)a->n + b->n, sizeof *sum->cell);
    if (status != MUS_OK) return status;
    sum->n = 0;
    for (int32_t j = 0, k = 0; j < a->n || k < b->n;) {
        bool left = k >= b->n || (j < a->n && a->cell[j].column <= b->cell[k].column);
        bool right = j >= a->n || (k < b->n && b->cell[k].column <= a->cell[j].column);
        int32_t column = left ? a->cell[j].column : b->cell[k].column;

        /* |value| and |factor| are below 2^31, so the sum fits 64 bits */
        int64_t value = (left ? a->cell[j].value : 0) + (right ? factor * b->cell[k].value : 0);
        if (value > INT32_MAX || value < -INT32_MAX)
            return mus__fail(m->context, MUS_ERR_LIMIT, "homology: an entry of %lld is beyond 2^31", (long long)value);
        if (value != 0) sum->cell[sum->n++] = (smith_cell){column, (int32_t)value};
        j += left, k += right;
    }
    smith_row keep = m->row[i];
    m->row[i] = *sum;
    *sum = keep;
    return MUS_OK;
}


/* Finds the next pivot: the entry of least absolute value, then of the shortest row. Returns false when no entry is
 * left. */
static bool smith_pivot(const smith *m, int32_t *row, int32_t *column)
{
    int32_t least = 0, length = 0;
    for (int32_t i = 0; i < m->rows; i++) {
        const smith_row *own = &m->row[i];
        if (own->n <= 0 || (least == 1 && own->n >= length)) continue;
        for (int32_t k = 0; k < own->n; k++) {
            int32_t size = smith_size(own->cell[k].value);
            if (least != 0 && (size > least || (size == least && own->n >= length))) continue;
            least = size, length = own->n;
            *row = i, *column = own->cell[k].column;
        }
    }
    return least != 0;
}


/* Clears column c by row operations with row r. *clean becomes true when no remainder is left in the column. */
static mus_status smith_clear_column(smith *m, int32_t r, int32_t c, bool *clean)
{
    int32_t pivot = smith_at(&m->row[r], c);
    for (int32_t i = 0; i < m->rows; i++) {
        int32_t value = i != r && m->row[i].n > 0 ? smith_at(&m->row[i], c) : 0;
        if (value == 0) continue;
        mus_status status = smith_add(m, i, r, -((int64_t)value / pivot));
        if (status != MUS_OK) return status;
        if (value % pivot != 0) *clean = false;
    }
    return MUS_OK;
}


/* Fills the rows from n entries (row, column, value): cells sorted by column, values of equal places summed. */
static mus_status smith_fill(smith *m, int32_t n, const int32_t *entry)
{
    for (int32_t k = 0; k < n; k++) {
        const int32_t *e = entry + 3 * (size_t)k;
        smith_row *row = &m->row[e[0]];
        mus_status status = mus__reserve(m->context, &row->cell, &row->room, (int64_t)row->n + 1, sizeof *row->cell);
        if (status != MUS_OK) return status;
        int32_t at = row->n++;
        for (; at > 0 && row->cell[at - 1].column > e[1]; at--) row->cell[at] = row->cell[at - 1];
        if (at > 0 && row->cell[at - 1].column == e[1]) {
            row->cell[at - 1].value += e[2];
            memmove(row->cell + at, row->cell + at + 1, (size_t)(row->n - at - 1) * sizeof *row->cell);
            row->n--;
        } else {
            row->cell[at] = (smith_cell){e[1], e[2]};
        }
    }

    /* remove cells whose sum is 0 */
    for (int32_t i = 0; i < m->rows; i++) {
        smith_row *row = &m->row[i];
        int32_t kept = 0;
        for (int32_t k = 0; k < row->n; k++)
            if (row->cell[k].value != 0) row->cell[kept++] = row->cell[k];
        row->n = kept;
    }
    return MUS_OK;
}


/* Reduces the matrix to a diagonal; factor[0 .. *rank - 1] are the pivots in the order in which they were found. */
static mus_status smith_reduce(smith *m, int32_t *rank, int32_t *factor)
{
    int32_t r = 0, c = 0;
    while (smith_pivot(m, &r, &c)) {
        bool clean = true;
        mus_status status = smith_clear_column(m, r, c, &clean);
        if (status != MUS_OK) return status;
        if (!clean) continue;

        /* column operations: each entry of the row is replaced by its remainder */
        smith_row *row = &m->row[r];
        int32_t pivot = smith_at(row, c), kept = 0;
        for (int32_t k = 0; k < row->n; k++) {
            smith_cell cell = row->cell[k];
            if (cell.column != c) cell.value %= pivot;
            if (cell.value != 0) row->cell[kept++] = cell;
        }
        row->n = kept;
        if (kept > 1) continue;
        row->n = -1;
        factor[(*rank)++] = smith_size(pivot);
    }
    return MUS_OK;
}


/* Replaces pairs of factors by (gcd, lcm) until each factor divides the next. */
static mus_status smith_order(mus_context *context, int32_t rank, int32_t *factor)
{
    for (int32_t i = 0; i < rank; i++) {
        for (int32_t j = i + 1; j < rank && factor[i] != 1; j++) {
            int32_t a = factor[i], b = factor[j];
            while (b != 0) {
                int32_t rest = a % b;
                a = b, b = rest;
            }
            int64_t lcm = (int64_t)(factor[i] / a) * factor[j];
            if (lcm > INT32_MAX)
                return mus__fail(context, MUS_ERR_LIMIT, "homology: a torsion coefficient of %lld is beyond 2^31",
                                 (long long)lcm);
            factor[i] = a, factor[j] = (int32_t)lcm;
        }
    }
    return MUS_OK;
}


mus_status mus__smith(mus_context *context, int32_t rows, int32_t n, const int32_t *entry, int32_t *rank,
                      int32_t *factor)
{
    *rank = 0;
    smith m = {.context = context, .rows = rows, .row = mus__new(context, rows, sizeof *m.row)};
    if (m.row == NULL) return mus__fail_memory(context, "the homology of a pattern");
    mus_status status = smith_fill(&m, n, entry);
    if (status == MUS_OK) status = smith_reduce(&m, rank, factor);
    if (status == MUS_OK) status = smith_order(context, *rank, factor);
    for (int32_t i = 0; i < rows; i++) mus__free(context, m.row[i].cell);
    mus__free(context, m.spare.cell);
    mus__free(context, m.row);
    return status == MUS_ERR_MEMORY ? mus__fail_memory(context, "the homology of a pattern") : status;
}
