#include "fit.h"
#include "../fit/fit_command.h"
#include "form_fit.h"
#include "table_fit.h"

#define COUNT(list) ((int)(sizeof(list) / sizeof(list)[0]))

/* A new tier is a line here. */
int lobe_split_sum_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier tiers[] = {{"low", lobe_fit_split_sum_low},   {"medium", lobe_fit_split_sum_medium},
                                          {"high", lobe_fit_split_sum_high}, {"table32", lobe_table_fit_32},
                                          {"table64", lobe_table_fit_64},    {"table128", lobe_table_fit_128}};
    return lobe_fit_command(self, tiers, COUNT(tiers), argc, argv);
}

int lobe_split_sum_sep_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier tiers[] = {
        {"low", lobe_fit_split_sum_sep_low},   {"medium", lobe_fit_split_sum_sep_medium},
        {"high", lobe_fit_split_sum_sep_high}, {"table32", lobe_table_fit_32},
        {"table64", lobe_table_fit_64},        {"table128", lobe_table_fit_128}};
    return lobe_fit_command(self, tiers, COUNT(tiers), argc, argv);
}
