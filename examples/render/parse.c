/*
 * parse.c: the words of the command line: numbers, views, sizes, colours.
 *
 * Numbers are read here, not by strtod, since that follows the locale; the result is within a rounding or two of the
 * nearest double, which no picture can show.
 */
#include "parse.h"

#include <math.h>
#include <string.h>

/* more digits do not change a double */
#define DIGITS_MAX 18


/* digits with at most one point; the exponent of ten that belongs to the mantissa goes to *shift */
static const char *parse_mantissa(const char *at, double *mantissa, int *shift)
{
    int digits = 0, point = 0, any = 0;

    *mantissa = 0;
    *shift = 0;
    for (;; at++) {
        if (*at == '.' && !point) {
            point = 1;
        } else if (*at >= '0' && *at <= '9') {
            any = 1;
            if (digits < DIGITS_MAX) {
                *mantissa = *mantissa * 10.0 + (*at - '0');
                digits += *mantissa > 0;
                *shift -= point;
            } else {
                *shift += !point;
            }
        } else {
            return any ? at : NULL;
        }
    }
}


const char *render_number_parse(const char *text, double *out)
{
    const char *at = text, *end;
    double mantissa;
    int negative = *at == '-', shift;

    if (*at == '-' || *at == '+') at++;
    at = parse_mantissa(at, &mantissa, &shift);
    if (!at) return NULL;

    /* an exponent counts only if it has digits */
    if (*at == 'e' || *at == 'E') {
        int sign = at[1] == '-' ? -1 : 1, exponent = 0;
        end = at + 1 + (at[1] == '-' || at[1] == '+');
        if (*end >= '0' && *end <= '9') {
            for (; *end >= '0' && *end <= '9'; end++)
                if (exponent < 10000) exponent = 10 * exponent + (*end - '0');
            shift += sign * exponent;
            at = end;
        }
    }
    if (mantissa > 0) mantissa = shift < 0 ? mantissa / pow(10.0, -shift) : mantissa * pow(10.0, shift);
    *out = negative ? -mantissa : mantissa;
    return isfinite(*out) ? at : NULL;
}


int render_view_parse(const char *text, render_camera *out, render_error *error)
{
    double value[4] = {0, 0, 1, NAN};
    const char *at = text;
    int count = 0;

    while (count < 4) {
        at = render_number_parse(at, &value[count]);
        if (!at) break;
        count++;
        if (*at != ',') break;
        at++;
    }
    if (!at || *at != '\0' || count < 2 || at[-1] == ',')
        return render_fail(error, "view \"%s\": expected YAW,PITCH or YAW,PITCH,ZOOM in degrees, such as 40,8", text);
    if (!(fabs(value[0]) <= 36000.0) || !(fabs(value[1]) <= 89.0) || !(value[2] >= 0.1 && value[2] <= 100.0))
        return render_fail(error, "view \"%s\": yaw is -36000 to 36000, pitch -89 to 89, zoom 0.1 to 100", text);
    out->yaw = value[0];
    out->pitch = value[1];
    out->zoom = value[2];
    out->height = value[3];
    return 0;
}


int render_size_parse(const char *text, int32_t *width, int32_t *height, render_error *error)
{
    int32_t side[2] = {0, 0};
    const char *at = text;

    for (int k = 0; k < 2; k++) {
        const char *start = at;
        for (; *at >= '0' && *at <= '9'; at++)
            if (side[k] < 1000000) side[k] = 10 * side[k] + (*at - '0');
        if (at == start || *at != (k ? '\0' : 'x'))
            return render_fail(error, "size \"%s\": expected WIDTHxHEIGHT in pixels, such as 1200x1200", text);
        at++;
        if (side[k] < RENDER_SIZE_MIN || side[k] > RENDER_SIZE_MAX)
            return render_fail(error, "size \"%s\": each side is %d to %d pixels", text, RENDER_SIZE_MIN,
                               RENDER_SIZE_MAX);
    }
    *width = side[0];
    *height = side[1];
    return 0;
}


/* sRGB to linear: c / 12.92 below 0.04045, else ((c + 0.055) / 1.055)^2.4 */
static void parse_linear(uint32_t rgb, double *colour)
{
    for (int k = 0; k < 3; k++) {
        double c = (double)((rgb >> (16 - 8 * k)) & 0xffu) / 255.0;
        colour[k] = c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
    }
}


int render_colour_parse(const char *text, double *colour, render_error *error)
{
    /* cloth as it is sold: dyed whites are below 100 %, dyed blacks above 0 */
    static const struct {
        const char *name;
        uint32_t rgb;
    } names[] = {{"white", 0xf2f1ed}, {"ecru", 0xe6dcc6},  {"grey", 0x9a9a9a},  {"black", 0x26262a},
                 {"red", 0xb3312f},   {"rust", 0xb5562f},  {"mustard", 0xd6a23a}, {"green", 0x4f7a4c},
                 {"sage", 0x97a98c},  {"teal", 0x2f7f86},  {"blue", 0x3c68a8},  {"navy", 0x27344f},
                 {"lilac", 0xa896c0}, {"pink", 0xd99aa5},  {"brown", 0x6e4f3a}};
    uint32_t rgb = 0;

    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (!strcmp(text, names[i].name)) {
            parse_linear(names[i].rgb, colour);
            return 0;
        }
    if (text[0] != '#' || strlen(text) != 7 || strspn(text + 1, "0123456789abcdefABCDEF") != 6)
        return render_fail(error, "colour \"%.40s\": expected #RRGGBB or one of white, ecru, grey, black, red, rust, "
                                  "mustard, green, sage, teal, blue, navy, lilac, pink, brown", text);
    for (int k = 1; k < 7; k++) {
        char c = text[k];
        rgb = rgb << 4 | (uint32_t)(c <= '9' ? c - '0' : (c | 32) - 'a' + 10);
    }
    parse_linear(rgb, colour);
    return 0;
}
