/*
 * json.c: JSON text in a growing buffer. A file is written beside its name and renamed.
 */
#define _POSIX_C_SOURCE 200809L /* getpid, stat */
#include "json.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "args.h"


static void put(json *j, const char *text, size_t bytes)
{
    if (j->failed) return;
    if (j->length + bytes + 1 > j->capacity) {
        const size_t capacity = 2 * j->capacity + bytes + 256;
        char *bigger = realloc(j->text, capacity);
        if (bigger == NULL) {
            j->failed = true;
            return;
        }
        j->text = bigger;
        j->capacity = capacity;
    }
    memcpy(j->text + j->length, text, bytes);
    j->length += bytes;
    j->text[j->length] = '\0';
}


/* Returns the number of bytes of the UTF-8 character at `c`; 0 when it is invalid (surrogates and overlong forms are)
 */
static size_t character(const unsigned char *c)
{
    const size_t bytes = c[0] < 0x80 ? 1 : c[0] < 0xc2 ? 0 : c[0] < 0xe0 ? 2 : c[0] < 0xf0 ? 3 : c[0] < 0xf5 ? 4 : 0;
    for (size_t i = 1; i < bytes; i++)
        if ((c[i] & 0xc0) != 0x80) return 0;
    const bool beyond = (c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] > 0x9f) ||
                        (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] > 0x8f);
    return beyond ? 0 : bytes;
}


/* Bytes that are not valid UTF-8 are replaced, since a JSON text must not have them. */
static void put_string(json *j, const char *value)
{
    put(j, "\"", 1);
    for (const unsigned char *c = (const unsigned char *)value; *c != '\0';) {
        const size_t bytes = character(c);
        char escape[8];
        if (bytes == 0)
            snprintf(escape, sizeof escape, "\\ufffd");
        else if (*c == '"' || *c == '\\')
            snprintf(escape, sizeof escape, "\\%c", *c);
        else if (*c < 0x20)
            snprintf(escape, sizeof escape, "\\u%04x", *c);
        else
            snprintf(escape, sizeof escape, "%.*s", (int)bytes, (const char *)c);
        put(j, escape, strlen(escape));
        c += bytes == 0 ? 1 : bytes;
    }
    put(j, "\"", 1);
}


/* Writes the comma before the next member, and its key. */
static void begin(json *j, const char *key)
{
    if (j->comma) put(j, ", ", 2);
    j->comma = true;
    if (key == NULL) return;
    put_string(j, key);
    put(j, ": ", 2);
}


void json_open(json *j, const char *key, char bracket)
{
    begin(j, key);
    put(j, &bracket, 1);
    j->comma = false;
}


void json_close(json *j, char bracket)
{
    put(j, &bracket, 1);
    j->comma = true;
}


void json_text(json *j, const char *key, const char *value)
{
    begin(j, key);
    put_string(j, value);
}


void json_int(json *j, const char *key, int64_t value)
{
    char text[32];
    begin(j, key);
    snprintf(text, sizeof text, "%lld", (long long)value);
    put(j, text, strlen(text));
}


void json_bool(json *j, const char *key, bool value)
{
    begin(j, key);
    put(j, value ? "true" : "false", value ? 4 : 5);
}


void json_null(json *j, const char *key)
{
    begin(j, key);
    put(j, "null", 4);
}


void json_number(json *j, const char *key, double value)
{
    char text[40];
    if (!isfinite(value)) {
        json_null(j, key);
        return;
    }
    begin(j, key);
    snprintf(text, sizeof text, "%.9g", value);
    put(j, text, strlen(text));
}


void json_warnings(json *j)
{
    const complaints *said = complaints_said();
    json_open(j, "warnings", '[');
    for (int32_t i = 0; i < said->doubts; i++) json_text(j, NULL, said->doubt[i]);
    json_close(j, ']');
}


void json_free(json *j)
{
    free(j->text);
    memset(j, 0, sizeof *j);
}


static bool put_all(const json *j, FILE *file)
{
    return fwrite(j->text, 1, j->length, file) == j->length && fputc('\n', file) != EOF;
}


bool json_write(const json *j, const char *command, const char *path)
{
    if (j->failed) return complain(EXIT_FAILED, command, "no memory for %s", path) == EXIT_DONE;
    if (is_stdout(path)) {
        if (put_all(j, stdout) && fflush(stdout) == 0) return true;
        return complain(EXIT_FAILED, command, "standard output: cannot be written: %s", strerror(errno)) == EXIT_DONE;
    }

    /* a device or a pipe is written directly; a file is written beside its name and renamed */
    char name[4096];
    struct stat there;
    const bool direct = stat(path, &there) == 0 && !S_ISREG(there.st_mode);
    const int length = direct ? snprintf(name, sizeof name, "%s", path)
                              : snprintf(name, sizeof name, "%s.%ld.part", path, (long)getpid());
    if (length >= (int)sizeof name)
        return complain(EXIT_FAILED, command, "%.60s...: the name is too long", path) == EXIT_DONE;
    FILE *file = fopen(name, direct ? "wb" : "wbx");
    bool done = file != NULL && put_all(j, file) && fflush(file) == 0;
    int reason = errno;
    if (file != NULL && fclose(file) != 0 && done) done = false, reason = errno;
    if (done && !direct && rename(name, path) != 0) done = false, reason = errno;
    if (done) return true;
    if (!direct && file != NULL) remove(name);
    return complain(EXIT_FAILED, command, "%s: cannot be written: %s", path, strerror(reason)) == EXIT_DONE;
}
