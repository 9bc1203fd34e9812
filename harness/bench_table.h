/* The yardstick of the benchmark: what an engine's CPU path does with a 64 x 64 split-sum table. */
#ifndef LOBE_BENCH_TABLE_H
#define LOBE_BENCH_TABLE_H
#include "registry.h"

/* Bilinear in roughness and NdotV as they come, texel centres, edges clamped; two floats a texel. It has none of the
 * warps of our own table tiers, so it is cheaper, and wrong by about .01. Only its array function is there. */
extern const lobe_entry lobe_bench_table64;

#endif
