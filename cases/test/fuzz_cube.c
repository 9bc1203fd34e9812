/* libFuzzer on what `lobefit prefilter` reads: any bytes give a cube of finite texels, from a cube file or from six
 * faces in one picture, or a refusal whose offset lies in the file and which says what was found and expected. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../prefilter/cube_file.h"
#include "../prefilter/faces.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static int faces(const uint8_t *data, size_t size, lobe_cube *cube, lobe_environment_fault *fault)
{
    lobe_environment map;
    int good;
    if (!lobe_environment_parse(data, size, &map, fault))
        return 0;
    good = lobe_faces_take(&map, cube, fault);
    /* Every texel of a strip is a face's. */
    if (good && lobe_faces_of(map.width, map.height) < LOBE_FACES_WIDE &&
        6 * cube->size * cube->size != map.width * map.height)
        abort();
    lobe_environment_free(&map);
    return good;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    lobe_cube cube;
    lobe_environment_fault fault = {(size_t)-1, ""};
    if (lobe_cube_is_file(data, size) ? lobe_cube_parse(data, size, &cube, &fault) : faces(data, size, &cube, &fault)) {
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
