/* args.h: options of a subcommand as a table, read once; and the exit codes of the command. */
#ifndef MUSLIN_ARGS_H
#define MUSLIN_ARGS_H

#include <stdbool.h>
#include <stdint.h>

#define EXIT_DONE 0
#define EXIT_FAILED 1 /* a run that failed */
#define EXIT_INPUT 2  /* bad input */

/*
 * Kinds of option: a flag (bool); text (const char *); a number (double), whole or not; a list (texts); a file that
 * will be written (const char *), "-" for standard output; a flag (bool) that takes standard output; a plain argument.
 */
typedef enum option_kind {
    OPTION_FLAG,
    OPTION_TEXT,
    OPTION_NUMBER,
    OPTION_WHOLE,
    OPTION_LIST,
    OPTION_OUTPUT,
    OPTION_STDOUT,
    OPTION_PLAIN
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
 * Read the arguments behind the subcommand; a table has at most 64 options. Prints the help and exits 0 at --help;
 * prints one line and returns false when an option is unknown, lacks its value, is given twice (lists apart) or is out
 * of range, when a file cannot be written where it should go, and when two outputs would share standard output.
 */
bool args_read(const char *command, const char *summary, const option *options, int argc, char **argv);

/* Is the output `path` (NULL when not asked) standard output? Then no line for people may go there. */
bool is_stdout(const char *path);

/* Can `path` be written, as far as one can tell before the work? False and a line when not. */
bool output_check(const char *command, const char *path);

/* One line on standard error, "muslin COMMAND: text". Returns `code`. */
int complain(int code, const char *command, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The same with the word "warning". */
void doubt(const char *command, const char *text);

/* What was said in place of lines on standard error: the first complaint, the first doubts, without the command. */
typedef struct complaints {
    char text[600];
    int32_t doubts;
    char doubt[64][512]; /* above the most warnings of a tape, 48 */
} complaints;

/* Keep complaints and doubts in `into` from now on, which is emptied; NULL: on standard error again. */
void complaints_keep(complaints *into);

/* The doubts up to now, whether they were printed or kept. */
const complaints *complaints_said(void);

/* Is all of standard output out? EXIT_DONE, or a line and EXIT_FAILED. */
int output_end(const char *command);

/* A finite number with a decimal point, whatever the locale; false when `text` is not one. */
bool number_read(const char *text, double *out);

#endif
