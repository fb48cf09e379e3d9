#!/usr/bin/env bash
# Writes the manual and the API reference of com.sphfluid and the packages that add to it as pages for a browser: Build/docs/index.html. Needs Doxygen (Debian: doxygen).
# A warning about a page or a comment of ours is an error: it names file and line.
set -euo pipefail

if (($#)); then
    echo "docs: '$1' is not understood; it takes no words." >&2
    exit 2
fi
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
./setup.sh docs
rm -rf Build/docs
mkdir -p Build/docs
doxygen Headless/Docs/Doxyfile
if [[ -s Build/docs-warnings.log ]]; then
    cat Build/docs-warnings.log >&2
    echo "$(wc -l < Build/docs-warnings.log) warnings of $(doxygen --version)" >&2
    exit 1
fi
# Where Doxygen loses its way in a page, its own commands are left in the text, without a warning.
if grep -lE '@(ref|section|code|endcode)\b' Build/docs/*.html >&2; then
    echo "these pages show commands of Doxygen" >&2
    exit 1
fi
perl Headless/Docs/search-words.pl Build/docs
# What people look for.
for word in mobile phone vr urp hdrp webgl honey ocean multiplayer network foam performance slow; do
    grep -q "\['${word}_0'" Build/docs/search/all_*.js || { echo "the search does not find '$word'" >&2; exit 1; }
done
echo "the manual and the API reference: $PWD/Build/docs/index.html"
echo "They are a static site: open that file in a browser, or publish the folder as it is."
