/*
 * sewing_cloth.c: the metres of cloth that a pattern takes, for the widths that cloth is sold in.
 *
 * Each material is laid on cloth folded lengthwise (muslin/layout.h), as it is cut at home, with a short search. A
 * width that a piece does not fit on is left out.
 */
#include <math.h>
#include <stdio.h>

#include "muslin/layout.h"
#include "sewing/sewing_text.h"

/* [m] widths from selvedge to selvedge; chosen: what shops sell most of interfacing, of cotton, and of cloth and
 * jersey */
static const double widths[] = {0.90, 1.14, 1.40};

/* elementary steps of a search for each panel, about 1 ms; chosen: on 18 designs the lengths, rounded up, are 3.9 %
 * above those of searches of 3e8 steps */
#define CLOTH_STEPS 1000000
#define CLOTH_SOLD 0.05 /* [m] lengths are rounded up to this; chosen: half of what shops count in */


/* write a length [m] as metres with two decimals, by the language; returns `out` (MUS__LENGTH) */
static const char *cloth_metres(const mus__instructions *job, double length, char *out)
{
    const long hundredths = lround(100.0 * length);
    char decimals[8];
    mus__phrase phrase = mus__phrase_in(job->language);
    snprintf(decimals, sizeof decimals, "%02ld", hundredths % 100);
    mus__phrase_number(&phrase, 0, hundredths / 100);
    mus__phrase_text(&phrase, 1, decimals);
    mus__phrase_write(&phrase, "metres", out, MUS__LENGTH);
    return out;
}


/* lay a material on one width: sets the length of cloth [m]; 0 without pieces and where one does not fit */
static mus_status cloth_length(const mus__instructions *job, int32_t material, double width, double *length)
{
    mus_layout *layout = NULL;
    mus_layout_def def;
    mus_layout_def_init(&def, sizeof def);
    def.width = width;
    def.material = material;
    def.fold = 1;
    def.steps = CLOTH_STEPS * ((int64_t)mus_pattern_panel_count(job->pattern) + mus_pattern_panel_count(job->extra));
    def.steps = def.steps > CLOTH_STEPS ? def.steps : CLOTH_STEPS;
    const mus_status status = mus_layout_create(job->sink.context, job->pattern, &def, &layout);
    *length = CLOTH_SOLD * ceil(mus_layout_length(layout) / CLOTH_SOLD - 1e-9);
    mus_layout_destroy(layout);
    /* a piece that is too wide, and a pattern with a fault, which is told as far as it can be sewn */
    return status == MUS_ERR_MEMORY ? status : MUS_OK;
}


mus_status mus__tell_cloth(mus__instructions *job)
{
    bool any = false;
    for (int32_t material = 0; material < MUS_MATERIAL_COUNT; material++) {
        bool first = true;
        if (material == MUS_MATERIAL_ELASTIC) continue; /* a notion */
        for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
            char wide[MUS__LENGTH], metres[MUS__LENGTH], key[48];
            double length;
            const mus_status status = cloth_length(job, material, widths[i], &length);
            if (status != MUS_OK) return status;
            if (!(length > 0.0)) continue;
            mus__phrase phrase = mus__phrase_in(job->language);
            if (!any) mus__sink_print(&job->sink, "\n%s\n", mus_language_text(job->language, "head.cloth"));
            any = true;
            mus__sink_print(&job->sink, "%s", first ? "- " : mus_language_text(job->language, "list.semicolon"));
            if (first) {
                snprintf(key, sizeof key, "material.%s", mus_material_name(material));
                mus__sink_print(&job->sink, "%s%s", mus_language_text(job->language, key),
                                mus_language_text(job->language, "list.comma"));
            }
            first = false;
            mus__phrase_text(&phrase, 0, cloth_metres(job, widths[i], wide));
            mus__phrase_text(&phrase, 1, cloth_metres(job, length, metres));
            mus__phrase_add(&phrase, "cloth.wide", &job->sink);
        }
        if (!first) mus__sink_print(&job->sink, "\n");
    }
    return MUS_OK;
}
