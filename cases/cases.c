#include "case.h"
#include <string.h>
#include "capsule_light/bounds.h"
#include "capsule_light/fit.h"
#include "capsule_light/front.h"
#include "capsule_light/tiers.h"
#include "capsule_light/truth_capsule.h"
#include "diffuse_sh/fit.h"
#include "diffuse_sh/tiers.h"
#include "diffuse_sh/truth_diffuse.h"
#include "energy/fit.h"
#include "energy/weight_vectors.h"
#include "env_lobes_sg/fit.h"
#include "env_lobes_sg/front.h"
#include "env_lobes/bounds.h"
#include "env_lobes/fit.h"
#include "env_lobes/front.h"
#include "env_lobes/truth_env_lobes.h"
#include "sg_light/bounds.h"
#include "sg_light/diffuse_case.h"
#include "sg_light/fit.h"
#include "sg_light/fit_diffuse.h"
#include "sg_light/front.h"
#include "sg_light/tiers.h"
#include "sg_light/truth_sg.h"
#include "sphere_diffuse/fit.h"
#include "sphere_diffuse/tiers.h"
#include "sphere_diffuse/truth_sphere_diffuse.h"
#include "sphere_light/bounds.h"
#include "sphere_light/fit.h"
#include "sphere_light/front.h"
#include "sphere_light/schlick_case.h"
#include "sphere_light/tiers.h"
#include "sphere_light/truth_sphere.h"
#include "split_sum/fit.h"
#include "split_sum/front.h"
#include "split_sum/tiers.h"
#include "split_sum/truth_split_sum.h"

#define ROUGHNESS_N_DOT_V                                                                                              \
    {                                                                                                                  \
        {"roughness", 0.001, 1.0}, { "n_dot_v", 0.001, 1.0 }                                                           \
    }

#define SPHERE_IN_VIEW                                                                                                 \
    {                                                                                                                  \
        {"roughness", 0.05, 1.0}, {"n_dot_v", 0.001, 1.0}, {"n_dot_l", -1.0, 1.0},                                     \
            {"azimuth", 0.0, 3.141592653589793},                                                                       \
        {                                                                                                              \
            "sigma", 0.0001, 1.570796326794896                                                                         \
        }                                                                                                              \
    }

static const lobe_case cases[] = {
    {.name = "split_sum",
     .integral = "scale, bias = int D V {1 - F, F} n.l dl, F = (1 - v.h)^5",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2",
     .accuracy = "2e-11",
     .input_count = 2,
     .output_count = 2,
     .inputs = ROUGHNESS_N_DOT_V,
     .outputs = {"scale", "bias"},
     .truth = lobe_truth_split_sum_rows,
     .fit = lobe_split_sum_fit,
     .search = lobe_front_search,
     .truth_opencl = lobe_truth_split_sum_opencl,
     .vectors = &lobe_split_sum_vectors},
    {.name = "split_sum_sep",
     .integral = "scale, bias = int D V {1 - F, F} n.l dl, F = (1 - v.h)^5",
     .brdf = "GGX, separable Smith, alpha = roughness^2",
     .accuracy = "2e-11",
     .input_count = 2,
     .output_count = 2,
     .inputs = ROUGHNESS_N_DOT_V,
     .outputs = {"scale", "bias"},
     .truth = lobe_truth_split_sum_sep_rows,
     .fit = lobe_split_sum_sep_fit,
     .search = lobe_front_search,
     .truth_opencl = lobe_truth_split_sum_sep_opencl,
     .vectors = &lobe_split_sum_vectors},
    {.name = "energy",
     .integral = "E = int D V n.l dl",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2",
     .accuracy = "2e-11",
     .input_count = 2,
     .output_count = 1,
     .inputs = ROUGHNESS_N_DOT_V,
     .outputs = {"E"},
     .truth = lobe_truth_energy_rows,
     .truth_opencl = lobe_truth_energy_opencl,
     .vectors = &lobe_split_sum_vectors,
     .fit = lobe_energy_fit},
    {.name = "diffuse_sh",
     .integral = "c_k = int f(v, l) n.l Y_k(l) dl, order 3, z = n, x towards v",
     .brdf = "Burley 2012, F90 = .5 + 2 roughness (l.h)^2, base colour 1",
     .accuracy = "2e-14",
     .input_count = 2,
     .output_count = 9,
     .inputs = {{"roughness", 0.0, 1.0}, {"n_dot_v", 0.0, 1.0}},
     .outputs = {"c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"},
     .truth = lobe_truth_diffuse_rows,
     .vectors = &lobe_diffuse_vectors,
     .fit = lobe_diffuse_fit,
     .bounds = lobe_diffuse_bounds},
    {.name = "sphere_light",
     .integral = "Lo = int D V n.l dl over the part above the horizon of a cone of half angle sigma; radiance 1",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
     .accuracy = "5e-7 relative",
     .input_count = 5,
     .output_count = 1,
     .inputs = SPHERE_IN_VIEW,
     .outputs = {"radiance"},
     .truth = lobe_truth_sphere_rows,
     .truth_opencl = lobe_truth_sphere_opencl,
     .vectors = &lobe_sphere_vectors,
     .fit = lobe_sphere_fit,
     .bounds = lobe_sphere_bounds,
     .search = lobe_sphere_front_search},
    {.name = "sphere_light_schlick",
     .integral = "s = int D V (1 - v.h)^5 n.l dl / int D V n.l dl over the part above the horizon of a cone of half "
                 "angle sigma: Lo at F0 is Lo(1) (F0 + (1 - F0) s)",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2",
     .accuracy = "1e-6 relative",
     .input_count = 5,
     .output_count = 1,
     .inputs = SPHERE_IN_VIEW,
     .outputs = {"schlick"},
     .truth = lobe_truth_sphere_schlick_rows,
     .refuse = lobe_truth_sphere_schlick_refusal,
     .vectors = &lobe_sphere_schlick_vectors,
     .bounds = lobe_sphere_schlick_bounds},
    {.name = "sphere_diffuse",
     .integral = "E / pi = int n.l / pi dl over the part above the horizon of a cone of half angle asin(sine)",
     .brdf = "Lambert, base colour 1",
     .accuracy = "2e-15",
     .input_count = 2,
     .output_count = 1,
     .inputs = {{"n_dot_l", -1.0, 1.0}, {"sine", 0.0, 1.0}},
     .outputs = {"irradiance"},
     .truth = lobe_truth_sphere_diffuse_rows,
     .vectors = &lobe_sphere_diffuse_vectors,
     .fit = lobe_sphere_diffuse_fit,
     .bounds = lobe_sphere_diffuse_bounds},
    {.name = "capsule_light",
     .integral = "Lo = int D V n.l dl over the part above the horizon of what a capsule covers; radiance 1",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
     .accuracy = "1e-6 relative",
     .input_count = 9,
     .output_count = 1,
     .inputs = {{"roughness", 0.05, 1.0},
                {"n_dot_v", 0.001, 1.0},
                {"mx", -1e6, 1e6},
                {"my", -1e6, 1e6},
                {"mz", -1e6, 1e6},
                {"ex", -1e6, 1e6},
                {"ey", -1e6, 1e6},
                {"ez", -1e6, 1e6},
                {"radius", 1e-9, 1e6}},
     .outputs = {"radiance"},
     .truth = lobe_truth_capsule_rows,
     .refuse = lobe_truth_capsule_row_refusal,
     .vectors = &lobe_capsule_vectors,
     .fit = lobe_capsule_fit,
     .bounds = lobe_capsule_bounds,
     .search = lobe_capsule_front_search},
    {.name = "env_lobes",
     .integral =
         "response = D G2 / (4 n.v), and times (1 - v.h)^5; lobes stand for its integral against an environment",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2",
     .accuracy = "1e-13 relative",
     .input_count = 4,
     .output_count = 2,
     .inputs = {{"roughness", 0.05, 1.0},
                {"n_dot_v", 0.001, 1.0},
                {"n_dot_l", 0.0, 1.0},
                {"azimuth", 0.0, 3.141592653589793}},
     .outputs = {"response", "response_schlick"},
     .truth = lobe_truth_env_lobes_rows,
     .vectors = &lobe_env_lobes_vectors,
     .fit = lobe_env_lobes_fit,
     .bounds = lobe_env_bounds,
     .search = lobe_env_lobes_search},
    {.name = "sg_light",
     .integral = "Lo = int exp(sharpness (l.axis - 1)) D V n.l dl over the upper hemisphere",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
     .accuracy = "1e-7 relative",
     .input_count = 5,
     .output_count = 1,
     .inputs = {{"roughness", 0.05, 1.0},
                {"n_dot_v", 0.001, 1.0},
                {"n_dot_l", -1.0, 1.0},
                {"azimuth", 0.0, 3.141592653589793},
                {"sharpness", 1.0, 65536.0}},
     .outputs = {"radiance"},
     .truth = lobe_truth_sg_rows,
     .vectors = &lobe_sg_vectors,
     .fit = lobe_sg_fit,
     .bounds = lobe_sg_bounds,
     .search = lobe_sg_front_search},
    {.name = "sg_diffuse",
     .integral = "E / pi = int exp((l.axis - 1) / versine) n.l / pi dl over the upper hemisphere",
     .brdf = "Lambert, base colour 1",
     .accuracy = "1e-9 of the light overhead",
     .input_count = 2,
     .output_count = 1,
     .inputs = {{"n_dot_l", -1.0, 1.0}, {"versine", LOBE_SG_DIFFUSE_VERSINE_LO, LOBE_SG_DIFFUSE_VERSINE_HI}},
     .outputs = {"irradiance"},
     .truth = lobe_truth_sg_diffuse_rows,
     .vectors = &lobe_sg_diffuse_vectors,
     .fit = lobe_sg_diffuse_fit,
     .bounds = lobe_sg_diffuse_bounds},
    {.name = "env_lobes_sg",
     .integral = "albedo = int D V n.l dl, what the lobes' weights sum to; the lobes are fitted to D V n.l itself",
     .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
     .accuracy = "2e-11",
     .input_count = 2,
     .output_count = 1,
     .inputs = ROUGHNESS_N_DOT_V,
     .outputs = {"albedo"},
     .truth = lobe_truth_energy_rows,
     .truth_opencl = lobe_truth_energy_opencl,
     .vectors = &lobe_env_lobes_sg_vectors,
     .fit = lobe_env_sg_fit,
     .bounds = lobe_env_bounds,
     .search = lobe_env_sg_search},
    {.name = "split_sum_kibl",
     .integral = "scale, bias = int D V {1 - F, F} n.l dl, F = (1 - v.h)^5",
     .brdf = "GGX, Schlick-Smith with k = alpha/2, alpha = roughness^2; a published formula was fitted to it",
     .accuracy = "2e-11",
     .input_count = 2,
     .output_count = 2,
     .inputs = ROUGHNESS_N_DOT_V,
     .outputs = {"scale", "bias"},
     .truth = lobe_truth_split_sum_kibl_rows,
     .truth_opencl = lobe_truth_split_sum_kibl_opencl},
};

const lobe_case *lobe_case_at(int i) { return i >= 0 && (size_t)i < sizeof cases / sizeof cases[0] ? &cases[i] : NULL; }

const lobe_case *lobe_case_find(const char *name)
{
    int i;
    for (i = 0; lobe_case_at(i); i++) {
        if (strcmp(cases[i].name, name) == 0)
            return &cases[i];
    }
    return NULL;
}
