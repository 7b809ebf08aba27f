#include "coupling/inputs/forest/start_input.hpp"

#include <map>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/forest/browsing_note.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"

namespace coupling {

/// A number of a stand or `all`, beside what is recorded there.
struct DeadWoodRow : forest::DeadWoodRecord {
    std::string stand;
};
struct SaplingRow : forest::SaplingRecord {
    std::string stand;
    std::optional<double> mean_height_m;
    std::string height_class;
};

namespace {

using config::joined;

/// Above, young trees are trees: they belong into the records of the stand.
constexpr double highest_sapling_m = 1.9;
constexpr double cm_pm = 100.0;

/// Patches by stand number; those of the whole forest under 0.
std::map<std::uint32_t, std::vector<forest::PatchId>> patches_by_stand(const forest::PatchGrid& grid) {
    std::map<std::uint32_t, std::vector<forest::PatchId>> patches;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        patches[grid.patches()[i].management_unit].push_back(forest::PatchId{i});
        patches[0].push_back(forest::PatchId{i});
    }
    return patches;
}

/// What the two tables share: each record belongs to a stand and a species.
template <class Record, class Row, class Check>
std::vector<forest::OnPatches<Record>> read_by_stand(const config::Schema<Row>& columns,
                                                     const std::string& file, const ForestSpecies& species,
                                                     const forest::PatchGrid& grid, Reading& reading,
                                                     Check check) {
    const config::Table table = table_of(columns, file, reading);
    config::RowProblems wrong{table};
    const SpeciesColumn column{table, species.lookup(), wrong};
    const auto patches = patches_by_stand(grid);
    std::map<std::uint32_t, forest::OnPatches<Record>> stands;
    StandsOffTheMap off;
    for (config::Read<Row>& row : columns.rows(table, wrong)) {
        check(row, wrong);
        const auto stand = stand_called(row.stand, row.row, patches, table, wrong, off);
        const auto kind = column.find(row.row);
        row.species = forest::SpeciesId{static_cast<std::uint16_t>(kind.value_or(0))};
        if (stand) {
            stands[*stand].records.push_back(row);
        }
    }
    wrong.throw_first();
    off.report(table.file(), stands.size(), reading);
    warn_of_stand_ins(column, species, table.file(), reading);
    std::vector<forest::OnPatches<Record>> all;
    for (auto& [number, stand] : stands) {
        stand.patches = patches.at(number);
        all.push_back(std::move(stand));
    }
    return all;
}

void check_dead_wood(config::Read<DeadWoodRow>& row, config::RowProblems& wrong) {
    constexpr double usual_stump_m = 0.3;
    if (!row.length_m && row.kind == forest::DeadWoodKind::stump) {
        row.length_m = usual_stump_m;
    }
    if (row.to_fall_line_deg && row.kind != forest::DeadWoodKind::log) {
        wrong.refuse(row.row, "log_angle_deg",
                     joined("log_angle_deg of a ", row.kind == forest::DeadWoodKind::snag ? "snag" : "stump"),
                     "an angle of logs alone");
    }
}

/// The middle of a class of heights such as 40-130, in centimetres; nothing if it is none.
std::optional<double> middle_of_class_m(const std::string& text) {
    const std::size_t dash = text.find('-');
    const auto from = config::parse_number(text.substr(0, dash));
    const auto to = dash == std::string::npos ? std::nullopt : config::parse_number(text.substr(dash + 1));
    const bool in_order = from && to && *from >= 0.0 && *from < *to;
    return in_order && *from + *to <= 2.0 * cm_pm * highest_sapling_m
               ? std::optional{(*from + *to) / 2.0 / cm_pm}
               : std::nullopt;
}

void check_saplings(config::Read<SaplingRow>& row, config::RowProblems& wrong) {
    const bool by_class = !row.height_class.empty();
    if (by_class == row.mean_height_m.has_value()) {
        wrong.refuse(row.row, "stand",
                     by_class ? "height_m and height_class" : "neither height_m nor height_class",
                     "one of the two in each row", "delete or fill in one of them");
        return;
    }
    const auto height_m = by_class ? middle_of_class_m(row.height_class) : row.mean_height_m;
    if (!height_m) {
        wrong.refuse(row.row, "height_class", joined("height_class ", config::in_quotes(row.height_class)),
                     "lower and upper height in cm, such as 10-40 or 40-130, with a middle of at most 190",
                     "enter taller young trees by diameter (stands.dbh_classes or stands.records)");
    }
    row.height_m = height_m.value_or(row.height_m);
}

}  // namespace

const config::Schema<DeadWoodRow>& dead_wood_columns() {
    using config::above;
    using R = DeadWoodRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "dead_wood", .setting = "stands.dead_wood", .row = "record"},
        {{"stand", &R::stand, "its number on the map, or all", {.may_be_empty = true}},
         {"species", "code or name"},
         {"kind", &R::kind, "what it is", {.words = {"snag", "stump", "log"}}},
         {"volume_m3pha", &R::volume_m3pha, "stem wood over bark", {.range = {0.0, 3000.0, above}}},
         {"dbh_cm", &R::dbh_cm, "of the trees they were; empty: 30", {.range = {7.0, 200.0}, .optional = true}},
         {"length_m", &R::length_m, "of a log, or height of what stands; empty: the whole tree, of stumps 0.3", {.range = {0.0, 80.0, above}}},
         {"decay_class", &R::decay_class, "1 fresh to 5; empty: 1", {.range = {1.0, 5.0}, .optional = true}},
         {"log_angle_deg", &R::to_fall_line_deg, "of logs to the fall line", {.range = {0.0, 90.0}}},
         {"anchored", &R::anchored, "logs behind stumps; empty: no", {.optional = true}}}};
    // clang-format on
    return columns;
}

const config::Schema<SaplingRow>& sapling_columns() {
    using config::above;
    using R = SaplingRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "saplings", .setting = "stands.saplings", .row = "record"},
        {{"stand", &R::stand, "its number on the map, or all", {.may_be_empty = true}},
         {"species", "code or name"},
         {"stems_pha", &R::stems_pha, "below 1 cm", {.range = {0.0, 1e6, above}}},
         {"height_class", &R::height_class, "lower and upper height in cm, such as 10-40; the stems stand at its middle", {.unit = "cm", .optional = true}},
         {"height_m", &R::mean_height_m, "instead: mean height", {.range = {0.0, highest_sapling_m, above}}},
         {"age_years", &R::age_years, "mean; empty: 3", {.range = {0.0, 300.0}, .optional = true}},
         {"browsed_percent", &R::browsed_percent, "stems browsed in a year: compared with the model in a note", {.range = {0.0, 100.0}}}}};
    // clang-format on
    return columns;
}

std::optional<StartingWood> read_starting_wood(const ForestSpecies& species, const forest::PatchGrid& grid,
                                               Reading& reading) {
    const ForestSettings& settings = reading.forest();
    return reading.attempt([&] {
        StartingWood wood;
        if (!settings.dead_wood.empty()) {
            wood.dead_wood = read_by_stand<forest::DeadWoodRecord>(dead_wood_columns(), settings.dead_wood,
                                                                   species, grid, reading, check_dead_wood);
        }
        if (!settings.saplings.empty()) {
            wood.saplings = read_by_stand<forest::SaplingRecord>(sapling_columns(), settings.saplings,
                                                                 species, grid, reading, check_saplings);
            note_browsing(wood.saplings, species, reading);
        }
        return wood;
    });
}

}  // namespace coupling
