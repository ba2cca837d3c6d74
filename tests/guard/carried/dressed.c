/* dressed.c: a T-shirt drafted, cut, sewn and brought to rest on a body. */
#include <muslin/muslin.h>

int main(void)
{
    mus_context *context = NULL;
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_pattern *pattern = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.03;
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    if (status == MUS_OK) status = mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern);
    if (status == MUS_OK) status = mus_cloth_create(context, pattern, &cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(context, cloth, body, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_settle(drape, NULL, NULL);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return status;
}
