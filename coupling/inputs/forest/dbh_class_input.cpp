#include "coupling/inputs/forest/dbh_class_input.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/species_column.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling {

struct DbhClassRow {
    std::uint32_t stand = 0;
    double from_cm = 0.0;
    double to_cm = 0.0;
    double stems_pha = 0.0;
    std::optional<double> height_m;
    std::optional<double> age_years;
};

namespace {

using config::joined;

/// Puts the rows of a table of diameter classes into stands.
class ClassReader {
public:
    ClassReader(const config::Table& table, const ForestSpecies& species,
                const std::map<std::uint32_t, InventoriedStand>& others)
        : table_{table}, species_{species}, others_{others}, wrong_{table} {}

    std::map<std::uint32_t, InventoriedStand> all(Reading& reading) {
        const SpeciesColumn column{table_, species_.lookup(), wrong_};
        for (const config::Read<DbhClassRow>& row : dbh_class_columns().rows(table_, wrong_)) {
            if (const auto species = column.find(row.row)) {
                take(row, forest::SpeciesId{static_cast<std::uint16_t>(*species)});
            }
        }
        wrong_.throw_first();
        warn_of_stand_ins(column, species_, table_.file(), reading);
        for (auto& [number, stand] : stands_) {
            // Thick trees take their places first.
            std::stable_sort(stand.species.begin(), stand.species.end(), [](const auto& a, const auto& b) {
                return *a.class_from_cm > *b.class_from_cm;
            });
        }
        return std::move(stands_);
    }

private:
    void take(const config::Read<DbhClassRow>& row, forest::SpeciesId species) {
        const forest::SpeciesRecord record{.species = species,
                                           .stems_pha = row.stems_pha,
                                           .mean_dbh_cm = 0.5 * (row.from_cm + row.to_cm),
                                           .mean_height_m = row.height_m,
                                           .age_years = row.age_years,
                                           .class_from_cm = row.from_cm,
                                           .class_to_cm = row.to_cm};
        if (is_sound(row.stand, record, row.row)) {
            const auto [found, is_new] = stands_.try_emplace(row.stand);
            if (is_new) {
                found->second.place = table_.place(row.row, "stand");
            }
            found->second.species.push_back(record);
        }
    }

    bool refuse(std::size_t row, const std::string& column, std::string found, std::string expected,
                std::string advice) {
        wrong_.refuse(row, column, std::move(found), std::move(expected), std::move(advice));
        return false;
    }

    bool is_sound(std::uint32_t stand, const forest::SpeciesRecord& record, std::size_t row) {
        const forest::Species& kind = species_.table[record.species];
        const std::string ends = joined(config::to_text(*record.class_from_cm), " to ",
                                        config::to_text(*record.class_to_cm), " cm");
        if (others_.contains(stand)) {
            return refuse(row, "stand",
                          joined("stand ", std::to_string(stand), ", which stands.records has too"),
                          "a stand of one of the two tables", "remove it from one of them");
        }
        if (*record.class_to_cm <= *record.class_from_cm) {
            return refuse(row, "dbh_to_cm", joined("a class of ", ends), "an upper end above the lower one",
                          "exchange the two");
        }
        if (*record.class_to_cm > kind.height_growth.max_dbh_cm) {
            return refuse(row, "dbh_to_cm", joined("a class of ", ends),
                          joined("at most the greatest diameter of ", kind.latin_name, ", ",
                                 config::to_text(kind.height_growth.max_dbh_cm), " cm"),
                          "check the unit (cm) and the species");
        }
        const double greatest_m = forest::greatest_recorded_height_m(kind.height_growth);
        if (record.mean_height_m.value_or(0.0) > greatest_m) {
            return refuse(row, "height_m", joined("height_m ", config::to_text(*record.mean_height_m)),
                          joined("at most the greatest height of ", kind.latin_name, ", ",
                                 config::to_text(greatest_m), " m"),
                          "check the unit (m) and the species");
        }
        const auto known = stands_.find(stand);
        const auto overlaps = [&](const forest::SpeciesRecord& other) {
            return other.species == record.species && *other.class_from_cm < *record.class_to_cm &&
                   *record.class_from_cm < *other.class_to_cm;
        };
        if (known != stands_.end() &&
            std::any_of(known->second.species.begin(), known->second.species.end(), overlaps)) {
            return refuse(row, "dbh_from_cm", joined("a class of ", ends, " that overlaps another one"),
                          "classes of a species side by side", "correct one of the ends");
        }
        return true;
    }

    const config::Table& table_;
    const ForestSpecies& species_;
    const std::map<std::uint32_t, InventoriedStand>& others_;
    config::RowProblems wrong_;
    std::map<std::uint32_t, InventoriedStand> stands_;
};

}  // namespace

const config::Schema<DbhClassRow>& dbh_class_columns() {
    using config::above;
    constexpr config::NumberRange ends_cm{forest::smallest_tree_cm, 500.0};
    // clang-format off
    static const config::Schema<DbhClassRow> columns{
        {.role = "dbh_classes", .setting = "stands.dbh_classes", .row = "diameter class"},
        {{"stand", &DbhClassRow::stand, "its number on the map", {.range = stand_numbers}},
         {"species", "code or name"},
         {"dbh_from_cm", &DbhClassRow::from_cm, "lower end", {.range = ends_cm}},
         {"dbh_to_cm", &DbhClassRow::to_cm, "upper end", {.range = ends_cm}},
         {"stems_pha", &DbhClassRow::stems_pha, "in the class", {.range = {0.0, 1e6}}},
         {"height_m", &DbhClassRow::height_m, "of the middle of the class", {.range = {1.5, 100.0, above}}},
         {"age_years", &DbhClassRow::age_years, "mean", {.range = {0.0, 2000.0}}}}};
    // clang-format on
    return columns;
}

bool add_dbh_classes(const ForestSpecies& species, Reading& reading,
                     std::map<std::uint32_t, InventoriedStand>& stands) {
    const std::string& name = reading.forest().dbh_classes;
    if (name.empty()) {
        return true;
    }
    auto read = reading.attempt([&] {
        const config::Table table = table_of(dbh_class_columns(), name, reading);
        return ClassReader{table, species, stands}.all(reading);
    });
    if (read) {
        stands.merge(*read);
    }
    return read.has_value();
}

}  // namespace coupling
