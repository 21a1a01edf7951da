# Bare systems of Debian, for the shell scripts that source this file. They need root and debootstrap. A release's base system is downloaded
# once and kept in /var/cache/sphereview-systems.
# The script may set $mirror, where Debian's packages are, and $keep, which leaves the system's folder.
cache=/var/cache/sphereview-systems
mirror= keep=

say() { printf '%s\n' "systems: $*" >&2; }

leave() {
    for place in dev/shm dev/pts dev sys proc; do
        ! mountpoint -q "$system/$place" || umount "$system/$place" || return
    done
    if [ -n "$keep" ]; then say "left in $system"; else rm -rf --one-file-system "$system"; fi
}

# Makes the release's system in a fresh folder, named $system, which goes when the subshell ends.
make_system() {
    system=$(mktemp -d "${TMPDIR:-/tmp}/systems-$1-XXXXXX")
    chmod 755 "$system"  # for apt, which downloads as a user of its own
    trap leave EXIT
    trap 'exit 130' INT
    trap 'exit 143' TERM
    [ -n "$mirror" ] || mirror=$(apt-get indextargets --format '$(REPO_URI)' | grep -m 1 '/debian/*$')
    mkdir -p "$cache"
    base=$cache/$1.tar.gz
    if [ ! -e "$base" ]; then
        debootstrap --variant=minbase --make-tarball="$base.part" "$1" "$system/packages" "$mirror" >&2
        mv "$base.part" "$base"
    fi
    debootstrap --variant=minbase --unpack-tarball="$base" "$1" "$system" "$mirror" >"$system.log" || { cat "$system.log" >&2; exit 1; }
    rm "$system.log"
    mount -t proc proc "$system/proc"
    mount -t sysfs sysfs "$system/sys"
    mount --bind /dev "$system/dev"
    mkdir -p /dev/shm /dev/pts
    mount --bind /dev/pts "$system/dev/pts"
    mount -t tmpfs -o size=1G tmpfs "$system/dev/shm"
    # How apt here reaches its mirror: the proxy and the like, and the name server.
    apt-config dump | grep -E '^Acquire::(http|https|Check|Retries)' >"$system/etc/apt/apt.conf.d/99host" || true
    cp /etc/resolv.conf "$system/etc/resolv.conf"
}

# Runs commands of the shell in the system.
in_system() {
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 CI=true chroot "$system" sh -ec "$1" </dev/null
}

# Calls the function `try`, which is the script's own, in a fresh system of each release; exits with the status of the last that failed.
try_releases() {
    # Where a failure is asked for by `if`, `set -e` does not hold inside. In a subshell, so that each system is gone before the next.
    set +e
    status=0
    for release in "$@"; do
        say "$release: begun"
        (
            set -e
            make_system "$release"
            try
        )
        tried=$?
        if [ $tried = 0 ]; then say "$release: passed"; else say "$release: FAILED"; status=$tried; fi
    done
    exit $status
}
