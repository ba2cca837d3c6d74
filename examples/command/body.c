/*
 * body.c: muslin body: makes a body from a tape and prints the measures asked for beside those of the surface made.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "language.h"
#include "mesh.h"
#include "scene.h"
#include "stance.h"
#include "muslin/language.h"
#include "surface.h"

#define MEASURE_COLUMNS 40 /* of a name in a language other than English; the longest has 37 */


/* the head of the table; English words end with their column, which others need not fit */
static void write_head(int32_t language)
{
    static const char *const keys[] = {"head.asked", "head.made", "head.error"};
    if (language == MUS_LANGUAGE_ENGLISH) {
        printf("%-16s %9s   %9s   %9s\n", "measure", "asked", "made", "error");
        return;
    }
    language_pad(mus_language_text(language, "head.measures"), MEASURE_COLUMNS + 1);
    for (int32_t i = 0; i < 3; i++) language_pad(mus_language_text(language, keys[i]), 13);
    printf("\n");
}


static void write_table(const mus_body *body, int32_t language, double spent)
{
    const bool english = language == MUS_LANGUAGE_ENGLISH;
    const char *degree = mus_language_text(language, "unit.degree");
    write_head(language);
    for (int32_t m = 0; m < mus_measure_count(); m++) {
        const double asked = mus_body_asked(body, m), made = mus_body_made(body, m);
        if (!isfinite(asked)) continue;
        const int angle = mus_measure_unit(m) == 'r';
        char note[64] = "", name[128];
        if (mus_body_source(body, m) == MUS_SOURCE_DERIVED)
            snprintf(note, sizeof note, "  %s", mus_language_text(language, "measure.derived"));
        mus_language_compose(language, "measure", mus_measure_name(m), name, sizeof name);
        language_pad(english ? mus_measure_name(m) : name, english ? 16 : MEASURE_COLUMNS);
        printf(" %8.2f ", asked * (angle ? 57.295779513082 : 100.0));
        language_pad(angle ? degree : "cm", 3);
        const double off = fabs(made - asked) < 5e-6 ? 0.0 : made - asked; /* no "-0.00" */
        if (isfinite(made) && angle)
            printf(" %8.2f %s %5.2f %s%s\n", made * 57.295779513082, degree, off * 57.295779513082, degree, note);
        else if (isfinite(made))
            printf(" %8.2f cm %6.2f mm%s\n", 100.0 * made, 1000.0 * off, note);
        else
            printf("%s%s\n", note[0] != '\0' ? "                      " : "", note);
    }
    const char *volume = mus_language_text(language, "measure.volume"), *place = strstr(volume, "{0}");
    printf("%.*s%.1f", (int)(place - volume), volume, 1000.0 * mus_body_volume(body));
    volume = place + 3, place = strstr(volume, "{1}");
    printf("%.*s%.1f%s\n", (int)(place - volume), volume, 1000.0 * spent, place + 3);
}


static void write_json(const mus_body *body, double spent, json *j)
{
    json_open(j, NULL, '{');
    json_open(j, "measures", '[');
    for (int32_t m = 0; m < mus_measure_count(); m++) {
        json_open(j, NULL, '{');
        json_text(j, "name", mus_measure_name(m));
        json_number(j, "asked_m", mus_body_asked(body, m));
        json_number(j, "made_m", mus_body_made(body, m));
        json_bool(j, "derived", mus_body_source(body, m) == MUS_SOURCE_DERIVED);
        json_close(j, '}');
    }
    json_close(j, ']');
    json_number(j, "volume_m3", mus_body_volume(body));
    json_number(j, "seconds", spent);
    json_warnings(j);
    json_close(j, '}');
}


/* Prints the names of poses and movements, one a line. */
static int list_poses(void)
{
    for (int32_t i = 0; i < mus_pose_count(); i++) printf("pose %s\n", mus_pose_name(i));
    for (int32_t i = 0; i < mus_move_count(); i++) printf("move %s\n", mus_move_name(i));
    return output_end("body");
}


int command_body(int argc, char **argv)
{
    source from = {0};
    mesh_source mesh = {0};
    surface_files files = {0};
    stance how = {0};
    bool as_json = false, poses = false;
    const char *asked = NULL;
    const option options[] = {SOURCE_TAPE(from),
                              SOURCE_POSTURE(from),
                              SOURCE_MESH(mesh),
                              {"--pose", OPTION_TEXT, &how.pose, 0, 0, "NAME  pose of the body"},
                              {"--move", OPTION_TEXT, &how.move, 0, 0, "NAME  a movement in place of a pose"},
                              {"--at", OPTION_NUMBER, &how.at, 0, 1e6, "SECONDS  time in the movement, default 0"},
                              {"--poses", OPTION_FLAG, &poses, 0, 0, "print the names of poses and movements only"},
                              SURFACE_FILES(files),
                              LANGUAGE_OPTION(asked),
                              {"--json", OPTION_STDOUT, &as_json, 0, 0, "measures as JSON on standard output"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("body", "Make the body of a tape or of a mesh; print the measures asked for and made.",
                    options, argc, argv))
        return EXIT_INPUT;
    const int32_t language = language_read("body", asked);
    if (language == MUS_NONE) return EXIT_INPUT;
    if (poses) return list_poses();
    if (how.pose != NULL && how.move != NULL) return complain(EXIT_INPUT, "body", "--pose and --move are two stances");
    if (mesh.file != NULL && scene_upright(&from, "body") != EXIT_DONE) return EXIT_INPUT;
    if (!surface_check(&files)) return EXIT_INPUT;
    if (mesh.file != NULL) return mesh_command(&mesh, &how, &files, as_json);

    scene s;
    mus_body *body = NULL;
    json j = {0};
    int code = scene_open(&s, "body");
    if (code == EXIT_DONE) code = scene_tape(&s, &from);
    if (code == EXIT_DONE) {
        const double start = seconds();
        mus_status status = scene_body(&s, &from, NULL, &body);
        const double spent = seconds() - start;
        if (status == MUS_OK) status = stance_take(&s, &how, &body);
        code = status != MUS_OK ? scene_fail(&s, status) : surface_write(&s, &files, body);
        if (code != EXIT_DONE) {
            /* the line is printed */
        } else if (as_json) {
            write_json(body, spent, &j);
            if (!json_write(&j, "body", "-")) code = EXIT_FAILED;
        } else if (!is_stdout(files.obj) && !is_stdout(files.glb) && !is_stdout(files.png)) {
            write_table(body, language, spent);
        }
    }
    json_free(&j);
    mus_body_destroy(body);
    scene_close(&s);
    return code;
}
