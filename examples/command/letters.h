/* letters.h: short texts on pictures, in a bitmap font of 5 x 7 dots. */
#ifndef MUSLIN_LETTERS_H
#define MUSLIN_LETTERS_H

#include <stdint.h>

#define LETTER_WIDE 5
#define LETTER_HIGH 7

/* The picture that is written on. */
typedef struct letters_page {
    int32_t width, height, dot; /* of the picture and of a dot of a letter [pixels] */
    unsigned char *rgba;
} letters_page;

/* Fills a rectangle with a colour (3 bytes); what lies outside the picture is left out. */
void letters_fill(const letters_page *p, int32_t x, int32_t y, int32_t wide, int32_t high, const unsigned char *colour);

/* Writes a text, its upper left corner at x, y. The font has a to z, digits, "P", "-", ".", "%" and "_"; other letters
 * are left blank. A letter with its gap is (LETTER_WIDE + 1) dots wide. */
void letters_say(const letters_page *p, int32_t x, int32_t y, const char *text);

#endif
