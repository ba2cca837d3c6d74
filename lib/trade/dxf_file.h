/*
 * dxf_file.h: a DXF file of the garment trade in memory: its blocks, their entities, the texts of the style.
 *
 * Flow of a reader: dxf_file.c (text -> entities), dxf_read.c (which blocks are the pieces of the wanted size),
 * dxf_ring.c (lines of a layer -> one closed ring; mirror line, grading), dxf_panel.c (ring -> panel of the pattern),
 * dxf_name.c, rul_read.c (the grade rules beside the file). pattern_read.c calls it for every file that is no JSON.
 */
#ifndef MUS__TRADE_DXF_FILE_H
#define MUS__TRADE_DXF_FILE_H

#include <stdbool.h>

#include "exchange/file_read.h"

/* most entities and points of a file. Chosen: 10000 pieces of 100 entities, 200 outlines of the 20000 points that a
 * ring may have. They bound the memory of a file to 90 MB and 64 MB */
#define MUS__DXF_ENTITIES 1000000
#define MUS__DXF_VERTICES 4000000

enum { MUS__DXF_POINT, MUS__DXF_LINE, MUS__DXF_POLYLINE, MUS__DXF_TEXT };

/* a text of the file: `length` bytes, no zero byte behind them */
typedef struct mus__dxf_slice {
    const char *at;
    int32_t length;
} mus__dxf_slice;

typedef struct mus__dxf_entity {
    int32_t kind;   /* MUS__DXF_* */
    int32_t layer;  /* -1 for a name that is no number */
    int32_t first;  /* first of its points in xy */
    int32_t n;      /* number of points */
    bool closed;    /* a polyline that is closed */
    bool angled;    /* a point with an angle */
    double angle;   /* [degrees] from +x, counter-clockwise */
    mus__dxf_slice text;
    int64_t line;   /* of the file */
} mus__dxf_entity;

typedef struct mus__dxf_block {
    mus__dxf_slice name;
    int64_t line;
    int32_t first; /* first entity */
    int32_t n;
} mus__dxf_block;

typedef struct mus__dxf_file {
    const mus__source *source;
    int32_t nentity, nblock, nxy;
    int32_t entity_room, block_room, xy_room;
    mus__dxf_entity *entities; /* (nentity) */
    mus__dxf_block *blocks;    /* (nblock); the last one has the entities outside blocks */
    double *xy;                /* (nxy x 2), in the unit of the file */
    double unit;               /* [m] of the file's unit */
} mus__dxf_file;

/* true when the text begins as a DXF does: a group code 0 or 999 on its first line */
bool mus__dxf_begins(const char *text);
/* read all blocks and entities; the caller frees `file`, after a failure too */
mus_status mus__dxf_load(const mus__source *source, mus__dxf_file *file);
void mus__dxf_unload(mus__dxf_file *file);
/* the value of the first text "KEY: value" of a block, key in any case; length -1 without one */
mus__dxf_slice mus__dxf_value(const mus__dxf_file *file, const mus__dxf_block *block, const char *key);
/* copy a slice as UTF-8: \U+XXXX becomes its character, other bytes are taken for Latin-1 unless they are UTF-8 */
void mus__dxf_copy(mus__dxf_slice slice, char *out, size_t capacity);
/* true when both texts are equal, in any case */
bool mus__dxf_same(mus__dxf_slice a, mus__dxf_slice b);
/* read a number, also with a decimal comma; false when it is none or not finite */
bool mus__dxf_number(mus__dxf_slice slice, double *out);

#endif
