/* lobefit search sg_light: the published forms and ours, judged against the truth. */
#ifndef LOBE_SG_LIGHT_FRONT_H
#define LOBE_SG_LIGHT_FRONT_H
#include "../case.h"

/* --threads N; --progress; --csv FILE writes there instead of to standard output; --ndf FILE writes the
 * normals as sums of Gaussians (ndf.h). */
int lobe_sg_front_search(const lobe_case *self, int argc, char **argv);

#endif
