# A floor and a ball under a sphere light and a capsule; after the fragments of those lights.
LIGHTS_NEED := $(addprefix $(B)/cases/picture/,canvas.o deflate.o huffman.o png.o tone.o) $(B)/cases/fit/parallel.o \
               $(SPHERE_LIGHT_OBJ) $(addprefix $(B)/cases/capsule_light/,candidates.o truth_capsule.o) $(TRUTH_OBJ) $(B)/cases/fit/atomic_file.o
$(B)/lights_picture: $(LIGHTS_SRC:%.c=$(B)/%.o) $(LIGHTS_NEED)
	$(CC) $(CFLAGS) $(sort $^) $(LOBEFIT_LIBS) -o $@

TEST_NEEDS += $(B)/lights_picture
