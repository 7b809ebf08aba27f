#!/bin/bash
# The Processing provider in QGIS without a screen: qgis_plugin.sh PROGRAM ZIP. Installs the zip in a profile of its own
# and calls each algorithm by qgis_process. Exit code 77 where QGIS is not installed.
set -eu
program=$(readlink -f "$1")
zip=$(readlink -f "$2")
files=$(cd "$(dirname "$0")/coupling/inputs/formats/files" && pwd)
# Debian starts it by a script that puts options of the desktop first.
qgis=$(command -v qgis_process.bin || command -v qgis_process) || { echo "QGIS is not installed"; exit 77; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$work XDG_DATA_HOME=$work/.local/share XDG_CONFIG_HOME=$work/.config
plugins=$work/.local/share/QGIS/QGIS3/profiles/default/python/plugins
mkdir -p "$plugins" "$work/bin"
(cd "$plugins" && cmake -E tar xf "$zip")
ln -s "$program" "$work/bin/bannwald"
cp "$files"/* "$work"
cd "$work"

fail() {
    echo "FAILED: $1"
    cat "$work/log"
    exit 1
}
# Whether a log has a line of this pattern.
has() { grep -q -- "$1" "$work/log" || fail "no line '$1'"; }
# Whether every layer was loaded and can be drawn.
all_layers() {
    local counts
    counts=$(sed -n 's/^\([0-9]*\) of \([0-9]*\) layers of the project can be drawn$/\1 \2/p' "$work/log")
    if [ -z "$counts" ] || [ "${counts% *}" != "${counts#* }" ] || [ "${counts% *}" -le 5 ]; then
        fail "layers: '$counts'"
    fi
}
algorithm() { PATH=$work/bin:/usr/bin:/bin "$qgis" run "bannwald:$1" -- "${@:2}" >"$work/log" 2>&1; }

"$qgis" plugins enable bannwald_processing >log 2>&1 || fail "the plugin cannot be enabled"

# Without the program: what to do.
touch empty.ini
PATH=/nowhere "$qgis" run bannwald:check -- SCENARIO="$work/empty.ini" >log 2>&1 || true
has "not on the PATH: install it, or name it in Settings"

# A project to draw in: QGIS opens it with every layer, ready to be edited.
algorithm draw DEM="$work/dem.tif" PROJECT="$work/drawn" || fail "draw"
has "^MAP:.*drawing.qgs"
"$program" check "$work/drawn/scenario.ini" >"$work/log" 2>&1 || fail "check of a project to draw in"
/usr/bin/python3 - "$work/drawn/drawing.qgs" >"$work/log" 2>&1 <<'PYTHON' || fail "drawing.qgs"
import sys

from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsProject, QgsVectorLayer

application = QgsApplication([], False)
application.initQgis()
project = QgsProject.instance()
assert project.read(sys.argv[1])
assert project.crs().isValid(), "no coordinate system"
layers = {layer.name(): layer for layer in project.mapLayers().values()}
assert len(layers) == 9, layers.keys()
for name, layer in layers.items():
    assert layer.isValid(), name
    assert not isinstance(layer, QgsVectorLayer) or layer.startEditing(), name
grounds = layers["Ground types"]
assert grounds.editorWidgetSetup(grounds.fields().indexOf("code")).type() == "ValueMap"
road = QgsFeature(layers["Targets: roads and other lines"].fields())
road["name"] = "Road"
road.setGeometry(QgsGeometry.fromWkt("MultiLineString ((1105 2010, 1105 2090))"))
layer = layers["Targets: roads and other lines"]
assert layer.addFeature(road) and layer.commitChanges(), layer.commitErrors()
project.clear()
application.exitQgis()
PYTHON
"$program" run "$work/drawn/scenario.ini" --out drawn/out --set release.rocks=200 --quiet >"$work/log" 2>&1 ||
    fail "run of what was drawn in QGIS"
grep -q Road drawn/out/tables/targets.csv || fail "the road that was drawn in QGIS is no target"

algorithm newproject DEM="$work/dem.tif" SOURCES="$work/layers.gpkg|layername=cliff" TARGETS="$work/road.shp" \
    TREES="$work/layers.gpkg|layername=trees" GROUNDS="$work/layers.gpkg|layername=grounds" PROJECT="$work/project" ||
    fail "newproject"
scenario=$work/project/scenario.ini
[ -s "$scenario" ] || fail "no scenario"

algorithm check SCENARIO="$scenario" || fail "check"
has "^ANSWER:"

settings=$'release.rocks_per_source=20\nnets.keep_paths=yes'
algorithm run SCENARIO="$scenario" SETTINGS="$settings" RESULTS="$work/out" || fail "run"
all_layers
"$program" run "$scenario" --quiet --set release.rocks_per_source=20 --set nets.keep_paths=yes --out plain
cmp out/tables/targets.csv plain/tables/targets.csv || fail "other results than on the command line"

# Results are not replaced unasked; the message of the program arrives.
algorithm run SCENARIO="$scenario" SETTINGS="release.rocks_per_source=21" RESULTS="$work/out" || true
has "ended with exit code [1-9]"
cmp out/tables/targets.csv plain/tables/targets.csv || fail "results were replaced"

printf 'name,height_m,capacity_kj,wkt\nnet,4,1000,"LINESTRING (1090 2010, 1090 2090)"\n' >nets.csv
algorithm netplace RUN="$work/out" NETS="$work/nets.csv" \
    DISTANCES=0,10 RESULTS="$work/places" || fail "netplace"
[ -s places/net_places.csv ] || fail "netplace"
has "^PLACES:"

# The road as it is: where nets are needed.
algorithm netplace RUN="$work/out" NETS="$work/road.shp" RESULTS="$work/sited" || fail "netplace of a road"
[ -s sited/net_stretches.csv ] || fail "no stretches"
[ ! -e sited/net_places.csv ] || fail "places of nets that nobody gave"
has "^Stretches where works are needed: \(none\|[1-9][0-9]* on the map\)$"
has "^Best nets: \(none\|[1-9][0-9]* on the map\)$"

printf 'return_period_years,diameter_m\n30,0.5\n100,1.0\n' >blocks.csv
algorithm hazard SCENARIO="$scenario" BLOCKS="$work/blocks.csv" SETTINGS="release.rocks_per_source=20" \
    RESULTS="$work/hazard" || fail "hazard"
all_layers
[ -s hazard/hazard/report.html ] || fail "no page of the hazard map"
