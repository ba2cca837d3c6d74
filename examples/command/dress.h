/* dress.h: one garment from its options to its report: for muslin dress, and for each line of a batch. */
#ifndef MUSLIN_COMMAND_DRESS_H
#define MUSLIN_COMMAND_DRESS_H

#include "json.h"
#include "mesh.h"
#include "motion.h"
#include "scene.h"

typedef struct dress {
    scene s;
    source from;
    mesh_source mesh;
    look look;
    mus_fabric fabric;
    const char *fabric_name, *place, *map, *png, *report;
    const char *files[MESH_FORMS]; /* mesh files by their form, NULL where none is asked for */
    const char *batch; /* for the help only: batch.c reads this option */
    double spacing_mm, nodes, threads, precision, friction;
    double turn; /* pictures of one turn; 0: none */
    double limit; /* seconds that a single garment may take; 0: no limit */
    bool as_json, quiet, self_contact, open;
    texts over; /* garments over the first, with self_contact */
    motion moved;
    bool led; /* whether the animated files are written */
    mus_progress_fn progress; /* of sewing and settling, when none is shown; may be NULL. With progress_user */
    void *progress_user;

    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_fit *fit; /* of a sewn garment; NULL before, and without memory for it */
    fit_map coloured;
    mus_status outcome;
    mus_worn worn; /* whether the garment is worn; MUS_WORN_UNKNOWN: not asked */
    mus_dress_report dressed; /* the starts tried, seconds of each phase */
    mus_reason why;           /* why the garment is on, or is not */
    double body_seconds, render_seconds;
} dress;

/* Sets every option to its default and all objects to NULL. */
void dress_init(dress *d);

/* Writes to `table` the options that say what is made and how it is shown, not where it is written: at most
 * DRESS_OPTIONS. Returns their number; the caller adds its own and ends the table. */
#define DRESS_OPTIONS 40
int32_t dress_options(dress *d, option *table);

/* Checks the options against each other. Returns an exit code. */
int dress_check(const char *command, const dress *d);

/* Reads tape, body and pattern, before the long work. Returns an exit code. */
int dress_open(dress *d);

/* Cuts, sews and settles the garment, moves the body, and writes picture and meshes. The report has the result. Returns
 * an exit code, which is EXIT_DONE when all outputs were written. */
int dress_run(dress *d);

/* Name of the reason why the garment is on or not, or "no memory". */
const char *dress_status(const dress *d);

/* Writes the members of the report into an open object. They are the same in each run: times are not among them. */
void dress_describe(const dress *d, bool timed, json *j);
/* Writes the member "seconds": the time of each phase. */
void dress_seconds(const dress *d, json *j);

void dress_close(dress *d);

#endif
