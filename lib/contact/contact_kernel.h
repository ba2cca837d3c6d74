/*
 * contact_kernel.h: the contact pass, as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_CONTACT).
 *
 * The fields stand `skin` off the body already (contact.c), so depths are taken from there and are small where a node
 * rests: a depth of first order jumps a little from ring to ring, but not at zero. A node nearer than the clearance is
 * put back along the outward normal (by at most `push`), loses its velocity into the skin, and its sliding velocity
 * shrinks by the friction impulse mu |v_n|. The step that led here moved the node with the velocity it had before the
 * impulse; `slip` times the change takes that sliding back, so that what sticks does not creep by h^2 f/m a step.
 */

/* [m] a node this near to the clearance is still on the skin: a float state rounds by as much */
#define TOUCH_BAND 2e-6

#define SIT_OUT_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define SIT_OUT_MOST 100    /* calls */

/* one node against one limb it may touch: x, v (3) are corrected in place */
static inline void MUS_FIELD(respond)(MUS_REAL lift, const mus__contact_rule *rule, const MUS_REAL *normal,
                                      MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL push = (MUS_REAL)rule->push, friction = (MUS_REAL)rule->friction, slip = (MUS_REAL)rule->slip;
    const MUS_REAL move = lift < 0 ? 0 : lift < push ? lift : push;
    for (int32_t i = 0; i < 3; i++) x[i] += move * normal[i];

    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    if (vn >= 0) return;
    MUS_REAL t[3];
    for (int32_t i = 0; i < 3; i++) t[i] = v[i] - vn * normal[i];
    const MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const MUS_REAL loss = -friction * vn;
    const MUS_REAL keep = speed > loss ? (speed - loss) / speed : 0;
    for (int32_t i = 0; i < 3; i++) {
        v[i] = keep * t[i];
        x[i] -= slip * (t[i] - v[i]);
    }
}


/* one node against all limbs, in place; box (nlimb x 6) is widened by `margin` already. Returns a lower bound of the
 * node's distance to the body, at most `margin` */
static inline MUS_REAL MUS_FIELD(touch)(const mus__collider *collider, const mus__contact_rule *rule,
                                        const MUS_REAL *box, MUS_REAL margin, MUS_REAL *p, MUS_REAL *w,
                                        int64_t *queries)
{
    const MUS_REAL clearance = (MUS_REAL)(rule->clearance - collider->skin), band = clearance + (MUS_REAL)TOUCH_BAND;
    MUS_REAL distance = margin;
    for (int32_t l = 0; l < collider->nlimb; l++, box += 6) {
        if (p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5])
            continue;

        MUS_REAL normal[3];
        int32_t near;
        const MUS_REAL depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (near == 0) continue;
        if (near < 0) {
            distance = 0;
            continue;
        }
        if (-depth < distance) distance = -depth;
        if (depth > -band) MUS_FIELD(respond)(depth + clearance, rule, normal, p, w);
    }
    return distance;
}


int64_t MUS_CONTACT(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                    int32_t last, const MUS_REAL *mobile, uint8_t *rest, MUS_REAL *x, MUS_REAL *v)
{
    /* a node sits out as many calls as half its distance allows; the half is for the error of a first-order distance */
    const MUS_REAL margin = (MUS_REAL)(rule->travel > 0.0 ? rule->clearance + SIT_OUT_MARGIN : rule->clearance);
    const MUS_REAL calls = (MUS_REAL)(rule->travel > 0.0 ? 0.5 / rule->travel : 0.0);
    MUS_REAL box[6 * MUS_LIMBS_MOST];
    for (int32_t k = 0; k < 6 * collider->nlimb; k++)
        box[k] = (MUS_REAL)collider->box[k] + (k % 6 < 3 ? -margin : margin);

    int64_t queries = 0;
    for (int32_t i = first; i < last; i++) {
        if (rest[i] > 0) {
            rest[i]--;
            continue;
        }
        if (mobile[i] == 0) continue;
        MUS_REAL p[3] = {x[i], x[n + i], x[2 * (int64_t)n + i]};
        MUS_REAL w[3] = {v[i], v[n + i], v[2 * (int64_t)n + i]};
        const MUS_REAL distance = MUS_FIELD(touch)(collider, rule, box, margin, p, w, &queries);
        const MUS_REAL off = (distance - (MUS_REAL)(rule->clearance - collider->skin)) * calls;
        rest[i] = off >= SIT_OUT_MOST ? SIT_OUT_MOST : off > 0 ? (uint8_t)off : 0;
        x[i] = p[0], x[n + i] = p[1], x[2 * (int64_t)n + i] = p[2];
        v[i] = w[0], v[n + i] = w[1], v[2 * (int64_t)n + i] = w[2];
    }
    return queries;
}
