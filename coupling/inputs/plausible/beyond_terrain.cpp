#include "coupling/inputs/plausible/beyond_terrain.hpp"

#include <algorithm>
#include <optional>

#include "config/text/joined.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"

namespace coupling::plausible {
namespace {

using config::joined;
using Things = std::vector<const PlacedThing*>;

std::vector<config::Point2> corners_of(const Things& things) {
    std::vector<config::Point2> corners;
    for (const PlacedThing* thing : things) {
        corners.insert(corners.end(), thing->corners.begin(), thing->corners.end());
    }
    return corners;
}

/// Those that a slip of coordinates explains better than a layer of a larger area does. By chance a place of
/// a commune may lie where the slope would be with exchanged axes, but then in the midst of others.
Things slipped(const ThingsOnTerrain& given, const Extent& terrain) {
    Things candidates;
    Things others;
    for (const PlacedThing& thing : given.things) {
        const bool may_be = thing.is_beyond && !lies_beside(terrain, extent_of(thing.corners)) &&
                            slip_of_coordinates(terrain, thing.corners, given.swap_advice);
        (may_be ? candidates : others).push_back(&thing);
    }
    if (!others.empty()) {
        const Extent area = extent_of(corners_of(others));
        std::erase_if(candidates,
                      [&](const PlacedThing* thing) { return area.overlaps(extent_of(thing->corners)); });
    }
    return candidates;
}

/// Why nothing of a file lies on the terrain; `cut` as in ThingsOnTerrain.
OffCause cause_of_none(const Things& off, const Extent& terrain, const ThingsOnTerrain& given) {
    const std::vector<config::Point2> corners = corners_of(off);
    OffCause cause = cause_off_terrain(terrain, corners, given.swap_advice);
    if (slip_of_coordinates(terrain, corners, given.swap_advice)) {
        return cause;
    }
    if (off.size() > 1 && terrain.overlaps(extent_of(corners))) {
        cause = {"they lie around it", "take a layer of this slope, or a larger terrain"};
    }
    if (given.cut.empty()) {
        return cause;
    }
    // Both files say where they lie, so that no other system can be the cause.
    if (cause.reason.starts_with("another coordinate system") || cause.reason.starts_with("perhaps")) {
        cause = {"another place, as both files name their coordinate system", "take a layer of this slope"};
    }
    return {cause.reason, joined(cause.advice, "; `", given.cut, "` cuts one to the terrain")};
}

config::Problem problem_of(const ThingsOnTerrain& given, const Things& off, const Extent& terrain,
                           const OffCause& cause) {
    const std::string first = joined(given.singular, " ", config::in_quotes(off.front()->name));
    const bool is_one = off.size() == 1;
    const std::string count =
        joined(std::to_string(off.size()), " of ", counted(given.things.size(), given.singular));
    return {config::ExitCode::data, is_one ? off.front()->place : given.place,
            joined(is_one ? first : count, " outside the terrain", is_one ? "" : joined(", such as ", first),
                   ": ", cause.reason, "; ",
                   is_one ? joined("the ", given.singular, " spans ") : std::string{"they span "},
                   in_words(extent_of(corners_of(off))), ", the terrain ", in_words(terrain)),
            std::string{given.expected}, cause.advice};
}

std::string note_of(const ThingsOnTerrain& given, const Things& off) {
    constexpr std::size_t most_named = 3;
    std::vector<std::string> named;  // several areas may be called by one code
    for (const PlacedThing* thing : off) {
        if (named.size() < most_named && std::find(named.begin(), named.end(), thing->name) == named.end()) {
            named.push_back(thing->name);
        }
    }
    std::string names;
    for (const std::string& name : named) {
        names += joined(names.empty() ? "" : ", ", config::in_quotes(name));
    }
    return joined(given.place.file, ": ", std::to_string(off.size()), " of ",
                  counted(given.things.size(), given.singular),
                  " wholly beyond the terrain; left out, such as ", names);
}

}  // namespace

BeyondTerrain beyond_terrain(const ThingsOnTerrain& given, const Extent& terrain) {
    Things off;
    for (const PlacedThing& thing : given.things) {
        if (thing.is_beyond) {
            off.push_back(&thing);
        }
    }
    if (off.empty()) {
        return {};
    }
    if (const Things slips = slipped(given, terrain); !slips.empty()) {
        const OffCause cause = cause_off_terrain(terrain, corners_of(slips), given.swap_advice);
        return {.problem = problem_of(given, slips, terrain, cause)};
    }
    if (off.size() == given.things.size()) {
        return {.problem = problem_of(given, off, terrain, cause_of_none(off, terrain, given))};
    }
    return {.note = note_of(given, off)};
}

void judge_beyond_terrain(const ThingsOnTerrain& given, const Extent& terrain, Reading& reading) {
    BeyondTerrain found = beyond_terrain(given, terrain);
    if (found.problem) {
        reading.problems().add(*std::move(found.problem));
    }
    if (!found.note.empty()) {
        reading.note(std::move(found.note));
    }
}

std::vector<config::Point2> corners_of(const config::Shape& shape) {
    std::vector<config::Point2> corners;
    for (const auto& part : shape.parts) {
        corners.insert(corners.end(), part.begin(), part.end());
    }
    return corners;
}

std::vector<std::size_t> take_out_areas_beyond(std::vector<config::CodedPolygon>& areas,
                                               std::vector<std::string> names, ThingsOnTerrain given,
                                               const Extent& terrain, Reading& reading) {
    std::vector<std::size_t> stayed;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        std::vector<config::Point2> corners = corners_of(areas[i].polygon);
        const bool is_beyond = !terrain.overlaps(extent_of(corners));
        given.things.push_back({std::move(names[i]), std::move(corners), is_beyond, given.place});
        if (!is_beyond) {
            stayed.push_back(i);
        }
    }
    judge_beyond_terrain(given, terrain, reading);
    std::vector<config::CodedPolygon> kept;
    for (const std::size_t i : stayed) {
        kept.push_back(std::move(areas[i]));
    }
    areas = std::move(kept);
    return stayed;
}

}  // namespace coupling::plausible
