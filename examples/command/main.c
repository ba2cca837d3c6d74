/*
 * main.c: the muslin command: from tape to paper. Each subcommand stands in a file of its own.
 *
 * Exit 0 only when the asked thing was done; 2 for bad input, 1 for a run that failed; one line on standard error.
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
    {"body", command_body, "tape to body; girths asked, girths made"},
    {"designs", command_designs, "the named designs"},
    {"draft", command_draft, "tape to pattern"},
    {"grade", command_grade, "one design in a row of sizes: ease, seams, rules"},
    {"dress", command_dress, "sew and drape: picture, mesh, report"},
    {"sheet", command_sheet, "many designs on many bodies as one picture"},
    {"print", command_print, "ready-to-cut paper: PDF, SVG"},
    {"convert", command_convert, "one pattern or tape file to another form"},
    {"catalogue", command_catalogue, "patterns kept in a file, to be found again"},
    {"find", command_find, "patterns of a catalogue like a given one"},
    {"bench", command_bench, "speed table"},
    {"verify", command_verify, "cases with exact answers: error and tolerance"},
};

#define COMMANDS (sizeof commands / sizeof commands[0])


static void usage(void)
{
    printf("usage: muslin COMMAND [options]\n\n");
    for (size_t i = 0; i < COMMANDS; i++) printf("  %-10s %s\n", commands[i].name, commands[i].help);
    printf("\nmuslin COMMAND --help tells the options; muslin --version the version.\n");
}


int main(int argc, char **argv)
{
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
    fprintf(stderr, "muslin: command \"%s\" is unknown; see muslin --help\n", argv[1]);
    return EXIT_INPUT;
}
