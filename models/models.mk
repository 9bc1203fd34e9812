# liblobe.a: every tier in its own object, so that a linker drops what a game does not call.
LIB_SRC := $(sort $(wildcard models/f32/*.c models/q30/*.c models/tables/*.c))
LIB_OBJ := $(LIB_SRC:%.c=$(B)/lib/%.o)
LIB_HDR := $(wildcard core/*.h models/*.h models/*/*.h)

$(B)/lib/%.o: %.c $(LIB_HDR)
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) -c $< -o $@

$(B)/liblobe.a: $(LIB_OBJ)
	@rm -f $@
	$(AR) rcsD $@ $^
