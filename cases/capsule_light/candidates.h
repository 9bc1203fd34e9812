/* Every form of this folder in double behind one signature. */
#ifndef LOBE_CAPSULE_LIGHT_CANDIDATES_H
#define LOBE_CAPSULE_LIGHT_CANDIDATES_H

typedef struct lobe_capsule_candidate {
    const char *name;
    double (*call)(const double *row); /* a row of the cells */
} lobe_capsule_candidate;

/* The i-th, or NULL past the end. */
const lobe_capsule_candidate *lobe_capsule_candidate_at(int i);

#endif
