#!/bin/sh
# The command-line contracts that users script against, as the project's own checker sees them.
. harness/test/tap.sh
contract=../shared/contract.sh
if [ -e $contract ]; then
    for model in split_sum split_sum_sep energy diffuse_sh sphere_light sg_light; do
        check "contracts of $model" bash $contract $model
    done
else
    skip 'command-line contracts' "$contract is not beside this checkout"
fi
finish
