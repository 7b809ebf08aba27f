#include "coupling/inputs/forest/start_input.hpp"

#include <map>

#include "config/options/values.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/browsing_note.hpp"
#include "coupling/inputs/reading/passed_over_columns.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

/// Above, young trees are trees: they belong into the records of the stand.
constexpr double highest_sapling_m = 1.9;
constexpr double cm_pm = 100.0;
constexpr double highest_stand_number = 4e9;

/// Patches by stand number; those of the whole forest under 0.
std::map<std::uint32_t, std::vector<forest::PatchId>> patches_by_stand(const forest::PatchGrid& grid) {
    std::map<std::uint32_t, std::vector<forest::PatchId>> patches;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        patches[grid.patches()[i].management_unit].push_back(forest::PatchId{i});
        patches[0].push_back(forest::PatchId{i});
    }
    return patches;
}

/// What the two tables share: stand, species and the rows' order.
template <class Record>
class StandTable {
public:
    StandTable(const config::Table& table, const ForestSpecies& species, const SpeciesLookup& lookup,
               const forest::PatchGrid& grid)
        : table_{table}, species_{species}, column_{table, lookup}, patches_{patches_by_stand(grid)} {}

    template <class Fill>
    std::vector<forest::OnPatches<Record>> read(Reading& reading, Fill fill) {
        std::map<std::uint32_t, forest::OnPatches<Record>> stands;
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const std::size_t before = problems_.list().size();
            const auto stand = stand_of(row);
            const auto species = column_.find(row);
            Record record;
            fill(row, record);
            if (!stand || !species || problems_.list().size() > before) {
                continue;
            }
            record.species = forest::SpeciesId{static_cast<std::uint16_t>(*species)};
            auto& here = stands[*stand];
            here.patches = patches_[*stand];
            here.records.push_back(record);
        }
        config::Problems shown;
        column_.refuse_unknown(shown);
        add_first(shown, problems_, table_.file());
        shown.throw_if_any();
        warn_of_stand_ins(column_, species_, table_.file(), reading);
        std::vector<forest::OnPatches<Record>> all;
        for (auto& [number, stand] : stands) {
            all.push_back(std::move(stand));
        }
        return all;
    }

    [[nodiscard]] bool has(std::size_t row, const std::string& column) const {
        return table_.has(column) && !table_.text(row, column).empty();
    }
    std::optional<double> optional(std::size_t row, const std::string& column,
                                   const config::NumberRange& range) {
        return has(row, column) ? table_.number(row, column, range, problems_) : std::nullopt;
    }
    const config::Table& table() const { return table_; }
    config::Problems& problems() { return problems_; }

private:
    std::optional<std::uint32_t> stand_of(std::size_t row) {
        if (table_.text(row, "stand") == "all") {
            return 0;
        }
        const auto number = table_.whole(row, "stand", {1.0, highest_stand_number}, problems_);
        if (number && !patches_.contains(static_cast<std::uint32_t>(*number))) {
            problems_.add(ExitCode::data, table_.place(row, "stand"),
                          joined("stand ", table_.text(row, "stand"), " which has no forest cell"),
                          "a stand of the map, or all");
            return std::nullopt;
        }
        return number ? std::optional{static_cast<std::uint32_t>(*number)} : std::nullopt;
    }

    const config::Table& table_;
    const ForestSpecies& species_;
    SpeciesColumn column_;
    config::Problems problems_;
    std::map<std::uint32_t, std::vector<forest::PatchId>> patches_;
};

config::Table table_with(const std::string& setting, const std::string& role, const std::string& name,
                         const std::vector<std::string>& columns, Reading& reading) {
    config::Table table = reading.table(setting, role, name);
    config::Problems problems;
    table.require(columns, problems);
    problems.throw_if_any();
    return table;
}

void fill_dead_wood(StandTable<forest::DeadWoodRecord>& rows, std::size_t row,
                    forest::DeadWoodRecord& record) {
    const config::Table& table = rows.table();
    const std::string& kind = table.text(row, "kind");
    if (kind == "snag" || kind == "stump" || kind == "log") {
        record.kind = kind == "snag"    ? forest::DeadWoodKind::snag
                      : kind == "stump" ? forest::DeadWoodKind::stump
                                        : forest::DeadWoodKind::log;
    } else {
        rows.problems().add(ExitCode::data, table.place(row, "kind"),
                            joined("kind ", config::in_quotes(kind)), "snag, stump or log");
    }
    record.volume_m3pha =
        table.number(row, "volume_m3pha", {.low = 0.0, .high = 3000.0, .low_excluded = true}, rows.problems())
            .value_or(1.0);
    record.dbh_cm = rows.optional(row, "dbh_cm", {7.0, 200.0}).value_or(record.dbh_cm);
    record.length_m = rows.optional(row, "length_m", {.low = 0.0, .high = 80.0, .low_excluded = true});
    if (!record.length_m && record.kind == forest::DeadWoodKind::stump) {
        constexpr double usual_stump_m = 0.3;
        record.length_m = usual_stump_m;
    }
    if (rows.has(row, "decay_class")) {
        record.decay_class =
            static_cast<int>(table.whole(row, "decay_class", {1.0, 5.0}, rows.problems()).value_or(1));
    }
    record.to_fall_line_deg = rows.optional(row, "log_angle_deg", {0.0, 90.0});
    if (record.to_fall_line_deg && record.kind != forest::DeadWoodKind::log) {
        rows.problems().add(ExitCode::data, table.place(row, "log_angle_deg"),
                            joined("log_angle_deg of a ", kind), "an angle of logs alone");
    }
    if (rows.has(row, "anchored")) {
        const auto anchored = config::flag_in(table.text(row, "anchored"));
        if (!anchored) {
            rows.problems().add(ExitCode::data, table.place(row, "anchored"),
                                joined("anchored ", config::in_quotes(table.text(row, "anchored"))),
                                "yes or no");
        }
        record.anchored = anchored.value_or(false);
    }
}

/// The middle of a class of heights such as 40-130, in centimetres; a problem if it is none.
std::optional<double> middle_of_class_m(StandTable<forest::SaplingRecord>& rows, std::size_t row) {
    const std::string& text = rows.table().text(row, "height_class");
    const std::size_t dash = text.find('-');
    const auto from = config::parse_number(text.substr(0, dash));
    const auto to = dash == std::string::npos ? std::nullopt : config::parse_number(text.substr(dash + 1));
    const bool in_order = from && to && *from >= 0.0 && *from < *to;
    if (!in_order || *from + *to > 2.0 * cm_pm * highest_sapling_m) {
        rows.problems().add(
            ExitCode::data, rows.table().place(row, "height_class"),
            joined("height_class ", config::in_quotes(text)),
            "lower and upper height in cm, such as 10-40 or 40-130, with a middle of at most 190",
            "enter taller young trees by diameter (stands.dbh_classes or stands.records)");
        return std::nullopt;
    }
    return (*from + *to) / 2.0 / cm_pm;
}

std::optional<double> sapling_height_m(StandTable<forest::SaplingRecord>& rows, std::size_t row) {
    const bool by_class = rows.has(row, "height_class");
    if (by_class == rows.has(row, "height_m")) {
        rows.problems().add(ExitCode::data, rows.table().place(row, "stand"),
                            by_class ? "height_m and height_class" : "neither height_m nor height_class",
                            "one of the two in each row", "delete or fill in one of them");
        return std::nullopt;
    }
    return by_class ? middle_of_class_m(rows, row)
                    : rows.optional(row, "height_m",
                                    {.low = 0.0, .high = highest_sapling_m, .low_excluded = true});
}

void fill_sapling(StandTable<forest::SaplingRecord>& rows, std::size_t row, forest::SaplingRecord& record) {
    const config::Table& table = rows.table();
    record.stems_pha =
        table.number(row, "stems_pha", {.low = 0.0, .high = 1e6, .low_excluded = true}, rows.problems())
            .value_or(1.0);
    record.height_m = sapling_height_m(rows, row).value_or(1.0);
    record.browsed_percent = rows.optional(row, "browsed_percent", {0.0, 100.0});
    if (rows.has(row, "age_years")) {
        record.age_years =
            static_cast<int>(table.whole(row, "age_years", {0.0, 300.0}, rows.problems()).value_or(0));
    }
}

}  // namespace

std::optional<StartingWood> read_starting_wood(const ForestSpecies& species, const forest::PatchGrid& grid,
                                               Reading& reading) {
    const ForestSettings& settings = reading.scenario().forest;
    return reading.attempt([&] {
        const SpeciesLookup lookup = species.lookup();
        StartingWood wood;
        if (!settings.dead_wood.empty()) {
            const config::Table table = table_with("stands.dead_wood", "dead_wood", settings.dead_wood,
                                                   {"stand", "species", "kind", "volume_m3pha"}, reading);
            warn_of_columns(table,
                            {"stand", "species", "kind", "volume_m3pha", "dbh_cm", "length_m", "decay_class",
                             "log_angle_deg", "anchored"},
                            reading);
            StandTable<forest::DeadWoodRecord> rows{table, species, lookup, grid};
            wood.dead_wood = rows.read(reading, [&](std::size_t row, forest::DeadWoodRecord& record) {
                fill_dead_wood(rows, row, record);
            });
        }
        if (!settings.saplings.empty()) {
            const config::Table table = table_with("stands.saplings", "saplings", settings.saplings,
                                                   {"stand", "species", "stems_pha"}, reading);
            warn_of_columns(table,
                            {"stand", "species", "stems_pha", "height_class", "height_m", "browsed_percent"},
                            reading);
            StandTable<forest::SaplingRecord> rows{table, species, lookup, grid};
            wood.saplings = rows.read(reading, [&](std::size_t row, forest::SaplingRecord& record) {
                fill_sapling(rows, row, record);
            });
            note_browsing(wood.saplings, species, reading);
        }
        return wood;
    });
}

}  // namespace coupling
