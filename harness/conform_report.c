#include "conform_report.h"
#include "conform_core.h"
#include "hash.h"
#include "port.h"

static void print_hex(uint64_t bits, int digits)
{
    char text[17];
    int i;
    for (i = 0; i < digits; i++)
        text[i] = "0123456789abcdef"[bits >> 4 * (digits - 1 - i) & 15u];
    text[digits] = 0;
    lobe_port_print(text);
}

static void print_count(uint32_t n)
{
    char text[11];
    int at = 10;
    text[at] = 0;
    do {
        text[--at] = (char)('0' + n % 10u);
        n /= 10u;
    } while (n);
    lobe_port_print(text + at);
}

/* An error of at most 4 with nine decimals; what is larger is as wrong as infinite. */
static void print_error(double error)
{
    char text[12] = "0.";
    uint32_t scaled;
    int i;
    if (!(error >= 0.0 && error < 4.0)) {
        lobe_port_print(error < 0.0 ? "none" : "inf");
        return;
    }
    scaled = (uint32_t)(error * 1e9 + 0.5);
    text[0] = (char)('0' + scaled / 1000000000u);
    for (i = 0; i < 9; i++) {
        text[10 - i] = (char)('0' + scaled % 10u);
        scaled /= 10u;
    }
    text[11] = 0;
    lobe_port_print(text);
}

static void print_name(const char *kind, const char *model, const char *tier, lobe_format format)
{
    lobe_port_print(kind);
    lobe_port_print(" ");
    lobe_port_print(model);
    lobe_port_print(" ");
    lobe_port_print(tier);
    lobe_port_print(" ");
    lobe_port_print(lobe_format_names[format]);
    lobe_port_print(" ");
}

static void print_case(const lobe_entry *e, const lobe_vectors *v, uint32_t row)
{
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    int k;
    lobe_evaluate_row(e, v, row, in, out);
    lobe_port_print(" at");
    for (k = 0; k < e->inputs; k++) {
        lobe_port_print(" ");
        print_hex(in[k].bits, 8);
    }
    lobe_port_print(" got");
    for (k = 0; k < e->outputs; k++) {
        lobe_port_print(" ");
        print_hex(out[k].bits, 8);
    }
}

static int report_vectors(const lobe_vectors *v)
{
    const lobe_entry *e = lobe_find_entry(v->model, v->tier, v->format);
    lobe_verdict verdict;
    const lobe_part *part;
    uint32_t passed;
    print_name("vectors", v->model, v->tier, v->format);
    if (!e || e->inputs != v->inputs || lobe_truth_count(e) != v->outputs) {
        lobe_port_print("has no function here BROKEN\n");
        return 1;
    }
    verdict = lobe_judge(e, v);
    passed = verdict.inside.passed + verdict.below.passed;
    part = verdict.inside.rows == 0 || verdict.below.passed < verdict.below.rows ? &verdict.below : &verdict.inside;
    lobe_port_print("rows ");
    print_count(v->rows);
    lobe_port_print(" passed ");
    print_count(passed);
    lobe_port_print(" worst ");
    print_error(part->worst);
    print_case(e, v, part->row);
    lobe_port_print(passed == v->rows ? " ok\n" : " BROKEN\n");
    return passed != v->rows;
}

static int report_hash(const lobe_entry *e)
{
    const uint64_t hash = lobe_hash_entry(e, LOBE_HASH_COUNT);
    const char *verdict = " unknown\n";
    int failed = 1;
    size_t i;
    for (i = 0; i < lobe_embedded_hash_count; i++) {
        const lobe_known_hash *known = &lobe_embedded_hashes[i];
        if (known->format == e->format && lobe_same(known->model, e->model) && lobe_same(known->tier, e->tier)) {
            failed = known->hash != hash;
            verdict = failed ? " differs\n" : " ok\n";
        }
    }
    print_name("hash", e->model, e->tier, e->format);
    print_hex(hash, 16);
    lobe_port_print(verdict);
    return failed;
}

int lobe_conform_report(int hashes)
{
    int failed = 0;
    size_t i;
    for (i = 0; i < lobe_embedded_count; i++)
        failed |= report_vectors(&lobe_embedded[i]);
    for (i = 0; hashes && i < lobe_entry_count; i++)
        failed |= report_hash(&lobe_entries[i]);
    lobe_port_print(failed ? "conform: BROKEN\n" : "conform: ok\n");
    return failed;
}
