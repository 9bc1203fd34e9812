#include "port.h"
#include <stdio.h>
#include <stdlib.h>

void lobe_port_print(const char *text) { fputs(text, stdout); }

void lobe_port_exit(int status) { exit(status); }
