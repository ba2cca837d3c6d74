/*
 * paper.c: sizes of paper, and the check that margins and overlap leave enough of it.
 */
#include <math.h>

#include "print/page.h"

#define POINT (0.0254 / 72.0) /* [m] a PostScript point */
#define ROLL_LONGEST 14000.0  /* [points] longest page of a roll; the limit of PDF is 14400, which is 5.08 m */
#define ROLL_SHORTEST 850.0   /* [points] shortest page of a roll, 0.3 m: chosen, about the height of A4 */
#define PRINTED_LEAST 0.05    /* [m] least width between the margins; chosen: narrower strips of pieces are of no use */

/* width and height in portrait [points], within 0.1 mm of the ISO sizes. Whole points keep the scale true: some
 * programs round the size of a page up and then shrink it to the paper (pdftocairo does, by 0.12 % on 595.28) */
static const double papers[][2] = {
    [MUS_PAPER_A4] = {595, 842},   [MUS_PAPER_LETTER] = {612, 792},           [MUS_PAPER_A3] = {842, 1191},
    [MUS_PAPER_A0] = {2384, 3370}, [MUS_PAPER_ROLL] = {2591, ROLL_LONGEST},
};


void mus__paper_size(int32_t paper, double *out)
{
    out[0] = papers[paper][0] * POINT;
    out[1] = papers[paper][1] * POINT;
}


double mus__roll_length(double length)
{
    return POINT * fmin(ROLL_LONGEST, fmax(ROLL_SHORTEST, ceil(length / POINT)));
}


mus_status mus__paper_check(const mus_sheet *sheet)
{
    const mus_sheet_def *def = &sheet->def;
    static const char *const names[] = {"A4", "Letter", "A3", "A0", "roll"};
    double narrow = papers[def->paper][0] * POINT - 2.0 * def->margin;
    if (narrow >= PRINTED_LEAST && narrow >= 2.0 * def->overlap) return MUS_OK;
    char margin[32], overlap[32], left[32], least[32];
    mus__print_millimetres(margin, sizeof margin, def->margin);
    mus__print_millimetres(overlap, sizeof overlap, def->overlap);
    mus__print_millimetres(left, sizeof left, narrow > 0.0 ? narrow : 0.0);
    mus__print_millimetres(least, sizeof least, PRINTED_LEAST);
    return mus__file_fail(sheet->context, MUS_ERR_ARG,
                          "paper %s: margin %s mm leaves %s mm of its width to print on; at least %s mm and twice the "
                          "overlap of %s mm must be left", names[def->paper], margin, left, least, overlap);
}
