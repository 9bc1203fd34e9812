/* What every shipped tier of sphere_light misses on the held-out cells, as CSV.
 *
 *   sphere <cells     reads what `lobefit search sphere_light --cells` writes: rows of positions (uniform, mixed),
 * cell, view in degrees, the five inputs, and the true radiance; a cell's rows follow each other Columns: name, format,
 * kind, title, operations, table bytes, positions, then errors. That of a cell is the relative L2 error over its rows;
 * all, view60 and view75 are rms over the cells, of all views, up to 60 and from 75 degrees; energy is that of the sum
 * over a cell, the largest in magnitude; small is by how much a cell whose sine is below alpha / 2 is worse than a
 * punctual light there, at most. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../registry.h"

enum { INPUTS = 5, CELLS = 512, SETS = 2 };

static const char *const set_names[SETS] = {"uniform", "mixed"};

typedef struct row {
    int set, cell;
    double view, in[INPUTS], truth;
} row;

typedef struct score {
    double cell[CELLS]; /* negative: no such cell */
    double all, view60, view75, worst, energy;
} score;

static row *rows;
static size_t count;

static void refuse(size_t line, const char *why)
{
    fprintf(stderr, "sphere: <stdin>:%zu: %s\n", line, why);
    exit(2);
}

static void read_rows(void)
{
    size_t room = 0, line = 0;
    char text[512], name[16];
    while (fgets(text, sizeof text, stdin)) {
        row *r;
        line++;
        if (text[0] == '#')
            continue;
        if (count == room) {
            room = room ? 2 * room : 16384;
            rows = realloc(rows, room * sizeof *rows);
            if (!rows)
                refuse(line, "out of memory");
        }
        r = &rows[count++];
        if (sscanf(text, "%15s %d %lf %lf %lf %lf %lf %lf %lf", name, &r->cell, &r->view, &r->in[0], &r->in[1],
                   &r->in[2], &r->in[3], &r->in[4], &r->truth) != 9)
            refuse(line, "expected positions, cell, view, five inputs and the truth");
        for (r->set = 0; r->set < SETS && strcmp(name, set_names[r->set]) != 0; r->set++)
            ;
        if (r->set == SETS || r->cell < 0 || r->cell >= CELLS)
            refuse(line, "the positions are neither uniform nor mixed, or the cell is not in [0, 511]");
    }
    if (!count)
        refuse(line, "no rows");
}

static double answer(const lobe_entry *e, const row *r)
{
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    int k;
    for (k = 0; k < INPUTS; k++)
        in[k] = lobe_value_nearest(e->format, r->in[k]);
    e->call(in, out);
    return lobe_value_real(e->format, out[0]);
}

/* A punctual light of the same solid angle: what all of them tend to. */
static double punctual(const row *r)
{
    const double a = r->in[0] * r->in[0], a2 = a * a, v = r->in[1], z = fmax(r->in[2], 0), h = v + z;
    const double across = 4 * r->in[3], s2 = r->in[4] * r->in[4], q = across + h * h, t = across + a2 * h * h;
    const double mask = z * sqrt(a2 + (1 - a2) * v * v) + v * sqrt(a2 + (1 - a2) * z * z);
    return z > 0 ? s2 / (1 + sqrt(1 - s2)) * a2 * q * q * z / (t * t * mask) : 0;
}

/* e NULL: the punctual light. */
static void judge(const lobe_entry *e, int set, score *s)
{
    double all = 0, view60 = 0, view75 = 0;
    size_t first = 0, i;
    int cells = 0, cells60 = 0, cells75 = 0, k;
    for (k = 0; k < CELLS; k++)
        s->cell[k] = -1;
    s->worst = s->energy = 0;
    while (first < count) {
        const row *r = &rows[first];
        double error = 0, truth = 0, sum = 0, true_sum = 0, square, energy;
        for (i = first; i < count && rows[i].set == r->set && rows[i].cell == r->cell; i++) {
            const double y = r->set != set ? 0 : e ? answer(e, &rows[i]) : punctual(&rows[i]);
            error += (y - rows[i].truth) * (y - rows[i].truth);
            truth += rows[i].truth * rows[i].truth;
            sum += y;
            true_sum += rows[i].truth;
        }
        first = i;
        if (r->set != set)
            continue;
        square = error / truth;
        energy = sum / true_sum - 1;
        s->cell[r->cell] = sqrt(square);
        all += square;
        cells++;
        if (r->view <= 60) {
            view60 += square;
            cells60++;
        } else if (r->view >= 75) {
            view75 += square;
            cells75++;
        }
        s->worst = fmax(s->worst, sqrt(square));
        if (fabs(energy) > fabs(s->energy))
            s->energy = energy;
    }
    s->all = sqrt(all / cells);
    s->view60 = sqrt(view60 / cells60);
    s->view75 = sqrt(view75 / cells75);
}

static double small_over(const score *s, const score *point, int set)
{
    double most = 0;
    size_t i;
    for (i = 0; i < count; i++) {
        const row *r = &rows[i];
        if (r->set == set && r->in[4] < .5 * r->in[0] * r->in[0])
            most = fmax(most, s->cell[r->cell] - point->cell[r->cell]);
    }
    return most;
}

int main(int argc, char **argv)
{
    static score point[SETS], s;
    size_t i;
    int set;
    (void)argv;
    if (argc != 1) {
        fprintf(stderr, "usage: sphere <cells\n");
        return 2;
    }
    read_rows();
    for (set = 0; set < SETS; set++)
        judge(NULL, set, &point[set]);
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (!lobe_same(e->model, "sphere_light"))
            continue;
        for (set = 0; set < SETS; set++) {
            judge(e, set, &s);
            printf("%s,%s,tier,%s,%d,0,%s,%.4f,%.4f,%.4f,%.4f,%+.3f,%.4f\n", e->tier, lobe_format_names[e->format],
                   e->tier, e->ops, set_names[set], s.all, s.view60, s.view75, s.worst, s.energy,
                   small_over(&s, &point[set], set));
        }
    }
    free(rows);
    return 0;
}
