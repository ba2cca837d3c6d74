/*
 * message.h: error sentences and UTF-8 for the libraries that handle files (libmuslin-exchange and libmuslin-print;
 * each carries a hidden copy).
 */
#ifndef MUS_FILE_MESSAGE_H
#define MUS_FILE_MESSAGE_H

#include <stddef.h>

#include "base/utf8.h"
#include "muslin/base.h"

#if defined(__GNUC__)
#define MUS__FILE_PRINTF(at, from) __attribute__((format(printf, at, from)))
#else
#define MUS__FILE_PRINTF(at, from)
#endif

/* replace each byte of `text` that is not printable UTF-8 by '?' */
void mus__text_make_printable(char *text);
/* make the formatted sentence, printable and at most 511 bytes long, the context's error text; returns `status` */
mus_status mus__file_fail(mus_context *context, mus_status status, const char *format, ...) MUS__FILE_PRINTF(3, 4);

#endif
