#pragma once

namespace coupling {

// What a new project offers, commented out.

/// Of the section of nets.
inline constexpr const char* offered_of_nets =
    ";keep_paths = yes           ; then `bannwald net place out --nets LINES` finds where nets are needed\n";
inline constexpr const char* offered_works =
    ";file = works.csv           ; dams, ditches, walls, galleries: bannwald info inputs lists the columns\n";
/// Design of barriers, a hazard map, what stands over the page, and results in other formats. The factors of
/// a design are those that are refused as adding nothing until a guideline's stand there.
inline constexpr const char* offered_sections =
    "\n[design]\n"
    ";rule = own                 ; a net to order: with the factors of your guideline\n"
    ";percentile = 95\n"
    ";energy_factor = 1.0\n"
    ";height_factor = 1.0\n"
    ";freeboard_m = 0.0\n"
    "\n[hazard]\n"
    ";blocks = return_periods.csv ; a hazard map: return_period_years, zone, diameter_m of the rocks\n"
    ";rule = release             ; or arrival, cadanav: what a level is taken from\n"
    ";smallest_zone_m2 = 0       ; smaller zones take a higher level around them\n"
    "\n[report]\n"
    ";title = Rockfall above the road\n"
    ";client = Commune\n"
    ";author = Office\n"
    ";place = Place\n"
    ";date = 2026-11-24\n"
    ";logo = logo.png            ; PNG, JPEG or SVG, which becomes part of the page\n"
    ";language = de              ; en, de, de_CH, fr, fr_CH or it\n"
    "\n[output]\n"
    ";shapefile = yes            ; the layers of results.gpkg for other programs, too\n"
    ";kml = yes                  ; and for Google Earth\n"
    ";gpx = yes                  ; and for GPS devices\n";

}  // namespace coupling
