#!/usr/bin/env bash
# Gets what ./run and ./test need. Safe to run again: what is there stays, and a second run ends at once.
#   ./setup.sh          for ./run
#   ./setup.sh test     for ./test and ./run check as well
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
purpose=${1:-run}
cache=${XDG_CACHE_HOME:-$HOME/.cache}/sphfluid
dotnet_major=10

run_packages=(libvulkan1 mesa-vulkan-drivers glslang-tools ffmpeg gnuplot-nox)
test_packages=(vulkan-validationlayers spirv-tools vkd3d-compiler wine64 gcc-mingw-w64-x86-64 npm)
# Microsoft's HLSL compiler, used by ./run check and ./test only: it is a file in this npm package.
compiler_package=gl@8.1.6
compiler_file=package/deps/windows/dll/x64/d3dcompiler_47.dll
compiler_sha256=e994847e01a6f1e4cbdc5a864616ac262f67ee4f14db194984661a8d927ab7f4

say() { printf 'setup: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

case $purpose in
    run) packages=("${run_packages[@]}") ;;
    test) packages=("${run_packages[@]}" "${test_packages[@]}") ;;
    *) fail "'$purpose' is not understood: nothing or 'test' is." ;;
esac

stamp=$root/Build/setup-$purpose-$(sha256sum < "${BASH_SOURCE[0]}" | cut -c1-16)
[[ -e $stamp ]] && exit 0

check_dotnet() {
    if ! command -v dotnet > /dev/null || ! dotnet --list-sdks | grep -q "^$dotnet_major\."; then
        fail ".NET SDK $dotnet_major.0 is not installed. Get it from https://dotnet.microsoft.com/download/dotnet/$dotnet_major.0 (Debian's archive does not have it), put 'dotnet' on the PATH and start again."
    fi
}

installed() { [[ $(dpkg-query -W -f '${Status}' "$1" 2> /dev/null) == *" installed" ]]; }

install_packages() {
    local missing=() package sudo=()
    if ! command -v dpkg-query > /dev/null; then
        say "this is not a Debian system. Needed are the Vulkan loader and a driver, glslangValidator, ffmpeg and gnuplot$([[ $purpose == test ]] && echo ', the Vulkan validation layers, spirv-val, vkd3d-compiler, wine64, x86_64-w64-mingw32-gcc and npm')."
        return
    fi
    for package in "${packages[@]}"; do
        # A program of the user's own build serves as well.
        [[ $package == ffmpeg ]] && command -v ffmpeg > /dev/null && continue
        [[ $package == gnuplot-nox ]] && command -v gnuplot > /dev/null && continue
        [[ $package == glslang-tools ]] && command -v glslangValidator > /dev/null && continue
        [[ $package == npm ]] && command -v npm > /dev/null && continue
        installed "$package" || missing+=("$package")
    done
    ((${#missing[@]})) || return 0
    if [[ $EUID -ne 0 ]]; then
        command -v sudo > /dev/null || fail "as root: apt-get install ${missing[*]}"
        sudo=(sudo)
    fi
    say "installing ${missing[*]}"
    "${sudo[@]}" apt-get update -q > /dev/null || say "apt-get update failed; trying with the lists at hand."
    if ! "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" > "$cache/apt.log" 2>&1; then
        tail -n 5 "$cache/apt.log" >&2
        fail "could not install ${missing[*]} (all of it: $cache/apt.log)."
    fi
}

fetch_compiler() {
    local target=$cache/d3dcompiler_47.dll folder
    [[ -e $target ]] && return
    command -v npm > /dev/null || fail "npm is missing: it fetches the HLSL compiler for ./run check. See https://nodejs.org/en/download"
    say "fetching d3dcompiler_47.dll (npm package $compiler_package)"
    folder=$(mktemp -d)
    (cd "$folder" && npm pack --silent "$compiler_package" > /dev/null && tar -xzf gl-*.tgz "$compiler_file") \
        || fail "npm could not fetch $compiler_package."
    echo "$compiler_sha256  $folder/$compiler_file" | sha256sum --check --quiet > /dev/null || fail "$compiler_file of $compiler_package is not the file expected."
    mv "$folder/$compiler_file" "$target"
    rm -r "$folder"
}

mkdir -p "$cache" "$root/Build"
check_dotnet
install_packages
[[ $purpose == test ]] && fetch_compiler
touch "$stamp"
