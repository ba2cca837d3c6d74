/*
 * muslin/catalogue.h: a collection of patterns on disk that is searched by how the patterns are sewn.
 *
 * A catalogue is one SQLite file. For each pattern the file holds a name, the canonical form (mus_pattern_form()) and
 * the numbers that a tailor compares: components, seams, openings with their lengths, panels with their areas. The
 * library is libmuslin-catalogue. A catalogue is used by one thread at a time. Any number of programs may have the
 * file open, and one of them may write.
 */
#ifndef MUSLIN_CATALOGUE_H
#define MUSLIN_CATALOGUE_H

#include "muslin/base.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An open catalogue. */
typedef struct mus_catalogue mus_catalogue;

#define MUS_CATALOGUE_READ 0  /* mode: search only; the file must exist */
#define MUS_CATALOGUE_WRITE 1 /* mode: search and add; a missing file is created */

/**
 * Open the catalogue `path`. `mode` is MUS_CATALOGUE_READ or MUS_CATALOGUE_WRITE.
 *
 * Errors:  MUS_ERR_ARG; MUS_ERR_FILE (cannot be opened or read); MUS_ERR_FORMAT (not a catalogue, or written by a newer
 *          library: the message names both versions); MUS_ERR_MEMORY
 */
MUS_API mus_status mus_catalogue_open(mus_context *context, const char *path, int32_t mode, mus_catalogue **out);

/** Close a catalogue and free it. Additions that are not committed are dropped. NULL is accepted. */
MUS_API void mus_catalogue_destroy(mus_catalogue *catalogue);

/**
 * Add a pattern under `name`, and write its number to *out (out may be NULL). A pattern that already has this name is
 * replaced, and its number stays.
 *
 * The pattern is on disk when the call returns, or, after mus_catalogue_begin(), when mus_catalogue_commit() returns.
 * Errors: MUS_ERR_ARG, MUS_ERR_STATE (open for reading), MUS_ERR_PATTERN, MUS_ERR_LIMIT, MUS_ERR_FILE, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_catalogue_add(mus_catalogue *catalogue, const mus_pattern *pattern, const char *name,
                                     int32_t *out);

/** Begin a transaction: the additions that follow are kept all together, by mus_catalogue_commit(), or not at all.
 * Errors: MUS_ERR_STATE (begun already, or open for reading), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_begin(mus_catalogue *catalogue);

/** Write all additions since mus_catalogue_begin() to disk. After a failure the transaction is still open: commit it
 * again or roll it back. Errors: MUS_ERR_STATE (not begun), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_commit(mus_catalogue *catalogue);

/** Drop all additions since mus_catalogue_begin(). Errors: MUS_ERR_STATE (not begun), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_rollback(mus_catalogue *catalogue);

/** Number of patterns; MUS_NONE when the file cannot be read. */
MUS_API int32_t mus_catalogue_count(const mus_catalogue *catalogue);

/** Name of the pattern number `id`; borrowed until the next call on the catalogue. Errors: MUS_ERR_ARG (no such
 * number), MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_name(mus_catalogue *catalogue, int32_t id, const char **name);

/** Find the patterns that are the same as `pattern` up to names, order and mirroring. ids gets the first `capacity`
 * numbers, ascending; *count is the number of all patterns found. Errors: MUS_ERR_ARG, those of mus_pattern_form(),
 * MUS_ERR_FILE */
MUS_API mus_status mus_catalogue_exact(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t *ids,
                                       int32_t capacity, int32_t *count);

/* Parts of the distance between two patterns. Their weights were chosen; mus_catalogue(3) has them in full. */
#define MUS_DISTANCE_PIECES 0   /* 1 for each panel by which the numbers of panels differ */
#define MUS_DISTANCE_SEAMS 1    /* 0.05 for each seam by which the numbers of seams differ */
#define MUS_DISTANCE_SURFACE 2  /* 2 for each component, 0.5 for each unit of the Euler characteristic */
#define MUS_DISTANCE_OPENINGS 3 /* openings matched by length: 0.02 for each per cent, 2 for one without a partner */
#define MUS_DISTANCE_PANELS 4   /* panels matched by size: 0.02 for each per cent of area and of perimeter (2 at most),
                                   0.2 for each edge (1 at most), 2 for one without a partner */
#define MUS_DISTANCE_CLOTH 5    /* 0.01 for each per cent of cloth area and of sewn length */
#define MUS_DISTANCE_COUNT 6    /* number of parts */

/**
 * Find the patterns nearest to `pattern`, nearest first. At equal distance the lower number comes first.
 *
 * Shapes: ids, distances, exact (capacity each; the last two may be NULL); *count is the number of entries written.
 *         exact is 1 where the canonical forms are equal, else 0
 * Errors: MUS_ERR_ARG, those of mus_pattern_form(), MUS_ERR_FILE, MUS_ERR_MEMORY
 * Cost:   the first call after a change of the file reads all of it: about 1 us for each pattern
 */
MUS_API mus_status mus_catalogue_nearest(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t capacity,
                                         int32_t *ids, double *distances, int32_t *exact, int32_t *count);

/** Explain the distance between `pattern` and the pattern number `id`: parts (MUS_DISTANCE_COUNT) gets numbers whose
 * sum is the distance; text gets a line for each part that is not 0, at most `capacity` bytes with the zero byte at the
 * end. Either may be NULL. Errors: as mus_catalogue_nearest() */
MUS_API mus_status mus_catalogue_explain(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t id,
                                         double *parts, char *text, size_t capacity);

/**
 * Find the patterns that contain `part`.
 *
 * A pattern contains the part when it has all panels of the part with their edges in order, the seams of the part join
 * the same edges there, and the labels of the part agree. Open edges of the part may be sewn to anything. ids and
 * *count are as in mus_catalogue_exact(). Errors: as mus_catalogue_exact(), MUS_ERR_MEMORY
 */
MUS_API mus_status mus_catalogue_containing(mus_catalogue *catalogue, const mus_pattern *part, int32_t *ids,
                                            int32_t capacity, int32_t *count);

#ifdef __cplusplus
}
#endif

#endif
