#!/usr/bin/env bash
# Writes the manual and the API reference of com.sphfluid as pages for a browser: Build/docs/index.html. Needs Doxygen (Debian: doxygen).
# A warning about a page or a comment of ours is an error: it names file and line.
set -euo pipefail

if (($#)); then
    echo "docs: '$1' is not understood; it takes no words." >&2
    exit 2
fi
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if ! command -v doxygen > /dev/null; then
    sudo=()
    if ! command -v apt-get > /dev/null; then
        echo "Doxygen is missing: https://www.doxygen.nl/download.html" >&2
        exit 1
    fi
    if ((EUID != 0)); then
        command -v sudo > /dev/null || { echo "as root: apt-get install doxygen" >&2; exit 1; }
        sudo=(sudo)
    fi
    echo "installing doxygen" >&2
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends doxygen > /dev/null
fi
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
echo Build/docs/index.html
