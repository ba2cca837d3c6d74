/*
 * worn.c: garments made wrong on purpose, and what mus_fit_worn() says of them: `make worn`.
 *
 *     build/bin/worn DATA [--spacing MM] [--garment WORD] [--only simulated] [--right LIST]
 *
 * Ten garments, named designs and GarmentCode specifications of the folder DATA, are dressed. As they lie they are to
 * be right, but for triangles through the skin. Then nodes are moved: each row is one defect of one garment, with the
 * kind, the limb and the place that the certificate names. Exit 1 when a row is not named as it should be, or a
 * garment as it lies is objected to.
 *
 * Then come garments that are wrong by simulation: drafted for another person than they are sewn round, or with panels
 * that start at a wrong place. Nothing is moved by hand once they are sewn.
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
    {"wide_ankle", NULL, "W40", D(LEG_IN_BOTH) | D(INSIDE_OUT) | D(SLID) | D(ROLLED) | D(TIGHT) | D(BESIDE)},
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

/* garments wrong by simulation: drafted for the size `drafted` and sewn round another size `body`, with no edge
 * attached to it; panels with this label (NULL: none) start `by` [m] from where they belong; mirrored: front and back
 * are exchanged */
static const struct {
    const char *design, *drafted, *body, *label;
    double by[3];
    int32_t mirrored, kind, limb;
} simulated[] = {
    {"tshirt", "C92", "W40", NULL, {0, 0, 0}, 0, MUS_WORN_TIGHT, MUS_NONE},
    {"leggings", "C104", "M50", NULL, {0, 0, 0}, 0, MUS_WORN_TIGHT, MUS_NONE},
    {"straight_skirt_mini", "W52", "W34", NULL, {0, 0, 0}, 0, MUS_WORN_LOW, MUS_NONE},
    {"straight_trousers", "M58", "W34", NULL, {0, 0, 0}, 0, MUS_WORN_LOW, MUS_NONE}, /* the crotch alone holds them */
    {"corset_top", "W52", "W34", NULL, {0, 0, 0}, 0, MUS_WORN_LOW, MUS_NONE},
    {"knit_wide_long", "W52", "C116", NULL, {0, 0, 0}, 0, MUS_WORN_OPENING, MUS_NONE},
    {"tshirt", "W40", "W40", "arm", {0, 0, -0.35}, 0, MUS_WORN_OPENING, MUS_NONE},
    {"tee_crew", "W40", "W40", "arm", {0, 0, 0.35}, 0, MUS_WORN_OPENING, MUS_NONE},
    {"tshirt", "W40", "W40", NULL, {0, 0, 0}, 1, MUS_WORN_INSIDE_OUT, MUS_NONE},
    {"straight_trousers", "W40", "W40", NULL, {0, 0, 0}, 1, MUS_WORN_INSIDE_OUT, MUS_NONE},
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


/* moves the start of the panels of a simulated garment */
static void misplace(size_t row, mus_pattern *pattern)
{
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        mus_pattern_placement(pattern, p, &place);
        const char *label = mus_pattern_panel_label(pattern, p);
        if (simulated[row].label != NULL && strcmp(label, simulated[row].label) == 0)
            for (int32_t d = 0; d < 3; d++) place.origin[d] += simulated[row].by[d];

        /* half a turn about the vertical axis, and the wrong side out */
        for (int32_t d = 0; d < 3 && simulated[row].mirrored; d++) place.rotation[6 + d] = -place.rotation[6 + d];
        if (simulated[row].mirrored) {
            for (int32_t k = 0; k < 3; k++) place.rotation[3 * k + 2] = -place.rotation[3 * k + 2];
            place.origin[2] = -place.origin[2], place.bend = -place.bend;
        }
        mus_pattern_set_placement(pattern, p, &place);
    }
}


/* tape of a size */
static mus_status size_tape(mus_context *context, const char *size, mus_tape **out)
{
    const mus_status status = mus_tape_create(context, out);
    return status == MUS_OK ? mus_tape_set_size(*out, size) : status;
}


/* sews and settles the garment of a row from its misplaced start: places x of the nodes (caller frees), NULL with the
 * context's error */
static double *sew_wrong(mus_context *context, size_t row, const mus_cloth_def *cut, const dressed *d)
{
    mus_pattern *wrong = NULL;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_def def;
    double *x = NULL;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    mus_status status = mus_pattern_copy(d->pattern, &wrong);
    if (status == MUS_OK) misplace(row, wrong);
    if (status == MUS_OK) status = mus_cloth_create(context, wrong, cut, &cloth);
    if (status == MUS_OK) status = mus_drape_create(context, cloth, d->body, &def, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_sew(drape, NULL, NULL);
    if (status == MUS_OK || status == MUS_ERR_SEW) {
        if (status == MUS_OK) mus_drape_settle(drape, NULL, NULL);
        const size_t bytes = 3 * (size_t)mus_drape_node_count(drape) * sizeof *x;
        x = malloc(bytes);
        if (x != NULL) memcpy(x, mus_drape_positions(drape), bytes);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(wrong);
    return x;
}


/* the certificate of a simulated garment against the pattern as it should start */
static mus_status simulate(mus_context *context, size_t row, double spacing, dressed *d, mus_worn *worn)
{
    mus_tape *other = NULL;
    mus_cloth_def cut;
    memset(d, 0, sizeof *d);
    mus_worn_init(worn, sizeof *worn);
    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = spacing;
    mus_status status = size_tape(context, simulated[row].drafted, &other);
    if (status == MUS_OK) status = size_tape(context, simulated[row].body, &d->tape);
    if (status == MUS_OK) status = mus_body_create(context, d->tape, NULL, &d->body);
    if (status == MUS_OK)
        status = mus_design_draft(context, mus_design_find(simulated[row].design), other, NULL, &d->pattern);
    mus_tape_destroy(other);
    const bool foreign = strcmp(simulated[row].drafted, simulated[row].body) != 0;
    if (status == MUS_OK && foreign) status = mus_arrange_pattern(d->pattern, d->body);
    for (int32_t e = 0; status == MUS_OK && foreign && e < mus_pattern_edge_count(d->pattern); e++)
        status = mus_pattern_set_edge_hold(d->pattern, e, MUS_HOLD_NONE, 0.0);
    if (status == MUS_OK) status = mus_cloth_create(context, d->pattern, &cut, &d->cloth);
    if (status == MUS_OK) status = mus_drape_create(context, d->cloth, d->body, NULL, &d->drape);
    double *x = status == MUS_OK ? sew_wrong(context, row, &cut, d) : NULL;
    if (status == MUS_OK) status = x != NULL ? mus_drape_set_state(d->drape, x, NULL) : MUS_ERR_SEW;
    if (status == MUS_OK) status = mus_fit_worn(d->drape, d->pattern, d->body, worn);
    free(x);
    return status;
}


/* the table of garments wrong by simulation; returns the number that is not named */
static int simulations(mus_context *context, double spacing, const char *word)
{
    int rows = 0, named = 0;
    for (size_t row = 0; row < sizeof simulated / sizeof *simulated; row++) {
        dressed d;
        mus_worn worn;
        if (word != NULL && strstr(simulated[row].design, word) == NULL) continue;
        rows++;
        const mus_status status = simulate(context, row, spacing, &d, &worn);
        const bool good = status == MUS_OK && worn.kind == simulated[row].kind;
        named += good;
        printf("%-3s %-20s of %-4s on %-4s %s%s: %s\n", good ? "yes" : "NO", simulated[row].design,
               simulated[row].drafted, simulated[row].body, simulated[row].label != NULL ? "sleeves moved " : "",
               simulated[row].mirrored ? "mirrored" : "", status == MUS_OK ? worn.text : mus_context_error(context));
        fflush(stdout);
        dressed_free(&d);
    }
    printf("%d of %d garments wrong by simulation named\n", named, rows);
    return rows - named;
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
    bool sims = false; /* those wrong by simulation alone */
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--only") == 0) sims = strcmp(argv[i + 1], "simulated") == 0;
        else if (strcmp(argv[i], "--spacing") == 0) spacing = 0.001 * atof(argv[i + 1]);
        else if (strcmp(argv[i], "--garment") == 0) word = argv[i + 1];
        else if (strcmp(argv[i], "--right") == 0) list = argv[i + 1];
    }
    if (argc < 2 || mus_context_create(NULL, &context) != MUS_OK) {
        fputs("worn DATA [--spacing MM] [--garment WORD] [--only simulated] [--right LIST]\n", stderr);
        return 2;
    }
    int code = list != NULL ? lists(context, list, spacing) : 0;
    if (list == NULL && !sims) code = table(context, argv[1], spacing, word);
    if (list == NULL && simulations(context, spacing, word) > 0) code = 1;
    mus_context_destroy(context);
    return code;
}
