/*
 * stroke_font.c: letters as single strokes, so that the printed text does not depend on the fonts of a machine.
 *
 * A glyph is a text: its width, then steps of three characters: kind, x, y, the last two as hexadecimal digits:
 *
 *     e  ---- capitals          m move, l line
 *     a  ---- small letters     h quarter of an ellipse, leaves horizontal, arrives upright
 *     4  ---- base line         v quarter of an ellipse, leaves upright, arrives horizontal
 *     0  ---- descenders
 *
 * So "o" is 6 wide: m3a h07 v34 h67 v3a, four quarters from its top. Three units of space follow each glyph. Letters
 * with accents are drawn as their base letter (Latin-1, Latin Extended-A); others are question marks.
 */
#include <string.h>

#include "drawing/stroke_font.h"

#define CAPITAL 10.0  /* units of the grid from the base line to the top of a capital */
#define BASE 4        /* y of the base line on the grid */
#define SPACING 3     /* units between two letters; chosen: three tenths of the height of capitals */
#define KAPPA 0.55228474983079340 /* handle of the cubic of a quarter circle over the radius: 4/3 (sqrt 2 - 1) */

static const char *const glyphs[95] = {
    /* space ! " # $ % & ' */
    "2", "0m0el07m04l05", "2m0el0bm2el2b", "8m3el14m7el54m0bl8bm07l87", "7m7cv4eh0bv49h76v44h06m4fl43",
    "8m8el04m2eh0cv2ah4cv2em68h46v64h86v68", "8m84l1bv3eh5bl07v34h88", "0m0el0b",
    /* ( ) * + , - . / */
    "2m2fl0cl06l23", "2m0fl2cl26l03", "4m2dl27m0cl48m4cl08", "6m08l68m35l3b", "1m15l02", "4m08l48", "0m04l05",
    "5m04l5e",
    /* 0 .. 9 */
    "6m3eh09v34h69v3e", "3m0cl3el34", "6m0bv3eh6bl59l04l64", "6m0cv3eh6bv39h66v34h06", "7m54l5el07l77",
    "6m6el1el09v3ah67v34h06", "6m5eh08l07v34h67v3ah07", "6m0el6el24", "6m3eh1bv39h5bv3em39h06v34h66v39",
    "6m14h6al6bv3eh0bv38h6b",
    /* : ; < = > ? @ */
    "0m04l05m09l0a", "1m15l02m19l1a", "6m6cl08l64", "6m06l66m0al6a", "6m0cl68l04", "6m0bv3eh6bv38l37m34l35",
    "8m85v44h09v4eh89l87m4bh29v47h69v4b",
    /* A .. Z */
    "am04l5ela4m28l88", "8m04l0el4eh7bv49l09m49h86v44l04", "8m8cv4eh09v44h86", "8m04l0el3eh89v34l04",
    "7m7el0el04l74m09l59", "7m7el0el04m09l59", "8m8cv4eh09v44h87l89l59", "8m0el04m8el84m09l89", "0m0el04",
    "5m5el57v24h06", "7m0el04m7el07m3al74", "6m0el04l64", "8m04l0el46l8el84", "8m04l0el84l8e", "8m4eh09v44h89v4e",
    "7m04l0el4eh7bv48l08", "8m4eh09v44h89v4em57l83", "7m04l0el4eh7bv48l08m38l74", "7m7cv4eh0bv49h76v44h06",
    "8m0el8em4el44", "8m0el08v44h88l8e", "8m0el44l8e", "cm0el34l6el94lce", "8m0el84m8el04", "8m0el49l8em49l44",
    "8m0el8el04l84",
    /* [ \ ] ^ _ ` */
    "2m2fl0fl03l23", "5m0el54", "2m0fl2fl23l03", "4m0bl2el4b", "6m03l63", "2m0el2c",
    /* a .. z */
    "6m6al64m67v3ah07v34h67", "6m0el04m07v3ah67v34h07", "5m59v3ah07v34h55", "6m6el64m67v3ah07v34h67",
    "6m07l67v3ah07v34h65", "4m4eh2cl24m0al4a", "6m6al63v30h02m67v3ah07v34h67", "6m0el04m07v3ah67l64",
    "0m0al04m0dl0e", "2m2al22v00m2dl2e", "5m0el04m5al05m27l54", "2m0el06v24", "8m0al04m07v2ah47l44m47v6ah87l84",
    "6m0al04m07v3ah67l64", "6m3ah07v34h67v3a", "6m0al00m07v3ah67v34h07", "6m6al60m67v3ah07v34h67", "4m0al04m07v3al4a",
    "5m59v3ah08v37h56v34h05", "4m2dl26v44m0al4a", "6m0al07v34h67m6al64", "6m0al34l6a", "8m0al24l4al64l8a",
    "6m0al64m6al04", "6m0al34m6al10", "6m0al6al04l64",
    /* { | } ~ */
    "3m3fl1el1al09l18l14l33", "0m0fl02", "3m0fl2el2al39l28l24l03", "6m08l2al48l6a"};

/* base letters of U+00C0 .. U+00FF and of U+0100 .. U+017F */
static const char latin_1[] = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYPsaaaaaaaceeeeiiiidnooooo/ouuuuypy";
static const char latin_a[] = "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOo"
                              "RrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";


uint32_t mus__text_character(const char **text)
{
    const unsigned char *p = (const unsigned char *)*text;
    if (p[0] == 0) return 0;
    int32_t more = p[0] < 0xc0 ? 0 : p[0] < 0xe0 ? 1 : p[0] < 0xf0 ? 2 : 3;
    uint32_t code = p[0] < 0x80 ? p[0] : more == 0 ? 0xfffd : p[0] & (0x3fU >> more);
    *text += 1;
    for (int32_t i = 1; i <= more; i++) {
        if ((p[i] & 0xc0) != 0x80) return 0xfffd;
        code = code << 6 | (p[i] & 0x3fU);
        *text += 1;
    }
    /* refused: overlong forms, and code points beyond Unicode */
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    return code < least[more] || code > 0x10ffff ? 0xfffd : code;
}


/* the letter of `glyphs` for a character, or 0 */
static char stroke_letter(uint32_t code)
{
    char letter = '\0';
    if (code >= 0x20 && code < 0x7f) letter = (char)code;
    else if (code == 0xa0 || code == '\t') letter = ' ';
    else if (code >= 0xc0 && code <= 0xff) letter = latin_1[code - 0xc0];
    else if (code >= 0x100 && code <= 0x17f) letter = latin_a[code - 0x100];
    else if (code >= 0x2010 && code <= 0x2015) letter = '-';
    else if (code == 0x2018 || code == 0x2019) letter = '\'';
    else if (code == 0x201c || code == 0x201d) letter = '"';
    return letter;
}


static const char *stroke_glyph(uint32_t code)
{
    const char letter = stroke_letter(code);
    return glyphs[(letter != '\0' ? letter : '?') - ' '];
}


bool mus__text_has_strokes(const char *text)
{
    bool all = true;
    for (uint32_t code; all && (code = mus__text_character(&text)) != 0;)
        all = stroke_letter(code) != '\0' || code == 0xfffd || code < 0x20 || code == 0x7f;
    return all;
}


static int32_t stroke_digit(char c)
{
    return c <= '9' ? c - '0' : c - 'a' + 10;
}


double mus__text_width(const char *text)
{
    int32_t width = 0;
    for (uint32_t code; (code = mus__text_character(&text)) != 0;)
        width += stroke_digit(stroke_glyph(code)[0]) + SPACING;
    return width > 0 ? (width - SPACING) / CAPITAL : 0.0;
}


size_t mus__text_line(const char *text, double height, double width)
{
    size_t fits = 0, end = 0;
    int32_t wide = 0;
    for (const char *at = text;;) {
        const bool word = *at == ' ' || *at == '\0';
        /* the last letter has no space behind it */
        if (word && fits > 0 && height * ((wide - SPACING) / CAPITAL) > width) break;
        if (word) fits = end;
        const uint32_t code = mus__text_character(&at);
        if (code == 0) break;
        wide += stroke_digit(stroke_glyph(code)[0]) + SPACING;
        end = (size_t)(at - text);
    }
    return fits;
}


double mus__text_advance(uint32_t code)
{
    return (double)(stroke_digit(stroke_glyph(code)[0]) + SPACING) / CAPITAL;
}


/* map from the grid of a glyph to the drawing */
typedef struct text_frame {
    double x, y, unit, cosine, sine;
} text_frame;


static void text_point(const text_frame *f, double x, double y, double *out)
{
    x *= f->unit;
    y = (y - BASE) * f->unit;
    out[0] = f->x + x * f->cosine - y * f->sine;
    out[1] = f->y + x * f->sine + y * f->cosine;
}


static void text_glyph(mus__drawing *drawing, const char *glyph, const text_frame *f)
{
    double x = 0.0, y = 0.0, p[6];
    for (const char *step = glyph + 1; *step != '\0'; step += 3) {
        double to_x = stroke_digit(step[1]), to_y = stroke_digit(step[2]);
        text_point(f, to_x, to_y, p + 4);
        if (step[0] == 'm') mus__draw_move(drawing, p[4], p[5]);
        else if (step[0] == 'l') mus__draw_line(drawing, p[4], p[5]);
        else {
            /* first handle in the direction of leaving, second against the direction of arrival */
            bool level = step[0] == 'h';
            double kx = KAPPA * (to_x - x), ky = KAPPA * (to_y - y);
            text_point(f, level ? x + kx : x, level ? y : y + ky, p);
            text_point(f, level ? to_x : to_x - kx, level ? to_y - ky : to_y, p + 2);
            mus__draw_curve(drawing, p);
        }
        x = to_x;
        y = to_y;
    }
}


void mus__stroke_text(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style)
{
    text_frame f = {x, y, style->height / CAPITAL, style->cosine, style->sine};
    for (uint32_t code; (code = mus__text_character(&text)) != 0;) {
        const char *glyph = stroke_glyph(code);
        text_glyph(drawing, glyph, &f);
        double advance = (stroke_digit(glyph[0]) + SPACING) * f.unit;
        f.x += advance * f.cosine;
        f.y += advance * f.sine;
    }
}
