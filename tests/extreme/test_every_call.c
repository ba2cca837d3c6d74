/*
 * test_every_call.c: every public function where memory fails, by the tables of every_call.h.
 *
 * A call that allocates is made with its first allocation failing, then its second and so on, on the same objects,
 * until it gets through: each failure is MUS_ERR_MEMORY with a sentence, changes no object, makes none and leaves no
 * file; in the end results and objects are those of a call that never lacked memory. All of it twice: with one
 * allocation that fails, and with all from one on. Of more than 250 allocations, of calls that move cloth more than 40,
 * every second, third, ... fails. The other calls allocate nothing, so they cannot fail in this way.
 */
#include "extreme/every_call.h"
#include "extreme/world.h"

Suite *mus_suite_every_call(void);

/* ---- what a call needs besides ---- */

static void nothing(world *w)
{
    (void)w;
}


static void begun(world *w)
{
    GOOD(mus_catalogue_begin(w->have.catalogue));
    GOOD(mus_catalogue_add(w->have.catalogue, P, "second", NULL));
}


static void another_drape(world *w)
{
    GOOD(mus_drape_create(w->context, w->have.cloth, w->have.body, &w->drape_def, &w->made.drape));
}


static void another_pattern(world *w)
{
    GOOD(mus_design_draft(w->context, mus_design_find("skirt"), w->have.tape, NULL, &w->made.pattern));
}


static void tacked(world *w)
{
    GOOD(mus_drape_tack(w->have.drape, 0, 3, 10.0, NULL));
}


static void on_ground(world *w)
{
    GOOD(mus_drape_add_plane(w->have.drape, NULL, NULL));
}


static void sewn(world *w)
{
    GOOD(mus_drape_sew(w->have.drape, NULL, NULL));
}


static void edited(world *w)
{
    GOOD(mus_pattern_split_edge(P, BOTTOM, 0.1, "part", NULL));
}


static void undone(world *w)
{
    edited(w);
    GOOD(mus_pattern_undo(P));
}


static void dart(world *w)
{
    GOOD(mus_pattern_add_dart(P, BOTTOM, 0.2, 0.03, (double[2]){0.2, 0.2}, &w->leg));
    w->right = mus_pattern_find_edge(P, 0, "right"), w->left = mus_pattern_find_edge(P, 0, "left");
    w->cut_def.edge_a = w->leg, w->cut_def.edge_b = w->right;
}


/* half of the dart goes to the right side: two darts with one point */
static void two_darts(world *w)
{
    dart(w);
    GOOD(mus_pattern_rotate_dart(P, w->leg, w->right, 0.2, w->left, 0.5, &w->second_leg));
    const int32_t seam = mus_pattern_edge_seam(P, w->second_leg);
    double angle;
    for (w->leg = 0;
         mus_pattern_edge_seam(P, w->leg) == seam || mus_pattern_dart(P, w->leg, &angle, NULL, NULL) != MUS_OK;)
        w->leg++;
    w->left = mus_pattern_find_edge(P, 0, "left");
}


static void cut_dart(world *w)
{
    dart(w);
    mus_cut_line_destroy(w->have.cut_line);
    GOOD(mus_pattern_cut_line(P, 0, 0.01, &w->have.cut_line));
}


static void curve(world *w)
{
    GOOD(mus_pattern_redraw_edge(P, RIGHT, 1, (int32_t[1]){MUS_PIECE_CUBIC}, 2, (double[4]){0.42, 0.1, 0.42, 0.3}));
}


static void corner(world *w)
{
    GOOD(mus_pattern_redraw_edge(P, RIGHT, 2, (int32_t[2]){MUS_PIECE_LINE, MUS_PIECE_LINE}, 1, (double[2]){0.41, 0.2}));
}


static void split(world *w)
{
    GOOD(mus_pattern_split_edge(P, BOTTOM, 0.1, "part", NULL));
}


static void untrue(world *w)
{
    GOOD(mus_pattern_move_point(P, 2, 1.02 * SIDE, SIDE));
}


static void loose_edges(world *w)
{
    int32_t panel, point[3];
    GOOD(mus_pattern_add_panel(P, "loose", &panel));
    for (int i = 0; i < 3; i++) GOOD(mus_pattern_add_point(P, panel, 0.1 * (i == 1), 0.1 * (i == 2), &point[i]));
    for (int i = 0; i < 3; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = point[i], def.end = point[(i + 1) % 3];
        GOOD(mus_pattern_add_edge(P, &def, NULL));
    }
}


/* a pattern whose arrays are full */
static void copied(world *w)
{
    mus_pattern *copy;
    GOOD(mus_pattern_copy(P, &copy));
    mus_pattern_destroy(P);
    P = copy;
}


/* no room is left in the array that a call adds to: it takes what comes as long as there is no memory */
static void full_of_panels(world *w)
{
    char name[24];
    mus_status status = MUS_OK;
    support_fail_after(0, true);
    for (int i = 0; status == MUS_OK; i++) {
        snprintf(name, sizeof name, "panel %d", i);
        status = mus_pattern_add_panel(P, name, NULL);
    }
    support_fail_never();
}


static void full_of_seams(world *w)
{
    support_fail_after(0, true);
    while (mus_pattern_add_seam(P, &w->seam_def, NULL) == MUS_OK) {
    }
    support_fail_never();
}


static void full_of_notches(world *w)
{
    support_fail_after(0, true);
    while (mus_pattern_add_notch(P, BOTTOM, 0.1, MUS_NOTCH_DOUBLE, NULL) == MUS_OK) {
    }
    support_fail_never();
}


static void a_shirt(world *w)
{
    mus_pattern_destroy(P);
    GOOD(mus_design_draft(w->context, mus_design_find("oxford_shirt"), w->have.tape, NULL, &P));
}


static void faulty(world *w)
{
    loose_edges(w);
    mus_faults_destroy(w->have.faults);
    GOOD(mus_pattern_check(P, &w->more, &w->have.faults));
}


/* the bytes of w->path in memory, too */
static void read_back(world *w)
{
    w->text = support_slurp(w->path, &w->text_size);
    ck_assert_ptr_nonnull(w->text);
}


static void tape_file(world *w)
{
    support_scratch("again.tape", w->path, sizeof w->path);
    GOOD(mus_tape_write(w->have.tape, w->path));
    read_back(w);
}


static void pattern_file(world *w)
{
    GOOD(mus_pattern_write(P, w->path));
    read_back(w);
}


static void fabric_file(world *w)
{
    GOOD(mus_fabric_save(w->context, &w->fabric, mus_fabric_name(0), NULL, w->path));
    read_back(w);
}


static void mesh_file(world *w)
{
    GOOD(mus_mesh_write_obj(w->context, w->path, 1, &w->view));
    read_back(w);
}


static void dxf_file(world *w)
{
    GOOD(mus_sheet_write_dxf(w->have.sheet, NULL, w->path));
    w->dxf.path = w->path;
}


static void val_file(world *w)
{
    static const char end[] = "</pattern>";
    w->text = support_slurp("tests/fuzz/seeds/val/half_skirt.val", &w->text_size);
    ck_assert_ptr_nonnull(w->text);
    const char *rest = strstr(w->text, end) + sizeof end;
    w->val.path = "again.val", w->val.text = w->text, w->val.text_size = (size_t)(rest - w->text);
    w->val.measures_path = "again.vit", w->val.measures = rest;
    w->val.measures_size = w->text_size - w->val.text_size;
}


/* the skin of the body as a mesh that was read */
static void mesh_of_body(world *w)
{
    mus_mesh_view view;
    mus_mesh_view_init(&view, sizeof view);
    view.positions = mus_body_vertices(w->have.body), view.vertex_count = mus_body_vertex_count(w->have.body);
    view.triangles = mus_body_triangles(w->have.body), view.triangle_count = mus_body_triangle_count(w->have.body);
    GOOD(mus_mesh_write_obj(w->context, w->path, 1, &view));
    GOOD(mus_mesh_read_obj(w->context, w->path, &w->have.mesh));
}


/* ---- digests ---- */

static uint64_t mix(uint64_t hash, const void *bytes, size_t size)
{
    for (size_t i = 0; bytes != NULL && i < size; i++) hash = (hash ^ ((const uint8_t *)bytes)[i]) * 1099511628211U;
    return hash;
}


static uint64_t mix_pattern(uint64_t hash, const mus_pattern *pattern)
{
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_pattern_write_bytes(pattern, &bytes, &size), MUS_OK);
    hash = mix(hash, bytes, size);
    mus_context_alloc(mus_pattern_context(pattern), bytes, 0);
    const int32_t history[2] = {mus_pattern_undo_count(pattern), mus_pattern_redo_count(pattern)};
    return mix(hash, history, sizeof history);
}


/* which objects there are, and what they hold */
static uint64_t mix_objects(uint64_t hash, const objects *o)
{
    if (o->tape != NULL)
        for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
            const double value = mus_tape_value(o->tape, m);
            hash = mix(hash, &value, sizeof value);
        }
    if (o->tape != NULL) hash = mix(hash, mus_tape_name(o->tape), strlen(mus_tape_name(o->tape)));
    if (o->body != NULL) hash = mix(hash, mus_body_vertices(o->body), 24 * (size_t)mus_body_vertex_count(o->body));
    if (o->pattern != NULL) hash = mix_pattern(hash, o->pattern);
    if (o->cloth != NULL) hash = mix(hash, mus_cloth_rest(o->cloth), 16 * (size_t)mus_cloth_node_count(o->cloth));
    const uint64_t state = o->drape == NULL ? 0 : mus_drape_hash(o->drape);
    if (o->fit != NULL) hash = mix(hash, mus_fit_gap(o->fit), 8 * (size_t)mus_fit_node_count(o->fit));
    if (o->manifold != NULL)
        hash = mix(hash, mus_manifold_vertices(o->manifold), 24 * (size_t)mus_manifold_vertex_count(o->manifold));
    if (o->mesh != NULL) hash = mix(hash, mus_mesh_vertices(o->mesh), 24 * (size_t)mus_mesh_vertex_count(o->mesh));
    const int32_t counts[] = {
        o->sheet ? mus_sheet_line_count(o->sheet) : -1, o->catalogue ? mus_catalogue_count(o->catalogue) : -1,
        o->faults ? mus_faults_count(o->faults) : -1, o->cut_line ? mus_cut_line_loop_count(o->cut_line) : -1};
    const double length = o->layout ? mus_layout_length(o->layout) : -1.0;
    hash = mix(hash, &length, sizeof length);
    const double period = o->move ? mus_move_period(o->move) : -1.0;
    hash = mix(hash, &period, sizeof period);
    return mix(mix(hash, counts, sizeof counts), &state, sizeof state);
}


/* the world with its file and the bytes that a call made; `results`: with the numbers that a call wrote */
static uint64_t digest(const world *w, bool results)
{
    size_t size = 0;
    char *bytes = support_slurp(w->path, &size);
    uint64_t hash = mix(mix(14695981039346656037U, bytes, size), w->bytes, w->bytes ? w->size : 0);
    free(bytes);
    hash = mix_objects(mix_objects(hash, &w->have), &w->made);
    if (!results) return hash;
    hash = mix(mix(hash, w->real, sizeof w->real), w->single, sizeof w->single);
    hash = mix(mix(hash, w->whole, sizeof w->whole), &w->more, sizeof w->more);
    hash = mix(mix(hash, &w->count, sizeof w->count), w->hash, sizeof w->hash);
    return mix(mix(hash, w->line, strlen(w->line)), w->second ? "second" : "", w->second ? 6 : 0);
}


/* ---- calls ---- */

typedef struct row {
    const char *name;
    void (*before)(world *w);
    mus_status (*call)(world *w);
    void (*ask)(world *w);
} row;

/* mus_context_alloc() has no status */
static mus_status call_mus_context_alloc(world *w)
{
    w->bytes = mus_context_alloc(w->context, NULL, w->size = 64);
    if (w->bytes == NULL) return mus_context_fail(w->context, MUS_ERR_MEMORY, "64 bytes were refused");
    memset(w->bytes, 1, 64);
    return MUS_OK;
}

#define CALL(name, before, arguments)                                                                                  \
    static mus_status call_##name##_##before(world *w)                                                                 \
    {                                                                                                                  \
        (void)w;                                                                                                       \
        return name arguments;                                                                                         \
    }
#define ASK(name, before, arguments)                                                                                   \
    static void ask_##name(world *w)                                                                                   \
    {                                                                                                                  \
        (void)w;                                                                                                       \
        (void)name arguments;                                                                                          \
    }
#define CALL_ROW(name, before, arguments) {#name, before, call_##name##_##before, NULL},
#define ASK_ROW(name, before, arguments) {#name, before, NULL, ask_##name},

CALLS_THAT_ALLOCATE(CALL)
CALLS_THAT_MOVE(CALL)
CALLS_THAT_DO_NOT(CALL)
ANSWERS(ASK)

static const row allocating[] = {
    CALLS_THAT_ALLOCATE(CALL_ROW){"mus_context_alloc", nothing, call_mus_context_alloc, NULL}};
static const row moving[] = {CALLS_THAT_MOVE(CALL_ROW)};
static const row quiet[] = {CALLS_THAT_DO_NOT(CALL_ROW)};
static const row answers[] = {ANSWERS(ASK_ROW)};
#define ROWS(table) (int)(sizeof table / sizeof *table)


static void begin_row(world *w, const row *r)
{
    make_world(w);
    r->before(w);
}


/* allocations of an undisturbed call, its status in *status and the digest of the world after it in *want */
static int64_t undisturbed(const row *r, mus_status *status, uint64_t *want)
{
    static world w;
    begin_row(&w, r);
    const int64_t before = support_allocations();
    *status = r->call(&w);
    const int64_t asked = support_allocations() - before;
    *want = digest(&w, true);
    end_world(&w);
    return asked;
}


/* as `undisturbed` says in the end, whichever allocations fail. `moves`: the cloth may be anywhere after a failure */
static void fail_each(const row *r, bool moves, bool forever)
{
    static world w;
    mus_status want_status, status;
    uint64_t want;
    const int64_t asked = undisturbed(r, &want_status, &want);
    const int64_t stride = 1 + asked / (SUPPORT_SLOW ? 8 : moves ? 40 : 250);
    ck_assert_msg(asked > 0, "%s allocates nothing", r->name);
    ck_assert_msg(moves || want_status == MUS_OK, "%s: %s", r->name, mus_status_name(want_status));
    begin_row(&w, r);
    const uint64_t start = digest(&w, false);
    for (int64_t n = 0;; n += stride) {
        mus_context_fail(w.context, MUS_ERR_ARG, "-");
        support_fail_after(n, forever);
        status = r->call(&w);
        support_fail_never();
        if (status == want_status) break;
        ck_assert_msg(status == MUS_ERR_MEMORY, "%s, allocation %d: %s", r->name, (int)n, mus_status_name(status));
        ck_assert_msg(strcmp(mus_context_error(w.context), "-") != 0 || r->call == call_mus_context_create_nothing,
                      "%s, allocation %d: no sentence", r->name, (int)n);
        if (moves) {
            GOOD_OF(&w, mus_drape_place(w.have.drape));
            r->before(&w);
        }
        ck_assert_msg(digest(&w, false) == start, "%s, allocation %d: not as before", r->name, (int)n);
    }
    ck_assert_msg(digest(&w, true) == want, "%s: another result after failures", r->name);
    end_world(&w);
}


START_TEST(a_call_that_lacked_memory_changed_nothing_and_serves_again)
{
    fail_each(&allocating[_i / 2], false, _i % 2);
}
END_TEST


START_TEST(cloth_that_lacked_memory_is_placed_and_moves_again)
{
    fail_each(&moving[_i / 2], true, _i % 2);
}
END_TEST


START_TEST(the_other_calls_ask_for_no_memory)
{
    static world w;
    const row *r = &quiet[_i];
    begin_row(&w, r);
    const int64_t asked = support_allocations();
    support_fail_after(0, true);
    const mus_status status = r->call(&w);
    support_fail_never();
    ck_assert_msg(status == MUS_OK, "%s: %s", r->name, mus_context_error(w.context));
    ck_assert_msg(support_allocations() == asked, "%s asks for memory", r->name);
    end_world(&w);
}
END_TEST


START_TEST(what_cannot_fail_asks_for_no_memory)
{
    static world w;
    make_world(&w);
    for (int i = 0; i < ROWS(answers); i++) {
        const int64_t asked = support_allocations();
        support_fail_after(0, true);
        answers[i].ask(&w);
        support_fail_never();
        ck_assert_msg(support_allocations() == asked, "%s asks for memory", answers[i].name);
    }
    end_world(&w);
}
END_TEST


Suite *mus_suite_every_call(void)
{
    Suite *suite = suite_create("every_call");
    TCase *tests = tcase_create("every_call");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, a_call_that_lacked_memory_changed_nothing_and_serves_again, 0, 2 * ROWS(allocating));
    tcase_add_loop_test(tests, cloth_that_lacked_memory_is_placed_and_moves_again, 0, 2 * ROWS(moving));
    tcase_add_loop_test(tests, the_other_calls_ask_for_no_memory, 0, ROWS(quiet));
    tcase_add_test(tests, what_cannot_fail_asks_for_no_memory);
    suite_add_tcase(suite, tests);
    return suite;
}
