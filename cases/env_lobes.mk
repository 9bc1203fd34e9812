# Environment specular by taps into a prefiltered map: truth, fit, front.
ENV_LOBES_SRC := $(wildcard cases/env_lobes/*.c)
ENV_LOBES_OBJ := $(ENV_LOBES_SRC:%.c=$(B)/%.o)
FIT_OBJ += $(ENV_LOBES_OBJ) $(B)/cases/environment/sky.o

# Operations of the kernels, from their texts.
FIT_OBJ += $(if $(EMIT_OBJ),$(B)/cases/env_lobes/operations.o)
$(B)/cases/env_lobes/operations.o: cases/env_lobes/operations.cpp $(EMIT_HDR) $(wildcard cases/env_lobes/*.h)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

# Every tier and the split sum on environments that no fit has seen, and on the maps that are there: a minute on two
# processors, and a committed result.
.PHONY: env-lobes-front
env-lobes-front: $(B)/lobefit
	$< search env_lobes $(ENVIRONMENTS:%=--map %) --csv cases/env_lobes/front.csv

# What Schlick's Fresnel adds to them: half a minute.
.PHONY: env-lobes-fresnel
env-lobes-fresnel: $(B)/lobefit
	$< search env_lobes --fresnel $(ENVIRONMENTS:%=--map %) --csv cases/env_lobes/fresnel.csv

# Fits of the shape alone, held against what ships.
.PHONY: env-lobes-shape
env-lobes-shape: $(B)/lobefit
	$< search env_lobes --shape $(ENVIRONMENTS:%=--map %) --csv cases/env_lobes/shape.csv

ENV_LOBES_TESTS := test_env_lobes_truth test_env_lobes_samplers test_env_lobes_fit test_env_lobes_table_fit
TESTS += $(ENV_LOBES_TESTS:%=$(B)/test/%)
$(ENV_LOBES_TESTS:%=$(B)/test/%): $(B)/test/%: cases/test/%.c $(TRUTH_OBJ) $(OPTIMISER_OBJ) $(CASES_HDR) \
    $(filter-out %/bounds.o %/fit.o %/front.o %/held.o %_front.o %_command.o %_tier.o %_write.o %_shipped.o,$(ENV_LOBES_OBJ)) $(addprefix $(B)/cases/environment/,environment.o sky.o) \
    $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(sort $(filter %.c %.o,$^)) $(filter %.a,$^) $(LOBEFIT_LIBS) -lcmocka -o $@

TESTS += $(if $(EMIT_OBJ),$(B)/test/test_env_operations)
$(B)/test/test_env_operations: cases/test/test_env_operations.c $(B)/cases/env_lobes/operations.o $(B)/cases/fit/trace.o \
    $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o,$^) -lm -o $@
