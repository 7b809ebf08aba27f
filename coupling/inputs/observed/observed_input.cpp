#include "coupling/inputs/observed/observed_input.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/places/shape_input.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"

namespace coupling {

namespace {

using config::joined;

constexpr config::NumberRange zone_range{.low = 0.0, .high = 4e9};

/// A table of observed stops with the fields of its rows; what is wrong becomes a problem.
class StopTable {
public:
    StopTable(const config::Table& table, config::Problems& problems)
        : table_{table}, problems_{problems}, has_shapes_{table.has("wkt")} {}

    [[nodiscard]] bool has_columns() const {
        std::vector<std::string> wanted;
        if (!has_shapes_) {
            wanted = {"x_m", "y_m"};
        }
        if (table_.has("x_release_m") || table_.has("y_release_m")) {
            wanted.insert(wanted.end(), {"x_release_m", "y_release_m"});
        }
        return table_.require(wanted, problems_);
    }

    [[nodiscard]] ObservedStop stop_of(std::size_t row) const {
        ObservedStop stop;
        if (has_shapes_) {
            take_shape(row, stop);
        } else {
            stop.end_m = {number(row, "x_m"), number(row, "y_m")};
        }
        if (given(row, "x_release_m") || given(row, "y_release_m")) {
            stop.start_m = Eigen::Vector2d{number(row, "x_release_m"), number(row, "y_release_m")};
        }
        if (given(row, "zone")) {
            const auto zone = table_.whole(row, "zone", zone_range, problems_);
            stop.zone = static_cast<std::uint32_t>(zone.value_or(0));
        }
        stop.group = table_.has("group") ? table_.text(row, "group") : "";
        return stop;
    }

private:
    [[nodiscard]] bool given(std::size_t row, const char* column) const {
        return table_.has(column) && !table_.text(row, column).empty();
    }
    [[nodiscard]] double number(std::size_t row, const char* column) const {
        return table_.number(row, column, {}, problems_).value_or(0.0);
    }
    void take_shape(std::size_t row, ObservedStop& stop) const {
        const auto shape = shape_of(table_, row, {config::Shape::Kind::point}, problems_);
        if (!shape) {
            return;
        }
        if (shape->parts.size() != 1) {
            problems_.add(config::ExitCode::data, table_.place(row, "wkt"),
                          counted(shape->parts.size(), "point"), "one point for each stop");
            return;
        }
        stop.end_m = {shape->parts[0][0].x_m, shape->parts[0][0].y_m};
    }

    const config::Table& table_;
    config::Problems& problems_;
    bool has_shapes_;
};

std::vector<ObservedStop> read_stop_table(Reading& reading) {
    const config::Table table =
        reading.table("observed.stops", "observed_stops", reading.scenario().observed_stops);
    config::Problems problems;
    const StopTable rows{table, problems};
    if (!rows.has_columns()) {
        problems.throw_if_any();
    }
    std::vector<ObservedStop> stops;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        stops.push_back(rows.stop_of(row));
    }
    if (stops.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no stops",
                     "at least one, or no observed.stops");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    return stops;
}

std::string in_words(const ObservedStop& stop) {
    return joined("a stop at x ", config::metres_in_words(stop.end_m.x()), ", y ",
                  config::metres_in_words(stop.end_m.y()));
}

void check_zones(std::span<const ObservedStop> stops, std::span<const rockfall::ReleaseSource> sources,
                 Reading& reading) {
    std::set<std::uint32_t> known;
    for (const rockfall::ReleaseSource& source : sources) {
        known.insert(source.zone);
    }
    std::set<std::uint32_t> unknown;
    for (const ObservedStop& stop : stops) {
        if (stop.zone && !known.contains(*stop.zone)) {
            unknown.insert(*stop.zone);
        }
    }
    if (!unknown.empty()) {
        reading.refuse({reading.shown(reading.scenario().observed_stops)},
                       joined("zone ", std::to_string(*unknown.begin()), ", from which no rock starts"),
                       "zones of the release",
                       "correct the column zone, or leave it empty to compare with all rocks");
    }
}

}  // namespace

std::optional<std::vector<ObservedStop>> read_observed_stops(Reading& reading) {
    if (reading.scenario().observed_stops.empty()) {
        return std::vector<ObservedStop>{};
    }
    return reading.attempt([&] { return read_stop_table(reading); });
}

void check_observed_stops(std::span<const ObservedStop> stops,
                          std::span<const rockfall::ReleaseSource> sources, const rockfall::Terrain& terrain,
                          Reading& reading) {
    check_zones(stops, sources, reading);
    const Eigen::Vector2d origin_m = terrain.origin_m();
    std::vector<config::Point2> places;
    std::vector<const ObservedStop*> off;
    for (const ObservedStop& stop : stops) {
        places.push_back({stop.end_m.x(), stop.end_m.y()});
        if (!terrain.locate(stop.end_m.x() - origin_m.x(), stop.end_m.y() - origin_m.y())) {
            off.push_back(&stop);
        }
    }
    if (off.empty()) {
        return;
    }
    const config::Place place{reading.shown(reading.scenario().observed_stops)};
    if (static_cast<double>(off.size()) > plausible::most_off_terrain * static_cast<double>(stops.size())) {
        plausible::OffTerrain judged;
        judged.place = place;
        judged.singular = "stop";
        judged.all = stops.size();
        judged.off = off.size();
        judged.places = places;
        judged.swap_advice = "exchange the columns of x and y";
        plausible::judge_off_terrain(judged, plausible::extent_of(terrain), reading);
        return;
    }
    reading.warn(place,
                 joined(std::to_string(off.size()), " of ", counted(stops.size(), "stop"),
                        " off the terrain, such as ", in_words(*off.front()),
                        "; they count, but no simulated rock can get there"),
                 "stops on the terrain", "take a larger terrain, or correct their coordinates");
}

}  // namespace coupling
