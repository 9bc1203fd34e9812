# The offline side: lobefit and its tests. It needs a C compiler, POSIX threads and libm; OpenCL is loaded at run time
# where its headers were found at build time. cases/fit/*.mk add their objects to FIT_OBJ and EMIT_OBJ.
FIT_OBJ :=
EMIT_OBJ :=
LOBEFIT_LD = $(CC)
LOBEFIT_LIBS = -lm -lpthread -ldl
-include cases/fit/fit.mk
-include cases/fit/emit.mk
-include cases/fit_rules.mk
-include cases/environment.mk
-include cases/prefilter.mk
-include cases/picture/picture.mk

# The truth is worth -O3: its inner loop vectorises with the bits it has.
CASES_OPT ?= -O3
CASES_CFLAGS = $(ALL_CFLAGS) $(CASES_OPT) $(if $(EMIT_OBJ),-DLOBE_WITH_EMIT)
CASES_HDR := $(wildcard core/*.h models/*.h models/coeffs/*.h cases/*.h cases/*/*.h)

# What the truth and the tests need, and what only lobefit does: the table of cases and their fits.
TRUTH_SRC := $(wildcard cases/split_sum/truth_*.c cases/energy/truth_*.c cases/diffuse_sh/truth_*.c) \
             $(addprefix cases/fit/, digest.c opencl.c random.c rows.c sweep.c)
TRUTH_OBJ := $(TRUTH_SRC:%.c=$(B)/%.o) $(B)/cases/split_sum/truth_source.o
CASES_SRC := cases/cases.c cases/fit/vectors.c cases/split_sum/points.c cases/split_sum/tiers.c cases/energy/weight_vectors.c \
             $(addprefix cases/diffuse_sh/, points.c tiers.c closed_form.c metric.c shipped.c)
-include cases/sphere_light.mk
-include cases/sphere_diffuse.mk
-include cases/capsule_light.mk
-include cases/sphere_stability.mk
-include cases/sphere_story.mk
-include cases/env_lobes.mk
-include cases/sg_light.mk
-include cases/env_lobes_sg.mk
-include cases/picture/lights.mk
-include cases/picture/environments.mk
LOBEFIT_OBJ := $(sort $(CASES_SRC:%.c=$(B)/%.o) $(TRUTH_OBJ) $(FIT_OBJ) $(EMIT_OBJ))

$(B)/cases/%.o: cases/%.c $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) -c $< -o $@

$(B)/cases/split_sum/truth_source.c: cases/embed.awk core/dialect.h cases/split_sum/truth_split_sum.h \
                                     cases/split_sum/truth_kernel.h cases/split_sum/truth_rows.cl
	@mkdir -p $(@D)
	order=$$(awk '$$2 == "LOBE_TRUTH_ORDER" { print $$3 }' cases/split_sum/truth_split_sum.h) && \
	awk -v name=lobe_truth_source -v prefix="#define LOBE_DOUBLE 1;#define LOBE_TRUTH_ORDER $$order" \
	    -f cases/embed.awk core/dialect.h cases/split_sum/truth_kernel.h cases/split_sum/truth_rows.cl > $@.new
	mv $@.new $@

$(B)/cases/split_sum/truth_source.o: $(B)/cases/split_sum/truth_source.c
	$(CC) $(CASES_CFLAGS) -Wno-overlength-strings -c $< -o $@

$(B)/lobefit: $(B)/cases/lobefit.o $(LOBEFIT_OBJ) $(B)/liblobe.a
	$(LOBEFIT_LD) $(CFLAGS) $^ $(LOBEFIT_LIBS) -o $@

# Tests of the offline side.
TRUTH_TESTS := truth truth_agreement truth_opencl rows
TESTS += $(TRUTH_TESTS:%=$(B)/test/test_%) $(wildcard cases/test/test_lobefit*.sh)

$(TRUTH_TESTS:%=$(B)/test/test_%): $(B)/test/test_%: cases/test/test_%.c $(TRUTH_OBJ) $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $< $(TRUTH_OBJ) $(LOBEFIT_LIBS) -lcmocka -o $@

TESTS += $(B)/test/test_diffuse_sh_truth
$(B)/test/test_diffuse_sh_truth: cases/test/test_diffuse_sh.c cases/diffuse_sh/closed_form.c $(TRUTH_OBJ) $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $< cases/diffuse_sh/closed_form.c $(TRUTH_OBJ) $(LOBEFIT_LIBS) -lcmocka -o $@

# Shell tests call the program; make test builds it first.
test: $(B)/lobefit

# How closely the integrators agree, over dense grids: three minutes, and a committed result.
$(B)/truth_sweep: $(B)/cases/split_sum/agreement_main.o $(TRUTH_OBJ)
	$(CC) $(CFLAGS) $^ $(LOBEFIT_LIBS) -o $@

.PHONY: truth-sweep
truth-sweep: $(B)/truth_sweep
	$< $$(date -u +%F) > $(B)/agreement.txt
	mv $(B)/agreement.txt cases/split_sum/agreement.txt

# libFuzzer on the row parser; needs clang.
$(B)/fuzz_rows: cases/test/fuzz_rows.c cases/fit/rows.c cases/fit/rows.h
	clang -g -O1 -fsanitize=fuzzer,address,undefined $(EXACT) cases/test/fuzz_rows.c cases/fit/rows.c -o $@
