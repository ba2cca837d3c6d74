/*
 * muslin/catalogue.h: a collection of patterns on disk, found again by how they are sewn.
 *
 * A catalogue is one SQLite file. It keeps of each pattern its name, its canonical form (mus_pattern_form()) and what a
 * tailor would compare: pieces, seams, openings with their lengths, panels with their areas. The library is
 * libmuslin-catalogue. A catalogue is used by one thread at a time; any number of programs may have it open, one
 * writing.
 */
#ifndef MUSLIN_CATALOGUE_H
#define MUSLIN_CATALOGUE_H

#include "muslin/base.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_catalogue mus_catalogue;

#define MUS_CATALOGUE_READ 0  /* the file must be there */
#define MUS_CATALOGUE_WRITE 1 /* it is made when it is not there */

/**
 * Open a catalogue.
 *
 * Errors:  MUS_ERR_ARG; MUS_ERR_FILE (cannot be opened or read); MUS_ERR_FORMAT (not a catalogue, or written by a newer
 *          library: the message has both versions); MUS_ERR_MEMORY
 */
MUS_API mus_status mus_catalogue_open(mus_context *context, const char *path, int32_t mode, mus_catalogue **out);
MUS_API void mus_catalogue_destroy(mus_catalogue *catalogue);

/**
 * Add a pattern under a name; one that is there already is replaced and keeps its number.
 *
 * Outside mus_catalogue_begin() it is on disk when the call returns; inside, when mus_catalogue_commit() returns.
 * Errors: MUS_ERR_ARG, MUS_ERR_STATE (open for reading), MUS_ERR_PATTERN, MUS_ERR_LIMIT, MUS_ERR_FILE, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_catalogue_add(mus_catalogue *catalogue, const mus_pattern *pattern, const char *name,
                                     int32_t *out);

/** Many additions as one: all of them are kept, or none. A catalogue destroyed in between keeps none.
 * Errors: MUS_ERR_STATE (begun already, or not begun), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_begin(mus_catalogue *catalogue);
MUS_API mus_status mus_catalogue_commit(mus_catalogue *catalogue);
MUS_API mus_status mus_catalogue_rollback(mus_catalogue *catalogue);

/** How many patterns there are; MUS_NONE when the file cannot be read. */
MUS_API int32_t mus_catalogue_count(const mus_catalogue *catalogue);

/** Name of a pattern by its number; borrowed until the next call on the catalogue. Errors: MUS_ERR_ARG (no such
 * number), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_name(mus_catalogue *catalogue, int32_t id, const char **name);

/** Patterns that are the same as `pattern` up to names, order and mirroring: at most `capacity` numbers in order,
 * *count is how many there are. Errors: those of mus_pattern_form(), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_exact(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t *ids,
                                       int32_t capacity, int32_t *count);

/* Parts of the distance between two patterns: 1 for each panel more or less; 0.05 for each seam; 2 for each piece that
 * hangs apart and 0.5 for each unit of the Euler characteristic; openings matched by length, 2 for one without partner
 * and else 0.02 for each per cent; panels matched by size, 2 without a partner, else 0.02 for each per cent of area and
 * of perimeter (2 at most) and 0.2 for each edge (1 at most); 0.01 for each per cent of cloth and of sewn length. */
#define MUS_DISTANCE_PIECES 0
#define MUS_DISTANCE_SEAMS 1
#define MUS_DISTANCE_SURFACE 2
#define MUS_DISTANCE_OPENINGS 3
#define MUS_DISTANCE_PANELS 4
#define MUS_DISTANCE_CLOTH 5
#define MUS_DISTANCE_COUNT 6

/**
 * The patterns nearest to `pattern`, nearest first; of equal distance the lower number first.
 *
 * Shapes: ids, distances, exact (capacity each; the last two may be NULL); *count is how many were written. exact is 1
 *         where the forms are equal
 * Errors: MUS_ERR_ARG, those of mus_pattern_form(), MUS_ERR_FILE, MUS_ERR_MEMORY
 * Cost:   the first call after the file changed reads it whole: 1 us a pattern or so
 */
MUS_API mus_status mus_catalogue_nearest(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t capacity,
                                         int32_t *ids, double *distances, int32_t *exact, int32_t *count);

/** How far a pattern is from one of the catalogue: parts (MUS_DISTANCE_COUNT) whose sum is the distance, and a line for
 * each part that is not 0 (text, at most `capacity` bytes with the end). Either may be NULL. Errors: as nearest */
MUS_API mus_status mus_catalogue_explain(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t id,
                                         double *parts, char *text, size_t capacity);

/**
 * Patterns that contain `part`: its panels are there with their edges in order, what is sewn in the part is sewn so,
 * and labels that the part has agree; its open edges may be sewn to anything. Numbers in order, as
 * mus_catalogue_exact().
 */
MUS_API mus_status mus_catalogue_containing(mus_catalogue *catalogue, const mus_pattern *part, int32_t *ids,
                                            int32_t capacity, int32_t *count);

#ifdef __cplusplus
}
#endif

#endif
