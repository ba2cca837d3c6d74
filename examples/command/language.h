/* language.h: the language of what the command prints for people; JSON and files of patterns do not have one. */
#ifndef MUSLIN_COMMAND_LANGUAGE_H
#define MUSLIN_COMMAND_LANGUAGE_H

#include <stddef.h>
#include <stdint.h>

#include "args.h"

#define LANGUAGE_OPTION(asked) \
    {"--language", OPTION_TEXT, &(asked), 0, 0, "LANG  en de fr es pt ja ar th; default: LC_ALL, LC_MESSAGES or LANG"}

/* Number of the language asked for; without one (NULL) that of the environment where the table has it, else English.
 * Prints a line and returns MUS_NONE for one that is not in the table. */
int32_t language_read(const char *command, const char *asked);

/* Prints a text and blanks up to `columns` of a terminal: letters of East Asia take two, signs above others none. */
void language_pad(const char *text, int32_t columns);

#endif
