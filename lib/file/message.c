/*
 * message.c: error sentences that quote a file or a path. Bytes that are not printable UTF-8 are replaced.
 */
#include "file/message.h"

#include <stdarg.h>
#include <stdio.h>

#define MESSAGE_BYTES 512 /* [bytes] capacity of the context's error text */


void mus__text_make_printable(char *text)
{
    for (char *at = text; *at != '\0';) {
        size_t n = mus__utf8_length(at);
        if (n == 0 || (n == 1 && ((unsigned char)*at < 0x20 || *at == 0x7F))) *at = '?', n = 1;
        at += n;
    }
}


mus_status mus__file_fail(mus_context *context, mus_status status, const char *format, ...)
{
    char text[MESSAGE_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    mus__text_make_printable(text);
    return mus_context_fail(context, status, text);
}
