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
    picture crystal "$scenes/crystal.extxyz" --view iso --samples 16 $dark
    picture packing "$scenes/packing.csv" --samples 16 $dark
    python3 "$scenes/make/sphereflake.py" | picture sphereflake - --fit --samples 16 --lights 64 $dark
    python3 "$scenes/make/drop.py" | picture drop - --view 35,30 --samples 16 --lights 64 --color-by height --colormap coolwarm --legend $dark
    picture planets "$scenes/planets.toml" --samples 16
}
