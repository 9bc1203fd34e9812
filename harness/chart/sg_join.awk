# The rows of cases/sg_light/front.csv that the chart of sg_light is drawn from: cells that no fit has seen.
BEGIN {
    FS = OFS = ","
    print "name,kind,title,operations,positions,all,smooth,worst_cell,worst_energy"
}
FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
$at["cells"] == "held" {
    form = $at["form"]
    kind = form ~ /^(low|medium|high)$/ ? "tier" : form == "point" ? "point" : "star"
    print tolower(form), kind, form, $at["operations"], $at["positions"], $at["all"], $at["smooth"], $at["worst_cell"], \
          $at["worst_energy"]
}
