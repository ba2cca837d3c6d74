/*
 * tape_forms.h: the readers of the forms of a tape file. Each fills an empty tape.
 */
#ifndef MUS_EXCHANGE_TAPE_FORMS_H
#define MUS_EXCHANGE_TAPE_FORMS_H

#include "exchange/source.h"

mus_status mus__tape_read_text(mus__source *source, mus_tape *tape);
mus_status mus__tape_read_yaml(mus__source *source, mus_tape *tape);
mus_status mus__tape_read_vit(mus__source *source, mus_tape *tape);
mus_status mus__tape_read_table(mus__source *source, const char *row, mus_tape *tape);

#endif
