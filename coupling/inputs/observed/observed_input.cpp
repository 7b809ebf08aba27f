#include "coupling/inputs/observed/observed_input.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/cut_command.hpp"
#include "coupling/inputs/plausible/off_terrain.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/observed_settings.hpp"

namespace coupling {

namespace {

using config::joined;

ObservedStop stop_of(const ObservedStopRow& row) {
    ObservedStop stop{.end_m = {row.x_m, row.y_m}, .start_m = {}, .zone = row.zone, .group = row.group};
    if (!row.shape.parts.empty()) {
        stop.end_m = {row.shape.parts[0][0].x_m, row.shape.parts[0][0].y_m};
    }
    if (row.x_release_m && row.y_release_m) {
        stop.start_m = Eigen::Vector2d{*row.x_release_m, *row.y_release_m};
    }
    return stop;
}

std::vector<ObservedStop> read_stop_table(Reading& reading) {
    const config::Table table = reading.table("observed.stops", "observed_stops", reading.observed().stops);
    const config::Schema<ObservedStopRow> columns = observed_stop_columns(table.has("wkt"));
    check_columns(table, columns, reading);
    config::RowProblems wrong{table};
    if (table.has("x_release_m") || table.has("y_release_m")) {
        table.require({"x_release_m", "y_release_m"}, wrong);
        wrong.throw_first();
    }
    std::vector<ObservedStop> stops;
    for (const config::Read<ObservedStopRow>& row : columns.rows(table, wrong)) {
        if (row.x_release_m.has_value() != row.y_release_m.has_value()) {
            const char* missing = row.x_release_m ? "y_release_m" : "x_release_m";
            wrong.refuse(row.row, missing, joined("no ", missing),
                         "both coordinates of the release, or none");
        }
        stops.push_back(stop_of(row));
    }
    wrong.throw_first();
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
        reading.refuse({reading.shown(reading.observed().stops)},
                       joined("zone ", std::to_string(*unknown.begin()), ", from which no rock starts"),
                       "zones of the release",
                       "correct the column zone, or leave it empty to compare with all rocks");
    }
}

}  // namespace

config::Schema<ObservedStopRow> observed_stop_columns(bool by_shapes) {
    using R = ObservedStopRow;
    std::vector<config::ColumnOf<R>> fields;
    if (by_shapes) {
        // clang-format off
        fields.push_back(
            {"wkt", &R::shape, "where it rests", {.shapes = {config::Shape::Kind::point}, .single = true}});
        // clang-format on
    } else {
        fields.push_back({"x_m", &R::x_m, "east, where it rests"});
        fields.push_back({"y_m", &R::y_m, "north"});
    }
    fields.push_back({"x_release_m", &R::x_release_m, "where it was released"});
    fields.push_back({"y_release_m", &R::y_release_m, "north"});
    fields.push_back({"zone", &R::zone, "of the release; empty: any", {.range = {0.0, 4e9}}});
    fields.push_back({"group", &R::group, "such as the block", {.optional = true}});
    return {{.role = "observed_stops",
             .setting = "observed.stops",
             .row = "stop",
             .no_rows = "at least one, or no observed.stops"},
            std::move(fields)};
}

std::optional<std::vector<ObservedStop>> read_observed_stops(Reading& reading) {
    if (reading.observed().stops.empty()) {
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
    const config::Place place{reading.shown(reading.observed().stops)};
    if (static_cast<double>(off.size()) > plausible::most_off_terrain * static_cast<double>(stops.size())) {
        plausible::OffTerrain judged;
        judged.place = place;
        judged.singular = "stop";
        judged.all = stops.size();
        judged.off = off.size();
        judged.places = places;
        judged.swap_advice = "exchange the columns of x and y";
        const plausible::Extent extent = plausible::extent_of(terrain);
        judged.cut = plausible::cut_command(reading, "observed_stops", reading.observed().stops, extent);
        plausible::judge_off_terrain(judged, extent, reading);
        return;
    }
    reading.warn(place,
                 joined(std::to_string(off.size()), " of ", counted(stops.size(), "stop"),
                        " off the terrain, such as ", in_words(*off.front()),
                        "; they count, but no simulated rock can get there"),
                 "stops on the terrain", "take a larger terrain, or correct their coordinates");
}

}  // namespace coupling
