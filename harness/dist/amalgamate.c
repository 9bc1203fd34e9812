/* Makes one file of many: copies each named file, with every `#include "..."` replaced by the text of the
 * file it names, once. System includes stay where they are.
 *
 *   amalgamate [-k HEADER]... [-t TEXT]... -o OUT FILE...
 *
 * -k keeps the include of a file of that base name as it is (a drop-in's own header), once.
 * -t puts a file in front as a comment (the licence). The output depends on the inputs only. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FILES = 512, MAX_PATH = 1024, MAX_LINE = 4096 };

static char seen[MAX_FILES][MAX_PATH];
static int n_seen;
static const char *keep[MAX_FILES];
static int n_keep;

static int fail(const char *path, int line, const char *why)
{
    if (line)
        fprintf(stderr, "amalgamate: %s:%d: %s\n", path, line, why);
    else
        fprintf(stderr, "amalgamate: %s: %s\n", path, why);
    return 2;
}

/* Resolves "." and "a/.." in place, so that two ways to one file are one name. */
static void normalise(char *path)
{
    char *parts[MAX_PATH / 2];
    char copy[MAX_PATH];
    int n = 0, i;
    char *p;
    strcpy(copy, path);
    for (p = strtok(copy, "/"); p; p = strtok(NULL, "/")) {
        if (strcmp(p, ".") == 0)
            continue;
        if (strcmp(p, "..") == 0 && n > 0 && strcmp(parts[n - 1], "..") != 0)
            n--;
        else
            parts[n++] = p;
    }
    *(path[0] == '/' ? path + 1 : path) = 0;
    for (i = 0; i < n; i++) {
        if (i > 0)
            strcat(path, "/");
        strcat(path, parts[i]);
    }
}

/* 1 if the name is new, 0 if it was there, -1 if there is no room. */
static int remember(const char *path)
{
    int i;
    for (i = 0; i < n_seen; i++)
        if (strcmp(seen[i], path) == 0)
            return 0;
    if (n_seen == MAX_FILES)
        return -1;
    strcpy(seen[n_seen++], path);
    return 1;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static int is_kept(const char *path)
{
    int i;
    for (i = 0; i < n_keep; i++)
        if (strcmp(keep[i], base_name(path)) == 0)
            return 1;
    return 0;
}

/* The name inside `#include "name"`, or NULL when the line is something else. */
static char *included_name(char *line)
{
    char *p = line + strspn(line, " \t");
    char *end;
    if (*p++ != '#')
        return NULL;
    p += strspn(p, " \t");
    if (strncmp(p, "include", 7) != 0)
        return NULL;
    p += 7;
    p += strspn(p, " \t");
    if (*p++ != '"')
        return NULL;
    end = strchr(p, '"');
    if (!end)
        return NULL;
    *end = 0;
    return p;
}

static int copy_file(FILE *out, const char *path, int depth);

static int copy_include(FILE *out, const char *from, int line, const char *name, int depth)
{
    char path[MAX_PATH];
    const size_t folder = (size_t)(base_name(from) - from);
    int is_new;
    if (folder + strlen(name) >= MAX_PATH)
        return fail(from, line, "the path of an include is too long");
    memcpy(path, from, folder);
    strcpy(path + folder, name);
    normalise(path);
    is_new = remember(path);
    if (is_new < 0)
        return fail(from, line, "more than 512 files");
    if (!is_new)
        return 0;
    if (is_kept(path)) {
        fprintf(out, "#include \"%s\"\n", base_name(path));
        return 0;
    }
    return copy_file(out, path, depth + 1);
}

static int copy_file(FILE *out, const char *path, int depth)
{
    char line[MAX_LINE], copy[MAX_LINE];
    int number = 0, status = 0;
    FILE *in = depth < 32 ? fopen(path, "r") : NULL;
    if (!in)
        return fail(path, 0, depth < 32 ? strerror(errno) : "includes nest deeper than 32");
    fprintf(out, "\n/* ---- %s ---- */\n", path);
    while (!status && fgets(line, sizeof line, in)) {
        char *name;
        number++;
        if (!strchr(line, '\n')) {
            status = fail(path, number, "a line longer than 4094 characters, or a last line without its end");
            break;
        }
        strcpy(copy, line);
        name = included_name(copy);
        if (name)
            status = copy_include(out, path, number, name, depth);
        else
            fputs(line, out);
    }
    if (!status && ferror(in))
        status = fail(path, 0, "cannot be read");
    fclose(in);
    return status;
}

static int copy_comment(FILE *out, const char *path)
{
    char line[MAX_LINE];
    FILE *in = fopen(path, "r");
    if (!in)
        return fail(path, 0, strerror(errno));
    fputs("/*\n", out);
    while (fgets(line, sizeof line, in)) {
        fputs(line[0] == '\n' ? " *" : " * ", out);
        fputs(line, out);
    }
    fputs(" */\n", out);
    fclose(in);
    return 0;
}

static int usage(FILE *to)
{
    fputs("usage: amalgamate [-k HEADER]... [-t TEXT]... -o OUT FILE...\n", to);
    return to == stdout ? 0 : 2;
}

int main(int argc, char **argv)
{
    const char *text[16], *target = NULL;
    char temporary[MAX_PATH], path[MAX_PATH];
    int n_text = 0, i, status = 0;
    FILE *out;
    for (i = 1; i < argc && argv[i][0] == '-'; i++) {
        if (strcmp(argv[i], "-h") == 0)
            return usage(stdout);
        if (i + 1 == argc || strlen(argv[i]) != 2)
            return usage(stderr);
        if (argv[i][1] == 'k' && n_keep < MAX_FILES)
            keep[n_keep++] = argv[++i];
        else if (argv[i][1] == 't' && n_text < 16)
            text[n_text++] = argv[++i];
        else if (argv[i][1] == 'o')
            target = argv[++i];
        else
            return usage(stderr);
    }
    if (!target || i == argc || strlen(target) + 5 > sizeof temporary)
        return usage(stderr);
    sprintf(temporary, "%s.new", target);
    out = fopen(temporary, "w");
    if (!out)
        return fail(temporary, 0, strerror(errno));
    for (int t = 0; t < n_text && !status; t++)
        status = copy_comment(out, text[t]);
    for (; i < argc && !status; i++) {
        if (strlen(argv[i]) >= sizeof path) {
            status = fail(argv[i], 0, "the path is too long");
            break;
        }
        strcpy(path, argv[i]);
        normalise(path);
        if (remember(path) > 0)
            status = copy_file(out, path, 0);
    }
    if (fclose(out) && !status)
        status = fail(temporary, 0, strerror(errno));
    if (!status && rename(temporary, target))
        status = fail(target, 0, strerror(errno));
    if (status)
        remove(temporary);
    return status;
}
