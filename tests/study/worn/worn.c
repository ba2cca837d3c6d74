/*
 * worn.c: garments made wrong on purpose, and what mus_fit_worn() says of them: `make worn`.
 *
 *     build/bin/worn DATA [--spacing MM] [--garment WORD] [--right LIST]
 *
 * Ten garments, named designs and GarmentCode specifications of the folder DATA, are dressed. As they lie they are to
 * be right, but for triangles through the skin. Then nodes are moved: each row is one defect of one garment, with the
 * kind, the limb and the place that the certificate names. Exit 1 when a row is not named as it should be, or a
 * garment as it lies is objected to.
 *
 * --right LIST: dress instead the garments of a file, "NAME PATTERN TAPE" a line (PATTERN a file or a design), and
 * print what the certificate says of each; the pictures say whether that is so.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"

enum {
    OVER_HEAD,
    ARM_BESIDE,
    LEG_IN_BOTH,
    INSIDE_OUT,
    HOOD_ASIDE,
    OFF_SHOULDER,
    SLID,
    ROLLED,
    THROUGH,
    TIGHT,
    BESIDE,
    ARM_IN,
    HALF_ON,
    DEFECTS
};

static const struct {
    const char *name;
    int32_t kind, limb; /* limb MUS_NONE: any */
} defects[DEFECTS] = {
    {"drawn up over the head", MUS_WORN_OPENING, MUS_NONE},
    {"left arm beside its sleeve", MUS_WORN_OPENING, MUS_WORN_ARM_LEFT},
    {"both legs in the right trouser leg", MUS_WORN_OPENING, MUS_WORN_LEG_LEFT},
    {"inside out", MUS_WORN_INSIDE_OUT, MUS_NONE},
    {"hood beside the head", MUS_WORN_HOOD, MUS_WORN_NECK},
    {"off the left shoulder", MUS_WORN_SHOULDER, MUS_WORN_ARM_LEFT},
    {"slid down", MUS_WORN_LOW, MUS_NONE},
    {"hem rolled up", MUS_WORN_ROLLED, MUS_NONE},
    {"4 cm forwards, through the body", MUS_WORN_THROUGH, MUS_NONE},
    {"twice as wide as it was cut", MUS_WORN_TIGHT, MUS_NONE},
    {"beside the body", MUS_WORN_OPENING, MUS_NONE},
    {"left arm inside the garment", MUS_WORN_OPENING, MUS_WORN_ARM_LEFT},
    {"both arms in the garment", MUS_WORN_OPENING, MUS_WORN_ARM_LEFT},
};

#define D(defect) (1 << (defect))
static const struct {
    const char *name, *file, *body; /* file NULL: a design, body: a table size */
    int32_t defects;
} garments[] = {
    {"tee_crew", NULL, "W40",
     D(OVER_HEAD) | D(ARM_BESIDE) | D(INSIDE_OUT) | D(OFF_SHOULDER) | D(ROLLED) | D(THROUGH) | D(BESIDE)},
    {"hoodie", NULL, "W40", D(OVER_HEAD) | D(ARM_BESIDE) | D(HOOD_ASIDE) | D(ROLLED) | D(BESIDE)},
    {"tank", NULL, "M50", D(OVER_HEAD) | D(INSIDE_OUT) | D(OFF_SHOULDER) | D(ROLLED) | D(THROUGH) | D(ARM_IN)},
    {"straight_trousers", NULL, "W40", D(LEG_IN_BOTH) | D(INSIDE_OUT) | D(SLID) | D(ROLLED) | D(TIGHT) | D(BESIDE)},
    {"gored4_skirt_midi", NULL, "W40", D(INSIDE_OUT) | D(SLID) | D(ROLLED) | D(TIGHT) | D(BESIDE) | D(HALF_ON)},
    {"corset_top", NULL, "W40", D(INSIDE_OUT) | D(SLID) | D(THROUGH) | D(TIGHT) | D(BESIDE) | D(HALF_ON)},
    {"d11_006_mean_all", "specs", "mean_all",
     D(OVER_HEAD) | D(ARM_IN) | D(HOOD_ASIDE) | D(ROLLED) | D(THROUGH) | D(BESIDE)},
    {"d11_002_mean_all", "specs", "mean_all", D(INSIDE_OUT) | D(SLID) | D(TIGHT) | D(BESIDE) | D(HALF_ON) | D(THROUGH)},
    {"d11_014_m_smpl_average_A40", "specs", "m_smpl_average_A40",
     D(LEG_IN_BOTH) | D(INSIDE_OUT) | D(OFF_SHOULDER) | D(THROUGH) | D(ARM_IN) | D(BESIDE)},
    {"shirt_mean", "originals", "mean_all",
     D(OVER_HEAD) | D(ARM_BESIDE) | D(INSIDE_OUT) | D(OFF_SHOULDER) | D(ROLLED) | D(BESIDE)},
};

typedef struct dressed {
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_reason why;
    double seconds;
} dressed;


static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}


/* tape, body and pattern of a garment, sewn and at rest. Errors are those of the library, printed */
static bool dress_garment(mus_context *context, const char *pattern, const char *tape, double spacing, dressed *out)
{
    mus_dress_def def;
    memset(out, 0, sizeof *out);
    mus_reason_init(&out->why, sizeof out->why);
    mus_dress_def_init(&def, sizeof def);
    def.spacing = spacing;
    def.self_contact = 1;
    mus_status status;
    if (strchr(tape, '.') != NULL)
        status = mus_tape_read(context, tape, NULL, &out->tape);
    else if ((status = mus_tape_create(context, &out->tape)) == MUS_OK)
        status = mus_tape_set_size(out->tape, tape);
    if (status == MUS_OK) status = mus_body_create(context, out->tape, NULL, &out->body);
    if (status == MUS_OK)
        status = strchr(pattern, '.') != NULL
                     ? mus_pattern_read(context, pattern, &out->pattern)
                     : mus_design_draft(context, mus_design_find(pattern), out->tape, NULL, &out->pattern);
    const double start = cpu_seconds();
    if (status == MUS_OK)
        mus_dress(context, out->pattern, out->body, &def, NULL, &out->why, &out->cloth, &out->drape);
    out->seconds = cpu_seconds() - start;
    if (out->drape == NULL) printf("%s: %s\n", pattern, mus_context_error(context));
    return out->drape != NULL;
}


static void dressed_free(dressed *d)
{
    mus_drape_destroy(d->drape);
    mus_cloth_destroy(d->cloth);
    mus_pattern_destroy(d->pattern);
    mus_body_destroy(d->body);
    mus_tape_destroy(d->tape);
}


/* the middle of the trunk at the hip, the shoulder joint on the left, the crotch, and the crown, by `low` and `high` of
 * the cloth */
typedef struct sights {
    double hip[3], joint[3], crotch[3], crown[3], low, high;
} sights;


/* place x (3) of a node of a panel with this label in a defect */
static void move_node(int32_t defect, const sights *s, const char *label, double *x)
{
    const double from_z = s->hip[2];
    const bool sleeve = strcmp(label, "arm") == 0 && x[0] > 0.0;
    const bool hood = strcmp(label, "hood") == 0;
    switch (defect) {
    case OVER_HEAD: x[1] += 0.6; break;
    case ARM_BESIDE:
        if (sleeve) x[2] -= 0.3;
        break;
    case LEG_IN_BOTH:
        if (x[1] < s->crotch[1] - 0.02 && x[0] > 0.0) x[0] -= 0.22;
        break;
    case INSIDE_OUT: x[2] = 2.0 * from_z - x[2]; break;
    case HOOD_ASIDE:
        if (hood && x[1] > s->joint[1] + 0.08)
            x[1] = s->joint[1] + 0.08 + 0.2 * (x[1] - s->joint[1] - 0.08), x[2] -= 0.1;
        break;
    case OFF_SHOULDER:
        if (x[1] > s->joint[1] - 0.10 && x[0] > 0.02) x[0] += 0.16, x[1] -= 0.08;
        break;
    case SLID: x[1] -= 0.35; break;
    case ROLLED:
        if (s->high < s->joint[1] - 0.15) x[1] = s->high - 0.4 * (s->high - x[1]);
        else if (strcmp(label, "arm") != 0 && x[1] < s->joint[1] - 0.05)
            x[1] = s->joint[1] - 0.05 - 0.05 * (s->joint[1] - 0.05 - x[1]);
        break;
    case THROUGH: x[2] += 0.04; break;
    case TIGHT: x[2] = from_z + 6.0 * (x[2] - from_z); break;
    case BESIDE: x[0] += 1.6; break;
    case ARM_IN:
        if (x[1] > s->joint[1] - 0.3 && x[0] > 0.06) x[0] += 0.7;
        break;
    case HALF_ON: x[0] *= 6.0; break;
    default: break;
    }
}


/* the certificate of a garment with a defect (DEFECTS: as it lies) */
static mus_status certify(mus_context *context, const dressed *d, int32_t defect, mus_worn *out, double *seconds)
{
    const int32_t n = mus_drape_node_count(d->drape);
    const double *at = mus_drape_positions(d->drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    mus_drape *wrong = NULL;
    sights s = {.low = 1e9, .high = -1e9};
    mus_worn_init(out, sizeof *out);
    if (x == NULL) return MUS_ERR_MEMORY;
    memcpy(x, at, 3 * (size_t)n * sizeof *x);
    mus_body_landmark(d->body, MUS_LANDMARK_HIP, s.hip);
    mus_body_landmark(d->body, MUS_LANDMARK_SHOULDER_LEFT, s.joint);
    mus_body_landmark(d->body, MUS_LANDMARK_CROTCH, s.crotch);
    mus_body_landmark(d->body, MUS_LANDMARK_CROWN, s.crown);
    for (int32_t i = 0; i < n; i++) s.low = fmin(s.low, x[3 * i + 1]), s.high = fmax(s.high, x[3 * i + 1]);
    for (int32_t i = 0; i < n && defect < DEFECTS; i++) {
        const int32_t panel = mus_cloth_node_panels(d->cloth)[i];
        move_node(defect, &s, mus_pattern_panel_label(d->pattern, panel), x + 3 * (ptrdiff_t)i);
    }
    mus_status status = mus_drape_create(context, d->cloth, d->body, NULL, &wrong);
    if (status == MUS_OK) status = mus_drape_set_state(wrong, x, NULL);
    const double start = cpu_seconds();
    if (status == MUS_OK) status = mus_fit_worn(wrong, d->pattern, d->body, out);
    *seconds = cpu_seconds() - start;
    mus_drape_destroy(wrong);
    free(x);
    return status;
}


static bool is_right(const mus_worn *worn)
{
    return worn->kind == MUS_WORN_YES || worn->kind == MUS_WORN_THROUGH;
}


/* one row; returns whether the certificate names the defect */
static bool print_row(const char *name, int32_t defect, const mus_worn *worn, double seconds)
{
    bool named = is_right(worn);
    if (defect < DEFECTS) {
        const int32_t limb = defects[defect].limb;
        named = worn->kind == defects[defect].kind && (limb == MUS_NONE || worn->limb == limb);

        /* a hood that is pushed down may shut the face in too */
        if (defect == HOOD_ASIDE) named |= worn->kind == MUS_WORN_OPENING && worn->limb == limb;
        if (defect == THROUGH) named &= worn->through_depth > 0.01;
    }
    printf("%-3s %-28s %-36s (%5.2f %5.2f %5.2f) %5d crossings, %5.1f mm, %6.1f cm2, %3.0f ms  %s\n",
           named ? "yes" : "NO", name, defect == DEFECTS ? "as it lies" : defects[defect].name, worn->place[0],
           worn->place[1], worn->place[2], (int)worn->through, 1000.0 * worn->through_depth,
           1e4 * worn->through_area, 1000.0 * seconds,
           worn->kind == MUS_WORN_YES ? "worn" : worn->text);
    fflush(stdout);
    return named;
}


/* the table of defects */
static int table(mus_context *context, const char *data, double spacing, const char *word)
{
    int rows = 0, named = 0, lying = 0, right = 0;
    double check = 0.0, drape = 0.0;
    for (size_t g = 0; g < sizeof garments / sizeof *garments; g++) {
        char pattern[1024], tape[1024];
        dressed d;
        if (word != NULL && strstr(garments[g].name, word) == NULL) continue;
        if (garments[g].file == NULL) {
            snprintf(pattern, sizeof pattern, "%s", garments[g].name);
            snprintf(tape, sizeof tape, "%s", garments[g].body);
        } else {
            snprintf(pattern, sizeof pattern, "%s/garmentcode/%s/%s_specification.json", data, garments[g].file,
                     garments[g].name);
            snprintf(tape, sizeof tape, "%s/garmentcode/bodies/%s.yaml", data, garments[g].body);
        }
        const bool on = dress_garment(context, pattern, tape, spacing, &d);
        rows += !on;
        for (int32_t defect = DEFECTS; on && defect >= 0; defect--) {
            mus_worn worn;
            double seconds = 0.0;
            if (defect < DEFECTS && (garments[g].defects >> defect & 1) == 0) continue;
            if (certify(context, &d, defect, &worn, &seconds) != MUS_OK) {
                printf("%s: %s\n", garments[g].name, mus_context_error(context));
                rows++;
                continue;
            }
            const bool good = print_row(garments[g].name, defect, &worn, seconds);
            if (defect == DEFECTS) lying++, right += good, check += seconds, drape += d.seconds;
            else rows++, named += good;
        }
        dressed_free(&d);
    }
    printf("%d of %d defects named; %d of %d garments as they lie without an objection; the check costs %.1f %% of a "
           "drape\n", named, rows, right, lying, drape > 0.0 ? 100.0 * check / drape : 0.0);
    return named == rows && right == lying ? 0 : 1;
}


/* what the certificate says of the garments of a list */
static int lists(mus_context *context, const char *path, double spacing)
{
    char name[256], pattern[1024], tape[1024];
    int all = 0, settled = 0, right = 0, whole = 0;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        printf("%s cannot be read\n", path);
        return 2;
    }
    while (fscanf(file, "%255s %1023s %1023s", name, pattern, tape) == 3) {
        dressed d;
        mus_worn worn;
        double seconds = 0.0;
        all++;
        if (dress_garment(context, pattern, tape, spacing, &d) &&
            certify(context, &d, DEFECTS, &worn, &seconds) == MUS_OK) {
            print_row(name, DEFECTS, &worn, seconds);
            settled += d.why.kind == MUS_REASON_SETTLED || d.why.kind == MUS_REASON_NOT_WORN;
            right += d.why.kind == MUS_REASON_SETTLED && is_right(&worn);
            whole += d.why.kind == MUS_REASON_SETTLED && worn.kind == MUS_WORN_YES;
        }
        dressed_free(&d);
    }
    fclose(file);
    printf("%d garments: %d at rest, %d of them worn but for triangles through the skin, %d worn and nothing through "
           "it\n", all, settled, right, whole);
    return 0;
}


int main(int argc, char **argv)
{
    const char *word = NULL, *list = NULL;
    double spacing = 0.02;
    mus_context *context;
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--spacing") == 0) spacing = 0.001 * atof(argv[i + 1]);
        else if (strcmp(argv[i], "--garment") == 0) word = argv[i + 1];
        else if (strcmp(argv[i], "--right") == 0) list = argv[i + 1];
    }
    if (argc < 2 || mus_context_create(NULL, &context) != MUS_OK) {
        fputs("worn DATA [--spacing MM] [--garment WORD] [--right LIST]\n", stderr);
        return 2;
    }
    const int code = list != NULL ? lists(context, list, spacing) : table(context, argv[1], spacing, word);
    mus_context_destroy(context);
    return code;
}
