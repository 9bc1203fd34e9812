#include "bound_header.h"
#include <math.h>
#include <stdlib.h>
#include "coefficients.h"

double lobe_rounded_up(double x)
{
    char text[40];
    double unit;
    if (!(x > 0))
        return 0;
    unit = pow(10, floor(log10(x)) - 2);
    snprintf(text, sizeof text, "%.2e", ceil(x / unit * (1 - 1e-12)) * unit);
    return atof(text);
}

void lobe_put_bound(FILE *f, const char *model, const char *tier, const char *format, const char *suffix, double x)
{
    fputs("#define LOBE_", f);
    lobe_put_upper(f, model);
    fputc('_', f);
    lobe_put_upper(f, tier);
    if (format) {
        fputc('_', f);
        lobe_put_upper(f, format);
    }
    fprintf(f, "_%s %.3g\n", suffix, x);
}
