#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bootstrap.sh"

# Google Benchmark and valgrind guard the speed; without them those tests are skipped.
install_missing "${packages[@]}"
install_missing libbenchmark-dev valgrind || echo "going on without libbenchmark-dev and valgrind" >&2
build release
run_tests release
