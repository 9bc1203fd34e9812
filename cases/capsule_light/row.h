/* A row of this case as the runtime's input. For a file that has LOBE_DOUBLE defined. */
#ifndef LOBE_CAPSULE_LIGHT_ROW_H
#define LOBE_CAPSULE_LIGHT_ROW_H
#include "../../models/capsule_light.h"

static inline lobe_capsule lobe_capsule_of_row(const double *row)
{
    return lobe_capsule_of(row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]);
}

#endif
