/* libFuzzer on the readers of cubes: any bytes give a cube of finite texels, or a refusal whose offset lies in the file
 * and which says what was found and expected. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../prefilter/cube_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    lobe_cube cube;
    lobe_environment_fault fault = {(size_t)-1, ""};
    if (lobe_cube_parse(data, size, &cube, &fault)) {
        for (int m = 0; m < cube.mips; m++)
            for (int i = 0; i < 18 * lobe_cube_side(cube.size, m) * lobe_cube_side(cube.size, m); i++)
                if (!isfinite(cube.rgb[m][i]))
                    abort();
        lobe_cube_free(&cube);
    } else if (fault.offset > size || !strstr(fault.reason, "found") || !strstr(fault.reason, "expected")) {
        abort();
    }
    return 0;
}
