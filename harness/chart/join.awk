# Joins errors and instruction counts into the table that the chart is drawn from.
# Usage: awk -f join.awk x86.csv m4f.csv m0.csv errors.csv
BEGIN {
    FS = OFS = ","
    print "brdf,name,format,kind,fitted,title,operations,bytes,max,max_scale,max_bias,max_e,rms_scale,rms_bias," \
          "rms_e,x86_instructions,m4f_instructions,m0_instructions"
}
FILENAME != last { file++; last = FILENAME }
file < 4 {
    if (FNR > 1)
        count[file, $1, $2, $3] = $4
    next
}
{
    # the furnace is of 1/E; in fixed point only E is counted, one reciprocal less
    model = $4 == "star" ? "peer" : $1 == "energy" && $3 == "f32" ? "energy_inverse" : $1
    line = $0
    for (i = 1; i <= 3; i++)
        line = line OFS ((i, model, $2, $3) in count ? count[i, model, $2, $3] : "")
    print line
}
