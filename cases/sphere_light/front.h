/* lobefit search sphere_light: the published forms and ours, judged against the truth. */
#ifndef LOBE_SPHERE_LIGHT_FRONT_H
#define LOBE_SPHERE_LIGHT_FRONT_H
#include "../case.h"

/* --threads N; --progress; and where to write what is asked for:
 *   --csv FILE    the judgement of every form; standard output if nothing is asked for
 *   --cells FILE  the held-out cells themselves, for who judges what ships
 *   --peers FILE  the fitted constants of the published forms, peers_fitted.h
 *   --ltc FILE    the fitted table of linearly transformed cosines, ltc_table.h */
int lobe_sphere_front_search(const lobe_case *self, int argc, char **argv);

#endif
