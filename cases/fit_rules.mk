# Fits, what they write, and the measurement of what ships.
RULES_SRC := $(wildcard cases/energy/fit*.c cases/split_sum/table_*.c cases/split_sum/fit*.c cases/split_sum/form*.c cases/split_sum/front.c \
    cases/split_sum/shipped.c $(addprefix cases/diffuse_sh/,bounds.c constants.c fit.c)) $(addprefix cases/fit/,bound_header.c bounds.c coefficients.c fit_command.c fit_grid.c judge_points.c measure.c truth_cache.c)
FIT_OBJ += $(RULES_SRC:%.c=$(B)/%.o)

# Stand-ins for generated headers, for a new tier or another count of coefficients: see cases/fit/blank_main.c.
$(B)/blank: $(addprefix $(B)/cases/fit/,blank_main.o coefficients.o atomic_file.o digest.o)
	$(CC) $(CFLAGS) $^ -o $@

# Every coefficient, table, integer kernel, bound, vector and hash anew, with the bytes that are committed. What a step
# writes is compiled into the program that runs the next, hence a make a step.
#
# A new closed-form tier is: a kernel in models/MODEL.h; build/blank coeffs models/coeffs MODEL TIER COUNT; a line in
# the case's list of fits; models/f32/MODEL_TIER.c. Then lobefit fit and make emit-q30, and when both are there a line
# in cases/split_sum/tier_rows.h and in harness/registry_rows.h, build/blank bounds, and make fit. A tier of a sphere
# light has its line of fits in cases/sphere_light/fit_tiers.c and fit.c, its integers by hand, its row in
# cases/sphere_light/tier_rows.h; one of environment lobes its row in cases/env_lobes/tier_rows.h.
FIT_MODELS := split_sum split_sum_sep energy diffuse_sh sphere_light capsule_light sg_light sg_diffuse sphere_diffuse \
    env_lobes env_lobes_sg
# What is fitted with another, and measured by itself; it takes longest, so it begins.
MEASURED_MODELS := sphere_light_schlick $(FIT_MODELS)
MEASURES := $(MEASURED_MODELS:%=measure-%)
LOBEFIT_AGAIN = $(MAKE) --no-print-directory $(B)/lobefit
# Fits take all processors; measurements take one each, so as many run at once as there are.
AT_ONCE = -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
.PHONY: fit $(MEASURES)
$(MEASURES): measure-%:
	@echo "lobefit bounds $*"; $(B)/lobefit bounds $*

fit:
	@set -e; $(LOBEFIT_AGAIN); \
	for model in $(FIT_MODELS); do echo "lobefit fit $$model"; $(B)/lobefit fit $$model; done; \
	$(MAKE) --no-print-directory emit-q30; $(LOBEFIT_AGAIN); \
	$(MAKE) --no-print-directory $(AT_ONCE) $(MEASURES); \
	$(LOBEFIT_AGAIN); \
	for model in $(MEASURED_MODELS); do echo "lobefit vectors $$model"; $(B)/lobefit vectors $$model; done; \
	$(MAKE) --no-print-directory hashes

TESTS += cases/test/test_regenerate.sh

# Any BRDF that is one kernel: make project-brdf BRDF=path/to/my.h builds build/project_my, which projects and fits
# lobe_brdf_my (or BRDF_NAME=its_name). See cases/diffuse_sh/project_brdf.c.
BRDF ?= cases/diffuse_sh/brdf/eon.h
BRDF_KEY = $(basename $(notdir $(BRDF)))
BRDF_NAME ?= lobe_brdf_$(BRDF_KEY)
.PHONY: project-brdf
project-brdf: $(B)/project_$(BRDF_KEY)
	@echo "$< truth ROUGHNESS NDOTV | table | fit DEGREE NAME"

PROJECT_BRDF = @mkdir -p $(@D); \
	$(CC) $(ALL_CFLAGS) -I. -DLOBE_BRDF_HEADER='"$(abspath $(1))"' -DLOBE_BRDF=$(2) cases/diffuse_sh/project_brdf.c \
	    cases/diffuse_sh/truth_diffuse.c -o $@ -lm
PROJECT_NEEDS := $(addprefix cases/diffuse_sh/,project_brdf.c truth_diffuse.c truth_diffuse.h) $(CORE_HDR)

# Those that come with it, for the test; then the one that was asked for, if it is another.
BRDFS := $(basename $(notdir $(wildcard cases/diffuse_sh/brdf/*.h)))
$(BRDFS:%=$(B)/project_%): $(B)/project_%: cases/diffuse_sh/brdf/%.h $(PROJECT_NEEDS)
	$(call PROJECT_BRDF,$<,lobe_brdf_$*)
ifeq ($(filter $(BRDF_KEY),$(BRDFS)),)
$(B)/project_$(BRDF_KEY): $(BRDF) $(PROJECT_NEEDS)
	$(call PROJECT_BRDF,$(BRDF),$(BRDF_NAME))
endif
TEST_NEEDS += $(BRDFS:%=$(B)/project_%)
TESTS += cases/test/test_project_brdf.sh

# The explored front of cost against error, refitted from scratch: two minutes, and committed results.
.PHONY: front
front: $(B)/lobefit
	$< search split_sum --csv cases/split_sum/front_corr.csv
	$< search split_sum_sep --csv cases/split_sum/front_sep.csv
