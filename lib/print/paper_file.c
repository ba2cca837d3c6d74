/*
 * paper_file.c: bytes that grow in memory and become a file whole or not at all.
 *
 * A file is written beside the wanted one and renamed over it; a failure removes it and leaves the old one as it was.
 * What is no plain file (a pipe, a device) cannot be renamed over and is written to directly; "-" is standard output.
 */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 700 /* stat, realpath */
#endif

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "print/print_internal.h"

#define PART_TRIES 100 /* names for the new file: others may be left by runs that were killed */


void mus__bytes_add(mus__bytes *bytes, const void *data, size_t size)
{
    if (bytes->status != MUS_OK || size == 0) return;
    int64_t need = size < INT32_MAX ? (int64_t)bytes->size + (int64_t)size : INT64_MAX;
    bytes->status = mus__print_reserve(bytes->context, &bytes->data, &bytes->room, need, 1);
    if (bytes->status != MUS_OK) return;
    memcpy(bytes->data + bytes->size, data, size);
    bytes->size += (int32_t)size;
}


void mus__bytes_print(mus__bytes *bytes, const char *format, ...)
{
    char text[1024];
    va_list list;
    va_start(list, format);
    int length = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (length > 0) mus__bytes_add(bytes, text, length < (int)sizeof text ? (size_t)length : sizeof text - 1);
}


static mus_status paper_fail(const mus__bytes *bytes, const char *path, const char *what, int code)
{
    size_t length = strlen(path);
    return mus__print_fail(bytes->context, MUS_ERR_FILE, "%s: cannot be %s: %s",
                           length > 200 ? path + length - 200 : path, what,
                           code != 0 ? strerror(code) : "the system gave no reason");
}


/* all bytes into an open file, down to the system; 0 or what went wrong */
static int paper_write(const mus__bytes *bytes, FILE *file)
{
    errno = 0;
    bool good = fwrite(bytes->data, 1, (size_t)bytes->size, file) == (size_t)bytes->size;
    good = fflush(file) == 0 && good;
    int code = good ? 0 : errno != 0 ? errno : EIO;
    if (file == stdout) return code;
    errno = 0;
    if (fclose(file) != 0 && code == 0) code = errno != 0 ? errno : EIO;
    return code;
}


static mus_status paper_direct(const mus__bytes *bytes, const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdout : fopen(path, "wb");
    if (file == NULL) return paper_fail(bytes, path, "opened", errno);
    int code = paper_write(bytes, file);
    return code == 0 ? MUS_OK : paper_fail(bytes, path, "written", code);
}


/* write beside `path`, then rename */
static mus_status paper_renamed(const mus__bytes *bytes, const char *path)
{
    size_t room = strlen(path) + 16;
    char *part = mus__print_new(bytes->context, (int64_t)room, 1);
    if (part == NULL) return mus__print_memory(bytes->context, "a file name");

    FILE *file = NULL;
    errno = EEXIST;
    for (int i = 0; i < PART_TRIES && file == NULL && errno == EEXIST; i++) {
        snprintf(part, room, "%s.part%d", path, i);
        errno = 0;
        file = fopen(part, "wbx");
    }
    mus_status status = MUS_OK;
    if (file == NULL) {
        status = paper_fail(bytes, path, "opened", errno);
    } else {
        int code = paper_write(bytes, file);
        if (code != 0) status = paper_fail(bytes, path, "written", code);
        else if (rename(part, path) != 0) status = paper_fail(bytes, path, "replaced", errno);
        if (status != MUS_OK) remove(part);
    }
    mus__print_free(bytes->context, part);
    return status;
}


mus_status mus__bytes_save(const mus__bytes *bytes, const char *path)
{
    struct stat info;
    if (strcmp(path, "-") == 0) return paper_direct(bytes, path);
    if (stat(path, &info) != 0) return paper_renamed(bytes, path);
    if (S_ISDIR(info.st_mode)) return paper_fail(bytes, path, "written", EISDIR);
    if (!S_ISREG(info.st_mode)) return paper_direct(bytes, path);

    /* through a link to the file that it names, so that the link stays */
    char *target = realpath(path, NULL);
    mus_status status = paper_renamed(bytes, target != NULL ? target : path);
    free(target);
    return status;
}
