/* Environments that no fit has seen: rooms by seeds that training.c does not use, and measured maps from files. */
#ifndef LOBE_ENV_HELD_H
#define LOBE_ENV_HELD_H
#include <stdbool.h>
#include "../environment/environment.h"

enum { LOBE_HELD_FILES = 8 };

typedef struct lobe_held {
    const char *files[LOBE_HELD_FILES]; /* averaged down to 256 columns, which must divide theirs */
    int file_count;
} lobe_held;

/* dark: judge.h. */
typedef bool lobe_held_fn(void *ctx, const char *name, const lobe_environment *map, double dark);

/* Those that count in means, the rooms first; ends at the first false. A file that does not do is told on stderr. */
bool lobe_held_each(const lobe_held *held, lobe_held_fn *f, void *ctx);
int lobe_held_count(const lobe_held *held);

/* The one that does not: a single bright texel. Where it is under the horizon the truth is next to 0, so that relative
 * errors need a floor, dark is not 0, and no mean with the others makes sense. */
bool lobe_held_texel(lobe_held_fn *f, void *ctx);

#endif
