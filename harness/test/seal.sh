# seal MODEL TIER FORMAT BOUND INPUTS OUTPUTS <ROWS >FILE: makes a vector file of rows. The digest is the one
# that the parser asks for, which test_vec_file checks against published FNV-1a values.
seal() {
    cat >"$work/rows"
    seal_head "$@" 0000000000000000 >"$work/unsealed.vec"
    cat "$work/rows" >>"$work/unsealed.vec"
    digest=$("$B/lobecheck" run "$work/unsealed.vec" 2>&1 | sed -n 's/.*the rows have //p')
    seal_head "$@" "$digest"
    cat "$work/rows"
}

seal_head() {
    printf '# model: %s\n# tier: %s\n# format: %s\n# bound_max: %s\n# inputs: %s\n# outputs: %s\n' "$1" "$2" "$3" "$4" \
        "$5" "$6"
    printf '# brdf: test\n# domain: test\n# truth: test\n# command: test\n# seed: 0\n# digest: %s\n' "$7"
}
