/*
 * test_hood.c: a hood that stands before the face when it is sewn lies on the head at rest with the face free; one that
 * hangs over the eyes is not worn.
 */

#include "drape/worn.h"

Suite *mus_suite_hood(void);

#define SPACING 0.02 /* [m] */


/* nonzero where the segment p q meets the triangle a b c */
static int32_t meets(const double *p, const double *q, const double *a, const double *b, const double *c)
{
    double d[3], e[3], f[3], s[3], n[3], m[3];
    for (int32_t k = 0; k < 3; k++) d[k] = q[k] - p[k], e[k] = b[k] - a[k], f[k] = c[k] - a[k], s[k] = p[k] - a[k];
    for (int32_t k = 0; k < 3; k++) {
        const int32_t i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = d[i] * f[j] - d[j] * f[i], m[k] = s[i] * e[j] - s[j] * e[i];
    }
    const double det = e[0] * n[0] + e[1] * n[1] + e[2] * n[2];
    const double u = (s[0] * n[0] + s[1] * n[1] + s[2] * n[2]) / det;
    const double v = (d[0] * m[0] + d[1] * m[1] + d[2] * m[2]) / det;
    const double t = (f[0] * m[0] + f[1] * m[1] + f[2] * m[2]) / det;
    return det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t <= 1.0;
}


/* triangles of the cloth before the eyes and nose: level lines of sight from inside the head, half way from the chin to
 * the crown (a head is an eighth of an adult) */
static int32_t before_the_face(const worn *w)
{
    double crown[3];
    int32_t count = 0;
    ck_assert_int_eq(mus_body_landmark(w->body, MUS_LANDMARK_CROWN, crown), MUS_OK);
    const double *x = mus_drape_positions(w->drape);
    const int32_t *corner = mus_cloth_triangles(w->cloth);
    for (int32_t ray = -1; ray <= 1; ray++) {
        const double eye[3] = {crown[0] + 0.02 * ray, crown[1] * (1.0 - 1.0 / 16.0), crown[2]};
        const double ahead[3] = {eye[0], eye[1], eye[2] + 0.6};
        for (int32_t k = 0; k < mus_cloth_triangle_count(w->cloth); k++)
            count += meets(eye, ahead, x + 3 * corner[3 * k], x + 3 * corner[3 * k + 1], x + 3 * corner[3 * k + 2]);
    }
    return count;
}


typedef struct hood_row {
    const char *design, *size;
    double head; /* [m] girth that the hood is drafted for; 0: that of the body */
} hood_row;

/* the last one takes the start with found places, which do not tell that it has a hood */
static const hood_row rows[] = {
    {"hoodie_v", "W40", 0.0}, {"hoodie", "M50", 0.66}, {"hoodie_zip", "M50", 0.66}, {"hoodie", "M58", 0.0}};


/* a body of the size and a design whose hood is for another head */
static worn hood_start(const hood_row *row, mus_dress_def *def)
{
    worn w = worn_body(row->size);
    if (row->head > 0.0) ck_assert_int_eq(mus_tape_set(w.tape, MUS_MEASURE_HEAD, row->head, MUS_SOURCE_GIVEN), MUS_OK);
    worn_put_on_design(&w, row->design, NULL);
    mus_dress_def_init(def, sizeof *def);
    def->spacing = SPACING, def->self_contact = 1;
    return w;
}


START_TEST(the_face_is_free)
{
    mus_dress_def def;
    worn w = hood_start(&rows[_i], &def);
    ck_assert_msg(mus_dress(w.context, w.pattern, w.body, &def, NULL, NULL, &w.cloth, &w.drape) == MUS_OK, "%s",
                  mus_context_error(w.context));
    ck_assert_int_eq(before_the_face(&w), 0);
    worn_end(&w);
}
END_TEST


/* sewn and settled without that, a deep hood hangs over the eyes; so the garment is not worn */
START_TEST(a_hood_over_the_eyes_is_not_worn)
{
    mus_dress_def def;
    mus_drape_def drape;
    mus_cloth_def cut;
    mus_worn how;
    const hood_row row = {"hoodie", "M50", 0.72};
    worn w = hood_start(&row, &def);
    mus_cloth_def_init(&cut, sizeof cut);
    mus_drape_def_init(&drape, sizeof drape);
    mus_worn_init(&how, sizeof how);
    cut.spacing = SPACING, drape.self_contact = 1;
    ck_assert_int_eq(mus_cloth_create(w.context, w.pattern, &cut, &w.cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, &drape, &w.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(w.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_gt(before_the_face(&w), 0);
    ck_assert_int_eq(mus_fit_worn(w.drape, w.pattern, w.body, &how), MUS_OK);
    ck_assert_int_eq(how.kind, MUS_WORN_HOOD);
    ck_assert_str_eq(how.text, "not worn: the hood hangs over the eyes, at hood_left");
    worn_end(&w);
}
END_TEST


Suite *mus_suite_hood(void)
{
    Suite *suite = suite_create("hood");
    TCase *tc = tcase_create("hood");
    tcase_set_timeout(tc, 60);
    tcase_add_loop_test(tc, the_face_is_free, 0, (int)(sizeof rows / sizeof rows[0]));
    tcase_add_test(tc, a_hood_over_the_eyes_is_not_worn);
    suite_add_tcase(suite, tc);
    return suite;
}
