/* lobefit emit for the formulas of emit_kernels.h. Usage: emit_try TIER LANGUAGE */
#include <stdio.h>

#include "../fit/emit.h"

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: emit_try TIER LANGUAGE\n");
        return 2;
    }
    return lobe_emit("try", argv[1], argv[2], stdout);
}
