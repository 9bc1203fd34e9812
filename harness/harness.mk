# lobecheck, its tests, fuzzing and benchmarks.
CHECK_SRC := $(addprefix harness/,lobecheck.c run.c eval.c hash_check.c bench.c bench_table.c hash_file.c vec_file.c rows.c \
             conform_core.c hash.c registry.c)
CHECK_HDR := $(wildcard harness/*.h)
CHECK_OBJ := $(CHECK_SRC:%.c=$(B)/%.o)
# What a target without files compiles: the same judge, and vectors as arrays.
CONFORM_SRC := $(addprefix harness/,conform_core.c hash.c registry.c)
VECTORS   := $(wildcard vectors/*.vec)

$(B)/harness/%.o: harness/%.c $(CHECK_HDR) $(LIB_HDR)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c $< -o $@

$(B)/lobecheck: $(CHECK_OBJ) $(B)/liblobe.a
	$(CC) $(ALL_CFLAGS) $^ -o $@ $(LDFLAGS) -lm

all: $(B)/liblobe.a $(B)/lobecheck
	$(B)/lobecheck run

EMBED_SRC := $(addprefix harness/,embed_vectors.c vec_file.c rows.c hash_file.c hash.c registry.c)
$(B)/embed_vectors: $(EMBED_SRC:%.c=$(B)/%.o) $(B)/liblobe.a
	$(CC) $(ALL_CFLAGS) $^ -o $@ $(LDFLAGS) -lm

# Every vector and hash as C arrays, for targets without files.
$(B)/embedded.c: $(B)/embed_vectors $(VECTORS) $(wildcard vectors/hashes.txt)
	$< $(if $(wildcard vectors/hashes.txt),--hashes vectors/hashes.txt) $(VECTORS) > $@.new
	mv $@.new $@

# The program for targets without files, on this host.
$(B)/conform: $(addprefix $(B)/harness/,conform.o conform_report.o port_stdio.o $(notdir $(CONFORM_SRC:.c=.o))) \
              $(B)/embedded.c $(B)/liblobe.a
	$(CC) $(ALL_CFLAGS) -Iharness $^ -o $@ $(LDFLAGS)

# Tests: programs on cmocka and scripts, all of which print TAP.
UNIT_TESTS := range arrays limits promises q30 apply diffuse_sh diffuse_sh_radiance sphere_diffuse sphere_sh \
              sphere_schlick sphere_tiers sphere_seen sphere_light_q30 capsule_tiers sg_light env_lobes env_adaptive env_lobes_table env_fresnel \
              helpers tables vec_file judge hash
SCRIPT_TESTS := chart cli conform contract diffuse_chart dropin embed env_chart fuzz header lib readme sanitize shaders sphere_chart targets vectors \
                warnings
TESTS += $(UNIT_TESTS:%=$(B)/test/test_%) $(SCRIPT_TESTS:%=harness/test/test_%.sh)

$(UNIT_TESTS:%=$(B)/test/test_%): $(B)/test/test_%: harness/test/test_%.c \
    $(addprefix $(B)/harness/,vec_file.o rows.o conform_core.o hash.o registry.o) $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $^ -o $@ $(LDFLAGS) -lcmocka -lm

# The table lookup as users of fast-math build it.
TABLE_SRC := $(wildcard models/f32/split*table*.c models/q30/split*table*.c models/tables/split*.c)
TESTS += $(B)/test/test_tables_fast
$(B)/test/test_tables_fast: harness/test/test_tables.c $(TABLE_SRC) $(LIB_HDR)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -Ofast harness/test/test_tables.c $(TABLE_SRC) -o $@ $(LDFLAGS) -lcmocka -lm

# What the scripts call.
TEST_NEEDS += $(B)/lobecheck $(B)/embed_vectors $(addprefix $(B)/harness/,conform.o conform_report.o port_stdio.o)

# TESTS is complete only when every room has been read, hence the second make.
.PHONY: run-tests
test:
	@$(MAKE) --no-print-directory run-tests
run-tests:
	@$(MAKE) --no-print-directory $(TEST_NEEDS) $(TESTS)
	@B='$(B)' CC='$(CC)' CXX='$(CXX)' harness/test/run.sh $(TESTS)

# Fuzzing: make fuzz FUZZ_SECONDS=30 runs each parser that long under the sanitizers. Needs clang.
FUZZ_SECONDS ?= 30
FUZZ_CC      ?= clang
FUZZ_FLAGS   := -std=gnu99 -ffp-contract=off -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all
FUZZ_SRC     := $(addprefix harness/,vec_file.c rows.c conform_core.c hash.c registry.c)

$(B)/fuzz/fuzz_%: harness/fuzz/fuzz_%.c $(FUZZ_SRC) $(LIB_SRC) $(CHECK_HDR) $(LIB_HDR)
	@mkdir -p $(@D)
	$(FUZZ_CC) $(FUZZ_FLAGS) $< $(FUZZ_SRC) $(LIB_SRC) -o $@ -lm

.PHONY: fuzz bench hashes
fuzz: $(B)/fuzz/fuzz_vec $(B)/fuzz/fuzz_rows
	harness/fuzz/seeds.sh $(B)/fuzz/seeds
	@mkdir -p $(B)/fuzz/found
	$(B)/fuzz/fuzz_vec -max_total_time=$(FUZZ_SECONDS) -max_len=8192 -timeout=10 -verbosity=0 -print_final_stats=1 \
	    -artifact_prefix=$(B)/fuzz/found/ $(B)/fuzz/seeds/vec
	$(B)/fuzz/fuzz_rows -max_total_time=$(FUZZ_SECONDS) -max_len=512 -timeout=10 -verbosity=0 -print_final_stats=1 \
	    -artifact_prefix=$(B)/fuzz/found/ $(B)/fuzz/seeds/rows

# Speed is measured on a build for this machine. The bits stay: no flag here lets a compiler fuse or reorder, and
# -fno-trapping-math only says that nobody watches the exception flags, without which gcc vectorises no choice on AVX2.
# make bench BENCH_CFLAGS='-O3 -mavx2 -fno-trapping-math' is another build in another folder.
BENCH_CFLAGS ?= -O3 -march=native -fno-trapping-math
BENCH_B      := $(B)/bench$(subst =,,$(subst $() ,,$(BENCH_CFLAGS)))
bench:
	@$(MAKE) --no-print-directory B=$(BENCH_B) CFLAGS='$(BENCH_CFLAGS)' $(BENCH_B)/lobecheck
	$(BENCH_B)/lobecheck bench

# After a change that is meant to change bits.
hashes: $(B)/lobecheck
	$(B)/lobecheck hash --write
