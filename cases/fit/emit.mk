# The recorder of kernels and what reads its record. C++ without its library, so that a C compiler links it.
#
#   make emit-q30    writes models/q30/*.c for every formula that has coefficients
EMIT_SRC := $(sort $(wildcard cases/fit/trace*.cpp cases/fit/emit*.cpp))
EMIT_OBJ := $(EMIT_SRC:%.cpp=$(B)/%.o)
EMIT_HDR := $(wildcard cases/fit/trace*.h cases/fit/emit*.h cases/test/emit_kernels.h core/*.h models/*.h \
                       models/coeffs/*.h)
EMIT_CXXFLAGS := -std=gnu++11 -O3 -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics \
                 -Wall -Wextra -Wconversion $(if $(WERROR),-Werror)
# Lights of a size are integers by hand: they need a block exponent.
EMIT_TIERS := $(filter-out sphere_% capsule_% sg_%,$(sort $(patsubst models/coeffs/%.h,%,$(wildcard $(addprefix models/coeffs/*_,low.h medium.h high.h exact.h zonal.h)))))
# The tier of a name without its model: in a recipe, after name is set.
EMIT_SPLIT := case $$name in *_zonal_low) tier=zonal_low ;; *) tier=$${name\#\#*_} ;; esac; model=$${name%_$$tier}

$(EMIT_OBJ): $(B)/%.o: %.cpp $(EMIT_HDR)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

.PHONY: emit-q30
emit-q30: $(B)/lobefit
	@set -e; for name in $(EMIT_TIERS); do \
	    $(EMIT_SPLIT); echo "lobefit emit $$model --tier $$tier --to q30 > models/q30/$$name.c"; \
	    $(B)/lobefit emit $$model --tier $$tier --to q30 > $(B)/q30.$$$$.new; \
	    mv $(B)/q30.$$$$.new models/q30/$$name.c; \
	done

# Tests. The compiled q30 sources trap on signed overflow there.
EMIT_TEST := $(B)/cases/test
EMIT_CHECKED := $(ALL_CFLAGS) -fsanitize=signed-integer-overflow -fsanitize-undefined-trap-on-error
EMIT_BEHIND := $(filter-out %/trace_kernels.o,$(EMIT_OBJ))
TESTS += $(EMIT_TEST)/emit_count $(EMIT_TEST)/emit_range $(EMIT_TEST)/emit_q30 $(EMIT_TEST)/emit_q30_try $(EMIT_TEST)/emit_languages

$(EMIT_TEST)/%.o: cases/test/%.cpp $(EMIT_HDR)
	@mkdir -p $(@D)
	$(CXX) $(EMIT_CXXFLAGS) -c $< -o $@

$(EMIT_TEST)/emit_count: $(EMIT_TEST)/test_emit_count.o $(EMIT_OBJ)
	$(CC) $(CFLAGS) $^ -lm -o $@

$(EMIT_TEST)/emit_range: $(EMIT_TEST)/test_emit_range.o $(EMIT_TEST)/emit_kernels.o $(EMIT_BEHIND)
	$(CC) $(CFLAGS) $^ -lm -o $@

$(EMIT_TEST)/emitted_rows.h: models/q30 $(wildcard models/q30/*.c)
	@mkdir -p $(@D)
	@for name in $(basename $(notdir $(wildcard $(EMIT_TIERS:%=models/q30/%.c)))); do \
	    $(EMIT_SPLIT); case $$tier in *low) bound=LOW ;; *) bound=MEDIUM ;; esac; \
	    echo "$$model($$tier, $$bound)"; \
	done > $@

EMIT_Q30 = $(wildcard $(EMIT_TIERS:%=models/q30/%.c))
$(EMIT_TEST)/emit_q30: cases/test/test_emit_q30.c cases/test/test_emit_q30_rows.h $(EMIT_TEST)/emitted_rows.h \
                       $(EMIT_OBJ) $(wildcard models/q30/*.c) $(LIB_HDR)
	$(CC) $(EMIT_CHECKED) -I$(EMIT_TEST) $< $(EMIT_Q30) $(EMIT_OBJ) -lm -o $@

$(EMIT_TEST)/emit_try: cases/test/emit_try.c $(EMIT_TEST)/emit_kernels.o $(EMIT_BEHIND)
	$(CC) $(ALL_CFLAGS) $^ -lm -o $@

$(EMIT_TEST)/try_%.c: $(EMIT_TEST)/emit_try
	$< $* q30 > $@.new
	mv $@.new $@

$(EMIT_TEST)/emit_q30_try: cases/test/test_emit_q30.c $(EMIT_TEST)/try_medium.c $(EMIT_TEST)/try_high.c \
                           $(EMIT_TEST)/try_inverse.c $(EMIT_TEST)/emit_kernels.o $(EMIT_BEHIND) $(LIB_HDR) \
                           cases/test/test_emit_q30_rows.h
	$(CC) $(EMIT_CHECKED) -DLOBE_TEST_TRY -Imodels/q30 $(filter %.c %.o,$^) -lm -o $@

$(EMIT_TEST)/emit_fpcore: cases/test/test_emit_fpcore.c $(EMIT_OBJ)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $^ -lm -o $@

# A test that needs arguments is a program of one line.
$(EMIT_TEST)/emit_languages: cases/test/test_emit_languages.sh cases/test/test_emit_bits.c $(B)/lobefit \
                             $(EMIT_TEST)/emit_fpcore
	@printf '#!/bin/sh\nCC="%s" exec sh %s %s %s %s\n' '$(CC)' $< $(B)/lobefit $(EMIT_TEST)/emit_fpcore \
	    $(EMIT_TEST)/languages > $@
	@chmod +x $@
