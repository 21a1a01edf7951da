#!/bin/sh
# part.sh TRAJECTORY K N: renders part K of N of a trajectory's frames into frames/. Frames that are there and whole are kept, so a part
# that was killed is simply run again. Options for `sphereview render` (size, shading, camera) stand in RENDER_OPTIONS.
set -eu
trajectory=$1 part=$2 parts=$3
mkdir -p frames
# shellcheck disable=SC2086
exec "${SPHEREVIEW:-sphereview}" render "$trajectory" --frames all --part "$part/$parts" --skip-existing \
    --manifest "frames/part-$part.jsonl" -o 'frames/{frame:07}.png' ${RENDER_OPTIONS:-}
