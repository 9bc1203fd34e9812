/* An equirectangular map of radiance: how it is read, and where its texels look.
 *
 * Row 0 is the top. World: z up, the middle column looks along +x, columns to the right turn towards -y, as seen from
 * inside: column j of w covers the azimuths pi (1 - 2 j / w) down to pi (1 - 2 (j + 1) / w), azimuth 0 being +x and
 * pi/2 being +y. */
#ifndef LOBE_ENVIRONMENT_H
#define LOBE_ENVIRONMENT_H
#include <stddef.h>

#define LOBE_PI 3.14159265358979323846

typedef struct lobe_environment {
    int width, height;
    float *rgb; /* height x width x 3, row 0 on top */
} lobe_environment;

/* Why a file was refused, and the byte at which it went wrong. */
typedef struct lobe_environment_fault {
    size_t offset;
    char reason[200]; /* what was found, what was expected */
} lobe_environment_fault;

enum { LOBE_ENVIRONMENT_MAX_SIDE = 32768, LOBE_ENVIRONMENT_MAX_TEXELS = 1 << 27 };

/* Parse a file held in memory. 1 and the map (free with lobe_environment_free), or 0 and the fault; the first of the
 * three tells the format by its first bytes. */
int lobe_environment_parse(const unsigned char *bytes, size_t size, lobe_environment *map,
                           lobe_environment_fault *fault);
int lobe_environment_from_rgbe(const unsigned char *bytes, size_t size, lobe_environment *map,
                               lobe_environment_fault *fault);
int lobe_environment_from_pfm(const unsigned char *bytes, size_t size, lobe_environment *map,
                              lobe_environment_fault *fault);
/* Where 0, "file: byte N: found ..., expected ..." stands on standard error. */
int lobe_environment_load(const char *path, lobe_environment *map);
/* The bytes of a file, to be freed, or NULL after a message of that kind. */
unsigned char *lobe_environment_read(const char *path, size_t *size);

/* Sets offset and reason; returns 0. */
int lobe_environment_refuse(lobe_environment_fault *fault, size_t offset, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* A black map. 0 where there is no memory. */
int lobe_environment_allocate(lobe_environment *map, int width, int height);
void lobe_environment_free(lobe_environment *map);

double lobe_environment_solid_angle(const lobe_environment *map, int row); /* of one texel of this row */
void lobe_environment_direction(const lobe_environment *map, int row, int column, double d[3]);
/* Averages over blocks of factor x factor texels, weighted with their solid angle. 0 where the sides do not divide, or
 * there is no memory. */
int lobe_environment_shrink(const lobe_environment *map, int factor, lobe_environment *small);

#endif
