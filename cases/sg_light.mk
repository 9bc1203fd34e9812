# Lights that are spherical Gaussians: truth, fit, front. The sphere beneath and the quadrature are sphere_light's.
SG_LIGHT_COMMANDS := $(addprefix cases/sg_light/,bounds.c diffuse_bounds.c fit.c fit_diffuse.c fit_tiers.c front.c objective.c shipped.c tiers.c)
SG_LIGHT_SRC := $(filter-out $(SG_LIGHT_COMMANDS),$(wildcard cases/sg_light/*.c))
SG_LIGHT_OBJ := $(SG_LIGHT_SRC:%.c=$(B)/%.o)
FIT_OBJ += $(SG_LIGHT_OBJ) $(SG_LIGHT_COMMANDS:%.c=$(B)/%.o)

# Operations of the forms, from their texts.
FIT_OBJ += $(if $(EMIT_OBJ),$(B)/cases/sg_light/operations.o)
$(B)/cases/sg_light/operations.o: cases/sg_light/operations.cpp $(EMIT_HDR) $(wildcard cases/sg_light/*.h)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

# Every form against the truth on its cells: a minute on two processors the first time, and a committed result.
.PHONY: sg-light-front
sg-light-front: $(B)/lobefit
	$< search sg_light --csv cases/sg_light/front.csv

# GGX and Beckmann as 1 to 5 spherical Gaussians: ten seconds, and a committed result.
.PHONY: sg-ndf
sg-ndf: $(B)/lobefit
	$< search sg_light --ndf cases/sg_light/ndf.csv

SG_LIGHT_SHARED := $(addprefix $(B)/cases/sphere_light/,columns.o light_points.o quadrature.o truth_cone.o truth_stretched.o \
    truth_source.o) $(addprefix $(B)/cases/fit/,atomic_file.o truth_cache.o interrupt.o jacobian.o least_squares.o objective.o \
    triangle.o trust_region.o)
TESTS += $(B)/test/test_sg_light_truth $(B)/test/test_sg_floors
$(B)/test/test_sg_light_truth: cases/test/test_sg_light.c $(SG_LIGHT_OBJ) $(SG_LIGHT_SHARED) $(TRUTH_OBJ) $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
$(B)/test/test_sg_floors: cases/test/test_sg_floors.c $(SG_LIGHT_OBJ) $(B)/cases/sg_light/shipped.o \
    $(SG_LIGHT_SHARED) $(TRUTH_OBJ) $(B)/liblobe.a $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o %.a,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
