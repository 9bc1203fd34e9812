/* The row parser: what it takes, and that everything else is refused with its line and its reason. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../fit/rows.h"

static const lobe_column columns[2] = {{"roughness", 0.001, 1}, {"n_dot_v", 0.001, 1}};

static int parse(const char *text, size_t length, lobe_rows *rows, char *error)
{
    error[0] = '\0';
    return lobe_rows_parse(text, length, "in", columns, 2, rows, error, 512);
}

static void taken(void **state)
{
    static const char text[] = "# head\n0.5 0.7\r\n\n  .25,1e0 # tail\n\t+0.125 , 5E-1\n1 1";
    static const double want[] = {0.5, 0.7, 0.25, 1, 0.125, 0.5, 1, 1};
    lobe_rows rows;
    char error[512];
    (void)state;
    assert_int_equal(parse(text, strlen(text), &rows, error), 0);
    assert_int_equal(rows.count, 4);
    assert_memory_equal(rows.values, want, sizeof want);
    lobe_rows_free(&rows);
    assert_int_equal(parse("", 0, &rows, error), 0);
    assert_int_equal(rows.count, 0);
    lobe_rows_free(&rows);
}

static void many(void **state)
{
    static char text[400000];
    size_t length = 0, i;
    lobe_rows rows;
    char error[512];
    (void)state;
    for (i = 0; i < 5000; i++)
        length += (size_t)sprintf(text + length, "%.17g %.17g\n", (double)(i + 6) / 5006,
                                  1.0 / (double)(i + 1) + 1e-3 * (i > 0));
    assert_int_equal(parse(text, length, &rows, error), 0);
    assert_int_equal(rows.count, 5000);
    for (i = 0; i < 5000; i++)
        assert_true(rows.values[2 * i] == (double)(i + 6) / 5006);
    lobe_rows_free(&rows);
}

static void refused(void **state)
{
    /* Line 2 of each is the bad one; what the message must name besides. */
    static const char *const bad[][2] = {
        {"0.5 0.5\nnan 0.5\n", "'nan'"},
        {"0.5 0.5\n0.5 inf\n", "'inf'"},
        {"0.5 0.5\n0.5 -Infinity\n", "'-Infinity'"},
        {"0.5 0.5\n0.5 word\n", "'word' is not a decimal number, allowed range [0.001, 1]"},
        {"0.5 0.5\n0.5\n", "1 number in the row, expected 2"},
        {"0.5 0.5\n0.5 0.5 0.5\n", "3 numbers in the row, expected 2"},
        {"0.5 0.5\n0x1p-1 0.5\n", "'0x1p-1'"},
        {"0.5 0.5\n0x 0.5\n", "'0x'"},
        {"0.5 0.5\n0.5 2.0\n", "n_dot_v '2.0' is out of its domain, allowed range [0.001, 1]"},
        {"0.5 0.5\n0 0.5\n", "roughness '0' is out of its domain, allowed range [0.001, 1]"},
        {"0.5 0.5\n0.5 -0.5\n", "'-0.5'"},
        {"0.5 0.5\n1e999 0.5\n", "'1e999'"},
        {"0.5 0.5\n1e-999 0.5\n", "'1e-999'"},
        {"0.5 0.5\n0.5,,0.5\n", "empty field"},
        {"0.5 0.5\n,0.5\n", "empty field"},
        {"0.5 0.5\n0.5 0.5,\n", "empty field"},
        {"0.5 0.5\n0.5 0.5e\n", "'0.5e'"},
        {"0.5 0.5\n0.5 --0.5\n", "'--0.5'"},
        {"0.5 0.5\n0.5 0.5.5\n", "'0.5.5'"},
        {"0.5 0.5\n0.5;0.5\n", "'0.5;0.5'"},
        {"0.5 0.5\n0.5 \x01\x02\n", "'\?\?'"},
        {"0.5 0.5\n0.5 0.50000000000000000000000000000000000000000000000000000000000000000000000000\n", "too long"},
    };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        lobe_rows rows;
        char error[512];
        assert_int_equal(parse(bad[i][0], strlen(bad[i][0]), &rows, error), 2);
        assert_int_equal(rows.count, 0);
        assert_null(rows.values);
        if (strncmp(error, "in:2: ", 6) != 0 || !strstr(error, bad[i][1]))
            fail_msg("'%s' does not name line 2 and %s", error, bad[i][1]);
    }
}

static void nul_byte(void **state)
{
    static const char text[] = "0.5 0.5\n0.5\0 0.5\n";
    lobe_rows rows;
    char error[512];
    (void)state;
    assert_int_equal(parse(text, sizeof text - 1, &rows, error), 2);
    assert_non_null(strstr(error, "in:2: "));
}

/* A message never runs over its buffer. */
static void short_buffer(void **state)
{
    char error[32];
    lobe_rows rows;
    size_t room;
    (void)state;
    for (room = 1; room <= 16; room++) {
        memset(error, 'x', sizeof error);
        assert_int_equal(lobe_rows_parse("0.5\n", 4, "in", columns, 2, &rows, error, room), 2);
        assert_true(memchr(error, '\0', room) != NULL);
        assert_int_equal(error[room], 'x');
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(taken),    cmocka_unit_test(many),         cmocka_unit_test(refused),
        cmocka_unit_test(nul_byte), cmocka_unit_test(short_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
