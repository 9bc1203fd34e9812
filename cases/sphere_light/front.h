/* lobefit search sphere_light: the explored forms and the published ones, judged against the truth. */
#ifndef LOBE_SPHERE_LIGHT_FRONT_H
#define LOBE_SPHERE_LIGHT_FRONT_H
#include "../case.h"

/* --csv FILE, stdout if left out; --threads N; --progress. */
int lobe_sphere_front_search(const lobe_case *self, int argc, char **argv);

#endif
