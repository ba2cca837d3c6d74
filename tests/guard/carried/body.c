/* body.c: a body from a tape. */
#include <muslin/muslin.h>

int main(void)
{
    mus_context *context = NULL;
    mus_tape *tape = NULL;
    mus_body *body = NULL;
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
    if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return status;
}
