/*
 * body_mirror.c: the right half of a symmetric body, from its left one.
 *
 * A body of a tape with all limbs is symmetric until it is posed. Its fillets, details and girths are made on the left
 * half alone, which halves the time and keeps both sides equal to the last bit.
 */
#include <string.h>

#include "body/body_internal.h"


bool mus__limb_is_right(int32_t l)
{
    return l > MUS__LIMB_TORSO && l < MUS__LIMB_COUNT && l % 2 == 0;
}


bool mus__body_is_even(const mus_body *body)
{
    return body->measured && body->frame == NULL && body->def.without == 0 && body->limb_count == MUS__LIMB_COUNT;
}


int32_t mus__mirror_part(const mus_body *body, int32_t q)
{
    const int32_t l = body->rig.part[q].limb;
    int32_t first = q, other = 0;
    if (l == MUS__LIMB_TORSO) return q;
    while (first > 0 && body->rig.part[first - 1].limb == l) first--;
    while (body->rig.part[other].limb != l + 1) other++;
    return other + q - first;
}


/* entry k on the left, X > 0, mirrors entry n/2 - k on the right */
void mus__body_mirror(mus_body *body, bool limbs)
{
    for (int32_t q = 0; q < body->nfield; q++) {
        const mus__field *from = &body->field[q];
        const int32_t l = body->rig.part[q].limb, n = from->nangle;
        if (limbs == (l == MUS__LIMB_TORSO) || mus__limb_is_right(l)) continue;
        mus__field *to = &body->field[mus__mirror_part(body, q)];
        if (to != from) {
            memcpy(to->fine, from->fine, sizeof to->fine);
            memcpy(to->largest, from->largest, (size_t)from->nring * sizeof *to->largest);
        }
        to->reach = from->reach;
        for (int32_t j = 0; j < from->nring; j++) {
            const double *x = from->radius + (ptrdiff_t)j * n;
            double *y = to->radius + (ptrdiff_t)j * n;
            for (int32_t k = 0; k < n; k++)
                if (to != from || k <= n / 4 || k >= n - n / 4) y[(n + n / 2 - k) % n] = x[k];
        }
    }
    for (int32_t l = MUS__LIMB_ARM_RIGHT; l < MUS__LIMB_COUNT && limbs; l += 2)
        for (int32_t i = 0; i < body->limb[l].count; i++) {
            const mus__contour *from = &body->limb[l - 1].contour[i];
            mus__contour *to = &body->limb[l].contour[i];
            to->a = from->a, to->b = from->b;
            memcpy(to->bump, from->bump, sizeof to->bump);
        }
}
