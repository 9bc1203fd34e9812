#!/bin/sh
# Prints the headers of core/ and models/ that are written in the dialect: those that reach core/dialect.h.
# Usage: shader_headers.sh CC      (from the root of the repository)
for h in core/dialect.h core/*.h models/*.h; do
    # The preprocessor follows the includes; -MM names what it opened, -MG what is not there yet.
    if "$1" -MM -MG -x c "$h" 2>/dev/null | tr ' ' '\n' | grep -q 'core/dialect\.h$'; then
        printf '%s\n' "$h"
    fi
done | awk '!seen[$0]++'
