#!/usr/bin/env bash
# publish.sh [DIR] [--system linux|windows] [--measure linux|windows]: the player as one folder that needs no .NET, or, with --measure, what measures a
# machine that has nothing but a Vulkan driver. ./run publish calls it.
#
# DIR is filled only when it is not there, is empty, or has nothing but what an earlier publish wrote and nobody changed:
# a list of its files, with their SHA-256, is in DIR/sphplayer-files.txt. Anything else is refused before anything is built,
# and nothing in DIR changes until the new files are complete beside it.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
list=sphplayer-files.txt
staging=

refuse() {
    echo "publish: $*" >&2
    exit 2
}

# Refuses a folder that is not ours to fill. Sets ours to the files that an earlier publish wrote and that are still there.
inspect() {
    local file sum listed=() changed
    declare -A written=()
    ours=()
    [[ -e $target || -L $target ]] || return 0
    [[ -d $target ]] || refuse "'$target' is a file; name a folder."
    [[ -r $target && -w $target && -x $target ]] || refuse "'$target' cannot be written."
    if [[ -f $target/$list && ! -L $target/$list ]]; then
        while read -r sum file; do
            [[ $sum =~ ^[0-9a-f]{64}$ && $file == ./* && $file != *..* ]] \
                || refuse "'$target/$list' is not a list that publish wrote; name another folder."
            written[$file]=$sum
        done < "$target/$list"
        written[./$list]=
    fi
    while IFS= read -r -d '' file; do
        [[ -v written[$file] ]] || refuse "'$target' has '${file#./}', which publish did not write; name another folder, or move it away."
        [[ $file == "./$list" ]] || listed+=("$file")
    done < <(cd "$target" && find . ! -type d -print0)
    while IFS= read -r -d '' file; do
        printf '%s\n' "${!written[@]}" | grep -qF -- "$file/" \
            || refuse "'$target' has the folder '${file#./}', which publish did not write; name another folder, or move it away."
    done < <(cd "$target" && find . -mindepth 1 -type d -print0)
    ((${#listed[@]})) || return 0
    changed=$(cd "$target" && sha256sum -- "${listed[@]}" | while read -r sum file; do
        [[ ${written[$file]} == "$sum" ]] || { echo "${file#./}"; break; }
    done)
    [[ -z $changed ]] || refuse "'$target/$changed' has changed since publish wrote it; name another folder, or move it away."
    ours=("${listed[@]}")
}

# Moves the new files into place. The list of the old files goes last and that of the new ones comes first, so that a folder left
# by an interruption can still be published to.
replace() {
    local file
    mkdir -p -- "$target"
    if ((${#ours[@]})); then (cd "$target" && rm -f -- "${ours[@]}"); fi
    find "$target" -mindepth 1 -depth -type d -empty -delete
    mv -f -- "$staging/$list" "$target/$list"
    find "$staging" -mindepth 1 -maxdepth 1 -exec mv -t "$target" -- {} +
}

# publish_program PROJECT DIR SCRIPT...: a program with its .NET, and the script assemblies that it is to run, so that trimming keeps what they call.
publish_program() {
    local project=$1 to=$2 script projects='' runtime=linux-x64
    shift 2
    [[ $system == linux ]] || runtime=win-x64
    for script in "$@"; do projects+=${projects:+%3B}$root/Headless/Package/$script/$script.csproj; done
    dotnet publish "$root/Headless/$project/Headless.$project.csproj" -c Release --nologo -v quiet -clp:ErrorsOnly -o "$to" \
        -p:ScriptProjects="$projects" -p:PublishRuntime="$runtime"
    mkdir -p "$to/ScriptAssemblies"
    for script in "$@"; do cp "$root/Build/ScriptAssemblies/$script.dll" "$to/ScriptAssemblies/"; done
}

clean() { [[ -z $staging ]] || rm -rf -- "$staging"; }

# Reads the words. Sets folder, system and measure.
read_words() {
    local folders=()
    folder='' system=linux measure=''
    while (($#)); do
        case $1 in
            --system=* | --measure=*)
                set -- "${1%%=*}" "${1#*=}" "${@:2}"
                continue
                ;;
            --system | --measure)
                [[ ${2-} == linux || ${2-} == windows ]] || refuse "$1 takes linux or windows, found '${2-}'."
                system=$2
                [[ $1 == --system ]] || measure=yes
                shift
                ;;
            -*) refuse "'$1' is not understood: ./run publish --help tells what it takes (for a folder of that name: ./$1)." ;;
            *) folders+=("$1") ;;
        esac
        shift
    done
    ((${#folders[@]} <= 1)) || refuse "one folder is expected, not ${#folders[@]}: ${folders[*]:1} is too much."
    ((${#folders[@]} == 0)) || [[ -n ${folders[0]} ]] || refuse "the folder's name is empty."
    folder=${folders[0]-$root/Build/$([[ -n $measure ]] && echo "measure-$system" || echo publish)}
}

read_words "$@"
target=$(realpath -m -- "$folder")
[[ $target != / ]] || refuse "'/' is not a folder to publish to."
[[ $target != "$(realpath -m -- "${HOME:-/}")" ]] || refuse "'$target' is your home folder; name a folder in it."
[[ $root/ != "$target"/* ]] || refuse "'$target' holds this project; name a folder outside of it, or none for Build/publish."
[[ $target != "$root"/* || $target == "$root"/Build/* ]] || refuse "'$target' is a folder of this project; name one outside of it, or none for Build/publish."
inspect

"$root/run" build "$([[ -n $measure ]] && echo Headless.slnx || echo Play.slnx)"
mkdir -p -- "$(dirname -- "$target")" || refuse "'$(dirname -- "$target")' cannot be made."
trap clean EXIT
staging=$(mktemp -d -- "$(dirname -- "$target")/.sphplayer-publish.XXXXXX") || refuse "'$(dirname -- "$target")' cannot be written."
if [[ -n $measure ]]; then
    source "$root/Headless/Publish/measure.sh"
    pack_measurement
else
    scripts=(SphFluid SphFluid.Universal SphFluid.Thesis SphFluid.Playback SphFluid.PySph SphFluid.Validation.Laboratory SphFluid.Validation)
    publish_program Player "$staging" "${scripts[@]}"
fi
(cd "$staging" && find . -type f ! -path "./$list" -print0 | LC_ALL=C sort -z | xargs -0 sha256sum > "$list")

# Building took a while: what has come into the folder meanwhile stays as well.
inspect
replace
size=$(du -sh "$target" | cut -f1)
if [[ -n $measure ]]; then echo "$target ($size): copy it, and start $([[ $system == linux ]] && echo run.sh || echo run.cmd) there"
else echo "$target ($size): start it with sphplayer play --project DIR --scene FILE.unity"; fi
