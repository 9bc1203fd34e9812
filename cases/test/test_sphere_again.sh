#!/bin/sh
# What is fitted of the published forms of a sphere light comes out again, byte for byte, with other threads.
. harness/test/tap.sh
again() {
    "$B/lobefit" search sphere_light "$1" "$work/again.h" --threads 3 && cmp "$work/again.h" "cases/sphere_light/$2"
}
check 'their constants' again --peers peers_fitted.h
check 'the table of linearly transformed cosines' again --ltc ltc_table.h
check 'no folder' exits 2 'cannot open' "$B/lobefit" search sphere_light --ltc "$work/none/table.h"
check 'no value' exits 2 '--peers' "$B/lobefit" search sphere_light --peers
finish
