/* What a split-sum kernel returns: reflectance is f0 * scale + f90 * bias. */
#ifndef LOBE_DFG_H
#define LOBE_DFG_H
#include "../core/scalar.h"

LOBE_STRUCT(lobe_dfg)
{
    lobe_real scale;
    lobe_real bias;
};

#endif
