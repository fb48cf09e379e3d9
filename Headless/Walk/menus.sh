#!/usr/bin/env bash
# A new user's first minutes without the Editor: an empty project of Unity 6000.5 with the package in it, the code that GameObject > Fluid > ...
# calls, and a picture of what each step leaves. Each is played twice in one process, as without a domain reload, and must show the same pictures.
# What they show in the end becomes the picture of the menus in the manual; afterwards ./run check --only docs --update.
# Run by hand: ./Headless/Walk/menus.sh [FOLDER], by default Build/walk.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
pictures=${1:-$root/Build/walk}
"$root/run" build Headless.slnx > /dev/null
player=$root/Build/dotnet/bin/Headless.Player/release/sphplayer
assemblies=$root/Build/ScriptAssemblies

project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
mkdir -p "$project/Assets" "$project/Packages" "$pictures"
cp -r "$root/ProjectSettings" "$project"
cp -r "$root"/Assets/Settings{,.meta} "$root/Packages/com.sphfluid/Samples~/GettingStarted/Materials" "$project/Assets"
printf 'm_EditorVersion: 6000.5.2f1\nm_EditorVersionWithRevision: 6000.5.2f1 (5849259a85f3)\n' > "$project/ProjectSettings/ProjectVersion.txt"
sed 's/\("com.unity.test-framework": \)"[^"]*"/\1"1.7.0"/' "$root/Packages/manifest.json" > "$project/Packages/manifest.json"
cp -r "$root/Packages/com.sphfluid" "$project/Packages"
cd "$project"
# With more threads the software device adds up faces of water in any order, and last bits of a second play's pictures differ.
export LP_NUM_THREADS=1
"$player" exec --project "$project" --assemblies "$assemblies" --executeMethod SphFluid.Validation.Editor.NewUserWalk.Write

fps=12 failed=0 shown=() moments=''
play() {
    "$player" play --project "$project" --assemblies "$assemblies" --executeMethod SphFluid.Validation.CommandLine.Play \
        --scene "Assets/NewUser/$1.unity" --seconds "$2" --fps $fps --size 480x270 --twice --out "$pictures/$1" > "$pictures/$1.log" 2>&1
}
report() {
    local step=$1
    shift
    if "$@"; then
        echo "ok      $step: $pictures/$step"
    else
        echo "FAILED  $step"
        tail -n 20 "$pictures/$step.log"
        failed=$((failed + 1))
    fi
}
is_clean() { grep -q '"errors": 0' "$pictures/$1/summary.json" && ! grep -q '^\[\(Warning\|Error\)\]\|--twice: ' "$pictures/$1.log"; }
names_the_menu() { grep -q 'GameObject > Fluid > Tank' "$pictures/$1.log"; }

# Where there is no liquid yet, the message says how to get one.
play 1-floor 0.1 || true
report 1-floor names_the_menu 1-floor
while read -r step seconds; do
    play "$step" "$seconds" || true
    report "$step" is_clean "$step"
    shown+=(-i "$pictures/$step/frame_$(awk -v t="$seconds" -v f=$fps 'BEGIN { printf "%05.0f", t * f }').png")
    moments+="${moments:+ }$seconds"
done << 'STEPS'
2-tank 1.5
3-emitter 1.5
4-surface 1
5-particles 1
STEPS
echo "$failed failed"
if ((failed == 0)); then
    menu=$root/Packages/com.sphfluid/Documentation~/images/menu.png
    ffmpeg -nostdin -hide_banner -loglevel error -y "${shown[@]}" -filter_complex 'xstack=inputs=4:layout=0_0|w0_0|0_h0|w0_h0' -frames:v 1 "$menu"
    "$root/Headless/Docs/record-picture.sh" "$menu" '' ./Headless/Walk/menus.sh "$moments" "$pictures/2-tank"
fi
exit $((failed > 0))
