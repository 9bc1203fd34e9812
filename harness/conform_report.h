/* Runs the embedded vectors and the hashes, and reports in words that need no printf. */
#ifndef LOBE_CONFORM_REPORT_H
#define LOBE_CONFORM_REPORT_H
#include <stdint.h>

/* A line a set of vectors:
 *   vectors MODEL TIER FORMAT rows N passed N worst 0.123456789 at HEX.. got HEX.. ok|BROKEN
 * then, where hashes is 1, a line an entry:
 *   hash MODEL TIER FORMAT HEX ok|differs|unknown
 * and last `conform: ok` or `conform: BROKEN`. Returns 0 or 1. hashes takes 100,000 evaluations an entry. */
int lobe_conform_report(int hashes);

#endif
