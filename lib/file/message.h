/*
 * message.h: error sentences of the libraries that handle files, and UTF-8 (shared by libmuslin-exchange and
 * libmuslin-print, hidden in both).
 */
#ifndef MUS_FILE_MESSAGE_H
#define MUS_FILE_MESSAGE_H

#include <stddef.h>

#include "muslin/base.h"

#if defined(__GNUC__)
#define MUS__FILE_PRINTF(at, from) __attribute__((format(printf, at, from)))
#else
#define MUS__FILE_PRINTF(at, from)
#endif

/* length of a valid UTF-8 sequence at `text` (1..4), 0 if there is none */
size_t mus__utf8_length(const char *text);
/* replace each byte of `text` that is not printable UTF-8 by '?' */
void mus__text_make_printable(char *text);
/* give the context a printable sentence of at most 511 bytes; returns `status` */
mus_status mus__file_fail(mus_context *context, mus_status status, const char *format, ...) MUS__FILE_PRINTF(3, 4);

#endif
