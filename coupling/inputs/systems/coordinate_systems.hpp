#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/formats/height_unit.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {

/// A projected coordinate system whose coordinates are known.
struct KnownSystem {
    std::string_view name;
    int epsg;  ///< 0: a family of systems
    /// Part of the text of the projection that this row needs; empty: any.
    std::string_view needs;
    double central_meridian_deg;
    double false_easting_m;
    double false_northing_m;
    /// Coordinates of its area of use. Source: EPSG Dataset, the bounding box of the area of use projected
    /// with PROJ 9.1 and rounded outward to 10 km; UTM wider, as countries use one zone beyond its borders.
    Extent area;
};

/// National systems of the Alps and their neighbours, and UTM zones 31 to 33.
std::span<const KnownSystem> known_systems();

/// What a projection file says, as far as coordinates can be held against it.
struct Projection {
    std::string name;            ///< as written, "" without any
    bool is_geographic = false;  ///< degrees
    std::optional<double> metres_per_unit;
    std::optional<double> central_meridian_deg;
    std::optional<double> false_easting;  ///< in its own unit
    std::optional<double> false_northing;
    std::optional<double> latitude_of_origin_deg;
    std::optional<double> scale;               ///< on the central meridian [-]
    std::optional<double> major_axis_m;        ///< of the figure of the earth
    std::optional<double> inverse_flattening;  ///< of it [-]
    std::optional<int> epsg;                   ///< its code, where the text names one
};

/// Reads well-known text, versions 1 (OGC and ESRI) and 2; nothing for other texts and for kinds that are
/// neither geographic nor projected.
std::optional<Projection> read_projection(std::string_view text);

/// The known system that a projection is: the same central meridian, false easting and false northing.
const KnownSystem* system_of(const Projection& projection, std::string_view text);

/// Names of at most three known systems in whose area of use an extent lies, such as
/// "MGI / Austria Lambert (EPSG 31287)"; "" if there are none.
std::string systems_around(const Extent& extent);

/// Why coordinates cannot be those of a projection file, and what would be.
struct Contradiction {
    std::string found;
    std::string expected;
    std::string advice;
};

/// What well-known text says of heights: that of its system of heights (VERT_CS, VERTCRS, or VERTCS behind
/// the plan as ESRI writes it), with its unit. Nothing without such a part or without a unit in it.
std::optional<formats::HeightUnit> height_unit_in(std::string_view text);

/// Holds the extent of the terrain against the text of the projection file `file`; nothing where the two
/// agree or where it cannot be judged: other systems, other kinds of text. Coordinates may lie 100 km outside
/// the area of use [choice]. Degrees and units other than the metre are contradictions too. A `file` that is
/// no .prj is that of the heights themselves.
std::optional<Contradiction> contradiction_of(std::string_view text, const Extent& extent,
                                              const std::string& file);

/// Heights in a unit other than the metre, or counted downwards, as the file of heights or its system says.
std::optional<Contradiction> contradiction_of_heights(const formats::HeightUnit& unit);

/// A map on which lengths differ from those on the ground, and whether it is refused for it.
struct MapScale {
    bool is_refused;
    Contradiction contradiction;
};

/// A map on which lengths differ from those on the ground: by a per cent or more an error, as Web Mercator is
/// no measure, from 0.3 % on a warning [both choices]. UTM has -0.04 to 0.1 % in its zone, national systems
/// of the Alps less than 0.1 %, Europe's LAEA (EPSG 3035) less than 0.1 % in them. Judged by the scale
/// factors in the middle of the extent (formats/system_scale.hpp); other kinds of text are not judged.
std::optional<MapScale> contradiction_of_scale(const std::string& text, const std::string& file,
                                               const Extent& extent);

}  // namespace coupling::plausible
