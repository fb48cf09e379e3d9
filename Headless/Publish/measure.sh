# shellcheck shell=bash
# What publish.sh --measure packs besides the program. Sourced by it.

# Fills the folder: player/ with every script assembly, project/, cache/ with compiled shaders, states/ of a software device, the model's estimates.
pack_measurement() {
    local scripts=() file
    for file in "$root"/Build/ScriptAssemblies/*.dll; do scripts+=("$(basename "$file" .dll)"); done
    publish_program Measure "$staging/player" "${scripts[@]}"
    find "$staging/player" -name '*.pdb' -delete
    mkdir "$staging/project"
    # Tests read the manual's text; its pictures are a fifth of all.
    tar -C "$root" --exclude='*/Documentation~/images' -cf - Packages Assets ProjectSettings | tar -C "$staging/project" -xf -
    "$root/Build/dotnet/bin/Headless.Bench/release/sphbench" "$root" model > "$staging/model.txt"
    git -C "$root" describe --always --dirty=+ --abbrev=12 > "$staging/commit.txt" 2> /dev/null || echo unknown > "$staging/commit.txt"
    [[ $system == windows ]] || pack_openssl
    pack_shaders
    pack_states
    write_start
}

# .NET's hashes take OpenSSL, which not every machine has; there it is taken from here.
pack_openssl() {
    local file
    mkdir "$staging/player/openssl"
    for file in libssl.so.3 libcrypto.so.3; do
        cp -L "$(ldconfig -p | awk -v f="$file" '$1 == f && /x86-64/ { print $NF; exit }')" "$staging/player/openssl/$file" 2> /dev/null \
            || echo "publish: $file is not installed here (Debian: apt install libssl3), so the folder runs only where OpenSSL 3 is" >&2
    done
}

# The user's compiled shaders, and what is missing of the packages': a machine without a compiler cannot make them. They are the same on every system.
pack_shaders() {
    local users=${XDG_CACHE_HOME:-$HOME/.cache}/sphplayer/shaders cache=$staging/cache/sphplayer/shaders file
    mkdir -p "$cache"
    if [[ -d $users ]]; then
        # Not those of Microsoft's compiler.
        (cd "$users" && find . -name '*.shader' -print0 | while IFS= read -r -d '' file; do
            head -c 64 "$file" | grep -aqi glslang && printf '%s\0' "$file"
        done | xargs -0 -r cp --parents -t "$cache")
    fi
    "$root/Build/dotnet/bin/Headless.Checks/release/sphchecks" "$root" --shader-cache "$cache" --only buffers >&2 \
        || echo "publish: not every shader could be compiled; those parts of the measurement will name them" >&2
}

# The first steps of samples on a software device, to compare a card's with. What is compiled on the way is packed too.
pack_states() {
    local software work=$staging/work
    software=$("$root/Build/dotnet/bin/Headless.Player/release/sphplayer" devices 2> /dev/null | sed -n 's/^\([0-9]*\): .*\[Cpu,.*/\1/p' | head -n 1)
    if [[ -z $software ]]; then
        echo "publish: there is no software device here (Debian: apt install mesa-vulkan-drivers), so no states are packed to compare a card's with" >&2
        return
    fi
    XDG_CACHE_HOME=$staging/cache "$root/Build/dotnet/bin/Headless.Measure/release/sphmeasure" --project "$root" --device "$software" --minutes 20 \
        --parts frame,states --out "$work" >&2 || refuse "the samples do not run here: see what stands above."
    mv "$work/states" "$staging/states"
    rm -rf "$work" "$staging"/states/*/play "$staging"/cache/sphplayer/pipelines-*
}

write_start() {
    if [[ $system == linux ]]; then
        printf '%s\n' '#!/bin/sh' "# Measures this machine's graphics device; --help tells what it takes." 'exec "$(dirname "$0")/player/sphmeasure" "$@"' > "$staging/run.sh"
        chmod +x "$staging/run.sh"
    else
        printf '%s\r\n' '@echo off' '"%~dp0player\sphmeasure.exe" %*' 'pause' > "$staging/run.cmd"
    fi
}
