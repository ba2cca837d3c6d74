/* bench.h: the parts of `muslin bench`: one row of figures, and the functions that measure the rows. */
#ifndef BENCH_H
#define BENCH_H

#include "command/json.h"
#include "edge_list.h"
#include "muslin/muslin.h"

/* One row. Figures that a case has not are NaN and are left out. */
typedef struct bench_row {
    const char *name;
    int32_t precision, threads, nodes, springs;
    int64_t evaluations;   /* force evaluations in the best repeat */
    double cpu_s, wall_s;  /* of that repeat */
    double plain_s;        /* CPU of one evaluation of one node in the plain form */
    double cpu_per_second; /* CPU seconds for a simulated second */
    double fall;           /* lowest node at half a second, below the start [m] */
    double strain;         /* largest strain of a structural spring, at rest */
    double reaction;       /* of the pins, upwards, over the weight, at rest */
    double cpu_frame_ms;   /* CPU for a frame of 20 ms */
    double area;           /* of the garment [m2] */
    double step;           /* [s] */
    double over_off;       /* of CPU time over that without what the row has */
} bench_row;

typedef struct bench {
    mus_context *context;
    bool as_json;
    json j;
} bench;

/* a row with nothing in it yet */
bench_row bench_row_start(const char *name, int32_t precision, int32_t threads);
void bench_row_write(bench *b, const bench_row *row);

double bench_cpu(void);
double bench_wall(void);

/* constants of the plain form for a fabric of C11 along both, G, and one rigidity B in every direction */
plain_lattice bench_lattice(const mus_fabric *fabric, int32_t side, double cell, double drag);
/* CPU seconds of one evaluation of one node: of forces alone, or a quarter of a step of RK4 */
double bench_plain(const plain_lattice *lattice, int32_t precision, bool steps);

/* The parts of the table, one file each: steps.c, contact.c, garment_contact.c, body.c, scenes.c, layers.c. */
mus_status bench_speed(bench *b, bool everything);
mus_status bench_contact(bench *b);
mus_status bench_worn(bench *b);
mus_status bench_body(bench *b);
mus_status bench_scenes(bench *b, bool everything);
mus_status bench_layers(bench *b);

#endif
