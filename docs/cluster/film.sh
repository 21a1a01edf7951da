#!/bin/sh
# film.sh FILM: makes a film of the pictures in frames/, in the order of their names, whatever its ending says: .mp4, .webm, .mkv (lossless),
# .gif. FPS: pictures a second [30].
set -eu
case $1 in
*.mkv) codec='-c:v ffv1' ;;
*.gif) codec='-vf split[a][b];[a]palettegen[p];[b][p]paletteuse' ;;
*.webm) codec='-c:v libvpx-vp9 -crf 24 -b:v 0 -pix_fmt yuv420p' ;;
# Encoders of yuv420p want even sides.
*) codec='-c:v libx264 -crf 18 -pix_fmt yuv420p -vf pad=ceil(iw/2)*2:ceil(ih/2)*2' ;;
esac
# shellcheck disable=SC2086
ffmpeg -v error -y -framerate "${FPS:-30}" -pattern_type glob -i 'frames/*.png' $codec "part-of-$1"
mv "part-of-$1" "$1"
