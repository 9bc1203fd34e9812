# A ball and a floor under environments, by taps into a filtered cube; after the fragments of env_lobes and prefilter.
AROUND_NEED := $(addprefix $(B)/cases/picture/,canvas.o deflate.o huffman.o png.o tone.o) $(PREFILTER_OBJ) \
               $(addprefix $(B)/cases/env_lobes/,gauss.o response.o rooms.o visible_normals.o) \
               $(addprefix $(B)/cases/fit/,parallel.o random.o) $(B)/liblobe.a
AROUND_OBJ := $(AROUND_SRC:%.c=$(B)/%.o)
$(B)/environments_picture: $(AROUND_OBJ) $(AROUND_NEED)
	$(CC) $(CFLAGS) $(sort $(filter %.o,$^)) $(filter %.a,$^) $(LOBEFIT_LIBS) -o $@

# 40 s of processor time each. They need no file, so the bytes are those committed.
.PHONY: environment-pictures
environment-pictures: $(B)/environments_picture
	$< sky cases/picture/environment_sky.png
	$< lamps cases/picture/environment_lamps.png
pictures: environment-pictures

TEST_NEEDS += $(B)/environments_picture
TESTS += $(B)/test/test_environment_pictures
$(B)/test/test_environment_pictures: cases/test/test_environment_pictures.c $(filter-out %_main.o,$(AROUND_OBJ)) \
    $(AROUND_NEED) $(TRUTH_OBJ)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(sort $(filter %.c %.o,$^)) $(filter %.a,$^) $(LOBEFIT_LIBS) -lcmocka -o $@
