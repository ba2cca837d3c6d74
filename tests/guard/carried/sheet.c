/* sheet.c: a sheet of cloth, pinned at one corner, stepped for a moment: the least that a drape is good for. */
#include <muslin/muslin.h>

int main(void)
{
    mus_context *context = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    const double cell[2] = {0.01, 0.01};
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) status = mus_cloth_create_grid(context, 20, 20, cell, NULL, &cloth);
    if (status == MUS_OK) status = mus_drape_create_plain(context, cloth, NULL, &drape);
    if (status == MUS_OK) status = mus_drape_pin(drape, 0, 1);
    if (status == MUS_OK) status = mus_drape_step(drape, 10, 0.0);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_context_destroy(context);
    return status;
}
