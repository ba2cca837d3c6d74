/*
 * verify.h: muslin verify from the inside: rows of exact against got, and one function a family of cases.
 *
 * A case asks verify_wants() for its id first, computes by the public API only, and adds its rows. The error of a row
 * is |got - exact| / |exact|, and |got| where exact is 0: a case that means an absolute error gives the difference as
 * `got` and 0 as `exact`, with its unit in the words of `quantity`. It passes when the error is at most `tolerance`.
 */
#ifndef VERIFY_H
#define VERIFY_H

#include <stdbool.h>
#include <stdint.h>

#include "command/json.h"
#include "muslin/muslin.h"

#define VERIFY_ONLY 64

typedef enum verify_form { VERIFY_TABLE, VERIFY_CSV, VERIFY_JSON } verify_form;

typedef struct verify {
    mus_context *context;
    verify_form form;
    bool all;                      /* long cases too */
    int32_t only_count;            /* of the ids asked for; 0: every case */
    const char *only[VERIFY_ONLY]; /* "I3", or "I" for all of its family */
    bool met[VERIFY_ONLY];         /* a case of that name asked */
    int32_t rows, failed, known; /* known: rows of a model that is wrong there, as expected */
    json j;
} verify;

/* Is this case to be run? A long one takes more than two seconds, and runs with --all or when it is asked for by id. */
bool verify_wants(verify *v, const char *id);
bool verify_wants_long(verify *v, const char *id);

/* One row. */
void verify_add(verify *v, const char *id, const char *quantity, double exact, double got, double tolerance);

/* A row of a model that is known to be wrong there: `exact` is the right value, and the row passes when the error is at
 * least `least`. It says "known" in the table. */
void verify_add_negative(verify *v, const char *id, const char *quantity, double exact, double got, double least);

/* A case that could not be run: a row that fails, and the context's sentence on standard error. */
void verify_broken(verify *v, const char *id, const char *quantity, mus_status status);

/* The families of cases. Each returns an exit code, which is EXIT_DONE also when rows fail. */
int verify_step(verify *v);
int verify_motion(verify *v);
int verify_energy(verify *v);
int verify_force(verify *v);
int verify_cloth(verify *v);
int verify_bend(verify *v);
int verify_drape(verify *v);
int verify_contact(verify *v);
int verify_collide(verify *v);
int verify_plane(verify *v);
int verify_spline(verify *v);
int verify_body(verify *v);

#endif
