#include "coupling/inputs/forest/tops/species_of_tops.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "config/random/stream.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/tops/species_shares.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"

namespace coupling {
namespace {

using config::joined;

/// An area with what grows there, and the rectangle around it.
struct SpeciesArea {
    config::Shape shape;
    std::vector<SpeciesShare> shares;
    config::Point2 low{};
    config::Point2 high{};

    [[nodiscard]] bool holds(config::Point2 place) const {
        return place.x_m >= low.x_m && place.x_m <= high.x_m && place.y_m >= low.y_m &&
               place.y_m <= high.y_m && config::point_in_polygon(shape, place);
    }
};

std::vector<SpeciesShare> shares_in(const std::string& text, const config::Place& place,
                                    const ExpectedSpecies& expected_instead) {
    try {
        std::vector<SpeciesShare> shares = species_shares(text);
        config::Problems unknown;
        for (const SpeciesShare& one : shares) {
            if (std::string expected = expected_instead(one.name); !expected.empty()) {
                unknown.add(config::ExitCode::data, place, joined("species ", config::in_quotes(one.name)),
                            std::move(expected));
            }
        }
        unknown.throw_if_any();
        return shares;
    } catch (const std::invalid_argument& wrong) {
        config::fail(config::ExitCode::data, place, wrong.what(),
                     "a species, or several with shares that add up to 100",
                     "such as PIAB, or PIAB 60, FASY 40");
    }
}

std::vector<SpeciesArea> areas_of_species(Reading& reading, const ExpectedSpecies& expected_instead) {
    std::vector<SpeciesArea> areas;
    if (reading.trees().species_areas.empty()) {
        return areas;
    }
    const config::Table table = table_of(species_area_columns(), reading.trees().species_areas, reading);
    for (config::Read<SpeciesAreaRow>& row : species_area_columns().all(table)) {
        SpeciesArea area{std::move(row.shape),
                         shares_in(row.species, table.place(row.row, "species"), expected_instead)};
        area.low = area.high = area.shape.parts.front().front();
        for (const std::vector<config::Point2>& ring : area.shape.parts) {
            for (const config::Point2 corner : ring) {
                area.low = {std::min(area.low.x_m, corner.x_m), std::min(area.low.y_m, corner.y_m)};
                area.high = {std::max(area.high.x_m, corner.x_m), std::max(area.high.y_m, corner.y_m)};
            }
        }
        areas.push_back(std::move(area));
    }
    return areas;
}

/// Nothing where a coordinate is none, which the reader of the list reports.
std::optional<config::Point2> place_of_top(const config::Table& table, std::size_t row, bool swap_xy) {
    const auto x_m = config::parse_number(table.text(row, swap_xy ? "y_m" : "x_m"));
    const auto y_m = config::parse_number(table.text(row, swap_xy ? "x_m" : "y_m"));
    return x_m && y_m ? std::optional{config::Point2{*x_m, *y_m}} : std::nullopt;
}

}  // namespace

std::uint64_t key_of_place(double x_m, double y_m) {
    const auto low_bits = [](double place_m) {
        return static_cast<std::uint64_t>(std::llround(1000.0 * place_m)) & 0xFFFFFFU;
    };
    return (low_bits(x_m) << 24) | low_bits(y_m);
}

const config::Schema<SpeciesAreaRow>& species_area_columns() {
    // clang-format off
    static const config::Schema<SpeciesAreaRow> columns{
        {.role = "species_areas", .setting = "trees.species_areas", .row = "area"},
        {{"species", &SpeciesAreaRow::species, "code or name of all its trees, or several with shares: PIAB 60, FASY 40"},
         {"wkt", &SpeciesAreaRow::shape, "the area; later rows lie on top", {.shapes = {config::Shape::Kind::polygon}}}}};
    // clang-format on
    return columns;
}

std::vector<std::string> species_of_tops(const config::Table& table, Reading& reading,
                                         const ExpectedSpecies& expected_instead) {
    const TreeSettings& settings = reading.trees();
    const std::vector<SpeciesArea> areas = areas_of_species(reading, expected_instead);
    std::vector<SpeciesShare> elsewhere;
    if (!settings.species.empty()) {
        elsewhere = shares_in(settings.species, reading.scenario().options->place_of("trees.species"),
                              expected_instead);
    }
    std::vector<std::string> species(table.rows());
    std::size_t without = 0;
    std::size_t in_areas = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::optional<config::Point2> place = place_of_top(table, row, settings.swap_xy);
        const std::vector<SpeciesShare>* shares = &elsewhere;
        for (const SpeciesArea& area : areas) {
            shares = place && area.holds(*place) ? &area.shares : shares;
        }
        in_areas += shares == &elsewhere ? 0U : 1U;
        if (shares->empty()) {
            ++without;
            continue;
        }
        const std::uint64_t key = place ? key_of_place(place->x_m, place->y_m) : row;
        const config::RandomStream stream{{reading.run().seed, 0, 0, key}, config::Purpose::unseen_tree};
        species[row] = species_at(*shares, stream.uniforms_of(0)[0]);
    }
    if (without > 0) {
        config::fail(config::ExitCode::data, {table.file()},
                     joined(counted(without, "tree"), " outside the areas of trees.species_areas"),
                     "a species for each tree", "set trees.species for those outside");
    }
    if (!areas.empty() && in_areas == 0 && table.rows() > 0) {
        reading.warn(
            {reading.shown(settings.species_areas)}, "no tree inside these areas",
            "areas over trees of the list",
            "compare the coordinate system of both files: all trees have the species of trees.species",
            config::Effect::answer);
    }
    return species;
}

}  // namespace coupling
