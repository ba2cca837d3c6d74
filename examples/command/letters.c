/*
 * letters.c: short texts on pictures.
 */
#include "letters.h"

#include <stddef.h>
#include <string.h>

/* the bitmap font: 7 rows from the top; the leftmost dot of a row is 16 */
static const struct {
    char letter;
    unsigned char row[LETTER_HIGH];
} letters[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 2, 4, 8, 31}},
    {'3', {31, 2, 4, 2, 1, 17, 14}},     {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}},
    {'9', {14, 17, 17, 15, 1, 2, 12}},   {'-', {0, 0, 0, 31, 0, 0, 0}},       {'.', {0, 0, 0, 0, 0, 12, 12}},
    {'%', {24, 25, 2, 4, 8, 19, 3}},     {'a', {0, 0, 14, 1, 15, 17, 15}},    {'c', {0, 0, 14, 16, 16, 17, 14}},
    {'e', {0, 0, 14, 17, 31, 16, 14}},   {'i', {4, 0, 12, 4, 4, 4, 14}},      {'k', {16, 16, 18, 20, 24, 20, 18}},
    {'m', {0, 0, 26, 21, 21, 17, 17}},   {'n', {0, 0, 22, 25, 17, 17, 17}},   {'p', {0, 0, 30, 17, 30, 16, 16}},
    {'r', {0, 0, 22, 25, 16, 16, 16}},   {'s', {0, 0, 14, 16, 14, 1, 30}},    {'t', {8, 8, 28, 8, 8, 9, 6}},
    {'u', {0, 0, 17, 17, 17, 19, 13}},   {'P', {30, 17, 17, 30, 16, 16, 16}},
    {'b', {16, 16, 30, 17, 17, 17, 30}}, {'d', {1, 1, 15, 17, 17, 17, 15}},   {'f', {6, 8, 28, 8, 8, 8, 8}},
    {'g', {0, 0, 15, 17, 15, 1, 14}},    {'h', {16, 16, 22, 25, 17, 17, 17}}, {'j', {2, 0, 6, 2, 2, 18, 12}},
    {'l', {12, 4, 4, 4, 4, 4, 14}},      {'o', {0, 0, 14, 17, 17, 17, 14}},   {'q', {0, 0, 15, 17, 15, 1, 1}},
    {'v', {0, 0, 17, 17, 17, 10, 4}},    {'w', {0, 0, 17, 17, 21, 21, 10}},   {'x', {0, 0, 17, 10, 4, 10, 17}},
    {'y', {0, 0, 17, 17, 15, 1, 14}},    {'z', {0, 0, 31, 2, 4, 8, 31}},      {'_', {0, 0, 0, 0, 0, 0, 31}},
};


void letters_fill(const letters_page *p, int32_t x, int32_t y, int32_t wide, int32_t high, const unsigned char *colour)
{
    for (int32_t j = y < 0 ? 0 : y; j < y + high && j < p->height; j++)
        for (int32_t i = x < 0 ? 0 : x; i < x + wide && i < p->width; i++)
            memcpy(p->rgba + 4 * ((size_t)j * (size_t)p->width + (size_t)i), colour, 3);
}


void letters_say(const letters_page *p, int32_t x, int32_t y, const char *text)
{
    static const unsigned char ink[3] = {40, 42, 46};
    for (; *text != '\0'; text++, x += (LETTER_WIDE + 1) * p->dot)
        for (size_t k = 0; k < sizeof letters / sizeof *letters; k++)
            for (int32_t j = 0; letters[k].letter == *text && j < LETTER_HIGH; j++)
                for (int32_t i = 0; i < LETTER_WIDE; i++)
                    if (letters[k].row[j] >> (LETTER_WIDE - 1 - i) & 1)
                        letters_fill(p, x + i * p->dot, y + j * p->dot, p->dot, p->dot, ink);
}
