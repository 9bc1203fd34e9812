/* Every form of this folder in double behind one signature: the punctual light, the published forms, ours. */
#ifndef LOBE_SG_LIGHT_CANDIDATES_H
#define LOBE_SG_LIGHT_CANDIDATES_H

typedef struct lobe_sg_candidate {
    const char *name;
    double (*call)(const double row[5]); /* a row of lobe_truth_sg_rows */
} lobe_sg_candidate;

/* The i-th, or NULL past the end. The first is the punctual light. */
const lobe_sg_candidate *lobe_sg_candidate_at(int i);

#endif
