/* Every form of this folder in double behind one signature: the punctual light, the published forms, ours. */
#ifndef LOBE_SPHERE_LIGHT_CANDIDATES_H
#define LOBE_SPHERE_LIGHT_CANDIDATES_H

typedef struct lobe_sphere_candidate {
    const char *name;
    double (*call)(const double row[5]); /* a row of lobe_truth_sphere_rows */
    int bytes;                           /* of its table */
} lobe_sphere_candidate;

/* The i-th, or NULL past the end. The first is the punctual light. */
const lobe_sphere_candidate *lobe_sphere_candidate_at(int i);

#endif
