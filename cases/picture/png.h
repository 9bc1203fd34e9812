/* A canvas as a PNG file. */
#ifndef LOBE_PICTURE_PNG_H
#define LOBE_PICTURE_PNG_H
#include "canvas.h"

/* Written whole or not at all. 0 after a message on standard error. */
int lobe_png_write(const lobe_canvas *canvas, const char *path);

#endif
