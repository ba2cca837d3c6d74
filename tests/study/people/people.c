/*
 * people.c: every person of ANSUR II and every table size made and measured: `make people`.
 *
 * people TABLE [--csv FILE] [--each N]. Printed: how many build, and each refusal; asked against made of every asked
 * measure (the library's own figure, and the same by slicing the triangles); CPU time of a body; volume against weight;
 * breadth and depth of the made body against the survey's calipers, and girths that were not asked. FILE gets a row a
 * person; N takes each Nth person alone. Exit 1 when a figure is beyond its limit.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ansur.h"
#include "slice.h"

/* limbs of a body of a tape, as body.h lists them */
#define TORSO 0
#define LEG_LEFT 3

/* what is compared without being asked: a column of the survey at the height of another */
static const struct {
    const char *what, *column, *height;
    char kind; /* b breadth, d depth, g girth */
    double off_female, off_male;
} calipers[] = {
    {"chest breadth", "chest_b", "chest_h", 'b', 0, 0},        {"chest depth", "chest_d", "chest_h", 'd', 0, 0},
    {"navel breadth", "waist_b", "waist_h", 'b', 0, 0},        {"navel depth", "waist_d", "waist_h", 'd', 0, 0},
    {"navel girth", "waist_circ", "waist_h", 'g', 0, 0},       {"seat breadth", "hip_b", "buttock_h", 'b', 0, 0},
    {"seat depth", "buttock_d", "buttock_h", 'd', 0, 0},       {"seat girth there", "hip_circ", "buttock_h", 'g', 0, 0},
    {"chest girth there", "chest_circ", "chest_h", 'g', 0, 0},
};
#define CALIPERS ((int)(sizeof calipers / sizeof *calipers))

/* lengths along the skin: those that the body follows to 2 mm, then those that come as girths and heights have them */
static const int lengths[] = {MUS_MEASURE_SHOULDER,      MUS_MEASURE_ARM,         MUS_MEASURE_ELBOW,
                              MUS_MEASURE_BACK_WAIST,    MUS_MEASURE_CROTCH_LENGTH, MUS_MEASURE_ACROSS_BACK,
                              MUS_MEASURE_ACROSS_FRONT, MUS_MEASURE_BUST_SPAN};
#define LENGTHS ((int)(sizeof lengths / sizeof *lengths))
#define LENGTHS_FOLLOWED 3

/* lengths that a body follows when its sheet names them. The survey has no bust span: a fifth of the bust stands for
 * it; its crotch length is taken at the navel, and the waist lies higher, in front and behind */
static const int named[] = {MUS_MEASURE_CROTCH_LENGTH, MUS_MEASURE_BUST_SPAN};
#define NAMED ((int)(sizeof named / sizeof *named))

typedef struct person {
    bool male;
    double named[NAMED], named_seconds, named_girth; /* of a body of a sheet that names them; NaN: refused */
    double seconds, drawn, volume, litres_off; /* part of the true volume */
    double off[ANSUR_MEASURES], cut[ANSUR_MEASURES], length[LENGTHS];
    double caliper[CALIPERS];
} person;


/* ---- statistics ---- */

static int by_size(const void *left, const void *right)
{
    const double x = *(const double *)left, y = *(const double *)right;
    return x < y ? -1 : x > y;
}


/* the q-quantile of n values, which it sorts */
static double quantile(double *x, int n, double q)
{
    if (n == 0) return NAN;
    qsort(x, (size_t)n, sizeof *x, by_size);
    return x[(int)lround(q * (n - 1))];
}


static void mean_of(const double *x, int n, double *mean, double *deviation)
{
    double sum = 0.0, square = 0.0;
    for (int i = 0; i < n; i++) sum += x[i];
    *mean = sum / n;
    for (int i = 0; i < n; i++) square += (x[i] - *mean) * (x[i] - *mean);
    *deviation = sqrt(square / n);
}


/* ---- one person ---- */

/* the asked girths again, from the triangles at the height of the landmark or contour that bears the measure */
static double cut_girth(const mus_body *body, int measure)
{
    static const struct {
        int measure, limb;
        const char *contour;
    } row[] = {
        {MUS_MEASURE_BUST, TORSO, "bust"},      {MUS_MEASURE_WAIST, TORSO, "waist"},
        {MUS_MEASURE_HIP, TORSO, "hip"},        {MUS_MEASURE_NECK, TORSO, "neck"},
        {MUS_MEASURE_HEAD, TORSO, "brow"},      {MUS_MEASURE_THIGH, LEG_LEFT, "thigh"},
        {MUS_MEASURE_CALF, LEG_LEFT, "calf"},   {MUS_MEASURE_ANKLE, LEG_LEFT, "ankle"},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        if (row[i].measure != measure) continue;
        for (int c = 0; c < mus_body_contour_count(body, row[i].limb); c++) {
            double points[9];
            slice section;
            if (strcmp(mus_body_contour_name(body, row[i].limb, c), row[i].contour) != 0) continue;
            if (mus_body_contour_points(body, row[i].limb, c, 3, points) != MUS_OK) return NAN;
            const bool met = measure == MUS_MEASURE_HIP ? slice_trunk(body, points[1] + 1e-9, &section)
                                                        : slice_limb(body, row[i].limb, points[1] + 1e-9, &section);
            return met ? section.girth : NAN;
        }
    }
    return NAN;
}


/* the body once more, of a sheet that names those lengths */
static void measure_named(mus_context *context, const ansur *table, int row, person *out)
{
    mus_tape *tape = ansur_tape(context, table, row);
    mus_body *body = NULL;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    for (int i = 0; i < NAMED; i++) out->named[i] = NAN;
    out->named_girth = out->named_seconds = NAN;
    if (tape == NULL || mus_tape_complete(tape) != MUS_OK) {
        mus_tape_destroy(tape);
        return;
    }
    const double up = mus_tape_value(tape, MUS_MEASURE_WAIST_HEIGHT) - 0.01 * ansur_value(table, row, "waist_h");
    const double crotch = 0.01 * ansur_value(table, row, "crotch_len") + 2.0 * up;
    const double span = 0.2 * mus_tape_value(tape, MUS_MEASURE_BUST);
    mus_status status = mus_tape_set(tape, MUS_MEASURE_CROTCH_LENGTH, crotch, MUS_SOURCE_GIVEN);
    if (status == MUS_OK && !out->male) status = mus_tape_set(tape, MUS_MEASURE_BUST_SPAN, span, MUS_SOURCE_GIVEN);
    const clock_t start = clock();
    if (status == MUS_OK) status = mus_body_create(context, tape, &def, &body);
    if (status == MUS_OK) {
        out->named_seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
        out->named_girth = 0.0;
        for (int i = 0; i < NAMED; i++)
            out->named[i] = mus_body_made(body, named[i]) - mus_body_asked(body, named[i]);
        for (int i = 0; i < ANSUR_MEASURES; i++) {
            const int m = ansur_measures[i].measure;
            out->named_girth = fmax(out->named_girth, fabs(mus_body_made(body, m) - mus_body_asked(body, m)));
        }
    }
    mus_body_destroy(body);
    mus_tape_destroy(tape);
}


static mus_status measure_person(mus_context *context, const ansur *table, int row, person *out)
{
    *out = (person){.male = ansur_male(table, row)};
    mus_tape *tape = ansur_tape(context, table, row);
    mus_body *body = NULL;
    if (tape == NULL) return MUS_ERR_TAPE;

    /* the shortest of three, as a person is made; then once more with the skin of a picture */
    mus_status status = MUS_OK;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    out->seconds = 1e30;
    for (int round = 0; round < 4 && status == MUS_OK; round++) {
        mus_body_destroy(body);
        def.plain = round < 3;
        const clock_t start = clock();
        status = mus_body_create(context, tape, &def, &body);
        const double spent = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (round == 3) out->drawn = spent;
        else if (spent < out->seconds) out->seconds = spent;
    }
    mus_tape_destroy(tape);
    if (status != MUS_OK) return status;

    for (int i = 0; i < ANSUR_MEASURES; i++) {
        const int m = ansur_measures[i].measure;
        const double asked = mus_body_asked(body, m);
        out->off[i] = mus_body_made(body, m) - asked;
        out->cut[i] = ansur_measures[i].height ? NAN : cut_girth(body, m) - asked;
    }
    for (int i = 0; i < LENGTHS; i++)
        out->length[i] = mus_body_made(body, lengths[i]) - mus_body_asked(body, lengths[i]);
    for (int i = 0; i < CALIPERS; i++) {
        slice section;
        const double y = 0.01 * ansur_value(table, row, calipers[i].height);
        slice_trunk(body, y, &section);
        const double made = calipers[i].kind == 'b'   ? section.breadth
                            : calipers[i].kind == 'd' ? section.depth
                                                      : section.girth;
        out->caliper[i] = 100.0 * made - ansur_value(table, row, calipers[i].column);
    }
    out->volume = mus_body_volume(body);
    out->litres_off = out->volume / ansur_volume(table, row) - 1.0;
    mus_body_destroy(body);
    measure_named(context, table, row, out);
    return MUS_OK;
}


/* ---- the page ---- */

static double *values; /* (rows) */

/* values of one sex (-1: of both), as many as `count` says */
#define GATHER(people, n, sex, expression)                                              \
    int count = 0;                                                                      \
    for (int i = 0; i < (n); i++) {                                                     \
        const person *p = &(people)[i];                                                 \
        const double value = (expression);                                              \
        const int of = p->male ? 1 : 0;                                                 \
        if (((sex) < 0 || of == (sex)) && isfinite(value)) values[count++] = value;     \
    }


static bool print_measures(const person *people, int n)
{
    bool good = true;
    printf("\nasked against made [mm]    worst   worst of slices\n");
    for (int m = 0; m < ANSUR_MEASURES; m++) {
        double worst = 0.0, cut = 0.0;
        int cuts = 0;
        for (int i = 0; i < n; i++) {
            if (!(fabs(people[i].off[m]) <= worst)) worst = fabs(people[i].off[m]);
            if (isnan(people[i].cut[m])) continue;
            cut = fmax(cut, fabs(people[i].cut[m]));
            cuts++;
        }
        printf("  %-20s %10.4f ", mus_measure_name(ansur_measures[m].measure), 1000.0 * worst);
        if (cuts > 0) printf("%10.4f of %d", 1000.0 * cut, cuts);
        printf("\n");
        good = good && worst <= (ansur_measures[m].height ? 0.002 : 0.001) && cut <= 0.001;
    }
    return good;
}


static bool print_lengths(const person *people, int n)
{
    bool good = true;
    printf("\nlengths made less asked [mm]  median   5 %%      95 %%\n");
    for (int m = 0; m < LENGTHS; m++) {
        GATHER(people, n, -1, 1000.0 * p->length[m])
        const double least = quantile(values, count, 0.0), most = quantile(values, count, 1.0);
        printf("  %-20s %13.2f %7.2f %7.2f\n", mus_measure_name(lengths[m]), quantile(values, count, 0.5),
               quantile(values, count, 0.05), quantile(values, count, 0.95));
        if (m < LENGTHS_FOLLOWED) good = good && least > -2.0 && most < 2.0;
    }
    return good;
}


static bool print_named(const person *people, int n)
{
    double girth = 0.0;
    printf("\nof sheets that name them [mm]   median   5 %%      95 %%    within 2 mm\n");
    for (int m = 0; m < NAMED; m++) {
        int close = 0;
        GATHER(people, n, -1, 1000.0 * p->named[m])
        for (int i = 0; i < count; i++) close += fabs(values[i]) < 2.0;
        printf("  %-20s %16.2f %7.2f %7.2f  %5.1f %% of %d\n", mus_measure_name(named[m]), quantile(values, count, 0.5),
               quantile(values, count, 0.05), quantile(values, count, 0.95), 100.0 * close / count, count);
    }
    GATHER(people, n, -1, 1000.0 * p->named_seconds)
    for (int i = 0; i < n; i++)
        if (people[i].named_girth > girth) girth = people[i].named_girth;
    printf("  girths and heights are off by %.4f mm at most; %.2f ms a body in the median\n", 1000.0 * girth,
           quantile(values, count, 0.5));
    return girth <= 0.001;
}


static bool print_volumes(const person *people, int n)
{
    bool good = true;
    printf("\nvolume against weight / 1.03 kg/l [%%]   median  median of |off|  95 %% of |off|   worst\n");
    for (int sex = -1; sex < 2; sex++) {
        GATHER(people, n, sex, 100.0 * p->litres_off)
        const double median = quantile(values, count, 0.5);
        for (int i = 0; i < count; i++) values[i] = fabs(values[i]);
        const double middle = quantile(values, count, 0.5), most = quantile(values, count, 0.95);
        printf("  %-34s %10.2f %16.2f %14.2f %7.1f\n", sex < 0 ? "all" : sex ? "men" : "women", median, middle, most,
               quantile(values, count, 1.0));
        if (sex < 0) good = fabs(median) <= 3.0 && most <= 12.0;
    }
    return good;
}


static void print_calipers(const person *people, int n)
{
    printf("\nnot asked, made less measured [cm]   women mean    sd     men mean    sd\n");
    for (int k = 0; k < CALIPERS; k++) {
        printf("  %-30s", calipers[k].what);
        for (int sex = 0; sex < 2; sex++) {
            double mean, deviation;
            GATHER(people, n, sex, p->caliper[k])
            mean_of(values, count, &mean, &deviation);
            printf("    %9.2f %6.2f", mean, deviation);
        }
        printf("\n");
    }
}


static bool print_times(const person *people, int n)
{
    GATHER(people, n, -1, 1000.0 * p->seconds)
    const double median = quantile(values, count, 0.5), most = quantile(values, count, 1.0);
    printf("\nCPU time of a plain body [ms]: median %.2f, 95 %% %.2f, worst %.2f", median,
           quantile(values, count, 0.95), most);
    for (int i = 0; i < n; i++) values[i] = 1000.0 * people[i].drawn;
    printf("; with skin, face, hands and feet: median %.2f\n", quantile(values, n, 0.5));
    return median < 5.0 && most < 20.0;
}


static void write_csv(const char *path, const ansur *table, const int *row, const person *people, int n)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fprintf(stderr, "people: cannot write %s\n", path);
        return;
    }
    fprintf(file, "id,ms,volume_l,volume_off_pct");
    for (int k = 0; k < CALIPERS; k++) fprintf(file, ",%s", calipers[k].what);
    fprintf(file, "\n");
    for (int i = 0; i < n; i++) {
        fprintf(file, "%s,%.3f,%.4f,%.3f", ansur_name(table, row[i]), 1000.0 * people[i].seconds,
                1000.0 * people[i].volume, 100.0 * people[i].litres_off);
        for (int k = 0; k < CALIPERS; k++) fprintf(file, ",%.3f", people[i].caliper[k]);
        fprintf(file, "\n");
    }
    fclose(file);
}


/* what a made body may miss a measure by: lengths 2 mm or, of those it does not follow, anything */
static double allowed(int32_t measure)
{
    for (int i = 0; i < LENGTHS; i++)
        if (lengths[i] == measure) return i < LENGTHS_FOLLOWED ? 0.002 : INFINITY;
    return measure == MUS_MEASURE_SHOULDER_SLOPE ? INFINITY : 0.001;
}


/* every table size: builds, and keeps girths and heights to 1 mm, the lengths that it follows to 2 mm */
static bool print_sizes(mus_context *context)
{
    int good = 0;
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        mus_tape *tape = NULL;
        mus_body *body = NULL;
        mus_status status = mus_tape_create(context, &tape);
        if (status == MUS_OK) status = mus_tape_set_size(tape, mus_tape_size_name(i));
        if (status == MUS_OK) status = mus_body_create(context, tape, NULL, &body);
        bool kept = status == MUS_OK;
        for (int32_t m = 0; m < mus_measure_count() && kept; m++)
            kept = !(fabs(mus_body_made(body, m) - mus_body_asked(body, m)) > allowed(m));
        if (status != MUS_OK) printf("%s refused: %s\n", mus_tape_size_name(i), mus_context_error(context));
        good += kept;
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    printf("table sizes: %d of %d built, girths and heights within 1 mm, shoulder, arm and elbow within 2 mm\n",
           good, (int)mus_tape_size_count());
    return good == mus_tape_size_count();
}


static bool run_people(mus_context *context, const ansur *table, const char *csv, int each)
{
    person *people = malloc(sizeof *people * (size_t)table->rows);
    int *row = malloc(sizeof *row * (size_t)table->rows), n = 0;
    values = malloc(sizeof *values * (size_t)table->rows);
    bool good = people != NULL && row != NULL && values != NULL;
    for (int i = 0; i < table->rows && good; i += each) {
        row[n] = i;
        if (measure_person(context, table, i, &people[n]) == MUS_OK)
            n++;
        else
            printf("%s refused: %s\n", ansur_name(table, i), mus_context_error(context));
    }
    if (good) {
        const int all = (table->rows + each - 1) / each;
        printf("people: %d of %d built, %.2f %% refused\n", n, all, 100.0 * (all - n) / all);
        good = all - n < 0.005 * all;
        good = print_sizes(context) && good;
        good = print_measures(people, n) && good;
        good = print_lengths(people, n) && good;
        good = print_named(people, n) && good;
        good = print_volumes(people, n) && good;
        print_calipers(people, n);
        good = print_times(people, n) && good;
        if (csv != NULL) write_csv(csv, table, row, people, n);
    }
    free(values);
    free(row);
    free(people);
    return good;
}


int main(int argc, char **argv)
{
    ansur table;
    mus_context *context = NULL;
    if (argc < 2 || !ansur_open(&table, argv[1])) {
        fprintf(stderr, "people: cannot read the table %s\n", argc < 2 ? "(none given)" : argv[1]);
        return 2;
    }
    const char *csv = NULL;
    int each = 1;
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--csv") == 0) csv = argv[i + 1];
        if (strcmp(argv[i], "--each") == 0) each = atoi(argv[i + 1]);
    }
    bool good = mus_context_create(NULL, &context) == MUS_OK && run_people(context, &table, csv, each > 0 ? each : 1);
    printf("%s\n", good ? "all figures hold" : "a figure does not hold");
    mus_context_destroy(context);
    ansur_close(&table);
    return good ? 0 : 1;
}
