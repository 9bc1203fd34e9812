/* A picture in memory, 8 bits a channel, and what is drawn on it: rectangles and text. */
#ifndef LOBE_PICTURE_CANVAS_H
#define LOBE_PICTURE_CANVAS_H

typedef struct lobe_canvas {
    int width, height;
    unsigned char *rgb; /* height x width x 3, row 0 on top */
} lobe_canvas;

/* 0 where there is no memory. */
int lobe_canvas_allocate(lobe_canvas *canvas, int width, int height, const unsigned char background[3]);
void lobe_canvas_free(lobe_canvas *canvas);

/* Does nothing outside the picture. */
void lobe_canvas_pixel(lobe_canvas *canvas, int x, int y, const unsigned char colour[3]);

/* Letters of 5 x 7 dots, `scale` pixels a dot and 6 dots a letter; lower case is written as upper case. */
void lobe_canvas_text(lobe_canvas *canvas, int x, int y, int scale, const char *text, const unsigned char colour[3]);
int lobe_text_width(const char *text, int scale);

#endif
