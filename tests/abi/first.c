/*
 * first.c: a program of the first release with ABI 1 (405070c, version 0.2.0). Its declarations are a copy of that
 * release's, with the sizes that its structs had; they stay as they are. It is linked with the library of today, as a
 * program that was built then meets it: it dresses a skirt and prints the state hash.
 */
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef int32_t mus_status;
typedef struct mus_context mus_context;
typedef struct mus_tape mus_tape;
typedef struct mus_body mus_body;
typedef struct mus_pattern mus_pattern;
typedef struct mus_cloth mus_cloth;
typedef struct mus_drape mus_drape;

struct mus_cloth_def {
    size_t size;
    double spacing;
    const void *fabric;
    int32_t bending;
    double paper_curvature;
    int32_t coarser;
};

struct mus_drape_def {
    size_t size;
    double gravity[3];
    int32_t precision, threads;
    double collision_distance, clearance, friction, drag, seam_pull, sew_seconds, settle_seconds, settle_residual;
    int32_t integrator;
    double contact_ball;
    int32_t self_contact;
    double thickness, self_friction;
    int32_t sew_once;
};

struct mus_dress_def {
    size_t size;
    double spacing;
    const void *fabric;
    int32_t self_contact, precision, threads;
    double friction;
    const struct mus_drape_def *drape;
    int32_t place, retry, open_closures;
    void *progress, *progress_user;
};

mus_status mus_context_create(const void *def, mus_context **out);
void mus_context_destroy(mus_context *context);
const char *mus_context_error(const mus_context *context);
size_t mus_context_bytes(const mus_context *context);
mus_status mus_tape_create(mus_context *context, mus_tape **out);
mus_status mus_tape_set_size(mus_tape *tape, const char *size);
void mus_tape_destroy(mus_tape *tape);
mus_status mus_body_create(mus_context *context, const mus_tape *tape, const void *def, mus_body **out);
void mus_body_destroy(mus_body *body);
int32_t mus_design_find(const char *name);
mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape, const void *def,
                            mus_pattern **out);
void mus_pattern_destroy(mus_pattern *pattern);
void mus_cloth_def_init(struct mus_cloth_def *def, size_t size);
mus_status mus_cloth_create(mus_context *context, const mus_pattern *pattern, const struct mus_cloth_def *def,
                            mus_cloth **out);
void mus_cloth_destroy(mus_cloth *cloth);
void mus_drape_def_init(struct mus_drape_def *def, size_t size);
mus_status mus_drape_create(mus_context *context, const mus_cloth *cloth, const mus_body *body,
                            const struct mus_drape_def *def, mus_drape **out);
mus_status mus_drape_place(mus_drape *drape);
mus_status mus_drape_sew(mus_drape *drape, void *progress, void *user);
mus_status mus_drape_settle(mus_drape *drape, void *progress, void *user);
uint64_t mus_drape_hash(const mus_drape *drape);
void mus_drape_destroy(mus_drape *drape);
void mus_dress_def_init(struct mus_dress_def *def, size_t size);
mus_status mus_dress(mus_context *context, const mus_pattern *pattern, const mus_body *body,
                     const struct mus_dress_def *def, void *report, void *reason, mus_cloth **cloth, mus_drape **drape);

#define MUST(call) \
    if ((call) != 0) return fprintf(stderr, "%s: %s\n", #call, context ? mus_context_error(context) : "no context"), 1


int main(void)
{
    mus_context *context = NULL;
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape, *dressed;
    struct mus_cloth_def cut;
    struct mus_drape_def def;
    struct mus_dress_def all;
    MUST(mus_context_create(NULL, &context));
    MUST(mus_tape_create(context, &tape));
    MUST(mus_tape_set_size(tape, "W40"));
    MUST(mus_body_create(context, tape, NULL, &body));
    MUST(mus_design_draft(context, mus_design_find("skirt"), tape, NULL, &pattern));

    mus_cloth_def_init(&cut, sizeof cut);
    cut.spacing = 0.06;
    MUST(mus_cloth_create(context, pattern, &cut, &cloth));
    mus_drape_def_init(&def, sizeof def);
    MUST(mus_drape_create(context, cloth, body, &def, &drape));
    MUST(mus_drape_place(drape));
    MUST(mus_drape_sew(drape, NULL, NULL));
    MUST(mus_drape_settle(drape, NULL, NULL));

    mus_dress_def_init(&all, sizeof all);
    all.spacing = 0.06;
    MUST(mus_dress(context, pattern, body, &all, NULL, NULL, NULL, &dressed));
    printf("%016" PRIx64 " %016" PRIx64 "\n", mus_drape_hash(drape), mus_drape_hash(dressed));

    mus_drape_destroy(dressed);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    const size_t left = mus_context_bytes(context);
    mus_context_destroy(context);
    return left == 0 ? 0 : 1;
}
