#!/usr/bin/env bash
# Lightbench beside POV-Ray 3.7, one thread each, on the same scenes: time, and whether the pictures agree.
#
#   benches/vs_povray.sh [RUNS] [FOLDER]        default: 5 runs, pictures into out/vs_povray
#
# POV-Ray's time is its own "Trace Time" in CPU seconds, which leaves out its start, parsing and writing. Ours is CPU
# seconds too, twice: of the whole process, with reading the scene and writing the picture, which favours POV-Ray; and of
# the tracing alone, which is what a second sample in each pixel adds to the process.
# LIGHTBENCH names another program than target/release/lightbench.
set -euo pipefail
cd "$(dirname "$0")/.."

runs=${1:-5}
out=${2:-out/vs_povray}
lightbench=${LIGHTBENCH:-target/release/lightbench}
command -v povray >/dev/null || { echo "povray is not installed: nothing to compare with" >&2; exit 0; }
[ -x "$lightbench" ] || cargo build --release --bin lightbench
mkdir -p "$out"

# POV-Ray scene | our scene | side for time [pixels]: POV-Ray's clock is coarse, so quick scenes need large pictures
scenes='
s1_area_100lights | scenes/d01_radiometric.scene | 512
s1_point          | benches/povray/s1_point.scene | 2048
s3_csg            | scenes/p_csg.scene | 2048
s5_torus          | scenes/p_torus.scene | 2048
s5_shapes         | scenes/p_shapes.scene | 2048
s5_julia          | scenes/p_julia.scene | 2048
'

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }

pov() { # scene, side, file type, output, more options
    povray "+Ibenches/povray/$1.pov" +Lbenches/povray "+W$2" "+H$2" -D "+F$3" "+O$4" +WT1 -A Declare=ITER=8 "${@:5}" 2>&1
}

pov_seconds() { # CPU seconds of tracing
    pov "$1" "$2" N "$out/$1_povray.png" | awk '/Trace Time/ { here = 1 } here && /CPU-seconds/ {
        for (i = 2; i <= NF; i++) if ($i ~ /^CPU-seconds/) print $(i - 1); exit }'
}

our_seconds() { # scene, side, samples a pixel: CPU seconds of the whole process
    local TIMEFORMAT='%U %S'
    { time "$lightbench" render "$1" --width "$2" --height "$2" --spp "$3" --threads 1 --format hdr --quiet \
        --out "$out" >/dev/null; } 2>&1 | awk '{ print $1 + $2 }'
}

# The same picture twice, linear, from a camera that looks a little aside (see common.inc), and their difference.
agreement() { # POV-Ray scene, our scene
    local aside="$out/$1_aside.scene"
    sed 's/POI 0 5 0/POI 0.0131 5.0173 0/' "$2" >"$aside"
    pov "$1" 512 E "$out/$1_povray.exr" Declare=LookX=0.0131 Declare=LookY=5.0173 >/dev/null
    "$lightbench" render "$aside" --width 512 --height 512 --format exr --quiet --out "$out" >/dev/null
    "$lightbench" compare "$out/$1_aside.exr" "$out/$1_povray.exr" --out "$out" | grep -E 'RMSE|largest|picture '
}

echo "$scenes" | while IFS='| ' read -r theirs ours side; do
    [ -n "$theirs" ] || continue
    echo "$theirs, $side × $side, $runs runs"
    for ((i = 0; i < runs; i++)); do # in turn, so that a busy machine is busy for both
        pov_seconds "$theirs" "$side" >>"$out/pov.$$"
        whole=$(our_seconds "$ours" "$side" 1) twice=$(our_seconds "$ours" "$side" 2)
        echo "$whole" >>"$out/whole.$$"
        awk -v a="$whole" -v b="$twice" 'BEGIN { print b - a }' >>"$out/trace.$$"
    done
    p=$(median <"$out/pov.$$") w=$(median <"$out/whole.$$") t=$(median <"$out/trace.$$")
    rm "$out"/{pov,whole,trace}.$$
    awk -v p="$p" -v w="$w" -v t="$t" 'BEGIN {
        printf "  POV-Ray %.3f s, lightbench %.3f s: ratio %.2f (medians of CPU seconds, tracing)\n", p, t, p / t
        printf "  with reading and writing, lightbench %.3f s: ratio %.2f\n", w, p / w }'
    agreement "$theirs" "$ours"
done
