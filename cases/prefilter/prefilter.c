/* The tiles of all mips, taken by threads one after another. */
#include "prefilter.h"
#include "../fit/interrupt.h"
#include "clock.h"
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

enum { MOST = LOBE_PREFILTER_TILE * LOBE_PREFILTER_TILE };

typedef struct work {
    const lobe_prefilter_source *source;
    const lobe_prefilter_options *options;
    const lobe_prefilter_tile *tiles;
    size_t count, texels;
    lobe_cube *cube;
    size_t next, done; /* touched atomically: tiles taken, texels filtered */
    int failed;
    lobe_prefilter_clock clock;
} work;

lobe_prefilter_options lobe_prefilter_options_default(lobe_prefilter_kernel kernel, int size)
{
    const int chain = lobe_cube_full_chain(size);
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    lobe_prefilter_options o = {lobe_prefilter_scale_default(kernel, chain > 2 ? chain - 2 : 1),
                                size,
                                LOBE_PREFILTER_DETAIL,
                                1,
                                0,
                                0,
                                isatty(STDERR_FILENO)};
    if (processors > 1)
        o.threads = processors < LOBE_PREFILTER_THREADS ? (int)processors : LOBE_PREFILTER_THREADS;
    return o;
}

static int one(const work *w, const lobe_prefilter_tile *tile, lobe_prefilter_cells *cells)
{
    double d[3 * MOST], rgb[3 * MOST];
    const lobe_prefilter_scale *scale = &w->options->scale;
    const int n = tile->height * tile->width;
    if (tile->mip == 0) {
        for (int i = 0; i < n; i++) {
            const lobe_cube_texel at = {tile->face, tile->row + i / tile->width, tile->column + i % tile->width};
            lobe_prefilter_mirror(&w->source->image, w->options->size, at, rgb + 3 * i);
        }
    } else {
        const double width = lobe_prefilter_width(scale, tile->mip);
        lobe_prefilter_group group = {
            scale->kernel, lobe_prefilter_parameter(scale->kernel, width), w->options->detail, {0, 0, 0}, 0};
        lobe_prefilter_tile_directions(tile, lobe_cube_side(w->options->size, tile->mip), d);
        lobe_prefilter_bound(d, n, &group);
        if (!lobe_prefilter_group_filter(w->source, &group, cells, d, n, rgb))
            return 0;
    }
    lobe_prefilter_tile_store(tile, rgb, w->cube);
    return 1;
}

/* Takes tiles until none is left; `talks` is set for the one thread that reports. */
static void run(work *w, int talks)
{
    lobe_prefilter_cells cells = {NULL, 0, 0};
    while (!lobe_interrupt_requested()) {
        const size_t i = __atomic_fetch_add(&w->next, 1, __ATOMIC_RELAXED);
        if (i >= w->count)
            break;
        if (!one(w, &w->tiles[i], &cells)) {
            __atomic_store_n(&w->failed, 1, __ATOMIC_RELAXED);
            break;
        }
        const size_t texels = (size_t)(w->tiles[i].height * w->tiles[i].width);
        const size_t done = __atomic_add_fetch(&w->done, texels, __ATOMIC_RELAXED);
        if (talks)
            lobe_prefilter_report(&w->clock, done, w->texels);
    }
    lobe_prefilter_cells_free(&cells);
}

static void *helper(void *arg)
{
    run(arg, 0);
    return NULL;
}

static lobe_prefilter_status run_all(work *w)
{
    pthread_t threads[LOBE_PREFILTER_THREADS];
    const int wanted = w->options->threads < LOBE_PREFILTER_THREADS ? w->options->threads : LOBE_PREFILTER_THREADS;
    int started = 0;
    lobe_prefilter_start(&w->clock);
    /* A thread that cannot be started is no error: this one takes what is left. */
    while (started + 1 < wanted && pthread_create(&threads[started], NULL, helper, w) == 0)
        started++;
    run(w, w->options->progress);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    lobe_prefilter_finish(&w->clock, w->done, w->texels);
    if (w->failed)
        return LOBE_PREFILTER_NO_MEMORY;
    return w->done < w->texels ? LOBE_PREFILTER_INTERRUPTED : LOBE_PREFILTER_DONE;
}

/* The tiles of mips [first, end); NULL where there is no memory. */
static lobe_prefilter_tile *tiles_of(int size, int first, int end, size_t *count)
{
    enum { T = LOBE_PREFILTER_TILE };
    size_t n = 0;
    for (int m = first; m < end; m++) {
        const size_t across = (size_t)(lobe_cube_side(size, m) + T - 1) / T;
        n += 6 * across * across;
    }
    lobe_prefilter_tile *tiles = malloc((n + 1) * sizeof *tiles), *out = tiles;
    *count = n;
    for (int m = first; tiles && m < end; m++) {
        const int side = lobe_cube_side(size, m);
        for (int face = 0; face < 6; face++)
            for (int i = 0; i < side; i += T)
                for (int j = 0; j < side; j += T) {
                    const lobe_prefilter_tile t = {
                        m, face, i, j, side - i < T ? side - i : T, side - j < T ? side - j : T};
                    *out++ = t;
                }
    }
    return tiles;
}

static lobe_prefilter_status run_mips(const lobe_prefilter_source *source, const lobe_prefilter_options *o, int first,
                                      int end, lobe_cube *cube, char *error, size_t error_size)
{
    work w = {source, o, NULL, 0, 0, cube, 0, 0, 0, {0, 0}};
    lobe_prefilter_status status;
    lobe_prefilter_tile *tiles = tiles_of(o->size, first, end, &w.count);
    if (!tiles)
        return LOBE_PREFILTER_NO_MEMORY;
    w.tiles = tiles;
    for (size_t i = 0; i < w.count; i++)
        w.texels += (size_t)(tiles[i].height * tiles[i].width);
    if (o->opencl && first > 0)
        status = lobe_prefilter_opencl(source, o, tiles, w.count, cube, error, error_size);
    else
        status = run_all(&w);
    free(tiles);
    return status;
}

lobe_prefilter_status lobe_prefilter(const lobe_prefilter_image *image, const lobe_prefilter_options *o,
                                     lobe_cube *cube, char *error, size_t error_size)
{
    const int mips = o->scale.mips;
    const lobe_prefilter_kernel kernel = o->scale.kernel;
    lobe_prefilter_source source;
    lobe_prefilter_status status;
    const double finest =
        mips > 1 ? o->detail *
                       lobe_prefilter_peak(kernel, lobe_prefilter_parameter(kernel, lobe_prefilter_width(&o->scale, 1)))
                 : 4;
    if (!lobe_cube_allocate(cube, o->size, mips))
        return LOBE_PREFILTER_NO_MEMORY;
    if (!lobe_prefilter_source_build(&source, *image, finest)) {
        lobe_cube_free(cube);
        return LOBE_PREFILTER_NO_MEMORY;
    }
    /* The mirror apart: its texels cost next to nothing, and would spoil the estimate. */
    status = run_mips(&source, o, 0, 1, cube, error, error_size);
    if (status == LOBE_PREFILTER_DONE && mips > 1)
        status = run_mips(&source, o, 1, mips, cube, error, error_size);
    if (status == LOBE_PREFILTER_DONE && o->fit && !lobe_prefilter_fit(&source, o, cube))
        status = lobe_interrupt_requested() ? LOBE_PREFILTER_INTERRUPTED : LOBE_PREFILTER_NO_MEMORY;
    lobe_prefilter_source_free(&source);
    if (status != LOBE_PREFILTER_DONE)
        lobe_cube_free(cube);
    return status;
}
