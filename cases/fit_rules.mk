# Fits, what they write, and the measurement of what ships.
RULES_SRC := $(wildcard cases/energy/fit*.c cases/split_sum/table_fit*.c cases/split_sum/fit*.c \
    cases/split_sum/shipped.c) $(addprefix cases/fit/,coefficients.c fit_command.c)
FIT_OBJ += $(RULES_SRC:%.c=$(B)/%.o)
