# SPDX-License-Identifier: MIT
# From a linker map, the objects of kernels.dir/ that the program contains, as a dependency of it:
# awk -v program=PROGRAM -v script=THIS_FILE -f THIS_FILE MAP
# Without it every program would be linked again when any kernel changes. A program without kernels
# depends on this file alone: for ninja, an empty list is a missing one.
/^Linker script and memory map/ { kept = 1 }  # after the sections that were discarded
/^ \.[a-z]/ { section = $1 }
kept && section !~ /^\.(debug|comment|note|stab)/ &&
    match($0, /0x[0-9a-f]+ +0x[0-9a-f]*[1-9a-f][0-9a-f]* +[^ ]*kernels\.(dir\/|a\()[^ )]+\)?$/) {
    path = $NF
    sub(/kernels\.a\(/, "kernels.dir/", path)
    sub(/\)$/, "", path)
    used[path]
}
END {
    printf "%s: %s", program, script
    for (path in used)
        printf " %s", path
    print ""
}
