#include "coupling/inputs/release/source_cover.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "config/text/joined.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"
#include "coupling/inputs/release/zone_blocks.hpp"

namespace coupling::plausible {
namespace {

using config::joined;
using config::Shape;

/// What of several shapes lies on the terrain.
struct SourceCover {
    double size = 0.0;
    double on = 0.0;
    std::vector<config::Point2> vertices;
    const SourceShape* first = nullptr;

    void add(const SourceShape& shape, const OnTerrain& found) {
        size += found.size;
        on += found.share * found.size;
        for (const auto& part : shape.shape.parts) {
            vertices.insert(vertices.end(), part.begin(), part.end());
        }
        first = first == nullptr ? &shape : first;
    }
    [[nodiscard]] double share_off() const { return size > 0.0 ? 1.0 - on / size : 0.0; }
    [[nodiscard]] bool is_mostly_off() const { return share_off() > most_off_terrain; }
};

const char* size_of_kind(Shape::Kind kind) {
    return kind == Shape::Kind::polygon ? " of the area" : kind == Shape::Kind::line ? " of the length" : "";
}

void refuse_cover(const config::Place& place, const std::string& what, const SourceCover& cover,
                  const Extent& terrain, Reading& reading) {
    const OffCause cause =
        cause_off_terrain(terrain, cover.vertices, "exchange x and y in the shapes of the file");
    reading.refuse(place,
                   joined(percent_in_words(cover.share_off()), size_of_kind(cover.first->shape.kind), " of ",
                          what, " off the terrain: ", cause.reason, "; they span ",
                          in_words(extent_of(cover.vertices)), ", the terrain ", in_words(terrain)),
                   "at least half of the sources, and of each zone, on the terrain", cause.advice);
}

std::string area_in_words(double area_m2) {
    return joined(std::to_string(std::lround(area_m2)), " m2");
}

void judge_polygon(const SourceShape& shape, const OnTerrain& found, Reading& reading) {
    if (found.share >= 1.0) {
        return;
    }
    const std::string zone = joined("a source polygon of zone ", std::to_string(shape.zone));
    if (found.share <= 0.0) {
        reading.refuse(shape.place, joined(zone, " wholly off the terrain"), "sources on the terrain",
                       "remove the row, correct it or take a larger terrain");
        return;
    }
    reading.warn(shape.place,
                 joined(zone, " with ", percent_in_words(1.0 - found.share), " of its area (",
                        area_in_words((1.0 - found.share) * found.size), " of ", area_in_words(found.size),
                        ") off the terrain; no rock starts there"),
                 "sources on the terrain", "take a larger terrain if rocks start there too");
}

}  // namespace

void judge_source_shapes(const SourceInput& input, const rockfall::Terrain& terrain, Reading& reading) {
    SourceCover all;
    std::map<std::uint32_t, SourceCover> zones;
    std::vector<std::pair<const SourceShape*, OnTerrain>> polygons;
    for (const SourceShape& shape : input.shapes) {
        if (!start_of(input, shape.zone, shape.start)) {
            continue;
        }
        const OnTerrain found = on_terrain(shape.shape, terrain, samples_a_side(input.shapes.size()));
        all.add(shape, found);
        zones[shape.zone].add(shape, found);
        if (shape.shape.kind == Shape::Kind::polygon) {
            polygons.emplace_back(&shape, found);
        }
    }
    if (all.first == nullptr) {
        return;
    }
    const Extent extent = extent_of(terrain);
    if (all.is_mostly_off()) {
        refuse_cover({input.file}, "the sources", all, extent, reading);
        return;
    }
    const bool zones_are_rows = !input.has_zones && input.shapes.front().shape.kind == Shape::Kind::point;
    for (const auto& [zone, cover] : zones) {
        if (cover.is_mostly_off() && !zones_are_rows) {
            refuse_cover(cover.first->place, joined("zone ", std::to_string(zone)), cover, extent, reading);
        }
    }
    for (const auto& [shape, found] : polygons) {
        if (!zones[shape->zone].is_mostly_off()) {
            judge_polygon(*shape, found, reading);
        }
    }
}

std::optional<std::size_t> later_twin(const SourceInput& input, std::size_t number) {
    const auto later = input.shapes.begin() + static_cast<std::ptrdiff_t>(number) + 1;
    const auto twin = std::find_if(later, input.shapes.end(), [&](const SourceShape& other) {
        return other.shape == input.shapes[number].shape;
    });
    return twin == input.shapes.end() ? std::nullopt
                                      : std::optional{static_cast<std::size_t>(twin - input.shapes.begin())};
}

void warn_of_covered_polygon(const SourceInput& input, std::size_t number, Reading& reading) {
    const SourceShape& shape = input.shapes[number];
    const auto twin = later_twin(input, number);
    const std::string what = joined("a source polygon of zone ", std::to_string(shape.zone));
    reading.warn(shape.place,
                 twin ? joined(what, " that stands a second time in row ",
                               std::to_string(input.shapes[*twin].place.line))
                      : joined(what, " wholly under polygons of later rows"),
                 "each source once: no rock starts from this row", "delete one of the rows");
}

}  // namespace coupling::plausible
