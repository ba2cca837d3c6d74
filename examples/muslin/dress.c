/*
 * dress.c: muslin dress: place, sew, settle; picture, meshes, report.
 *
 * A garment that does not come to rest is written all the same, with the reason in the report and exit code 1. One line
 * on standard error: an output that could not be written comes first, since the report holds the reason of the run.
 */
#define _POSIX_C_SOURCE 200809L /* isatty */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "json.h"
#include "mesh.h"
#include "motion.h"
#include "scene.h"

typedef struct dress {
    scene s;
    source from;
    mesh_source mesh;
    look look;
    mus_fabric fabric;
    const char *fabric_name, *map, *png, *glb, *obj, *report;
    double spacing_mm, threads, precision, friction;
    bool as_json, quiet, self_contact;
    motion moved;
    bool led; /* the animated file is written */

    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_fit *fit; /* of a garment that is sewn; may be NULL */
    fit_map coloured;
    mus_status outcome;
    char reason[512];
    double body_seconds, mesh_seconds, sew_seconds, settle_seconds, render_seconds;
} dress;


/* one line that rewrites itself on a terminal */
static int32_t show_progress(void *user, const char *phase, double progress)
{
    (void)user;
    fprintf(stderr, "\r%-7s %3.0f %%", phase, 100.0 * progress);
    fflush(stderr);
    return 0;
}


/* why it ended as it did: of the list, with the place; what the run of a movement says goes before */
static void find_reason(const dress *d, mus_reason *out)
{
    mus_reason_init(out, sizeof *out);
    if (d->drape != NULL) mus_drape_reason(d->drape, out);
    else if (d->outcome == MUS_ERR_PATTERN) mus_pattern_reason(d->s.pattern, out);
    if (d->outcome == MUS_OK) {
        out->kind = MUS_REASON_SETTLED;
    } else if (d->outcome == MUS_ERR_DIVERGED || d->outcome == MUS_ERR_STEP) {
        out->kind = MUS_REASON_UNSTABLE;
    } else if (out->kind == MUS_REASON_NONE || out->kind == MUS_REASON_SETTLED) {
        out->kind = MUS_REASON_BAD_INPUT;
    }
    if (out->text[0] == '\0') snprintf(out->text, sizeof out->text, "%.*s", (int)sizeof out->text - 1, d->reason);
}


static const char *status_word(const dress *d)
{
    mus_reason why;
    find_reason(d, &why);
    return d->outcome == MUS_ERR_MEMORY ? "no memory" : mus_reason_name(why.kind);
}


/* body, cloth, drape: everything before the first step */
static mus_status prepare(dress *d)
{
    double start = seconds();
    mus_status status = MUS_OK;
    if (d->mesh.file == NULL) {
        status = mus_body_create(d->s.context, d->s.tape, NULL, &d->body);
        d->body_seconds = seconds() - start;
    }
    if (status != MUS_OK) return status;

    start = seconds();
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    cut.fabric = d->fabric;
    cut.spacing = 0.001 * d->spacing_mm;
    status = mus_cloth_create(d->s.context, d->s.pattern, &cut, &d->cloth);
    d->mesh_seconds = seconds() - start;
    if (status != MUS_OK) return status;

    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.threads = (int32_t)d->threads;
    def.precision = (int32_t)d->precision;
    def.friction = d->friction;
    def.self_contact = d->self_contact;
    status = mus_drape_create(d->s.context, d->cloth, d->body, &def, &d->drape);
    return status == MUS_OK ? mus_drape_place(d->drape) : status;
}


/* sew and settle; the outcome is kept for the report */
static void run(dress *d)
{
    const bool show = !d->quiet && isatty(STDERR_FILENO);
    const mus_progress_fn progress = show ? show_progress : NULL;
    double start = seconds();
    d->outcome = mus_drape_sew(d->drape, progress, NULL);
    d->sew_seconds = seconds() - start;
    start = seconds();
    if (d->outcome == MUS_OK) d->outcome = mus_drape_settle(d->drape, progress, NULL);
    d->settle_seconds = seconds() - start;
    if (show) fputs("\r             \r", stderr);

    /* at rest, but through itself: no garment */
    mus_reason why;
    mus_reason_init(&why, sizeof why);
    mus_drape_reason(d->drape, &why);
    if (d->outcome == MUS_OK && why.kind == MUS_REASON_TANGLED) d->outcome = MUS_ERR_UNSETTLED;
    if (d->outcome != MUS_OK) snprintf(d->reason, sizeof d->reason, "%s", mus_context_error(d->s.context));
}


/* into the pose, and to rest there; or through the movement. Returns an exit code */
static int move_on(dress *d)
{
    dressed on = {&d->s, &d->look, d->body, NULL, d->cloth, d->drape};
    int code = EXIT_DONE;
    if (d->moved.pose != NULL) {
        d->outcome = motion_into(&on, &d->moved, d->moved.pose);
        const double start = seconds();
        if (d->outcome == MUS_OK) d->outcome = mus_drape_settle(d->drape, NULL, NULL);
        d->settle_seconds += seconds() - start;
    } else if (d->moved.move != NULL) {
        mus_body *thin = NULL;
        mus_body_def def;
        mus_body_def_init(&def, sizeof def);
        def.samples = 32;
        def.ring_spacing = 0.025;
        if (d->glb != NULL && d->mesh.file == NULL)
            d->outcome = mus_body_create(d->s.context, d->s.tape, &def, &thin);
        on.thin = thin;
        if (d->outcome == MUS_OK) code = motion_lead(&on, &d->moved, d->glb, &d->outcome);
        d->led = d->glb != NULL && d->moved.made > 0;
        mus_body_destroy(thin);
    }
    if (d->outcome != MUS_OK) snprintf(d->reason, sizeof d->reason, "%s", mus_context_error(d->s.context));
    return code;
}


static void write_motion(const motion *m, json *j)
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
    json_number(j, "seconds", m->seconds);
    json_close(j, '}');
}


static void write_seconds(const dress *d, json *j)
{
    json_open(j, "seconds", '{');
    json_number(j, "draft", d->s.draft_seconds);
    json_number(j, "body", d->body_seconds);
    json_number(j, "mesh", d->mesh_seconds);
    json_number(j, "sew", d->sew_seconds);
    json_number(j, "settle", d->settle_seconds);
    json_number(j, "render", d->render_seconds);
    json_close(j, '}');
}


/* what there is of cloth on cloth */
static void write_layers(const dress *d, const mus_drape_report *r, json *j)
{
    int64_t crossings = 0;
    if (mus_drape_crossings(d->drape, 0, NULL, &crossings) == MUS_OK) json_int(j, "crossings", crossings);
    json_int(j, "self_contacts", r->self_contacts);
    json_int(j, "self_queries", r->self_queries);
}


/* the sentence, and the panel, seam and place that it is about */
static void write_reason(const dress *d, json *j)
{
    mus_reason why;
    find_reason(d, &why);
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


static void describe(const dress *d, json *j)
{
    json_open(j, NULL, '{');
    json_text(j, "garment", mus_pattern_name(d->s.pattern));
    json_text(j, "status", status_word(d));
    write_reason(d, j);
    if (d->drape != NULL) {
        mus_drape_report r;
        char hash[24];
        mus_drape_report_init(&r, sizeof r);
        mus_drape_report_get(d->drape, &r);
        snprintf(hash, sizeof hash, "%016llx", (unsigned long long)mus_drape_hash(d->drape));
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
        if (d->self_contact) write_layers(d, &r, j);
        json_text(j, "skipped", mus_drape_skipped(d->drape));
        json_text(j, "state_hash", hash);
    }
    if (d->fit != NULL) fit_write(d->fit, j);
    if (d->moved.pose != NULL || d->moved.move != NULL) write_motion(&d->moved, j);
    write_seconds(d, j);
    json_close(j, '}');
}


/* the body as it stands now; out is the rest body when it never moved */
static mus_status body_now(const dress *d, mus_body **own)
{
    *own = NULL;
    if (d->moved.pose == NULL && d->moved.move == NULL) return MUS_OK;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    mus_status status = mus_drape_body_pose(d->drape, &pose);
    return status == MUS_OK ? mus_body_pose(d->body, &pose, own) : status;
}


/* how what is sewn fits; without memory for it there is none to tell */
static void look_at_fit(dress *d)
{
    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    if (mus_drape_report_get(d->drape, &r) == MUS_OK && r.seams_closed == r.seams)
        if (mus_fit_create(d->drape, d->body, &d->fit) != MUS_OK) d->fit = NULL;
}


/* picture and meshes of what there is now */
static int write_shapes(dress *d)
{
    if (d->png == NULL && d->glb == NULL && d->obj == NULL) return EXIT_DONE;
    garment g = {0};
    mus_body *own = NULL;
    mus_status status = body_now(d, &own);
    if (status != MUS_OK) return scene_fail(&d->s, status);
    int code = garment_make(&d->s, &d->look, own != NULL ? own : d->body, d->cloth, d->drape, &g);
    if (code == EXIT_DONE && d->map != NULL && d->fit != NULL) {
        code = fit_map_make(&d->s, d->map, d->fit, &d->coloured);
        d->look.map = &d->coloured;
    }
    if (code == EXIT_DONE && d->glb != NULL && !d->led) status = mus_mesh_write_glb(d->s.context, d->glb, 2, g.view);
    if (code == EXIT_DONE && status == MUS_OK && d->obj != NULL)
        status = mus_mesh_write_obj(d->s.context, d->obj, 2, g.view);
    if (status != MUS_OK) code = scene_fail(&d->s, status);
    const double start = seconds();
    if (code == EXIT_DONE && d->png != NULL) code = picture_write(&d->s, &d->look, &g, d->png);
    d->render_seconds = seconds() - start;
    garment_free(&g);
    fit_map_free(&d->coloured);
    d->look.map = NULL;
    mus_body_destroy(own);
    return code;
}


/* report where asked, else one line for people */
static int write_report(const dress *d)
{
    int code = EXIT_DONE;
    json j = {0};
    describe(d, &j);
    if (d->report != NULL && !json_write(&j, "dress", d->report)) code = EXIT_FAILED;
    if (d->as_json && !json_write(&j, "dress", "-")) code = EXIT_FAILED;
    json_free(&j);
    if (d->as_json || d->drape == NULL || is_stdout(d->report) || is_stdout(d->png) || is_stdout(d->glb) ||
        is_stdout(d->obj))
        return code;

    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    if (mus_drape_report_get(d->drape, &r) == MUS_OK)
        printf("%s: %s; %d nodes, %d of %d seams closed, gap %.2f mm, depth %.2f mm, strain %.1f %%, %.1f s\n",
               mus_pattern_name(d->s.pattern), status_word(d), (int)r.nodes, (int)r.seams_closed, (int)r.seams,
               1000.0 * r.max_seam_gap, 1000.0 * r.max_penetration, 100.0 * r.max_strain,
               d->mesh_seconds + d->sew_seconds + d->settle_seconds);
    return code;
}


/* a name, or a file that ends in .json */
static int find_fabric(dress *d)
{
    mus_fabric_init(&d->fabric, sizeof d->fabric);
    const char *ending = d->fabric_name != NULL ? strrchr(d->fabric_name, '.') : NULL;
    if (ending != NULL && strcmp(ending, ".json") == 0) {
        mus_status status = mus_fabric_load(d->s.context, d->fabric_name, &d->fabric);
        return status == MUS_OK ? EXIT_DONE : scene_fail(&d->s, status);
    }
    if (d->fabric_name == NULL || mus_fabric_find(d->fabric_name, &d->fabric) == MUS_OK) return EXIT_DONE;
    char names[512] = "";
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        const size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, "%s%s", i == 0 ? "" : ", ", mus_fabric_name(i));
    }
    return complain(EXIT_INPUT, "dress", "--fabric %s: expected a .json file or one of %s", d->fabric_name, names);
}


static int read_options(dress *d, int argc, char **argv)
{
    d->spacing_mm = 10.0;
    d->threads = 1.0;
    d->precision = 32.0;
    d->friction = NAN;
    d->look.repeat = 0.1;
    d->moved.count = 240.0;
    const option options[] = {
        SOURCE_PATTERN(d->from),
        SOURCE_TAPE(d->from),
        SOURCE_MESH(d->mesh),
        {"--fabric", OPTION_TEXT, &d->fabric_name, 0, 0,
         "NAME  jersey (default), cotton, denim ... (muslin_fabric(5)), or FILE.json"},
        {"--spacing", OPTION_NUMBER, &d->spacing_mm, 1, 100, "MM  of the lattice, default 10"},
        {"--friction", OPTION_NUMBER, &d->friction, 0, 10, "MU  on skin, default the fabric's"},
        {"--self-contact", OPTION_FLAG, &d->self_contact, 0, 0, "cloth does not go through cloth"},
        {"--colour", OPTION_TEXT, &d->look.colour, 0, 0, "C  #RRGGBB or a name"},
        {"--texture", OPTION_TEXT, &d->look.texture, 0, 0, "FILE  a PNG printed on the cloth"},
        {"--repeat", OPTION_NUMBER, &d->look.repeat, 0.001, 10, "M  width of one repeat of the texture, default 0.1"},
        {"--map", OPTION_TEXT, &d->map, 0, 0, "NAME  colours of the cloth by strain, pressure or ease"},
        {"--view", OPTION_LIST, &d->look.views, 0, 0, "YAW,PITCH,ZOOM  of a view; may be given again"},
        {"--pixels", OPTION_TEXT, &d->look.pixels, 0, 0, "WxH  of the picture"},
        {"--pose", OPTION_TEXT, &d->moved.pose, 0, 0, "NAME  into a pose (muslin body --poses lists them)"},
        {"--move", OPTION_TEXT, &d->moved.move, 0, 0, "NAME  lead the body through a movement: walk, arm_raise ..."},
        {"--frames", OPTION_TEXT, &d->moved.frames, 0, 0, "DIR  a picture a frame, DIR/frame_0001.png and on"},
        {"--count", OPTION_WHOLE, &d->moved.count, 1, 4096, "N  frames of the movement, 60 a second, default 240"},
        {"--png", OPTION_OUTPUT, &d->png, 0, 0, "FILE  the picture"},
        {"--glb", OPTION_OUTPUT, &d->glb, 0, 0, "FILE  body and garment as binary glTF 2.0; of a movement: animated"},
        {"--obj", OPTION_OUTPUT, &d->obj, 0, 0, "FILE  body and garment as OBJ"},
        {"--report", OPTION_OUTPUT, &d->report, 0, 0, "FILE  what happened, as JSON"},
        {"--json", OPTION_STDOUT, &d->as_json, 0, 0, "the report on standard output"},
        {"--threads", OPTION_WHOLE, &d->threads, 1, 64, "N  threads, default 1; the result is the same"},
        {"--precision", OPTION_WHOLE, &d->precision, 32, 64, "BITS  of the state: 32 (default) or 64"},
        {"--quiet", OPTION_FLAG, &d->quiet, 0, 0, "no progress on the terminal"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("dress", "Sew a garment round a body and let it come to rest.", options, argc, argv))
        return EXIT_INPUT;
    if (d->precision != 32.0 && d->precision != 64.0)
        return complain(EXIT_INPUT, "dress", "--precision %g: expected 32 or 64", d->precision);
    return EXIT_DONE;
}


static int run_failed(const dress *d)
{
    mus_reason why;
    find_reason(d, &why);
    return complain(failure_code(d->outcome), "dress", "%s",
                    why.text[0] != '\0' ? why.text : mus_status_text(d->outcome));
}


int command_dress(int argc, char **argv)
{
    dress *d = calloc(1, sizeof *d);
    if (d == NULL) return complain(EXIT_FAILED, "dress", "no memory");
    int code = read_options(d, argc, argv);
    if (code != EXIT_DONE) {
        free(d);
        return code;
    }

    code = scene_open(&d->s, "dress");
    if (code == EXIT_DONE) code = find_fabric(d);
    if (code == EXIT_DONE) code = look_check(&d->s, &d->look);
    if (code == EXIT_DONE) code = fit_map_check(&d->s, d->map);
    if (code == EXIT_DONE) code = motion_check(&d->s, &d->moved);
    if (code == EXIT_DONE && d->mesh.file != NULL) {
        const double start = seconds();
        code = mesh_body(&d->s, &d->mesh, NULL, &d->body);
        d->body_seconds = seconds() - start;
    }
    if (code == EXIT_DONE && (d->mesh.file == NULL || d->from.pattern == NULL)) code = scene_tape(&d->s, &d->from);
    if (code == EXIT_DONE) code = scene_pattern(&d->s, &d->from);
    if (code == EXIT_DONE) {
        d->outcome = prepare(d);
        if (d->outcome == MUS_OK)
            run(d);
        else
            snprintf(d->reason, sizeof d->reason, "%s", mus_context_error(d->s.context));
        if (d->outcome == MUS_OK) code = move_on(d);
        if (d->drape != NULL && code == EXIT_DONE) look_at_fit(d);
        if (d->drape != NULL && code == EXIT_DONE) code = write_shapes(d);
        const int report = write_report(d);
        if (code == EXIT_DONE) code = report;
        if (code == EXIT_DONE && d->outcome != MUS_OK) code = run_failed(d);
    }
    mus_fit_destroy(d->fit);
    mus_drape_destroy(d->drape);
    mus_cloth_destroy(d->cloth);
    mus_body_destroy(d->body);
    scene_close(&d->s);
    free(d);
    return code;
}
