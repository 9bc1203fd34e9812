# Conformance on every target, instruction counts, drop-ins and installation.
#
#   make conform    a row a target; fails when one fails, and with LOBE_REQUIRE_ALL=1 when one is not installed
#   make counts     build/counts_{x86,m0,m4f}.csv: model,tier,format,instructions
#   make dist       build/dist: the drop-in for C (lobe.h, lobe.c) and the one for shaders (lobe.shader.h)
#   make install    PREFIX, DESTDIR
# A new target is a name in TARGETS with its compiler, flags and runner.

DIST ?= $(B)/dist
PORT := $(B)/ports

PORT_WARN  := -Wall -Wextra -Werror
PORT_SRC   := $(LIB_SRC) $(CONFORM_SRC)
EMBEDDED   := $(B)/embedded.c
MAIN_SRC   := harness/conform.c harness/conform_report.c
HOST_PORT  := harness/port_stdio.c
CHIP_PORT  := harness/ports/cortex_m/start.c
CHIP_FLAGS := -mthumb -O2 -ffunction-sections -fdata-sections -Wl,--gc-sections -nostartfiles \
              -T harness/ports/cortex_m/mps2.ld
CHIP_RUN   := qemu-system-arm -nographic -monitor none -serial none -semihosting-config enable=on,target=native

HOSTED     := x86-64-gcc-O0 x86-64-gcc-O2 x86-64-gcc-O3-native x86-64-clang-O0 x86-64-clang-O2 \
              x86-64-clang-O3-native aarch64 s390x i686
CHIPS      := cortex-m0 cortex-m4f
DEVICES    := opencl vulkan
TARGETS    := $(HOSTED) $(CHIPS) $(DEVICES)

CC_x86-64-gcc-O0          := gcc -O0
CC_x86-64-gcc-O2          := gcc -O2
CC_x86-64-gcc-O3-native   := gcc -O3 -march=native
CC_x86-64-clang-O0        := clang -O0
CC_x86-64-clang-O2        := clang -O2
CC_x86-64-clang-O3-native := clang -O3 -march=native
CC_aarch64                := aarch64-linux-gnu-gcc -O2 -static
RUN_aarch64               := qemu-aarch64-static
CC_s390x                  := s390x-linux-gnu-gcc -O2 -static
RUN_s390x                 := qemu-s390x-static
CC_i686                   := i686-linux-gnu-gcc -O2 -msse2 -mfpmath=sse -static
RUN_i686                  := qemu-i386-static
# ARMv6-M code on the board with a Cortex-M3, which has room for the vectors and runs it unchanged.
CC_cortex-m0              := arm-none-eabi-gcc -mcpu=cortex-m0 -mfloat-abi=soft $(CHIP_FLAGS)
RUN_cortex-m0             := $(CHIP_RUN) -M mps2-an385 -kernel
CC_cortex-m4f             := arm-none-eabi-gcc -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard $(CHIP_FLAGS)
RUN_cortex-m4f            := $(CHIP_RUN) -M mps2-an386 -kernel
CC_opencl                 := gcc -O2
CC_vulkan                 := gcc -O2

$(HOSTED:%=$(PORT)/%.row): PORT_MAIN = $(MAIN_SRC) $(HOST_PORT)
$(CHIPS:%=$(PORT)/%.row):  PORT_MAIN = $(MAIN_SRC) $(CHIP_PORT)
$(PORT)/opencl.row: PORT_MAIN = harness/ports/device_main.c harness/ports/opencl_compute.c
$(PORT)/vulkan.row: PORT_MAIN = harness/ports/device_main.c harness/ports/vulkan_compute.c
$(PORT)/opencl.row: PORT_LIBS = -lOpenCL
$(PORT)/vulkan.row: PORT_LIBS = -lvulkan
$(PORT)/opencl.row $(PORT)/vulkan.row: $(DIST)/lobe.shader.h
$(PORT)/opencl.row $(PORT)/vulkan.row: export PROGRAM_ARGUMENTS = $(basename $@)
$(PORT)/opencl.row: export NEEDS = header:CL/cl.h
$(PORT)/vulkan.row: export NEEDS = header:vulkan/vulkan.h glslangValidator
$(PORT)/opencl.row: export POCL_CACHE_DIR = $(abspath $(PORT)/pocl)
$(PORT)/opencl.row: export PREPARE = mkdir -p $(POCL_CACHE_DIR) && sh harness/ports/device_kernels.sh \
    $(basename $@) $(DIST)/lobe.shader.h cl $(wildcard core/*.h models/*.h)
$(PORT)/vulkan.row: export PREPARE = sh harness/ports/device_kernels.sh \
    $(basename $@) $(DIST)/lobe.shader.h glsl $(wildcard core/*.h models/*.h)

.PHONY: conform counts counts-x86 counts-m0 counts-m4f FORCE
FORCE:

# A count that cannot be had is a dash in its column; the verdicts stand by themselves.
conform: $(TARGETS:%=$(PORT)/%.row)
	-@$(MAKE) --no-print-directory -k counts
	@sh harness/ports/conform.sh table $(B) $(TARGETS:%=$(PORT)/%.row)

$(PORT)/%.row: $(EMBEDDED) FORCE
	@sh harness/ports/conform.sh target $@ '$(CC_$*)' '$(RUN_$*)' \
	    $(EXACT) $(PORT_WARN) -Iharness $(PORT_MAIN) $(PORT_SRC) $(EMBEDDED) $(PORT_LIBS)

# Counting. Published formulas are counted beside the registry, wherever harness/peers/ declares one.
COUNT_SRC := harness/ports/count.c harness/registry.c $(LIB_SRC)
PEER_HDR  := $(wildcard harness/peers/*.h)

counts: counts-x86 counts-m0 counts-m4f
	@ls $(B)/counts_*.csv

$(PORT)/peer_rows.h: $(PEER_HDR)
	@mkdir -p $(@D)
	@sed -n -e 's/^LOBE_FN lobe_dfg peer_\([a-z0-9_]*\)(lobe_real r, lobe_real v)$$/PEER_DFG(\1)/p' \
	    -e 's/^LOBE_FN lobe_real peer_\([a-z0-9_]*\)(lobe_real r, lobe_real v)$$/PEER_ENERGY(\1)/p' \
	    -e 's/^LOBE_FN lobe_sh9 peer_\([a-z0-9_]*\)(lobe_real r, lobe_real v)$$/PEER_SH9(\1)/p' \
	    $(PEER_HDR) >$@

COUNT_ARGS = $(EXACT) $(PORT_WARN) -I$(PORT) $(if $(PEER_HDR),-DLOBE_PEERS) $(COUNT_SRC)

counts-x86: $(PORT)/peer_rows.h
	@sh harness/ports/count.sh callgrind $(B)/counts_x86.csv 'gcc -O2' 'valgrind --tool=callgrind' \
	    $(COUNT_ARGS) harness/ports/counter_none.c $(HOST_PORT)

counts-m0: $(PORT)/peer_rows.h
	@sh harness/ports/count.sh chip $(B)/counts_m0.csv '$(CC_cortex-m0)' \
	    '$(subst -kernel,-icount shift=6 -kernel,$(RUN_cortex-m0))' $(COUNT_ARGS) harness/ports/cortex_m/counter.c $(CHIP_PORT)

counts-m4f: $(PORT)/peer_rows.h
	@sh harness/ports/count.sh chip $(B)/counts_m4f.csv '$(CC_cortex-m4f)' \
	    '$(subst -kernel,-icount shift=6 -kernel,$(RUN_cortex-m4f))' $(COUNT_ARGS) harness/ports/cortex_m/counter.c $(CHIP_PORT)

include harness/dist/dist.mk
