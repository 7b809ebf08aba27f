#include "coupling/inputs/plausible/off_terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"

namespace coupling::plausible {
namespace {

using config::joined;
using config::Point2;

constexpr const char* transform =
    "transform the file to the coordinate system of the terrain, or take the terrain in that of the file";

constexpr const char* cut_or_larger = "cut the file to the terrain, or take a larger terrain";

/// A change of coordinates that people forget.
struct KnownShift {
    double east_m;
    double north_m;
    const char* reason;
};

/// Added to the places. Plain shifts only show the cause: between LV03 and LV95 they are up to 1.6 m wrong
/// (swisstopo, FINELTRA), so the advice is always to transform.
constexpr std::array shifts{
    KnownShift{2e6, 1e6, "their easting lacks 2 000 000 m and their northing 1 000 000 m (Swiss LV03, LV95)"},
    KnownShift{-2e6, -1e6,
               "their easting has 2 000 000 m and their northing 1 000 000 m more (Swiss LV03, LV95)"},
    KnownShift{0.0, 5e6, "their northing lacks 5 000 000 m (MGI: Austria GK and Austria M)"},
    KnownShift{0.0, -5e6, "their northing has 5 000 000 m more (MGI: Austria GK and Austria M)"},
    KnownShift{150e3, 0.0, "their easting lacks 150 000 m (MGI: Austria GK West and M28)"},
    KnownShift{-150e3, 0.0, "their easting has 150 000 m more (MGI: Austria GK West and M28)"},
    KnownShift{450e3, 0.0, "their easting lacks 450 000 m (MGI: Austria GK Central and M31)"},
    KnownShift{-450e3, 0.0, "their easting has 450 000 m more (MGI: Austria GK Central and M31)"},
    KnownShift{750e3, 0.0, "their easting lacks 750 000 m (MGI: Austria GK East and M34)"},
    KnownShift{-750e3, 0.0, "their easting has 750 000 m more (MGI: Austria GK East and M34)"},
};

/// Share of the places that a change of their coordinates brings into the extent.
double share_inside(const Extent& terrain, std::span<const Point2> places,
                    const std::function<Point2(const Point2&)>& changed) {
    const auto inside = std::count_if(places.begin(), places.end(),
                                      [&](const Point2& point) { return terrain.contains(changed(point)); });
    return static_cast<double>(inside) / static_cast<double>(places.size());
}

/// Where the terrain lies in Switzerland the shift between its systems needs no numbers.
std::string shift_in_words(const KnownShift& shift, const Extent& terrain) {
    const std::string system = systems_around(terrain);
    const bool is_swiss_shift = std::abs(shift.north_m) == 1e6;
    if (is_swiss_shift && system.find("LV95") != std::string::npos) {
        return "they look like Swiss LV03 while the terrain is in LV95";
    }
    if (is_swiss_shift && system.find("LV03") != std::string::npos) {
        return "they look like Swiss LV95 while the terrain is in LV03";
    }
    return shift.reason;
}

/// Distance in plan between two extents; 0 where they overlap.
double gap_m(const Extent& a, const Extent& b) {
    return std::hypot(std::max({0.0, b.west_m - a.east_m, a.west_m - b.east_m}),
                      std::max({0.0, b.south_m - a.north_m, a.south_m - b.north_m}));
}

/// Nearer to the terrain than this share of its longer side, things were probably meant there [choice].
constexpr double near_share = 0.5;

bool looks_like_degrees(const Extent& extent) {
    return Extent{-180.0, 180.0, -90.0, 90.0}.covers(extent);
}

/// The number of a zone before the easting: 2 to 5 of Gauss-Kruger, 31 to 33 of UTM, there or not.
std::string zone_number(const std::function<bool(double, double)>& fits_shifted) {
    for (const int zone : {2, 3, 4, 5, 31, 32, 33}) {
        for (const double sign : {1.0, -1.0}) {
            if (fits_shifted(sign * 1e6 * zone, 0.0)) {
                return joined("their easting ", sign > 0.0 ? "lacks" : "has", " the number of the zone, ",
                              std::to_string(zone), ", before it");
            }
        }
    }
    return "";
}

std::string unit_in_words(const Extent& terrain, std::span<const Point2> places) {
    struct Unit {
        double metres;
        const char* name;
    };
    for (const Unit& unit : {Unit{1e3, "kilometres"}, Unit{1e-2, "centimetres"}, Unit{1e-3, "millimetres"},
                             Unit{0.3048, "feet"}}) {
        const auto scaled = [&](const Point2& p) { return Point2{unit.metres * p.x_m, unit.metres * p.y_m}; };
        if (share_inside(terrain, places, scaled) > most_off_terrain) {
            return unit.name;
        }
    }
    return "";
}

}  // namespace

bool lies_beside(const Extent& terrain, const Extent& extent) {
    const double side_m = std::max(terrain.east_m - terrain.west_m, terrain.north_m - terrain.south_m);
    return gap_m(terrain, extent) <= near_share * side_m;
}

std::optional<OffCause> slip_of_coordinates(const Extent& terrain, std::span<const Point2> places,
                                            std::string_view swap_advice) {
    const auto fits = [&](const auto& changed) {
        return share_inside(terrain, places, changed) > most_off_terrain;
    };
    const auto fits_shifted = [&](double east_m, double north_m) {
        return fits([&](const Point2& p) { return Point2{p.x_m + east_m, p.y_m + north_m}; });
    };
    if (fits([](const Point2& p) { return Point2{p.y_m, p.x_m}; })) {
        return OffCause{"x and y look swapped", std::string{swap_advice}};
    }
    if (looks_like_degrees(extent_of(places)) && !looks_like_degrees(terrain)) {
        return OffCause{"they look like degrees of longitude and latitude", transform};
    }
    for (const KnownShift& shift : shifts) {
        if (fits_shifted(shift.east_m, shift.north_m)) {
            return OffCause{shift_in_words(shift, terrain), transform};
        }
    }
    if (const std::string zone = zone_number(fits_shifted); !zone.empty()) {
        return OffCause{zone, transform};
    }
    if (const std::string unit = unit_in_words(terrain, places); !unit.empty()) {
        return OffCause{joined("they look like ", unit), "write the coordinates in metres"};
    }
    return std::nullopt;
}

OffCause cause_off_terrain(const Extent& terrain, std::span<const Point2> places,
                           std::string_view swap_advice) {
    if (auto slip = slip_of_coordinates(terrain, places, swap_advice)) {
        return *std::move(slip);
    }
    const Extent extent = extent_of(places);
    if (extent.overlaps(terrain)) {
        return {"they reach beyond the terrain", cut_or_larger};
    }
    if (lies_beside(terrain, extent)) {
        return {joined("they lie ", std::to_string(std::lround(std::ceil(gap_m(terrain, extent)))),
                       " m beyond its edge"),
                "take a larger terrain, or delete them from the file"};
    }
    const std::string own = systems_around(extent);
    const std::string of_terrain = systems_around(terrain);
    if (!own.empty() && !of_terrain.empty() && own != of_terrain) {
        return {joined("another coordinate system: they would fit ", own, ", the terrain ", of_terrain),
                transform};
    }
    return {"perhaps another coordinate system or another place",
            "compare the coordinate system of both files, then transform one of them"};
}

std::vector<Point2> places_outside_of_stated_extent(std::span<const Point2> places, const Reading& reading) {
    const std::vector<double>& extent_m = reading.terrain().extent_m;
    std::vector<Point2> outside;
    if (extent_m.size() == 4) {
        const Extent stated{extent_m[0], extent_m[2], extent_m[1], extent_m[3]};
        std::copy_if(places.begin(), places.end(), std::back_inserter(outside),
                     [&](const Point2& place) { return !stated.contains(place); });
    }
    return outside;
}

std::size_t outside_of_stated_extent(std::span<const Point2> places, const Reading& reading) {
    return places_outside_of_stated_extent(places, reading).size();
}

void judge_off_terrain(const OffTerrain& things, const Extent& terrain, Reading& reading) {
    if (things.off == 0) {
        return;
    }
    // Those that stand in the last cell of the stated part are off its terrain, too.
    constexpr std::size_t most_of_ten = 8;
    const std::vector<Point2> outside = places_outside_of_stated_extent(things.places, reading);
    if (things.off < things.all && 10 * outside.size() >= most_of_ten * things.off &&
        !slip_of_coordinates(terrain, outside, things.swap_advice)) {
        reading.note(joined(things.place.file, ": ", std::to_string(things.off), " of ",
                            counted(things.all, things.singular), " outside of terrain.extent_m, left out"));
        return;
    }
    const std::string names = joined(things.singular, "s");
    const std::string count =
        joined(std::to_string(things.off), " of ", counted(things.all, things.singular), " off the terrain");
    if (static_cast<double>(things.off) > most_off_terrain * static_cast<double>(things.all)) {
        OffCause cause = cause_off_terrain(terrain, things.places, things.swap_advice);
        if (!things.cut.empty() && cause.advice == cut_or_larger) {
            cause.advice =
                joined("cut the file to the terrain, `", things.cut, "`, or take a larger terrain");
        }
        reading.refuse(things.place,
                       joined(count, ": ", cause.reason, "; the ", names, " span ",
                              in_words(extent_of(things.places)), ", the terrain ", in_words(terrain)),
                       joined("at least half of the ", names, " on the terrain"), cause.advice);
        return;
    }
    reading.warn(things.place, joined(count, ", such as ", things.example, "; left out"),
                 joined(names, " on the terrain"),
                 "correct their coordinates unless they stand beyond its border");
}

}  // namespace coupling::plausible
