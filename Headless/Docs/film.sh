#!/usr/bin/env bash
# The moving picture of the README from a play, as an animated WebP that GitHub and every browser shows.
#   ./run play --seconds 3 --fps 15 --size 960x540 --out Build/film
#   ./Headless/Docs/film.sh Build/film [FILE.webp] [WIDTH] [QUALITY]
# Frames come from the pictures, not from film.mp4, so they are compressed once; 15 a second are kept.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
play=${1:-$root/Build/play}
file=${2:-$root/Packages/com.sphfluid/Documentation~/images/dam-break.webp}
width=${3:-640}
quality=${4:-60}
most=3000000 # bytes: what a page loads while its reader looks at it

[[ -e $play/frame_00001.png ]] || { echo "'$play' has no pictures of a play: ./run play --out '$play' makes them." >&2; exit 2; }
of_summary() { sed -n "s/^ *\"$1\": *\"\{0,1\}\([^\",]*\).*/\1/p" "$play/summary.json" | head -n 1; }
fps=$(of_summary fps)
ffmpeg -nostdin -hide_banner -loglevel error -y -framerate "${fps:-30}" -i "$play/frame_%05d.png" -vf "fps=15,scale=$width:-2:flags=lanczos" \
    -c:v libwebp_anim -lossless 0 -quality "$quality" -compression_level 6 -loop 0 "$file"
scene=$(of_summary scene)
[[ ! -e $(dirname "$file")/pictures.csv ]] || "$root/Headless/Docs/record-picture.sh" "$file" "$(basename "$scene" .unity)" \
    "./run play --seconds $(printf '%.3g' "$(of_summary simulated_s)") --fps ${fps:-30} --size $(of_summary width)x$(of_summary height)" '' "$play"
size=$(stat -c %s "$file")
echo "$file: $size bytes"
((size <= most)) || { echo "that is more than $most: a smaller WIDTH, a lower QUALITY or a shorter play." >&2; exit 1; }
