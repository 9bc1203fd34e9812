/* `make stability`: the failure map of sphere lights as a table of cells (CSV) and of regions (text).
 * usage: stability CELLS.csv REGIONS.txt */
#include <stdio.h>
#include "../../fit/atomic_file.h"
#include "stability.h"

enum { POSITIONS = 120 };

static void write_cells(FILE *out, const lobe_stability *s)
{
    int f, cell;
    fputs("form,alpha,half_angle,view,error,energy,horizon\n", out);
    for (f = 0; lobe_sphere_candidate_at(f); f++) {
        const lobe_sphere_candidate *form = lobe_sphere_candidate_at(f);
        for (cell = 0; cell < LOBE_STABILITY_CELLS; cell++) {
            const lobe_stability_cell c = lobe_stability_judge(s, form, cell);
            fprintf(out, "%s,%g,%g,%g,%.4f,%.4f,", form->name, c.alpha, c.sigma, c.view, c.error, c.energy);
            if (c.horizon >= 0)
                fprintf(out, "%.4f", c.horizon);
            fputc('\n', out);
        }
    }
}

static void write_regions(FILE *out, const lobe_stability *s)
{
    int f, r;
    fprintf(out,
            "# Sphere lights, relative L2 error in per cent over %d positions a cell, written by make stability.\n",
            s->positions);
    fputs("# rms over the region's cells / worst cell (its alpha, half angle, view in degrees)\n", out);
    for (r = 0; r < LOBE_STABILITY_REGIONS; r++) {
        fprintf(out, "\n%s\n", lobe_stability_region_name[r]);
        for (f = 0; lobe_sphere_candidate_at(f); f++) {
            const lobe_sphere_candidate *form = lobe_sphere_candidate_at(f);
            const lobe_stability_sum sum = lobe_stability_over(s, form, (lobe_stability_region)r);
            fprintf(out, "  %-28s %7.1f / %7.1f  (%g, %g, %g)\n", form->name, 100 * sum.rms, 100 * sum.worst,
                    sum.at.alpha, sum.at.sigma, sum.at.view);
        }
    }
}

/* The exit status. */
static int put(const char *path, const lobe_stability *s, void (*write)(FILE *out, const lobe_stability *s))
{
    lobe_atomic_file file;
    if (!lobe_atomic_open(&file, path))
        return 2;
    write(file.stream, s);
    return lobe_atomic_commit(&file) ? 0 : 2;
}

int main(int argc, char **argv)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    lobe_stability s;
    int status;
    if (argc != 3) {
        fputs("usage: stability CELLS.csv REGIONS.txt\n", stderr);
        return 2;
    }
    options.label = "failure map";
    if (!lobe_stability_make(&s, POSITIONS, &options)) {
        fputs("stability: not enough memory\n", stderr);
        return 2;
    }
    status = put(argv[1], &s, write_cells);
    if (!status)
        status = put(argv[2], &s, write_regions);
    lobe_stability_free(&s);
    return status;
}
