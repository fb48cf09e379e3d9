#!/usr/bin/env bash
# Sets the address of a copy in the one place that has it, README.md, and writes what follows from it into each package.json: documentationUrl, changelogUrl and
# licensesUrl, which the Package Manager opens. Until then packages have none.
#   ./Headless/Publish/publisher.sh OWNER/REPOSITORY
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[[ ${1-} =~ ^[A-Za-z0-9][A-Za-z0-9-]*/[A-Za-z0-9._-]+$ ]] || { echo "publisher: OWNER/REPOSITORY of GitHub, e.g. ada/sphfluid" >&2; exit 2; }
sed -i -E "s|(https://github\.com/)[^/]+/[^/?]+(\.git\?path=)|\1$1\2|" README.md
for package in Packages/*/package.json; do
    pages=https://github.com/$1/blob/HEAD/${package%/package.json}
    sed -i -E "/\"(documentation|changelog|licenses)Url\"/d; s|^( *)\"license\": .*|&\n\1\"documentationUrl\": \"$pages/Documentation~/index.md\",\n\1\"changelogUrl\": \"$pages/CHANGELOG.md\",\n\1\"licensesUrl\": \"$pages/LICENSE.md\",|" "$package"
done
