/*
 * muslin/layout.h: pieces on the cloth: where each is cut, and how many metres that takes.
 *
 * A layout has the pieces of one material of a pattern, with their allowances, on cloth of a given width: open or
 * folded lengthwise, with or without nap. The cloth runs along x from 0 on; y goes across it, from the fold or the
 * selvedge at 0. The grain of each piece runs along the cloth. Outlines that come from elsewhere are laid by the same
 * search.
 *
 * Units: metre, radian. The result depends on pieces, options and seed alone: neither on time nor on threads.
 */
#ifndef MUSLIN_LAYOUT_H
#define MUSLIN_LAYOUT_H

#include "muslin/base.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Called now and then during a search, on the caller's thread, with the part that is done (0 to 1) and the length so
 * far [m]. A value other than 0 ends the search with the best layout so far, which then depends on time. */
typedef int32_t (*mus_layout_progress_fn)(void *user, double done, double length);

/** Options of a layout. */
typedef struct mus_layout_def {
    size_t size;
    double width;     /* of the cloth from selvedge to selvedge [m], 0.01 to 1e5, default 1.4 */
    double gap;       /* least distance of two cut lines [m], 0 to 0.1, default 0.002 */
    double allowance; /* of edges without an allowance of their own [m], 0 to 0.1, default 0.01 */
    int32_t material; /* MUS_MATERIAL_*, default MUS_MATERIAL_MAIN */
    int32_t fold;     /* nonzero: the cloth is folded lengthwise, right sides together, and cut through two layers;
                       * default 0: open */
    int32_t nap;      /* nonzero: pile, or a print with an up and a down: no piece is turned round; default 0 */
    double tolerance; /* by which the grain of a piece may leave that of the cloth [rad], 0 to 0.2, default 0 */
    double stripe;    /* distance of stripes across the cloth [m], 0 (none, default) or 0.001 to 10: the lowest point of
                       * each piece, as the panel is drawn, lies on a stripe, so that hems match */
    int64_t steps;    /* elementary steps of each run, 1e5 to 1e13, default 1e9: about a second */
    int32_t runs;     /* searches from seeds of their own, of which the shortest layout is taken, 1 to 64, default 1 */
    int32_t threads;  /* that share the runs, 1 to 64, default 1 */
    uint64_t seed;    /* default 1 */
    mus_layout_progress_fn progress; /* NULL (default): none */
    void *user;       /* handed to progress */
} mus_layout_def;

/** Write the defaults of a layout's options; `size` is sizeof(mus_layout_def). */
MUS_API void mus_layout_def_init(mus_layout_def *def, size_t size);

/** Pieces on cloth. A layout does not change once it is made, and does not need the pattern any more. */
typedef struct mus_layout mus_layout;

/**
 * Lay the pieces of a pattern, and those that are cut and not draped (mus_pattern_cut_only()), on cloth.
 *
 * On folded cloth a mirrored pair, or two pieces that are symmetric, are cut at once through both layers, and a single
 * symmetric piece lies as a half on the fold. A single piece without symmetry, and one that is too wide for the folded
 * cloth, is cut from opened cloth behind the folded part; or through both layers, which gives one to spare, when all
 * of these together take less cloth so. A piece is symmetric when its cut line and notches are their own mirror images
 * in a line along the grain. Across the grain does for two pieces without nap: one of them is turned by half a turn.
 * `def` NULL takes the defaults. A material that no piece is cut of gives a layout without pieces, of length 0.
 * Errors:  MUS_ERR_ARG (value out of range; a piece wider than the cloth), MUS_ERR_PATTERN (a fault of the pattern),
 *          MUS_ERR_LIMIT (more than 2000 pieces), MUS_ERR_VERSION, MUS_ERR_MEMORY. *out is NULL then
 * Memory:  *out is the caller's: mus_layout_destroy(). 16 n^2 bytes a run for n pieces while it is made
 * Cost:    def.steps times def.runs, about 1 ns each; twice that where single pieces are tried both ways. Fewer when
 *          ten attempts in a row make the layout no shorter
 * Source:  Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research, 2025
 */
MUS_API mus_status mus_layout_create(mus_context *context, const mus_pattern *pattern, const mus_layout_def *def,
                                     mus_layout **out);

/** An outline to be laid, given in points. */
typedef struct mus_layout_item {
    size_t size;
    int32_t n;           /* number of points, 3 to 100000 */
    const double *xy;    /* (n x 2) a simple polygon, either way round, within 1e7 of the origin */
    int32_t count;       /* how many are laid, default 1 */
    int32_t turn_count;  /* 0 (default): as drawn, and by half a turn without def.nap; else the number of `turns` */
    const double *turns; /* (turn_count) [rad] counter-clockwise; a multiple of a quarter turn is exact */
} mus_layout_item;

/** Zero `item`, write the defaults and its size. */
MUS_API void mus_layout_item_init(mus_layout_item *item, size_t size);

/**
 * Lay outlines on open cloth: `count` items (1 or more). def.allowance, material and fold are not read.
 *
 * x is along the cloth. With a gap of 0 outlines may lie as near as they can without sharing a point.
 * Errors:  MUS_ERR_ARG (value out of range, an outline wider than the cloth or without area), MUS_ERR_LIMIT (more than
 *          2000 pieces), MUS_ERR_VERSION, MUS_ERR_MEMORY. *out is NULL then
 * Memory, Cost, Source: as mus_layout_create()
 */
MUS_API mus_status mus_layout_create_items(mus_context *context, int32_t count, const mus_layout_item *items,
                                           const mus_layout_def *def, mus_layout **out);

/** Free a layout; NULL is accepted. */
MUS_API void mus_layout_destroy(mus_layout *layout);

/** The context that the layout was made from; NULL for NULL. */
MUS_API mus_context *mus_layout_context(const mus_layout *layout);

/** Width of the cloth [m]; 0 for NULL. */
MUS_API double mus_layout_width(const mus_layout *layout);

/** Length of cloth that the layout takes [m]; 0 for NULL. */
MUS_API double mus_layout_length(const mus_layout *layout);

/** Length of its folded part, from x = 0 on [m]; 0 for open cloth. */
MUS_API double mus_layout_folded(const mus_layout *layout);

/** Part of the cloth, 0 to 1, that the pieces cover; a piece to spare does not count. */
MUS_API double mus_layout_utilisation(const mus_layout *layout);

/** Elementary steps that the search took. */
MUS_API int64_t mus_layout_steps(const mus_layout *layout);

/** A piece as it lies on the cloth. */
typedef struct mus_layout_piece {
    size_t size;
    int32_t panel;    /* index in the pattern; those of mus_pattern_cut_only() follow its own panels. Index of the item
                       * for a layout of items */
    const char *name; /* of the panel; borrowed until the layout is destroyed. "" for a layout of items */
    int32_t mirrored; /* nonzero: cut turned over. On folded cloth: as it lies on the upper layer */
    int32_t turned;   /* nonzero: by half a turn: its upper end, along the grain as drawn, is towards x = 0 */
    int32_t layers;   /* 2: cut through both layers of folded cloth; 1: one layer, or half of it on the fold */
    int32_t on_fold;  /* nonzero: a half, which lies with its middle on the fold (y = 0) */
    int32_t spare;    /* nonzero: one of the two that are cut is not needed */
    double turn[4];   /* from the plane of the panel to the cloth: x = turn[0] u + turn[1] v + shift[0], */
    double shift[2];  /* y = turn[2] u + turn[3] v + shift[1] [m] */
    int32_t n;        /* number of points of the outline */
    const double *xy; /* (n x 2) cut line on the cloth [m], the half of a piece on the fold; borrowed as the name */
} mus_layout_piece;

/** Zero `piece` and write its size. */
MUS_API void mus_layout_piece_init(mus_layout_piece *piece, size_t size);

/** Number of pieces that lie on the cloth; one that is cut through two layers counts once. */
MUS_API int32_t mus_layout_piece_count(const mus_layout *layout);

/** Get piece `piece`. Errors: MUS_ERR_ARG (no such piece), MUS_ERR_VERSION. */
MUS_API mus_status mus_layout_piece_get(const mus_layout *layout, int32_t piece, mus_layout_piece *out);

#ifdef __cplusplus
}
#endif

#endif
