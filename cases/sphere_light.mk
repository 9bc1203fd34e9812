# Sphere and capsule lights: truth, fits, and the forms that were explored. The tests link what is no command.
SPHERE_LIGHT_COMMANDS := $(addprefix cases/sphere_light/,bounds.c fit.c fit_tiers.c front.c lit_fit.c lit_objective.c \
    lit_tiers.c ltc_fit.c measure.c objective.c peers_fit.c schlick_bounds.c \
    schlick_case.c shipped.c solve.c tiers.c)
SPHERE_LIGHT_SRC := $(filter-out $(SPHERE_LIGHT_COMMANDS),$(wildcard cases/sphere_light/*.c)) cases/fit/truth_cache.c
SPHERE_LIGHT_OBJ := $(SPHERE_LIGHT_SRC:%.c=$(B)/%.o) $(B)/cases/sphere_light/truth_source.o
FIT_OBJ += $(SPHERE_LIGHT_OBJ) $(SPHERE_LIGHT_COMMANDS:%.c=$(B)/%.o)

# Operations of the published forms, from their texts.
FIT_OBJ += $(if $(EMIT_OBJ),$(B)/cases/sphere_light/operations.o)
$(B)/cases/sphere_light/operations.o: cases/sphere_light/operations.cpp $(EMIT_HDR) $(wildcard cases/sphere_light/*.h)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

# Every form against the truth on its cells: half a minute on two processors, and a committed result.
.PHONY: sphere-light-front
sphere-light-front: $(B)/lobefit
	$< search sphere_light --csv cases/sphere_light/front.csv

# What is fitted of the published forms, before the front: the constants in half a minute, and the table of linearly
# transformed cosines in less.
.PHONY: sphere-light-peers ltc
sphere-light-peers: $(B)/lobefit
	$< search sphere_light --peers cases/sphere_light/peers_fitted.h
ltc: $(B)/lobefit
	$< search sphere_light --ltc cases/sphere_light/ltc_table.h

SPHERE_LIGHT_TESTS := $(B)/test/test_sphere_light $(B)/test/test_sphere_peers
TESTS += $(SPHERE_LIGHT_TESTS) cases/test/test_sphere_again.sh
$(SPHERE_LIGHT_TESTS): $(B)/test/%: cases/test/%.c $(SPHERE_LIGHT_OBJ) $(TRUTH_OBJ) \
                             $(B)/cases/fit/atomic_file.o $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o,$^) $(LOBEFIT_LIBS) -lcmocka -o $@

$(B)/cases/sphere_light/truth_source.c: cases/embed.awk core/dialect.h cases/sphere_light/truth_stretched.h \
                                        cases/sphere_light/truth_rows.cl
	@mkdir -p $(@D)
	awk -v name=lobe_truth_sphere_source -v prefix="#define LOBE_DOUBLE 1" -f $^ > $@.new
	mv $@.new $@

$(B)/cases/sphere_light/truth_source.o: $(B)/cases/sphere_light/truth_source.c
	$(CC) $(CASES_CFLAGS) -Wno-overlength-strings -c $< -o $@

TESTS += $(B)/test/test_sphere_light_opencl
$(B)/test/test_sphere_light_opencl: cases/test/test_sphere_light_opencl.c $(SPHERE_LIGHT_OBJ) $(TRUTH_OBJ) \
                                    $(B)/cases/fit/atomic_file.o $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o,$^) $(LOBEFIT_LIBS) -lcmocka -o $@

SPHERE_FIT_TESTS := test_sphere_floors test_sphere_schlick_floors test_sphere_fit
TESTS += $(SPHERE_FIT_TESTS:%=$(B)/test/%)
$(SPHERE_FIT_TESTS:%=$(B)/test/%): $(B)/test/%: cases/test/%.c $(SPHERE_LIGHT_OBJ) $(TRUTH_OBJ) \
    $(addprefix $(B)/cases/sphere_light/,fit_tiers.o lit_objective.o lit_tiers.o objective.o shipped.o) $(B)/liblobe.a $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o %.a,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
