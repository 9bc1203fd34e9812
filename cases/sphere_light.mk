# Sphere and capsule lights: truth, and the forms that were explored. None of it ships yet.
SPHERE_LIGHT_SRC := $(wildcard cases/sphere_light/*.c)
SPHERE_LIGHT_OBJ := $(SPHERE_LIGHT_SRC:%.c=$(B)/%.o) $(B)/cases/sphere_light/truth_source.o
FIT_OBJ += $(SPHERE_LIGHT_OBJ)

# Every form against the truth on its cells: half a minute on two processors, and a committed result.
.PHONY: sphere-light-front
sphere-light-front: $(B)/lobefit
	$< search sphere_light --csv cases/sphere_light/front.csv

TESTS += $(B)/test/test_sphere_light
$(B)/test/test_sphere_light: cases/test/test_sphere_light.c $(SPHERE_LIGHT_OBJ) $(TRUTH_OBJ) \
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
