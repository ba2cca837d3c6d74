/*
 * drape_self.h: self-contact as a drape uses it (drape_self.c).
 */
#ifndef MUS_DRAPE_DRAPE_SELF_H
#define MUS_DRAPE_DRAPE_SELF_H

#include "drape/drape_state.h"

/* what a drape calls of its self-contact: a table, so that a program without self-contact links none of it */
struct mus__self_ops {
    void (*destroy)(mus__self_contact *self);
    void (*weld)(mus_drape *drape);
    mus_status (*ready)(mus_drape *drape, double h);
    void (*rule)(mus_drape *drape, double h);
};

/* its memory, if the def asks for it; sets drape->self and drape->self_ops. Errors: MUS_ERR_ARG (thickness above half
 * the spacing), MUS_ERR_MEMORY */
mus_status mus__drape_self_create(mus_drape *drape);
/* take the triangles of the open or welded cloth */
static inline void mus__drape_self_weld(mus_drape *drape)
{
    if (drape->self != NULL) drape->self_ops->weld(drape);
}


/* before steps of `h`, with places, masses and the contact rule set: find the pairs; self-contact acts from now on */
static inline mus_status mus__drape_self_ready(mus_drape *drape, double h)
{
    return drape->self != NULL ? drape->self_ops->ready(drape, h) : MUS_OK;
}


/* the rule of steps of `h`, the contact rule being set */
static inline void mus__drape_self_rule(mus_drape *drape, double h)
{
    if (drape->self != NULL) drape->self_ops->rule(drape, h);
}


/* MUS_ERR_LIMIT when a step found more pairs than there is capacity for */
mus_status mus__drape_self_fits(const mus_drape *drape);
/* number of nodes that cannot move: cloth is nearer to them than the numbers of the state can tell apart */
int32_t mus__drape_self_frozen(const mus_drape *drape);
/* adds the mean force [N] that it gave node i since mus__drape_self_forget to `force` (3); nonzero when there was any
 */
int32_t mus__drape_self_force(const mus_drape *drape, int32_t i, double *force);
void mus__drape_self_forget(mus_drape *drape);
/* at a check of settling: make pairs thinner whose nodes stay deep in the body and touch cloth; nonzero when any was */
int32_t mus__drape_self_give_way(mus_drape *drape);
void mus__drape_self_report(const mus_drape *drape, mus_drape_report *report);

#endif
