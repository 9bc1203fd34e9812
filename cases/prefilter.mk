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

# `prefilter_error filter SIZE [FILE...]` and `... trilinear ...` print what the tables of cases/prefilter/README.md hold.
$(B)/prefilter_error: $(B)/cases/prefilter/error_main.o $(PREFILTER_OBJ)
	$(CC) $(CFLAGS) $^ $(LOBEFIT_LIBS) -o $@

PREFILTER_TESTS := prefilter prefilter_filter prefilter_files prefilter_opencl
TESTS += $(PREFILTER_TESTS:%=$(B)/test/test_%) $(wildcard cases/test/test_prefilter*.sh)

$(PREFILTER_TESTS:%=$(B)/test/test_%): $(B)/test/test_%: cases/test/test_%.c $(PREFILTER_OBJ) $(PREFILTER_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $< $(PREFILTER_OBJ) $(LOBEFIT_LIBS) -lcmocka -o $@

# libFuzzer on the readers of cubes; needs clang.
PREFILTER_FUZZ_SRC := $(addprefix cases/prefilter/,cube.c cube_file.c dds.c half.c ktx2.c) cases/environment/refuse.c
$(B)/fuzz/fuzz_cube: cases/test/fuzz_cube.c $(PREFILTER_FUZZ_SRC) $(PREFILTER_HDR)
	@mkdir -p $(@D)
	clang -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $(EXACT) $< $(PREFILTER_FUZZ_SRC) -lm -o $@
