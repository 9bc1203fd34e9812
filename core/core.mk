# core is headers only; here are its tests and the measurement of its elementary functions.
CORE_HDR := $(wildcard core/*.h)

# elementary_fast: survives what a user's -Ofast does. q30_halves: the spellings of Cortex-M0, on this host.
# geometry_double: the scalar of the ground truth.
CORE_TESTS := elementary elementary_fast arc arc_double q30 q30_halves q30_scaled q30_scaled_halves geometry geometry_double
TESTS += $(CORE_TESTS:%=$(B)/test/test_core_%) harness/test/test_core_dialect.sh

$(B)/test/test_core_elementary_fast: CORE_TEST_FLAGS = -DLOBE_TEST_FAST -Ofast
$(B)/test/test_core_q30_halves $(B)/test/test_core_q30_scaled_halves: CORE_TEST_FLAGS = -DLOBE_Q_HALVES -DLOBE_Q_NO_CLZ
$(B)/test/test_core_arc_double $(B)/test/test_core_geometry_double: CORE_TEST_FLAGS = -DLOBE_DOUBLE
CORE_TEST = $(CC) $(ALL_CFLAGS) $(CORE_TEST_FLAGS) $< -o $@ $(LDFLAGS) -lcmocka -lm

$(B)/test/test_core_elementary $(B)/test/test_core_elementary_fast: harness/test/test_core_elementary.c \
    harness/elementary.h $(CORE_HDR)
	@mkdir -p $(@D)
	$(CORE_TEST)

$(B)/test/test_core_q30 $(B)/test/test_core_q30_halves: harness/test/test_core_q30.c $(CORE_HDR)
	@mkdir -p $(@D)
	$(CORE_TEST)

$(B)/test/test_core_q30_scaled $(B)/test/test_core_q30_scaled_halves: harness/test/test_core_q30_scaled.c $(CORE_HDR)
	@mkdir -p $(@D)
	$(CORE_TEST)

$(B)/test/test_core_geometry $(B)/test/test_core_geometry_double: harness/test/test_core_geometry.c $(CORE_HDR)
	@mkdir -p $(@D)
	$(CORE_TEST)

$(B)/test/test_core_arc $(B)/test/test_core_arc_double: harness/test/test_core_arc.c $(CORE_HDR)
	@mkdir -p $(@D)
	$(CORE_TEST)

# Every float of every domain: minutes, so by hand, and the result is committed.
.PHONY: exhaustive
exhaustive: $(B)/exhaustive
	nice -n 10 $(B)/exhaustive > $(B)/exhaustive.txt
	mv $(B)/exhaustive.txt harness/exhaustive.txt
	cat harness/exhaustive.txt

$(B)/exhaustive: harness/exhaustive.c harness/elementary.h $(CORE_HDR)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $< -o $@ -pthread -lm
