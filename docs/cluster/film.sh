#!/bin/sh
# film.sh FILM: makes a film of the pictures in frames/, in the order of their names, whatever its ending says: .mp4, .webm, .mkv and .png
# (animated), which lose nothing, .gif. FPS: pictures a second [30].
set -eu
# As `render --movie` has it. Encoders of yuv420p want even sides.
usual='-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p
    -colorspace bt709 -color_range tv -color_trc bt709 -color_primaries bt709'
case $1 in
*.mkv) codec='-c:v ffv1' ;;
*.png) codec='-c:v apng -plays 0 -f apng' ;;
*.gif) codec='-vf split[a][b];[a]palettegen[p];[b][p]paletteuse' ;;
*.webm) codec="-c:v libvpx-vp9 -crf 24 -b:v 0 $usual" ;;
*.mp4) codec="-c:v libx264 -crf 18 $usual" ;;
*) echo "film.sh: found '$1', expected a name that ends with .mp4, .webm, .mkv, .png or .gif" >&2; exit 2 ;;
esac
part=$(dirname -- "$1")/part-of-$(basename -- "$1")
# shellcheck disable=SC2086
ffmpeg -v error -y -framerate "${FPS:-30}" -pattern_type glob -i 'frames/*.png' $codec "$part"
mv -- "$part" "$1"
