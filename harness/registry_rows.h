/* The rows of the registry, read several times with other meanings of DFG_F32 and its siblings.
 * A new tier is a line here, and its coefficient header included in registry.c.
 *   columns: model, tier, prefix of the bounds in the coefficient header
 *   DFG_F32, DFG_Q30: scale and bias, with an array version; DFG_Q30_SCALAR: without
 *   ENERGY_F32, ENERGY_Q30: E */
DFG_F32(split_sum, low, LOBE_SPLIT_SUM_LOW)
DFG_Q30(split_sum, low, LOBE_SPLIT_SUM_LOW)
