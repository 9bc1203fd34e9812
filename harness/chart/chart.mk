# `make chart`: harness/chart/{split_sum,split_sum_sep,energy,diffuse_sh}.{svg,csv}, cost on x, error on y.
CHART       := harness/chart
CHART_BRDFS := split_sum split_sum_sep split_sum_kibl energy
CHART_SIDE  ?= 1024

.PHONY: chart
.PRECIOUS: $(CHART)/%.csv $(B)/chart/%.truth $(B)/chart/%.errors
chart: $(CHART)/split_sum.svg $(CHART)/split_sum_sep.svg $(CHART)/energy.svg $(CHART)/diffuse_sh.svg

$(B)/chart/errors: $(CHART)/errors.c harness/registry.c $(wildcard harness/*.h harness/peers/*.h) $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $(CHART)/errors.c harness/registry.c $(B)/liblobe.a -lm -o $@

$(B)/chart/grid: $(B)/chart/errors
	$< grid $(CHART_SIDE) >$@.new
	mv $@.new $@

$(B)/chart/%.truth: $(B)/chart/grid $(B)/lobefit
	$(B)/lobefit truth $* <$< >$@.new
	mv $@.new $@

$(B)/chart/%.errors: $(B)/chart/%.truth $(B)/chart/errors
	paste -d' ' $(B)/chart/grid $< | $(B)/chart/errors $* >$@.new
	mv $@.new $@

$(CHART)/%.csv: $(B)/chart/%.errors counts $(CHART)/join.awk
	awk -f $(CHART)/join.awk $(B)/counts_x86.csv $(B)/counts_m4f.csv $(B)/counts_m0.csv $< >$@.new
	mv $@.new $@

front_split_sum       := front="cases/split_sum/front_corr.csv";
front_split_sum_sep   := front="cases/split_sum/front_sep.csv";
heading_split_sum     := Split sum, height-correlated Smith GGX: roughness and NdotV in [.02, 1]
heading_split_sum_sep := Split sum, separable Smith GGX: roughness and NdotV in [.02, 1]
heading_energy        := 1/E of height-correlated GGX, white furnace error: roughness and NdotV in [.02, 1]

# diffuse_sh has errors of its own: light and furnace.
$(B)/chart/diffuse: $(CHART)/diffuse.c harness/registry.c $(wildcard harness/*.h harness/peers/*.h) $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $(CHART)/diffuse.c harness/registry.c $(B)/liblobe.a -lm -o $@

$(B)/chart/diffuse_sh.errors: $(B)/chart/diffuse $(B)/lobefit
	$< grid >$(B)/chart/diffuse_sh.grid
	$(B)/lobefit truth diffuse_sh <$(B)/chart/diffuse_sh.grid | paste -d' ' $(B)/chart/diffuse_sh.grid - | $< >$@.new
	mv $@.new $@

$(CHART)/diffuse_sh.csv: $(B)/chart/diffuse_sh.errors counts $(CHART)/diffuse_join.awk
	awk -f $(CHART)/diffuse_join.awk $(B)/counts_x86.csv $(B)/counts_m4f.csv $(B)/counts_m0.csv $< >$@.new
	mv $@.new $@

$(CHART)/diffuse_sh.svg: $(CHART)/diffuse_sh.csv $(CHART)/diffuse.gp
	gnuplot -e 'in="$<"; out="$@.new.svg"' $(CHART)/diffuse.gp
	mv $@.new.svg $@

$(CHART)/%.svg: $(CHART)/%.csv $(CHART)/chart.gp
	gnuplot -e 'in="$<"; out="$@.new.svg"; brdf="$*"; $(front_$*)heading="$(heading_$*)"' $(CHART)/chart.gp
	mv $@.new.svg $@

# sphere_light is judged on cells of its own; the published forms are judged by the offline side.
chart: $(CHART)/sphere_light.svg

$(B)/chart/sphere: $(CHART)/sphere.c harness/registry.c $(wildcard harness/*.h) $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $(CHART)/sphere.c harness/registry.c $(B)/liblobe.a -lm -o $@

$(B)/chart/sphere_light.cells: $(B)/lobefit
	@mkdir -p $(@D)
	$< search sphere_light --cells $@

$(B)/chart/sphere_light.errors: $(B)/chart/sphere_light.cells $(B)/chart/sphere
	$(B)/chart/sphere <$< >$@.new
	mv $@.new $@

$(CHART)/sphere_light.csv: $(B)/chart/sphere_light.errors cases/sphere_light/front.csv counts $(CHART)/sphere_join.awk
	awk -f $(CHART)/sphere_join.awk $(B)/counts_x86.csv $(B)/counts_m4f.csv $(B)/counts_m0.csv \
	    cases/sphere_light/front.csv $< >$@.new
	mv $@.new $@

$(CHART)/sphere_light.svg: $(CHART)/sphere_light.csv $(CHART)/sphere.gp
	gnuplot -e 'in="$<"; out="$@.new.svg"' $(CHART)/sphere.gp
	mv $@.new.svg $@

-include harness/chart/env.mk
