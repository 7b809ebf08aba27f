#!/bin/bash
# Makes the files of this folder with GDAL (gdal-bin): the sample project of the tests as a GIS would hand it over, in
# EPSG:2443, whose origin lies on land, as the sample lies near (0, 0). They are committed, so that tests need no GDAL.
set -eu
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
header="ncols 12\nnrows 10\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n"
grid() { printf "$header"; awk "BEGIN { for (r = 0; r < 10; r++) { for (c = 0; c < 12; c++) printf \"%s \", ($1); print \"\" } }"; }
grid '400 - 7 * c' > "$work/dem.asc"
grid 'c < 3 ? 1 : 3' > "$work/surface.asc"
grid 'c == 2 && r >= 3 && r < 7 ? 1 : 0' > "$work/source.asc"
to_tif() { gdal_translate -q -a_srs EPSG:2443 "$@"; }
to_tif -ot Float32 -co COMPRESS=DEFLATE -co PREDICTOR=3 -co TILED=YES -co BLOCKXSIZE=16 -co BLOCKYSIZE=16 "$work/dem.asc" dem.tif
gdal_translate -q -a_srs EPSG:2443+6360 -ot Float32 -co COMPRESS=DEFLATE "$work/dem.asc" feet.tif
to_tif -ot Byte -co COMPRESS=LZW "$work/surface.asc" surface.tif
to_tif -ot Int16 -co BLOCKYSIZE=3 "$work/source.asc" source.tif

cat > "$work/trees.csv" <<'END'
tree_id,x_m,y_m,species,dbh_cm,height_m
1,1060,2050,Weißtanne,32.5,25
2,1070,2042,Fi,20,18
3,1080,2061,hêtre,41,28
END
cat > "$work/targets.csv" <<'END'
id,name,WKT
road,Straße,"LINESTRING (1105 2010, 1105 2090)"
house,Haus,"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))"
END
cat > "$work/grounds.csv" <<'END'
code,WKT
3,"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))"
1,"POLYGON ((1000 2000, 1030 2000, 1030 2100, 1000 2100, 1000 2000))"
END
cat > "$work/cliff.csv" <<'END'
zone,WKT
1,"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))"
END
points="-oo X_POSSIBLE_NAMES=x_m -oo Y_POSSIBLE_NAMES=y_m -oo AUTODETECT_TYPE=YES -a_srs EPSG:2443"
shapes="-oo GEOM_POSSIBLE_NAMES=WKT -oo KEEP_GEOM_COLUMNS=NO -oo AUTODETECT_TYPE=YES -a_srs EPSG:2443"
rm -f layers.gpkg ./*.shp ./*.shx ./*.dbf ./*.prj ./*.cpg ./*.geojson
ogr2ogr -f GPKG layers.gpkg "$work/trees.csv" $points -nln trees
ogr2ogr -update -f GPKG layers.gpkg "$work/targets.csv" $shapes -nln targets
ogr2ogr -update -f GPKG layers.gpkg "$work/grounds.csv" $shapes -nln grounds
ogr2ogr -update -f GPKG layers.gpkg "$work/cliff.csv" $shapes -nln cliff
ogr2ogr -f "ESRI Shapefile" trees.shp "$work/trees.csv" $points -lco ENCODING=UTF-8
ogr2ogr -f "ESRI Shapefile" road.shp "$work/targets.csv" $shapes -lco ENCODING=ISO-8859-1 -where "id = 'road'" -nlt LINESTRING
ogr2ogr -f "ESRI Shapefile" house.shp "$work/targets.csv" $shapes -lco ENCODING=UTF-8 -where "id = 'house'" -nlt POLYGON
ogr2ogr -f "ESRI Shapefile" grounds.shp "$work/grounds.csv" $shapes
ogr2ogr -f "ESRI Shapefile" cliff.shp "$work/cliff.csv" $shapes
ogr2ogr -f GeoJSON targets.geojson "$work/targets.csv" $shapes -lco RFC7946=NO
