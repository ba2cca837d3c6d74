/* args.h: options of a subcommand as a table, read once; and the exit codes of the command. */
#ifndef MUSLIN_ARGS_H
#define MUSLIN_ARGS_H

#include <stdbool.h>
#include <stdio.h>
#include <stdint.h>

#define EXIT_DONE 0
#define EXIT_FAILED 1 /* a run that failed */
#define EXIT_INPUT 2  /* bad input */

/*
 * Kinds of option: a flag (bool); a text (const char *); a number (double), integer or not; a list of texts; an output
 * file (const char *), "-" for standard output; a flag (bool) whose output is standard output; a plain argument; all
 * plain arguments that are left (a list of texts).
 */
typedef enum option_kind {
    OPTION_FLAG,
    OPTION_TEXT,
    OPTION_NUMBER,
    OPTION_WHOLE,
    OPTION_LIST,
    OPTION_OUTPUT,
    OPTION_STDOUT,
    OPTION_PLAIN,
    OPTION_REST
} option_kind;

typedef struct texts {
    int32_t count;
    const char *at[32];
} texts;

typedef struct option {
    const char *name; /* "--tape"; of a plain argument its name in messages */
    option_kind kind;
    void *value;
    double low, high; /* of a number */
    const char *help; /* one line: "FILE  what it is" */
} option;

/*
 * Reads the arguments after the subcommand; a table has at most 64 options. --help prints the help and exits 0. Prints
 * one line and returns false when an option is unknown, has no value, is given twice (unless it is a list) or is out of
 * range, when an output file cannot be written, or when two outputs are standard output.
 */
bool args_read(const char *command, const char *summary, const option *options, int argc, char **argv);

/* Whether the output `path` (NULL: not asked for) is standard output. Then no line for people may be printed there. */
bool is_stdout(const char *path);

/* Whether `path` can be written, as far as that can be told before the work; prints a line when it cannot. */
bool output_check(const char *command, const char *path);

/* Prints a text with its control characters as \x1b: names from files must not steer the terminal. */
void print_shown(FILE *file, const char *text);

/* Prints one line on standard output, as print_shown() does. */
void print_line(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Prints one line on standard error, "muslin COMMAND: text". Returns `code`. */
int complain(int code, const char *command, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Prints one line on standard error, "muslin COMMAND: warning: text". */
void doubt(const char *command, const char *text);

/* The texts that would go to standard error: the first complaint and the first warnings, without the command's name. */
typedef struct complaints {
    char text[600];
    int32_t doubts;
    char doubt[64][512]; /* above the most warnings of a tape, 48 */
} complaints;

/* Empties `into`, and writes complaints and warnings to it from now on; NULL: to standard error again. */
void complaints_keep(complaints *into);

/* Returns the complaints and warnings so far, whether they were printed or kept. */
const complaints *complaints_said(void);

/* Flushes standard output. Returns EXIT_DONE, or prints a line and returns EXIT_FAILED. */
int output_end(const char *command);

/* Reads a finite number with a decimal point, in every locale; returns false when `text` is not one. */
bool number_read(const char *text, double *out);

#endif
