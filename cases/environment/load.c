/* From a path to a map: reads the whole file, tells its format, and says on standard error why it was refused. */
#include "environment.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int lobe_environment_parse(const unsigned char *bytes, size_t size, lobe_environment *map,
                           lobe_environment_fault *fault)
{
    if (size >= 2 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f'))
        return lobe_environment_from_pfm(bytes, size, map, fault);
    if (size >= 2 && bytes[0] == '#' && bytes[1] == '?')
        return lobe_environment_from_rgbe(bytes, size, map, fault);
    if (size < 2)
        return lobe_environment_refuse(fault, 0, "found a file of %zu bytes, expected #? (RGBE) or PF (PFM)", size);
    return lobe_environment_refuse(fault, 0, "found bytes 0x%02x 0x%02x, expected #? (RGBE) or PF (PFM)", bytes[0],
                                   bytes[1]);
}

static unsigned char *read_all(FILE *f, const char *path, size_t *size)
{
    unsigned char *bytes = NULL;
    size_t room = 0, n;
    *size = 0;
    do {
        if (*size == room) {
            room = room ? 2 * room : (size_t)1 << 16;
            unsigned char *more = room <= (size_t)1 << 31 ? realloc(bytes, room) : NULL;
            if (!more) {
                fprintf(stderr, "%s: byte %zu: larger than memory or 2 GiB\n", path, *size);
                free(bytes);
                return NULL;
            }
            bytes = more;
        }
        n = fread(bytes + *size, 1, room - *size, f);
        *size += n;
    } while (n);
    if (ferror(f)) {
        fprintf(stderr, "%s: byte %zu: cannot be read: %s\n", path, *size, strerror(errno));
        free(bytes);
        return NULL;
    }
    return bytes;
}

unsigned char *lobe_environment_read(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    if (!f) {
        fprintf(stderr, "%s: cannot be opened: %s\n", path, strerror(errno));
        return NULL;
    }
    unsigned char *bytes = read_all(f, path, size);
    fclose(f);
    return bytes;
}

int lobe_environment_load(const char *path, lobe_environment *map)
{
    lobe_environment_fault fault = {0, ""};
    size_t size;
    unsigned char *bytes = lobe_environment_read(path, &size);
    int good;
    if (!bytes)
        return 0;
    good = lobe_environment_parse(bytes, size, map, &fault);
    free(bytes);
    if (!good)
        fprintf(stderr, "%s: byte %zu: %s\n", path, fault.offset, fault.reason);
    return good;
}
