/* written.h: the manifold of a body, written as OBJ, read back and measured on the file alone. */
#ifndef MUS_TESTS_MANIFOLD_WRITTEN_H
#define MUS_TESTS_MANIFOLD_WRITTEN_H

#include "closed.h"
#include "muslin/manifold.h"

typedef struct written {
    closed_report file;
    int32_t vertices, triangles, cuts;
    double spent;    /* CPU time of making it, all threads [s] */
    double girth;    /* largest difference between a girth of the tape that was given, and that of the file [m] */
    char measure[32]; /* the measure of that girth */
} written;

/* make, write to `path`, read and check; girths are of a body in the rest pose. false: the context has the sentence, or
 * the file cannot be read */
bool written_manifold(mus_context *context, const mus_body *body, const mus_manifold_def *def, const char *path,
                      bool girths, written *out);

#endif
