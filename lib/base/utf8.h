/*
 * utf8.h: the one check of UTF-8 (RFC 3629), for names at the doors of the library and for texts of files.
 *
 * It is all inline, since the libraries for files and catalogues use it and carry nothing else of lib/base.
 */
#ifndef MUS_BASE_UTF8_H
#define MUS_BASE_UTF8_H

#include <stddef.h>

/* length of the UTF-8 sequence at the start of `text` [bytes], 1..4; 0 if there is none: an overlong form, a surrogate,
 * a code point beyond U+10FFFF, a lone byte. A zero byte is a sequence of 1 */
static inline size_t mus__utf8_length(const char *text)
{
    const unsigned char *byte = (const unsigned char *)text;
    const size_t n = byte[0] < 0x80                      ? 1
                     : byte[0] >= 0xC2 && byte[0] < 0xE0 ? 2
                     : byte[0] >= 0xE0 && byte[0] < 0xF0 ? 3
                     : byte[0] >= 0xF0 && byte[0] < 0xF5 ? 4
                                                         : 0;
    for (size_t i = 1; i < n; i++)
        if ((byte[i] & 0xC0) != 0x80) return 0;
    if (n == 3 && ((byte[0] == 0xE0 && byte[1] < 0xA0) || (byte[0] == 0xED && byte[1] > 0x9F))) return 0;
    if (n == 4 && ((byte[0] == 0xF0 && byte[1] < 0x90) || (byte[0] == 0xF4 && byte[1] > 0x8F))) return 0;
    return n;
}


/* length of the longest start of `text` that is UTF-8 [bytes]: that of the whole text when all is */
static inline size_t mus__utf8_span(const char *text)
{
    size_t at = 0;
    while (text[at] != '\0' && mus__utf8_length(text + at) > 0) at += mus__utf8_length(text + at);
    return at;
}

#endif
