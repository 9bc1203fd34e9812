/* Result files that appear whole or not at all, the progress line, and Ctrl-C. */
#include "../fit/atomic_file.h"
#include "../fit/interrupt.h"
#include "../fit/minimax.h"
#include "../fit/progress.h"

#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>

static char directory[64], path[96];

static int enter(void **state)
{
    (void)state;
    strcpy(directory, "lobe_files_XXXXXX");
    if (!mkdtemp(directory))
        return -1;
    snprintf(path, sizeof path, "%s/result", directory);
    FILE *f = fopen(path, "w");
    if (!f)
        return -1;
    fputs("old\n", f);
    return fclose(f);
}

static int leave(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(directory); /* fails where a temporary file was left behind */
}

static void expect(const char *text)
{
    char got[32] = "";
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    got[fread(got, 1, sizeof got - 1, f)] = 0;
    fclose(f);
    assert_string_equal(got, text);
}

static void commit_replaces_and_abandon_leaves(void **state)
{
    lobe_atomic_file file;
    (void)state;
    assert_true(lobe_atomic_open(&file, path));
    fputs("half", file.stream);
    expect("old\n"); /* nothing shows before the end */
    lobe_atomic_abandon(&file);
    expect("old\n");
    assert_true(lobe_atomic_open(&file, path));
    fputs("new\n", file.stream);
    assert_true(lobe_atomic_commit(&file));
    expect("new\n");
}

static void failed_write_leaves_the_old_file(void **state)
{
    lobe_atomic_file file;
    (void)state;
    assert_true(lobe_atomic_open(&file, path));
    /* A full disk, as the stream sees it: writes go to a device that refuses them. */
    assert_non_null(freopen("/dev/full", "w", file.stream));
    fputs("new\n", file.stream);
    assert_false(lobe_atomic_commit(&file));
    expect("old\n");
    assert_false(lobe_atomic_open(&file, "no/such/directory/result"));
}

/* a exp(b t) against a line: more than one step to fit; the fifth call comes with a Ctrl-C. */
static void curve(void *ctx, const double *params, size_t count, double *values)
{
    int *calls = ctx;
    if (++*calls == 5)
        raise(SIGINT);
    for (size_t i = 0; i < count; i++)
        for (size_t r = 0; r < 50; r++)
            values[i * 50 + r] = params[2 * i] * exp(params[2 * i + 1] * (double)r / 50.0) - (double)r;
}

static void ctrl_c_ends_a_fit_between_batches(void **state)
{
    int calls = 0;
    const lobe_residuals residuals = {curve, NULL, &calls, 2, 50, NULL, NULL, NULL};
    lobe_progress_line line = lobe_progress_line_default();
    lobe_minimax_options o = lobe_minimax_default();
    double x[2] = {1.0, 1.0};
    (void)state;
    o.progress = lobe_progress_print;
    o.progress_ctx = &line;
    assert_true(lobe_interrupt_install());
    const lobe_minimax_result r = lobe_minimax(&residuals, &o, x);
    assert_int_equal(r.fit.status, LOBE_FIT_INTERRUPTED);
    assert_true(calls >= 5 && calls <= 8);
    assert_true(r.fit.value < 49.0 - exp(1.0) + 2.0); /* not worse than the start */
    lobe_interrupt_clear();
    assert_false(lobe_interrupt_requested());
    signal(SIGINT, SIG_DFL);
}

static void progress_line_has_rate_and_estimate_and_is_rare(void **state)
{
    char text[512] = "";
    lobe_progress_line line = lobe_progress_line_default();
    lobe_progress progress = {"search", 0, 1000, 0.5};
    (void)state;
    assert_null(line.out); /* silent unless asked */
    line.out = tmpfile();
    assert_non_null(line.out);
    for (size_t i = 0; i < 100; i++) {
        progress.evaluations = i;
        assert_true(lobe_progress_print(&line, &progress));
    }
    assert_int_equal(ftell(line.out), 0); /* a hundred calls in no time: nothing yet */
    line.interval_s = 0.0;
    lobe_progress_print(&line, &progress);
    lobe_progress_finish(&line);
    rewind(line.out);
    text[fread(text, 1, sizeof text - 1, line.out)] = 0;
    fclose(line.out);
    assert_non_null(strstr(text, "search: 99 of at most 1000 evaluations"));
    assert_non_null(strstr(text, "/s"));
    assert_non_null(strstr(text, "s left"));
    assert_true(text[strlen(text) - 1] == '\n');
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(commit_replaces_and_abandon_leaves, enter, leave),
        cmocka_unit_test_setup_teardown(failed_write_leaves_the_old_file, enter, leave),
        cmocka_unit_test(ctrl_c_ends_a_fit_between_batches),
        cmocka_unit_test(progress_line_has_rate_and_estimate_and_is_rare),
    };
    return cmocka_run_group_tests_name("result files and progress", tests, NULL, NULL);
}
