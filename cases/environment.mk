# Lighting from maps: what `lobefit project` and the pictures need. The lobes alone know models/.
ENVIRONMENTS := $(wildcard ../shared/data/environments/*.hdr)
ENVIRONMENT_SRC := $(filter-out %_main.c,$(wildcard cases/environment/*.c))
ENVIRONMENT_HDR := $(wildcard cases/environment/*.h)
ENVIRONMENT_OBJ := $(ENVIRONMENT_SRC:%.c=$(B)/%.o)
FIT_OBJ += $(addprefix $(B)/cases/environment/,environment.o load.o pfm.o project.o project_command.o refuse.o rgbe.o sun.o window.o)

$(B)/environment_metric: $(B)/cases/environment/metric_main.o $(ENVIRONMENT_OBJ) $(B)/cases/fit/random.o
	$(CC) $(CFLAGS) $^ -lm -o $@

# What each tier loses under a sky, and under the maps that are there.
.PHONY: environment-metric
environment-metric: $(B)/environment_metric
	$< $(ENVIRONMENTS)

ENVIRONMENT_TESTS := environment environment_files environment_metric
TESTS += $(ENVIRONMENT_TESTS:%=$(B)/test/test_%) $(wildcard cases/test/test_environment*.sh)

$(ENVIRONMENT_TESTS:%=$(B)/test/test_%): $(B)/test/test_%: cases/test/test_%.c $(ENVIRONMENT_OBJ) \
    $(B)/cases/fit/random.o $(ENVIRONMENT_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $< $(ENVIRONMENT_OBJ) $(B)/cases/fit/random.o -lcmocka -lm -o $@

# libFuzzer on the two readers and the projection; needs clang.
$(B)/fuzz/fuzz_environment: cases/test/fuzz_environment.c $(ENVIRONMENT_SRC) $(ENVIRONMENT_HDR)
	@mkdir -p $(@D)
	clang -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $(EXACT) $< \
	    $(filter-out %/metric.c %/lobes.c %_command.c,$(ENVIRONMENT_SRC)) -lm -o $@
