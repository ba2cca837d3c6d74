/* scene.h: a body dressed for a row of `make same`: what is worn, how it is cut, and all that the drape says. */
#ifndef MUS_TESTS_SAME_SCENE_H
#define MUS_TESTS_SAME_SCENE_H

#include "same.h"

#define SCENE_SELF 0x001   /* cloth meets cloth */
#define SCENE_FOUND 0x002  /* where the panels start is found */
#define SCENE_DOUBLE 0x004 /* the state is in double */
#define SCENE_SCAN 0x008   /* the body is made of the mesh beside the tape's file */
#define SCENE_OPEN 0x010   /* zips and buttons are left open */
#define SCENE_PAPER 0x020  /* bending by springs over one node */
#define SCENE_ONE_CUT 0x040 /* no coarser cuts */
#define SCENE_ONCE 0x080    /* sewing gives up where its first try fails */
#define SCENE_TWO 0x100     /* two threads */
#define SCENE_VERLET 0x200  /* stepped by Verlet */
#define SCENE_BALL 0x400    /* contact by planes while a node stays in a ball of 0.25 mm */

typedef struct same_scene {
    const char *name;    /* of the row; NULL: the garment's */
    const char *garment; /* a design, words, or a file of the real data ending in .json; '+' before what is worn over */
    const char *tape;    /* a table size, or the name of a body of the real data */
    double spacing;      /* of the lattice [mm] */
    int32_t flags;       /* SCENE_* */
    const char *fabric;  /* NULL: the default */
} same_scene;

typedef struct same_dressed {
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
} same_dressed;

/* a file of garmentcode/bodies of the real data with this ending ("mean_all", ".obj"), and the body of a mesh */
const char *same_body_file(const char *body, const char *ending);
mus_body *same_scan(const same_run *run, const char *body, bool distances, mus_scan_report *report);

/* the garment of a scene: a design drafted to a tape, or a file, and garments worn over it */
mus_pattern *same_garment(const same_run *run, const char *garment, const mus_tape *tape);

/* cloth of the pattern, and a drape of it round the body, placed */
void same_cut_out(const same_run *run, const same_scene *scene, same_dressed *out);

/* tape, body and pattern made, cut out and placed */
same_dressed same_place(const same_run *run, const same_scene *scene);

/* sewn, and settled when it was; statuses are added. Returns whether it settled */
bool same_wear(same_run *run, const same_dressed *d);

/* add how a drape stands: places, speeds, report, reason, forces, normals, gaps, crossings */
void same_drape(same_run *run, const mus_drape *drape, const mus_cloth *cloth);

/* add how the garment fits */
void same_fit(same_run *run, const same_dressed *d);

/* ---- scenes that are stepped: steps.c, moved.c ---- */

typedef struct same_stepped {
    const char *name;
    same_scene scene;
    void (*act)(same_run *run, const same_dressed *d); /* what is done to it once it is sewn */
} same_stepped;

/* a scene placed and sewn, and its act */
same_dressed same_stepped_scene(same_run *run, const same_stepped *row);

/* make the row of a same_stepped: its scene, its act, and all that the drape says then */
void same_make_stepped(same_run *run, const void *what, int32_t index);

/* so many seconds of cloth time, in as many even steps as nine tenths of the bound ask for */
void same_step_seconds(same_run *run, const same_dressed *d, double seconds);

#endif
