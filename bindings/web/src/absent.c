/* absent.c: in place of what a module in a browser does not have: readers that need outside libraries, and paths. */
#include <stddef.h>

#include "absent.h"
#include "exchange/tape_readers.h"


char *realpath(const char *path, char *resolved)
{
    (void)path, (void)resolved;
    return NULL;
}


mus_status mus__tape_read_yaml(mus__source *source, mus_tape *tape, mus__unused *unused)
{
    (void)source, (void)tape, (void)unused;
    return MUS_ERR_UNSUPPORTED;
}


mus_status mus__tape_read_vit(mus__source *source, mus_tape *tape, mus__unused *unused)
{
    (void)source, (void)tape, (void)unused;
    return MUS_ERR_UNSUPPORTED;
}
