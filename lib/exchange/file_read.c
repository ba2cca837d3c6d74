/*
 * file_read.c: load a file into memory; make messages with file and line; read numbers independent of the locale.
 *
 * A reader gets the text in one allocation with a zero byte behind it, so a pointer can walk it without reading past
 * the end. Regular files alone are read. The allocation grows while the file is read, since a file of /proc tells no
 * length.
 */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 700 /* newlocale, uselocale */
#endif

#include <errno.h>
#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "exchange/file_read.h"

#define LIST_LONGEST (1 << 24) /* most elements of any list; chosen: bounds it to 1 GB, entities and points have less */

#define FILE_NAME_BYTES 200  /* [bytes] of a path in a message; chosen: leaves 311 of 511 bytes for the sentence */
#define FILE_ERROR_BYTES 512 /* [bytes] capacity of the context's error text */
#define NUMBER_BYTES 64      /* [bytes] of a number with its zero byte; chosen: 17 digits are exact */


mus_status mus__source_fail(const mus__source *source, int64_t line, mus_status status, const char *format, ...)
{
    char text[FILE_ERROR_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (line > 0)
        return mus__file_fail(source->context, status, "%s:%lld: %s", source->name, (long long)line, text);
    return mus__file_fail(source->context, status, "%s: %s", source->name, text);
}


mus_status mus__source_wrap(const mus__source *source, int64_t line, mus_status status)
{
    char text[FILE_ERROR_BYTES];
    snprintf(text, sizeof text, "%s", mus_context_error(source->context));
    return mus__source_fail(source, line, status == MUS_ERR_ARG ? MUS_ERR_FORMAT : status, "%s", text);
}


/* read all of `file` into an allocation that grows by half */
static mus_status source_load(mus__source *source, FILE *file)
{
    size_t capacity = 0;
    for (;;) {
        /* one byte stays free for the zero byte at the end */
        if (source->size + 1 >= capacity) {
            size_t grown = capacity + capacity / 2 + 16384;
            char *text = mus_context_alloc(source->context, source->text, grown);
            if (text == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for %zu bytes", grown);
            source->text = text;
            capacity = grown;
        }
        size_t got = fread(source->text + source->size, 1, capacity - source->size - 1, file);
        source->size += got;
        if (source->size > MUS__FILE_BYTES_MAX)
            return mus__source_fail(source, 0, MUS_ERR_LIMIT, "the file is above the limit of %zu bytes",
                                    MUS__FILE_BYTES_MAX);
        if (got == 0) break;
    }
    if (ferror(file)) return mus__source_fail(source, 0, MUS_ERR_FILE, "cannot be read: %s", strerror(errno));
    source->text[source->size] = '\0';
    return MUS_OK;
}


/* copy a text into an allocation of the source, with a zero byte behind it */
static mus_status source_copy(mus__source *source, const char *text, size_t size)
{
    if (size > MUS__FILE_BYTES_MAX)
        return mus__source_fail(source, 0, MUS_ERR_LIMIT, "%zu bytes are above the limit of %zu", size,
                                MUS__FILE_BYTES_MAX);
    source->text = mus_context_alloc(source->context, NULL, size + 1);
    if (source->text == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for %zu bytes", size + 1);
    memcpy(source->text, text, size);
    source->text[size] = '\0';
    source->size = size;
    return MUS_OK;
}


static mus_status source_read(mus__source *source, const char *path)
{
    /* opening a pipe waits for a writer, perhaps for ever; a device may have no end */
    struct stat info;
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode))
        return mus__source_fail(source, 0, MUS_ERR_FILE, "is no regular file, but a %s",
                                S_ISDIR(info.st_mode) ? "folder" : S_ISFIFO(info.st_mode) ? "pipe" : "device");
    errno = 0;
    FILE *file = fopen(path, "rb");
    if (file == NULL) return mus__source_fail(source, 0, MUS_ERR_FILE, "cannot be opened: %s", strerror(errno));
    const mus_status status = source_load(source, file);
    fclose(file);
    return status;
}


mus_status mus__input_check(mus_context *context, const mus__input *input, const void *out, const char *what)
{
    if (input->path != NULL && out != NULL) return MUS_OK;
    return mus__file_fail(context, MUS_ERR_ARG, "%s: a required pointer is NULL", what);
}


mus_status mus__locale_enter(mus_context *context, mus__locale *locale)
{
    locale_t own = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (own == (locale_t)0) return mus__file_fail(context, MUS_ERR_MEMORY, "no memory for a locale");
    locale->own = (void *)own;
    locale->before = (void *)uselocale(own);
    return MUS_OK;
}


void mus__locale_leave(mus__locale *locale)
{
    if (locale->own == NULL) return;
    uselocale((locale_t)locale->before);
    freelocale((locale_t)locale->own);
    locale->own = NULL;
}


mus_status mus__source_open(mus_context *context, const mus__input *input, mus__source *out)
{
    memset(out, 0, sizeof *out);
    const size_t length = strlen(input->path);
    out->context = context;
    out->path = input->path;
    out->name = length > FILE_NAME_BYTES ? input->path + length - FILE_NAME_BYTES : input->path;
    mus_status status = mus__locale_enter(context, &out->locale);
    if (status == MUS_OK)
        status = input->text != NULL ? source_copy(out, input->text, input->size) : source_read(out, input->path);
    if (status != MUS_OK) {
        mus__source_close(out);
        return status;
    }

    /* drop a UTF-8 byte order mark */
    if (out->size >= 3 && memcmp(out->text, "\xEF\xBB\xBF", 3) == 0) {
        out->size -= 3;
        memmove(out->text, out->text + 3, out->size + 1);
    }
    return MUS_OK;
}


void mus__source_close(mus__source *source)
{
    mus_context_alloc(source->context, source->text, 0);
    source->text = NULL;
    source->size = 0;
    mus__locale_leave(&source->locale);
}


mus_status mus__source_reserve(const mus__source *source, void *array, int32_t *room, int64_t need, size_t size)
{
    if (need <= *room) return MUS_OK;
    int64_t grown = (int64_t)*room + *room / 2 + 64;
    grown = grown < need ? need : grown;
    if (grown > LIST_LONGEST)
        return mus__source_fail(source, 0, MUS_ERR_LIMIT, "a list of more than %d elements; expected a pattern",
                                (int)LIST_LONGEST);
    void *old;
    memcpy(&old, array, sizeof old);
    void *bigger = mus_context_alloc(source->context, old, (size_t)grown * size);
    if (bigger == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for %lld elements",
                                                (long long)grown);
    memcpy(array, &bigger, sizeof bigger);
    *room = (int32_t)grown;
    return MUS_OK;
}


void mus__source_base(const char *path, const char *const *endings, char *out, size_t bytes)
{
    const char *base = strrchr(path, '/');
    base = base != NULL ? base + 1 : path;
    size_t length = strlen(base);
    for (; *endings != NULL; endings++) {
        size_t n = strlen(*endings);
        if (length > n && strcmp(base + length - n, *endings) == 0) {
            length -= n;
            break;
        }
    }

    /* copy whole, printable characters only */
    size_t used = 0;
    while (used < length) {
        size_t n = mus__utf8_length(base + used);
        if (n == 0 || used + n >= bytes) break;
        used += n;
    }
    memcpy(out, base, used);
    out[used] = '\0';
}


void mus__panel_name_free(const mus_pattern *pattern, char *name, size_t capacity)
{
    size_t n = strlen(name);
    if (n > capacity - 16) n = mus__utf8_span(name) < capacity - 16 ? n : capacity - 16;
    while (n > 0 && (name[n] & 0xc0) == 0x80) n--;
    for (int32_t i = 2; mus_pattern_find_panel(pattern, name) != MUS_NONE; i++)
        snprintf(name + n, capacity - n, "_%d", (int)i);
}


void mus__unused_add(mus__unused *unused, const char *name)
{
    size_t length = strlen(unused->names);
    unused->count++;
    if (length + strlen(name) + 3 > sizeof unused->names) return;
    snprintf(unused->names + length, sizeof unused->names - length, "%s%s", length > 0 ? ", " : "", name);
    unused->listed++;
}


void mus__unused_log(const mus__unused *unused, const mus__source *source)
{
    if (unused->count == 0) return;
    char text[FILE_ERROR_BYTES + 128];
    if (unused->listed < unused->count)
        snprintf(text, sizeof text, "%s: not used: %s and %d more", source->name, unused->names,
                 (int)(unused->count - unused->listed));
    else
        snprintf(text, sizeof text, "%s: not used: %s", source->name, unused->names);
    mus__text_make_printable(text);
    mus_context_log(source->context, MUS_LOG_INFO, text);
}


mus_status mus__unused_fail(const mus__unused *unused, const mus__source *source)
{
    return mus__source_fail(source, 0, MUS_ERR_FORMAT, "no measure that muslin knows was found%s%s%s",
                            unused->count > 0 ? "; there are " : "", unused->names,
                            unused->listed < unused->count ? " and more" : "");
}


size_t mus__number_span(const char *text)
{
    const char *at = text;
    if (*at == '+' || *at == '-') at++;
    size_t before = strspn(at, "0123456789");
    at += before;
    size_t after = *at == '.' ? strspn(at + 1, "0123456789") : 0;
    if (before + after == 0) return 0;
    if (*at == '.') at += 1 + after;

    /* an exponent without digits is not part of the number */
    if (*at == 'e' || *at == 'E') {
        const char *digits = at + 1;
        if (*digits == '+' || *digits == '-') digits++;
        size_t n = strspn(digits, "0123456789");
        if (n > 0) at = digits + n;
    }
    return (size_t)(at - text);
}


/* length of a fraction such as "1/4" or "¼" at the start of a text [bytes], with its value; 0 when there is none */
static size_t fraction_span(const char *text, double *out)
{
    static const char *const digits = "0123456789";
    static const char *const signs[] = {"⅛", "¼", "⅜", "½", "⅝", "¾", "⅞"};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        *out = 0.125 * (double)(i + 1);
        if (strncmp(text, signs[i], strlen(signs[i])) == 0) return strlen(signs[i]);
    }
    const size_t above = strspn(text, digits), below = text[above] == '/' ? strspn(text + above + 1, digits) : 0;
    if (above == 0 || below == 0) return 0;
    *out = strtod(text, NULL) / strtod(text + above + 1, NULL);
    return above + 1 + below;
}


/* length of the comma and the digits behind it, after `whole` digits at `text` [bytes]; 0 with the fault as a text */
static size_t comma_span(const char *text, size_t whole, const char **fault)
{
    const size_t after = strspn(text + whole + 1, "0123456789");
    const char stop = text[whole + 1 + after];
    if (strspn(text, "0123456789") < whole || after == 0 || stop == ',' || stop == '.')
        *fault = "has a comma that is no decimal comma; write the decimal point as \".\"";
    else if (after == 3 && text[0] != '0')
        *fault = "has a comma that may be one of thousands; write the decimal point as \".\"";
    return *fault == NULL ? 1 + after : 0;
}


const char *mus__amount_read(const char *text, double *out, size_t *length)
{
    char number[NUMBER_BYTES] = "0";
    const char *fault = NULL;
    double part;
    size_t fraction = fraction_span(text, &part), span = fraction > 0 ? 0 : mus__number_span(text), comma = 0;
    if (span + fraction == 0) return "is not a number";
    if (span > 0 && text[span] == ',') {
        comma = comma_span(text, span, &fault);
    } else if (span > 0 && strspn(text, "0123456789") == span) {
        /* "41 1/4" and "41-1/4" */
        const size_t gap = text[span] == '-' ? 1 : strspn(text + span, " \t");
        fraction = fraction_span(text + span + gap, &part);
        if (fraction > 0) fraction += gap;
    }
    if (fault != NULL) return fault;
    if (span + comma >= sizeof number) return "has too many digits";
    if (fraction > 0 && !(part > 0.0 && part < 1.0)) return "has a fraction that is not between 0 and 1";

    memcpy(number, text, span + comma);
    if (span > 0) number[span + comma] = '\0';
    if (comma > 0) number[span] = '.';
    *out = strtod(number, NULL) + (fraction > 0 ? part : 0.0);
    *length = span + comma + fraction;
    return *out - *out != 0.0 ? "is too large" : NULL;
}


const char *mus__number_read(const char *text, double *out)
{
    const char *blanks = " \t\r\n";
    double value = 0.0;
    size_t length = 0;
    text += strspn(text, blanks);
    const char *fault = mus__amount_read(text, &value, &length);
    if (fault != NULL) return fault;
    if (text[length + strspn(text + length, blanks)] != '\0') return "has more than a number";
    *out = value;
    return NULL;
}


/* Levenshtein distance of two names below 40 bytes, one row of the table at a time */
static int32_t name_distance(const char *a, const char *b)
{
    int32_t row[41];
    size_t m = strlen(a), n = strlen(b);
    if (m > 40 || n > 40) return 99;
    for (size_t j = 0; j <= n; j++) row[j] = (int32_t)j;
    for (size_t i = 1; i <= m; i++) {
        int32_t corner = row[0];
        row[0] = (int32_t)i;
        for (size_t j = 1; j <= n; j++) {
            int32_t change = corner + (a[i - 1] != b[j - 1]);
            corner = row[j];
            if (row[j] + 1 < change) change = row[j] + 1;
            if (row[j - 1] + 1 < change) change = row[j - 1] + 1;
            row[j] = change;
        }
    }
    return row[n];
}


const char *mus__measure_nearest(const char *name)
{
    /* accept up to a third of the letters wrong, and 2 in a short word; chosen */
    int32_t limit = (int32_t)(strlen(name) / 3);
    int32_t best = limit < 2 ? 3 : limit + 1;
    const char *nearest = NULL;
    for (int32_t i = 0; i < mus_measure_count(); i++) {
        int32_t distance = name_distance(name, mus_measure_name(i));
        if (distance >= best) continue;
        best = distance;
        nearest = mus_measure_name(i);
    }
    return nearest;
}
