/*
 * cut_ring.c: the ring of corners that becomes a cut line.
 */
#include "pattern/cut_ring.h"


void mus__cut_add(mus__cut_ring *ring, const mus__cut_corner *corner)
{
    if (ring->status != MUS_OK) return;
    ring->status = mus__reserve(ring->context, &ring->list, &ring->room, (int64_t)ring->n + 1, sizeof *ring->list);
    if (ring->status == MUS_OK) ring->list[ring->n++] = *corner;
}
