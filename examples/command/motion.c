/*
 * motion.c: muslin dress --pose and --move. The garment is settled on the body as made. Then the body moves and the
 * cloth is stepped, at 60 frames a second of cloth time; mus_drape_estimate() gives the number of steps of a frame.
 *
 * A pose is reached by a smooth change of all angles. A movement begins with a smooth change into its first pose, whose
 * frames are not counted. The largest depth of a node over all frames and the longest way of a node between two frames
 * are recorded. Pictures are FOLDER/frame_0001.png and on; the animated files have all frames as keys.
 */
#include "motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EASE_SECONDS 1.5
#define ARM_GAP 0.02 /* [m] distance of the arms from the sides; chosen: room for cloth between them */

/* positions and normals of one mesh at all keys */
typedef struct track {
    double *positions, *normals; /* (keys x vertices x 3) */
    int32_t vertices;
} track;

/* the state of a movement */
typedef struct lead {
    const dressed *d;
    motion *m;
    mus_move *move;
    mus_estimate plan;
    double *last; /* (nodes x 3) positions in the frame before [m] */
    track cloth, body;
    double *times;
    film film;
    bool filming;
} lead;


int motion_check(const scene *s, const motion *m)
{
    mus_pose pose;
    mus_move *move = NULL;
    mus_pose_init(&pose, sizeof pose);
    mus_status status = MUS_OK;
    if (m->pose != NULL && m->move != NULL)
        return complain(EXIT_INPUT, s->command, "--pose and --move exclude each other");
    if (m->pose != NULL) status = mus_pose_named(s->context, m->pose, &pose);
    if (m->move != NULL) status = mus_move_named(s->context, m->move, 1.7, &move);
    mus_move_destroy(move);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


/* Returns the height of the cloth's middle above the hip's middle, along the trunk in its present pose [m]. */
static mus_status height_on_body(const dressed *d, double *out)
{
    mus_pose pose;
    mus_body *posed = NULL;
    double hip[3];
    mus_pose_init(&pose, sizeof pose);
    mus_status status = mus_drape_body_pose(d->drape, &pose);
    if (status == MUS_OK) status = mus_body_pose(d->body, &pose, &posed);
    if (status == MUS_OK) status = mus_body_landmark(posed, MUS_LANDMARK_HIP, hip);
    mus_body_destroy(posed);
    if (status != MUS_OK) return status;
    const int32_t n = mus_drape_node_count(d->drape);
    const double *x = mus_drape_positions(d->drape);
    double sum = 0.0;
    for (int32_t i = 0; i < n; i++) sum += x[3 * (ptrdiff_t)i + 1];
    *out = sum / n - hip[1];
    return MUS_OK;
}


/* Steps one frame while the body moves into `pose`, and records depth and way of the nodes. */
static mus_status step_frame(const dressed *d, motion *m, const mus_estimate *plan, const mus_pose *pose,
                             double *last)
{
    const double frame = 1.0 / MOTION_RATE, start = seconds();
    mus_status status = mus_drape_pose_body(d->drape, pose, frame);

    /* the number of steps estimated at rest, or more where the pose has lowered the step bound */
    const int32_t least = (int32_t)ceil(frame / (0.9 * mus_drape_step_bound(d->drape)));
    const int32_t steps = least > plan->steps_per_frame ? least : plan->steps_per_frame;
    if (status == MUS_OK) status = mus_drape_step(d->drape, steps, frame / steps);
    m->seconds += seconds() - start;
    if (status != MUS_OK) return status;
    m->steps += steps;

    mus_drape_report r;
    mus_drape_report_init(&r, sizeof r);
    status = mus_drape_report_get(d->drape, &r);
    if (status != MUS_OK) return status;
    if (r.max_penetration > m->max_depth) m->max_depth = r.max_penetration;
    if (r.step_parts > m->step_parts) m->step_parts = r.step_parts;
    const int32_t n = mus_drape_node_count(d->drape);
    const double *x = mus_drape_positions(d->drape);
    for (ptrdiff_t i = 0; i < n; i++) {
        const double a = x[3 * i] - last[3 * i], b = x[3 * i + 1] - last[3 * i + 1], c = x[3 * i + 2] - last[3 * i + 2];
        m->max_jump = fmax(m->max_jump, sqrt(a * a + b * b + c * c));
    }
    memcpy(last, x, (size_t)n * 3 * sizeof *last);
    return MUS_OK;
}


/* Moves all angles from the present pose to `target`, by the share 3 u^2 - 2 u^3 at relative time u. */
static mus_status ease(const dressed *d, motion *m, const mus_estimate *plan, const mus_pose *target,
                       double *last)
{
    mus_pose from, now;
    mus_pose_init(&from, sizeof from);
    mus_status status = mus_drape_body_pose(d->drape, &from);
    const int32_t frames = (int32_t)(EASE_SECONDS * MOTION_RATE);
    for (int32_t k = 1; k <= frames && status == MUS_OK; k++) {
        const double u = (double)k / frames, w = u * u * (3.0 - 2.0 * u);
        now = from;
        for (int i = 0; i < 3; i++) {
            now.place[i] += w * (target->place[i] - from.place[i]);
            for (int j = 0; j < MUS_JOINT_COUNT; j++)
                now.angle[j][i] += w * (target->angle[j][i] - from.angle[j][i]);
        }
        status = step_frame(d, m, plan, &now, last);
    }
    return status;
}


static mus_status begin(const dressed *d, mus_estimate *plan, double **last)
{
    const size_t bytes = (size_t)mus_drape_node_count(d->drape) * 3 * sizeof **last;
    *last = malloc(bytes + 1);
    if (*last == NULL) return MUS_ERR_MEMORY;
    memcpy(*last, mus_drape_positions(d->drape), bytes);
    mus_estimate_init(plan, sizeof *plan);
    return mus_drape_estimate(d->drape, 1.0 / MOTION_RATE, plan);
}


mus_status motion_into(const dressed *d, motion *m, const char *pose)
{
    mus_estimate plan;
    mus_pose target;
    double *last = NULL;
    mus_pose_init(&target, sizeof target);
    mus_status status = mus_pose_named(d->s->context, pose, &target);
    if (status == MUS_OK) status = mus_body_clear_arms(d->body, &target, ARM_GAP);
    if (status == MUS_OK) status = mus_body_stand(d->body, mus_pose_feet(pose), &target);
    if (status == MUS_OK) status = begin(d, &plan, &last);
    if (status == MUS_OK) status = ease(d, m, &plan, &target, last);
    if (status == MUS_OK) status = mus_drape_pose_body(d->drape, &target, 0.0);
    free(last);
    return status;
}


/* ---- a movement ---- */

static bool track_open(track *t, int32_t keys, int32_t vertices)
{
    const size_t count = (size_t)keys * (size_t)vertices * 3;
    t->vertices = vertices;
    t->positions = malloc(count * sizeof *t->positions);
    t->normals = malloc(count * sizeof *t->normals);
    return t->positions != NULL && t->normals != NULL;
}


static void track_keep(track *t, int32_t key, const double *positions, const double *normals)
{
    const size_t count = (size_t)t->vertices * 3, at = (size_t)key * count;
    memcpy(t->positions + at, positions, count * sizeof *positions);
    memcpy(t->normals + at, normals, count * sizeof *normals);
}


/* Writes the picture of a frame, and adds its key to the animated file. */
static int show_frame(lead *q, int32_t k, const mus_pose *pose)
{
    const dressed *d = q->d;
    const bool keep = q->times != NULL;
    if (!q->filming && !keep) return EXIT_DONE;
    mus_body *posed = NULL;
    garment g = {0};
    mus_status status = MUS_OK;
    int code = EXIT_DONE;
    if (q->filming) {
        char path[4096];
        snprintf(path, sizeof path, "%s/frame_%04d.png", q->m->frames, (int)k + 1);
        status = mus_body_pose(d->body, pose, &posed);
        if (status == MUS_OK) code = garment_make(d->s, d->l, posed, d->cloth, d->drape, &g);
        if (status == MUS_OK && code == EXIT_DONE) code = film_shoot(&q->film, &g, path);
        mus_body_destroy(posed);
        posed = NULL;
        garment_free(&g);
    }
    if (status == MUS_OK && code == EXIT_DONE && keep) {
        status = mus_body_pose(d->thin != NULL ? d->thin : d->body, pose, &posed);
        if (status == MUS_OK) code = garment_make(d->s, d->l, posed, d->cloth, d->drape, &g);
        if (status == MUS_OK && code == EXIT_DONE) {
            track_keep(&q->body, k, g.view[0].positions, g.view[0].normals);
            track_keep(&q->cloth, k, g.view[1].positions, g.view[1].normals);
            q->times[k] = (double)k / MOTION_RATE;
        }
        mus_body_destroy(posed);
        garment_free(&g);
    }
    return status == MUS_OK ? code : scene_fail(d->s, status);
}


/* Writes the animated files: the meshes of the last frame, with the keys. */
static int write_film(lead *q, const char *fabric, const char *const *files)
{
    const dressed *d = q->d;
    garment g;
    int code = garment_make(d->s, d->l, d->thin != NULL ? d->thin : d->body, d->cloth, d->drape, &g);
    if (code == EXIT_DONE) {
        garment_motion moves = {.keys = q->m->made, .times = q->times};
        for (int i = 0; i < 2; i++) mus_mesh_motion_init(&moves.move[i], sizeof moves.move[i]);
        moves.move[0].positions = q->body.positions, moves.move[0].normals = q->body.normals;
        moves.move[1].positions = q->cloth.positions, moves.move[1].normals = q->cloth.normals;
        const mus_status status = garment_write(d->s, &g, d->cloth, fabric, &moves, files);
        if (status != MUS_OK) code = scene_fail_output(d->s, status);
    }
    garment_free(&g);
    return code;
}


/* Computes a box for the camera of all frames: it contains the standing body with its arms spread. */
static void frame_box(const mus_body *body, double *box)
{
    const double *x = mus_body_vertices(body);
    const int32_t n = mus_body_vertex_count(body);
    double high = 0.0, wide = 0.0;
    for (ptrdiff_t i = 0; i < n; i++) {
        high = fmax(high, x[3 * i + 1]);
        wide = fmax(wide, hypot(x[3 * i], x[3 * i + 2]));
    }
    box[0] = box[2] = -0.85 * wide, box[1] = 0.0;
    box[3] = box[5] = 0.85 * wide, box[4] = 1.02 * high;
}


static int open_lead(lead *q, bool keep, double *box)
{
    const dressed *d = q->d;
    const int32_t count = (int32_t)q->m->count;
    if (keep) {
        q->times = malloc((size_t)count * sizeof *q->times);
        if (q->times == NULL || !track_open(&q->cloth, count, mus_cloth_node_count(d->cloth)) ||
            !track_open(&q->body, count, mus_body_vertex_count(d->thin != NULL ? d->thin : d->body)))
            return complain(EXIT_FAILED, d->s->command, "no memory for %d frames", (int)count);
    }
    if (q->m->frames == NULL) return EXIT_DONE;
    frame_box(d->body, box);
    q->filming = true;
    return film_open(&q->film, d->s, d->l, box);
}


static void close_lead(lead *q)
{
    if (q->filming) film_close(&q->film);
    mus_move_destroy(q->move);
    free(q->cloth.positions);
    free(q->cloth.normals);
    free(q->body.positions);
    free(q->body.normals);
    free(q->times);
    free(q->last);
}


/* Moves the body into the first pose, then steps frame by frame. */
static int lead_frames(lead *q, mus_status *status)
{
    const dressed *d = q->d;
    motion *m = q->m, before = {0};
    mus_pose pose;
    double start = 0.0, end = 0.0;
    mus_pose_init(&pose, sizeof pose);
    *status = mus_move_at(q->move, 0.0, &pose);
    if (*status == MUS_OK) *status = ease(d, &before, &q->plan, &pose, q->last);
    if (*status == MUS_OK) *status = height_on_body(d, &start);
    m->max_depth = before.max_depth;
    int code = EXIT_DONE;
    for (int32_t k = 0; k < (int32_t)m->count && *status == MUS_OK && code == EXIT_DONE; k++) {
        if (k > 0) {
            *status = mus_move_at(q->move, (double)k / MOTION_RATE, &pose);
            if (*status == MUS_OK) *status = step_frame(d, m, &q->plan, &pose, q->last);
        }
        if (*status != MUS_OK) break;
        code = show_frame(q, k, &pose);
        m->made = k + 1;
    }
    if (*status == MUS_OK) *status = height_on_body(d, &end);
    m->slid = end - start;
    return code;
}


bool motion_filed(const char *const *files)
{
    return files[MUS_MESH_GLB] != NULL || files[MUS_MESH_USDA] != NULL || files[MUS_MESH_PC2] != NULL;
}


int motion_lead(const dressed *d, motion *m, const char *fabric, const char *const *files, mus_status *status)
{
    lead q = {.d = d, .m = m};
    double box[6];
    int code = open_lead(&q, motion_filed(files), box);
    if (code == EXIT_DONE) {
        *status = mus_body_move(d->body, m->move, ARM_GAP, &q.move);
        if (*status == MUS_OK) *status = begin(d, &q.plan, &q.last);
        if (*status == MUS_OK) code = lead_frames(&q, status);
        if (code == EXIT_DONE && motion_filed(files) && m->made > 0) code = write_film(&q, fabric, files);
    }
    close_lead(&q);
    return code;
}
