/*
 * svg_panel.h: what an SVG says of one panel, and the panel of the pattern that it becomes.
 */
#ifndef MUS_TRADE_SVG_PANEL_H
#define MUS_TRADE_SVG_PANEL_H

#include "trade/svg_path.h"

enum { MUS__SVG_EDGE, MUS__SVG_OUTLINE, MUS__SVG_GRAIN, MUS__SVG_MARK, MUS__SVG_NOTCH };

#define MUS__SVG_NAME 128 /* bytes of a name with its end; the pattern's limit */

/* one path of a panel */
typedef struct mus__svg_item {
    int32_t kind; /* MUS__SVG_EDGE ... */
    int64_t line; /* of the file */
    mus__svg_path path; /* [m] in the plane of the panel */
    char id[MUS__SVG_NAME], name[MUS__SVG_NAME], label[MUS__SVG_NAME];
    char edge[MUS__SVG_NAME]; /* of a notch: id of its edge, "" for the nearest */
    double s;                 /* [m] of a notch, NaN: the nearest place */
    double notch;             /* kind of a notch */
    double allowance;         /* [m], NaN: none given */
    int32_t made;             /* edge of the pattern, MUS_NONE */
} mus__svg_item;

typedef struct mus__svg_panel {
    char name[MUS__SVG_NAME], label[MUS__SVG_NAME], mirror_of[MUS__SVG_NAME];
    const char *word; /* edges in the order of the outline, from 1, minus: against; NULL: in the order of the file */
    double cut[MUS_MATERIAL_COUNT], layer;
    double origin[2]; /* [m] of the panel's plane on the sheet, y up */
    int64_t line;
    int32_t n, room;
    mus__svg_item *items;
} mus__svg_panel;

/* adds the panel to the pattern; *out is its index */
mus_status mus__svg_panel_add(const mus__source *source, mus__svg_panel *panel, mus_pattern *pattern, int32_t *out);
void mus__svg_panel_clear(mus_context *context, mus__svg_panel *panel);
/* the place of an edge that is nearest to p [m]: arc length from its start; *distance gets the distance. Errors:
 * MUS_ERR_MEMORY */
mus_status mus__svg_nearest(const mus__source *source, const mus_pattern *pattern, int32_t edge, const double *p,
                            double *s, double *distance);

#endif
