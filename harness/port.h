/* What a new target has to provide, and all of it: two functions in one small file. Compile that with
 * conform.c, conform_report.c, conform_core.c, hash.c, registry.c, the arrays that embed_vectors wrote, and
 * the library. port_stdio.c is the file for a target that has stdio. */
#ifndef LOBE_PORT_H
#define LOBE_PORT_H

/* Shows the text, which ends lines itself. */
void lobe_port_print(const char *text);

/* Ends the program with the status where the target knows one. Does not return. */
void lobe_port_exit(int status);

#endif
