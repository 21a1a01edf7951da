#!/bin/sh
# The program for Windows against the one for this system: tests/windows/program.sh SPHEREVIEW.EXE SPHEREVIEW
# The same bytes, also by WGL, the same exit statuses; names beyond ASCII, long paths, names of the network, other line ends, Ctrl+C.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
export WINEPREFIX="${WINEPREFIX:-$here/../../build/windows/wine}"
exe=$1 native=$2
scenes=$here/../../scenes
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

windows() { "$here/wine" "$exe" "$@"; }
fail() { echo "FAILED: $*" >&2; exit 1; }

# ends STATUS WORDS...: how the command ends, and that it says at most one line.
ends() {
    expected=$1 status=0
    shift
    windows "$@" >out.txt 2>err.txt </dev/null || status=$?
    [ "$status" = "$expected" ] || fail "status $status instead of $expected of: $* $(cat err.txt)"
    [ "$(wc -l <err.txt)" -le 1 ] || fail "more than one line of: $* $(cat err.txt)"
}
says() { grep -q -F -- "$1" err.txt || fail "'$1' is not in: $(cat err.txt)"; }

for scene in "$scenes"/input*.txt "$scenes"/planets.toml "$scenes"/helix.xyz "$scenes"/packing.csv; do
    for options in "" "--shade headlight" "--samples 16 --size 200x200" "--shade studio --size 200x200"; do
        # shellcheck disable=SC2086
        "$native" render "$scene" --backend cpu $options -o here.png
        # shellcheck disable=SC2086
        ends 0 render "$scene" --backend cpu $options -o there.png
        cmp here.png there.png || fail "$scene $options"
    done
done

for scene in "$scenes"/input*.txt; do
    "$native" render "$scene" --backend cpu -o here.png
    ends 0 render "$scene" --backend wgl -o there.png
    cmp here.png there.png || fail "$scene with WGL"
done

# What Windows is told of the program.
for word in UTF-8 longPathAware PerMonitorV2; do grep -q -a -F "$word" "$exe" || fail "the manifest lacks $word"; done

ends 0 --version
ends 0 render "$scenes/input4.txt" --backend cpu -s 60x60 -o small.png
ends 0 render "$scenes/input4.txt" --backend cpu -s 60x60 --expect small.png
ends 1 render "$scenes/input1.txt" --backend cpu -s 60x60 --expect small.png
ends 2 render missing.txt
says missing.txt
ends 2 render --no-such-option
ends 3 render "$scenes/input1.txt" --backend egl
ends 4 render "$scenes/input1.txt" --backend cpu -o no/such/folder/a.png
ends 4 render "$scenes/input1.txt" --backend cpu -o .
ends 0 render "$scenes/input1.txt" --backend cpu -s 40x40 -o NUL
{ [ ! -e NUL ] && [ ! -e NUL.png ]; } || fail "NUL became a file"
ends 0 doctor

# A reader that has gone, as `| head` does, is told as elsewhere.
mkfifo gone
windows --licenses >gone 2>err.txt &
job=$!
head -c 1 gone >head.txt
status=0
wait $job || status=$?
[ "$status" = 4 ] || fail "status $status where nobody reads any more: $(cat err.txt)"
says 'stdout: cannot be written: Broken pipe'

# Names beyond ASCII, in arguments, patterns, outputs and messages.
cp "$scenes/input1.txt" 'größe→球.txt'
mkdir 'Ωmega'
ends 0 render 'größe→球.txt' --backend cpu -s 40x40 -o 'Ωmega/{name}.png'
[ -e 'Ωmega/größe→球.png' ] || fail "no Ωmega/größe→球.png: $(find .)"
ends 0 convert 'größe→球.txt' 'ö.toml'
"$native" convert 'größe→球.txt' here.toml
cmp here.toml 'ö.toml'
ends 0 explain 'ö.toml' --pixel 20,20 --size 40x40
ends 2 render 'nö.txt'
says 'nö.txt: cannot be read'

# A path of more than 260 characters.
long=$(printf 'a%.0s' $(seq 60))
mkdir -p "$long/$long/$long/$long/$long"
cp "$scenes/input1.txt" "$long/$long/$long/$long/$long/scene.txt"
ends 0 render "$long/$long/$long/$long/$long/scene.txt" --backend cpu -s 40x40 -o "$long/$long/$long/$long/$long/b.png"
cmp "$long/$long/$long/$long/$long/b.png" 'Ωmega/größe→球.png' || fail "a long path"

# A name of the network, which Wine looks up in its folder unc.
mkdir -p "$WINEPREFIX/dosdevices/unc/sphereview"
ln -sfn "$folder" "$WINEPREFIX/dosdevices/unc/sphereview/share"
cp "$scenes/input1.txt" scene.txt
ends 0 render '\\sphereview\share\scene.txt' --backend cpu -s 40x40 -o '\\sphereview\share\network.png'
cmp network.png 'Ωmega/größe→球.png' || fail "a name of the network"
ends 0 render '\\sphereview\share\scene.txt' --backend cpu -s 40x40 -o '\\sphereview\share\new\{name}.png'
cmp new/scene.png network.png || fail "a folder of the network"
ends 4 render '\\sphereview\share\scene.txt' --backend cpu -s 40x40 -o '\\sphereview\share\missing\a.png'

# Line ends of Windows, and standard streams, through which no byte changes.
sed 's/$/\r/' "$scenes/input1.txt" >crlf.txt
ends 0 render crlf.txt --backend cpu -s 40x40 -o crlf.png
cmp crlf.png 'Ωmega/größe→球.png' || fail "other line ends"
windows render - --backend cpu -s 40x40 -o - <crlf.txt >streamed.png
cmp streamed.png crlf.png || fail "standard streams"

# Ctrl+C ends a render that would take hours, and nothing stays behind.
python3 - >endless.txt <<'PY'
from math import nextafter
radius = 100.0
print(20)
for i in range(20):
    print("255 0 0\n0 0 0\n%r" % radius)
    radius = nextafter(radius, 200)
PY
windows render endless.txt --backend cpu -s 1000x100000 -o endless.png 2>/dev/null &
job=$!
# It takes signals once it renders: that alone needs the processor for so many seconds.
is_rendering() {
    pgrep -f 'sphereview.exe render endless' | xargs -r ps -o cputimes= -p | awk '$1 >= 3 { found = 1 } END { exit !found }'
}
tries=0
until is_rendering || [ $tries -gt 600 ]; do
    tries=$((tries + 1))
    sleep 0.2
done
pkill -INT -f 'sphereview.exe render endless'
status=0
wait $job || status=$?
[ $status = 130 ] || fail "Ctrl+C: status $status"
[ "$(find . -name '*endless*' | wc -l)" = 1 ] || fail "Ctrl+C left: $(find . -name '*endless*')"
echo "all as it should be"
