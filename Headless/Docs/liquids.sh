#!/usr/bin/env bash
# The pictures of the liquids in the Project window: each liquid's prefab, played. About five minutes on two CPU cores.
#   ./Headless/Docs/liquids.sh [NAME...]   all, or the named ones, e.g. Honey
# Without a warning the play must end. Look at what comes out.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
package=$root/Packages/com.sphfluid
plays=$root/Build/liquids
size=${SIZE:-192x192}
mkdir -p "$plays"

# name, width of its tank [m], moment [s]
while IFS=, read -r name width moment; do
    (($# == 0)) || [[ " $* " == *" $name "* ]] || continue
    guid=$(sed -n 's/^guid: //p' "$package/Runtime/Assets/Liquids/Prefabs/$name.prefab.meta")
    read -r x y z < <(awk -v w="$width" 'BEGIN { s = w / 1.6; print 2.05 * s, 1.35 * s, -3.55 * s }')
    sed "s/@PREFAB@/$guid/; s/@X@/$x/; s/@Y@/$y/; s/@Z@/$z/" "$root/Headless/Docs/liquid.unity" > "$plays/$name.unity"
    "$root/run" play --scene "$plays/$name.unity" --seconds "$moment" --fps 20 --size "$size" --out "$plays/$name" \
        < /dev/null > "$plays/$name.log" 2>&1 || { tail -n 20 "$plays/$name.log"; exit 1; }
    if grep -n '^\[\(Warning\|Error\)\]' "$plays/$name.log"; then exit 1; fi
    last=$(find "$plays/$name" -name 'frame_*.png' | sort | tail -n 1)
    cp "$last" "$package/Editor/Liquids/$name.png"
    echo "$package/Editor/Liquids/$name.png"
done << 'LIQUIDS'
Water,1.6,0.7
Sea Water,1.6,0.7
Muddy River,1.6,0.7
Honey,0.4,1.6
Oil,0.4,1.2
Milk,0.8,0.5
Blood,0.8,0.5
Lava,1.6,1.6
Mercury,0.4,0.35
Slime,0.4,0.5
LIQUIDS
