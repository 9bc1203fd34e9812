/* The same sums through OpenCL: the host gathers the cells of as many tiles as fit into one upload. */
#define LOBE_DOUBLE
#include "kernel.h"
#include "prefilter.h"
#include "../fit/interrupt.h"
#include "clock.h"
#include "../fit/opencl.h"
#include <stdlib.h>
#include <string.h>

/* core/dialect.h, kernel.h and rows.cl, embedded at build time */
extern const char lobe_prefilter_cl_source[];

enum { MOST = LOBE_PREFILTER_TILE * LOBE_PREFILTER_TILE, BATCH_TILES = 1024 };
#define BATCH_CELLS ((size_t)1 << 20) /* 80 MB */

typedef struct batch {
    const lobe_prefilter_source *source;
    const lobe_prefilter_options *options;
    lobe_cube *cube;
    double *in, *out, *table; /* 5 and 3 numbers a direction; the parameter and the cells */
    size_t rows, cells, room; /* room: cells that fit into table */
    size_t done, texels;
    lobe_prefilter_clock clock;
    char *error;
    size_t error_size;
} batch;

static int grow(batch *b, size_t cells)
{
    if (cells <= b->room)
        return 1;
    const size_t room = cells > BATCH_CELLS ? cells : BATCH_CELLS;
    double *more = realloc(b->table, (1 + room * LOBE_PREFILTER_ROW) * sizeof *more);
    if (!more)
        return 0;
    b->table = more;
    b->room = room;
    return 1;
}

/* Tiles [first, end), all of one mip. */
static int compute(batch *b, const lobe_prefilter_tile *tiles, size_t first, size_t end)
{
    const lobe_prefilter_kernel kernel = b->options->scale.kernel;
    const double *out = b->out;
    b->table[0] = lobe_prefilter_parameter(kernel, lobe_prefilter_width(&b->options->scale, tiles[first].mip));
    const lobe_opencl_job job = {lobe_prefilter_cl_source,
                                 "lobe_prefilter_rows",
                                 b->in,
                                 5 * b->rows,
                                 b->out,
                                 3 * b->rows,
                                 b->table,
                                 1 + b->cells * LOBE_PREFILTER_ROW,
                                 kernel == LOBE_PREFILTER_SG,
                                 b->rows};
    if (lobe_opencl_run(&job, b->error, b->error_size))
        return 0;
    for (size_t i = first; i < end; i++) {
        lobe_prefilter_tile_store(&tiles[i], out, b->cube);
        out += 3 * tiles[i].height * tiles[i].width;
    }
    b->done += b->rows;
    b->rows = b->cells = 0;
    return 1;
}

static int append(batch *b, const lobe_prefilter_tile *tile, const lobe_prefilter_cells *cells, const double *d)
{
    if (!grow(b, b->cells + cells->count))
        return 0;
    memcpy(b->table + 1 + b->cells * LOBE_PREFILTER_ROW, cells->rows,
           cells->count * LOBE_PREFILTER_ROW * sizeof(double));
    for (int k = 0; k < tile->height * tile->width; k++) {
        double *row = b->in + 5 * b->rows++;
        memcpy(row, d + 3 * k, 3 * sizeof(double));
        row[3] = (double)b->cells;
        row[4] = (double)cells->count;
    }
    b->cells += cells->count;
    return 1;
}

static lobe_prefilter_status run(batch *b, const lobe_prefilter_tile *tiles, size_t count, lobe_prefilter_cells *cells)
{
    const lobe_prefilter_scale *scale = &b->options->scale;
    size_t first = 0;
    for (size_t i = 0; i < count; i++) {
        const lobe_prefilter_tile *tile = &tiles[i];
        double d[3 * MOST];
        lobe_prefilter_group group = {scale->kernel,
                                      lobe_prefilter_parameter(scale->kernel, lobe_prefilter_width(scale, tile->mip)),
                                      b->options->detail,
                                      {0, 0, 0},
                                      0};
        lobe_prefilter_tile_directions(tile, lobe_cube_side(b->options->size, tile->mip), d);
        lobe_prefilter_bound(d, tile->height * tile->width, &group);
        if (!lobe_prefilter_gather(b->source, &group, cells))
            return LOBE_PREFILTER_NO_MEMORY;
        const int full = i > first && (tile->mip != tiles[first].mip || i - first == BATCH_TILES ||
                                       b->cells + cells->count > BATCH_CELLS);
        if (full) {
            if (lobe_interrupt_requested())
                return LOBE_PREFILTER_INTERRUPTED;
            if (!compute(b, tiles, first, i))
                return LOBE_PREFILTER_NO_OPENCL;
            if (b->options->progress)
                lobe_prefilter_report(&b->clock, b->done, b->texels);
            first = i;
        }
        if (!append(b, tile, cells, d))
            return LOBE_PREFILTER_NO_MEMORY;
    }
    if (first < count && !compute(b, tiles, first, count))
        return LOBE_PREFILTER_NO_OPENCL;
    return LOBE_PREFILTER_DONE;
}

lobe_prefilter_status lobe_prefilter_opencl(const lobe_prefilter_source *source, const lobe_prefilter_options *options,
                                            const lobe_prefilter_tile *tiles, size_t count, lobe_cube *cube,
                                            char *error, size_t error_size)
{
    lobe_prefilter_cells cells = {NULL, 0, 0};
    batch b = {source, options, cube, NULL, NULL, NULL, 0, 0, 0, 0, 0, {0, 0}, error, error_size};
    for (size_t i = 0; i < count; i++)
        b.texels += (size_t)(tiles[i].height * tiles[i].width);
    lobe_prefilter_start(&b.clock);
    lobe_prefilter_status status = LOBE_PREFILTER_NO_MEMORY;
    b.in = malloc(BATCH_TILES * MOST * 5 * sizeof(double));
    b.out = malloc(BATCH_TILES * MOST * 3 * sizeof(double));
    if (b.in && b.out && grow(&b, 1))
        status = run(&b, tiles, count, &cells);
    lobe_prefilter_finish(&b.clock, b.done, b.texels);
    lobe_prefilter_cells_free(&cells);
    free(b.in);
    free(b.out);
    free(b.table);
    return status;
}
