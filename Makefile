# Lobe. `make` builds the library and proves it on this host; it needs a C compiler and make.
# Each room keeps its own rules: models/models.mk, harness/harness.mk, cases/cases.mk, ...

CC      ?= cc
CXX     ?= c++
AR      ?= ar
OPT     ?= -O2
WARN    := -Wall -Wextra -Wconversion $(if $(WERROR),-Werror)
# Identical bits everywhere: no contraction, no excess precision (gnu99, not c99: s390x), no errno.
EXACT   := -std=gnu99 -ffp-contract=off -fno-math-errno
CFLAGS  ?= $(OPT)
ALL_CFLAGS = $(EXACT) $(WARN) $(CFLAGS)
B       := build

PREFIX  ?= /usr/local
DESTDIR ?=

.DEFAULT_GOAL := all
.PHONY: all deps test fit conform chart stability install dist clean

TESTS :=

include models/models.mk
-include core/core.mk
-include harness/harness.mk
-include harness/ports/ports.mk
-include harness/chart/chart.mk
-include cases/cases.mk

clean:
	rm -rf $(B)
