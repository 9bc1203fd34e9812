/* What ships of these cases, read several times with other meanings of the macros. A new tier is a line here and one
 * in harness/registry_rows.h.
 *   columns: model, tier, prefix of the bounds in models/coeffs/MODEL_bounds.h */
DFG(split_sum, low, LOBE_SPLIT_SUM_LOW)
DFG(split_sum, medium, LOBE_SPLIT_SUM_MEDIUM)
DFG(split_sum, high, LOBE_SPLIT_SUM_HIGH)
DFG(split_sum, table32, LOBE_SPLIT_SUM_TABLE32)
DFG(split_sum, table64, LOBE_SPLIT_SUM_TABLE64)
DFG(split_sum, table128, LOBE_SPLIT_SUM_TABLE128)
DFG(split_sum_sep, low, LOBE_SPLIT_SUM_SEP_LOW)
DFG(split_sum_sep, medium, LOBE_SPLIT_SUM_SEP_MEDIUM)
DFG(split_sum_sep, high, LOBE_SPLIT_SUM_SEP_HIGH)
DFG(split_sum_sep, table32, LOBE_SPLIT_SUM_SEP_TABLE32)
DFG(split_sum_sep, table64, LOBE_SPLIT_SUM_SEP_TABLE64)
DFG(split_sum_sep, table128, LOBE_SPLIT_SUM_SEP_TABLE128)
ENERGY(energy, low, LOBE_ENERGY_LOW)
ENERGY(energy, medium, LOBE_ENERGY_MEDIUM)
ENERGY(energy, high, LOBE_ENERGY_HIGH)
