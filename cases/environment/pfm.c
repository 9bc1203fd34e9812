/* Portable float maps: "PF" colour or "Pf" grey, width, height, scale; rows from the bottom up, little endian where
 * the scale is negative. The size of the scale is ignored, as most writers leave it at 1. */
#include "environment.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* The next word of the header and the one white-space character behind it; other bytes than ASCII end it. */
static int word(const unsigned char *bytes, size_t size, size_t *at, char text[32])
{
    size_t n = 0;
    while (*at < size && (bytes[*at] == ' ' || bytes[*at] == '\n' || bytes[*at] == '\r' || bytes[*at] == '\t'))
        ++*at;
    while (*at < size && bytes[*at] > ' ' && bytes[*at] < 127 && n < 31)
        text[n++] = (char)bytes[(*at)++];
    text[n] = 0;
    if (n == 0 || *at >= size || bytes[*at] > ' ')
        return 0;
    ++*at;
    return 1;
}

static float texel(const unsigned char *p, int little)
{
    const uint32_t b = little ? (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24
                              : (uint32_t)p[3] | (uint32_t)p[2] << 8 | (uint32_t)p[1] << 16 | (uint32_t)p[0] << 24;
    float f;
    memcpy(&f, &b, sizeof f);
    return f;
}

typedef struct head {
    int channels, little, width, height;
} head;

static int header(const unsigned char *bytes, size_t size, size_t *at, head *h, lobe_environment_fault *fault)
{
    char text[32], *end;
    size_t start;
    if (!word(bytes, size, at, text) || (strcmp(text, "PF") != 0 && strcmp(text, "Pf") != 0))
        return lobe_environment_refuse(fault, 0, "found '%s', expected PF or Pf and white space", text);
    h->channels = text[1] == 'F' ? 3 : 1;
    for (int i = 0; i < 2; i++) {
        const char *name = i ? "height" : "width";
        long side;
        start = *at;
        if (!word(bytes, size, at, text))
            return lobe_environment_refuse(fault, start, "found '%s', expected the %s and white space", text, name);
        side = strtol(text, &end, 10);
        if (*end || side < 1 || side > LOBE_ENVIRONMENT_MAX_SIDE)
            return lobe_environment_refuse(fault, start, "found %s '%s', expected a whole number in [1, %d]", name,
                                           text, LOBE_ENVIRONMENT_MAX_SIDE);
        *(i ? &h->height : &h->width) = (int)side;
    }
    start = *at;
    if (!word(bytes, size, at, text))
        return lobe_environment_refuse(fault, start, "found '%s', expected the scale and white space", text);
    const double scale = strtod(text, &end);
    if (*end || !isfinite(scale) || scale == 0)
        return lobe_environment_refuse(fault, start, "found scale '%s', expected a number other than 0", text);
    h->little = scale < 0;
    if (h->width > LOBE_ENVIRONMENT_MAX_TEXELS / h->height)
        return lobe_environment_refuse(fault, start, "found %d x %d texels, expected at most %d", h->width, h->height,
                                       LOBE_ENVIRONMENT_MAX_TEXELS);
    return 1;
}

int lobe_environment_from_pfm(const unsigned char *bytes, size_t size, lobe_environment *map,
                              lobe_environment_fault *fault)
{
    size_t at = 0;
    head h = {0, 0, 0, 0};
    if (!header(bytes, size, &at, &h, fault))
        return 0;
    const size_t texels = (size_t)h.width * (size_t)h.height, step = 4 * (size_t)h.channels;
    if ((size - at) / step < texels)
        return lobe_environment_refuse(fault, size, "found the end of the file after %zu texels, expected %zu",
                                       (size - at) / step, texels);
    if (!lobe_environment_allocate(map, h.width, h.height))
        return lobe_environment_refuse(fault, at, "found %d x %d texels, expected a map that fits into memory", h.width,
                                       h.height);
    for (int y = h.height - 1; y >= 0; y--)
        for (int x = 0; x < h.width; x++, at += step) {
            float *out = map->rgb + 3 * ((size_t)y * (size_t)h.width + (size_t)x);
            for (int k = 0; k < 3; k++) {
                const size_t where = at + (h.channels == 3 ? 4 * (size_t)k : 0);
                out[k] = texel(bytes + where, h.little);
                if (!isfinite(out[k])) {
                    const float bad = out[k];
                    lobe_environment_free(map);
                    return lobe_environment_refuse(fault, where, "found %g, expected a finite number", (double)bad);
                }
            }
        }
    return 1;
}
