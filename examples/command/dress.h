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
    const char *fabric_name, *place, *map, *png, *glb, *obj, *report;
    const char *batch; /* of the help alone: batch.c reads a batch */
    double spacing_mm, nodes, threads, precision, friction;
    bool as_json, quiet, self_contact, open;
    texts over; /* garments over the first, with self_contact */
    motion moved;
    bool led; /* the animated file is written */
    mus_progress_fn progress; /* of sewing and settling where none is shown, NULL: none; with progress_user */
    void *progress_user;

    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_fit *fit; /* of a garment that is sewn; may be NULL */
    fit_map coloured;
    mus_status outcome;
    mus_dress_report dressed; /* starts that were tried, seconds of each phase */
    mus_reason why;           /* why the garment is on, or is not */
    double body_seconds, render_seconds;
} dress;

/* Nothing is made yet, and every option has its default. */
void dress_init(dress *d);

/* Options that say what is made and how it is shown, not where it goes, into `table`: at most DRESS_OPTIONS. Returns
 * how many; the caller adds its own and ends the table. */
#define DRESS_OPTIONS 40
int32_t dress_options(dress *d, option *table);

/* What no range of an option tells. Returns an exit code. */
int dress_check(const char *command, const dress *d);

/* Read tape, body and pattern, before the long work. Returns an exit code. */
int dress_open(dress *d);

/* Cut, sew, settle, move, and write picture and meshes; what became of the garment is in the report. Returns an exit
 * code: that of what could not be written. */
int dress_run(dress *d);

/* Name of the reason why the garment is on or is not, or "no memory". */
const char *dress_status(const dress *d);

/* Members of the report into an open object; without the time that it took, all is the same in each run. */
void dress_describe(const dress *d, bool timed, json *j);
/* "seconds", the time that it took. */
void dress_seconds(const dress *d, json *j);

void dress_close(dress *d);

#endif
