/*
 * alike.h: sewings compared, of patterns in which panels of one shape can stand for one another.
 */
#ifndef MUS_STUDY_ALIKE_H
#define MUS_STUDY_ALIKE_H

#include "seam/seam_find.h"

/* seams of `mate` that the true sewing does not have, and the other way round */
int32_t seams_wrong(const mus__seam_facts *facts, const int32_t *truth, const int32_t *mate);

/* renames the true sewing: panels of one shape are exchanged, and those turned that are the same upside down, as long
 * as more seams of `mate` are right */
void seams_match(const mus__seam_facts *facts, int32_t *truth, const int32_t *mate);

#endif
