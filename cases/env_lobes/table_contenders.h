/* The tables that ship, to be judged like their closed forms (contenders.h). */
#ifndef LOBE_ENV_TABLE_CONTENDERS_H
#define LOBE_ENV_TABLE_CONTENDERS_H
#include "judge.h"

enum { LOBE_TABLE_CONTENDERS = 4 };
extern const lobe_judge_model lobe_table_contender[LOBE_TABLE_CONTENDERS];

#endif
