/*
 * hello.c: the whole way in one program: read a tape and a pattern, drape, print the hash of the state.
 *
 *     cc hello.c $(pkg-config --cflags --libs muslin-exchange) -o hello
 *     ./hello w40.tape tshirt.json        prints 16 hex digits
 *     ./hello w40.tape tshirt.json 20     the same with a lattice of 20 mm
 *
 * `muslin dress --pattern tshirt.json --tape w40.tape --report r.json` has the same hash in its report.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"


/* one sentence for what went wrong, and the end */
static void must(mus_context *context, mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "hello: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


int main(int argc, char **argv)
{
    mus_context *context;
    mus_tape *tape;
    mus_pattern *pattern;
    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_cloth_def cut;
    unsigned long long hash;

    if (argc < 3) {
        fprintf(stderr, "usage: hello TAPE PATTERN [SPACING_MM]\n");
        return 2;
    }
    mus_cloth_def_init(&cut, sizeof cut);
    if (argc > 3) cut.spacing = 0.001 * atof(argv[3]);

    /* what is there: a person and a pattern */
    must(NULL, mus_context_create(NULL, &context));
    must(context, mus_tape_read(context, argv[1], NULL, &tape));
    must(context, mus_body_create(context, tape, NULL, &body));
    must(context, mus_pattern_read(context, argv[2], &pattern));

    /* cut it, hang it round the body, sew it, let it come to rest */
    must(context, mus_cloth_create(context, pattern, &cut, &cloth));
    must(context, mus_drape_create(context, cloth, body, NULL, &drape));
    must(context, mus_drape_place(drape));
    must(context, mus_drape_sew(drape, NULL, NULL));
    must(context, mus_drape_settle(drape, NULL, NULL));
    hash = mus_drape_hash(drape);
    printf("%016llx\n", hash);

    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
