#!/bin/sh
# Puts CBMC, the model checker, into build/cbmc, unless `cbmc` is a command here already. Debian 12
# has no package of it, so that of Debian 13 is unpacked with the libraries that it needs and run
# with its own loader; nothing is installed, and no root is needed.
set -eu

cd "$(dirname "$0")/../.."
packages="cbmc libc6 libstdc++6 libgcc-s1 minisat zlib1g"

if command -v cbmc >/dev/null 2>&1 || [ -x build/cbmc/run ]; then
    exit 0
fi
command -v apt-get >/dev/null 2>&1 || {
    echo "proof: cbmc is missing (diffblue.github.io/cbmc), and there is no apt-get" >&2
    exit 1
}
work=$PWD/build/cbmc.part
rm -rf "$work"
mkdir -p "$work/lists" "$work/cache" "$work/root"
key=/usr/share/keyrings/debian-archive-keyring.gpg
[ -f $key ] && key="[signed-by=$key] " || key=
# The mirror that this machine uses already; else Debian's own.
mirror=$(apt-get indextargets --format '$(REPO_URI) $(COMPONENT)' 'Created-By: Packages' \
    2>/dev/null | awk '$1 ~ /\/debian\/?$/ && $2 == "main" { print $1; exit }')
echo "deb $key${mirror:-http://deb.debian.org/debian} trixie main" >"$work/sources.list"
set -- -q -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=- \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" \
    -o APT::Sandbox::User="$(id -un)" -o Acquire::Languages=none \
    -o Acquire::Retries=1 -o Acquire::http::Timeout=15
(
    cd "$work"
    apt-get "$@" update
    # shellcheck disable=SC2086 # one word a package
    apt-get "$@" download $packages
) >"$work/log" 2>&1 </dev/null || {
    tail -n 3 "$work/log" >&2
    echo "proof: CBMC cannot be downloaded" >&2
    exit 1
}
for package in "$work"/*.deb; do
    dpkg-deb -x "$package" "$work/root"
done
cat >"$work/run" <<'END'
#!/bin/sh
# CBMC with the libraries beside it.
root=$(dirname "$0")/root
for loader in "$root"/lib64/ld-linux*.so.2 "$root"/usr/lib64/ld-linux*.so.2 \
    "$root"/usr/lib/*/ld-linux*.so.* "$root"/lib/*/ld-linux*.so.*; do
    [ -e "$loader" ] && break
done
triple=$(basename "$(dirname "$(ls "$root"/usr/lib/*/libstdc++.so.6)")")
exec "$loader" --library-path \
    "$root/usr/lib/$triple:$root/usr/lib:$root/lib/$triple" "$root/usr/bin/cbmc" "$@"
END
chmod +x "$work/run"
"$work/run" --version >/dev/null || {
    echo "proof: the CBMC that was downloaded does not run here" >&2
    exit 1
}
rm -rf build/cbmc "$work/cache" "$work/lists" "$work"/*.deb
mv "$work" build/cbmc
