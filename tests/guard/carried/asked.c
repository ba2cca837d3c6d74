/* asked.c: a catalogue asked for the patterns that are sewn as one that it has. */
#include <muslin/catalogue.h>
#include <muslin/exchange.h>
#include <muslin/muslin.h>

int main(int argc, char **argv)
{
    mus_context *context = NULL;
    mus_pattern *pattern = NULL;
    mus_catalogue *catalogue = NULL;
    int32_t ids[16], count = 0;
    if (argc < 3) return 2;
    mus_status status = mus_context_create(NULL, &context);
    if (status == MUS_OK) status = mus_pattern_read(context, argv[1], &pattern);
    if (status == MUS_OK) status = mus_catalogue_open(context, argv[2], MUS_CATALOGUE_READ, &catalogue);
    if (status == MUS_OK) status = mus_catalogue_exact(catalogue, pattern, ids, 16, &count);
    mus_catalogue_destroy(catalogue);
    mus_pattern_destroy(pattern);
    mus_context_destroy(context);
    return status;
}
