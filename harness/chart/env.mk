# env_lobes and sg_light are judged by the offline side, in minutes; the charts are of its committed tables.
.PHONY: env-chart
chart: env-chart
env-chart: $(CHART)/env_lobes.svg $(CHART)/sg_light.svg

$(B)/chart/env: $(CHART)/env.c harness/registry.c $(wildcard harness/*.h) $(B)/liblobe.a
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $(CHART)/env.c harness/registry.c $(B)/liblobe.a -lm -o $@

$(B)/chart/env_lobes.csv: $(B)/chart/env $(CHART)/env_join.awk cases/env_lobes/front.csv cases/env_lobes_sg/front.csv
	$< >$(B)/chart/env.costs
	awk -f $(CHART)/env_join.awk $(B)/chart/env.costs cases/env_lobes/front.csv cases/env_lobes_sg/front.csv >$@.new
	mv $@.new $@

$(B)/chart/sg_light.csv: $(CHART)/sg_join.awk cases/sg_light/front.csv
	@mkdir -p $(@D)
	awk -f $(CHART)/sg_join.awk cases/sg_light/front.csv >$@.new
	mv $@.new $@

$(CHART)/env_lobes.csv $(CHART)/sg_light.csv: $(CHART)/%.csv: $(B)/chart/%.csv
	cp $< $@

$(CHART)/env_lobes.svg: $(CHART)/env_lobes.csv $(CHART)/env.gp
	gnuplot -e 'in="$<"; out="$@.new.svg"' $(CHART)/env.gp
	mv $@.new.svg $@

$(CHART)/sg_light.svg: $(CHART)/sg_light.csv $(CHART)/sg.gp
	gnuplot -e 'in="$<"; out="$@.new.svg"' $(CHART)/sg.gp
	mv $@.new.svg $@
