/*
 * shader.c: the programs that run on the device, and their building.
 *
 * depth:  positions only, for shadow maps and occlusion
 * back:   a light gradient behind everything
 * floor:  takes light from the background: shadow of the key light with a penumbra that widens away from the feet, as
 *         percentage-closer soft shadows do (Fernando, 2005), computed per vertex of a fine grid, and occlusion of the
 *         sky
 * body:   body and cloth: key light with shadow, fill, rim, hemisphere of sky and floor times ambient occlusion with
 *         colour bleeding (Jimenez and others, Practical Realtime Strategies for Accurate Indirect Occlusion, 2016,
 *         eq. 10); skin has a broad highlight, cloth a sheen at grazing view and a woven pattern along the grain
 * finish: linear colour to sRGB bytes with an ordered dither, so that gradients show no bands
 *
 * Light arrives in the shader as world directions; everything is linear until finish.
 */
#include "render_internal.h"

#include <string.h>

#define PIECES_MAX 5

static const char shader_version[] = "#version 330 core\n";

static const char depth_vertex[] = "layout(location = 0) in vec3 a_position;\n"
                                   "uniform mat4 u_view;\n"
                                   "void main() { gl_Position = u_view * vec4(a_position, 1.0); }\n";

static const char depth_fragment[] = "void main() {}\n";

/* one triangle over the whole picture */
static const char whole_vertex[] = "out vec2 v_at;\n"
                                   "void main() {\n"
                                   "    v_at = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
                                   "    gl_Position = vec4(2.0 * v_at - 1.0, 0.0, 1.0);\n"
                                   "}\n";

/* light grey, a little cooler above; a soft horizon where floor and wall would meet */
static const char back_fragment[] =
    "in vec2 v_at;\n"
    "out vec4 o_colour;\n"
    "void main() {\n"
    "    vec3 low = vec3(0.680, 0.665, 0.650), middle = vec3(0.840, 0.838, 0.835), high = vec3(0.700, 0.715, 0.735);\n"
    "    float t = v_at.y;\n"
    "    vec3 c = mix(low, middle, smoothstep(-0.05, 0.45, t));\n"
    "    o_colour = vec4(mix(c, high, smoothstep(0.45, 1.15, t)), 1.0);\n"
    "}\n";

/* taps on a golden-angle spiral: even over the disc for any number of them */
static const char spiral[] = "vec2 spiral(int i, float n)\n"
                             "{\n"
                             "    float a = 2.39996323 * float(i);\n"
                             "    return sqrt((float(i) + 0.5) / n) * vec2(cos(a), sin(a));\n"
                             "}\n";

/* The key light spans 0.2 of its distance. What casts the shadow stands on the floor, so a shadow point that lies far
 * from the middle is cast from high up: distance l / cos(rise), which is half of what its penumbra's width follows. */
static const char floor_vertex[] =
    "layout(location = 0) in vec3 a_position;\n"
    "layout(location = 4) in vec2 a_open;\n"
    "uniform mat4 u_view;\n"
    "uniform mat4 u_light;\n"
    "uniform sampler2DShadow u_shadow;\n"
    "uniform vec3 u_key;\n"
    "uniform vec3 u_spread;\n" /* width, height and depth of the light's box [m] */
    "uniform vec3 u_middle;\n"
    "out float v_lit;\n"
    "out vec2 v_open;\n"
    "void main() {\n"
    "    vec3 p = (u_light * vec4(a_position, 1.0)).xyz * 0.5 + 0.5;\n"
    "    float away = max(length(a_position.xz - u_middle.xz) - 0.06, 0.0) / length(u_key.xz);\n"
    "    vec2 radius = (0.012 + 0.10 * away) / u_spread.xy;\n"
    "    float lit = 0.0;\n"
    "    for (int i = 0; i < 80; i++)\n"
    "        lit += textureLod(u_shadow, vec3(p.xy + radius * spiral(i, 80.0), min(p.z, 0.9999) - 0.0015), 0.0);\n"
    "    v_lit = lit / 80.0;\n"
    "    v_open = a_open;\n"
    "    gl_Position = u_view * vec4(a_position, 1.0);\n"
    "}\n";

/* the colour multiplies what is behind; nothing is left of it at the rim of the grid, and where another view joins */
static const char floor_fragment[] =
    "in float v_lit;\n"
    "in vec2 v_open;\n" /* share of the sky; how much of the shade is shown */
    "out vec4 o_colour;\n"
    "uniform vec2 u_joined;\n" /* left, right: 1 where another view joins */
    "uniform vec2 u_size;\n"
    "void main() {\n"
    "    float x = gl_FragCoord.x / u_size.x;\n"
    "    float shown = v_open.y * smoothstep(0.0, 0.22, x + 1.0 - u_joined.x)\n"
    "                  * smoothstep(0.0, 0.22, 2.0 - x - u_joined.y);\n"
    "    float shade = shown * (0.34 * (1.0 - v_lit) + 0.95 * pow(1.0 - v_open.x, 1.6));\n"
    "    o_colour = vec4(1.0 - min(shade, 0.85) * vec3(1.0, 0.985, 0.965), 1.0);\n"
    "}\n";

/* centroid: at the rim of a triangle all values are taken inside of it, or specks show along outlines */
/* between its nodes cloth cuts through what is strongly curved (1 mm at a spacing of 20 mm): the body is taken as 6 mm
 * farther from the eye than it is when it is asked which of the two hides the other */
static const char body_vertex[] =
    "layout(location = 0) in vec3 a_position;\n"
    "layout(location = 1) in vec3 a_normal;\n"
    "layout(location = 2) in vec2 a_texcoord;\n"
    "layout(location = 3) in vec3 a_colour;\n"
    "layout(location = 4) in vec2 a_open;\n"
    "layout(location = 5) in vec2 a_thread;\n"
    "uniform mat4 u_view;\n"
    "uniform vec3 u_eye;\n"
    "uniform int u_kind;\n"
    "centroid out vec3 v_position;\n"
    "centroid out vec3 v_normal;\n"
    "centroid out vec2 v_texcoord;\n"
    "centroid out vec3 v_colour;\n"
    "centroid out vec2 v_open;\n"
    "centroid out vec2 v_thread;\n"
    "void main() {\n"
    "    v_position = a_position;\n"
    "    v_normal = a_normal;\n"
    "    v_texcoord = a_texcoord;\n"
    "    v_colour = a_colour;\n"
    "    v_open = a_open;\n"
    "    v_thread = a_thread;\n"
    "    vec3 behind = u_kind == 0 ? 0.006 * normalize(a_position - u_eye) : vec3(0.0);\n"
    "    gl_Position = u_view * vec4(a_position + behind, 1.0);\n"
    "}\n";

/* Plain weave: threads 0.5 mm apart, over and under in turn, so the repeat is 1 mm. Single threads differ in
 * thickness along their length (slubs), which is what is left to see from afar. Each layer fades out before its
 * period falls under two pixels. weave() gives (brightness, slope along weft, slope along warp). */
static const char weave[] =
    "float hash(vec2 p)\n"
    "{\n"
    "    uvec2 q = uvec2(ivec2(p)) * uvec2(1597334677u, 3812015801u);\n"
    "    uint n = (q.x ^ q.y) * 1597334677u;\n"
    "    n = (n ^ (n >> 15)) * 2246822519u;\n"
    "    return float((n ^ (n >> 13)) & 0xffffu) / 65535.0;\n"
    "}\n"
    "float slub(vec2 p)\n"
    "{\n"
    "    vec2 i = floor(p), f = fract(p);\n"
    "    f = f * f * (3.0 - 2.0 * f);\n"
    "    return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y)"
    " - 0.5;\n"
    "}\n"
    /* how much of a layer of the given period may be seen at w metres a pixel */
    "float seen(float w, float period) { return 1.0 - smoothstep(0.22, 0.5, w / period); }\n"
    "vec3 weave(vec2 at, float w)\n"
    "{\n"
    "    float tone = 0.0;\n"
    "    vec2 slope = vec2(0.0);\n"
    "    vec2 a = vec2(2000.0, 60.0), b = vec2(500.0, 24.0), c = vec2(160.0, 11.0);\n"
    "    tone += 0.11 * seen(w, 0.0012) * (slub(at * a) + slub(at.yx * a + 77.0));\n"
    "    tone += 0.06 * seen(w, 0.004) * (slub(at * b + 31.0) + slub(at.yx * b + 5.0));\n"
    "    tone += 0.035 * seen(w, 0.012) * (slub(at * c + 9.0) + slub(at.yx * c + 3.0));\n"
    /* threads are a quarter of the picture's finest detail: they need ten pixels a repeat to be drawn without moire */
    "    float fine = 1.0 - smoothstep(0.07, 0.16, w / 0.001);\n"
    "    if (fine > 0.0) {\n"
    "        vec2 t = at * 2000.0, i = floor(t), f = fract(t) - 0.5;\n"
    "        bool warp = mod(i.x + i.y, 2.0) < 0.5;\n"
    /* the thread on top is round across its run and arched along it */
    "        vec2 q = warp ? f : f.yx;\n"
    "        vec2 s = vec2(2.2 * q.x, 1.1 * q.y);\n"
    "        tone += fine * (0.10 * cos(6.2832 * q.x) + 0.07 * cos(6.2832 * q.y) - 0.03);\n"
    "        slope = fine * (warp ? s : s.yx);\n"
    "    }\n"
    "    return vec3(1.0 + tone, slope);\n"
    "}\n";

/* Seams and stitches, from the map of thread.c: 1 on a line and 0 at 8 mm. A groove and the fold of an edge tilt the
 * surface across the line; thread lies in a dent of its own. What is narrower than a pixel (w metres wide) is drawn a
 * pixel wide and fainter. sewn() gives (slope along weft, slope along warp, share of light lost, share of thread). */
static const char sewn[] =
    "uniform int u_sewn;\n"
    "uniform sampler2D u_thread;\n"
    "uniform float u_stitch_texel;\n" /* side of a texel [m] */
    "float band(float away, float half_width, float w)\n"
    "{\n"
    "    return clamp((half_width + 0.5 * w - away) / w, 0.0, 1.0) * min(2.0 * half_width / w, 1.0);\n"
    "}\n"
    "vec4 sewn(vec2 at, float w)\n"
    "{\n"
    "    vec2 texel = 1.0 / vec2(textureSize(u_thread, 0));\n"
    "    vec4 t = texture(u_thread, at);\n"
    "    if (max(t.x, max(t.y, t.z)) <= 0.0) return vec4(0.0);\n"
    "    vec2 right = vec2(texel.x, 0.0), up = vec2(0.0, texel.y);\n"
    "    vec3 x = texture(u_thread, at + right).xyz - texture(u_thread, at - right).xyz;\n"
    "    vec3 y = texture(u_thread, at + up).xyz - texture(u_thread, at - up).xyz;\n"
    "    vec3 away = 0.008 * (1.0 - t.xyz);\n"
    "    x *= 0.004 / u_stitch_texel, y *= 0.004 / u_stitch_texel;\n" /* of length 1, towards the line */
    "    vec3 wide = max(vec3(0.0016, 0.0012, 0.0013), 0.6 * w);\n"
    "    vec3 tilt = vec3(0.9, 0.45, 0.8) * exp(-(away * away) / (wide * wide)) * min(vec3(1.0), vec3(0.0022) / w);\n"
    "    float dash = mix(1.0, smoothstep(0.18, 0.34, t.w), 1.0 - smoothstep(0.0006, 0.0016, w));\n"
    "    float lost = 0.42 * band(away.x, 0.0006, w) + 0.20 * band(away.z, 0.0006, w);\n"
    "    return vec4(dot(tilt, x), dot(tilt, y), lost, dash * band(away.y, 0.00045, w));\n"
    "}\n";

static const char body_head[] =
    "centroid in vec3 v_position;\n"
    "centroid in vec3 v_normal;\n"
    "centroid in vec2 v_texcoord;\n"
    "centroid in vec3 v_colour;\n"
    "centroid in vec2 v_open;\n"
    "centroid in vec2 v_thread;\n"
    "out vec4 o_colour;\n"
    "uniform mat4 u_light;\n"
    "uniform vec3 u_eye;\n"
    "uniform vec3 u_key;\n"
    "uniform vec3 u_fill;\n"
    "uniform vec3 u_rim;\n"
    "uniform int u_kind;\n"
    "uniform int u_woven;\n"
    "uniform int u_printed;\n"
    "uniform vec2 u_repeats;\n"
    "uniform sampler2D u_print;\n"
    "uniform sampler2DShadow u_shadow;\n"
    "uniform float u_texel;\n" /* side of a texel of the shadow map [m] */
    "uniform vec3 u_spread;\n"
    /* share of the key light that arrives; off the surface by a little more than the filter is wide on a slope.
     * `taps` is 0 where no light comes anyway: the loop is not entered */
    "float lit(vec3 p, vec3 n, int taps)\n"
    "{\n"
    "    float slope = sqrt(max(1.0 - dot(n, u_key) * dot(n, u_key), 0.0));\n"
    "    vec3 q = p + n * (0.0008 + 0.007 * slope) + u_key * 0.001;\n"
    "    q = (u_light * vec4(q, 1.0)).xyz * 0.5 + 0.5;\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < taps; i++)\n"
    "        sum += textureLod(u_shadow, vec3(q.xy + 0.009 * spiral(i, float(taps)) / u_spread.xy, q.z), 0.0);\n"
    "    return sum / float(max(taps, 1));\n"
    "}\n"
    /* light that was lost in a crease comes back coloured */
    "vec3 bleed(float open, vec3 base)\n"
    "{\n"
    "    vec3 a = 2.0404 * base - 0.3324, b = 4.7951 * base - 0.6417, c = 2.7552 * base + 0.6903;\n"
    "    return max(vec3(open), ((open * a - b) * open + c) * open);\n"
    "}\n"
    /* straight up to 0.7, then a shoulder that ends at 1 */
    "vec3 shoulder(vec3 c)\n"
    "{\n"
    "    vec3 over = max(c - 0.7, 0.0);\n"
    "    return min(c, 0.7) + 0.3 * (1.0 - exp(-over / 0.3));\n"
    "}\n";

static const char body_fragment[] =
    "void main() {\n"
    "    bool cloth = u_kind == 1, wrong = !gl_FrontFacing;\n"
    "    vec3 v = normalize(u_eye - v_position);\n"
    "    vec3 n = normalize(v_normal) * (wrong ? -1.0 : 1.0);\n"
    "    vec3 base = v_colour;\n"
    "    float open = wrong ? v_open.y : v_open.x;\n"
    "    float wrap = cloth ? 0.18 : 0.12;\n"
    "    float facing = max((dot(n, u_key) + wrap) / (1.0 + wrap), 0.0);\n"
    "    float through = cloth && wrong ? max(-dot(n, u_key), 0.0) : 0.0;\n"
    "    float light = lit(v_position, facing > 0.0 ? n : -n, facing + through > 0.0 ? 10 : 0);\n"
    /* the cloth's own look, in the plane of its panel */
    "    if (u_printed != 0) {\n"
    "        vec4 print = texture(u_print, v_texcoord * u_repeats);\n"
    "        base = mix(base, print.rgb, print.a * (wrong ? 0.35 : 1.0));\n"
    "    }\n"
    "    if (u_woven != 0) {\n"
    "        vec2 dx = dFdx(v_texcoord), dy = dFdy(v_texcoord);\n"
    "        vec3 px = dFdx(v_position), py = dFdy(v_position);\n"
    "        float pixel = max(length(dx), length(dy));\n"
    "        vec3 w = weave(v_texcoord, pixel);\n"
    "        base *= w.x;\n"
    "        float turn = sign(dx.x * dy.y - dx.y * dy.x);\n"
    "        vec3 weft = turn * (px * dy.y - py * dx.y), warp = turn * (py * dx.x - px * dy.x);\n"
    "        weft /= max(length(weft), 1e-9);\n"
    "        warp /= max(length(warp), 1e-9);\n"
    "        n = normalize(n + 0.35 * (weft * w.y + warp * w.z));\n"
    "        if (u_sewn != 0) {\n"
    "            vec4 s = sewn(v_thread, pixel);\n"
    "            n = normalize(n + weft * s.x + warp * s.y);\n"
    "            base *= 1.0 - s.z;\n"
    "            float tone = dot(base, vec3(0.3, 0.6, 0.1));\n"
    "            base = mix(base, tone > 0.3 ? 0.6 * base : 1.5 * base + 0.06, s.w);\n"
    "        }\n"
    "        facing = max((dot(n, u_key) + wrap) / (1.0 + wrap), 0.0);\n"
    "    }\n"
    "    if (cloth && wrong) base *= 0.70;\n"
    /* light; inside a garment, a fifth of what falls on its outside comes through */
    "    float key = (facing + 0.2 * through) * light;\n"
    "    if (cloth) open = mix(open, wrong ? v_open.x : v_open.y, 0.15);\n"
    "    float fill = max((dot(n, u_fill) + 0.5) / 1.5, 0.0) * open;\n"
    "    float rim = max(dot(n, u_rim), 0.0) * open;\n"
    "    vec3 sky = mix(vec3(0.185, 0.175, 0.165), vec3(0.370, 0.380, 0.395), 0.5 + 0.5 * n.y);\n"
    "    vec3 sum = base * (sky * bleed(open, base) + 0.74 * key * vec3(1.0, 0.975, 0.94)\n"
    "                       + 0.17 * fill * vec3(0.94, 0.97, 1.0) + 0.14 * rim);\n"
    /* gloss: skin has a broad highlight, cloth a nap that catches light at grazing view */
    "    float graze = pow(1.0 - clamp(dot(n, v), 0.0, 1.0), cloth ? 3.0 : 4.0);\n"
    "    if (cloth) {\n"
    "        sum += graze * open * (0.04 + 0.25 * base) * (0.45 + 0.55 * light);\n"
    "    } else {\n"
    "        float h = max(dot(n, normalize(u_key + v)), 0.0), g = max(dot(n, normalize(u_rim + v)), 0.0);\n"
    "        sum += 0.07 * pow(h, 18.0) * light + 0.05 * pow(g, 12.0) * open + 0.10 * graze * open;\n"
    "    }\n"
    "    o_colour = vec4(shoulder(sum), 1.0);\n"
    "}\n";

/* sRGB: 12.92 c below 0.0031308, else 1.055 c^(1/2.4) - 0.055; half a step of noise by the place of the pixel */
static const char finish_fragment[] =
    "uniform sampler2D u_picture;\n"
    "in vec2 v_at;\n"
    "out vec4 o_colour;\n"
    "void main() {\n"
    "    vec3 c = clamp(texelFetch(u_picture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0);\n"
    "    c = mix(12.92 * c, 1.055 * pow(max(c, 1e-6), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));\n"
    "    float noise = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));\n"
    "    o_colour = vec4(c + (noise - 0.5) / 255.0, 1.0);\n"
    "}\n";


static GLuint shader_compile(const render_gl *gl, GLenum stage, int count, const char *const *pieces,
                             render_error *error)
{
    GLuint shader = gl->CreateShader(stage);
    GLint good = 0;
    char log[256] = "";

    gl->ShaderSource(shader, count, pieces, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    log[strcspn(log, "\n")] = '\0';
    render_fail(error, "no picture: the driver refuses a shader: %s", log);
    gl->DeleteShader(shader);
    return 0;
}


static int program_link(const render_gl *gl, render_program *p, GLuint vertex, GLuint fragment, render_error *error)
{
    GLint good = 0;
    char log[256] = "";

    p->id = gl->CreateProgram();
    gl->AttachShader(p->id, vertex);
    gl->AttachShader(p->id, fragment);
    gl->LinkProgram(p->id);
    gl->GetProgramiv(p->id, GL_LINK_STATUS, &good);
    if (!good) {
        gl->GetProgramInfoLog(p->id, sizeof log, NULL, log);
        log[strcspn(log, "\n")] = '\0';
        return render_fail(error, "no picture: the driver cannot link a program: %s", log);
    }
#define UNIFORM_FIND(name) p->name = gl->GetUniformLocation(p->id, "u_" #name);
    RENDER_UNIFORM_LIST(UNIFORM_FIND)
#undef UNIFORM_FIND
    return 0;
}


/* a program of the pieces of its two stages; both lists end in NULL */
static int program_build(const render_gl *gl, render_program *p, const char *const *vertex,
                         const char *const *fragment, render_error *error)
{
    GLuint shaders[2] = {0, 0};
    int rc = -1;

    for (int stage = 0; stage < 2; stage++) {
        const char *const *list = stage ? fragment : vertex;
        const char *pieces[PIECES_MAX + 1] = {shader_version};
        int count = 1;
        while (count <= PIECES_MAX && list[count - 1]) {
            pieces[count] = list[count - 1];
            count++;
        }
        shaders[stage] = shader_compile(gl, stage ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER, count, pieces, error);
        if (!shaders[stage]) goto done;
    }
    rc = program_link(gl, p, shaders[0], shaders[1], error);

done:
    for (int stage = 0; stage < 2; stage++)
        if (shaders[stage]) gl->DeleteShader(shaders[stage]);
    return rc;
}


int render_programs_build(render *r, render_error *error)
{
    static const char *const depth[2][PIECES_MAX + 1] = {{depth_vertex}, {depth_fragment}};
    static const char *const back[2][PIECES_MAX + 1] = {{whole_vertex}, {back_fragment}};
    static const char *const ground[2][PIECES_MAX + 1] = {{spiral, floor_vertex}, {floor_fragment}};
    static const char *const body[2][PIECES_MAX + 1] = {{body_vertex}, {weave, sewn, spiral, body_head, body_fragment}};
    static const char *const finish[2][PIECES_MAX + 1] = {{whole_vertex}, {finish_fragment}};

    if (program_build(&r->gl, &r->depth_program, depth[0], depth[1], error) ||
        program_build(&r->gl, &r->back_program, back[0], back[1], error) ||
        program_build(&r->gl, &r->floor_program, ground[0], ground[1], error) ||
        program_build(&r->gl, &r->body_program, body[0], body[1], error) ||
        program_build(&r->gl, &r->finish_program, finish[0], finish[1], error))
        return -1;
    return 0;
}


void render_programs_free(render *r)
{
    render_program *list[5] = {&r->depth_program, &r->back_program, &r->floor_program, &r->body_program,
                               &r->finish_program};

    for (int i = 0; i < 5; i++)
        if (list[i]->id) r->gl.DeleteProgram(list[i]->id);
}
