#include "environment.h"
#include <stdarg.h>
#include <stdio.h>

int lobe_environment_refuse(lobe_environment_fault *fault, size_t offset, const char *format, ...)
{
    va_list args;
    fault->offset = offset;
    va_start(args, format);
    vsnprintf(fault->reason, sizeof fault->reason, format, args);
    va_end(args);
    return 0;
}
