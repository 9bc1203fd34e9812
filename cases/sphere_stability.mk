# Where sphere lights fail: a map over alpha, half angle and view, and the regions that the tests hold to their limits.
STABILITY_DIR := cases/sphere_light/stability
STABILITY_OBJ := $(B)/$(STABILITY_DIR)/stability.o $(SPHERE_LIGHT_OBJ) $(TRUTH_OBJ) $(B)/cases/fit/atomic_file.o

$(B)/stability: $(B)/$(STABILITY_DIR)/main.o $(STABILITY_OBJ)
	$(CC) $(CFLAGS) $(sort $^) $(LOBEFIT_LIBS) -o $@

# Half a minute on two processors; the results are committed.
stability: $(B)/stability
	$< $(STABILITY_DIR)/cells.csv $(STABILITY_DIR)/regions.txt
	gnuplot -e "in='$(STABILITY_DIR)/cells.csv'; out='$(B)/stability.svg'" $(STABILITY_DIR)/stability.gp
	mv $(B)/stability.svg $(STABILITY_DIR)/stability.svg
	cat $(STABILITY_DIR)/regions.txt

TESTS += $(B)/test/test_sphere_stability
$(B)/test/test_sphere_stability: cases/test/test_sphere_stability.c $(STABILITY_OBJ) $(CASES_HDR) \
                                 $(STABILITY_DIR)/stability.h
	@mkdir -p $(@D)
	$(CC) $(CASES_CFLAGS) $(filter %.c,$^) $(sort $(filter %.o,$^)) $(LOBEFIT_LIBS) -lcmocka -o $@
