/* Coefficients of form_capsule.h, fitted by random descent in double; the program was an exploration and is not here. */
#ifndef LOBE_SPHERE_LIGHT_FORMS_COEFFICIENTS_H
#define LOBE_SPHERE_LIGHT_FORMS_COEFFICIENTS_H
#define LOBE_CAPSULE_C0 LOBE_R(0.618561278)
#define LOBE_CAPSULE_C1 LOBE_R(-0.0799356733)
#define LOBE_CAPSULE_C2 LOBE_R(1.83765011)
#define LOBE_CAPSULE_C3 LOBE_R(0.485308753)
#endif
