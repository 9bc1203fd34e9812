#include "canvas.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

int lobe_canvas_allocate(lobe_canvas *canvas, int width, int height, const unsigned char background[3])
{
    canvas->width = width;
    canvas->height = height;
    canvas->rgb = malloc((size_t)width * (size_t)height * 3);
    for (int i = 0; canvas->rgb && i < width * height; i++)
        memcpy(canvas->rgb + 3 * i, background, 3);
    return canvas->rgb != NULL;
}

void lobe_canvas_free(lobe_canvas *canvas)
{
    free(canvas->rgb);
    canvas->rgb = NULL;
}

void lobe_canvas_pixel(lobe_canvas *canvas, int x, int y, const unsigned char colour[3])
{
    if (x >= 0 && y >= 0 && x < canvas->width && y < canvas->height)
        memcpy(canvas->rgb + 3 * ((size_t)y * (size_t)canvas->width + (size_t)x), colour, 3);
}

/* Seven rows a letter, the leftmost dot in bit 4. */
static const struct letter {
    char name;
    unsigned char row[7];
} letters[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}}, {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'D', {30, 17, 17, 17, 17, 17, 30}}, {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 15}}, {'H', {17, 17, 17, 31, 17, 17, 17}}, {'I', {14, 4, 4, 4, 4, 4, 14}},
    {'J', {7, 2, 2, 2, 2, 18, 12}},      {'K', {17, 18, 20, 24, 20, 18, 17}}, {'L', {16, 16, 16, 16, 16, 16, 31}},
    {'M', {17, 27, 21, 21, 17, 17, 17}}, {'N', {17, 25, 21, 19, 17, 17, 17}}, {'O', {14, 17, 17, 17, 17, 17, 14}},
    {'P', {30, 17, 17, 30, 16, 16, 16}}, {'Q', {14, 17, 17, 17, 21, 18, 13}}, {'R', {30, 17, 17, 30, 20, 18, 17}},
    {'S', {15, 16, 16, 14, 1, 1, 30}},   {'T', {31, 4, 4, 4, 4, 4, 4}},       {'U', {17, 17, 17, 17, 17, 17, 14}},
    {'V', {17, 17, 17, 17, 17, 10, 4}},  {'W', {17, 17, 17, 21, 21, 27, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},     {'0', {14, 17, 19, 21, 25, 17, 14}},
    {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {30, 1, 1, 14, 1, 1, 30}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},   {'6', {6, 8, 16, 30, 17, 17, 14}},
    {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {',', {0, 0, 0, 0, 12, 4, 8}},       {':', {0, 12, 12, 0, 12, 12, 0}},
    {'%', {24, 25, 2, 4, 8, 19, 3}},     {'-', {0, 0, 0, 31, 0, 0, 0}},       {'+', {0, 4, 4, 31, 4, 4, 0}},
    {'=', {0, 0, 31, 0, 31, 0, 0}},      {'/', {0, 1, 2, 4, 8, 16, 0}},       {'(', {2, 4, 8, 8, 8, 4, 2}},
    {')', {8, 4, 2, 2, 2, 4, 8}},        {';', {0, 12, 12, 0, 12, 4, 8}},     {'\'', {4, 4, 8, 0, 0, 0, 0}},
    {'_', {0, 0, 0, 0, 0, 0, 31}},       {'|', {4, 4, 4, 4, 4, 4, 4}},
};

static const unsigned char *letter(char c)
{
    static const unsigned char blank[7] = {0};
    for (size_t i = 0; i < sizeof letters / sizeof letters[0]; i++)
        if (letters[i].name == toupper((unsigned char)c))
            return letters[i].row;
    return blank;
}

void lobe_canvas_text(lobe_canvas *canvas, int x, int y, int scale, const char *text, const unsigned char colour[3])
{
    for (; *text; text++, x += 6 * scale) {
        const unsigned char *row = letter(*text);
        for (int i = 0; i < 7 * scale; i++)
            for (int j = 0; j < 5 * scale; j++)
                if (row[i / scale] >> (4 - j / scale) & 1)
                    lobe_canvas_pixel(canvas, x + j, y + i, colour);
    }
}

int lobe_text_width(const char *text, int scale) { return text[0] ? (6 * (int)strlen(text) - 1) * scale : 0; }
