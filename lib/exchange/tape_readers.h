/*
 * tape_readers.h: the readers of the forms of a tape file. Each fills an empty tape and lists the names that muslin has
 * no use for.
 */
#ifndef MUS_EXCHANGE_TAPE_READERS_H
#define MUS_EXCHANGE_TAPE_READERS_H

#include "exchange/file_read.h"

mus_status mus__tape_read_yaml(mus__source *source, mus_tape *tape, mus__unused *unused);
mus_status mus__tape_read_vit(mus__source *source, mus_tape *tape, mus__unused *unused);
mus_status mus__tape_read_table(mus__source *source, const char *row, mus_tape *tape, mus__unused *unused);

#endif
