#!/usr/bin/env bash
# The moving picture of the README from a play, as an animated WebP that GitHub and every browser shows.
#   ./run play --seconds 3 --fps 30 --size 1280x720 --out Build/film
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
fps=$(sed -n 's/^ *"fps": *\([0-9.]*\),*$/\1/p' "$play/summary.json")
ffmpeg -nostdin -hide_banner -loglevel error -y -framerate "${fps:-30}" -i "$play/frame_%05d.png" -vf "fps=15,scale=$width:-2:flags=lanczos" \
    -c:v libwebp_anim -lossless 0 -quality "$quality" -compression_level 6 -loop 0 "$file"
scene=$(sed -n 's/^ *"scene": *"\(.*\)",*$/\1/p' "$play/summary.json")
[[ ! -e $(dirname "$file")/pictures.csv ]] || "$root/Headless/Docs/record-picture.sh" "$file" "$(basename "$scene" .unity)" \
    "./run play --seconds $(sed -n 's/^ *"simulated_s": *\([0-9]*\).*/\1/p' "$play/summary.json") --fps ${fps:-30} --size 1280x720" '' "$play"
size=$(stat -c %s "$file")
echo "$file: $size bytes"
((size <= most)) || { echo "that is more than $most: a smaller WIDTH, a lower QUALITY or a shorter play." >&2; exit 1; }
