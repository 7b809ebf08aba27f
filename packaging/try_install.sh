#!/usr/bin/env bash
# Installs into an empty folder and works with what is there: try_install.sh CMAKE BUILD_FOLDER
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" --install "$2" --prefix "$folder/usr" >/dev/null
cd "$folder"
usr/bin/bannwald init example --example profile --quiet
usr/bin/bannwald run example/scenario.ini --quiet --set release.rocks=50
test -s example/out/report.html
gzip -dc usr/share/man/man1/bannwald.1.gz | grep -q 'bannwald run'
test -s usr/share/doc/bannwald/copyright
# shellcheck disable=SC1091
source usr/share/bash-completion/completions/bannwald
complete -p bannwald
