# The fitter's engines. They need a C compiler, threads and sqrt; nlopt, cminpack and lbfgs are linked by the
# comparison and its tests alone.
OPTIMISER_SRC := $(addprefix cases/fit/, atomic_file.c coarse_to_fine.c differential_evolution.c global_local.c \
    interrupt.c jacobian.c least_squares.c minimax.c nelder_mead.c objective.c parallel.c power_norm.c progress.c \
    prune.c random.c simplex_repair.c triangle.c trust_region.c)
OPTIMISER_OBJ := $(OPTIMISER_SRC:%.c=$(B)/%.o)
OPTIMISER_HDR := $(wildcard cases/fit/*.h)
FIT_OBJ += $(OPTIMISER_OBJ)

# -O3: the factor's inner loops vectorise along a row, which leaves their bits alone.
$(OPTIMISER_OBJ): $(B)/cases/fit/%.o: cases/fit/%.c $(OPTIMISER_HDR)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -O3 -c $< -o $@

OPTIMISER_TEST_OBJ := $(B)/cases/test/optimiser_problems.o
OPTIMISER_TESTS := $(B)/cases/test/test_optimisers $(B)/cases/test/test_optimisers_local \
    $(B)/cases/test/test_optimisers_minimax $(B)/cases/test/test_optimisers_files

$(B)/cases/test/optimiser_problems.o $(B)/cases/test/compare_optimisers.o $(OPTIMISER_TESTS:=.o): \
    $(B)/cases/test/%.o: cases/test/%.c $(OPTIMISER_HDR) cases/test/optimiser_problems.h
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c $< -o $@

$(OPTIMISER_TESTS): %: %.o $(OPTIMISER_TEST_OBJ) $(OPTIMISER_OBJ)
	$(CC) $(CFLAGS) $^ -lcmocka $(if $(findstring local,$@),-lcminpack) -lpthread -lm -o $@

TESTS += $(OPTIMISER_TESTS)

$(B)/cases/test/compare_optimisers: %: %.o $(OPTIMISER_TEST_OBJ) $(OPTIMISER_OBJ)
	$(CC) $(CFLAGS) $^ -lnlopt -llbfgs -lcminpack -lpthread -lm -o $@

# The committed table; its digits depend on the C library's cos and exp, through the test functions.
.PHONY: optimiser-table
optimiser-table: $(B)/cases/test/compare_optimisers
	$< > $(B)/success.txt
	mv $(B)/success.txt cases/fit/success.txt
