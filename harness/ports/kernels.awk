# Finds the kernels of the f32 tiers, and writes each as a program for a device.
#
#   awk -v want=list|glsl|cl|c [-v kernel=NAME] -f kernels.awk harness/registry_rows.h HEADER...
#
# A kernel is a LOBE_FN named lobe_MODEL_TIER, or as the fourth column says, where the registry (the first file) has a row
# of that model and tier in f32, and its results all members of what it returns, or of LIT rows the registry's one; its
# inputs are scalars, or a struct S that LOBE_FN S_of makes of scalars, which are then the inputs. Tables have no kernel:
# they are texture fetches; nor has a tier without inputs, a constant.
#   list  a line a kernel: name, number of inputs, number of outputs
#   glsl  main of a compute shader for `kernel`; cl: an OpenCL kernel `run`; both go behind the shader text
#   c     host wrappers over arrays and a table of them

FNR == 1 { file++ }

file == 1 {
    if (match($0, /^[A-Z0-9_]+_F32\([a-z0-9_]+, *[a-z0-9_]+/)) {
        row = row_kind = $0
        sub(/\(.*/, "", row_kind)
        sub(/^[A-Z0-9_]+\(/, "", row)
        split(row, word, /, */)
        sub(/\).*/, "", word[4])
        name = word[4] != "" ? word[4] : "lobe_" word[1] "_" word[2]
        registered[name] = 1
        if (row_kind == "LIT_F32")
            only[name] = "schlick"
    }
    next
}
# Comments and line ends go, so that a declaration is one piece of text.
{ sub(/\/\/.*/, ""); text = text $0 " " }

function uncomment(s,    from, to, out) {
    out = ""
    while ((from = index(s, "/*")) > 0) {
        out = out substr(s, 1, from - 1)
        s = substr(s, from + 2)
        to = index(s, "*/")
        s = to ? substr(s, to + 2) : ""
    }
    return out s
}

# A struct's scalars: a member that is a struct, which stands before, adds its own.
function find_structs(s,    name, body, n, i, k, part, word, type) {
    while (match(s, /LOBE_STRUCT\([a-z0-9_]+\)[ ]*\{[^}]*\}/)) {
        body = substr(s, RSTART, RLENGTH)
        s = substr(s, RSTART + RLENGTH)
        name = body
        sub(/^LOBE_STRUCT\(/, "", name)
        sub(/\).*/, "", name)
        gsub(/.*\{|\}/, "", body)
        gsub(/[;,]/, " & ", body)
        n = split(body, word, /[ \t]+/)
        count[name] = 0
        type = ""
        for (i = 1; i <= n; i++) {
            if (word[i] == ";")
                type = ""
            else if (type == "")
                type = word[i]
            else if (word[i] != "," && type == "lobe_real")
                member[name, count[name]++] = word[i]
            else if (word[i] != ",")
                for (k = 0; k < count[type]; k++)
                    member[name, count[name]++] = word[i] "." member[type, k]
        }
    }
}

# How many scalars S_of takes.
function find_makers(s,    head, name, args) {
    while (match(s, /LOBE_FN +lobe_[a-z0-9_]+ +lobe_[a-z0-9_]+_of\([^)]*\)/)) {
        head = substr(s, RSTART, RLENGTH)
        s = substr(s, RSTART + RLENGTH)
        split(head, word, / +/)
        name = word[3]
        sub(/\(.*/, "", name)
        args = head
        sub(/[^(]*\(/, "", args)
        if (name == word[2] "_of")
            made[word[2]] = gsub(/lobe_real/, "", args)
    }
}

# The types of a kernel's inputs into types_in; 0 where one cannot be made.
function find_inputs(name, args,    n, i, part, scalars, word) {
    sub(/LOBE_COEFFS/, "", args)
    n = split(args, part, /,/)
    for (i = 1; i <= n; i++) {
        split(part[i], word, / +/)
        type_in = word[1] != "" ? word[1] : word[2]
        if (type_in != "lobe_real" && !(type_in in made))
            return 0
        types_in[name, i] = type_in
        scalars += type_in == "lobe_real" ? 1 : made[type_in]
    }
    arguments[name] = n
    return scalars
}

function find_kernels(s,    head, type, name, args, n) {
    while (match(s, /LOBE_FN +[a-z0-9_]+ +lobe_[a-z0-9_]+\([^)]*\)/)) {
        head = substr(s, RSTART, RLENGTH)
        s = substr(s, RSTART + RLENGTH)
        split(head, word, / +/)
        type = word[2]
        name = word[3]
        sub(/\(.*/, "", name)
        args = head
        sub(/[^(]*\(/, "", args)
        sub(/\).*/, "", args)
        if (!(name in registered) || (type != "lobe_real" && !(type in count)))
            continue
        n = find_inputs(name, args)
        if (n == 0)
            continue
        kernels++
        names[kernels] = name
        types[name] = type
        inputs[name] = n
        outputs[name] = type == "lobe_real" || (name in only) ? 1 : count[type]
    }
}

function call(name, x,    i, j, at, s, t) {
    for (i = 1; i <= arguments[name]; i++) {
        t = types_in[name, i]
        s = s (i > 1 ? ", " : "") (t == "lobe_real" ? "" : t "_of(")
        for (j = 0; j < (t == "lobe_real" ? 1 : made[t]); j++)
            s = s (j ? ", " : "") sprintf(x, inputs[name], at++)
        s = s (t == "lobe_real" ? "" : ")")
    }
    return name "(" s ")"
}

function body(name, x, y,    i, s, t) {
    t = types[name]
    s = "    " t " d = " call(name, x) ";\n"
    for (i = 0; i < outputs[name]; i++)
        s = s "    " sprintf(y, outputs[name], i) " = d" (name in only ? "." only[name] : t == "lobe_real" ? "" : "." member[t, i]) ";\n"
    return s
}

END {
    text = uncomment(text)
    find_structs(text)
    find_makers(text)
    find_kernels(text)
    if (want == "list")
        for (k = 1; k <= kernels; k++)
            print names[k], inputs[names[k]], outputs[names[k]]
    if (want == "glsl") {
        print "layout(local_size_x = 64) in;"
        print "layout(std430, binding = 0) readonly buffer rows_in { float x[]; };"
        print "layout(std430, binding = 1) writeonly buffer rows_out { float y[]; };"
        print "layout(push_constant) uniform rows { uint n; };"
        print "void main()\n{\n    uint i = gl_GlobalInvocationID.x;\n    if (i >= n)\n        return;"
        printf "%s}\n", body(kernel, "x[i * %du + %du]", "y[i * %du + %du]")
    }
    if (want == "cl") {
        print "__kernel void run(__global const float *x, __global float *y, uint n)\n{"
        print "    size_t i = get_global_id(0);\n    if (i >= n)\n        return;"
        printf "%s}\n", body(kernel, "x[i * %d + %d]", "y[i * %d + %d]")
    }
    if (want == "c") {
        for (k = 1; k <= kernels; k++)
            printf "static void at_%s(const float *x, float *y)\n{\n%s}\n", names[k], body(names[k], "x[0 * %d + %d]", "y[0 * %d + %d]")
        print "static const struct kernel kernels[] = {"
        for (k = 1; k <= kernels; k++)
            printf "    {\"%s\", %d, %d, at_%s},\n", names[k], inputs[names[k]], outputs[names[k]], names[k]
        print "    {0, 0, 0, 0}};"
    }
}
