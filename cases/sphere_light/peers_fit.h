/* The constants of the published forms, fitted to our cells by the metric that all are judged by: peers_fitted.h. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_FIT_H
#define LOBE_SPHERE_LIGHT_PEERS_FIT_H
#include <stdbool.h>
#include "../fit/sweep.h"

/* false after a line on stderr, the old file untouched. */
bool lobe_sphere_peers_fit(const lobe_sweep_options *options, const char *path);

#endif
