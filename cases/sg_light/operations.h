/* Operations of the forms beyond a punctual light, as cases/fit/trace.h counts them: of ours from their text. */
#ifndef LOBE_SG_LIGHT_OPERATIONS_H
#define LOBE_SG_LIGHT_OPERATIONS_H
#ifdef __cplusplus
extern "C" {
#endif

/* -1: not counted. */
int lobe_sg_operations(const char *name);

/* Of the tiers high and inner of models/sg_diffuse.h, from their inputs. */
int lobe_sg_diffuse_operations(const char *tier);

#ifdef __cplusplus
}
#endif
#endif
