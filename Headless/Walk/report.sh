#!/usr/bin/env bash
# Opens a chart's report.html in Chromium, steps through it as a reader does (report.js) and takes pictures: wide and narrow, light and dark.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$(dirname "$here")")
page=${1:-$root/Build/chart}/report.html
out=${2:-$root/Build/walk/report}
widths=(1280 400)

[[ -f $page ]] || { echo "There is no '$page'. Give the folder of a chart: Headless/Walk/report.sh DIR [PICTURES]" >&2; exit 2; }
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) \
    || { echo "No Chromium was found (Debian: apt-get install chromium); nothing is checked." >&2; exit 2; }

mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# open SCHEME WIDTH HEIGHT FLAG... FILE; Chromium's own preference for light is 1 and for dark 0.
open() {
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$work/profile" \
        --blink-settings=preferredColorScheme="$1" --window-size="$2,$3" "${@:4}" 2> "$work/log"
}

# The page, with a catcher of errors before its script and the walk behind it.
sed -e 's|<head>|<head><script>window.walkErrors = []; window.addEventListener("error", e => window.walkErrors.push(e.message));</script>|' \
    -e '/<\/body>/d' -e '/<\/html>/d' "$page" > "$work/walk.html"
{ echo '<script>'; cat "$here/report.js"; echo '</script></body></html>'; } >> "$work/walk.html"

# In a frame, as no window is as narrow as a phone. It tells the outer page what it found.
framed() {
    cat << END
<!DOCTYPE html><body style="margin: 0"><pre id="walk"></pre>
<script>window.addEventListener("message", e => { document.getElementById("walk").textContent = e.data; });</script>
<iframe src="walk.html" style="width: $1px; height: 900px; border: 0"></iframe></body>
END
}

faults=0
for width in "${widths[@]}"; do
    framed "$width" > "$work/frame.html"
    found=$(open 1 1400 1000 --virtual-time-budget=10000 --dump-dom "file://$work/frame.html" | sed -n 's|.*<pre id="walk">\([^<]*\)</pre>.*|\1|p')
    [[ -n $found ]] || found="$width px: the page's walk did not end"
    echo "$found"
    [[ $found == *"; no fault" ]] || faults=$((faults + 1))
    for scheme in light dark; do
        open "$([[ $scheme == light ]] && echo 1 || echo 0)" "$width" "${HEIGHT:-4200}" --screenshot="$out/$scheme-$width.png" "file://$(realpath "$page")" > /dev/null
    done
done
open 1 1280 900 --no-pdf-header-footer --print-to-pdf="$out/print.pdf" "file://$(realpath "$page")" > /dev/null
echo "pictures: $out"
exit "$((faults > 0))"
