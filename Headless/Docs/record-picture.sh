#!/usr/bin/env bash
# Writes what a picture of the manual shows into images/pictures.csv, from which pages have their captions.
#   ./Headless/Docs/record-picture.sh FILE SAMPLE COMMAND MOMENTS PLAY
# MOMENTS: seconds, with blanks between; none for a film. PLAY: the folder of the play, whose summary.json knows particles and device.
set -euo pipefail

file=$1 sample=$2 command=$3 moments=$4 summary=$5/summary.json
table=$(dirname "$file")/pictures.csv
name=$(basename "$file")

of_summary() {
    sed -n "s/^ *\"$1\": *\"\{0,1\}\([^\",]*[^\", ]\).*/\1/p" "$summary" | head -n 1
}

device=$(sed -n 's/^ *"device": *"\(.*\)",*$/\1/p' "$summary")
line="$name,$sample,\"$command\",$moments,$(of_summary particles),\"$device\",$(date -u +%F),,$(sha256sum "$file" | cut -c 1-12)"
{
    head -n 1 "$table"
    { tail -n +2 "$table" | grep -v "^$name," || true; echo "$line"; } | LC_ALL=C sort
} > "$table.new"
mv "$table.new" "$table"
