#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "coupling/exchange/regimes/apply.hpp"
#include "coupling/exchange/regimes/regime.hpp"
#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace coupling {

inline const forest::SpeciesTable& species_table() {
    static const forest::SpeciesTable table = forest::SpeciesTable::shipped();
    return table;
}

inline forest::SpeciesId species_of(const std::string& code) {
    return *species_table().find(code);
}

/// A square of forest that faces south, its western half stand 1, its eastern half stand 2.
inline forest::PatchGrid two_stands(int side) {
    const forest::PatchGrid plain = forest::square_of_forest(side);
    std::vector<forest::Patch> patches = plain.patches();
    for (forest::Patch& patch : patches) {
        patch.management_unit = 2 * patch.cell.column < side ? 1 : 2;
    }
    return {plain.frame(), patches};
}

/// A spruce of 10 to 50 cm every four metres, 80 years old.
inline std::vector<forest::Tree> spruces(int side) {
    std::vector<forest::Tree> trees;
    const int a_row = side * 10 / 4;
    for (int i = 0; i < a_row * a_row; ++i) {
        const double dbh_cm = 10.0 + (i * 7 + i / a_row * 13) % 41;
        trees.push_back(forest::new_tree(species_table()[species_of("piab")], species_of("piab"),
                                         2.0 + 4.0 * (i % a_row), 2.0 + 4.0 * (i / a_row), dbh_cm,
                                         5.0 + 0.6 * dbh_cm, 80.0));
        trees.back().id = forest::TreeId{static_cast<std::uint64_t>(i)};
    }
    return trees;
}

inline forest::Stand spruce_stand(int side) {
    return {two_stands(side), species_table().size(), spruces(side), 2000};
}

/// Files that are always there: the south-western 20 x 20 m, and a line of 28 m to the north.
inline std::vector<config::Shape> one_polygon(const std::string& file, config::Shape::Kind kind) {
    if (file == "areas.csv" && kind == config::Shape::Kind::polygon) {
        return {forest::rectangle({10.0, 10.0}, 20.0, 20.0, {})};
    }
    if (file == "lines.csv" && kind == config::Shape::Kind::line) {
        return {{config::Shape::Kind::line, {{{20.0, 0.0}, {20.0, 28.0}}}}};
    }
    config::fail(config::ExitCode::file, {file}, "not there");
}

inline config::Table table_of(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "regime.csv");
}

inline Regime regime_of(const std::string& text, const forest::PatchGrid& grid) {
    return Regime::read(table_of(text), "regime", species_table(), grid, one_polygon);
}

/// What is said about a regime that is not accepted; empty for one that is.
inline std::string problems_of(const std::string& text, const forest::PatchGrid& grid) {
    try {
        static_cast<void>(regime_of(text, grid));
    } catch (const config::InputError& error) {
        return error.what();
    }
    return {};
}

inline double volume_m3(const forest::Stand& stand) {
    double sum = 0.0;
    for (const forest::Tree& tree : stand.trees()) {
        sum += tree.stems *
               forest::stem_volume_m3(species_table()[tree.species].allometry, tree.dbh_cm, tree.height_m);
    }
    return sum;
}

inline bool books_close(const forest::Stand& stand) {
    const forest::StandBalance balance = stand.total_balance();
    const double in_kg = stand.mass_at_start_kg() + balance.mass_in_kg + balance.grown_kg - balance.shed_kg;
    const double dead_kg = balance.dead_wood_in_kg - balance.all_dead_wood_out_kg();
    return std::abs(stand.dead_wood_kg() - dead_kg) <= 1e-9 * in_kg + 1e-6 &&
           stand.stems_at_start() + balance.all_stems_in() ==
               balance.all_stems_out() + stand.stems_standing() &&
           std::abs(in_kg - balance.all_lost_kg() - stand.mass_standing_kg()) <= 1e-9 * in_kg + 1e-6;
}

}  // namespace coupling
