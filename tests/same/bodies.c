/*
 * bodies.c: rows "body/...": bodies of table sizes and of files, in other samplings, postures and without limbs;
 * "pose/..." and "move/...": named poses and movements; "scan/...": bodies of meshes.
 */
#include "scene.h"

#include <stdio.h>
#include <string.h>

#define CONTOUR 32

/* ---- what a body is ---- */

static void digest_limbs(same_run *run, const mus_body *body)
{
    double points[2 * 3 * CONTOUR];
    int32_t range[4];
    for (int32_t limb = 0; limb < mus_body_limb_count(body); limb++) {
        same_text(run, mus_body_limb_name(body, limb));
        if (same_status(run, mus_body_limb_range(body, limb, range))) same_ints(run, range, 4);
        for (int32_t c = 0; c < mus_body_contour_count(body, limb); c++) {
            same_text(run, mus_body_contour_name(body, limb, c));
            if (same_status(run, mus_body_contour_points(body, limb, c, CONTOUR, points)))
                same_reals(run, points, 3 * CONTOUR);
        }
    }
}


/* depths of a lattice of points about the body */
static void digest_depths(same_run *run, const mus_body *body)
{
    double points[3 * 512], depth[512], normal[3 * 512];
    for (int i = 0; i < 512; i++) {
        points[3 * i] = 0.1 * (i % 8 - 3.5);
        points[3 * i + 1] = 0.02 + 0.21 * (i / 8 % 8);
        points[3 * i + 2] = 0.05 * (i / 64 - 3.5);
    }
    if (!same_status(run, mus_body_depth(body, 512, points, depth, normal))) return;
    same_reals(run, depth, 512);
    same_reals(run, normal, 3 * 512);
}


static void digest_body(same_run *run, const mus_body *body)
{
    const int64_t vertices = mus_body_vertex_count(body), triangles = mus_body_triangle_count(body);
    double place[3];
    same_reals(run, mus_body_vertices(body), 3 * vertices);
    same_reals(run, mus_body_normals(body), 3 * vertices);
    same_ints(run, mus_body_triangles(body), 3 * triangles);
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        same_real(run, mus_body_asked(body, m));
        same_real(run, mus_body_made(body, m));
        same_int(run, mus_body_source(body, m));
    }
    same_real(run, mus_body_volume(body));
    for (int32_t l = 0; l < MUS_LANDMARK_COUNT; l++)
        if (same_status(run, mus_body_landmark(body, l, place))) same_reals(run, place, 3);
    digest_limbs(run, body);
    digest_depths(run, body);
}


static void digest_made(same_run *run, const mus_tape *tape, const mus_body_def *def)
{
    mus_body *body = NULL;
    if (same_status(run, mus_body_create(run->context, tape, def, &body))) digest_body(run, body);
}


static void make_size(same_run *run, const void *what, int32_t index)
{
    (void)what;
    digest_made(run, same_size(run, mus_tape_size_name(index)), NULL);
}


/* what: a file of the real data, a '#' before the row of a table */
static void make_file(same_run *run, const void *what, int32_t index)
{
    (void)index;
    char file[128];
    snprintf(file, sizeof file, "%s", (const char *)what);
    char *row = strchr(file, '#');
    if (row != NULL) *row++ = '\0';
    digest_made(run, same_tape(run, file, row, true), NULL);
}


/* ---- options ---- */

static void make_option(same_run *run, const void *what, int32_t index)
{
    (void)what;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    switch (index) {
    case 0:
        def.samples = 48, def.ring_spacing = 0.02;
        break;
    case 1:
        def.ellipse = 1;
        break;
    case 2:
        def.plain = 1;
        break;
    case 3:
        def.without = MUS_WITHOUT_ARM_LEFT | MUS_WITHOUT_HAND_RIGHT | MUS_WITHOUT_SHANK_LEFT | MUS_WITHOUT_FOOT_RIGHT;
        break;
    case 4:
        def.stoop = 0.03, def.head_forward = 0.02, def.sway = -0.01;
        break;
    default:
        def.stoop = -0.01, def.sway = 0.03, def.plain = 1;
        break;
    }
    digest_made(run, same_size(run, "W40"), &def);
}


/* a body of given limbs: an ellipse stack and a prism of six corners */
static void make_given(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    const double stack[3 * 6] = {0.1, 0, 0, 0.12, 0.09, 2.0, 0.4, 0.01, 0, 0.1, 0.1, 2.5, 0.7, 0, 0.02, 0.14, 0.1, 3.0};
    const double prism[2 * 6] = {0.0, 0, 0, 0.05, 0.05, 2.0, 0.3, 0, 0, 0.05, 0.05, 2.0};
    const double corners[2 * 6 * 2] = {0.05, 0, 0.025, 0.045, -0.025, 0.045, -0.05, 0, -0.025, -0.045, 0.025, -0.045,
                                       0.06, 0, 0.03,  0.05,  -0.03,  0.05,  -0.06, 0, -0.03,  -0.05,  0.03,  -0.05};
    mus_limb limb[2];
    mus_body *body = NULL;
    for (int i = 0; i < 2; i++) mus_limb_init(&limb[i], sizeof limb[i]);
    limb[0].name = "form", limb[0].contours = 3, limb[0].contour = stack;
    limb[0].pole[0] = 0.02, limb[0].pole[1] = 0.8;
    limb[1].name = "prism", limb[1].contours = 2, limb[1].contour = prism;
    limb[1].corners = 6, limb[1].outline = corners;
    limb[1].origin[0] = 0.4, limb[1].axis[0] = 0.2, limb[1].pole[0] = -0.03, limb[1].pole[1] = 0.33;
    if (same_status(run, mus_body_create_limbs(run->context, 2, limb, NULL, &body))) digest_body(run, body);
}


/* ---- poses ---- */

static void digest_posed(same_run *run, const mus_body *body, const mus_pose *pose)
{
    mus_body *posed = NULL;
    same_reals(run, pose->place, 3);
    same_reals(run, &pose->angle[0][0], 3 * MUS_JOINT_COUNT);
    if (same_status(run, mus_body_pose(body, pose, &posed))) digest_body(run, posed);
    mus_body_destroy(posed);
}


static void make_pose(same_run *run, const void *what, int32_t index)
{
    (void)what;
    static const char *const sizes[] = {"W40", "M56", "C116"};
    mus_pose pose, rest;
    mus_pose_init(&pose, sizeof pose);
    mus_pose_init(&rest, sizeof rest);
    mus_body *body = same_body(run, same_size(run, sizes[index % 3]));
    same_must(run, mus_pose_named(run->context, mus_pose_name(index), &pose), "mus_pose_named");
    same_reals(run, &pose.angle[0][0], 3 * MUS_JOINT_COUNT);
    same_must(run, mus_body_rest_pose(body, &rest), "mus_body_rest_pose");
    same_reals(run, &rest.angle[0][0], 3 * MUS_JOINT_COUNT);
    same_must(run, mus_body_clear_arms(body, &pose, 0.02), "mus_body_clear_arms");
    same_must(run, mus_body_stand(body, mus_pose_feet(mus_pose_name(index)), &pose), "mus_body_stand");
    digest_posed(run, body, &pose);
}


static void make_move(same_run *run, const void *what, int32_t index)
{
    (void)what;
    mus_body *body = same_body(run, same_size(run, "W40"));
    mus_move *move[2] = {NULL, NULL};
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    same_must(run, mus_body_move(body, mus_move_name(index), 0.02, &move[0]), "mus_body_move");
    same_must(run, mus_move_named(run->context, mus_move_name(index), 1.7, &move[1]), "mus_move_named");
    for (int m = 0; m < 2; m++) {
        same_real(run, mus_move_period(move[m]));
        same_real(run, mus_move_duration(move[m]));
        for (int i = 0; i < 40; i++) {
            same_must(run, mus_move_at(move[m], 0.07 * i, &pose), "mus_move_at");
            same_reals(run, pose.place, 3);
            same_reals(run, &pose.angle[0][0], 3 * MUS_JOINT_COUNT);
        }
    }
    digest_posed(run, body, &pose);
}


static void make_joints(same_run *run, const void *what, int32_t index)
{
    (void)what, (void)index;
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        same_text(run, mus_joint_name(j));
        for (int32_t axis = 0; axis < 3; axis++) {
            double limit[2];
            same_must(run, mus_joint_limits(j, axis, &limit[0], &limit[1]), "mus_joint_limits");
            same_reals(run, limit, 2);
        }
    }
}


/* ---- meshes ---- */

static void make_scan(same_run *run, const void *what, int32_t index)
{
    (void)index;
    mus_scan_report r;
    mus_scan_report_init(&r, sizeof r);
    mus_body *body = same_scan(run, what, true, &r);
    const int32_t counts[] = {r.vertices, r.contours, r.holes, r.filled};
    const double values[] = {r.unit, r.stature, r.crotch, r.widest_hole, r.deepest_fill};
    same_ints(run, counts, 4);
    same_reals(run, values, 5);
    same_reals(run, r.frame, 9);
    same_reals(run, r.place, 3);
    same_reals(run, r.armpit, 2);
    same_reals(run, r.arm_angle, 2);
    same_reals(run, r.girth, MUS_SCAN_GIRTH_COUNT);
    same_reals(run, r.girth_height, MUS_SCAN_GIRTH_COUNT);
    same_reals(run, &r.mesh_to_body[0][0], 3 * MUS_SCAN_PART_COUNT);
    same_reals(run, &r.body_to_mesh[0][0], 3 * MUS_SCAN_PART_COUNT);
    digest_body(run, body);
    mus_pose pose;
    mus_pose_init(&pose, sizeof pose);
    same_must(run, mus_pose_named(run->context, "step", &pose), "mus_pose_named");
    if (same_status(run, mus_body_ground(body, &pose))) digest_posed(run, body, &pose);
}


void same_bodies(same_list *list)
{
    static const char *const files[] = {
        "garmentcode/bodies/mean_all.yaml",       "garmentcode/bodies/mean_female.yaml",
        "garmentcode/bodies/m_smpl_average_A40.yaml", "valentina/measurements/gost_man_500_1760.vit",
        "valentina/measurements/person_01.vit",   "freesewing/models.csv#cisFemaleAdult30",
        "freesewing/models.csv#cisMaleAdult40",   "freesewing/models.csv#cisMaleGiant150"};
    static const char *const scans[] = {"mean_all", "mean_female", "m_smpl_average_A40"};
    static const char *const options[] = {"coarse", "ellipse", "plain", "without", "stoop", "sway"};
    for (int32_t i = 0; i < mus_tape_size_count(); i++)
        same_add(list, make_size, "body/%s", mus_tape_size_name(i))->index = i;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        same_row *row = same_add(list, make_file, "body/%s", strrchr(files[i], '/') + 1);
        row->what = files[i], row->data = true;
    }
    for (int32_t i = 0; i < 6; i++) same_add(list, make_option, "body/W40-%s", options[i])->index = i;
    same_add(list, make_given, "body/given-limbs");
    for (int32_t i = 0; i < mus_pose_count(); i++) same_add(list, make_pose, "pose/%s", mus_pose_name(i))->index = i;
    for (int32_t i = 0; i < mus_move_count(); i++) same_add(list, make_move, "move/%s", mus_move_name(i))->index = i;
    same_add(list, make_joints, "pose/joints");
    for (int i = 0; i < 3; i++) {
        same_row *row = same_add(list, make_scan, "scan/%s", scans[i]);
        row->what = scans[i], row->data = true;
    }
}
