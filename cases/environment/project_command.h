/* `lobefit project FILE ...`; argv starts at FILE. Returns the exit status. */
#ifndef LOBE_ENVIRONMENT_PROJECT_COMMAND_H
#define LOBE_ENVIRONMENT_PROJECT_COMMAND_H

int lobe_project_command(int argc, char **argv);

#endif
