#!/usr/bin/env bash
# Gets what ./run and ./test need. Safe to run again: what is there stays, and a second run ends at once.
#   ./setup.sh          for ./run
#   ./setup.sh test     for ./test and ./run check as well
#   ./setup.sh docs     for ./run docs
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
purpose=${1:-run}
cache=${XDG_CACHE_HOME:-${HOME:-$root/Build}/.cache}/sphplayer
dotnet_major=10

run_packages=(libvulkan1 mesa-vulkan-drivers glslang-tools ffmpeg gnuplot-nox)
test_packages=(vulkan-validationlayers libvulkan-dev gcc libc6-dev spirv-tools spirv-cross vkd3d-compiler wine64 gcc-mingw-w64-x86-64 npm)
# Runs exported cases in ./test; where the archive does not serve it, the tests that need it are skipped and counted.
engine_packages=(python3-pysph python3-mpi4py python3-pyzoltan openmpi-bin python3-meshio)
docs_packages=(doxygen)
# A program of the user's own build serves as well.
declare -A program_of=([ffmpeg]=ffmpeg [gnuplot-nox]=gnuplot [glslang-tools]=glslangValidator [npm]=npm [doxygen]=doxygen)
# Microsoft's HLSL compilers, used by ./run check and ./test only: files in these npm packages.
fxc=(d3dcompiler_47.dll gl@8.1.6 package/deps/windows/dll/x64/d3dcompiler_47.dll
    e994847e01a6f1e4cbdc5a864616ac262f67ee4f14db194984661a8d927ab7f4)
dxc=(dxcompiler.dll webgpu@0.6.2 package/dist/win32-x64/dxcompiler.dll
    04cf618004bf19f789f54e8931c7f7106223bccd354b093c4ff725c748512602)
# The translator of wgpu into WebGPU's language, and Chrome's WebGPU, for ./run check --only wgsl.
naga=(naga.mjs naga-wasm@30.1.0 package/dist/wasm/naga.js
    1338164cbc245394fe22309e2a89f1cd24a83733b23db4c97478c5f13b2c7e0d)
naga_wasm=(naga_bg.wasm naga-wasm@30.1.0 package/dist/wasm/naga_bg.wasm
    c7c5cd7322c14c5a0da57bf707fef71d1a51ee2c5094c0786d8216e04cfee4de)
dawn=(dawn.node webgpu@0.6.2 package/dist/linux-x64/dawn.node
    ab18a659f8325e874ea45c80347b64336d7f748601102753d2bc669fdecfd710)

say() { printf 'setup: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

case $purpose in
    run) packages=("${run_packages[@]}") ;;
    test) packages=("${run_packages[@]}" "${test_packages[@]}") ;;
    docs) packages=("${docs_packages[@]}") ;;
    *) fail "'$purpose' is not understood: nothing, 'test' or 'docs' is." ;;
esac

stamp=$root/Build/setup-$purpose-$(sha256sum < "${BASH_SOURCE[0]}" | cut -c1-16)
[[ -e $stamp ]] && exit 0

check_dotnet() {
    if ! command -v dotnet > /dev/null || ! dotnet --list-sdks | grep -q "^$dotnet_major\."; then
        fail ".NET SDK $dotnet_major.0 is not installed. Get it from https://dotnet.microsoft.com/download/dotnet/$dotnet_major.0 (Debian's archive does not have it), put 'dotnet' on the PATH and start again."
    fi
}

# apt ARGUMENT...: apt-get as root. It waits for another that works, ten minutes at most; what it says of a failure is in apt.log.
apt() {
    local sudo=() tries output
    [[ $EUID -eq 0 ]] || sudo=(sudo)
    for ((tries = 0; ; tries++)); do
        output=$(${sudo[@]+"${sudo[@]}"} env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -o DPkg::Lock::Timeout=600 "$@" 2>&1) && return
        # Locks of dpkg it waits for by itself.
        [[ $output == *"Could not get lock /var/lib/apt/lists"* ]] && ((tries < 120)) || break
        ((tries)) || say "waiting for another apt"
        sleep 5
    done
    printf '%s\n' "$output" > "$cache/apt.log"
    return 1
}

# install_missing PACKAGE...: false where it fails.
install_missing() {
    local missing=() package
    for package in "$@"; do installed "$package" || missing+=("$package"); done
    ((${#missing[@]})) || return 0
    [[ $EUID -eq 0 ]] || command -v sudo > /dev/null || fail "as root: apt-get install ${missing[*]}"
    say "installing ${missing[*]}"
    apt update || say "apt-get update failed; trying with the lists at hand."
    apt install -y --no-install-recommends "${missing[@]}"
}

installed() { [[ $(dpkg-query -W -f '${Status}' "$1" 2> /dev/null) == *" installed" ]]; }

install_packages() {
    local wanted=() package
    if ! command -v dpkg-query > /dev/null; then
        if [[ $purpose == docs ]]; then
            command -v doxygen > /dev/null || fail "Doxygen is missing: https://www.doxygen.nl/download.html"
            return
        fi
        say "this is not a Debian system. Needed are the Vulkan loader and a driver, glslangValidator, ffmpeg and gnuplot$([[ $purpose == test ]] && echo ', the Vulkan validation layers and headers, gcc, spirv-val, spirv-cross, vkd3d-compiler, wine64, x86_64-w64-mingw32-gcc and npm')."
        return
    fi
    for package in "${packages[@]}"; do
        command -v "${program_of[$package]-/}" > /dev/null || wanted+=("$package")
    done
    if ! install_missing ${wanted[@]+"${wanted[@]}"}; then
        tail -n 5 "$cache/apt.log" >&2
        fail "the packages could not be installed (all of it: $cache/apt.log)."
    fi
}

install_engine() {
    command -v dpkg-query > /dev/null || return 0
    install_missing "${engine_packages[@]}" || say "PySPH could not be installed (all of it: $cache/apt.log); tests that run exported cases are skipped."
}

# fetch_compiler FILE PACKAGE PATH SHA256: a file of an npm package into the cache.
fetch_compiler() {
    local target=$cache/$1 package=$2 file=$3 sha256=$4 folder
    [[ -e $target ]] && return
    command -v npm > /dev/null || { say "npm is missing: it fetches $1 for ./run check. See https://nodejs.org/en/download"; return 1; }
    say "fetching $1 (npm package $package)"
    folder=$(mktemp -d)
    (cd "$folder" && npm pack --silent --fetch-retries=0 "$package" > /dev/null && tar -xzf "${package%@*}"-*.tgz "$file") \
        || { say "npm could not fetch $package."; return 1; }
    echo "$sha256  $folder/$file" | sha256sum --check --quiet > /dev/null || { say "$file of $package is not the file expected."; return 1; }
    mv "$folder/$file" "$target"
    rm -r "$folder"
}

mkdir -p "$root/Build"
# Its name until 0.1.0.
old_cache=${cache%/*}/sphfluid
[[ -e $cache || ! -d $old_cache ]] || mv "$old_cache" "$cache" || say "'$old_cache' stays; what it holds is fetched again."
if ! mkdir -p "$cache" 2> /dev/null; then
    [[ $purpose != test ]] || fail "the folder '$cache' cannot be made, and the compilers of ./run check go there: set XDG_CACHE_HOME to one that can be written."
    cache=$root/Build
fi
[[ $purpose == docs ]] || check_dotnet
install_packages
if [[ $purpose == test ]]; then
    install_engine
    fetch_compiler "${fxc[@]}" || exit 1
    fetch_compiler "${dxc[@]}" || { say "without it ./run check leaves out DXC; the next run tries again."; exit 0; }
    fetch_compiler "${naga[@]}" && fetch_compiler "${naga_wasm[@]}" && fetch_compiler "${dawn[@]}" \
        || { say "without it ./run check leaves out WGSL; the next run tries again."; exit 0; }
fi
touch "$stamp"
