/*
 * alike.c: sewings that differ only by panels of one shape: the judge of `make seams` counts them as the same.
 *
 * Panels are exchanged only where lengths, angles, curvature, notches and grain agree edge by edge, not mirrored.
 */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "alike.h"

#define ALIKE_LENGTH 5e-4 /* [m] lengths of panels that can stand for one another */
#define ALIKE_ANGLE 0.01  /* [rad] and their angles; relative arc length of notches */


/* whether edges a and b of two panels are alike: lengths, angles, curvature, notches; `turned`: one upside down */
static bool alike(const mus__seam_facts *f, const mus__seam_edge *a, const mus__seam_edge *b, bool turned)
{
    const double sign = turned ? -1.0 : 1.0;
    if (fabs(a->length - b->length) > ALIKE_LENGTH || fabs(a->start - b->start) > ALIKE_ANGLE ||
        fabs(a->end - b->end) > ALIKE_ANGLE || fabs(a->turn - b->turn) > ALIKE_ANGLE ||
        fabs(a->normal[0] - sign * b->normal[0]) > ALIKE_ANGLE ||
        fabs(a->normal[1] - sign * b->normal[1]) > ALIKE_ANGLE || a->nnotch != b->nnotch)
        return false;
    for (int32_t i = 0; i < 2 * a->nnotch; i++)
        if (fabs(f->notches[2 * a->notch + i] - f->notches[2 * b->notch + i]) > ALIKE_ANGLE) return false;
    return true;
}


/* exchanges panels p and q, edge i of p for edge i + shift of q, in the sewing; false where the two are not alike.
 * With p = q the panel is turned upside down. */
static bool exchange(const mus__seam_facts *f, int32_t p, int32_t q, int32_t shift, int32_t *mate, int32_t *work)
{
    const mus__seam_panel *a = &f->panels[p], *b = &f->panels[q];
    bool upright = true, turned = true;
    for (int32_t i = 0; i < f->n; i++) work[i] = i;
    for (int32_t i = 0; i < a->n; i++) {
        const int32_t x = a->first + i, y = b->first + (i + shift) % b->n;
        if (f->edges[x].next != a->first + (i + 1) % a->n || f->edges[y].next != b->first + (i + shift + 1) % b->n)
            return false;
        upright = upright && alike(f, &f->edges[x], &f->edges[y], false);
        turned = turned && alike(f, &f->edges[x], &f->edges[y], true);
        work[x] = y;
        if (p != q) work[y] = x;
    }
    if (!upright && !turned) return false;
    for (int32_t i = 0; i < f->n; i++) work[f->n + work[i]] = mate[i] == MUS_NONE ? MUS_NONE : work[mate[i]];
    memcpy(mate, work + f->n, sizeof *mate * (size_t)f->n);
    return true;
}


int32_t seams_wrong(const mus__seam_facts *f, const int32_t *truth, const int32_t *mate)
{
    int32_t wrong = 0;
    for (int32_t a = 0; a < f->n; a++)
        wrong += (mate[a] > a && truth[a] != mate[a]) + (truth[a] > a && truth[a] != mate[a]);
    return wrong;
}


/* turns all panels upside down at once that are the same so: the parts of a garment may be turned together */
static void turn_all(const mus__seam_facts *f, int32_t *truth, const int32_t *mate, int32_t *work)
{
    int32_t *turned = work + 3 * f->n;
    memcpy(turned, truth, sizeof *truth * (size_t)f->n);
    for (int32_t p = 0; p < f->npanel; p++)
        for (int32_t shift = 1; shift < f->panels[p].n; shift++)
            if (exchange(f, p, p, shift, turned, work)) break;
    if (seams_wrong(f, turned, mate) < seams_wrong(f, truth, mate))
        memcpy(truth, turned, sizeof *truth * (size_t)f->n);
}


/* whether panel q can stand for panel p, its edge i + shift for edge i of p */
static bool stands_for(const mus__seam_facts *f, int32_t p, int32_t q, int32_t shift)
{
    const mus__seam_panel *a = &f->panels[p], *b = &f->panels[q];
    bool upright = true, turned = true;
    for (int32_t i = 0; i < a->n; i++) {
        const mus__seam_edge *x = &f->edges[a->first + i], *y = &f->edges[b->first + (i + shift) % b->n];
        upright = upright && alike(f, x, y, false);
        turned = turned && alike(f, x, y, true);
    }
    return upright || turned;
}


/* carries names from the found sewing to the true one along the seams: panel `seed` stands for itself, the panel that
 * is sewn to it for the one that is truly sewn there if it can, and so on; the others as before where they are free.
 * to[a] is the edge that a stands for */
static void follow(const mus__seam_facts *f, int32_t seed, const int32_t *truth, const int32_t *mate, int32_t *to,
                   int32_t *queue)
{
    int32_t *taken = queue + f->npanel, end = 0;
    for (int32_t a = 0; a < f->n; a++) to[a] = MUS_NONE;
    for (int32_t p = 0; p < f->npanel; p++) taken[p] = 0;
    for (int32_t next = 0, begin = seed; begin != MUS_NONE;) {
        for (int32_t i = 0; i < f->panels[begin].n; i++) to[f->panels[begin].first + i] = f->panels[begin].first + i;
        taken[begin] = 1;
        queue[end++] = begin;
        for (; next < end; next++)
            for (int32_t i = 0; i < f->panels[queue[next]].n; i++) {
                const int32_t a = f->panels[queue[next]].first + i, b = mate[a], d = truth[to[a]];
                if (b == MUS_NONE || d == MUS_NONE || to[b] != MUS_NONE) continue;
                const int32_t p = f->edges[b].panel, q = f->edges[d].panel, n = f->panels[p].n;
                if (f->panels[q].n != n || taken[q]) continue;
                const int32_t shift = (d - f->panels[q].first - (b - f->panels[p].first) + n) % n;
                if (!stands_for(f, p, q, shift)) continue;
                for (int32_t k = 0; k < n; k++) to[f->panels[p].first + k] = f->panels[q].first + (k + shift) % n;
                taken[q] = 1;
                queue[end++] = p;
            }
        begin = MUS_NONE;
        for (int32_t p = f->npanel - 1; p >= 0; p--)
            if (f->panels[p].n > 0 && to[f->panels[p].first] == MUS_NONE && !taken[p]) begin = p;
    }
}


/* the names of follow() from each panel in turn, where all panels have one */
static void rename_along(const mus__seam_facts *f, int32_t *truth, const int32_t *mate, int32_t *work)
{
    int32_t *to = work, *renamed = work + f->n, *queue = work + 2 * f->n;
    for (int32_t seed = 0; seed < f->npanel; seed++) {
        bool whole = f->panels[seed].n > 0;
        if (whole) follow(f, seed, truth, mate, to, queue);
        for (int32_t a = 0; a < f->n && whole; a++) whole = to[a] != MUS_NONE;
        if (!whole) continue;
        /* an edge is truly sewn as the edge is that it stands for */
        for (int32_t a = 0; a < f->n; a++) {
            renamed[a] = MUS_NONE;
            for (int32_t b = 0; b < f->n; b++)
                if (truth[to[a]] != MUS_NONE && to[b] == truth[to[a]]) renamed[a] = b;
        }
        if (seams_wrong(f, renamed, mate) < seams_wrong(f, truth, mate))
            memcpy(truth, renamed, sizeof *truth * (size_t)f->n);
    }
}


void seams_match(const mus__seam_facts *f, int32_t *truth, const int32_t *mate)
{
    const size_t bytes = sizeof *mate * (size_t)f->n;
    int32_t *work = malloc(4 * bytes + 2 * sizeof *work * (size_t)f->npanel + 1), *before = work + 2 * f->n;
    rename_along(f, truth, mate, work);
    turn_all(f, truth, mate, work);
    int32_t wrong = seams_wrong(f, truth, mate);
    bool moved = wrong > 0;
    while (moved) {
        moved = false;
        for (int32_t p = 0; p < f->npanel; p++)
            for (int32_t q = p; q < f->npanel; q++)
                for (int32_t shift = p == q; f->panels[p].n == f->panels[q].n && shift < f->panels[p].n; shift++) {
                    memcpy(before, truth, bytes);
                    if (!exchange(f, p, q, shift, truth, work)) continue;
                    const int32_t now = seams_wrong(f, truth, mate);
                    if (now < wrong) {
                        wrong = now;
                        moved = true;
                    } else {
                        memcpy(truth, before, bytes);
                    }
                }
    }
    free(work);
}
