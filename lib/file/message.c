/*
 * message.c: error sentences that quote a file or a path. Bytes that are not printable UTF-8 are replaced.
 */
#include "file/message.h"

#include <stdarg.h>
#include <stdio.h>

#define MESSAGE_BYTES 512 /* [bytes] capacity of the context's error text */


size_t mus__utf8_length(const char *text)
{
    const unsigned char *byte = (const unsigned char *)text;
    size_t n = byte[0] < 0x80                      ? 1
               : byte[0] >= 0xC2 && byte[0] < 0xE0 ? 2
               : byte[0] >= 0xE0 && byte[0] < 0xF0 ? 3
               : byte[0] >= 0xF0 && byte[0] < 0xF5 ? 4
                                                   : 0;
    for (size_t i = 1; i < n; i++)
        if ((byte[i] & 0xC0) != 0x80) return 0;

    /* refused: overlong forms, surrogates, code points beyond U+10FFFF */
    if (n == 3 && ((byte[0] == 0xE0 && byte[1] < 0xA0) || (byte[0] == 0xED && byte[1] > 0x9F))) return 0;
    if (n == 4 && ((byte[0] == 0xF0 && byte[1] < 0x90) || (byte[0] == 0xF4 && byte[1] > 0x8F))) return 0;
    return n;
}


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
