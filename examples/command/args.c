/*
 * args.c: reads the options of a subcommand.
 *
 * Whether output files can be written is checked before the work begins: a drape of a minute should not fail at its end
 * because a folder does not exist.
 */
#define _POSIX_C_SOURCE 200809L /* access, stat */
#include "args.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>


#define PRINTED_BYTES 8192 /* of a line for people: two paths and a sentence */


/* receives complaints in place of standard error; NULL: standard error. One for the process, as standard error is */
static complaints *kept;
/* the doubts that were printed */
static complaints printed;


void complaints_keep(complaints *into)
{
    kept = into;
    if (into != NULL) memset(into, 0, sizeof *into);
}


void print_shown(FILE *file, const char *text)
{
    for (const unsigned char *at = (const unsigned char *)text; *at != '\0'; at++) {
        const bool c1 = at[0] == 0xC2 && at[1] >= 0x80 && at[1] < 0xA0;
        if (*at < 0x20 || *at == 0x7F || c1)
            fprintf(file, "\\x%02x", *at);
        else
            fputc(*at, file);
        if (c1) fprintf(file, "\\x%02x", *++at);
    }
}


void print_line(const char *format, ...)
{
    char text[PRINTED_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    print_shown(stdout, text);
    putchar('\n');
}


int complain(int code, const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    if (kept == NULL) {
        char text[PRINTED_BYTES];
        vsnprintf(text, sizeof text, format, list);
        fprintf(stderr, "muslin %s: ", command);
        print_shown(stderr, text);
        fputc('\n', stderr);
    } else if (kept->text[0] == '\0') {
        vsnprintf(kept->text, sizeof kept->text, format, list);
    }
    va_end(list);
    return code;
}


void doubt(const char *command, const char *text)
{
    complaints *into = kept != NULL ? kept : &printed;
    if (kept == NULL) {
        fprintf(stderr, "muslin %s: warning: ", command);
        print_shown(stderr, text);
        fputc('\n', stderr);
    }
    if (into->doubts < (int32_t)(sizeof into->doubt / sizeof *into->doubt))
        snprintf(into->doubt[into->doubts++], sizeof *into->doubt, "%s", text);
}


const complaints *complaints_said(void)
{
    return kept != NULL ? kept : &printed;
}


bool number_read(const char *text, double *out)
{
    /* the command never calls setlocale(), so strtod() expects "." */
    char *end;
    if (text[strspn(text, "+-.0123456789eE")] != '\0') return false;
    *out = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*out);
}


int output_end(const char *command)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return EXIT_DONE;
    return complain(EXIT_FAILED, command, "standard output: cannot be written");
}


static void print_help(const char *command, const char *summary, const option *options)
{
    printf("usage: muslin %s", command);
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind == OPTION_PLAIN || o->kind == OPTION_REST) printf(" %s", o->name);
    printf(" [options]\n\n%s\n\n", summary);
    for (const option *o = options; o->name != NULL; o++) printf("  %-14s %s\n", o->name, o->help);
    printf("  %-14s %s\n", "--help", "this text");
}


static const option *find_option(const option *options, const char *name)
{
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind != OPTION_PLAIN && o->kind != OPTION_REST && strcmp(o->name, name) == 0) return o;
    return NULL;
}


/* Returns the first plain argument that has no value yet, or that of all that are left. */
static const option *next_plain(const option *options)
{
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind == OPTION_REST || (o->kind == OPTION_PLAIN && *(const char **)o->value == NULL)) return o;
    return NULL;
}


/* Writes a complaint and returns false from the calling function's expression. */
#define REFUSE(...) (complain(EXIT_INPUT, __VA_ARGS__), false)


/* Stores the value of one option; returns false, with a complaint, when the text is no such value. */
static bool take_value(const char *command, const option *o, const char *text)
{
    if (o->kind == OPTION_LIST || o->kind == OPTION_REST) {
        texts *list = o->value;
        if (list->count == (int32_t)(sizeof list->at / sizeof list->at[0]))
            return REFUSE(command, "%s: more than %d are given", o->name, (int)list->count);
        list->at[list->count++] = text;
        return true;
    }
    if (o->kind == OPTION_NUMBER || o->kind == OPTION_WHOLE) {
        double value;
        const bool whole = o->kind == OPTION_WHOLE;
        if (!number_read(text, &value) || value < o->low || value > o->high || (whole && floor(value) != value))
            return REFUSE(command, "%s %s: expected a %snumber from %g to %g", o->name, text, whole ? "whole " : "",
                          o->low, o->high);
        *(double *)o->value = value;
        return true;
    }
    *(const char **)o->value = text;
    return true;
}


bool is_stdout(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}


bool output_check(const char *command, const char *path)
{
    /* the folder must be writable: the file is written beside its name and renamed */
    char folder[4096];
    struct stat there;
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    if (is_stdout(path)) return true;
    if (path[0] == '\0') return REFUSE(command, "the name of an output is empty");
    if (strlen(path) >= sizeof folder - 64) return REFUSE(command, "%.60s...: the name is too long", path);
    if (stat(path, &there) == 0 && S_ISDIR(there.st_mode))
        return REFUSE(command, "%s: cannot be written: a folder", path);
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)) return true;
    memcpy(folder, length == 0 ? "." : path, length == 0 ? 1 : length);
    folder[length == 0 ? 1 : length] = '\0';
    if (access(folder, W_OK) != 0) return REFUSE(command, "%s: cannot be written: %s", path, strerror(errno));
    return true;
}


/* Whether two outputs would be one file: the second would take the place of the first. A device takes both. */
static bool is_same_file(const char *a, const char *b)
{
    struct stat one, two;
    const bool there = stat(a, &one) == 0, both = there && stat(b, &two) == 0;
    if (there && !S_ISREG(one.st_mode)) return false;
    return strcmp(a, b) == 0 || (both && one.st_dev == two.st_dev && one.st_ino == two.st_ino);
}


/* Checks that every output can be written, each in a file of its own, and that at most one goes to standard output. */
static bool check_outputs(const char *command, const option *options)
{
    const option *first = NULL;
    for (const option *o = options; o->name != NULL; o++) {
        if (o->kind != OPTION_OUTPUT && o->kind != OPTION_STDOUT) continue;
        const char *path = o->kind == OPTION_OUTPUT ? *(const char **)o->value : NULL;
        if (path != NULL && !output_check(command, path)) return false;
        for (const option *p = options; path != NULL && !is_stdout(path) && p < o; p++) {
            const char *other = p->kind == OPTION_OUTPUT ? *(const char **)p->value : NULL;
            if (other != NULL && !is_stdout(other) && is_same_file(other, path))
                return REFUSE(command, "%s and %s both write to %s", p->name, o->name, path);
        }
        if (o->kind == OPTION_OUTPUT ? !is_stdout(path) : !*(bool *)o->value) continue;
        if (first != NULL) return REFUSE(command, "%s and %s both write to standard output", first->name, o->name);
        first = o;
    }
    return true;
}


bool args_read(const char *command, const char *summary, const option *options, int argc, char **argv)
{
    uint64_t seen = 0;
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--help") != 0 && strcmp(argv[i], "-h") != 0) continue;
        print_help(command, summary, options);
        exit(output_end(command));
    }
    for (int i = 0; i < argc; i++) {
        const option *o = find_option(options, argv[i]);
        if (o == NULL && argv[i][0] == '-' && argv[i][1] != '\0')
            return REFUSE(command, "option %s is unknown; see muslin %s --help", argv[i], command);
        if (o == NULL) {
            o = next_plain(options);
            if (o == NULL) return REFUSE(command, "\"%s\" is one argument too many", argv[i]);
            if (!take_value(command, o, argv[i])) return false;
            continue;
        }
        if (o->kind != OPTION_LIST && (seen >> (o - options) & 1)) return REFUSE(command, "%s is given twice", argv[i]);
        seen |= UINT64_C(1) << (o - options);
        if (o->kind == OPTION_FLAG || o->kind == OPTION_STDOUT) {
            *(bool *)o->value = true;
            continue;
        }
        if (i + 1 == argc) return REFUSE(command, "%s needs a value", argv[i]);
        if (!take_value(command, o, argv[++i])) return false;
    }
    return check_outputs(command, options);
}
