#!/usr/bin/env bash
# The pictures of the liquids in the Project window: each liquid's prefab in a project of its own, played for three seconds, which must pass
# without a warning. About ten minutes on two CPU cores. Look at what comes out.
#   ./Headless/Docs/liquids.sh [NAME...]   all, or the named ones, e.g. Honey "Sea Water"
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
package=$root/Packages/com.sphfluid
plays=$root/Build/liquids
"$root/run" build Play.slnx > /dev/null
player=$root/Build/dotnet/bin/Headless.Player/release/sphplayer
fps=30

project=$(mktemp -d)
trap 'rm -rf "$project"' EXIT
mkdir -p "$project/Assets" "$project/Packages" "$plays" "$package/Editor/Liquids"
cp -r "$root/ProjectSettings" "$project"
cp -r "$root"/Assets/Settings{,.meta} "$package/Samples~/GettingStarted/Materials" "$project/Assets"
cp -r "$root"/Packages/{manifest.json,packages-lock.json,com.*} "$project/Packages"

# name, width of its tank [m], moment of the picture [s]
while IFS=, read -r name width moment; do
    (($# == 0)) || [[ " $* " == *" $name "* ]] || continue
    guid=$(sed -n 's/^guid: //p' "$package/Runtime/Assets/Liquids/Prefabs/$name.prefab.meta")
    read -r x y z < <(awk -v w="$width" 'BEGIN { s = w / 1.6; print 2.05 * s, 1.35 * s, -3.55 * s }')
    sed "s/@PREFAB@/$guid/; s/@X@/$x/; s/@Y@/$y/; s/@Z@/$z/" "$root/Headless/Docs/liquid.unity" > "$project/Assets/$name.unity"
    "$player" play --project "$project" --assemblies "$root/Build/ScriptAssemblies" --scene "Assets/$name.unity" --seconds 3 --fps $fps \
        --size 160x160 --out "$plays/$name" < /dev/null > "$plays/$name.log" 2>&1 || { tail -n 20 "$plays/$name.log"; exit 1; }
    if grep '^\[\(Warning\|Error\)\]' "$plays/$name.log"; then exit 1; fi
    frame=$(awk -v t="$moment" -v f=$fps 'BEGIN { printf "%05.0f", t * f }')
    cp "$plays/$name/frame_$frame.png" "$package/Editor/Liquids/$name.png"
    echo "$package/Editor/Liquids/$name.png"
done << 'LIQUIDS'
Water,1.7,0.7
Sea Water,1.7,0.7
Muddy River,1.7,0.7
Honey,0.46,1.4
Oil,0.46,1.1
Milk,0.8,0.5
Blood,0.8,0.5
Lava,1.7,2.2
Mercury,0.46,0.3
Slime,0.5,0.6
LIQUIDS
