# Lobe. `make` builds the library and proves it on this host; it needs a C compiler and make.
# Each room keeps its own rules: models/models.mk, harness/harness.mk, cases/cases.mk, ...

CC      ?= cc
CXX     ?= c++
AR      ?= ar
OPT     ?= -O2
WARN    := -Wall -Wextra -Wconversion $(if $(WERROR),-Werror)
# Identical bits everywhere: no contraction, no excess precision (gnu99, not c99: s390x), no errno. Without
# -fno-trapping-math gcc does not vectorise a minimum; it changes no bit.
EXACT   := -std=gnu99 -ffp-contract=off -fno-math-errno -fno-trapping-math
CFLAGS  ?= $(OPT)
ALL_CFLAGS = $(EXACT) $(WARN) $(CFLAGS)
B       := build

PREFIX  ?= /usr/local
DESTDIR ?=

# What matters here is the table at the end; make V=1 shows the commands.
ifndef V
.SILENT:
endif

.DEFAULT_GOAL := all
.PHONY: all deps test fit conform chart stability install dist clean

TESTS :=

include models/models.mk
-include core/core.mk
-include harness/harness.mk
-include harness/ports/ports.mk
-include harness/chart/chart.mk
-include cases/cases.mk

# Everything beyond a C compiler and make. gcc-multilib must stay out: it removes the cross compilers.
PACKAGES := build-essential clang lld llvm clang-format libclang-rt-14-dev valgrind pkg-config \
    libcmocka-dev libnlopt-dev libcminpack-dev liblbfgs-dev gnuplot-nox \
    pocl-opencl-icd ocl-icd-opencl-dev opencl-c-headers clinfo \
    glslang-tools spirv-tools spirv-cross mesa-vulkan-drivers libvulkan-dev \
    gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross \
    gcc-i686-linux-gnu libc6-dev-i386-cross qemu-user-static \
    gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm

AS_ROOT := $(if $(filter 0,$(shell id -u)),,sudo)
deps:
	$(AS_ROOT) apt-get update -q
	$(AS_ROOT) env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $(PACKAGES)

clean:
	rm -rf $(B)
