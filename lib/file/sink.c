/*
 * sink.c: a buffer that a writer fills, and that then becomes a file or an allocation of the caller's.
 *
 * A writer puts all of its output into a sink and gives the sink away once. The bytes are written to a new file beside
 * the wanted one, and the new file is renamed over it. A failure at any point removes the new file and leaves the old
 * one unchanged. Devices and pipes cannot be renamed over and are written directly; "-" is standard output.
 */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 700 /* stat, realpath */
#endif

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "file/sink.h"

#define PART_TRIES 100 /* names tried for the new file; chosen: killed programs may have left a few such files behind */


void mus__sink_init(mus__sink *sink, mus_context *context)
{
    memset(sink, 0, sizeof *sink);
    sink->context = context;
}


void mus__sink_free(mus__sink *sink)
{
    mus_context_alloc(sink->context, sink->bytes, 0);
    sink->bytes = NULL;
}


/* grow the buffer so that `size` more bytes fit; false when there is no memory */
static bool sink_reserve(mus__sink *sink, size_t size)
{
    if (sink->status != MUS_OK) return false;
    if (size <= sink->capacity - sink->size) return true;

    size_t grown = sink->capacity + sink->capacity / 2 + 4096;
    if (grown < sink->size + size) grown = sink->size + size;
    char *bytes = mus_context_alloc(sink->context, sink->bytes, grown);
    if (bytes == NULL) {
        sink->status = mus__file_fail(sink->context, MUS_ERR_MEMORY, "no memory for a file of %zu bytes", grown);
        return false;
    }
    sink->bytes = bytes;
    sink->capacity = grown;
    return true;
}


void mus__sink_add(mus__sink *sink, const void *bytes, size_t size)
{
    if (size == 0 || !sink_reserve(sink, size)) return;
    memcpy(sink->bytes + sink->size, bytes, size);
    sink->size += size;
}


void mus__sink_u32(mus__sink *sink, uint32_t value)
{
    const unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8), (unsigned char)(value >> 16),
                                    (unsigned char)(value >> 24)};
    mus__sink_add(sink, bytes, 4);
}


void mus__sink_f32(mus__sink *sink, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    mus__sink_u32(sink, bits);
}


void mus__sink_print(mus__sink *sink, const char *format, ...)
{
    /* nearly every call prints less than 256 bytes; a longer text is printed a second time, into enough memory */
    if (!sink_reserve(sink, 256)) return;
    const size_t left = sink->capacity - sink->size;
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    int length = vsnprintf(sink->bytes + sink->size, left, format, list);
    va_end(list);
    if (length > 0 && (size_t)length >= left && sink_reserve(sink, (size_t)length + 1))
        vsnprintf(sink->bytes + sink->size, (size_t)length + 1, format, again);
    va_end(again);
    if (length > 0 && sink->status == MUS_OK) sink->size += (size_t)length;
}


void mus__sink_number(mus__sink *sink, double number)
{
    /* jansson takes "-0" for the integer 0 and loses the sign */
    if (number == 0.0 && signbit(number)) {
        mus__sink_add(sink, "-0.0", 4);
        return;
    }
    char text[40];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, number);
        if (strtod(text, NULL) == number) break;
    }
    mus__sink_add(sink, text, strlen(text));
}


void mus__sink_quote(mus__sink *sink, const char *text)
{
    mus__sink_add(sink, "\"", 1);
    for (size_t n; *text != '\0'; text += n) {
        unsigned char byte = (unsigned char)*text;
        n = mus__utf8_length(text);
        if (byte == '"' || byte == '\\')
            mus__sink_print(sink, "\\%c", byte);
        else if (byte < 0x20)
            mus__sink_print(sink, "\\u%04x", byte);
        else
            mus__sink_add(sink, n > 0 ? text : "?", n > 0 ? n : 1);
        if (n == 0) n = 1;
    }
    mus__sink_add(sink, "\"", 1);
}


static mus_status save_fail(const mus__sink *sink, const char *path, const char *what)
{
    int code = errno;
    size_t length = strlen(path);
    return mus__file_fail(sink->context, MUS_ERR_FILE, "%s: cannot be %s: %s",
                          length > 200 ? path + length - 200 : path, what, strerror(code));
}


/* write and flush all bytes to an open file, and close it unless it is standard output; false on failure */
static bool save_bytes(const mus__sink *sink, FILE *file)
{
    errno = 0;
    bool good = fwrite(sink->bytes, 1, sink->size, file) == sink->size;
    good = fflush(file) == 0 && good;
    if (file == stdout) return good;
    int code = errno;
    bool closed = fclose(file) == 0;
    if (!good) errno = code;
    return good && closed;
}


/* open a new file beside `target` and write its name to `temporary`; NULL when none can be opened */
static FILE *open_beside(const char *target, char *temporary, size_t bytes)
{
    for (int i = 0; i < PART_TRIES; i++) {
        snprintf(temporary, bytes, "%s.part%d", target, i);
        errno = 0;
        FILE *file = fopen(temporary, "wbx");
        if (file != NULL || errno != EEXIST) return file;
    }
    return NULL;
}


/* write to a new file beside the target and rename it to the target */
static mus_status save_renamed(const mus__sink *sink, const char *target)
{
    size_t bytes = strlen(target) + 16;
    char *temporary = mus_context_alloc(sink->context, NULL, bytes);
    if (temporary == NULL) return mus__file_fail(sink->context, MUS_ERR_MEMORY, "no memory for a file name");

    mus_status status = MUS_OK;
    FILE *file = open_beside(target, temporary, bytes);
    if (file == NULL) {
        status = save_fail(sink, target, "written");
    } else if (!save_bytes(sink, file) || rename(temporary, target) != 0) {
        status = save_fail(sink, target, "written");
        remove(temporary);
    }
    mus_context_alloc(sink->context, temporary, 0);
    return status;
}


static mus_status save_file(const mus__sink *sink, const char *path)
{
    if (strcmp(path, "-") == 0)
        return save_bytes(sink, stdout) ? MUS_OK : save_fail(sink, "standard output", "written");

    /* no file of this name yet (an empty path fails when it is opened) */
    struct stat info;
    if (stat(path, &info) != 0) return path[0] != '\0' ? save_renamed(sink, path) : save_fail(sink, path, "written");

    /* a device or a pipe */
    if (!S_ISREG(info.st_mode)) {
        errno = 0;
        FILE *file = S_ISDIR(info.st_mode) ? NULL : fopen(path, "wb");
        if (S_ISDIR(info.st_mode)) errno = EISDIR;
        return file != NULL && save_bytes(sink, file) ? MUS_OK : save_fail(sink, path, "written");
    }

    /* an existing file: replace the one that a symbolic link leads to, so that the link stays */
    char *target = realpath(path, NULL);
    if (target == NULL) return save_fail(sink, path, "found");
    mus_status status = save_renamed(sink, target);
    free(target);
    return status;
}


mus_status mus__target_check(mus_context *context, const mus__target *target, const char *what)
{
    if (target->path != NULL) return MUS_OK;
    if (target->bytes != NULL) *target->bytes = NULL;
    if (target->bytes != NULL && target->size != NULL) return MUS_OK;
    return mus__file_fail(context, MUS_ERR_ARG, "%s: a required pointer is NULL", what);
}


mus_status mus__sink_give(mus__sink *sink, const mus__target *target)
{
    if (sink->status != MUS_OK) return sink->status;
    if (target->path != NULL) return save_file(sink, target->path);
    *target->bytes = sink->bytes;
    *target->size = sink->size;
    sink->bytes = NULL;
    sink->size = sink->capacity = 0;
    return MUS_OK;
}
