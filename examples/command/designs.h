/* designs.h: parts of muslin designs: one design told, many drawn. */
#ifndef MUSLIN_DESIGNS_H
#define MUSLIN_DESIGNS_H

#include "json.h"
#include "scene.h"

/* Prints all of a named design: words, axes, cloth, and for a tape (none given: the size of design_size()) ease, pieces
 * and cloth; the title in the language. Returns an exit code. */
int design_show(const char *name, const source *from, int32_t language, bool as_json);

/* Draws the pieces of designs, drafted for a tape, as tiles with their names and titles, and writes a PNG. A tape that
 * a design is not for, or none: the size of design_size(). Returns an exit code. */
int designs_draw(const int32_t *designs, int32_t count, const source *from, const char *path);

/* Name, family, title, words and groups of a design, as members of the JSON object that is open. */
void design_json_head(int32_t design, json *j);

/* A table size that a design can be drafted for: W40, else M50, else C116. */
const char *design_size(int32_t design);

/* Drafts a design for the tape of `from`, or for design_size(). `s` is open. Returns an exit code. */
int design_draft(scene *s, int32_t design, const source *from);

#endif
