# The diffuse part of sphere lights. quadrature.c is sphere_light's.
SPHERE_DIFFUSE_SRC := $(wildcard cases/sphere_diffuse/*.c)
SPHERE_DIFFUSE_OBJ := $(SPHERE_DIFFUSE_SRC:%.c=$(B)/%.o)
FIT_OBJ += $(SPHERE_DIFFUSE_OBJ)

TESTS += $(B)/test/test_sphere_diffuse_truth
$(B)/test/test_sphere_diffuse_truth: cases/test/test_sphere_diffuse.c $(TRUTH_OBJ) $(CASES_HDR) $(B)/liblobe.a \
    $(addprefix $(B)/cases/,sphere_diffuse/truth_sphere_diffuse.o sphere_diffuse/burley_cone.o sphere_light/quadrature.o)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c %.o %.a,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
