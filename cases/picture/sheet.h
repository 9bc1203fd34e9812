/* The picture's layout: for each scene three rows of spheres and their differences from the truth, with labels. */
#ifndef LOBE_PICTURE_SHEET_H
#define LOBE_PICTURE_SHEET_H
#include "canvas.h"
#include "scene.h"

/* What was shaded of one scene: the discs' points and LOBE_PICTURE_VALUES numbers a point. */
typedef struct lobe_shaded {
    int count, diameter; /* pixels */
    int *pixel;          /* two a point: column, row inside the disc's square */
    double *point;       /* two a point, as lobe_scene_shade takes them */
    double *rgb;
} lobe_shaded;

/* The points of a disc; rgb is there but empty. 0 where there is no memory. */
int lobe_shaded_of(int diameter, lobe_shaded *shaded);
void lobe_shaded_free(lobe_shaded *shaded);

/* An empty sheet with its headings. 0 where there is no memory. */
int lobe_sheet_of(int diameter, int scenes, lobe_canvas *sheet);
void lobe_sheet_draw(lobe_canvas *sheet, int index, const lobe_scene *scene, const lobe_shaded *shaded);

#endif
