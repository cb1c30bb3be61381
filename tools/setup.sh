#!/bin/sh
# Installs what is missing for a purpose, and nothing else. Asks nothing.
#
#   tools/setup.sh [build]   compiler, CMake, make, pkg-config, stb
#   tools/setup.sh test      the same, OpenCV and g++ for the comparison with it, and Unity into
#                            build/unity
#   tools/setup.sh ci        the same, and clang, the 32-bit libraries and what tests/lint.sh
#                            runs
#   tools/setup.sh embedded  as test, and clang, cross compilers, emulators, Python: for
#                            tests/embedded/run.py and tools/budget.py (2.5 GB on disk)
#
# On Debian and its relatives packages come from apt-get, through sudo when it is not root who
# calls. Elsewhere the script says what is missing and fails.
set -eu

cd "$(dirname "$0")/.."
purpose=${1:-build}
packages=

fail() {
    echo "setup: $*" >&2
    exit 1
}

need() { # PACKAGE... : wanted, installed in one go later
    packages="$packages $*"
}

compiles() { # COMPILER [FLAG...] : can it make a program that includes libc's headers?
    command -v "$1" >/dev/null 2>&1 &&
        echo '#include <errno.h>
#include <stdio.h>
int main(void) { return puts("") < 0; }' | "$@" -x c - -o /dev/null >/dev/null 2>&1
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null 2>&1; then
        # Without a terminal there is nobody to type a password.
        if [ -t 0 ]; then sudo "$@"; else sudo -n "$@"; fi
    else
        fail "missing packages:$packages; install them as root, then run this again"
    fi
}

gcc_major() { # of the gcc that is there, else of the one that Debian would install
    gcc -dumpversion 2>/dev/null ||
        apt-cache depends gcc 2>/dev/null | sed -n 's/.*Depends: gcc-\([0-9][0-9]*\)$/\1/p'
}

find_missing() {
    compiles cc || need gcc libc6-dev
    command -v cmake >/dev/null 2>&1 || need cmake
    command -v make >/dev/null 2>&1 || need make
    command -v pkg-config >/dev/null 2>&1 || need pkg-config
    pkg-config --exists stb 2>/dev/null || need libstb-dev
    # Tests without OpenCV leave the comparison with it out.
    if [ "$purpose" != build ] && command -v apt-get >/dev/null 2>&1; then
        echo '#include <string>' | c++ -x c++ -fsyntax-only - 2>/dev/null || need g++
        [ -e /usr/include/opencv4/opencv2/imgproc.hpp ] ||
            need libopencv-core-dev libopencv-imgproc-dev
    fi
    if [ "$purpose" = ci ]; then
        compiles gcc || need gcc libc6-dev
        compiles clang || need clang
        command -v clang-tidy >/dev/null 2>&1 || need clang-tidy
        command -v cppcheck >/dev/null 2>&1 || need cppcheck
        # Not gcc-multilib: it would throw out the cross compilers, which it conflicts with for
        # a symbolic link to the kernel's headers. The preset m32 names that folder instead.
        compiles gcc -m32 -idirafter /usr/include/x86_64-linux-gnu ||
            need "gcc-$(gcc_major)-multilib"
    fi
}

find_missing_for_chips() {
    command -v python3 >/dev/null 2>&1 || need python3
    compiles clang || need clang
    compiles arm-none-eabi-gcc --specs=rdimon.specs ||
        need gcc-arm-none-eabi libnewlib-arm-none-eabi
    compiles riscv64-unknown-elf-gcc --specs=picolibc.specs --crt0=semihost --oslib=semihost ||
        need gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf
    compiles arm-linux-gnueabihf-gcc || need gcc-arm-linux-gnueabihf libc6-dev-armhf-cross
    compiles aarch64-linux-gnu-gcc || need gcc-aarch64-linux-gnu libc6-dev-arm64-cross
    compiles s390x-linux-gnu-gcc || need gcc-s390x-linux-gnu libc6-dev-s390x-cross
    command -v qemu-system-arm >/dev/null 2>&1 || need qemu-system-arm
    command -v qemu-system-riscv32 >/dev/null 2>&1 || need qemu-system-misc
    command -v qemu-s390x >/dev/null 2>&1 || need qemu-user
}

install_missing() {
    [ -n "$packages" ] || return 0
    command -v apt-get >/dev/null 2>&1 || fail "missing (Debian's names):$packages"
    echo "setup: installing$packages"
    # shellcheck disable=SC2086 # one word a package
    as_root env DEBIAN_FRONTEND=noninteractive sh -c '
        apt-get -q -o DPkg::Lock::Timeout=120 update &&
        apt-get -q -y -o DPkg::Lock::Timeout=120 install --no-install-recommends "$@"' \
        sh $packages </dev/null || fail "could not install:$packages"
}

# Debian carries a copy of Unity in the sources of ntpsec. apt-get checks its signature. The
# deb-src entry and apt's lists are private to this folder: the machine's own stay as they are,
# and no root is needed.
unity_from_debian() {
    command -v apt-get >/dev/null 2>&1 || return 1
    work=$PWD/build/unity.part
    rm -rf "$work"
    mkdir -p "$work/lists" "$work/cache" "$work/copy"
    key=/usr/share/keyrings/debian-archive-keyring.gpg
    [ -f $key ] && key="[signed-by=$key] " || key=
    # The mirror that this machine uses already; else Debian's own.
    mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
        'Created-By: Packages' 2>/dev/null |
        awk '$1 ~ /\/debian\/?$/ && $2 !~ /-/ && $3 == "main" { print $1, $2; exit }')
    echo "deb-src $key${mirror:-http://deb.debian.org/debian bookworm} main" >"$work/sources.list"
    set -- -q -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=- \
        -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" \
        -o APT::Sandbox::User="$(id -un)" -o Acquire::Languages=none \
        -o Acquire::Retries=1 -o Acquire::http::Timeout=15
    (
        cd "$work"
        apt-get "$@" update && apt-get "$@" source --download-only ntpsec
    ) >"$work/log" 2>&1 </dev/null || return 1
    (cd "$work/copy" && cmake -E tar xf ../ntpsec_*.orig.tar.*) || return 1
    mkdir -p "$work/unity"
    cp "$work"/copy/ntpsec-*/tests/unity/unity.[ch] \
        "$work"/copy/ntpsec-*/tests/unity/unity_internals.h "$work/unity" || return 1
    rm -rf build/unity
    mv "$work/unity" build/unity
    rm -rf "$work"
}

get_unity() {
    [ ! -f build/unity/unity.c ] || return 0
    [ -z "${UNITY_DIR:-}" ] || return 0
    echo "setup: fetching Unity"
    cmake -DUNITY_TO="$PWD/build/unity" -P cmake/unity_upstream.cmake >/dev/null 2>&1 ||
        unity_from_debian ||
        fail "Unity can be had neither from GitHub nor from Debian (build/unity.part/log);" \
            "put its unity.c, unity.h and unity_internals.h into build/unity"
}

case $purpose in
build | test | ci | embedded) ;;
*)
    echo "usage: tools/setup.sh [build|test|ci|embedded]" >&2
    exit 2
    ;;
esac
find_missing
[ "$purpose" != embedded ] || find_missing_for_chips
install_missing
[ "$purpose" = build ] || get_unity
