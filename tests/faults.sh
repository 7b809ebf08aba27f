#!/usr/bin/env bash
# Lets every operation on the disk of four small runs go wrong: what is lost, what is wrong afterwards?
#   bash tests/faults.sh [OPTION OF fault_driver...]      such as --runs static --modes kill,power or --every 10
# Takes about one and a half hours on two cores; --runs and --modes share it out. Fails if anything was found.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

install_missing "${packages[@]}"
build release bannwald disk_faults fault_driver
binaries=$root/build/release
exec "$binaries/tests/faults/fault_driver" "$binaries/bannwald" \
    "$binaries/tests/faults/libdisk_faults.so" "$@"
