/*
 * args.c: options of a subcommand.
 */
#include "args.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>


int complain(int code, const char *command, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(stderr, "muslin %s: ", command);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
    return code;
}


bool number_read(const char *text, double *out)
{
    /* the command never calls setlocale: the decimal point is a point */
    char *end;
    if (text[strspn(text, "+-.0123456789eE")] != '\0') return false;
    *out = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*out);
}


static void print_help(const char *command, const char *summary, const option *options)
{
    printf("usage: muslin %s", command);
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind == OPTION_PLAIN) printf(" %s", o->name);
    printf(" [options]\n\n%s\n\n", summary);
    for (const option *o = options; o->name != NULL; o++) printf("  %-14s %s\n", o->name, o->help);
    printf("  %-14s %s\n", "--help", "this text");
}


static const option *find_option(const option *options, const char *name)
{
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind != OPTION_PLAIN && strcmp(o->name, name) == 0) return o;
    return NULL;
}


/* the first plain argument that has no value yet */
static const option *next_plain(const option *options)
{
    for (const option *o = options; o->name != NULL; o++)
        if (o->kind == OPTION_PLAIN && *(const char **)o->value == NULL) return o;
    return NULL;
}


/* complain, and say false */
#define REFUSE(...) (complain(EXIT_INPUT, __VA_ARGS__), false)


/* give one option its value; false and a line when it does not fit */
static bool take_value(const char *command, const option *o, const char *text)
{
    if (o->kind == OPTION_LIST) {
        texts *list = o->value;
        if (list->count == (int32_t)(sizeof list->at / sizeof list->at[0]))
            return REFUSE(command, "%s: more than %d are given", o->name, (int)list->count);
        list->at[list->count++] = text;
        return true;
    }
    if (o->kind == OPTION_NUMBER) {
        double value;
        if (!number_read(text, &value) || value < o->low || value > o->high)
            return REFUSE(command, "%s %s: expected a number from %g to %g", o->name, text, o->low, o->high);
        *(double *)o->value = value;
        return true;
    }
    const char **slot = o->value;
    if (*slot != NULL) return REFUSE(command, "%s is given twice", o->name);
    *slot = text;
    return true;
}


bool args_read(const char *command, const char *summary, const option *options, int argc, char **argv)
{
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help(command, summary, options);
            exit(EXIT_DONE);
        }
        const option *o = find_option(options, argv[i]);
        if (o == NULL && argv[i][0] == '-' && argv[i][1] != '\0')
            return REFUSE(command, "option %s is unknown; see muslin %s --help", argv[i], command);
        if (o == NULL) {
            o = next_plain(options);
            if (o == NULL) return REFUSE(command, "\"%s\" is one argument too many", argv[i]);
            if (!take_value(command, o, argv[i])) return false;
            continue;
        }
        if (o->kind == OPTION_FLAG) {
            *(bool *)o->value = true;
            continue;
        }
        if (i + 1 == argc) return REFUSE(command, "%s needs a value", argv[i]);
        if (!take_value(command, o, argv[++i])) return false;
    }
    return true;
}
