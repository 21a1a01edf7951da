#!/bin/sh
# Renders the pictures of the README's gallery into docs/.
# usage: gallery.sh SPHEREVIEW
set -eu

program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
scenes=$root/scenes

picture() {
    name=$1
    shift
    "$program" render "$@" --size 500x500 --shade studio -o "$root/docs/gallery-$name.png"
}

dark="--background #202430"
# shellcheck disable=SC2086
{
    picture helix "$scenes/helix.xyz" --frame 15 --view 60,0 --samples 16 $dark
    picture crystal "$scenes/crystal.extxyz" --view iso --sun -3,6,-2 --sun-strength 0.5 --sky 0.8 --samples 16 $dark
    picture packing "$scenes/packing.csv" --samples 16 --sun -4,5,5 --sun-strength 0.6 --sky 0.7 $dark
    python3 "$scenes/make/sphereflake.py" | picture sphereflake - --sun -5,6,-6 --sun-strength 0.6 --sky 0.7 --samples 4 --lights 64 $dark
    picture planets "$scenes/planets.toml" --samples 16
}
