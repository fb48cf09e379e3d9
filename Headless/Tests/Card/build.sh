#!/usr/bin/env bash
# build.sh FOLDER: the layer that imitates a graphics card, for VK_LAYER_PATH; VK_INSTANCE_LAYERS=VK_LAYER_SPHFLUID_card loads it.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
gcc -shared -fPIC -O2 -Wall -Wextra -Werror -fvisibility=hidden -o "$1/libcard_layer.so" "$here/card_layer.c"
cp "$here/VkLayer_sphfluid_card.json" "$1/"
