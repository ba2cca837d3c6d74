/*
 * light.c: the depth of the scene as a light sees it.
 *
 * The light is far away, so its rays are parallel and the map is a box fitted round all vertices, which wastes no
 * texel. The floor takes shadow but casts none. Source: Williams, Casting Curved Shadows on Curved Surfaces, 1978.
 */
#include "render_internal.h"

#include <math.h>

/* room round the scene, so that filters at the rim find nothing in the way [m] */
#define MARGIN 0.02


/* box of all meshes in the frame of the light */
static void light_box(const render *r, const float *look, double *low, double *high)
{
    for (int k = 0; k < 3; k++) {
        low[k] = 1e30;
        high[k] = -1e30;
    }
    for (int32_t i = 0; i < r->part_count; i++) {
        const render_part *part = &r->parts[i];
        for (int32_t j = 0; part->kind != RENDER_FLOOR && j < part->vertex_count; j++)
            for (int k = 0; k < 3; k++) {
                const float *p = part->v[j].position;
                float x = look[k] * p[0] + look[4 + k] * p[1] + look[8 + k] * p[2] + look[12 + k];
                low[k] = fmin(low[k], (double)x);
                high[k] = fmax(high[k], (double)x);
            }
    }
    for (int k = 0; k < 3; k++) {
        low[k] -= MARGIN;
        high[k] += MARGIN;
    }
}


void render_light_matrix(const render *r, const double *towards, float *matrix, double *spread)
{
    double up[3] = {0, fabs(towards[1]) > 0.99 ? 0.0 : 1.0, fabs(towards[1]) > 0.99 ? 1.0 : 0.0};
    double forward[3] = {-towards[0], -towards[1], -towards[2]}, low[3], high[3];
    float look[16], box[16];

    render_matrix_look(look, r->centre, forward, up);
    light_box(r, look, low, high);
    render_matrix_box(box, low, high);
    render_matrix_multiply(matrix, box, look);
    for (int k = 0; k < 3; k++) spread[k] = high[k] - low[k];
}


/* all but the floor, positions only */
void render_light_draw(render *r, const float *matrix)
{
    r->gl.UniformMatrix4fv(r->depth_program.view, 1, GL_FALSE, matrix);
    for (int32_t i = 0; i < r->part_count; i++)
        if (r->parts[i].kind != RENDER_FLOOR) render_part_draw(r, &r->parts[i]);
}


/* a depth texture bound as the only target of a framebuffer */
int render_depth_target(render *r, int32_t width, int32_t height, GLuint *frame, GLuint *map, render_error *error)
{
    const render_gl *gl = &r->gl;
    static const GLfloat open[4] = {1.0f, 1.0f, 1.0f, 1.0f};

    gl->GenTextures(1, map);
    gl->BindTexture(GL_TEXTURE_2D, *map);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    gl->TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, open);

    gl->GenFramebuffers(1, frame);
    gl->BindFramebuffer(GL_FRAMEBUFFER, *frame);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *map, 0);
    gl->DrawBuffer(GL_NONE);
    gl->ReadBuffer(GL_NONE);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return 0;
    return render_fail(error, "no picture: the driver takes no depth map of %d x %d", (int)width, (int)height);
}


int render_light_map(render *r, const double *towards, int32_t size, render_light *light, render_error *error)
{
    const render_gl *gl = &r->gl;
    GLuint frame = 0;
    int rc;

    render_light_matrix(r, towards, light->matrix, light->spread);
    rc = render_depth_target(r, size, size, &frame, &light->map, error);
    if (!rc) {
        gl->Viewport(0, 0, size, size);
        gl->Enable(GL_DEPTH_TEST);
        gl->DepthMask(GL_TRUE);
        gl->DepthFunc(GL_LESS);
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        gl->Enable(GL_POLYGON_OFFSET_FILL);
        gl->PolygonOffset(1.5f, 4.0f);
        gl->UseProgram(r->depth_program.id);
        render_light_draw(r, light->matrix);
        gl->Disable(GL_POLYGON_OFFSET_FILL);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (frame) gl->DeleteFramebuffers(1, &frame);
    return rc;
}
