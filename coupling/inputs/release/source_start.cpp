#include "coupling/inputs/release/source_start.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/release_settings.hpp"
#include "rockfall/parameters.hpp"

namespace coupling {

namespace {

using rockfall::StartLaw;

constexpr std::uint64_t most_source_rocks = 4'000'000'000ULL;  // rocks of a source are counted in 32 bits
constexpr config::NumberRange diameter_range{.low = 0.01, .high = 20.0};

/// Refuses two fields of which only one may be filled. True if both are.
bool both(const config::Read<SourceRow>& row, const std::optional<double>& first, const char* first_name,
          const std::optional<double>& second, const char* second_name, config::RowProblems& wrong) {
    if (!first || !second) {
        return false;
    }
    wrong.refuse(row.row, second_name, std::string{second_name} + " beside " + first_name,
                 "only one of them for a source");
    return true;
}

double diameter_of_volume_m(double volume_m3) {
    return std::cbrt(6.0 * volume_m3 / std::numbers::pi);
}

/// Size and density.
void take_size(const config::Read<SourceRow>& row, StartLaw& law, config::RowProblems& wrong) {
    const bool contradicts = both(row, row.diameter_m, "diameter_m", row.mass_t, "mass_t", wrong) |
                             both(row, row.diameter_m, "diameter_m", row.volume_m3, "volume_m3", wrong) |
                             both(row, row.mass_t, "mass_t", row.volume_m3, "volume_m3", wrong);
    law.density_kgpm3 = row.density_kgpm3.value_or(law.density_kgpm3);
    if (contradicts || !row.has_size()) {
        return;
    }
    const double diameter_m = row.diameter_m ? *row.diameter_m
                              : row.mass_t   ? diameter_of_volume_m(1000.0 * *row.mass_t / law.density_kgpm3)
                                             : diameter_of_volume_m(*row.volume_m3);
    if (!diameter_range.contains(diameter_m)) {
        wrong.refuse(row.row, row.mass_t ? "mass_t" : "volume_m3",
                     "a rock of " + config::to_text(diameter_m) + " m in diameter", "a size of 0.01 to 20 m");
    }
    law.diameter = rockfall::DiameterLaw::fixed(diameter_m);
}

/// How the rocks begin to move.
void take_motion(const config::Read<SourceRow>& row, const ReleaseSettings& release, StartLaw& law,
                 config::RowProblems& wrong) {
    both(row, row.speed_mps, "speed_mps", row.fall_height_m, "fall_height_m", wrong);
    both(row, row.azimuth_deg, "azimuth_deg", row.fall_height_m, "fall_height_m", wrong);
    if (row.speed_mps) {
        law.speed_mps = *row.speed_mps;
        law.height_m = release.start_height_m;
    }
    if (row.azimuth_deg) {
        law.azimuth = config::Angle::from_degrees(*row.azimuth_deg);
        if (!(law.speed_mps > 0.0)) {
            wrong.refuse(row.row, "azimuth_deg", "azimuth_deg for a rock without speed",
                         "speed_mps or release.start_speed_mps above 0, or no azimuth_deg");
        }
    }
    if (row.fall_height_m) {
        law.height_m = *row.fall_height_m;
        law.speed_mps = 0.0;
    }
}

/// The three sides of a row, of which it has all or none.
bool take_sides(const config::Read<SourceRow>& row, ShapeSettings& shapes, config::RowProblems& wrong) {
    shapes.sides.clear();
    shapes.sides_m.clear();
    for (const auto& [column, side_m] :
         {std::pair{"side_a_m", row.side_a_m}, {"side_b_m", row.side_b_m}, {"side_c_m", row.side_c_m}}) {
        if (!side_m) {
            wrong.refuse(row.row, column, std::string{"no "} + column, "all three sides, or none");
            return false;
        }
        shapes.sides_m.push_back(*side_m);
    }
    if (row.has_size()) {
        shapes.sides = std::exchange(shapes.sides_m, {});
    }
    return true;
}

/// Shape and sides. Sides beside a size of the row are relative to each other. True if the row says something
/// of them.
bool take_shape(const config::Read<SourceRow>& row, const Reading& reading, StartLaw& law,
                config::RowProblems& wrong) {
    ShapeSettings shapes = reading.release().shapes;
    const bool has_sides = row.side_a_m || row.side_b_m || row.side_c_m;
    if (!has_sides && row.shape_name.empty() && !row.sides_scatter && row.shape_file.empty()) {
        return false;
    }
    if (!row.shape_name.empty() || !row.shape_file.empty() || has_sides) {
        shapes.shape = !row.shape_name.empty() ? row.shape_name : !row.shape_file.empty() ? "hull" : "box";
        shapes.shares.clear();
    }
    if (!row.shape_file.empty()) {
        shapes.file = row.shape_file;
    }
    if (has_sides && !take_sides(row, shapes, wrong)) {
        return true;
    }
    shapes.sides_scatter = row.sides_scatter.value_or(shapes.sides_scatter);
    const auto place = [&](const std::string& name) {
        const bool is_own = (name == "sides_scatter" && row.sides_scatter) ||
                            (name == "shape_file" && !row.shape_file.empty());
        return wrong.place(row.row, name == "sides_m" || name == "sides" ? "side_a_m"
                                    : is_own                             ? name
                                                                         : "shape");
    };
    law.shape = shape_law(
        shapes, place, [&](const std::string& name) { return reading.settings().resolve(name); }, wrong);
    if (law.shape) {
        if (const auto own_m = law.shape->own_diameter_m()) {
            law.diameter = rockfall::DiameterLaw::fixed(*own_m);
        }
    }
    law.elongation = law.shape ? rockfall::ElongationLaw{*law.shape} : rockfall::ElongationLaw{1.0, 0.0};
    if (!rocks_have_shapes(reading.rockfall())) {
        law.shape = nullptr;  // spheres of the same volume
    }
    return true;
}

using SourceField = config::ColumnOf<SourceRow>;

/// The columns of both tables behind those in which they differ. Spheres of these diameters and densities
/// have no other volumes and masses.
std::vector<SourceField> with_rocks(std::vector<SourceField> fields) {
    using config::above;
    using R = SourceRow;
    constexpr config::NumberRange side_range{0.0, 50.0, above};
    // clang-format off
    const std::vector<SourceField> of_rocks{
        {"zone", &R::zone, "of the release", {.range = {1.0, 4e9}}},
        {"blocks", &R::blocks, "how many rocks, of all parts of the row together; empty: a share of release.rocks", {.unit = "-", .range = {1.0, 1e9}}},
        {"speed_mps", &R::speed_mps, "initial, from release.start_height_m above the ground", {.range = {0.0, 100.0}}},
        {"azimuth_deg", &R::azimuth_deg, "heading of that speed, clockwise from north; empty: down the fall line", {.range = {0.0, 360.0}}},
        {"fall_height_m", &R::fall_height_m, "instead of both: dropped at rest from this height of the underside", {.range = {0.0, 1000.0, above}}},
        {"diameter_m", &R::diameter_m, "of spheres; instead mass_t or volume_m3", {.range = diameter_range}},
        {"mass_t", &R::mass_t, "of each rock", {.range = {0.0, 21'000.0, above}}},
        {"volume_m3", &R::volume_m3, "of each rock", {.range = {0.0, 4200.0, above}}},
        {"density_kgpm3", &R::density_kgpm3, "of the rocks", {.range = {1000.0, 5000.0}}},
        {"shape", &R::shape_name, "as release.shape, for motion models whose rocks have one", {.optional = true}},
        {"side_a_m", &R::side_a_m, "sides of the shape; beside a size only their ratios count", {.range = side_range}},
        {"side_b_m", &R::side_b_m, "second side", {.range = side_range}},
        {"side_c_m", &R::side_c_m, "third side", {.range = side_range}},
        {"sides_scatter", &R::sides_scatter, "each side is drawn within this share of itself, either way", {.unit = "-", .range = {0.0, 0.9}}},
        {"shape_file", &R::shape_file, "hull of the rocks: CSV of points, PLY or STL", {.optional = true}}};
    // clang-format on
    fields.insert(fields.end(), of_rocks.begin(), of_rocks.end());
    return fields;
}

/// The rocks of the rows that say how many they have.
void share_blocks(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                  std::span<const SourceStart> starts) {
    std::map<std::size_t, std::vector<std::size_t>> of_row;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (starts[rows[i]].blocks) {
            of_row[rows[i]].push_back(i);
        }
    }
    for (const auto& [row, places] : of_row) {
        std::vector<rockfall::ReleaseSource> of_this;
        for (const std::size_t place : places) {
            of_this.push_back(sources[place]);
        }
        rockfall::spread(of_this, *starts[row].blocks);
        for (std::size_t i = 0; i < places.size(); ++i) {
            sources[places[i]].rocks = of_this[i].rocks;
        }
    }
}

/// The rocks of all other rows. Returns how many they are together.
std::uint64_t share_the_rest(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                             std::span<const SourceStart> starts, const ReleaseSettings& release) {
    std::vector<rockfall::ReleaseSource> rest;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (!starts[rows[i]].blocks) {
            rest.push_back(sources[i]);
        }
    }
    if (rest.empty()) {
        return 0;
    }
    const std::uint64_t rocks = release.rocks > 0 ? release.rocks : release.rocks_per_source * rest.size();
    if (rocks <= most_source_rocks) {
        rockfall::allot(rest, rocks);
        auto next = rest.begin();
        for (std::size_t i = 0; i < sources.size(); ++i) {
            if (!starts[rows[i]].blocks) {
                sources[i].rocks = (next++)->rocks;
            }
        }
    }
    return rocks;
}

}  // namespace

const config::Schema<SourceRow>& source_shape_columns() {
    using config::Shape;
    // clang-format off
    static const config::Schema<SourceRow> columns{
        {.role = "source_shapes", .setting = "release.source_shapes", .row = "source"},
        with_rocks({{"wkt", &SourceRow::shape, "one kind in a file", {.shapes = {Shape::Kind::point, Shape::Kind::line, Shape::Kind::polygon}}}})};
    // clang-format on
    return columns;
}

const config::Schema<SourceRow>& zone_block_columns() {
    // clang-format off
    static const config::Schema<SourceRow> columns{
        {.role = "return_periods", .setting = "hazard.blocks", .row = "row", .no_rows = "rocks of at least one zone with one return period"},
        with_rocks({{"return_period_years", &SourceRow::return_period_years, "of these rocks, in this zone or all others", {.range = {0.0, 1e6, config::above}}}})};
    // clang-format on
    return columns;
}

SourceStart read_source_start(const config::Read<SourceRow>& row, const Reading& reading,
                              config::RowProblems& wrong) {
    SourceStart start;
    start.blocks = row.blocks;
    StartLaw law = start_law(reading.release());
    take_size(row, law, wrong);
    take_motion(row, reading.release(), law, wrong);
    const bool has_shape = take_shape(row, reading, law, wrong);
    if (has_shape || row.has_size() || row.density_kgpm3 || row.speed_mps || row.azimuth_deg ||
        row.fall_height_m) {
        start.law = std::make_shared<const StartLaw>(std::move(law));
    }
    return start;
}

void share_rocks(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                 std::span<const SourceStart> starts, Reading& reading) {
    share_blocks(sources, rows, starts);
    std::uint64_t rocks = share_the_rest(sources, rows, starts, reading.release());
    bool has_rest = false;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const bool has_blocks = starts[rows[i]].blocks.has_value();
        rocks += has_blocks ? sources[i].rocks : 0;
        has_rest = has_rest || !has_blocks;
    }
    if (rocks > most_source_rocks) {
        reading.refuse(reading.settings().options->place_of("release.rocks_per_source"),
                       counted(rocks, "rock") + " from " + counted(sources.size(), "source"),
                       "at most " + std::to_string(most_source_rocks) + " in one run");
        return;
    }
    for (const char* key : {"release.rocks", "release.rocks_per_source"}) {
        if (!has_rest && reading.settings().options->was_set(key)) {
            reading.note(std::string{key} + " has no effect: each source says how many blocks it has");
        }
    }
    rockfall::number_rocks(sources);
}

}  // namespace coupling
