#!/usr/bin/env bash
# The pictures of the samples in the manual, played anew: four moments of each, side by side. About twenty minutes on two CPU cores.
#   ./Headless/Docs/pictures.sh [NAME...]           all, or the named ones, e.g. fountain
#   ./Headless/Docs/pictures.sh --judge [NAME...]   keeps the committed ones and says how like them the new ones are (SSIM): below
#                                                   0.9 the look has changed, and somebody has to look at Build/pictures/NAME.png
# images/pictures.csv says what each shows, and pages take their captions from it: afterwards ./run check --only docs --update.
# The thesis's surface and the 65,536 particles are made by hand, by the commands in that table.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
images=$root/Packages/com.sphfluid/Documentation~/images
plays=$root/Build/pictures
fps=20
least=0.9 # of the structural similarity; other rounding of another device moves drops and waves
judge=0
[[ ${1-} != --judge ]] || { judge=1; shift; }
failed=0

# Pictures of a play by number, in the tiles of one.
tiles() {
    local play=$1 layout=$2 file=$3 frame chosen=''
    shift 3
    for frame in "$@"; do chosen+="${chosen:++}eq(n\\,$frame)"; done
    ffmpeg -nostdin -hide_banner -loglevel error -y -framerate "$fps" -i "$play/frame_%05d.png" -vf "select=$chosen,tile=$layout" -frames:v 1 "$file"
}

# name, sample, size of a tile, tiles, moments [s]
while read -r name sample size layout moments; do
    (($# == 0)) || [[ " $* " == *" $name "* ]] || continue
    frames=()
    for moment in $moments; do frames+=("$(awk -v t="$moment" -v f=$fps 'BEGIN { printf "%.0f", t * f }')"); done
    command="play --scene $sample --seconds ${moments##* } --fps $fps --size $size"
    # shellcheck disable=SC2086
    "$root/run" $command --out "$plays/$name" < /dev/null > "$plays-$name.log" 2>&1 || { tail -n 20 "$plays-$name.log"; exit 1; }
    if ((judge)); then
        tiles "$plays/$name" "$layout" "$plays/$name.png" "${frames[@]}"
        similarity=$(ffmpeg -nostdin -hide_banner -i "$plays/$name.png" -i "$images/$name.png" -lavfi ssim -f null - 2>&1 | sed -n 's/.*All:\([0-9.]*\).*/\1/p')
        verdict=ok
        awk -v s="${similarity:-0}" -v l=$least 'BEGIN { exit s >= l }' && verdict=CHANGED failed=$((failed + 1))
        printf '%-8s%-26s%s\n' "$verdict" "$name" "${similarity:-another size}"
        continue
    fi
    tiles "$plays/$name" "$layout" "$images/$name.png" "${frames[@]}"
    "$root/Headless/Docs/record-picture.sh" "$images/$name.png" "$sample" "./run $command" "$moments" "$plays/$name"
    echo "$images/$name.png"
done << 'PICTURES'
dam-break DamBreak 960x540 1x1 3
dam-break-water DamBreak 640x360 1x1 0.65
dam-break-rest DamBreak 640x360 1x1 8
falling-block-water FallingBlock 640x360 1x1 0.55
liquids Liquids 640x360 2x2 0.3 0.7 1.2 2.4
multiple-objects-water MultipleObjects 640x360 1x1 0.65
floating-crates FloatingCrates 480x270 2x2 0 0.4 1 3
fountain Fountain 480x270 2x2 0.8 1.5 2.3 3
getting-started GettingStarted 480x270 2x2 0.6 1.2 1.8 2.4
heated-water HeatedWater 480x270 2x2 0.4 0.7 1.1 1.6
pour-and-fill PourAndFill 480x270 2x2 0.4 1.1 2 4
wave-tank WaveTank 480x270 2x2 1.4 2 3.2 5.6
weather-proof WeatherProof 480x270 2x2 0.6 1.2 1.8 2.4
river River 480x270 2x2 0.3 0.8 1.2 1.8
waterfall Waterfall 480x270 2x2 0.4 0.8 1.2 1.8
harbour Harbour 480x270 2x2 0.5 1 1.5 2.4
storm-in-a-glass StormInAGlass 480x270 2x2 0 0.6 1 1.5
honey-on-bread HoneyOnBread 480x270 2x2 0.4 0.7 1.1 1.5
lava-on-steps LavaOnSteps 480x270 2x2 0 0.5 1 1.5
gallery Gallery 480x270 2x2 2 5.5 9 12.5
duck-pond DuckPond 480x270 2x2 0.5 2 4 6
water-wheel WaterWheel 480x270 2x2 0.3 0.8 1.5 2.4
stairs Stairs 480x270 2x2 3 6 9 13
PICTURES
exit $((failed > 0))
