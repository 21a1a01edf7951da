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
    "$program" render "$@" --size 500x500 --shade headlight --samples 4 --background "#202430" -o "$root/docs/gallery-$name.png"
}

picture helix "$scenes/helix.xyz" --frame 15 --view 60,0
picture crystal "$scenes/crystal.extxyz" --view iso
picture packing "$scenes/packing.csv"
python3 "$scenes/make/sphereflake.py" | picture sphereflake -
