#!/usr/bin/env bash
# Installs what is missing, builds the program and runs the small example over years: nine hectares under four
# regimes for thirty years with rocks, about a minute on two cores.
#   bash coupling/run.sh [FOLDER]      FOLDER: where the example goes, out/regimes-small by default
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tests/bootstrap.sh"

folder=${1:-$root/out/regimes-small}
install_missing "${packages[@]}"
build release bannwald

bannwald=$root/build/release/bannwald
if [ ! -e "$folder/scenario.ini" ]; then
    "$bannwald" init "$folder" --example regimes-small --quiet
fi
"$bannwald" check "$folder/scenario.ini"
"$bannwald" run "$folder/scenario.ini" --overwrite

echo
echo "Results lie in $folder/out; open $folder/out/report.html in a browser."
echo "The scenario is $folder/scenario.ini: change it and run"
echo "  $bannwald run $folder/scenario.ini --overwrite"
