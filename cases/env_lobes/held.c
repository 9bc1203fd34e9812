#include "held.h"
#include <stdio.h>
#include <string.h>
#include "rooms.h"

static const struct {
    lobe_room room;
    unsigned seed;
} rooms[] = {
    {LOBE_ROOM_SKY, 101},     {LOBE_ROOM_SKY, 102},    {LOBE_ROOM_LAMPS, 101},  {LOBE_ROOM_LAMPS, 102},
    {LOBE_ROOM_CHECKER, 101}, {LOBE_ROOM_CLOUDS, 101}, {LOBE_ROOM_CLOUDS, 102},
};
enum { ROOMS = sizeof rooms / sizeof rooms[0], WIDTH = 256 };

static bool in_room(lobe_room room, unsigned seed, double dark, lobe_held_fn *f, void *ctx)
{
    lobe_environment map;
    char name[40];
    bool good;
    if (!lobe_room_make(&map, room, WIDTH, seed)) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    snprintf(name, sizeof name, "%s %u", lobe_room_name[room], seed);
    good = f(ctx, name, &map, dark);
    lobe_environment_free(&map);
    return good;
}

static bool in_file(const char *path, lobe_held_fn *f, void *ctx)
{
    const char *slash = strrchr(path, '/');
    lobe_environment map, small;
    bool good;
    if (!lobe_environment_load(path, &map))
        return false;
    if (map.width % WIDTH || !lobe_environment_shrink(&map, map.width / WIDTH, &small)) {
        fprintf(stderr, "lobefit: search: '%s' has %d columns, expected a multiple of %d\n", path, map.width, WIDTH);
        lobe_environment_free(&map);
        return false;
    }
    good = f(ctx, slash ? slash + 1 : path, &small, 0);
    lobe_environment_free(&small);
    lobe_environment_free(&map);
    return good;
}

bool lobe_held_each(const lobe_held *held, lobe_held_fn *f, void *ctx)
{
    for (int i = 0; i < (int)ROOMS; i++) {
        if (!in_room(rooms[i].room, rooms[i].seed, 0, f, ctx))
            return false;
    }
    for (int i = 0; i < held->file_count; i++) {
        if (!in_file(held->files[i], f, ctx))
            return false;
    }
    return true;
}

int lobe_held_count(const lobe_held *held) { return (int)ROOMS + held->file_count; }

bool lobe_held_texel(lobe_held_fn *f, void *ctx) { return in_room(LOBE_ROOM_TEXEL, 101, 0.1, f, ctx); }
