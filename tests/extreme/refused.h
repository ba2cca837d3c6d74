/*
 * refused.h: numbers that no setter takes, put in each field of a def in turn.
 *
 * The tables of fields name each as "struct.member"; tests/guard/setters.py reads these names and holds them against
 * the public headers, so that a new number without a row here is a fault.
 */
#ifndef MUS_TESTS_REFUSED_H
#define MUS_TESTS_REFUSED_H

#include <math.h>
#include <string.h>

#include "support.h"

typedef struct refused_field {
    const char *name; /* "mus_x_def.member" */
    size_t offset;
    int32_t count;
    bool nan_is_default;
    const char *word; /* that the message must hold */
} refused_field;

#define REFUSED(type, member, count, nan_is_default, word)                                                             \
    {                                                                                                                  \
#type "." #member, offsetof(type, member), count, nan_is_default, word                                         \
    }

static const double refused_values[] = {NAN, INFINITY, -INFINITY};

/* tries a def: the status of the call that takes it; its objects are freed before it returns */
typedef mus_status (*refused_try)(mus_context *context, const void *def, void *user);


/* every field of `def` (a good one, `size` bytes) in turn not finite: refused by name, no byte kept, the next call good
 */
static inline void refused_fields(const refused_field *fields, size_t count, const void *def, size_t size,
                                  refused_try attempt, void *user)
{
    mus_context *context = support_context();
    ck_assert_int_eq(attempt(context, def, user), MUS_OK);
    const size_t bytes = mus_context_bytes(context);
    unsigned char bad[4096];
    ck_assert_uint_le(size, sizeof bad);
    for (size_t f = 0; f < count; f++)
        for (int32_t i = 0; i < fields[f].count; i++)
            for (int32_t v = fields[f].nan_is_default ? 1 : 0; v < 3; v++) {
                memcpy(bad, def, size);
                memcpy(bad + fields[f].offset + (size_t)i * sizeof(double), &refused_values[v], sizeof(double));
                const mus_status status = attempt(context, bad, user);
                const char *text = mus_context_error(context);
                ck_assert_msg(status == MUS_ERR_ARG, "%s[%d] = %g: status %d (%s)", fields[f].name, (int)i,
                              refused_values[v], (int)status, text);
                ck_assert_msg(strstr(text, fields[f].word) != NULL, "%s: \"%s\" has no \"%s\"", fields[f].name, text,
                              fields[f].word);
                ck_assert_uint_eq(mus_context_bytes(context), bytes);
            }
    ck_assert_int_eq(attempt(context, def, user), MUS_OK);
    support_context_end(context);
}

#endif
