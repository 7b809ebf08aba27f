# Sourced by coupling/run.sh, tests/run.sh and .ci/run: installs what is missing and builds.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(g++ cmake ninja-build libcgal-dev libeigen3-dev libboost-program-options-dev libboost-iostreams-dev
    libboost-mpi-dev libopenmpi-dev openmpi-bin librandom123-dev nlohmann-json3-dev libsqlite3-dev libtiff-dev
    libpng-dev libjpeg-dev libgeotiff-dev libproj-dev libshp-dev libzip-dev voro++-dev libxlsxwriter-dev libgtest-dev
    librapidcheck-dev libfcl-dev libccd-dev libkainjow-mustache-dev)

# Names those of the given packages that are not installed.
missing_of() {
    local package
    for package in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            echo "$package"
        fi
    done
}

# Installs packages as root or through sudo; else says what to run and fails.
install_missing() {
    if ! command -v dpkg-query >/dev/null; then
        echo "This is no Debian system; needed are what Debian 12 calls: $*" >&2
        return 0
    fi
    local missing
    mapfile -t missing < <(missing_of "$@")
    if [ ${#missing[@]} -eq 0 ]; then
        return 0
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "Packages are missing. Please run as root, then start again:" >&2
            echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    echo "Installing: ${missing[*]}" >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
        "${missing[@]}" >&2
}

# Compilers that run side by side: one a core, and 2 GB of memory for each.
job_count() {
    local cores memory_kb by_memory
    cores=$(nproc)
    memory_kb=$(awk '/^MemAvailable/ {print $2}' /proc/meminfo)
    by_memory=$((memory_kb / 2000000))
    echo $((by_memory < 1 ? 1 : by_memory < cores ? by_memory : cores))
}

# build PRESET [TARGET...]: configures and builds; messages go to stderr.
build() {
    local preset=$1
    shift
    local launcher=()
    if command -v ccache >/dev/null; then
        launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    fi
    (
        cd "$root" || exit
        cmake --preset "$preset" "${launcher[@]}" >&2
        cmake --build --preset "$preset" -j "$(job_count)" ${1:+--target "$@"} >&2
    )
}

# run_tests PRESET [OPTION OF CTEST...]
# Runs make sure that their files are on the disk (fsync). Tests that only look at the files wait for nothing in memory.
run_tests() {
    local preset=$1
    shift
    local folder
    folder=$(test_folder)
    # A name as users have them: no message and no script may depend on short names of plain letters.
    local within="$folder/Wald über Straße (2026)"
    mkdir -p "$within"
    (cd "$root" && TMPDIR=$within ctest --preset "$preset" -j "$(job_count)" "$@") || { rm -rf "$folder"; return 1; }
    rm -rf "$folder"
}

# A new folder for the files of tests: in memory where there is room, else where TMPDIR says.
test_folder() {
    local room_kb
    room_kb=$(df --output=avail /dev/shm 2>/dev/null | tail -n 1)
    if [ -z "${TMPDIR:-}" ] && [ -w /dev/shm ] && [ "${room_kb:-0}" -gt 4000000 ]; then
        mktemp -d /dev/shm/bannwald-tests-XXXXXX
    else
        mktemp -d
    fi
}
