/*
 * verify.c: `muslin verify`: cases with exact answers, run through the public API, as a table, CSV or JSON.
 *
 * The cases stand in the other files of this folder, one file a family. A row is printed as soon as its case has run,
 * since some cases take seconds. JSON holds all rows in one object and is printed at the end.
 */
#include "verify.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/args.h"
#include "command/commands.h"
#include "command/scene.h"

static int (*const families[])(verify *v) = {verify_step,  verify_motion,  verify_energy, verify_force,
                                              verify_cloth, verify_bend,    verify_drape,  verify_contact,
                                              verify_collide, verify_plane, verify_spline, verify_body};


/* ---- which cases ---- */

/* `asked` is the id itself, or its letters alone */
static bool names(const char *asked, const char *id)
{
    const size_t letters = strcspn(id, "0123456789");
    return strcmp(asked, id) == 0 || (strlen(asked) == letters && strncmp(asked, id, letters) == 0);
}


static bool wants(verify *v, const char *id, bool is_long)
{
    bool found = v->only_count == 0 && (!is_long || v->all);
    for (int32_t i = 0; i < v->only_count; i++) {
        if (!names(v->only[i], id)) continue;
        v->met[i] = true;
        if (!is_long || v->all || strcmp(v->only[i], id) == 0) found = true;
    }
    return found;
}


bool verify_wants(verify *v, const char *id)
{
    return wants(v, id, false);
}


bool verify_wants_long(verify *v, const char *id)
{
    return wants(v, id, true);
}


/* split "I3,B6" in place */
static int read_only(verify *v, char *text)
{
    for (char *at = text; at != NULL;) {
        char *comma = strchr(at, ',');
        if (comma != NULL) *comma = '\0';
        if (*at == '\0') return complain(EXIT_INPUT, "verify", "--only: an id is empty");
        if (v->only_count == VERIFY_ONLY)
            return complain(EXIT_INPUT, "verify", "--only: more than %d ids are given", VERIFY_ONLY);
        v->only[v->only_count++] = at;
        at = comma != NULL ? comma + 1 : NULL;
    }
    return EXIT_DONE;
}


/* ---- rows ---- */

static void begin_rows(verify *v)
{
    if (v->form == VERIFY_TABLE)
        printf("%-4s %-62s %14s %14s %9s %9s  %s\n", "id", "quantity", "exact", "got", "error", "tolerance", "pass");
    if (v->form == VERIFY_CSV) printf("id,quantity,exact,got,error,tolerance,pass\n");
    json_open(&v->j, NULL, '{');
    json_open(&v->j, "cases", '[');
}


static void add_row(verify *v, const char *id, const char *quantity, double exact, double got, double tolerance,
                    bool negative)
{
    const double error = exact != 0.0 ? fabs((got - exact) / exact) : fabs(got);
    const bool pass = negative ? error >= tolerance : error <= tolerance;
    v->rows++;
    if (!pass) v->failed++;
    if (pass && negative) v->known++;
    if (v->form == VERIFY_TABLE)
        printf("%-4s %-62s %14.9g %14.9g %9.1e %s%8.1e  %s\n", id, quantity, exact, got, error, negative ? ">" : " ",
               tolerance, !pass ? "NO" : negative ? "known" : "yes");
    if (v->form == VERIFY_CSV)
        printf("%s,\"%s\",%.17g,%.17g,%.3g,%.3g,%s\n", id, quantity, exact, got, error, tolerance,
               pass ? "true" : "false");
    if (v->form != VERIFY_JSON) fflush(stdout);

    json_open(&v->j, NULL, '{');
    json_text(&v->j, "id", id);
    json_text(&v->j, "quantity", quantity);
    json_number(&v->j, "exact", exact);
    json_number(&v->j, "got", got);
    json_number(&v->j, "error", error);
    json_number(&v->j, "tolerance", tolerance);
    json_bool(&v->j, "pass", pass);
    if (negative) json_bool(&v->j, "negative", true);
    json_close(&v->j, '}');
}


void verify_add(verify *v, const char *id, const char *quantity, double exact, double got, double tolerance)
{
    add_row(v, id, quantity, exact, got, tolerance, false);
}


void verify_add_negative(verify *v, const char *id, const char *quantity, double exact, double got, double least)
{
    add_row(v, id, quantity, exact, got, least, true);
}


void verify_broken(verify *v, const char *id, const char *quantity, mus_status status)
{
    const char *text = mus_context_error(v->context);
    complain(EXIT_FAILED, "verify", "%s %s: %s", id, quantity, text[0] != '\0' ? text : mus_status_text(status));
    add_row(v, id, quantity, 0.0, NAN, 0.0, false);
}


/* ---- the command ---- */

static int run_families(verify *v)
{
    int code = EXIT_DONE;
    begin_rows(v);
    for (size_t f = 0; f < sizeof families / sizeof families[0] && code == EXIT_DONE; f++) code = families[f](v);
    json_close(&v->j, ']');
    json_close(&v->j, '}');
    if (code != EXIT_DONE) return code;
    for (int32_t i = 0; i < v->only_count; i++)
        if (!v->met[i]) return complain(EXIT_INPUT, "verify", "--only: case \"%s\" is unknown", v->only[i]);
    if (v->form == VERIFY_JSON && !json_write(&v->j, "verify", "-")) return EXIT_FAILED;
    if (v->form == VERIFY_TABLE)
        printf("%d of %d rows pass, %d known failures\n", (int)(v->rows - v->failed - v->known),
               (int)(v->rows - v->known), (int)v->known);
    if (v->failed > 0) return complain(EXIT_FAILED, "verify", "%d of %d rows fail", (int)v->failed, (int)v->rows);
    return EXIT_DONE;
}


int command_verify(int argc, char **argv)
{
    bool as_json = false, as_csv = false;
    const char *only = NULL;
    verify v = {0};
    const option options[] = {{"--only", OPTION_TEXT, &only, 0, 0, "ID,...  these cases only, or families: I3,B6,D"},
                              {"--all", OPTION_FLAG, &v.all, 0, 0, "also the cases that take long"},
                              {"--csv", OPTION_STDOUT, &as_csv, 0, 0, "as CSV"},
                              {"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
                              {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("verify", "Run cases with exact answers; print exact value, computed value, error and tolerance.",
                    options, argc, argv))
        return EXIT_INPUT;
    v.form = as_json ? VERIFY_JSON : as_csv ? VERIFY_CSV : VERIFY_TABLE;

    char ids[1024];
    if (only != NULL && strlen(only) >= sizeof ids) return complain(EXIT_INPUT, "verify", "--only: too long a list");
    if (only != NULL) {
        memcpy(ids, only, strlen(only) + 1);
        if (read_only(&v, ids) != EXIT_DONE) return EXIT_INPUT;
    }
    scene s;
    int code = scene_open(&s, "verify");
    v.context = s.context;
    if (code == EXIT_DONE) code = run_families(&v);
    json_free(&v.j);
    scene_close(&s);
    return code;
}
