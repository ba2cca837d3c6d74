/* bench.h: the parts of `muslin bench`: one row of figures, and the functions that measure the rows. */
#ifndef BENCH_H
#define BENCH_H

#include "command/json.h"
#include "edge_list.h"
#include "muslin/muslin.h"

/* One row. Figures that a case does not have are NaN and are not printed. */
typedef struct bench_row {
    const char *name;
    int32_t precision, threads, nodes, springs;
    int64_t evaluations;   /* force evaluations in the best repeat */
    double cpu_s, wall_s;  /* of that repeat */
    double plain_s;        /* CPU time of one evaluation of one node in the edge-list form [s] */
    double cpu_per_second; /* CPU seconds for a simulated second */
    double fall;           /* depth of the lowest node below the start after half a second [m] */
    double strain;         /* largest strain of a structural spring at rest */
    double reaction;       /* upward force of the pins over the weight, at rest */
    double cpu_frame_ms;   /* CPU time of a frame of 20 ms [ms] */
    double area;           /* area of the garment [m2] */
    double step;           /* length of a step [s] */
    double over_off;       /* CPU time over that of the same case with the feature off */
} bench_row;

typedef struct bench {
    mus_context *context;
    bool as_json;
    json j;
} bench;

/* Returns a row whose figures are all NaN or 0. */
bench_row bench_row_start(const char *name, int32_t precision, int32_t threads);
void bench_row_write(bench *b, const bench_row *row);

double bench_cpu(void);
double bench_wall(void);

/* Returns the constants of the edge-list form for a fabric with equal C11 along weft and warp, shear G, and one bending
 * rigidity B in every direction. */
plain_lattice bench_lattice(const mus_fabric *fabric, int32_t side, double cell, double drag);
/* CPU time [s] of one evaluation of one node in the edge-list form: forces only, or a quarter of an RK4 step. */
double bench_plain(const plain_lattice *lattice, int32_t precision, bool steps);

/* The parts of the table, one file each: steps.c, contact.c, garment_contact.c, body.c, scenes.c, layers.c. */
mus_status bench_speed(bench *b, bool everything);
mus_status bench_contact(bench *b);
mus_status bench_worn(bench *b);
mus_status bench_body(bench *b);
mus_status bench_scenes(bench *b, bool everything);
mus_status bench_layers(bench *b);

#endif
