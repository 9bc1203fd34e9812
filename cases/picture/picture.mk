# Spheres under environments. The committed picture shows the maps of ../shared/data too, so without them another file
# is written.
PICTURE_SRC := $(wildcard cases/picture/*.c)
PICTURE_OBJ := $(PICTURE_SRC:%.c=$(B)/%.o)
PICTURE_OF  := $(if $(ENVIRONMENTS),cases/picture/diffuse.png,$(B)/diffuse.png)

$(B)/pictures: $(PICTURE_OBJ) $(ENVIRONMENT_OBJ) $(addprefix $(B)/cases/fit/,atomic_file.o parallel.o random.o)
	$(CC) $(CFLAGS) $^ -lm -lpthread -o $@

.PHONY: pictures
pictures: $(B)/pictures
	$< $(PICTURE_OF) $(ENVIRONMENTS)

TESTS += $(B)/test/test_picture cases/test/test_pictures.sh
TEST_NEEDS += $(B)/pictures

$(B)/test/test_picture: cases/test/test_picture.c $(filter-out %_main.o,$(PICTURE_OBJ)) $(ENVIRONMENT_OBJ) \
    $(addprefix $(B)/cases/fit/,atomic_file.o parallel.o random.o)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $^ -lcmocka -lm -lpthread -o $@
