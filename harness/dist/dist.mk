# Drop-ins and installation.
SHADER_HDR = $(shell sh harness/dist/shader_headers.sh $(CC))
VERSION    = $(shell sed -n 's/^.define LOBE_VERSION "\(.*\)"/\1/p' models/lobe.h)

.PHONY: dist install
dist: $(DIST)/lobe.h $(DIST)/lobe.c $(DIST)/lobe.shader.h

$(B)/amalgamate: harness/dist/amalgamate.c
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $< -o $@

$(DIST)/lobe.h: $(wildcard models/lobe*.h) LICENSE $(B)/amalgamate
	@mkdir -p $(@D)
	@$(B)/amalgamate -t LICENSE -o $@ models/lobe.h

$(DIST)/lobe.c: $(LIB_SRC) $(LIB_HDR) LICENSE $(B)/amalgamate harness/dist/drop_in.h
	@mkdir -p $(@D)
	@$(B)/amalgamate -t LICENSE -k lobe.h -o $@ harness/dist/drop_in.h $(LIB_SRC)

$(DIST)/lobe.shader.h: $(LIB_HDR) LICENSE $(B)/amalgamate harness/dist/shader_headers.sh harness/dist/one_file.h
	@mkdir -p $(@D)
	@$(B)/amalgamate -t LICENSE -o $@ harness/dist/one_file.h $(SHADER_HDR)

# The library and its header; the kernel headers with their folders, for C, C++ and OpenCL; the shader text.
install: $(B)/liblobe.a $(DIST)/lobe.h $(DIST)/lobe.shader.h
	install -d '$(DESTDIR)$(PREFIX)/lib/pkgconfig' '$(DESTDIR)$(PREFIX)/include/lobe/core' \
	    '$(DESTDIR)$(PREFIX)/include/lobe/models/coeffs'
	install -m 644 $(B)/liblobe.a '$(DESTDIR)$(PREFIX)/lib'
	install -m 644 $(DIST)/lobe.h '$(DESTDIR)$(PREFIX)/include'
	install -m 644 $(filter core/%,$(SHADER_HDR)) '$(DESTDIR)$(PREFIX)/include/lobe/core'
	install -m 644 $(filter models/%,$(SHADER_HDR)) '$(DESTDIR)$(PREFIX)/include/lobe/models'
	install -m 644 $(wildcard models/coeffs/*.h) '$(DESTDIR)$(PREFIX)/include/lobe/models/coeffs'
	install -m 644 $(DIST)/lobe.shader.h '$(DESTDIR)$(PREFIX)/include/lobe'
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' harness/dist/lobe.pc.in \
	    >'$(DESTDIR)$(PREFIX)/lib/pkgconfig/lobe.pc'

# The drop-in built as each language allows, and lobecheck on top of it, for the test that compares hashes.
DROPIN_WARN := -Wall -Wextra -Wpedantic -Werror
CC_gcc-c99       := gcc -std=c99
CC_clang-c99     := clang -std=c99
CC_gcc-c++11     := g++ -x c++ -std=c++11
CC_clang-c++11   := clang++ -x c++ -std=c++11

$(B)/dropin/%.o: $(DIST)/lobe.c $(DIST)/lobe.h
	@mkdir -p $(@D)
	$(CC_$*) $(DROPIN_WARN) -O2 -ffp-contract=off -c $< -o $@

$(B)/dropin/lobecheck-%: $(B)/dropin/%.o $(CHECK_OBJ)
	$(CC) $(ALL_CFLAGS) $^ -o $@ $(LDFLAGS) -lm
.PRECIOUS: $(B)/dropin/%.o
