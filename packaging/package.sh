# The packages that ./dev package makes; read by it. $root, say, need, build and $build_packages are its own.

# Of the same sources the same bytes, whenever they are packed: the date of all that is packed is that of the version's heading in
# CHANGELOG.md.
set_date() {
    version=$(sed -n 's/^project(sphereview VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt")
    date=$(sed -n "s/^## $version (\([0-9]*-[0-9]*-[0-9]*\))\$/\1/p" "$root/CHANGELOG.md")
    [ -n "$date" ] && SOURCE_DATE_EPOCH=$(date -u -d "$date" +%s) || { say "CHANGELOG.md has no heading '## $version (YYYY-MM-DD)'"; exit 1; }
    export SOURCE_DATE_EPOCH
}

# Builds a preset and packs it; what cpack says goes to the build's log.
pack() {
    build "$@"
    cpack --config "$root/build/$1/CPackConfig.cmake" >>"$root/build/$1.log" 2>&1 || { tail -n 20 "$root/build/$1.log" >&2; exit 1; }
    rm -rf "$root/build/packages/_CPack_Packages"
}

# The number's lowest bytes, the lowest first: bytes NUMBER HOW_MANY.
bytes() {
    number=$1
    for _ in $(seq "$2"); do
        # shellcheck disable=SC2059
        printf "\\$(printf %o $((number & 255)))"
        number=$((number >> 8))
    done
}

# An .ico with a PNG of each usual size, which the program for this system renders: a head of 6 bytes, for each picture 16 bytes that
# say its sides (0 means 256), 1 plane of 32 bits, its length and where it begins; then the pictures.
icon_for_windows() {
    icon=$root/build/icon.ico
    sides="16 32 48 256"
    place=$((6 + 4 * 16))
    {
        bytes 0 2
        bytes 1 2
        bytes 4 2
        for side in $sides; do
            "$program" render "$root/packaging/icon.toml" -s "${side}x$side" --samples 16 --shade headlight --backend cpu -o "$icon-$side.png"
            length=$(wc -c <"$icon-$side.png")
            bytes "$side" 1
            bytes "$side" 1
            bytes 0 2
            bytes 1 2
            bytes 32 2
            bytes "$length" 4
            bytes $place 4
            place=$((place + length))
        done
        for side in $sides; do cat "$icon-$side.png"; done
    } >"$icon"
    echo "$icon"
}

# The executable for Windows and what it links, by Debian's cross compiler; its icon is rendered by the program for this system.
pack_windows() {
    need_windows_parts
    build release
    pack windows "-DSPHEREVIEW_ICON=$(icon_for_windows)"
}

# A wheel for the Python that PYTHON names, with the libraries inside that a system may lack. What builds it is in an environment of its
# own, so that only what changed is compiled anew.
pack_wheel() {
    # shellcheck disable=SC2086
    need $build_packages python3-dev python3-venv
    python=${PYTHON:-python3}
    tools=$root/build/wheel/tools-$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    [ -x "$tools/bin/auditwheel" ] || { "$python" -m venv "$tools" && "$tools/bin/pip" install -q --require-hashes -r "$root/python/requirements.txt" >&2; }
    rm -rf "$root/build/wheel/made"
    rm -f "$root"/build/packages/*-cp"$("$python" -c 'import sys; print("%d%d" % sys.version_info[:2])')"-*.whl
    say "building the wheel"
    PATH=$tools/bin:$PATH
    pip wheel -q --disable-pip-version-check --no-deps --no-build-isolation --config-settings build-dir=build/wheel/tree \
        -w "$root/build/wheel/made" "$root" >&2
    auditwheel repair -w "$root/build/packages" "$root"/build/wheel/made/*.whl >&2
}

# Says of all packages what is inside, and their sums.
sum_up() (
    cd "$root/build/packages"
    rm -f ./*.spdx.json SHA256SUMS
    set --
    for package in *; do
        case $package in
        *.deb) built=release ;;
        *.tar.xz) built=portable ;;
        *.zip) built=windows ;;
        *.whl) set -- "$@" "$package="; continue ;;  # which has the list itself
        *) say "of $package it is not known what is inside"; exit 1 ;;
        esac
        set -- "$@" "$package=$root/build/$built/generated/parts.json"
    done
    python3 -B "$root/packaging/parts.py" spdx sphereview.spdx.json "$@"
    sha256sum -- * >SHA256SUMS.part
    mv SHA256SUMS.part SHA256SUMS
)

# make_packages KIND...: in build/packages, each in place of the former ones of its kind.
make_packages() {
    # shellcheck disable=SC2086
    need $package_packages
    set_date
    mkdir -p "$root/build/packages"
    [ $# -gt 0 ] || set -- deb tar
    for kind in "$@"; do
        case $kind in
        deb) rm -f "$root"/build/packages/*.deb && pack release ;;
        tar) rm -f "$root"/build/packages/*.tar.xz && pack portable ;;
        wheel) pack_wheel ;;
        windows) rm -f "$root"/build/packages/*.zip && pack_windows ;;
        sums) ;;
        *) say "found the kind of package '$kind', expected deb, tar, windows, wheel or sums"; exit 2 ;;
        esac
    done
    sum_up
    say "made in build/packages:"
    ls "$root/build/packages"
}
