/* libFuzzer on the readers of maps: any bytes give a map whose projection is finite, or a refusal whose offset lies in
 * the file and which says what was found and expected. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../environment/project.h"
#include "../environment/sun.h"
#include "../environment/window.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void use(lobe_environment *map)
{
    lobe_sun sun;
    double sh[3][9];
    lobe_environment_take_sun(map, LOBE_SUN_SHARE, &sun);
    if (!lobe_environment_project(map, sh))
        return;
    lobe_sh9_window_positive(sh);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 9; k++)
            if (!isfinite(sh[c][k]))
                abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    lobe_environment map;
    lobe_environment_fault fault = {(size_t)-1, ""};
    if (lobe_environment_parse(data, size, &map, &fault)) {
        /* A texel's size does not matter to the projection, so the large maps are only read. */
        if ((long)map.width * map.height <= 1 << 12)
            use(&map);
        lobe_environment_free(&map);
    } else if (fault.offset > size || !strstr(fault.reason, "found") || !strstr(fault.reason, "expected")) {
        abort();
    }
    return 0;
}
