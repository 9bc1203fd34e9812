/* The commands of lobecheck. Each takes the arguments after its name and returns the exit status:
 * 0 all good, 1 a check failed, 2 bad usage or input. */
#ifndef LOBE_COMMAND_H
#define LOBE_COMMAND_H
#include "registry.h"

int lobe_command_list(int argc, char **argv);
int lobe_command_run(int argc, char **argv);
int lobe_command_eval(int argc, char **argv);
int lobe_command_hash(int argc, char **argv);
int lobe_command_bench(int argc, char **argv);

/* Says what is wrong with a name, and what is allowed in its place, on standard error; returns 2. Checks
 * model, then tier of that model (NULL: not given), then format; 0 where all are known. */
int lobe_refuse_names(const char *model, const char *tier, const char *format);

/* The domain as text without blanks, at most size bytes: "[0.02,1]" where it is the same for every input, else one an
 * input, with an x between. Returns text. */
const char *lobe_domain_text(const lobe_entry *entry, char *text, size_t size);

/* The value of `--name VALUE` or `--name=VALUE` at argv[*i]; moves *i onto the value. NULL: another argument. */
const char *lobe_option(int argc, char **argv, int *i, const char *name);

#endif
