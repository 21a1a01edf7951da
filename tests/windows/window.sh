#!/bin/sh
# The window of the program for Windows: tests/windows/window.sh SPHEREVIEW.EXE SPHEREVIEW
# A sphere is dragged with the mouse, the scene saved, and F12 writes what `render` of this system's program writes; opened from a folder, no
# console stays beside the window. Needs a display.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
exe=$1 native=$2
folder=$(mktemp -d)
trap 'kill $job 2>/dev/null || true; rm -rf "$folder"' EXIT
job=
cd "$folder"

fail() { echo "FAILED: $*" >&2; cat err.txt >&2; exit 1; }
# waits_for COMMAND...: until the command succeeds; a minute at most.
waits_for() {
    tries=0
    until "$@" >/dev/null 2>&1; do
        tries=$((tries + 1))
        [ $tries -lt 300 ] || fail "waited in vain for: $*"
        sleep 0.2
    done
}
is_saved() { ! cmp -s scene.txt before.txt; }

printf '2\n255 0 0\n0 0 200\n60\n0 0 255\n90 0 300\n30\n' >scene.txt
cp scene.txt before.txt
"$here/wine" "$exe" scene.txt --shade flat --samples 1 2>err.txt &
job=$!
waits_for xdotool search --onlyvisible --name 'scene.txt - sphereview'
window=$(xdotool search --onlyvisible --name 'scene.txt - sphereview' | tail -n 1)
eval "$(xdotool getwindowgeometry --shell "$window")"

xdotool mousemove $((X + WIDTH / 3)) $((Y + HEIGHT / 2))
xdotool key F12
waits_for test -s scene.png
"$native" render before.txt -o native.png
cmp scene.png native.png || fail "F12"

xdotool click 1  # selects it
xdotool mousedown 1
for step in 1 2 3 4 5 6 7 8; do xdotool mousemove $((X + WIDTH / 3 + 10 * step)) $((Y + HEIGHT / 2 + 5 * step)); done
xdotool mouseup 1
waits_for xdotool search --onlyvisible --name '^scene.txt \* - sphereview'
xdotool key ctrl+s
waits_for is_saved
waits_for xdotool search --onlyvisible --name '^scene.txt - sphereview'
xdotool key F12
waits_for test -s scene-1.png
"$native" render scene.txt -o native.png
cmp scene-1.png native.png || fail "F12 after a drag"
! cmp -s scene.png scene-1.png || fail "the drag is not in the picture"

xdotool key ctrl+q
status=0
wait $job || status=$?
job=
[ $status = 0 ] || fail "status $status"

# As from a folder, in a console of its own, whose window has the program's name.
is_shown() { xdotool search --onlyvisible --name "$1"; }
is_gone() { ! is_shown "$1"; }
"$here/wine" start /unix "$exe" "$folder/scene.txt" 2>err.txt &
job=$!
waits_for is_shown '^scene.txt - sphereview'
waits_for is_gone 'sphereview\.exe'
is_shown '^scene.txt - sphereview' >/dev/null || fail "the window went with the console"
xdotool windowfocus "$(is_shown '^scene.txt - sphereview' | tail -n 1)" key ctrl+q
waits_for is_gone 'sphereview'
wait $job
job=
echo "all as it should be"
