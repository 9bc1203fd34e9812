/* `lobefit search env_lobes [--fresnel | --shape] --csv FILE`: every tier, the split sum and stars on environments that
 * no fit has seen; what Schlick's Fresnel adds; what fits of the shape alone give. */
#ifndef LOBE_ENV_FRONT_H
#define LOBE_ENV_FRONT_H
#include <stdio.h>
#include "../case.h"
#include "held.h"

/* A lobe_command_fn. */
int lobe_env_lobes_search(const lobe_case *self, int argc, char **argv);

/* Its tables. False after a line on stderr. */
bool lobe_front_write(const lobe_held *held, int threads, FILE *out);
bool lobe_fresnel_front_write(const lobe_held *held, int threads, FILE *out);
bool lobe_shape_front_write(const lobe_held *held, int threads, FILE *out);

#endif
