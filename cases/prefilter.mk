# Filtered cube maps: what `lobefit prefilter` and the pictures of environment lobes need.
PREFILTER_SRC := $(filter-out %_main.c,$(wildcard cases/prefilter/*.c))
PREFILTER_HDR := $(wildcard cases/prefilter/*.h)
# The sampler and the filter without the command line; what they need of the other rooms comes with them.
PREFILTER_OBJ := $(patsubst %.c,$(B)/%.o,$(filter-out %_command.c,$(PREFILTER_SRC))) $(B)/cases/prefilter/cl_source.o \
                 $(addprefix $(B)/cases/fit/,atomic_file.o interrupt.o opencl.o) \
                 $(addprefix $(B)/cases/environment/,environment.o load.o pfm.o refuse.o rgbe.o sky.o)
FIT_OBJ += $(PREFILTER_SRC:%.c=$(B)/%.o) $(B)/cases/prefilter/cl_source.o

$(B)/cases/prefilter/cl_source.c: cases/embed.awk core/dialect.h cases/prefilter/kernel.h cases/prefilter/rows.cl
	@mkdir -p $(@D)
	awk -v name=lobe_prefilter_cl_source -v prefix="#define LOBE_DOUBLE 1" -f cases/embed.awk core/dialect.h \
	    cases/prefilter/kernel.h cases/prefilter/rows.cl > $@.new
	mv $@.new $@

$(B)/cases/prefilter/cl_source.o: $(B)/cases/prefilter/cl_source.c
	$(CC) $(CASES_CFLAGS) -Wno-overlength-strings -c $< -o $@

# `prefilter_error filter|bilinear|trilinear|fraction SIZE [FILE...]` prints what the tables of cases/prefilter/README.md
# hold, in a minute or two each.
$(B)/prefilter_error: $(B)/cases/prefilter/error_main.o $(PREFILTER_OBJ)
	$(CC) $(CFLAGS) $^ $(LOBEFIT_LIBS) -o $@

# `prefilter_taps SIZE [FILE...]`: what reading the taps of env_lobes from a cube of that size costs.
$(B)/prefilter_taps: $(B)/cases/prefilter/taps_main.o $(PREFILTER_OBJ) \
    $(addprefix $(B)/cases/,env_lobes/response.o env_lobes/rooms.o fit/parallel.o fit/random.o)
	$(CC) $(CFLAGS) $^ $(LOBEFIT_LIBS) -o $@

PREFILTER_TESTS := prefilter prefilter_faces prefilter_filter prefilter_files prefilter_opencl
TESTS += $(PREFILTER_TESTS:%=$(B)/test/test_%) $(wildcard cases/test/test_prefilter*.sh)

$(PREFILTER_TESTS:%=$(B)/test/test_%): $(B)/test/test_%: cases/test/test_%.c $(PREFILTER_OBJ) $(PREFILTER_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $< $(PREFILTER_OBJ) $(LOBEFIT_LIBS) -lcmocka -o $@

# libFuzzer on the readers of cubes; needs clang.
PREFILTER_FUZZ_SRC := $(addprefix cases/prefilter/,cube.c cube_file.c dds.c faces.c half.c ktx2.c) \
                      $(addprefix cases/environment/,environment.c load.c pfm.c refuse.c rgbe.c)
$(B)/fuzz/fuzz_cube: cases/test/fuzz_cube.c $(PREFILTER_FUZZ_SRC) $(PREFILTER_HDR)
	@mkdir -p $(@D)
	clang -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $(EXACT) $< $(PREFILTER_FUZZ_SRC) -lm -o $@

# A part of `make fuzz`: the readers of maps and cubes, FUZZ_SECONDS each.
.PHONY: fuzz-readers
fuzz: fuzz-readers
fuzz-readers: $(B)/fuzz/fuzz_cube $(B)/fuzz/fuzz_environment $(B)/lobefit
	cases/test/fuzz_seeds.sh $(B)/lobefit $(B)/fuzz/seeds
	@mkdir -p $(B)/fuzz/found
	$(B)/fuzz/fuzz_cube -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -timeout=10 -verbosity=0 -print_final_stats=1 \
	    -artifact_prefix=$(B)/fuzz/found/ $(B)/fuzz/seeds/cube
	$(B)/fuzz/fuzz_environment -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -timeout=10 -verbosity=0 \
	    -print_final_stats=1 -artifact_prefix=$(B)/fuzz/found/ $(B)/fuzz/seeds/map
