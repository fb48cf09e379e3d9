#!/usr/bin/env bash
# Follows the README as a newcomer does: a fresh clone in an empty folder, the commands of "See it without Unity" as they are printed,
# and then looks for what the README promises. Run by hand, as it builds everything anew: ./Headless/Walk/readme.sh
#   --trial   a shorter and smaller play in place of the default one, to try this script
#   --keep    leaves the folder
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
trial='' keep=''
for word in "$@"; do
    case $word in
        --trial) trial=' --seconds 0.2 --size 320x180' ;;
        --keep) keep=yes ;;
        *) echo "'$word' is not understood: --trial and --keep are." >&2; exit 2 ;;
    esac
done

folder=$(mktemp -d)
[[ $keep ]] || trap 'rm -rf "$folder"' EXIT
failed=0
ok() { printf 'ok      %s\n' "$*"; }
no() { printf 'FAILED  %s\n' "$*"; failed=$((failed + 1)); }
expect() { local what=$1; shift; if "$@" > /dev/null 2>&1; then ok "$what"; else no "$what"; fi; }

git clone -q "file://$root" "$folder/clone"
cd "$folder/clone"
echo "clone of $(git log -1 --format='%h %s') in $folder/clone"

# The fences of a section whose language is sh.
commands=$(awk '/^## /{ inside = ($0 == "## See it without Unity") } inside && /^```sh$/{ code = 1; next } /^```/{ code = 0 } inside && code' README.md)
[[ $commands ]] || { no "the README has commands under 'See it without Unity'"; exit 1; }

while IFS= read -r command; do
    [[ $command ]] || continue
    [[ $command == ./run && $trial ]] && command+=$trial
    echo "\$ $command"
    begun=$(date +%s)
    (while [[ ! -s Build/play/frame_00000.png ]]; do sleep 0.2; done; echo "$(($(date +%s) - begun))" > "$folder/first") &
    watcher=$!
    if bash -c "$command" > "$folder/output" 2>&1 < /dev/null; then ok "'$command' in $(($(date +%s) - begun)) s"; else no "'$command'"; tail -n 20 "$folder/output"; fi
    kill "$watcher" 2> /dev/null || true
    wait "$watcher" 2> /dev/null || true
    [[ -e $folder/first ]] && echo "        the first picture came after $(< "$folder/first") s"
done <<< "$commands"

play=Build/play
frames=$(sed -n 's/^ *"frames": *\([0-9]*\),*$/\1/p' "$play/summary.json" 2> /dev/null || echo 0)
expect "the film is there and a player can read it" ffprobe -v error -select_streams v:0 -show_entries stream=codec_name "$play/film.mp4"
expect "a picture a frame ($frames)" test "$(find "$play" -name 'frame_*.png' | wc -l)" -eq "${frames:-0}"
expect "pictures are no single colour" bash -c "[[ \$(ffmpeg -v error -i '$play/frame_00000.png' -vf signalstats,metadata=print:key=lavfi.signalstats.YMAX:file=- -f null - | sed -n 's/.*=//p') -gt 40 ]]"
expect "timings.csv has a row a frame" test "$(tail -n +2 "$play/timings.csv" | wc -l)" -eq "${frames:-0}"
expect "summary.json tells of no error" grep -q '"errors": 0' "$play/summary.json"
expect "the git URL's folder holds a package" git cat-file -e "HEAD:$(sed -n 's|^https://github.com/.*?path=/\(.*\)$|\1|p' README.md)/package.json"
for file in $(grep -o 'Packages/[^ )`]*\.webp' README.md | sort -u); do expect "the film of the README, below 3 MB" test "$(git cat-file -s "HEAD:$file")" -lt 3000000; done
tail -n 3 "$folder/output"
echo "$failed failed"
exit $((failed > 0))
