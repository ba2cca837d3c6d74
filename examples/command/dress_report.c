/*
 * dress_report.c: the report of a garment as JSON: reason, counts, figures, times.
 *
 * All members but the times, which can be left out, are the same in each run of the same garment.
 */
#include "dress.h"

#include <stdio.h>


const char *dress_status(const dress *d)
{
    return d->outcome == MUS_ERR_MEMORY ? "no memory" : mus_reason_name(d->why.kind);
}


static void write_motion(const motion *m, bool timed, json *j)
{
    json_open(j, "motion", '{');
    json_text(j, "name", m->move != NULL ? m->move : m->pose);
    json_int(j, "frames", m->made);
    json_int(j, "frames_per_second", MOTION_RATE);
    json_int(j, "steps", m->steps);
    json_int(j, "step_parts", m->step_parts);
    json_number(j, "max_penetration_mm", 1000.0 * m->max_depth);
    json_number(j, "max_jump_mm", 1000.0 * m->max_jump);
    json_number(j, "slid_mm", 1000.0 * m->slid);
    if (timed) json_number(j, "seconds", m->seconds);
    json_close(j, '}');
}


/* Writes the number of crossings and, with self-contact, the numbers of its contacts and queries. */
static void write_layers(const dress *d, const mus_drape_report *r, json *j)
{
    int64_t crossings = 0;
    if (mus_drape_crossings(d->drape, 0, NULL, &crossings) == MUS_OK) json_int(j, "crossings", crossings);
    if (!d->self_contact && d->over.count == 0) return;
    json_int(j, "self_contacts", r->self_contacts);
    json_int(j, "self_queries", r->self_queries);
}


/* Writes the reason's sentence, and the panel, seam and place that it names. */
static void write_reason(const dress *d, json *j)
{
    const mus_reason why = d->why;
    if (why.kind == MUS_REASON_SETTLED) return;
    json_text(j, "reason", why.text);
    json_open(j, "at", '{');
    if (why.panel != MUS_NONE) json_text(j, "panel", mus_pattern_panel_name(d->s.pattern, why.panel));
    if (why.seam != MUS_NONE) json_int(j, "seam", why.seam);
    if (why.count > 0) json_int(j, "crossings", why.count);
    if (why.node != MUS_NONE) {
        json_open(j, "place", '[');
        for (int32_t i = 0; i < 3; i++) json_number(j, NULL, why.place[i]);
        json_close(j, ']');
    }
    json_close(j, '}');
}


/* Writes the starts that were tried, in their order. */
static void write_starts(const mus_dress_report *report, bool timed, json *j)
{
    json_open(j, "starts", '[');
    for (int32_t i = 0; i < report->starts; i++) {
        json_open(j, NULL, '{');
        static const char *const kinds[] = {"both", "pattern", "found", "raised"};
        json_text(j, "kind", kinds[report->start_place[i]]);
        if (timed) json_number(j, "seconds", report->start_seconds[i]);
        json_text(j, "end", mus_reason_name(report->start_end[i]));
        json_close(j, '}');
    }
    json_close(j, ']');
}


/* Writes whether the garment is worn, why not, and what goes through the body; nothing on a body that cannot tell. */
static void write_worn(const dress *d, json *j)
{
    const mus_worn *worn = &d->worn;
    if (worn->kind == MUS_WORN_UNKNOWN) return;
    json_bool(j, "worn", worn->kind == MUS_WORN_YES);
    json_text(j, "worn_why", worn->text);
    json_open(j, "through_body", '{');
    json_int(j, "count", worn->through);
    json_number(j, "depth_mm", 1000.0 * worn->through_depth);
    json_number(j, "area_cm2", 1e4 * worn->through_area);
    json_close(j, '}');
}


void dress_seconds(const dress *d, json *j)
{
    json_open(j, "seconds", '{');
    json_number(j, "draft", d->s.draft_seconds);
    json_number(j, "body", d->body_seconds);
    json_number(j, "place", d->dressed.place_seconds);
    json_number(j, "mesh", d->dressed.cut_seconds);
    json_number(j, "sew", d->dressed.sew_seconds);
    json_number(j, "settle", d->dressed.settle_seconds);
    json_number(j, "render", d->render_seconds);
    double thrown = 0.0; /* the starts that were not kept */
    for (int32_t i = 0; i < d->dressed.starts; i++)
        if (i != d->dressed.kept) thrown += d->dressed.start_seconds[i];
    json_number(j, "thrown_away", thrown);
    json_close(j, '}');
}


void dress_describe(const dress *d, bool timed, json *j)
{
    json_text(j, "garment", mus_pattern_name(d->s.pattern));
    json_text(j, "status", dress_status(d));
    write_reason(d, j);
    json_warnings(j);
    if (d->drape != NULL) {
        mus_drape_report r;
        char hash[24];
        mus_drape_report_init(&r, sizeof r);
        mus_drape_report_get(d->drape, &r);
        snprintf(hash, sizeof hash, "%016llx", (unsigned long long)mus_drape_hash(d->drape));
        json_text(j, "start", d->dressed.found ? "found" : "pattern");
        write_starts(&d->dressed, timed, j);
        json_int(j, "panels", mus_cloth_panel_count(d->cloth));
        json_int(j, "nodes", r.nodes);
        json_int(j, "springs", r.springs);
        json_int(j, "seams", r.seams);
        json_int(j, "seams_closed", r.seams_closed);
        json_number(j, "max_seam_gap_mm", 1000.0 * r.max_seam_gap);
        json_number(j, "max_penetration_mm", 1000.0 * r.max_penetration);
        json_number(j, "max_strain", r.max_strain);
        json_number(j, "residual", r.residual);
        json_number(j, "max_speed_m_s", r.max_speed);
        json_number(j, "mass_kg", mus_cloth_mass(d->cloth));
        json_int(j, "steps", r.steps);
        json_number(j, "step_s", r.step);
        json_number(j, "step_bound_s", r.step_bound);
        json_number(j, "sew_time_s", r.sew_time);
        json_number(j, "settle_time_s", r.settle_time);
        json_int(j, "spring_evaluations", r.spring_evaluations);
        json_int(j, "contact_queries", r.contact_queries);
        write_layers(d, &r, j);
        json_text(j, "skipped", mus_drape_skipped(d->drape));
        json_text(j, "state_hash", hash);
    }
    write_worn(d, j);
    if (d->fit != NULL) fit_write(d->fit, j);
    if (d->moved.pose != NULL || d->moved.move != NULL) write_motion(&d->moved, timed, j);
    if (timed) dress_seconds(d, j);
}
