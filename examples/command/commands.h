/* commands.h: the subcommands; each takes the arguments after its name and returns the exit code. */
#ifndef MUSLIN_COMMANDS_H
#define MUSLIN_COMMANDS_H

int command_body(int argc, char **argv);
int command_designs(int argc, char **argv);
int command_draft(int argc, char **argv);
int command_grade(int argc, char **argv);
int command_dress(int argc, char **argv);
int command_sheet(int argc, char **argv);
int command_print(int argc, char **argv);
int command_layout(int argc, char **argv);
int command_convert(int argc, char **argv);
int command_seams(int argc, char **argv);
int command_catalogue(int argc, char **argv);
int command_find(int argc, char **argv);
int command_bench(int argc, char **argv);
int command_verify(int argc, char **argv);

#endif
