/* lobefit search capsule_light: what ships and what is published, judged against the truth on the held-out cells. */
#ifndef LOBE_CAPSULE_LIGHT_FRONT_H
#define LOBE_CAPSULE_LIGHT_FRONT_H
#include "../case.h"

/* --csv FILE, stdout if left out; --threads N; --progress. */
int lobe_capsule_front_search(const lobe_case *self, int argc, char **argv);

#endif
