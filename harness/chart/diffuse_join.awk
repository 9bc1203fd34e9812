# Joins the errors of diffuse_sh and instruction counts into the table that its chart is drawn from.
# Usage: awk -f diffuse_join.awk x86.csv m4f.csv m0.csv errors.csv
BEGIN {
    FS = OFS = ","
    print "model,name,format,kind,title,operations,light_rms,light_max,furnace_rms,furnace_max,x86_instructions," \
          "m4f_instructions,m0_instructions,x86_radiance,m4f_radiance,m0_radiance"
}
FILENAME != last { file++; last = FILENAME }
file < 4 {
    if (FNR > 1)
        count[file, $1, $2, $3] = $4
    next
}
{
    line = $0
    for (i = 1; i <= 3; i++)
        line = line OFS count[i, $1, $2, $3]
    for (i = 1; i <= 3; i++)
        line = line OFS ($1 == "peer" ? count[i, $1, $2 "_radiance", $3] : count[i, $1 "_radiance", $2, $3])
    print line
}
