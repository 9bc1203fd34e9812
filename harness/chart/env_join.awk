# Joins what fans of taps cost and what the offline side found them to miss into the table that the chart of env_lobes is
# drawn from. Errors are parts of the split sum's on the same environments, so that the two models' may stand together.
# Usage: awk -f env_join.awk costs.csv cases/env_lobes/front.csv cases/env_lobes_sg/front.csv
BEGIN {
    FS = OFS = ","
    print "model,name,kind,title,operations,lookups,relative,rms,shape"
}
FILENAME != last { file++; last = FILENAME }
file == 1 {
    operations[$1, $2] = $3
    lookups[$1, $2] = $4
    next
}
/^#/ { next }
# A name that ships has its costs from the library; of the others, each but the seed's fan is one lookup.
function row(model, name, relative, rms, shape,    kind, title, ops, taps) {
    kind = (model, name) in operations ? (name ~ /table/ ? "table" : name ~ /adaptive/ ? "adaptive" : "tier") : "star"
    ops = operations[model, name]
    taps = kind == "star" ? (name ~ /seed paper/ ? 8 : 1) : lookups[model, name]
    title = name == "asg" ? "one ASG" : name
    print model, name, kind, title, ops, taps, relative, rms, shape
}
file == 2 && $1 == "all" { order[++n] = $2; relative[$2] = $4; rms[$2] = $6 }
file == 2 && $1 == "shape" { shape[$2] = $3 }
# "seed paper's two layers, refitted" has a comma of its own
file == 3 {
    if (sub(/,refitted|, refitted/, " refitted"))
        $0 = $0
    if ($1 == "env_lobes_sg") {
        m++
        sg[m] = "lobes" $2; sg_rms[m] = $4; sg_shape[m] = $5
    } else if ($1 ~ /seed/) {
        m++
        sg[m] = $1; sg_rms[m] = $4; sg_shape[m] = $5
    }
}
END {
    for (i = 1; i <= n; i++)
        row("env_lobes", order[i], relative[order[i]], rms[order[i]], shape[order[i]])
    for (i = 1; i <= m; i++)
        row("env_lobes_sg", sg[i], "", sg_rms[i], sg_shape[i])
}
