# Capsule lights: truth, fit, front. The sphere beneath and the quadrature are sphere_light's.
CAPSULE_LIGHT_SRC := $(wildcard cases/capsule_light/*.c)
CAPSULE_LIGHT_OBJ := $(CAPSULE_LIGHT_SRC:%.c=$(B)/%.o)
FIT_OBJ += $(CAPSULE_LIGHT_OBJ)

# Operations of the forms, from their texts.
FIT_OBJ += $(if $(EMIT_OBJ),$(B)/cases/capsule_light/operations.o)
$(B)/cases/capsule_light/operations.o: cases/capsule_light/operations.cpp $(EMIT_HDR) $(wildcard cases/capsule_light/*.h)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

# Every form against the truth on its cells: twenty seconds on two processors, and a committed result.
.PHONY: capsule-light-front
capsule-light-front: $(B)/lobefit
	$< search capsule_light --csv cases/capsule_light/front.csv

TESTS += $(B)/test/test_capsule_light
$(B)/test/test_capsule_light: cases/test/test_capsule_light.c $(TRUTH_OBJ) $(CASES_HDR) \
    $(addprefix $(B)/cases/,$(addprefix capsule_light/,truth_capsule.o cells.o judge.o candidates.o) \
      $(addprefix sphere_light/,truth_cone.o truth_stretched.o truth_source.o quadrature.o))
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
