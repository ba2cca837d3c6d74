/*
 * main.c: the muslin command. Each subcommand has a file of its own.
 *
 * The exit code is 0 when the task was done, 2 for bad input, 1 for a run that failed; then one line on standard error
 * says why.
 */
#include <stdio.h>
#include <string.h>

#include "args.h"
#include "commands.h"
#include "muslin/base.h"

static const struct {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *help;
} commands[] = {
    {"body", command_body, "make a body from a tape; measures asked for and made"},
    {"designs", command_designs, "list, search, show and draw the named designs"},
    {"draft", command_draft, "draft a design to a tape"},
    {"grade", command_grade, "draft one design in several sizes: ease, seams, grade rules"},
    {"dress", command_dress, "sew and drape a garment: picture, mesh, report"},
    {"sheet", command_sheet, "dress many designs on many bodies, as one picture"},
    {"print", command_print, "write paper ready to cut: PDF, SVG"},
    {"layout", command_layout, "lay pieces on cloth: metres, a drawing"},
    {"convert", command_convert, "convert a pattern or tape file to another form"},
    {"seams", command_seams, "propose the seams of a pattern whose file has none"},
    {"catalogue", command_catalogue, "add patterns to a catalogue file"},
    {"find", command_find, "find patterns of a catalogue that are like a given one"},
    {"bench", command_bench, "measure speed"},
    {"verify", command_verify, "run cases with exact answers: error and tolerance"},
};

#define STACK_BYTES (320 << 10) /* 256 KiB of the library (muslin(3)), and the command's own */
#define PAGE_BYTES 4096
#define COMMANDS (sizeof commands / sizeof commands[0])


static void usage(void)
{
    printf("usage: muslin COMMAND [options]\n\n");
    for (size_t i = 0; i < COMMANDS; i++) printf("  %-10s %s\n", commands[i].name, commands[i].help);
    printf("\nmuslin COMMAND --help lists the options; muslin --version prints the version.\n");
}


/* The command that begins with the most letters of a text, at least three; NULL: none does. */
static const char *nearest(const char *text)
{
    const char *found = NULL;
    size_t most = 2;
    for (size_t i = 0; i < COMMANDS; i++) {
        size_t n = 0;
        while (text[n] != '\0' && text[n] == commands[i].name[n]) n++;
        if (n > most) most = n, found = commands[i].name;
    }
    return found;
}


/* Takes the stack that the library needs from the system. Later, where memory is short, the system would end the
 * program by a signal, in the middle of its work and without a sentence. */
static __attribute__((noinline)) void take_stack(void)
{
    volatile char room[STACK_BYTES];
    for (size_t i = sizeof room; i >= PAGE_BYTES; i -= PAGE_BYTES) room[i - 1] = 0;
}


int main(int argc, char **argv)
{
    take_stack();
    if (argc < 2) {
        fprintf(stderr, "muslin: no command is given; see muslin --help\n");
        return EXIT_INPUT;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) {
        usage();
        return output_end("--help");
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("muslin %d.%d.%d\n", MUS_VERSION_MAJOR, MUS_VERSION_MINOR, MUS_VERSION_PATCH);
        return output_end("--version");
    }
    for (size_t i = 0; i < COMMANDS; i++) {
        if (strcmp(argv[1], commands[i].name) != 0) continue;
        const int code = commands[i].run(argc - 2, argv + 2);
        return code == EXIT_DONE ? output_end(argv[1]) : code;
    }
    const char *near = nearest(argv[1]);
    fprintf(stderr, "muslin: command \"%s\" is unknown; ", argv[1]);
    if (near != NULL) fprintf(stderr, "did you mean %s? ", near);
    fprintf(stderr, "see muslin --help\n");
    return EXIT_INPUT;
}
