# Environment specular by a fan of spherical Gaussians: the fit of its two layers, and what goes wrong in such fits. The
# response, the environments and their spectra are env_lobes'.
ENV_SG_SHARED := $(addprefix $(B)/cases/env_lobes/,gauss.o harmonics.o kernels.o response.o rooms.o spectrum.o \
    visible_normals.o) $(addprefix $(B)/cases/environment/,environment.o sky.o) $(B)/cases/fit/random.o
ENV_SG_OBJ := $(patsubst %.c,$(B)/%.o,$(filter-out %/fit.c %/front.c,$(wildcard cases/env_lobes_sg/*.c)))
FIT_OBJ += $(ENV_SG_OBJ) $(addprefix $(B)/cases/env_lobes_sg/,fit.o front.o) $(ENV_SG_SHARED)

# What ships, the seed paper's model and the split sum: two minutes on two processors, and a committed result.
.PHONY: env-lobes-sg-front
env-lobes-sg-front: $(B)/lobefit
	$< search env_lobes_sg --csv cases/env_lobes_sg/front.csv

# What goes wrong: tables and their plots, two minutes on one processor; the results are committed. L-BFGS is a peer,
# from liblbfgs (make deps).
ENV_SG_TRIES_DIR := cases/env_lobes_sg/stability
ENV_SG_TRIES_OBJ := $(patsubst %.c,$(B)/%.o,$(wildcard $(ENV_SG_TRIES_DIR)/*.c)) \
    $(addprefix $(B)/cases/env_lobes_sg/,fan.o target.o) \
    $(addprefix $(B)/cases/env_lobes/,gauss.o kernels.o response.o visible_normals.o) \
    $(addprefix $(B)/cases/fit/,atomic_file.o differential_evolution.o nelder_mead.o objective.o random.o \
        simplex_repair.o)
$(B)/lobe_experiments: $(ENV_SG_TRIES_OBJ)
	$(CC) $(CFLAGS) $(sort $^) -llbfgs -lm -o $@

.PHONY: lobe-experiments
lobe-experiments: $(B)/lobe_experiments
	$< $(ENV_SG_TRIES_DIR)
	cd $(ENV_SG_TRIES_DIR) && gnuplot plots.gp

TESTS += $(B)/test/test_env_lobes_sg
$(B)/test/test_env_lobes_sg: cases/test/test_env_lobes_sg.c $(ENV_SG_OBJ) $(ENV_SG_SHARED) $(CASES_HDR)
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(sort $(filter %.c %.o,$^)) -lcmocka -lpthread -lm -o $@
