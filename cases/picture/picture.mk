# Spheres under environments. The committed picture shows the maps of ../shared/data too, so without them another file
# is written.
LIGHTS_SRC  := $(addprefix cases/picture/,lights.c lights_main.c)
AROUND_SRC  := $(addprefix cases/picture/,environments.c environments_main.c all_around.c pyramid.c)
PICTURE_SRC := $(filter-out $(LIGHTS_SRC) $(AROUND_SRC),$(wildcard cases/picture/*.c))
PICTURE_OBJ := $(PICTURE_SRC:%.c=$(B)/%.o)
PICTURE_OF  := $(if $(ENVIRONMENTS),cases/picture/diffuse.png,$(B)/diffuse.png)

$(B)/pictures: $(PICTURE_OBJ) $(ENVIRONMENT_OBJ) $(addprefix $(B)/cases/fit/,atomic_file.o parallel.o random.o)
	$(CC) $(CFLAGS) $^ -lm -lpthread -o $@

# Half a minute, and one and a half for the lights, whose truth is integrated at every pixel.
.PHONY: pictures
pictures: $(B)/pictures $(B)/lights_picture
	$< $(PICTURE_OF) $(ENVIRONMENTS)
	$(B)/lights_picture cases/picture/lights.png

TESTS += $(B)/test/test_picture cases/test/test_pictures.sh
TEST_NEEDS += $(B)/pictures

$(B)/test/test_picture: cases/test/test_picture.c $(filter-out %_main.o,$(PICTURE_OBJ)) $(ENVIRONMENT_OBJ) \
    $(addprefix $(B)/cases/fit/,atomic_file.o parallel.o random.o)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $^ -lcmocka -lm -lpthread -o $@
