/* Reads a .vec file: head lines `# key: value`, then a row a case, inputs first and true outputs after. The
 * head is every line up to the first that does not start with '#'; the digest is of all bytes behind it.
 * The text is not trusted: every refusal names its line and its reason. */
#ifndef LOBE_VEC_FILE_H
#define LOBE_VEC_FILE_H
#include "conform_core.h"
#include "rows.h"

enum {
    LOBE_VEC_LINE_MAX = 1024,     /* bytes in a line */
    LOBE_VEC_ROWS_MAX = 4000000,  /* rows in a file */
    LOBE_VEC_FILE_MAX = 268435456 /* bytes in a file */
};

typedef enum lobe_vec_key {
    LOBE_KEY_MODEL,
    LOBE_KEY_TIER,
    LOBE_KEY_FORMAT,
    LOBE_KEY_INPUTS,
    LOBE_KEY_OUTPUTS,
    LOBE_KEY_BRDF,
    LOBE_KEY_DOMAIN,
    LOBE_KEY_TRUTH,
    LOBE_KEY_BOUND_MAX,
    LOBE_KEY_COMMAND,
    LOBE_KEY_SEED,
    LOBE_KEY_DIGEST,
    LOBE_KEY_BOUND_RMS, /* from here on a file may do without */
    LOBE_KEY_BOUND_FURNACE,
    LOBE_VEC_KEYS,
    LOBE_VEC_KEYS_NEEDED = LOBE_KEY_BOUND_RMS
} lobe_vec_key;

typedef struct lobe_vec_file {
    char *key[LOBE_VEC_KEYS]; /* the values of the head */
    lobe_vectors vectors;     /* points into the storage below */
    uint32_t *in;
    double *truth;
} lobe_vec_file;

typedef struct lobe_vec_error {
    size_t line; /* from 1; 0 where the file as a whole is meant */
    char reason[LOBE_REASON_SIZE];
} lobe_vec_error;

/* Parses text of that length, which may hold anything, NUL bytes too. Returns 1, or 0 with the error and
 * nothing to free. */
int lobe_vec_parse(const char *text, size_t length, lobe_vec_file *file, lobe_vec_error *error);

/* The same for a file of that name. */
int lobe_vec_load(const char *path, lobe_vec_file *file, lobe_vec_error *error);

/* Prints the error as `path:line: reason` on standard error. */
void lobe_vec_complain(const char *path, const lobe_vec_error *error);

void lobe_vec_free(lobe_vec_file *file);

/* 1 where the columns are those of the entry; else 0 with the reason. Names may be parted by commas too. */
int lobe_vec_fits(const lobe_vec_file *file, const lobe_entry *entry, lobe_vec_error *error);

#endif
