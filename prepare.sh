# Sourced by ./run and ./test: `prepare TARGET` installs the Debian packages that are missing, then configures the release preset and
# builds the target. A second time all of it finds nothing to do and takes about a second.

say() { printf '== %s\n' "$*"; }

install_missing_packages() {
  local wanted missing=() package
  wanted=$(grep -v '^#' packages.txt)
  for package in $wanted; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null
}

prepare() {
  install_missing_packages
  say "building $1 in build/release (the first time takes a few minutes)"
  mkdir -p build
  cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log; exit 4; }
  cmake --build --preset release --target "$1"
}

cd "$(dirname "${BASH_SOURCE[0]}")"
