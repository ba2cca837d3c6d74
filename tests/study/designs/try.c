/*
 * try.c: see try.h.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "try.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define CHORDS 12
#define LINE 520 /* points of an edge; a facing has 513 at most */
#define MOST_CHORDS 4096
#define NOTCHES 64
#define NOTCH_OFF 1e-6   /* [m] notches that meet are so far apart at most */
#define NOTCH_NEAR 0.010 /* [m] two single notches nearer than this look like a double one, or a triple one */
#define END 1e-6         /* part of an edge: a notch this near to its end is at the end */
#define NOISE 1e-12 /* [m2]: 0.1 nm beside a chord of a centimetre */


int try_group(const mus_tape *tape)
{
    switch (mus_tape_sex(tape)) {
    case MUS_SEX_FEMALE:
        return MUS_GROUP_WOMEN;
    case MUS_SEX_MALE:
        return MUS_GROUP_MEN;
    case MUS_SEX_CHILD:
        return MUS_GROUP_CHILDREN;
    default:
        return 0;
    }
}


void try_reason(const char *text, char *key, int size)
{
    int n = 0;
    const char *colon = strstr(text, ": ");
    if (strncmp(text, "draft of ", 9) == 0 && colon != NULL) text = colon + 2;
    for (bool number = false; *text != '\0' && n + 1 < size; text++) {
        const bool digit = isdigit((unsigned char)*text) || (number && (*text == '.' || *text == 'e'));
        if (!digit || !number) key[n++] = digit ? '#' : *text;
        number = digit;
    }
    key[n] = '\0';
}


/* ---- notches ---- */

/* the notches of an edge, without those at its ends, which stand for joints, in the order of their places: arc lengths
 * (NOTCHES) from its start, or from its end when `turned`, as parts of its length, and kinds (NOTCHES). Returns their
 * number */
static int notches_of(const mus_pattern *pattern, int32_t edge, bool turned, double *t, int32_t *kind)
{
    int n = 0;
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern) && n < NOTCHES; i++) {
        int32_t own, k;
        double s;
        if (mus_pattern_notch(pattern, i, &own, &s, &k) != MUS_OK || own != edge) continue;
        const double part = s / mus_pattern_edge_length(pattern, edge), at = turned ? 1.0 - part : part;
        if (part < END || part > 1.0 - END) continue;
        int j = n++;
        for (; j > 0 && t[j - 1] > at; j--) t[j] = t[j - 1], kind[j] = kind[j - 1];
        t[j] = at, kind[j] = k;
    }
    return n;
}


/* are the notches of both edges of a seam the same in number, kind and place, none two in one place? */
static bool notches_meet(const mus_pattern *pattern, const mus_seam_def *seam)
{
    double a[NOTCHES], b[NOTCHES];
    int32_t kind_a[NOTCHES], kind_b[NOTCHES];
    const double la = mus_pattern_edge_length(pattern, seam->edge_a);
    const double lb = mus_pattern_edge_length(pattern, seam->edge_b);
    const int n = notches_of(pattern, seam->edge_a, false, a, kind_a);
    if (n != notches_of(pattern, seam->edge_b, seam->direction == MUS_SEAM_REVERSED, b, kind_b)) return false;
    for (int i = 0; i < n; i++) {
        if (kind_a[i] != kind_b[i] || fabs(a[i] - b[i]) * fmax(la, lb) > NOTCH_OFF) return false;
        if (i > 0 && (a[i] - a[i - 1]) * fmin(la, lb) < NOTCH_NEAR) return false;
    }
    return true;
}


/* ---- seams and darts ---- */

static void look_at_seams(const mus_pattern *pattern, design_try *out)
{
    for (int32_t s = 0; s < mus_pattern_seam_count(pattern); s++) {
        mus_seam_def seam;
        int32_t a[2], b[2];
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(pattern, s, &seam) != MUS_OK) continue;
        const double la = mus_pattern_edge_length(pattern, seam.edge_a);
        const double lb = mus_pattern_edge_length(pattern, seam.edge_b);
        out->seam = fmax(out->seam, fabs(lb - la - seam.ease));
        mus_pattern_edge_ends(pattern, seam.edge_a, &a[0], &a[1]);
        mus_pattern_edge_ends(pattern, seam.edge_b, &b[0], &b[1]);
        if (!notches_meet(pattern, &seam)) out->notches++, out->notch = s;
        const bool same = mus_pattern_edge_panel(pattern, seam.edge_a) == mus_pattern_edge_panel(pattern, seam.edge_b);
        const bool touch = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
        if (same && touch) out->dart = fmax(out->dart, fabs(la - lb));
    }
}


/* ---- outlines ---- */

static double side_of(const double *a, const double *b, const double *p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}


/* p and q lie on different sides of the line through a and b, by more than rounding */
static bool parted(const double *a, const double *b, const double *p, const double *q)
{
    const double s = side_of(a, b, p), t = side_of(a, b, q);
    return s * t < 0.0 && fabs(s) > NOISE && fabs(t) > NOISE;
}


static bool chords_cross(const double *a, const double *b, const double *c, const double *d)
{
    return parted(a, b, c, d) && parted(c, d, a, b);
}


/* every pair of chords of the outline that are no neighbours */
static bool outline_crosses(const mus_pattern *pattern, int32_t panel)
{
    double xy[2 * (MOST_CHORDS + 1)];
    const int32_t *edges, *forward;
    int32_t n, count = 0;
    if (mus_pattern_outline(pattern, panel, &n, &edges, &forward) != MUS_OK) return true;
    for (int32_t i = 0; i < n; i++) {
        double line[2 * LINE];
        int32_t points;
        if (mus_pattern_edge_polyline(pattern, edges[i], CHORDS, line, LINE, &points) != MUS_OK || points > LINE ||
            count + points > MOST_CHORDS)
            return true;
        for (int32_t k = 0; k < points - 1; k++, count++)
            memcpy(xy + 2 * count, line + 2 * (forward[i] > 0 ? k : points - 1 - k), 2 * sizeof *xy);
    }
    memcpy(xy + 2 * count, xy, 2 * sizeof *xy);
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = i + 2; k < count - (i == 0); k++)
            if (chords_cross(xy + 2 * i, xy + 2 * i + 2, xy + 2 * k, xy + 2 * k + 2)) return true;
    return false;
}


static void look_at_outlines(const mus_pattern *pattern, design_try *out)
{
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        if (!outline_crosses(pattern, p)) continue;
        out->crossings++;
        snprintf(out->crossing, sizeof out->crossing, "%s", mus_pattern_panel_name(pattern, p));
    }
}


/* ---- a draft ---- */

static double cpu(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


void try_draft(mus_context *context, int design, const mus_tape *tape, design_try *out, mus_pattern **kept)
{
    mus_pattern *pattern = NULL;
    *out = (design_try){.status = MUS_OK};
    const double start = cpu();
    out->status = mus_design_draft(context, design, tape, NULL, &pattern);
    out->seconds = cpu() - start;
    if (out->status != MUS_OK) {
        snprintf(out->text, sizeof out->text, "%s", mus_context_error(context));
    } else {
        out->panels = mus_pattern_panel_count(pattern);
        out->seams = mus_pattern_seam_count(pattern);
        look_at_seams(pattern, out);
        look_at_outlines(pattern, out);
        if (mus_pattern_cut_only(pattern) != NULL) look_at_outlines(mus_pattern_cut_only(pattern), out);
    }
    if (kept != NULL) *kept = pattern;
    else mus_pattern_destroy(pattern);
}
