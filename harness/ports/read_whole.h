/* A whole file in memory, with a zero byte behind it; NULL if it cannot be read. The caller frees. */
#ifndef LOBE_PORTS_READ_WHOLE_H
#define LOBE_PORTS_READ_WHOLE_H
#include <stdio.h>
#include <stdlib.h>

static inline void *read_whole(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    char *bytes = NULL;
    long n = -1;
    if (!f)
        return NULL;
    if (fseek(f, 0, SEEK_END) == 0 && (n = ftell(f)) >= 0 && fseek(f, 0, SEEK_SET) == 0)
        bytes = malloc((size_t)n + 1);
    if (bytes && fread(bytes, 1, (size_t)n, f) != (size_t)n) {
        free(bytes);
        bytes = NULL;
    }
    fclose(f);
    if (bytes) {
        bytes[n] = 0;
        *size = (size_t)n;
    }
    return bytes;
}

#endif
