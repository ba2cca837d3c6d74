/*
 * sheet_tile.c: the windows of the tiles, and what meets a window.
 */
#include <math.h>
#include <string.h>

#include "print/sheet.h"

#define TILE_NAME 0.024 /* [m] upper left corner of a page that holds its name */


/* clip the segment to the box (Liang and Barsky 1984); true when a part of it is left: `part` (2) gets its ends, 0 at a
 * to 1 at b */
static bool segment_clip(const double *a, const double *b, const double *box, double *part)
{
    double from = 0.0, to = 1.0;
    for (int32_t k = 0; k < 2; k++)
        if ((a[k] < box[k] && b[k] < box[k]) || (a[k] > box[2 + k] && b[k] > box[2 + k])) return false;
    for (int32_t k = 0; k < 2; k++) {
        double d = b[k] - a[k];
        if (d == 0.0) {
            if (a[k] < box[k] || a[k] > box[2 + k]) return false;
            continue;
        }
        double t = (box[k] - a[k]) / d, u = (box[2 + k] - a[k]) / d;
        from = fmax(from, t < u ? t : u);
        to = fmin(to, t < u ? u : t);
    }
    part[0] = from;
    part[1] = to;
    return from <= to;
}


bool mus__segment_meets(const double *a, const double *b, const double *box)
{
    double part[2];
    return segment_clip(a, b, box, part);
}


bool mus__frame_meets(const mus__frame *frame, const double *a, const double *b, const double *box)
{
    double p[2][2];
    for (int32_t i = 0; i < 2; i++) {
        const double x = (i == 0 ? a : b)[0] - frame->x, y = (i == 0 ? a : b)[1] - frame->y;
        p[i][0] = x * frame->u[0] + y * frame->u[1];
        p[i][1] = y * frame->u[0] - x * frame->u[1];
    }
    return mus__segment_meets(p[0], p[1], box);
}


void mus__words_wall(double half, double *wall)
{
    wall[0] = -half - MUS__WORDS_CLEAR;
    wall[1] = -MUS__WORDS_CLEAR;
    wall[2] = half + MUS__WORDS_CLEAR;
    wall[3] = MUS__CAPTION_HEIGHT + MUS__WORDS_CLEAR;
}


bool mus__path_meets(const mus__drawing *drawing, const mus__path *path, const mus__frame *frame, const double *box)
{
    const double *xy = drawing->xy + path->at;
    double at[2] = {0.0, 0.0}, first[2] = {0.0, 0.0}, p[2];
    for (int32_t i = 0; i < path->nop; i++) {
        const unsigned char op = drawing->ops[path->op + i];
        double cubic[8] = {at[0], at[1], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        if (op == 'c') memcpy(cubic + 2, xy, 6 * sizeof *xy);
        for (int32_t k = 1; k <= (op == 'c' ? 8 : op == 'm' ? 0 : 1); k++) {
            if (op == 'c')
                mus__cubic_at(cubic, 0.125 * k, p);
            else
                memcpy(p, op == 'z' ? first : xy, sizeof p);
            if (frame != NULL ? mus__frame_meets(frame, at, p, box) : mus__segment_meets(at, p, box)) return true;
            memcpy(at, p, sizeof at);
        }
        if (op == 'm') memcpy(at, xy, sizeof at), memcpy(first, xy, sizeof first);
        xy += 2 * (op == 'c' ? 3 : op == 'z' ? 0 : 1);
    }
    return false;
}


/* grow a box by another */
static void run_add(double *box, const double *more)
{
    for (int32_t k = 0; k < 2; k++) {
        box[k] = more[k] < box[k] ? more[k] : box[k];
        box[2 + k] = more[2 + k] > box[2 + k] ? more[2 + k] : box[2 + k];
    }
}


int32_t mus__piece_runs(const mus__piece *piece, double *runs)
{
    static const double none[4] = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    int32_t n = 0;
    for (int32_t l = 0; l < piece->cut.nloop; l++) {
        const int32_t start = piece->cut.start[l], end = piece->cut.start[l + 1];
        for (int32_t group = start; group < end; group += MUS__RUN * MUS__RUN) {
            const int32_t whole = n++;
            if (runs != NULL) memcpy(runs + 4 * whole, none, sizeof none);
            for (int32_t first = group; first < end && first < group + MUS__RUN * MUS__RUN; first += MUS__RUN, n++) {
                if (runs == NULL) continue;
                double *run = runs + 4 * n;
                memcpy(run, none, sizeof none);
                for (int32_t i = first; i <= end && i <= first + MUS__RUN; i++) {
                    const double *p = piece->cut.xy + 2 * (i < end ? i : start), at[4] = {p[0], p[1], p[0], p[1]};
                    run_add(run, at);
                }
                run_add(runs + 4 * whole, run);
            }
        }
    }
    return n;
}


/* does no side of a run meet the box, or cross the line from its middle to the right? */
static bool run_is_apart(const double *run, const double *box, double mx, double my)
{
    return (run[0] > box[2] || run[2] < box[0] || run[1] > box[3] || run[3] < box[1]) &&
           (run[1] > my || run[3] < my || run[2] < mx);
}


bool mus__piece_meets(const mus__piece *piece, const double *runs, const double *box, double *at)
{
    double part[2];
    if (box[0] > piece->box[2] || box[2] < piece->box[0] || box[1] > piece->box[3] || box[3] < piece->box[1])
        return false;

    /* the middle of the box is inside when a line from it to the right crosses the cut line an odd number of times */
    const double mx = 0.5 * (box[0] + box[2]), my = 0.5 * (box[1] + box[3]);
    bool inside = false;
    for (int32_t l = 0; l < piece->cut.nloop; l++) {
        const int32_t start = piece->cut.start[l], end = piece->cut.start[l + 1];
        for (int32_t first = start; first < end; first += MUS__RUN) {
            if (runs != NULL && (first - start) % (MUS__RUN * MUS__RUN) == 0) {
                const double *group = runs;
                const int32_t left = (end - first + MUS__RUN - 1) / MUS__RUN, many = left < MUS__RUN ? left : MUS__RUN;
                runs += 4;
                if (run_is_apart(group, box, mx, my)) {
                    runs += 4 * many;
                    first += MUS__RUN * (many - 1);
                    continue;
                }
            }
            const double *run = runs;
            if (runs != NULL) runs += 4;
            if (run != NULL && run_is_apart(run, box, mx, my)) continue;
            for (int32_t i = first; i < end && i < first + MUS__RUN; i++) {
                const double *a = piece->cut.xy + 2 * i, *b = piece->cut.xy + 2 * (i + 1 < end ? i + 1 : start);
                if (segment_clip(a, b, box, part)) {
                    for (int32_t k = 0; k < 2 && at != NULL; k++) at[k] = a[k] + part[0] * (b[k] - a[k]);
                    return true;
                }
                if ((a[1] > my) != (b[1] > my) && mx < a[0] + (b[0] - a[0]) * (my - a[1]) / (b[1] - a[1]))
                    inside = !inside;
            }
        }
    }
    if (inside && at != NULL) at[0] = mx, at[1] = my;
    return inside;
}


bool mus__piece_inside(const mus__piece *piece, double x, double y)
{
    bool inside = false;
    for (int32_t i = 0; i < piece->nflat; i++) {
        const double *a = piece->flat + 2 * i, *b = piece->flat + 2 * ((i + 1) % piece->nflat);
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
}


bool mus__piece_holds(const mus__piece *piece, const double *box)
{
    for (int32_t k = 0; k < 2; k++)
        if (box[k] < piece->box[k] || box[2 + k] > piece->box[2 + k]) return false;
    for (int32_t i = 0; i < piece->nflat; i++)
        if (mus__segment_meets(piece->flat + 2 * i, piece->flat + 2 * ((i + 1) % piece->nflat), box)) return false;
    return mus__piece_inside(piece, 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3]));
}


void mus__tile_window(const mus_sheet *sheet, const mus__tile *tile, double *box)
{
    double margin = sheet->def.margin, overlap = sheet->def.overlap;
    double width = sheet->page[0] - 2.0 * margin, height = sheet->page[1] - 2.0 * margin;
    box[0] = tile->column * (width - overlap);
    box[3] = sheet->extent[1] - tile->row * (height - overlap);
    box[2] = box[0] + width;
    box[1] = box[3] - height;
}


int32_t mus__tile_find(const mus_sheet *sheet, int32_t column, int32_t row)
{
    for (int32_t i = 0; i < sheet->ntile; i++)
        if (sheet->tiles[i].column == column && sheet->tiles[i].row == row) return i;
    return MUS_NONE;
}


bool mus__tile_marked(const double *window, const double *box)
{
    /* the marks of a neighbour, at the middle of an edge, are as wide as the page's own name, and half as deep */
    for (int32_t d = 0; d < 2; d++) {
        const double middle = 0.5 * (window[d] + window[2 + d]), deep = 0.5 * TILE_NAME;
        if (box[d] > middle + TILE_NAME || box[2 + d] < middle - TILE_NAME) continue;
        if (box[1 - d] < window[1 - d] + deep || box[3 - d] > window[3 - d] - deep) return true;
    }
    return box[0] < window[0] + TILE_NAME && box[3] > window[3] - TILE_NAME;
}


bool mus__page_holds(const mus_sheet *sheet, const double *box, bool plain)
{
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double window[4];
        mus__tile_window(sheet, &sheet->tiles[i], window);
        const bool in = box[0] >= window[0] && box[1] >= window[1] && box[2] <= window[2] && box[3] <= window[3];
        if (in && !(plain && sheet->tiled && mus__tile_marked(window, box))) return true;
    }
    return false;
}


bool mus__pages_show(const mus_sheet *sheet, const double *box)
{
    for (int32_t k = 0; k < 5; k++) {
        const double x = k == 4 ? 0.5 * (box[0] + box[2]) : box[k % 2 * 2];
        const double y = k == 4 ? 0.5 * (box[1] + box[3]) : box[1 + k / 2 * 2];
        const double point[4] = {x, y, x, y};
        if (!mus__page_holds(sheet, point, false)) return false;
    }
    return true;
}
