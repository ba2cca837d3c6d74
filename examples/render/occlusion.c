/*
 * occlusion.c: how much of its surroundings each vertex sees.
 *
 * The scene is drawn from DIRECTIONS far points, evenly spread over the sphere, as small depth maps side by side in one
 * texture. A vertex sees a direction d if nothing in d's map lies before it; its openness is
 *     sum over d of V(d) max(0, n . d) / sum over d of max(0, n . d)
 * for the right side (normal n) and for the wrong side (normal -n). It does not depend on the camera, costs nothing
 * when drawing, and shows no noise in the picture. Source: Landis, Production-Ready Global Illumination, 2002 (the
 * measure); Fibonacci points: Swinbank and Purser, 2006.
 */
#include "render_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 5 x 6 maps of 288: texels of 7 mm on an adult, 1440 x 1728 pixels in all */
#define DIRECTIONS 30
#define ACROSS 6
#define SIDE 288

/* a vertex is tested this far off its surface, in texels: less shows the surface's own steps, more loses creases */
#define LIFT 1.6

/* rounds of averaging with neighbours: takes off the steps of a finite number of directions */
#define SMOOTHING 2

/* places round a vertex of the floor that are asked in each map */
#define FLOOR_TAPS 16

typedef struct occlusion_view {
    double towards[3];
    float matrix[16];
    double texel; /* larger side of a texel [m] */
} occlusion_view;


/* points on a spiral from pole to pole, at equal steps of height and golden-angle steps of azimuth */
static void occlusion_direction(int i, double *d)
{
    double y = 1.0 - (2.0 * i + 1.0) / DIRECTIONS, r = sqrt(1.0 - y * y), a = 2.39996322972865332 * i;

    d[0] = r * cos(a);
    d[1] = y;
    d[2] = r * sin(a);
}


/* all maps into one texture, then into memory: rows of ACROSS * SIDE */
static int occlusion_maps(render *r, occlusion_view *views, float *depth, render_error *error)
{
    const render_gl *gl = &r->gl;
    GLuint frame = 0, map = 0;
    int32_t width = ACROSS * SIDE, height = DIRECTIONS / ACROSS * SIDE;
    int rc = render_depth_target(r, width, height, &frame, &map, error);

    if (!rc) {
        gl->Enable(GL_DEPTH_TEST);
        gl->DepthMask(GL_TRUE);
        gl->DepthFunc(GL_LESS);
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        gl->UseProgram(r->depth_program.id);
        for (int i = 0; i < DIRECTIONS; i++) {
            double spread[3];
            occlusion_direction(i, views[i].towards);
            render_light_matrix(r, views[i].towards, views[i].matrix, spread);
            views[i].texel = fmax(spread[0], spread[1]) / SIDE;
            gl->Viewport(i % ACROSS * SIDE, i / ACROSS * SIDE, SIDE, SIDE);
            render_light_draw(r, views[i].matrix);
        }
        gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
        gl->ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (frame) gl->DeleteFramebuffers(1, &frame);
    if (map) gl->DeleteTextures(1, &map);
    return rc;
}


/* share of the four texels round a place of map `i` that do not hide it, weighted as bilinear filters do */
static double occlusion_seen(const occlusion_view *view, const float *depth, int i, const double *p)
{
    const float *m = view->matrix, *map = depth + (ptrdiff_t)(i / ACROSS * SIDE) * ACROSS * SIDE + i % ACROSS * SIDE;
    double q[3], sum = 0;
    int x, y;

    for (int k = 0; k < 3; k++) {
        double clip = (double)m[k] * p[0] + (double)m[4 + k] * p[1] + (double)m[8 + k] * p[2] + (double)m[12 + k];
        q[k] = 0.5 + 0.5 * clip;
    }
    q[0] = q[0] * SIDE - 0.5;
    q[1] = q[1] * SIDE - 0.5;
    if (!(q[0] >= 0 && q[1] >= 0 && q[0] < SIDE - 1 && q[1] < SIDE - 1)) return 1.0;

    x = (int)q[0];
    y = (int)q[1];
    for (int k = 0; k < 4; k++) {
        int dx = k & 1, dy = k >> 1;
        double wx = dx ? q[0] - x : 1.0 - (q[0] - x), wy = dy ? q[1] - y : 1.0 - (q[1] - y);
        if ((double)map[(ptrdiff_t)(y + dy) * ACROSS * SIDE + x + dx] >= q[2]) sum += wx * wy;
    }
    return sum;
}


/*
 * The same at a place of the floor, averaged over a disc that widens away from the feet: a direction stands for a cone
 * of half angle 0.36, and what hides the sky from a far place stands in the middle, about as far away.
 */
static void occlusion_disc(const render *r, const render_vertex *v, double disc[FLOOR_TAPS][2])
{
    double away = hypot((double)v->position[0] - r->centre[0], (double)v->position[2] - r->centre[2]);

    for (int i = 0; i < FLOOR_TAPS; i++) {
        double a = 2.39996322972865332 * i, radius = 0.36 * away * sqrt((i + 0.5) / FLOOR_TAPS);
        disc[i][0] = (double)v->position[0] + radius * cos(a);
        disc[i][1] = (double)v->position[2] + radius * sin(a);
    }
}


static void occlusion_floor(const render *r, const occlusion_view *views, const float *depth, render_vertex *v)
{
    double disc[FLOOR_TAPS][2], seen = 0, all = 0;

    occlusion_disc(r, v, disc);
    for (int i = 0; i < DIRECTIONS && views[i].towards[1] > 0; i++) {
        double rise = views[i].towards[1];
        for (int j = 0; j < FLOOR_TAPS; j++) {
            double p[3] = {disc[j][0], (double)v->position[1] + 1.5 * LIFT * views[i].texel, disc[j][1]};
            seen += rise * occlusion_seen(&views[i], depth, i, p);
        }
        all += rise * FLOOR_TAPS;
    }
    v->open[0] = (float)(seen / all);
}


/* openness of both sides of a vertex */
static void occlusion_vertex(const occlusion_view *views, const float *depth, render_vertex *v)
{
    double seen[2] = {0, 0}, all[2] = {0, 0};

    for (int i = 0; i < DIRECTIONS; i++) {
        const double *d = views[i].towards;
        double cosine = (double)v->normal[0] * d[0] + (double)v->normal[1] * d[1] + (double)v->normal[2] * d[2];
        int side = cosine < 0;
        double lift = LIFT * views[i].texel * (side ? -1.0 : 1.0), p[3];

        for (int k = 0; k < 3; k++)
            p[k] = (double)v->position[k] + lift * (double)v->normal[k] + 0.5 * fabs(lift) * d[k];
        all[side] += fabs(cosine);
        seen[side] += fabs(cosine) * occlusion_seen(&views[i], depth, i, p);
    }
    for (int side = 0; side < 2; side++) v->open[side] = (float)(all[side] > 0 ? seen[side] / all[side] : 1.0);
}


/* v = half itself, half the mean of its neighbours along triangle sides */
static int occlusion_smooth(render_part *part, render_error *error)
{
    size_t n = (size_t)part->vertex_count;
    float *sum = malloc(3 * n * sizeof *sum);

    if (!sum) return render_fail(error, "no picture: out of memory for the occlusion");
    for (int round = 0; round < SMOOTHING; round++) {
        memset(sum, 0, 3 * n * sizeof *sum);
        for (int32_t i = 0; i < part->index_count; i++) {
            int32_t a = part->triangles[i], b = part->triangles[i % 3 == 2 ? i - 2 : i + 1];
            for (int k = 0; k < 2; k++) {
                sum[3 * a + k] += part->v[b].open[k];
                sum[3 * b + k] += part->v[a].open[k];
            }
            sum[3 * a + 2] += 1.0f;
            sum[3 * b + 2] += 1.0f;
        }
        for (size_t i = 0; i < n; i++)
            for (int k = 0; k < 2 && sum[3 * i + 2] > 0; k++)
                part->v[i].open[k] = 0.5f * (part->v[i].open[k] + sum[3 * i + (size_t)k] / sum[3 * i + 2]);
    }
    free(sum);
    return 0;
}


int render_occlusion(render *r, render_error *error)
{
    occlusion_view views[DIRECTIONS];
    float *depth = malloc((size_t)DIRECTIONS * SIDE * SIDE * sizeof *depth);
    int rc = -1;

    if (!depth) return render_fail(error, "no picture: out of memory for the occlusion");
    if (occlusion_maps(r, views, depth, error)) goto done;
    for (int32_t i = 0; i < r->part_count; i++) {
        render_part *part = &r->parts[i];
        int is_floor = part->kind == RENDER_FLOOR;
        for (int32_t j = 0; j < part->vertex_count; j++) {
            if (is_floor) occlusion_floor(r, views, depth, &part->v[j]);
            else occlusion_vertex(views, depth, &part->v[j]);
        }
        if (!is_floor && occlusion_smooth(part, error)) goto done;
    }
    rc = 0;

done:
    free(depth);
    return rc;
}
