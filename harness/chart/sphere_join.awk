# Joins the errors of what ships, those of the published forms and instruction counts into the table that the chart of
# sphere_light is drawn from. A published form has its errors and operations from the offline side, in double.
# Usage: awk -f sphere_join.awk x86.csv m4f.csv m0.csv front.csv errors.csv
BEGIN {
    FS = OFS = ","
    print "name,format,kind,title,operations,bytes,positions,all,view60,view75,worst,energy,small_over_point," \
          "x86_instructions,m4f_instructions,m0_instructions"
}
FILENAME != last { file++; last = FILENAME }
file < 4 {
    if (FNR > 1)
        count[file, $1, $2, $3] = $4
    next
}
file == 4 {
    # ours come from the errors, of the formats that ship
    if ($1 != "held" || $3 == "low" || $3 == "medium" || $3 == "high")
        next
    kind = $3 == "point" ? "point" : $5 > 0 ? "table" : "star"
    line = tolower($3) OFS "double" OFS kind OFS $3 OFS $4 OFS $5 OFS $2
    for (i = 6; i <= 11; i++)
        line = line OFS $i
    print line ",,,"
    next
}
{
    line = $0
    for (i = 1; i <= 3; i++)
        line = line OFS count[i, "sphere_light", $1, $2]
    print line
}
