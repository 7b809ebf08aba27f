#include "coupling/inputs/tree_input.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "config/text/numbers.hpp"
#include "coupling/inputs/species_table.hpp"

namespace coupling {

namespace {

constexpr config::NumberRange dbh_range_cm{.low = 0.0, .high = 500.0, .low_excluded = true};
constexpr config::NumberRange height_range_m{.low = 0.0, .high = 150.0, .low_excluded = true};

/// Median of the positive numbers of a column, 0 without any.
double median_of(const config::Table& table, const std::string& column) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto value = config::parse_number(table.text(row, column));
        if (value && *value > 0.0) {
            values.push_back(*value);
        }
    }
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A wrong unit shows in the median before it shows anywhere else.
void check_units(const config::Table& table, Reading& reading) {
    const double dbh = median_of(table, "dbh_cm");
    const double height = median_of(table, "height_m");
    if (dbh > 200.0 || (dbh > 0.0 && dbh < 1.0)) {
        reading.doubt(
            {table.file()}, "a median dbh_cm of " + config::to_text(dbh),
            std::string{"centimetres; these look like "} + (dbh > 200.0 ? "millimetres" : "metres"));
    }
    if (height > 100.0 || (height > 0.0 && height < 1.0)) {
        reading.doubt({table.file()}, "a median height_m of " + config::to_text(height),
                      std::string{"metres; these look like "} +
                          (height > 100.0 ? "decimetres or centimetres" : "another unit"));
    }
}

/// Looks up species and counts what is unknown or borrowed, one message for each name.
class SpeciesFinder {
public:
    explicit SpeciesFinder(const config::Table& table) : table_{table}, known_{SpeciesTable::shipped()} {}

    const Species* find(std::size_t row) {
        const std::string& name = table_.text(row, "species");
        const auto [entry, is_new] = seen_.try_emplace(name);
        if (is_new) {
            entry->second = {known_.find(name), row, 0};
        }
        ++entry->second.count;
        return entry->second.species;
    }

    void tell(Reading& reading, config::Problems& problems) const {
        std::map<std::string, std::size_t> borrowed;
        for (const auto& [name, use] : seen_) {
            if (use.species == nullptr) {
                refuse(name, use, problems);
            } else if (!use.species->stand_in.empty()) {
                borrowed[use.species->code] += use.count;
            }
        }
        for (const auto& [code, count] : borrowed) {
            const Species& species = *known_.find(code);
            reading.note(table_.file() + ": " + counted(count, "tree") + " of " + species.code + " (" +
                         species.latin_name + ") taken like " + species.stand_in + "; the fracture energy " +
                         config::to_text(species.fracture_energy) + " is the species' own");
        }
    }

private:
    struct Use {
        const Species* species = nullptr;
        std::size_t first_row = 0;
        std::size_t count = 0;
    };

    void refuse(const std::string& name, const Use& use, config::Problems& problems) const {
        const std::string nearest = known_.nearest(name);
        std::string found = name.empty() ? "no species" : "species " + config::in_quotes(name);
        if (use.count > 1) {
            found += ", " + std::to_string(use.count) + " times";
        }
        problems.add(config::ExitCode::data, table_.place(use.first_row, "species"), std::move(found),
                     "a code or Latin name of the species table" +
                         (nearest.empty() ? std::string{", such as ABAL"} : " (" + nearest + "?)"));
    }

    const config::Table& table_;
    SpeciesTable known_;
    std::map<std::string, Use> seen_;
};

/// A row's tree; the fields that are wrong become problems.
std::optional<TreeRecord> tree_of(const config::Table& table, std::size_t row, SpeciesFinder& finder,
                                  config::Problems& problems) {
    TreeRecord tree;
    tree.id = table.has("tree_id") ? table.text(row, "tree_id") : "";
    if (tree.id.empty()) {
        tree.id = std::to_string(row + 1);
    }
    const auto x_m = table.number(row, "x_m", {}, problems);
    const auto y_m = table.number(row, "y_m", {}, problems);
    const auto dbh_cm = table.number(row, "dbh_cm", dbh_range_cm, problems);
    const auto height_m = table.number(row, "height_m", height_range_m, problems);
    const Species* species = finder.find(row);
    if (!x_m || !y_m || !dbh_cm || !height_m || species == nullptr) {
        return std::nullopt;
    }
    tree.species = species->code;
    tree.stem = {*x_m, *y_m, *dbh_cm, *height_m, species->fracture_energy};
    return tree;
}

void tell_doubled_ids(const std::vector<TreeRecord>& trees, const std::string& file, Reading& reading) {
    std::set<std::string> seen;
    std::set<std::string> doubled;
    for (const TreeRecord& tree : trees) {
        if (!seen.insert(tree.id).second) {
            doubled.insert(tree.id);
        }
    }
    if (!doubled.empty()) {
        reading.doubt({file},
                      counted(doubled.size(), "tree_id") + " used more than once, such as " +
                          config::in_quotes(*doubled.begin()),
                      "one tree_id for each tree");
    }
}

std::vector<TreeRecord> read_tree_table(Reading& reading) {
    const config::Table table = reading.table("trees.file", "trees", reading.scenario().trees);
    config::Problems problems;
    if (!table.require({"x_m", "y_m", "species", "dbh_cm", "height_m"}, problems)) {
        problems.throw_if_any();
    }
    check_units(table, reading);
    SpeciesFinder finder{table};
    std::vector<TreeRecord> trees;
    trees.reserve(table.rows());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (auto tree = tree_of(table, row, finder, problems)) {
            trees.push_back(std::move(*tree));
        }
    }
    config::Problems shown;
    finder.tell(reading, shown);
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    if (trees.empty()) {
        reading.doubt({table.file()}, "no trees", "at least one, or no trees.file for a bare slope");
    }
    tell_doubled_ids(trees, table.file(), reading);
    return trees;
}

}  // namespace

std::optional<std::vector<TreeRecord>> read_trees(Reading& reading) {
    if (reading.scenario().trees.empty()) {
        return std::vector<TreeRecord>{};
    }
    return reading.attempt([&] { return read_tree_table(reading); });
}

std::vector<TreeRecord> on_terrain(std::vector<TreeRecord> trees, const rockfall::Terrain& terrain,
                                   Reading& reading) {
    const Eigen::Vector2d origin_m = terrain.origin_m();
    const auto outside = std::stable_partition(trees.begin(), trees.end(), [&](const TreeRecord& tree) {
        return terrain.locate(tree.stem.x_m - origin_m.x(), tree.stem.y_m - origin_m.y()).has_value();
    });
    if (outside != trees.end()) {
        const auto count = static_cast<std::size_t>(trees.end() - outside);
        reading.doubt({reading.shown(reading.scenario().trees)},
                      counted(count, "tree") + " outside the terrain, such as tree " +
                          config::in_quotes(outside->id) + " (x " + config::to_text(outside->stem.x_m) +
                          ", y " + config::to_text(outside->stem.y_m) + "); left out",
                      "trees on the terrain");
        trees.erase(outside, trees.end());
    }
    return trees;
}

}  // namespace coupling
