/* The parser of vector files: reads what is right, and refuses what is wrong at its line. */
#include "../hash.h"
#include "../vec_file.h"
#include "cmocka_first.h"
#include <stdlib.h>
#include <string.h>

#define HEAD_TO(bound)                                                                                                 \
    "# model: split_sum\n# tier: low\n# format: f32\n# inputs: roughness n_dot_v\n# outputs: scale bias\n"             \
    "# brdf: GGX\n# domain: [0.02, 1]\n# truth: by hand, exact\n# bound_max: " bound                                   \
    "\n# command: none\n# seed: 0\n# bound_rms: 0.05\n"
#define HEAD HEAD_TO("0.1")
#define ROWS "0.5 0.25 0.75 0.125\n1 0.5 0.3 0.1\n"

enum { HEAD_LINES = 13 };

/* A file of head, digest and rows, with the digest that the rows have. Returns its length. */
static size_t seal(char *text, size_t size, const char *head, const char *rows, size_t rows_length)
{
    const unsigned long long digest = lobe_fnv1a(LOBE_FNV_START, rows, rows_length);
    const int length = snprintf(text, size, "%s# digest: %016llx\n", head, digest);
    assert_true(length > 0 && (size_t)length + rows_length < size);
    memcpy(text + length, rows, rows_length);
    return (size_t)length + rows_length;
}

/* Parses a copy of exactly that many bytes, so that a sanitizer sees any step beyond them. */
static int parse(const char *text, size_t length, lobe_vec_file *file, lobe_vec_error *error)
{
    char *copy = malloc(length ? length : 1);
    int good;
    assert_non_null(copy);
    memcpy(copy, text, length);
    good = lobe_vec_parse(copy, length, file, error);
    free(copy);
    return good;
}

static void reads_a_good_file(void **state)
{
    char text[4096];
    lobe_vec_file file;
    lobe_vec_error error;
    const size_t length =
        seal(text, sizeof text, HEAD "# a comment\n# note: other keys are allowed\n", ROWS, strlen(ROWS));
    (void)state;
    if (!parse(text, length, &file, &error))
        fail_msg("line %zu: %s", error.line, error.reason);
    assert_string_equal(file.vectors.model, "split_sum");
    assert_string_equal(file.vectors.tier, "low");
    assert_string_equal(file.key[LOBE_KEY_TRUTH], "by hand, exact");
    assert_int_equal(file.vectors.format, LOBE_F32);
    assert_int_equal(file.vectors.rows, 2);
    assert_int_equal(file.vectors.in[0], 0x3f000000);
    assert_int_equal(file.vectors.in[2], 0x3f800000);
    assert_true(file.vectors.truth[3] == 0.1);
    assert_true(file.vectors.bound_max == 0.1);
    lobe_vec_free(&file);
}

static void reads_q30(void **state)
{
    static const char head[] =
        "# model: energy\n# tier: low\n# format: q30\n# inputs: roughness n_dot_v\n# outputs: E\n"
        "# brdf: GGX\n# domain: all\n# truth: t\n# bound_max: 1e-3\n# bound_rms: 1e-4\n# command: c\n"
        "# seed: 1\n";
    static const char rows[] = "0.5, 1 0x1p-1 # behind a row\n# a comment among the rows\n\n";
    char text[4096];
    lobe_vec_file file;
    lobe_vec_error error;
    (void)state;
    if (!parse(text, seal(text, sizeof text, head, rows, strlen(rows)), &file, &error))
        fail_msg("line %zu: %s", error.line, error.reason);
    assert_int_equal(file.vectors.rows, 1);
    assert_int_equal(file.vectors.in[0], 1 << 29);
    assert_int_equal(file.vectors.in[1], 1 << 30);
    assert_true(file.vectors.truth[0] == 0.5);
    lobe_vec_free(&file);
}

/* head and rows are sealed, then refused at that line for a reason that has these words. */
static void refuse(const char *head, const char *rows, size_t rows_length, size_t line, const char *words)
{
    static char text[1 << 16];
    lobe_vec_file file;
    lobe_vec_error error = {0, ""};
    const size_t length = seal(text, sizeof text, head, rows, rows_length);
    if (parse(text, length, &file, &error))
        fail_msg("accepted, should say '%s'", words);
    if (error.line != line || !strstr(error.reason, words))
        fail_msg("line %zu: '%s', expected line %zu: '%s'", error.line, error.reason, line, words);
}

static void refuses_bad_rows(void **state)
{
    static char long_line[2 * LOBE_VEC_LINE_MAX];
    static const struct {
        const char *rows;
        size_t line;
        const char *words;
    } cases[] = {
        {"0.5 0.25 0.75\n", 1, "3 numbers, 4 are needed"},
        {ROWS "0.5 0.25 0.75 0.125 1\n", 3, "more than 4 numbers"},
        {ROWS "0.5 0.25 x 0.125\n", 3, "'x' is not a number"},
        {"0.5 0.25 0.75e 0.125\n", 1, "'0.75e' is not a number"},
        {"0.5 0.25 0.75 0x\n", 1, "'0x' is not a number"},
        {"0.5 0.25 0.75 nan\n", 1, "a truth is finite"},
        {"0.5 0.25 1e999 0.5\n", 1, "a truth is finite"},
        {"nan 0.25 0.75 0.5\n", 1, "is not exact in f32"},
        {"0.5 inf 0.75 0.5\n", 1, "is not exact in f32"},
        {"0.1 0.25 0.75 0.5\n", 1, "is not exact in f32"},
        {"0.5,,0.25 0.75 0.5\n", 1, "nothing stands after a comma"},
        {",0.5 0.25 0.75 0.5\n", 1, "nothing stands before a comma"},
        {"0.5 0.25 0.75 0.5,\n", 1, "nothing stands after a comma"},
        {"0.5 0.25 0.75 0.5", 1, "does not end"},
        {ROWS "0.5 0.25", 3, "does not end"},
        {"\n\n# nothing\n", 3, "without rows"},
        {"", 0, "without rows"},
    };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++)
        refuse(HEAD, cases[i].rows, strlen(cases[i].rows), HEAD_LINES + cases[i].line, cases[i].words);
    refuse(HEAD, "0.5 \0 0.25 1 1\n", 15, HEAD_LINES + 1, "NUL");
    memset(long_line, ' ', sizeof long_line);
    long_line[sizeof long_line - 2] = '\n';
    refuse(HEAD, long_line, sizeof long_line - 1, HEAD_LINES + 1, "a line of");
    memset(long_line, '1', 100);
    refuse(HEAD, long_line, sizeof long_line - 1, HEAD_LINES + 1, "a line of");
    long_line[200] = '\n';
    refuse(HEAD, long_line, 201, HEAD_LINES + 1, "is not a number");
}

static void refuses_bad_heads(void **state)
{
    static const char *const keys[] = {"model",  "tier",  "format",    "inputs",  "outputs", "brdf",
                                       "domain", "truth", "bound_max", "command", "seed"};
    char head[2048], wanted[64];
    size_t i;
    (void)state;
    for (i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        char *at;
        strcpy(head, HEAD);
        snprintf(wanted, sizeof wanted, "# %s:", keys[i]);
        at = strstr(head, wanted);
        assert_non_null(at);
        at[2] = 'z'; /* now another key */
        snprintf(wanted, sizeof wanted, "without the key '%s'", keys[i]);
        refuse(head, ROWS, strlen(ROWS), HEAD_LINES, wanted);
        at[2] = keys[i][0];
        at = strchr(at, ':') + 1;
        memset(at, ' ', strcspn(at, "\n"));
        snprintf(wanted, sizeof wanted, "'%s' has no value", keys[i]);
        refuse(head, ROWS, strlen(ROWS), i + 1, wanted);
    }
    refuse(HEAD "# tier: high\n", ROWS, strlen(ROWS), 13, "the key 'tier' again; line 2 has it");
    refuse(HEAD_TO("0"), ROWS, strlen(ROWS), 9, "not a number above 0");
    refuse(HEAD_TO("-1"), ROWS, strlen(ROWS), 9, "not a number above 0");
    refuse(HEAD_TO("nan"), ROWS, strlen(ROWS), 9, "not a number above 0");
    refuse(HEAD_TO("inf"), ROWS, strlen(ROWS), 9, "not a number above 0");
    refuse(HEAD_TO("0.1 0.2"), ROWS, strlen(ROWS), 9, "not a number above 0");
}

static void refuses_other_files(void **state)
{
    char text[4096];
    lobe_vec_file file;
    lobe_vec_error error;
    size_t length, cut;
    (void)state;
    assert_false(parse("", 0, &file, &error));
    assert_int_equal(error.line, 1);
    assert_false(parse("hello\n", 6, &file, &error));
    assert_int_equal(error.line, 1);
    length = seal(text, sizeof text, HEAD, ROWS, strlen(ROWS));
    for (cut = 0; cut < length; cut++) /* a file cut anywhere is refused: the digest sees to it */
        if (parse(text, cut, &file, &error))
            fail_msg("accepted after %zu of %zu bytes", cut, length);
    text[length - 2] = '2';
    assert_false(parse(text, length, &file, &error));
    assert_int_equal(error.line, HEAD_LINES);
    assert_non_null(strstr(error.reason, "digest"));
    assert_false(lobe_vec_load("no such file.vec", &file, &error));
    assert_non_null(strstr(error.reason, "cannot be opened"));
}

/* FNV-1a 64 as its authors publish it (Fowler, Noll, Vo: test vectors of the reference code). */
static void digest_is_fnv1a(void **state)
{
    (void)state;
    assert_true(lobe_fnv1a(LOBE_FNV_START, "", 0) == UINT64_C(0xcbf29ce484222325));
    assert_true(lobe_fnv1a(LOBE_FNV_START, "a", 1) == UINT64_C(0xaf63dc4c8601ec8c));
    assert_true(lobe_fnv1a(LOBE_FNV_START, "foobar", 6) == UINT64_C(0x85944171f73967e8));
    assert_true(lobe_fnv1a_word(LOBE_FNV_START, 0x64636261) == lobe_fnv1a(LOBE_FNV_START, "abcd", 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_a_good_file), cmocka_unit_test(reads_q30),           cmocka_unit_test(refuses_bad_rows),
        cmocka_unit_test(refuses_bad_heads), cmocka_unit_test(refuses_other_files), cmocka_unit_test(digest_is_fnv1a),
    };
    return cmocka_run_group_tests_name("vec_file", tests, NULL, NULL);
}
