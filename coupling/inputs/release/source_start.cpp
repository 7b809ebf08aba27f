#include "coupling/inputs/release/source_start.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling {

namespace {

using rockfall::StartLaw;

constexpr std::uint64_t most_rocks = 4'000'000'000ULL;  // rocks of a source are counted in 32 bits
constexpr double most_blocks = 1e9;
constexpr config::NumberRange diameter_range{.low = 0.01, .high = 20.0};
/// Spheres of these diameters and densities have no other volumes and masses.
constexpr config::NumberRange volume_range{.low = 0.0, .high = 4200.0, .low_excluded = true};
constexpr config::NumberRange mass_range{.low = 0.0, .high = 21'000.0, .low_excluded = true};

/// The fields of one row that may be empty.
class Row {
public:
    Row(const config::Table& table, std::size_t row, config::Problems& problems)
        : table_{table}, row_{row}, problems_{problems} {}

    [[nodiscard]] bool has(const std::string& column) const { return has_value(table_, row_, column); }
    [[nodiscard]] const std::string& text(const std::string& column) const {
        return table_.text(row_, column);
    }
    [[nodiscard]] config::Place place(const std::string& column) const {
        return table_.has(column) ? table_.place(row_, column) : table_.place(row_, "wkt");
    }
    [[nodiscard]] config::Problems& problems() const { return problems_; }
    std::optional<double> number(const std::string& column, config::NumberRange range) {
        return has(column) ? table_.number(row_, column, range, problems_) : std::nullopt;
    }
    std::optional<long long> whole(const std::string& column, config::NumberRange range) {
        return has(column) ? table_.whole(row_, column, range, problems_) : std::nullopt;
    }
    void refuse(const std::string& column, std::string found, std::string expected) {
        problems_.add(config::ExitCode::data, place(column), std::move(found), std::move(expected));
    }
    /// Tells of two fields of which only one may be filled. True if both are.
    bool both(const std::string& first, const std::string& second) {
        if (!has(first) || !has(second)) {
            return false;
        }
        refuse(second, second + " beside " + first, "only one of them for a source");
        return true;
    }

private:
    const config::Table& table_;
    std::size_t row_;
    config::Problems& problems_;
};

double diameter_of_volume_m(double volume_m3) {
    return std::cbrt(6.0 * volume_m3 / std::numbers::pi);
}

/// Size and density. True if the row says something of them.
bool read_size(Row& row, StartLaw& law) {
    const bool contradicts = row.both("diameter_m", "mass_t") | row.both("diameter_m", "volume_m3") |
                             row.both("mass_t", "volume_m3");
    const auto density_kgpm3 = row.number("density_kgpm3", {.low = 1000.0, .high = 5000.0});
    law.density_kgpm3 = density_kgpm3.value_or(law.density_kgpm3);
    std::optional<double> diameter_m = row.number("diameter_m", diameter_range);
    std::string column = "diameter_m";
    if (const auto mass_t = row.number("mass_t", mass_range)) {
        diameter_m = diameter_of_volume_m(1000.0 * *mass_t / law.density_kgpm3);
        column = "mass_t";
    }
    if (const auto volume_m3 = row.number("volume_m3", volume_range)) {
        diameter_m = diameter_of_volume_m(*volume_m3);
        column = "volume_m3";
    }
    if (diameter_m && !contradicts) {
        if (!diameter_range.contains(*diameter_m)) {
            row.refuse(column, "a rock of " + config::to_text(*diameter_m) + " m in diameter",
                       "a size of 0.01 to 20 m");
        }
        law.diameter = rockfall::DiameterLaw::fixed(*diameter_m);
    }
    return density_kgpm3 || diameter_m;
}

/// How the rocks begin to move. True if the row says something of it.
bool read_motion(Row& row, const Scenario& scenario, StartLaw& law) {
    row.both("speed_mps", "fall_height_m");
    row.both("azimuth_deg", "fall_height_m");
    const auto speed_mps = row.number("speed_mps", {.low = 0.0, .high = 100.0});
    const auto azimuth_deg = row.number("azimuth_deg", {.low = 0.0, .high = 360.0});
    const auto fall_height_m =
        row.number("fall_height_m", {.low = 0.0, .high = 1000.0, .low_excluded = true});
    if (speed_mps) {
        law.speed_mps = *speed_mps;
        law.height_m = scenario.start_height_m;
    }
    if (azimuth_deg) {
        law.azimuth = config::Angle::from_degrees(*azimuth_deg);
        if (!(law.speed_mps > 0.0)) {
            row.refuse("azimuth_deg", "azimuth_deg for a rock without speed",
                       "speed_mps or release.start_speed_mps above 0, or no azimuth_deg");
        }
    }
    if (fall_height_m) {
        law.height_m = *fall_height_m;
        law.speed_mps = 0.0;
    }
    return speed_mps || azimuth_deg || fall_height_m;
}

/// Shape and sides. Sides beside a size of the row are relative to each other. True if the row says something
/// of them.
bool read_shape(Row& row, const Scenario& scenario, StartLaw& law) {
    ShapeSettings shapes = scenario.shapes;
    const bool has_sides = row.has("side_a_m") || row.has("side_b_m") || row.has("side_c_m");
    if (!has_sides && !row.has("shape") && !row.has("sides_scatter") && !row.has("shape_file")) {
        return false;
    }
    if (row.has("shape")) {
        shapes.shape = row.text("shape");
        shapes.shares.clear();
    } else if (row.has("shape_file")) {
        shapes.shape = "hull";
        shapes.shares.clear();
    } else if (has_sides) {
        shapes.shape = "box";
        shapes.shares.clear();
    }
    if (row.has("shape_file")) {
        shapes.file = row.text("shape_file");
    }
    if (has_sides) {
        shapes.sides.clear();
        constexpr config::NumberRange side_range{.low = 0.0, .high = 50.0, .low_excluded = true};
        shapes.sides_m.clear();
        for (const char* column : {"side_a_m", "side_b_m", "side_c_m"}) {
            if (!row.has(column)) {
                row.refuse(column, std::string{"no "} + column, "all three sides, or none");
                return true;
            }
            const auto side_m = row.number(column, side_range);
            if (!side_m) {
                return true;
            }
            shapes.sides_m.push_back(*side_m);
        }
        if (row.has("diameter_m") || row.has("mass_t") || row.has("volume_m3")) {
            shapes.sides = std::exchange(shapes.sides_m, {});
        }
    }
    if (const auto scatter = row.number("sides_scatter", {.low = 0.0, .high = 0.9})) {
        shapes.sides_scatter = *scatter;
    }
    const auto place = [&](const std::string& name) {
        return row.place(name == "sides_m" || name == "sides" ? "side_a_m" : row.has(name) ? name : "shape");
    };
    law.shape = shape_law(
        shapes, place, [&](const std::string& name) { return scenario.resolve(name); }, row.problems());
    if (law.shape) {
        if (const auto own_m = law.shape->own_diameter_m()) {
            law.diameter = rockfall::DiameterLaw::fixed(*own_m);
        }
    }
    if (!rocks_have_shapes(scenario)) {
        law.shape = nullptr;  // spheres of the same volume
    }
    return true;
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
                             std::span<const SourceStart> starts, const Scenario& scenario) {
    std::vector<rockfall::ReleaseSource> rest;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (!starts[rows[i]].blocks) {
            rest.push_back(sources[i]);
        }
    }
    if (rest.empty()) {
        return 0;
    }
    const std::uint64_t rocks = scenario.rocks > 0 ? scenario.rocks : scenario.rocks_per_source * rest.size();
    if (rocks <= most_rocks) {
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

std::vector<std::string> start_columns() {
    return {"zone",       "blocks",   "speed_mps", "azimuth_deg",   "fall_height_m",
            "diameter_m", "mass_t",   "volume_m3", "density_kgpm3", "shape",
            "side_a_m",   "side_b_m", "side_c_m",  "sides_scatter", "shape_file"};
}

SourceStart read_source_start(const config::Table& table, std::size_t row_number, const Scenario& scenario,
                              config::Problems& problems) {
    Row row{table, row_number, problems};
    SourceStart start;
    if (const auto blocks = row.whole("blocks", {.low = 1.0, .high = most_blocks})) {
        start.blocks = static_cast<std::uint32_t>(*blocks);
    }
    StartLaw law = start_law(scenario);
    const bool has_size = read_size(row, law);
    const bool has_motion = read_motion(row, scenario, law);
    const bool has_shape = read_shape(row, scenario, law);
    if (has_size || has_motion || has_shape) {
        start.law = std::make_shared<const StartLaw>(std::move(law));
    }
    return start;
}

void share_rocks(std::vector<rockfall::ReleaseSource>& sources, std::span<const std::size_t> rows,
                 std::span<const SourceStart> starts, Reading& reading) {
    const Scenario& scenario = reading.scenario();
    share_blocks(sources, rows, starts);
    std::uint64_t rocks = share_the_rest(sources, rows, starts, scenario);
    bool has_rest = false;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const bool has_blocks = starts[rows[i]].blocks.has_value();
        rocks += has_blocks ? sources[i].rocks : 0;
        has_rest = has_rest || !has_blocks;
    }
    if (rocks > most_rocks) {
        reading.refuse(scenario.options->place_of("release.rocks_per_source"),
                       counted(rocks, "rock") + " from " + counted(sources.size(), "source"),
                       "at most " + std::to_string(most_rocks) + " in one run");
        return;
    }
    for (const char* key : {"release.rocks", "release.rocks_per_source"}) {
        if (!has_rest && scenario.options->was_set(key)) {
            reading.note(std::string{key} + " has no effect: each source says how many blocks it has");
        }
    }
    rockfall::number_rocks(sources);
}

}  // namespace coupling
