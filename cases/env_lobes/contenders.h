/* What is judged: the tiers that ship, the split sum, and stars. */
#ifndef LOBE_ENV_CONTENDERS_H
#define LOBE_ENV_CONTENDERS_H
#include "judge.h"

/* The split sum; with dominant-direction shift (Lagarde and de Rousiers, "Moving Frostbite to Physically Based
 * Rendering", 2014, listing 21); the tiers. The first is what the others are a part of. */
enum { LOBE_CONTENDERS = 6 };
extern const lobe_judge_model lobe_contender[LOBE_CONTENDERS];

#endif
