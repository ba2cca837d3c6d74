/*
 * contact_kernel.h: the contact pass, as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_CONTACT).
 *
 * A node nearer than the clearance is put back along the outward normal (by at most `push`), loses its velocity into
 * the skin, and its sliding velocity shrinks by the friction impulse mu |v_n|.
 */

/* one node against one limb it may touch: x, v (3) are corrected in place */
static inline void MUS_FIELD(respond)(MUS_REAL lift, MUS_REAL push, MUS_REAL friction, const MUS_REAL *normal,
                                      MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL move = lift < push ? lift : push;
    for (int32_t i = 0; i < 3; i++) x[i] += move * normal[i];

    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    if (vn >= 0) return;
    MUS_REAL t[3];
    for (int32_t i = 0; i < 3; i++) t[i] = v[i] - vn * normal[i];
    const MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const MUS_REAL loss = -friction * vn;
    const MUS_REAL keep = speed > loss ? (speed - loss) / speed : 0;
    for (int32_t i = 0; i < 3; i++) v[i] = keep * t[i];
}


int64_t MUS_CONTACT(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                    int32_t last, const MUS_REAL *mobile, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL clearance = (MUS_REAL)rule->clearance, friction = (MUS_REAL)rule->friction;
    const MUS_REAL push = (MUS_REAL)rule->push;
    int64_t queries = 0;

    for (int32_t l = 0; l < collider->nlimb; l++) {
        const MUS_FIELD(field) *field = &collider->MUS_FIELDS[l];
        const double *box = collider->box + 6 * l;
        const MUS_REAL lx = (MUS_REAL)box[0] - clearance, ly = (MUS_REAL)box[1] - clearance;
        const MUS_REAL lz = (MUS_REAL)box[2] - clearance, hx = (MUS_REAL)box[3] + clearance;
        const MUS_REAL hy = (MUS_REAL)box[4] + clearance, hz = (MUS_REAL)box[5] + clearance;
        for (int32_t i = first; i < last; i++) {
            MUS_REAL p[3] = {x[i], x[n + i], x[2 * (int64_t)n + i]};
            if (p[0] < lx || p[0] > hx || p[1] < ly || p[1] > hy || p[2] < lz || p[2] > hz || mobile[i] == 0) continue;

            MUS_REAL normal[3];
            int32_t near;
            queries++;
            const MUS_REAL depth = MUS_FIELD(query)(field, p, clearance, normal, &near);
            if (!near || depth <= -clearance) continue;

            MUS_REAL w[3] = {v[i], v[n + i], v[2 * (int64_t)n + i]};
            MUS_FIELD(respond)(depth + clearance, push, friction, normal, p, w);
            x[i] = p[0], x[n + i] = p[1], x[2 * (int64_t)n + i] = p[2];
            v[i] = w[0], v[n + i] = w[1], v[2 * (int64_t)n + i] = w[2];
        }
    }
    return queries;
}
