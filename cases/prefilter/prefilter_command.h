/* `lobefit prefilter FILE ...`; argv starts at FILE. Returns the exit status. */
#ifndef LOBE_PREFILTER_COMMAND_H
#define LOBE_PREFILTER_COMMAND_H

int lobe_prefilter_command(int argc, char **argv);

#endif
