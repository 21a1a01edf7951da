#!/bin/sh
# film.sh TRAJECTORY FILM: makes a film of the pictures that the manifests in frames/ have of the trajectory as it is now, in the order of
# their names, whatever the film's ending says: .mp4, .webm, .mkv and .png (animated), which lose nothing, .gif. FPS: pictures a second [30].
set -eu
# As `render --movie` has it. Encoders of yuv420p want even sides.
usual='-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p
    -colorspace bt709 -color_range tv -color_trc bt709 -color_primaries bt709'
case $2 in
*.mkv) codec='-c:v ffv1' ;;
*.png) codec='-c:v apng -plays 0 -f apng' ;;
*.gif) codec='-vf split[a][b];[a]palettegen[p];[b][p]paletteuse' ;;
*.webm) codec="-c:v libvpx-vp9 -crf 24 -b:v 0 $usual" ;;
*.mp4) codec="-c:v libx264 -crf 18 $usual" ;;
*) echo "film.sh: found '$2', expected a name that ends with .mp4, .webm, .mkv, .png or .gif" >&2; exit 2 ;;
esac
# What an earlier, longer trajectory has left in frames/ is none of this film's.
sum=$(sha256sum <"$1")
grep -h "\"scene_sha256\":\"${sum%% *}\"" frames/part-*.jsonl | sed -n 's|.*"picture":"\(frames/[0-9]*\.png\)".*|\1|p' | sort -u >frames/film.txt
[ -s frames/film.txt ] || { echo "film.sh: found no picture of $1 as it is now in frames/part-*.jsonl" >&2; exit 2; }
xargs ls <frames/film.txt >/dev/null  # says which are not there
part=$(dirname -- "$2")/part-of-$(basename -- "$2")
# shellcheck disable=SC2086
xargs cat <frames/film.txt | ffmpeg -v error -y -f image2pipe -c:v png -framerate "${FPS:-30}" -i - $codec "$part"
mv -- "$part" "$2"
