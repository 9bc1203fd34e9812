# How medium's closed forms were come by: a few minutes of one processor, and a committed result.
STORY_DIR := cases/sphere_light/story
$(B)/sphere_story: $(B)/$(STORY_DIR)/main.o $(B)/$(STORY_DIR)/shipped.o $(STABILITY_OBJ) \
                   $(addprefix $(B)/cases/fit/,nelder_mead.o objective.o simplex_repair.o)
	$(CC) $(CFLAGS) $(sort $(filter-out %/stability.o,$^)) $(LOBEFIT_LIBS) -o $@

.PHONY: sphere-light-story
sphere-light-story: $(B)/sphere_story
	$< $(STORY_DIR)/cells.csv $(STORY_DIR)/summary.txt
	gnuplot -e "in='$(STORY_DIR)/cells.csv'; out='$(B)/story.svg'" $(STORY_DIR)/story.gp
	mv $(B)/story.svg $(STORY_DIR)/story.svg
	cat $(STORY_DIR)/summary.txt
