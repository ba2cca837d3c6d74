/*
 * outside.c: every person of ANSUR II and every table size, measured on the written OBJ file: `make outside`.
 *
 * outside TABLE FOLDER [--each N] [--sizes 1]. The file is written to FOLDER and read by a ruler that shares nothing
 * with the library (ruler.h). Printed: asked against made of each measure that the tape gives, the same of derived
 * measures, and how far the skin lies off what cloth touches. Measures that are known to be beyond their limits are
 * counted apart (measure.c). Exit 1 when any other is beyond its limit.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../people/ansur.h"
#include "measure.h"

/* off [m] of one measure over all bodies, apart for given and for derived values */
typedef struct tally {
    int count, beyond;
    double sum, least, most;
    char who[32];
} tally;

static tally given[OUTSIDE_ROWS], derived[OUTSIDE_ROWS];
static outside_gap worst;
static char who_outside[32], who_inside[32];
static int bodies, touched;


static void add(tally *to, double off, double limit, const char *who)
{
    if (isnan(off)) return;
    if (to->count == 0 || fabs(off) > fmax(fabs(to->least), fabs(to->most)))
        snprintf(to->who, sizeof to->who, "%s", who);
    to->least = to->count == 0 ? off : fmin(to->least, off);
    to->most = to->count == 0 ? off : fmax(to->most, off);
    to->sum += off;
    to->count++;
    to->beyond += fabs(off) > limit;
}


/* measure one tape; with `touch` the skin is compared with the fields too */
static void measure_one(mus_context *context, const mus_tape *tape, const char *who, const char *path, bool touch)
{
    mus_body *body = NULL;
    double made[OUTSIDE_ROWS];
    if (mus_body_create(context, tape, NULL, &body) != MUS_OK || outside_write(context, body, path) != MUS_OK ||
        !outside_measure(body, path, made)) {
        printf("%s: %s\n", who, mus_context_error(context));
        mus_body_destroy(body);
        return;
    }
    for (int i = 0; i < OUTSIDE_ROWS; i++) {
        const outside_row *row = &outside_rows[i];
        const bool asked = mus_body_source(body, row->measure) == MUS_SOURCE_GIVEN;
        add(asked ? &given[i] : &derived[i], made[i] - mus_body_asked(body, row->measure), row->most, who);
    }
    bodies++;
    if (touch) {
        outside_gap gap;
        outside_touch(body, 1, &gap);
        worst.points += gap.points, worst.far += gap.far;
        if (gap.outside > worst.outside) {
            worst.outside = gap.outside, memcpy(worst.at_outside, gap.at_outside, sizeof gap.at_outside);
            snprintf(who_outside, sizeof who_outside, "%s", who);
        }
        if (gap.inside > worst.inside) {
            worst.inside = gap.inside, memcpy(worst.at_inside, gap.at_inside, sizeof gap.at_inside);
            snprintf(who_inside, sizeof who_inside, "%s", who);
        }
        touched++;
    }
    mus_body_destroy(body);
}


/* print a table; whether every row that is judged is within its limit; *known: rows that are beyond it as is known */
static bool print(const char *title, const tally *table, bool judged, int *known)
{
    bool good = true;
    printf("\n%s, made less asked [mm]   bodies    mean    least     most   beyond  worst\n", title);
    for (int i = 0; i < OUTSIDE_ROWS; i++) {
        const tally *t = &table[i];
        if (t->count == 0) continue;
        const bool angle = outside_rows[i].measure == MUS_MEASURE_SHOULDER_SLOPE;
        const double unit = angle ? 180.0 / acos(-1.0) : 1000.0;
        printf("  %-30s %8d %8.2f %8.2f %8.2f %8d  %s%s%s\n", mus_measure_name(outside_rows[i].measure), t->count,
               unit * t->sum / t->count, unit * t->least, unit * t->most, t->beyond, t->who,
               angle ? " [degrees]" : "", outside_rows[i].known && t->beyond > 0 ? " (known)" : "");
        if (!judged || t->beyond == 0) continue;
        good = good && outside_rows[i].known;
        *known += outside_rows[i].known;
    }
    return good;
}


int main(int argc, char **argv)
{
    ansur table;
    mus_context *context = NULL;
    int each = 1;
    if (argc < 3 || !ansur_open(&table, argv[1]) || mus_context_create(NULL, &context) != MUS_OK) {
        fprintf(stderr, "outside: expected a table of people and a folder\n");
        return 2;
    }
    for (int i = 3; i + 1 < argc; i += 2)
        if (strcmp(argv[i], "--each") == 0) each = atoi(argv[i + 1]);
    char path[4096];
    snprintf(path, sizeof path, "%s/outside.obj", argv[2]);
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        mus_tape *tape = NULL;
        if (mus_tape_create(context, &tape) == MUS_OK && mus_tape_set_size(tape, mus_tape_size_name(i)) == MUS_OK)
            measure_one(context, tape, mus_tape_size_name(i), path, true);
        mus_tape_destroy(tape);
    }
    const int sizes = bodies;
    for (int i = 0; i < table.rows && each > 0; i += each) {
        mus_tape *tape = ansur_tape(context, &table, i);
        if (tape != NULL) measure_one(context, tape, ansur_name(&table, i), path, i % 10 == 0);
        mus_tape_destroy(tape);
    }
    remove(path);
    printf("%d table sizes, %d people\n", sizes, bodies - sizes);
    int known = 0;
    bool good = print("given", given, true, &known);
    print("derived", derived, false, &known);
    printf("\nskin against contact, %d bodies: %.3f %% of %lld points are further than 0.5 mm off\n", touched,
           100.0 * (double)worst.far / (double)(worst.points + 1), (long long)worst.points);
    printf("  furthest outside %.2f mm (%s, at %.3f %.3f %.3f m)\n", 1000.0 * worst.outside, who_outside,
           worst.at_outside[0], worst.at_outside[1], worst.at_outside[2]);
    printf("  furthest inside %.2f mm (%s, at %.3f %.3f %.3f m)\n", 1000.0 * worst.inside, who_inside,
           worst.at_inside[0], worst.at_inside[1], worst.at_inside[2]);
    printf("%s; %d measures are known to be beyond their limits%s\n",
           good ? "all other figures hold" : "a figure does not hold", known,
           worst.far > 0 ? ", and so is the distance of skin and contact" : "");
    mus_context_destroy(context);
    ansur_close(&table);
    return good ? 0 : 1;
}
