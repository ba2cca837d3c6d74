/*
 * draw.c: a loaded scene to pixels.
 *
 * For one view: shadow map of the key light (the lights turn with the camera, as in a studio, so every side is well
 * lit), then background, floor, body and cloth into a multisampled buffer of linear colour, resolved, then encoded
 * into sRGB bytes. The camera has a long lens and frames the whole scene at zoom 1: by its height and by its widest
 * reach from the upright axis, so that the scale is the same from every side.
 */
#include "render_internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* upright angle of view at zoom 1 [deg]: about a 100 mm lens on small film, which keeps proportions calm */
#define LENS 25.0

/* room round the scene: the picture is this much larger */
#define FRAME 1.07

/* texels a side of the key light's map: 2 mm on an adult; the filter of the shader is 9 mm */
#define SHADOW_SIDE 1024

#define SAMPLES 4

const render_camera render_default_views[RENDER_DEFAULT_VIEW_COUNT] = {{0, 5, 1, NAN}, {40, 8, 1, NAN}};

/* an eye in the world and what it takes to draw from it */
typedef struct draw_view {
    double eye[3];
    double key[3]; /* towards the lights */
    double fill[3];
    double rim[3];
    float matrix[16];
    int32_t width;
    int32_t joined[2]; /* left, right: nonzero where another view joins */
} draw_view;


int render_create(render **out, render_error *error)
{
    render *r = calloc(1, sizeof *r);
    GLint samples = 0;

    *out = NULL;
    if (!r) return render_fail(error, "no picture: out of memory");
    if (render_egl_open(&r->egl, &r->gl, error)) goto fail;
    snprintf(r->device, sizeof r->device, "%s", (const char *)r->gl.GetString(GL_RENDERER));
    r->gl.GetIntegerv(GL_MAX_SAMPLES, &samples);
    r->samples = samples < SAMPLES ? samples : SAMPLES;
    if (render_programs_build(r, error)) goto fail;

    /* depth maps are looked at by comparison */
    r->gl.GenVertexArrays(1, &r->empty_array);
    r->gl.GenSamplers(1, &r->compare);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    r->gl.SamplerParameteri(r->compare, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    *out = r;
    return 0;

fail:
    render_destroy(r);
    return -1;
}


void render_destroy(render *r)
{
    render_error ignored;

    if (!r) return;
    if (r->egl && !render_egl_enter(r->egl, &ignored)) {
        render_scene_free(r);
        render_programs_free(r);
        if (r->empty_array) r->gl.DeleteVertexArrays(1, &r->empty_array);
        if (r->compare) r->gl.DeleteSamplers(1, &r->compare);
    }
    render_egl_close(r->egl);
    free(r);
}


const char *render_device(const render *r)
{
    return r->device;
}


/* of a closed part the far side is never seen */
void render_part_draw(render *r, const render_part *part)
{
    if (part->closed) r->gl.Enable(GL_CULL_FACE);
    r->gl.BindVertexArray(part->array);
    r->gl.DrawElements(GL_TRIANGLES, part->index_count, GL_UNSIGNED_INT, NULL);
    r->gl.Disable(GL_CULL_FACE);
}


/* unit direction at `azimuth` from the camera's side of the scene (positive to its right) and `rise` above level */
static void draw_direction(double yaw, double azimuth, double rise, double *d)
{
    double a = (yaw + azimuth) * PI / 180.0, e = rise * PI / 180.0;

    d[0] = cos(e) * sin(a);
    d[1] = sin(e);
    d[2] = cos(e) * cos(a);
}


/*
 * The scene is an upright cylinder of half height h and radius r, seen at pitch p: half height h cos p + r sin p in
 * the picture, half width r. The eye's distance is that at which the nearest of it still fits.
 */
static void draw_view_set(const render *r, const render_camera *camera, double aspect, draw_view *view)
{
    double pitch = camera->pitch * PI / 180.0, h = 0.5 * (r->high[1] - r->low[1]);
    double half_height = FRAME * (h * cos(pitch) + r->radius * fabs(sin(pitch))), half_width = FRAME * r->radius;
    double tangent = tan(0.5 * LENS * PI / 180.0), depth = h * fabs(sin(pitch)) + r->radius * cos(pitch);
    double distance = fmax(half_height, half_width / aspect) / tangent + 0.5 * r->radius;
    double aim[3], out[3], forward[3], up[3] = {0, 1, 0}, nearer = camera->zoom > 1 ? 1 - 1 / camera->zoom : 0;
    float look[16], lens[16];

    for (int k = 0; k < 3; k++) aim[k] = r->centre[k] + nearer * (r->focus[k] - r->centre[k]);
    if (isfinite(camera->height)) aim[1] = camera->height;
    draw_direction(camera->yaw, 0, camera->pitch, out);
    for (int k = 0; k < 3; k++) {
        view->eye[k] = aim[k] + distance * out[k];
        forward[k] = -out[k];
    }
    tangent /= camera->zoom;
    depth += fabs(aim[1] - r->centre[1]) + 2.0 * h + 2.0 * r->radius;
    render_matrix_look(look, view->eye, forward, up);
    render_matrix_perspective(lens, aspect * tangent, tangent, fmax(0.02 * distance, distance - depth),
                              distance + depth);
    render_matrix_multiply(view->matrix, lens, look);

    /* key from the upper left, fill from the right, rim from behind */
    draw_direction(camera->yaw, -38, 48, view->key);
    draw_direction(camera->yaw, 60, 8, view->fill);
    draw_direction(camera->yaw, 158, 38, view->rim);
}


static void draw_target_free(render *r, render_target *t)
{
    const render_gl *gl = &r->gl;

    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteFramebuffers(1, &t->many);
    gl->DeleteFramebuffers(1, &t->one);
    gl->DeleteFramebuffers(1, &t->bytes);
    gl->DeleteRenderbuffers(1, &t->many_colour);
    gl->DeleteRenderbuffers(1, &t->many_depth);
    gl->DeleteRenderbuffers(1, &t->bytes_colour);
    gl->DeleteTextures(1, &t->one_colour);
}


static int draw_target_make(render *r, int32_t w, int32_t h, render_target *t, render_error *error)
{
    const render_gl *gl = &r->gl;
    int good;

    memset(t, 0, sizeof *t);
    t->width = w;
    t->height = h;
    gl->GenRenderbuffers(1, &t->many_colour);
    gl->BindRenderbuffer(GL_RENDERBUFFER, t->many_colour);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, r->samples, GL_RGBA16F, w, h);
    gl->GenRenderbuffers(1, &t->many_depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, t->many_depth);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, r->samples, GL_DEPTH_COMPONENT32F, w, h);
    gl->GenRenderbuffers(1, &t->bytes_colour);
    gl->BindRenderbuffer(GL_RENDERBUFFER, t->bytes_colour);
    gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, w, h);
    gl->GenTextures(1, &t->one_colour);
    gl->BindTexture(GL_TEXTURE_2D, t->one_colour);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, w, h, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

    gl->GenFramebuffers(1, &t->many);
    gl->BindFramebuffer(GL_FRAMEBUFFER, t->many);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, t->many_colour);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, t->many_depth);
    good = gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl->GenFramebuffers(1, &t->one);
    gl->BindFramebuffer(GL_FRAMEBUFFER, t->one);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t->one_colour, 0);
    good = good && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl->GenFramebuffers(1, &t->bytes);
    gl->BindFramebuffer(GL_FRAMEBUFFER, t->bytes);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, t->bytes_colour);
    good = good && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (good && gl->GetError() == GL_NO_ERROR) return 0;

    draw_target_free(r, t);
    return render_fail(error, "no picture: the driver has no room for %d x %d pixels", (int)w, (int)h);
}


/* what all lit programs share; the map is on unit 0, a print on unit 1, seams on unit 2 */
static void draw_program_use(render *r, const render_program *p, const draw_view *view, const render_light *light)
{
    const render_gl *gl = &r->gl;

    gl->UseProgram(p->id);
    gl->UniformMatrix4fv(p->view, 1, GL_FALSE, view->matrix);
    gl->UniformMatrix4fv(p->light, 1, GL_FALSE, light->matrix);
    gl->Uniform3f(p->spread, (GLfloat)light->spread[0], (GLfloat)light->spread[1], (GLfloat)light->spread[2]);
    gl->Uniform3f(p->eye, (GLfloat)view->eye[0], (GLfloat)view->eye[1], (GLfloat)view->eye[2]);
    gl->Uniform3f(p->key, (GLfloat)view->key[0], (GLfloat)view->key[1], (GLfloat)view->key[2]);
    gl->Uniform3f(p->fill, (GLfloat)view->fill[0], (GLfloat)view->fill[1], (GLfloat)view->fill[2]);
    gl->Uniform3f(p->rim, (GLfloat)view->rim[0], (GLfloat)view->rim[1], (GLfloat)view->rim[2]);
    gl->Uniform1i(p->shadow, 0);
    gl->Uniform1i(p->print, 1);
    gl->Uniform1i(p->thread, 2);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, light->map);
    gl->BindSampler(0, r->compare);
    gl->ActiveTexture(GL_TEXTURE1);
}


/* multiplies what is behind by the shade; from below there is no floor to see */
static void draw_floor(render *r, const render_part *part, const draw_view *view, const render_light *light)
{
    const render_program *p = &r->floor_program;
    const render_gl *gl = &r->gl;

    if (view->eye[1] <= r->low[1]) return;
    draw_program_use(r, p, view, light);
    gl->Uniform3f(p->middle, (GLfloat)r->centre[0], (GLfloat)r->centre[1], (GLfloat)r->centre[2]);
    gl->Uniform2f(p->joined, (GLfloat)view->joined[0], (GLfloat)view->joined[1]);
    gl->Uniform2f(p->size, (GLfloat)view->width, 1.0f);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ZERO, GL_SRC_COLOR);
    gl->DepthMask(GL_FALSE);
    render_part_draw(r, part);
    gl->DepthMask(GL_TRUE);
    gl->Disable(GL_BLEND);
}


static void draw_body(render *r, const render_part *part)
{
    const render_program *p = &r->body_program;
    const render_gl *gl = &r->gl;

    gl->Uniform1i(p->kind, part->kind);
    gl->Uniform1i(p->woven, part->kind == RENDER_CLOTH && part->has_texcoords);
    gl->Uniform1i(p->printed, part->print != 0);
    gl->Uniform2f(p->repeats, part->repeats[0], part->repeats[1]);
    gl->Uniform1i(p->sewn, part->thread != 0);
    gl->Uniform1f(p->stitch_texel, part->texel);
    gl->ActiveTexture(GL_TEXTURE2);
    gl->BindTexture(GL_TEXTURE_2D, part->thread);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, part->print);
    render_part_draw(r, part);
}


static void draw_scene(render *r, const draw_view *view, const render_light *light, const render_target *t)
{
    const render_gl *gl = &r->gl;

    gl->BindFramebuffer(GL_FRAMEBUFFER, t->many);
    gl->Viewport(0, 0, t->width, t->height);
    gl->Enable(GL_MULTISAMPLE);
    gl->DepthMask(GL_TRUE);
    gl->Clear(GL_DEPTH_BUFFER_BIT);

    gl->Disable(GL_DEPTH_TEST);
    gl->UseProgram(r->back_program.id);
    gl->BindVertexArray(r->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LEQUAL);

    for (int32_t i = 0; i < r->part_count; i++)
        if (r->parts[i].kind == RENDER_FLOOR) draw_floor(r, &r->parts[i], view, light);
    draw_program_use(r, &r->body_program, view, light);
    static const int order[3] = {RENDER_TRIM, RENDER_CLOTH, RENDER_BODY}; /* from the outside in: less is drawn twice */
    for (int k = 0; k < 3; k++)
        for (int32_t i = 0; i < r->part_count; i++)
            if (r->parts[i].kind == order[k]) draw_body(r, &r->parts[i]);
    gl->BindSampler(0, 0);
    gl->ActiveTexture(GL_TEXTURE0);
}


/* samples to linear pixels to bytes; OpenGL's rows come from the bottom */
static void draw_finish(render *r, const render_target *t, unsigned char *rgba, size_t stride)
{
    const render_gl *gl = &r->gl;

    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, t->many);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, t->one);
    gl->BlitFramebuffer(0, 0, t->width, t->height, 0, 0, t->width, t->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);

    gl->BindFramebuffer(GL_FRAMEBUFFER, t->bytes);
    gl->Disable(GL_DEPTH_TEST);
    gl->UseProgram(r->finish_program.id);
    gl->Uniform1i(r->finish_program.picture, 0);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, t->one_colour);
    gl->BindVertexArray(r->empty_array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);

    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int32_t y = 0; y < t->height; y++)
        gl->ReadPixels(0, t->height - 1 - y, t->width, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba + stride * (size_t)y);
}


/* one view into a column of a picture whose rows are `stride` bytes apart */
static int draw_column(render *r, const draw_view *view, int32_t height, unsigned char *rgba, size_t stride,
                       render_error *error)
{
    render_light light = {0};
    render_target target;
    int32_t width = view->width;

    if (render_light_map(r, view->key, SHADOW_SIDE, &light, error)) goto fail;
    if (draw_target_make(r, width, height, &target, error)) goto fail;
    draw_scene(r, view, &light, &target);
    draw_finish(r, &target, rgba, stride);
    draw_target_free(r, &target);
    r->gl.DeleteTextures(1, &light.map);
    if (r->gl.GetError() == GL_NO_ERROR) return 0;
    return render_fail(error, "no picture: the driver failed while drawing %d x %d pixels", (int)width, (int)height);

fail:
    if (light.map) r->gl.DeleteTextures(1, &light.map);
    return -1;
}


static int draw_check(const render *r, int32_t count, const render_camera *cameras, int32_t width, int32_t height,
                      render_error *error)
{
    if (r->part_count < 1) return render_fail(error, "no scene is loaded");
    if (width < RENDER_SIZE_MIN || width > RENDER_SIZE_MAX || height < RENDER_SIZE_MIN || height > RENDER_SIZE_MAX)
        return render_fail(error, "size %d x %d: each side is %d to %d pixels", (int)width, (int)height,
                           RENDER_SIZE_MIN, RENDER_SIZE_MAX);
    if (count < 1 || count > width / RENDER_SIZE_MIN)
        return render_fail(error, "%d views do not fit a width of %d pixels: expected 1 to %d", (int)count, (int)width,
                           (int)width / RENDER_SIZE_MIN);
    for (int32_t i = 0; i < count; i++)
        if (!(fabs(cameras[i].yaw) <= 36000.0) || !(fabs(cameras[i].pitch) <= 89.0) ||
            !(cameras[i].zoom >= 0.1 && cameras[i].zoom <= 100.0) || isinf(cameras[i].height))
            return render_fail(error, "view %d (yaw %g, pitch %g, zoom %g): pitch is -89 to 89, zoom 0.1 to 100",
                               (int)i + 1, cameras[i].yaw, cameras[i].pitch, cameras[i].zoom);
    return 0;
}


int render_picture(render *r, int32_t count, const render_camera *cameras, int32_t width, int32_t height,
                   unsigned char *rgba, render_error *error)
{
    if (draw_check(r, count, cameras, width, height, error) || render_egl_enter(r->egl, error)) return -1;
    for (int32_t i = 0; i < count; i++) {
        int32_t left = (int32_t)((int64_t)width * i / count), right = (int32_t)((int64_t)width * (i + 1) / count);
        draw_view view = {.width = right - left, .joined = {i > 0, i + 1 < count}};
        draw_view_set(r, &cameras[i], (double)view.width / (double)height, &view);
        if (draw_column(r, &view, height, rgba + 4 * (size_t)left, 4 * (size_t)width, error)) return -1;
    }
    return 0;
}


int render_draw(render *r, const render_camera *camera, int32_t width, int32_t height, unsigned char *rgba,
                render_error *error)
{
    return render_picture(r, 1, camera, width, height, rgba, error);
}
