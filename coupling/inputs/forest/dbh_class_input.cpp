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
#include "forest/start/height_curve.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

constexpr double highest_stand_of_classes = 4e9;

/// Reads the rows of a table of diameter classes.
class ClassReader {
public:
    ClassReader(const config::Table& table, const ForestSpecies& species, const SpeciesLookup& lookup,
                const std::map<std::uint32_t, InventoriedStand>& others)
        : table_{table}, species_{species}, column_{table, lookup}, others_{others} {}

    void read(std::size_t row) {
        const std::size_t before = problems_.list().size();
        const auto stand = table_.whole(row, "stand", {1.0, highest_stand_of_classes}, problems_);
        const auto species = column_.find(row);
        forest::SpeciesRecord record;
        record.class_from_cm =
            table_.number(row, "dbh_from_cm", {forest::smallest_tree_cm, 500.0}, problems_);
        record.class_to_cm = table_.number(row, "dbh_to_cm", {forest::smallest_tree_cm, 500.0}, problems_);
        record.stems_pha = table_.number(row, "stems_pha", {0.0, 1e6}, problems_);
        record.mean_height_m = optional(row, "height_m", {.low = 1.5, .high = 100.0, .low_excluded = true});
        record.age_years = optional(row, "age_years", {0.0, 2000.0});
        if (!stand || !species || problems_.list().size() > before) {
            return;
        }
        record.species = forest::SpeciesId{static_cast<std::uint16_t>(*species)};
        record.mean_dbh_cm = 0.5 * (*record.class_from_cm + *record.class_to_cm);
        if (is_sound(static_cast<std::uint32_t>(*stand), record, row)) {
            const auto [found, is_new] = stands_.try_emplace(static_cast<std::uint32_t>(*stand));
            if (is_new) {
                found->second.place = table_.place(row, "stand");
            }
            found->second.species.push_back(record);
        }
    }

    std::map<std::uint32_t, InventoriedStand> finish(Reading& reading) {
        config::Problems shown;
        column_.refuse_unknown(shown);
        add_first(shown, problems_, table_.file());
        shown.throw_if_any();
        warn_of_stand_ins(column_, species_, table_.file(), reading);
        for (auto& [number, stand] : stands_) {
            // Thick trees take their places first.
            std::stable_sort(stand.species.begin(), stand.species.end(), [](const auto& a, const auto& b) {
                return *a.class_from_cm > *b.class_from_cm;
            });
        }
        return std::move(stands_);
    }

private:
    std::optional<double> optional(std::size_t row, const std::string& column,
                                   const config::NumberRange& range) {
        return table_.has(column) && !table_.text(row, column).empty()
                   ? table_.number(row, column, range, problems_)
                   : std::nullopt;
    }

    bool refuse(std::size_t row, const std::string& column, std::string found, std::string expected,
                std::string advice) {
        problems_.add(ExitCode::data, table_.place(row, column), std::move(found), std::move(expected),
                      std::move(advice));
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
    SpeciesColumn column_;
    const std::map<std::uint32_t, InventoriedStand>& others_;
    config::Problems problems_;
    std::map<std::uint32_t, InventoriedStand> stands_;
};

}  // namespace

bool add_dbh_classes(const ForestSpecies& species, Reading& reading,
                     std::map<std::uint32_t, InventoriedStand>& stands) {
    const std::string& name = reading.scenario().forest.dbh_classes;
    if (name.empty()) {
        return true;
    }
    auto read = reading.attempt([&] {
        const config::Table table = reading.table("stands.dbh_classes", "dbh_classes", name);
        config::Problems problems;
        table.require({"stand", "species", "dbh_from_cm", "dbh_to_cm", "stems_pha"}, problems);
        problems.throw_if_any();
        const SpeciesLookup lookup = species.lookup();
        ClassReader reader{table, species, lookup, stands};
        for (std::size_t row = 0; row < table.rows(); ++row) {
            reader.read(row);
        }
        return reader.finish(reading);
    });
    if (!read) {
        return false;
    }
    stands.merge(*read);
    return true;
}

}  // namespace coupling
