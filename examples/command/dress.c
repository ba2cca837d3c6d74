/*
 * dress.c: muslin dress: dresses a body by mus_dress(), brings it into a pose or leads it through a movement, and
 * writes pictures and meshes. dress_report.c writes the report, batch.c dresses many garments.
 *
 * A garment that does not come to rest is written too, with the reason in the report and exit code 1. There is one line
 * on standard error; it is that of an output that could not be written, if there is one, since the report has the
 * reason of the run.
 */
#define _POSIX_C_SOURCE 200809L /* isatty */
#include "dress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "batch.h"
#include "commands.h"

/* Shows the progress as one line that is overwritten on a terminal. */
static int32_t show_progress(void *user, const mus_progress *progress)
{
    (void)user;
    fprintf(stderr, "\r%-7s %3.0f %%", progress->phase, 100.0 * progress->progress);
    fflush(stderr);
    return 0;
}


/* Makes the body from the tape, unless there is one from a mesh. */
static mus_status make_body(dress *d)
{
    if (d->mesh.file != NULL) return MUS_OK;
    const double start = seconds();
    const mus_status status = scene_body(&d->s, &d->from, NULL, &d->body);
    d->body_seconds = seconds() - start;
    return status;
}


/* Places, sews and settles. A placement found by the library is tried after the pattern's own for a single garment on a
 * body of a tape only: there is none for others. */
static mus_status put_on(dress *d)
{
    const bool show = !d->quiet && isatty(STDERR_FILENO);
    mus_dress_def def;
    mus_dress_def_init(&def, sizeof def);
    def.spacing = 0.001 * d->spacing_mm;
    def.nodes_most = (int32_t)d->nodes;
    def.fabric = &d->fabric;
    def.self_contact = d->self_contact || d->over.count > 0;
    def.precision = (int32_t)d->precision;
    def.threads = (int32_t)d->threads;
    def.friction = d->friction;
    def.open_closures = d->open;
    def.retry = d->mesh.file == NULL && d->over.count == 0;
    if (d->place != NULL)
        def.place = strcmp(d->place, "found") == 0 ? MUS_DRESS_PLACE_FOUND : MUS_DRESS_PLACE_PATTERN;
    def.seconds_most = d->limit;
    def.progress = show ? show_progress : d->progress;
    def.progress_user = d->progress_user;
    const mus_status status =
        mus_dress(d->s.context, d->s.pattern, d->body, &def, &d->dressed, &d->why, &d->cloth, &d->drape);
    if (show) fputs("\r             \r", stderr);
    return status;
}


/* Updates the reason why the garment is on or not, after the body has moved. */
static void moved_reason(dress *d)
{
    mus_reason_init(&d->why, sizeof d->why);
    mus_drape_reason(d->drape, &d->why);
    if (d->outcome == MUS_OK) d->why.kind = MUS_REASON_SETTLED;
    else if (d->outcome == MUS_ERR_DIVERGED || d->outcome == MUS_ERR_STEP) d->why.kind = MUS_REASON_UNSTABLE;
    else if (d->why.kind == MUS_REASON_NONE || d->why.kind == MUS_REASON_SETTLED) d->why.kind = MUS_REASON_BAD_INPUT;
    if (d->outcome != MUS_OK && d->why.text[0] == '\0')
        snprintf(d->why.text, sizeof d->why.text, "%.255s", mus_context_error(d->s.context));
}


/* Brings the body into the pose and settles the garment there, or leads the body through the movement. Returns an exit
 * code. */
static int move_on(dress *d)
{
    dressed on = {&d->s, &d->look, d->body, NULL, d->cloth, d->drape};
    int code = EXIT_DONE;
    if (d->moved.pose != NULL) {
        d->outcome = motion_into(&on, &d->moved, d->moved.pose);
        const double start = seconds();
        if (d->outcome == MUS_OK) d->outcome = mus_drape_settle(d->drape, NULL, NULL);
        d->dressed.settle_seconds += seconds() - start;
    } else if (d->moved.move != NULL) {
        mus_body *thin = NULL;
        mus_body_def def;
        mus_body_def_init(&def, sizeof def);
        def.samples = 32;
        def.ring_spacing = 0.025;
        if (motion_filed(d->files) && d->mesh.file == NULL)
            d->outcome = scene_body(&d->s, &d->from, &def, &thin);
        on.thin = thin;
        if (d->outcome == MUS_OK) code = motion_lead(&on, &d->moved, d->fabric_name, d->files, &d->outcome);
        d->led = motion_filed(d->files) && d->moved.made > 0;
        mus_body_destroy(thin);
    }
    if (d->moved.pose != NULL || d->moved.move != NULL) moved_reason(d);
    return code;
}


/* Makes a copy of the body in its present pose; *out is the rest body when it has not moved. */
static mus_status body_now(const dress *d, mus_body **own)
{
    *own = NULL;
    if (d->moved.pose == NULL && d->moved.move == NULL) return MUS_OK;
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    mus_status status = mus_drape_body_pose(d->drape, &pose);
    return status == MUS_OK ? mus_body_pose(d->body, &pose, own) : status;
}


/* Makes the fit of a sewn garment; without memory for it the report has none. */
static void look_at_fit(dress *d)
{
    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    if (mus_drape_report_get(d->drape, &r) == MUS_OK && r.seams_closed == r.seams)
        if (mus_fit_create(d->drape, d->body, &d->fit) != MUS_OK) d->fit = NULL;
}


/* Asks whether the garment is worn, by the body as it stands now; without memory for it the report does not say. */
static void look_at_worn(dress *d)
{
    mus_body *own = NULL;
    if (body_now(d, &own) == MUS_OK)
        mus_fit_worn(d->drape, d->s.pattern, own != NULL ? own : d->body, &d->worn);
    mus_body_destroy(own);
}


/* Writes picture and meshes of the present state. */
static int write_shapes(dress *d)
{
    const char *files[MESH_FORMS];
    bool asked = d->png != NULL || d->turn > 0.0;
    for (int32_t i = 0; i < MESH_FORMS; i++) {
        const bool done = d->led && (i == MUS_MESH_GLB || i == MUS_MESH_USDA);
        files[i] = done ? NULL : d->files[i];
        asked = asked || d->files[i] != NULL;
    }
    if (!asked) return EXIT_DONE;
    garment g = {0};
    mus_body *own = NULL;
    mus_status status = body_now(d, &own);
    if (status != MUS_OK) return scene_fail(&d->s, status);
    int code = garment_make(&d->s, &d->look, own != NULL ? own : d->body, d->cloth, d->drape, &g);
    if (code == EXIT_DONE && d->map != NULL && d->fit != NULL) {
        code = fit_map_make(&d->s, d->map, d->fit, &d->coloured);
        d->look.map = &d->coloured;
    }
    if (code == EXIT_DONE) status = garment_write(&d->s, &g, d->cloth, d->fabric_name, NULL, files);
    if (status != MUS_OK) code = scene_fail_output(&d->s, status);
    const double start = seconds();
    if (code == EXIT_DONE && d->png != NULL) code = picture_write(&d->s, &d->look, &g, d->png);
    if (code == EXIT_DONE && d->turn > 0.0)
        code = picture_turn(&d->s, &d->look, &g, (int32_t)d->turn, d->moved.frames);
    d->render_seconds = seconds() - start;
    garment_free(&g);
    fit_map_free(&d->coloured);
    d->look.map = NULL;
    mus_body_destroy(own);
    return code;
}


/* Reads a fabric: a name of the table, or a file that ends in .json. */
static int find_fabric(dress *d)
{
    mus_fabric_init(&d->fabric, sizeof d->fabric);
    if (d->fabric_name != NULL && strcmp(d->fabric_name, "own") == 0) {
        const char *of = d->from.design;
        d->fabric_name = of != NULL ? mus_design_fabric(mus_design_find(of)) : NULL;
        if (d->fabric_name == NULL) return complain(EXIT_INPUT, "dress", "--fabric own needs --design NAME");
    }
    const char *ending = d->fabric_name != NULL ? strrchr(d->fabric_name, '.') : NULL;
    if (ending != NULL && strcmp(ending, ".json") == 0) {
        mus_status status = mus_fabric_load(d->s.context, d->fabric_name, &d->fabric);
        return status == MUS_OK ? EXIT_DONE : scene_fail(&d->s, status);
    }
    if (mus_fabric_find(d->fabric_name != NULL ? d->fabric_name : "jersey", &d->fabric) == MUS_OK) return EXIT_DONE;
    char names[512] = "";
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        const size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, "%s%s", i == 0 ? "" : ", ", mus_fabric_name(i));
    }
    return complain(EXIT_INPUT, "dress", "--fabric %s: expected own, a .json file or one of %s", d->fabric_name, names);
}


void dress_init(dress *d)
{
    memset(d, 0, sizeof *d);
    d->spacing_mm = 10.0;
    d->nodes = MUS_CLOTH_NODES;
    d->threads = 1.0;
    d->friction = NAN;
    mus_dress_report_init(&d->dressed, sizeof d->dressed);
    mus_reason_init(&d->why, sizeof d->why);
    mus_worn_init(&d->worn, sizeof d->worn);
    d->worn.kind = MUS_WORN_UNKNOWN;
    d->look.repeat = 0.1;
    d->moved.count = 240.0;
}


int32_t dress_options(dress *d, option *table)
{
    const option options[] = {
        SOURCE_PATTERN(d->from),
        {"--over", OPTION_LIST, &d->over, 0, 0,
         "GARMENT  worn over it: a design, words, a file; repeatable, inside to outside"},
        SOURCE_TAPE(d->from),
        SOURCE_POSTURE(d->from),
        SOURCE_MESH(d->mesh),
        {"--fabric", OPTION_TEXT, &d->fabric_name, 0, 0,
         "NAME  jersey (default), denim ... (muslin_fabric(5)), own: the design's, FILE.json"},
        {"--spacing", OPTION_NUMBER, &d->spacing_mm, 1, 100, "MM  spacing of the nodes, default 10"},
        {"--nodes", OPTION_WHOLE, &d->nodes, 1, 1 << 24, "N  most nodes of the cloth, default 1048576"},
        {"--friction", OPTION_NUMBER, &d->friction, 0, 10,
         "MU  friction coefficient on skin, default: that of the fabric"},
        {"--place", OPTION_TEXT, &d->place, 0, 0,
         "HOW  start of panels: file (as the pattern says) or found; default file, then found"},
        {"--self-contact", OPTION_FLAG, &d->self_contact, 0, 0, "contact of cloth with cloth"},
        {"--open", OPTION_FLAG, &d->open, 0, 0, "leave zips and buttons open"},
        {"--colour", OPTION_LIST, &d->look.colours, 0, 0, "C  #RRGGBB or a name; repeatable, one a garment"},
        {"--texture", OPTION_TEXT, &d->look.texture, 0, 0, "FILE  a PNG as print of the cloth"},
        {"--repeat", OPTION_NUMBER, &d->look.repeat, 0.001, 10, "M  width of one repeat of the texture, default 0.1"},
        {"--map", OPTION_TEXT, &d->map, 0, 0, "NAME  colour the cloth by strain, pressure or ease"},
        {"--view", OPTION_LIST, &d->look.views, 0, 0, "YAW,PITCH[,ZOOM]  a view, in degrees; may be repeated"},
        {"--pixels", OPTION_TEXT, &d->look.pixels, 0, 0, "WxH  size of the picture"},
        {"--pose", OPTION_TEXT, &d->moved.pose, 0, 0,
         "NAME  bring the body into a pose (muslin body --poses lists them)"},
        {"--move", OPTION_TEXT, &d->moved.move, 0, 0, "NAME  lead the body through a movement: walk, arm_raise ..."},
        {"--count", OPTION_WHOLE, &d->moved.count, 1, 4096, "N  number of frames, 60 a second, default 240"},
        {"--threads", OPTION_WHOLE, &d->threads, 1, 64,
         "N  number of threads, default 1; the result does not depend on it"},
        {"--precision", OPTION_WHOLE, &d->precision, 32, 64,
         "BITS  precision of the state: 32 or 64; default: as the cloth asks"}};
    _Static_assert(sizeof options / sizeof *options <= DRESS_OPTIONS, "the table of the caller holds them");
    memcpy(table, options, sizeof options);
    return (int32_t)(sizeof options / sizeof *options);
}


int dress_check(const char *command, const dress *d)
{
    if (d->turn > 0.0 && (d->moved.frames == NULL || d->moved.move != NULL))
        return complain(EXIT_INPUT, command, "--turn N goes with --frames DIR and without --move");
    if (d->moved.frames != NULL && d->moved.move == NULL && d->turn == 0.0)
        return complain(EXIT_INPUT, command, "--frames %s: goes with --move NAME or --turn N", d->moved.frames);
    if (d->files[MUS_MESH_PC2] != NULL && d->moved.move == NULL)
        return complain(EXIT_INPUT, command, "--pc2 %s: goes with --move NAME", d->files[MUS_MESH_PC2]);
    if (d->precision != 0.0 && d->precision != 32.0 && d->precision != 64.0)
        return complain(EXIT_INPUT, command, "--precision %g: expected 32 or 64", d->precision);
    if (d->place != NULL && strcmp(d->place, "file") != 0 && strcmp(d->place, "found") != 0)
        return complain(EXIT_INPUT, command, "--place %s: expected file or found", d->place);
    return d->mesh.file != NULL ? scene_upright(&d->from, command) : EXIT_DONE;
}


int dress_open(dress *d)
{
    int code = scene_open(&d->s, "dress");
    if (code == EXIT_DONE) code = find_fabric(d);
    d->look.fabric = d->fabric_name;
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
    return code == EXIT_DONE ? scene_over(&d->s, &d->over) : code;
}


int dress_run(dress *d)
{
    int code = EXIT_DONE;
    d->outcome = make_body(d);
    if (d->outcome == MUS_OK) {
        d->outcome = put_on(d);
    } else {
        d->why.kind = MUS_REASON_BAD_INPUT;
        snprintf(d->why.text, sizeof d->why.text, "%.255s", mus_context_error(d->s.context));
    }
    if (d->outcome == MUS_OK) code = move_on(d);
    if (d->drape != NULL && code == EXIT_DONE) look_at_fit(d);
    if (d->drape != NULL && code == EXIT_DONE) look_at_worn(d);
    return d->drape != NULL && code == EXIT_DONE ? write_shapes(d) : code;
}


void dress_close(dress *d)
{
    mus_fit_destroy(d->fit);
    mus_drape_destroy(d->drape);
    mus_cloth_destroy(d->cloth);
    mus_body_destroy(d->body);
    scene_close(&d->s);
}


/* ---- the subcommand: one garment ---- */

/* Writes the report when it is asked for, else one line for people. */
static int write_report(const dress *d)
{
    int code = EXIT_DONE;
    json j = {0};
    json_open(&j, NULL, '{');
    dress_describe(d, true, &j);
    json_close(&j, '}');
    if (d->report != NULL && !json_write(&j, "dress", d->report)) code = EXIT_FAILED;
    if (d->as_json && !json_write(&j, "dress", "-")) code = EXIT_FAILED;
    json_free(&j);
    bool taken = is_stdout(d->report) || is_stdout(d->png);
    for (int32_t i = 0; i < MESH_FORMS; i++) taken = taken || is_stdout(d->files[i]);
    if (d->as_json || d->drape == NULL || taken) return code;

    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    if (mus_drape_report_get(d->drape, &r) == MUS_OK)
        print_line("%s: %s; %d nodes, %d of %d seams closed, gap %.2f mm, depth %.2f mm, largest strain %.1f %%, "
                   "%.1f s",
                   mus_pattern_name(d->s.pattern), dress_status(d), (int)r.nodes, (int)r.seams_closed, (int)r.seams,
                   1000.0 * r.max_seam_gap, 1000.0 * r.max_penetration, 100.0 * r.max_strain,
                   d->dressed.cut_seconds + d->dressed.sew_seconds + d->dressed.settle_seconds);
    return code;
}


static int read_options(dress *d, int argc, char **argv)
{
    const option outputs[] = {
        {"--frames", OPTION_TEXT, &d->moved.frames, 0, 0,
         "DIR  write a picture for each frame: DIR/frame_0001.png and on"},
        {"--turn", OPTION_WHOLE, &d->turn, 1, 4096, "N  N pictures of one turn to --frames, in place of a movement"},
        {"--png", OPTION_OUTPUT, &d->png, 0, 0, "FILE  write the picture"},
        {"--glb", OPTION_OUTPUT, &d->files[MUS_MESH_GLB], 0, 0,
         "FILE  write body and garment as binary glTF 2.0; animated with --move"},
        {"--obj", OPTION_OUTPUT, &d->files[MUS_MESH_OBJ], 0, 0, "FILE  write body and garment as OBJ"},
        {"--usda", OPTION_OUTPUT, &d->files[MUS_MESH_USDA], 0, 0, "FILE  write them as USD; animated with --move"},
        {"--ply", OPTION_OUTPUT, &d->files[MUS_MESH_PLY], 0, 0, "FILE  write them as PLY"},
        {"--pc2", OPTION_OUTPUT, &d->files[MUS_MESH_PC2], 0, 0,
         "FILE  write the garment of each frame of --move as a point cache"},
        {"--report", OPTION_OUTPUT, &d->report, 0, 0, "FILE  write the report as JSON"},
        {"--json", OPTION_STDOUT, &d->as_json, 0, 0, "the report on standard output"},
        {"--limit", OPTION_NUMBER, &d->limit, 0.001, 1e6, "S  seconds that it may take, default no limit"},
        {"--quiet", OPTION_FLAG, &d->quiet, 0, 0, "no progress on the terminal"},
        {"--batch", OPTION_TEXT, &d->batch, 0, 0,
         "LIST  dress many garments, one a line; see muslin dress --batch --help"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    option options[DRESS_OPTIONS + sizeof outputs / sizeof *outputs];
    dress_init(d);
    memcpy(options + dress_options(d, options), outputs, sizeof outputs);
    if (!args_read("dress", "Sew a garment round a body and let it come to rest.", options, argc, argv))
        return EXIT_INPUT;
    return dress_check("dress", d);
}


static int run_failed(const dress *d)
{
    return complain(failure_code(d->outcome), "dress", "%s",
                    d->why.text[0] != '\0' ? d->why.text : mus_status_text(d->outcome));
}


int command_dress(int argc, char **argv)
{
    for (int i = 0; i < argc; i++)
        if (strcmp(argv[i], "--batch") == 0) return batch_dress(argc, argv);
    dress *d = malloc(sizeof *d);
    if (d == NULL) return complain(EXIT_FAILED, "dress", "no memory");
    int code = read_options(d, argc, argv);
    if (code != EXIT_DONE) {
        free(d);
        return code;
    }

    code = dress_open(d);
    if (code == EXIT_DONE) {
        code = dress_run(d);
        const int report = write_report(d);
        if (code == EXIT_DONE) code = report;
        if (code == EXIT_DONE && d->outcome != MUS_OK) code = run_failed(d);
    }
    dress_close(d);
    free(d);
    return code;
}
