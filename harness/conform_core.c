#include "conform_core.h"

void lobe_evaluate_row(const lobe_entry *entry, const lobe_vectors *vectors, uint32_t row, lobe_value *in,
                       lobe_value *out)
{
    int k;
    for (k = 0; k < entry->inputs; k++)
        in[k].bits = vectors->in[(size_t)row * (size_t)entry->inputs + (size_t)k];
    entry->call(in, out);
}

static double distance(double got, double want)
{
    const double d = got > want ? got - want : want - got;
    return d <= LOBE_NOT_FINITE ? d : LOBE_NOT_FINITE; /* NaN too */
}

static double smaller(double a, double b) { return a < b ? a : b; }

static void judge_row(const lobe_entry *entry, const lobe_vectors *vectors, uint32_t row, lobe_part *inside,
                      lobe_part *below)
{
    const int truths = lobe_truth_count(entry);
    const double *truth = vectors->truth + (size_t)row * (size_t)truths;
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    lobe_part *part;
    double got_sum = 0.0, want_sum = 0.0;
    int k, kept = 1;
    lobe_evaluate_row(entry, vectors, row, in, out);
    part = lobe_in_domain(entry, in) ? inside : below;
    for (k = 0; k < truths + entry->sums; k++) {
        const double got = k < truths ? lobe_answer(entry, k, out) : got_sum;
        const double want = k < truths ? truth[k] : want_sum;
        const double error = distance(got, want);
        got_sum += got;
        want_sum += want;
        part->squares[k] += error < 1.0 ? error * error : 1.0;
        if (error > part->worst) {
            part->worst = error;
            part->row = row;
            part->output = k;
        }
        if (!(error <= part->bound))
            kept = 0;
    }
    if (vectors->bound_furnace > 0.0 && entry->outputs == 1) {
        const double energy = lobe_value_real(entry->format, out[0]);
        const double error = distance(truth[0] / (energy > 0.0 ? energy : 1e-300), 1.0);
        if (error > part->furnace)
            part->furnace = error;
        if (!(error <= vectors->bound_furnace))
            kept = 0;
    }
    part->rows++;
    part->passed += (uint32_t)kept;
}

lobe_verdict lobe_judge(const lobe_entry *entry, const lobe_vectors *vectors)
{
    static const lobe_verdict nothing;
    lobe_verdict v = nothing;
    uint32_t row;
    v.inside.worst = v.below.worst = -1.0;
    v.inside.furnace = v.below.furnace = -1.0;
    v.inside.bound = smaller(vectors->bound_max, entry->max);
    v.below.bound = smaller(vectors->bound_max, entry->below_max);
    for (row = 0; row < vectors->rows; row++)
        judge_row(entry, vectors, row, &v.inside, &v.below);
    return v;
}
