/*
 * fit_spread.c: percentiles of a quantity of a fit, by the area of the cloth.
 *
 * The largest value of a mesh belongs to one node at a corner, a dart or a fold, and grows with each finer mesh. A
 * percentile by area is a figure of the garment: it comes to rest as the mesh is refined.
 */
#include <math.h>
#include <stdlib.h>

#include "base/sort.h"
#include "fit/fit_internal.h"

typedef struct fit_entry {
    double value, area;
    int32_t node;
} fit_entry;


void mus_fit_spread_init(mus_fit_spread *spread, size_t size)
{
    mus_fit_spread own = {.node = MUS_NONE};
    mus__def_init(spread, size, &own, sizeof own);
}


static int entry_order(const void *a, const void *b)
{
    const fit_entry *p = a, *q = b;
    if (p->value != q->value) return p->value < q->value ? -1 : 1;
    return p->node < q->node ? -1 : p->node > q->node;
}


static double value_at(const mus_fit *fit, int32_t quantity, int32_t i)
{
    switch (quantity) {
    case MUS_FIT_STRAIN: return fmax(fit->warp[i], fit->weft[i]);
    case MUS_FIT_WARP: return fit->warp[i];
    case MUS_FIT_WEFT: return fit->weft[i];
    case MUS_FIT_PRESSURE: return fit->pressure[i];
    default: return fit->gap[i];
    }
}


/* the least value that `part` of the area has at most; entries (n) in order */
static double percentile(const fit_entry *entry, int32_t n, double area, double part)
{
    double sum = 0.0;
    for (int32_t i = 0; i < n; i++) {
        sum += entry[i].area;
        if (sum >= part * area) return entry[i].value;
    }
    return n > 0 ? entry[n - 1].value : (double)NAN;
}


mus_status mus_fit_spread_get(const mus_fit *fit, int32_t quantity, mus_fit_spread *out)
{
    if (fit == NULL) return MUS_ERR_ARG;
    if (quantity < MUS_FIT_STRAIN || quantity > MUS_FIT_GAP)
        return mus__fail(fit->context, MUS_ERR_ARG, "fit: quantity %d is not one of %d to %d", (int)quantity,
                         MUS_FIT_STRAIN, MUS_FIT_GAP);
    if (out == NULL) return mus__fail(fit->context, MUS_ERR_ARG, "fit: out is NULL");
    if (out->size != sizeof *out)
        return mus__fail(fit->context, MUS_ERR_VERSION, "mus_fit_spread.size %zu is unknown; use mus_fit_spread_init",
                         out->size);
    fit_entry *entry = mus__new(fit->context, fit->n, sizeof *entry);
    if (entry == NULL) return mus__fail_memory(fit->context, "the spread of a fit");

    int32_t n = 0;
    double sum = 0.0;
    mus_fit_spread_init(out, sizeof *out);
    for (int32_t i = 0; i < fit->n; i++) {
        const double value = value_at(fit, quantity, i);
        if (isnan(value) || !(fit->area[i] > 0.0)) continue;
        entry[n++] = (fit_entry){value, fit->area[i], i};
        out->area += fit->area[i];
        sum += value * fit->area[i];
    }
    mus__sort(entry, (size_t)n, sizeof *entry, entry_order);
    out->p50 = percentile(entry, n, out->area, 0.50);
    out->p95 = percentile(entry, n, out->area, 0.95);
    out->p99 = percentile(entry, n, out->area, 0.99);
    out->mean = n > 0 ? sum / out->area : (double)NAN;
    out->least = n > 0 ? entry[0].value : (double)NAN;
    out->largest = n > 0 ? entry[n - 1].value : (double)NAN;
    out->node = n > 0 ? entry[n - 1].node : MUS_NONE;
    mus__free(fit->context, entry);
    return MUS_OK;
}
