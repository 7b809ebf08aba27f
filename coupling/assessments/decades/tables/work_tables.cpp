#include "coupling/assessments/decades/tables/work_tables.hpp"

#include <algorithm>
#include <utility>

#include "coupling/assessments/decades/tables/member_columns.hpp"
#include "coupling/assessments/decades/tables/yearly_work.hpp"

namespace coupling::decades {
namespace {

MemberTable<HarvestRow> interventions() {
    using Row = MemberRow<HarvestRow>;
    constexpr const char* given = "input regimes.list";
    const auto row_of_regime = [](const Row& row) {
        return &row.names.interventions[row.names.regime_of(row.course)][row.intervention];
    };
    using NameAndTreatment = std::pair<std::string, std::string>;
    return {"interventions.csv",
            "What people did each year, and what was due but found nothing to do.",
            "an intervention that was due",
            {member_columns<HarvestRow>(),
             {ColumnsOf<NameAndTreatment>{
                  {"intervention", "name of the row of the regime", given, &NameAndTreatment::first},
                  {"treatment", "kind of treatment", given, &NameAndTreatment::second}},
              row_of_regime},

             {"areas", "areas that it came to", &HarvestRow::areas},
             {"area_ha", 4, "their area; of a group cut that of the holes", &HarvestRow::area_ha},
             {"stems", 0, "stems felled, of salvage taken, in the whole forest", &HarvestRow::stems},
             {"taken_m3", 3, "stem wood over bark that left the forest", &HarvestRow::taken_m3},
             {"left_m3", 3, "stem wood that stayed as logs and stumps", &HarvestRow::left_m3},
             {"plants", "trees planted", &HarvestRow::plants},
             {"guarded", "of these, with a guard each", &HarvestRow::guarded},
             {"tended", "young stems cut by tending", &HarvestRow::tended},
             {"fenced_ha", 4, "area that is fenced longer than before", &HarvestRow::fenced_ha},
             {"found_nothing", "yes: it was due but found nothing to do", &HarvestRow::found_nothing}}};
}

MemberTable<TimberRow> timber() {
    using Class = forest::TimberClass;
    return {"timber.csv",
            "Felled wood by species and diameter class: taken and left.",
            "a species and diameter class that was felled in a year",
            {member_columns<TimberRow>(),
             species_column<TimberRow>(),
             dbh_class_columns<TimberRow>(),
             {ColumnsOf<Class>{
                  {"stems", 0, "stems felled, in the whole forest", &Class::stems},
                  {"taken_m3", 3, "their stem wood over bark that left the forest", &Class::taken_m3},
                  {"left_m3", 3, "their stem wood that stayed as logs and stumps", &Class::left_m3}},
              &TimberRow::timber}}};
}

/// The work of a year per hectare.
struct WorkRow : YearlyWork {
    std::int32_t year;
};

ColumnsOf<YearlyWork> money_columns() {
    constexpr const char* from_work_and_prices =
        "simulated work, prices of regimes.timber_prices and regimes.work_costs";
    return {{"revenue_eur_pha", 2, "revenue of the wood sold", from_work_and_prices,
             &YearlyWork::revenue_eur_pha},
            {"harvest_cost_eur_pha", 2, "cost of felling and hauling", from_work_and_prices,
             &YearlyWork::harvest_cost_eur_pha},
            {"young_growth_cost_eur_pha", 2, "cost of planting, tending and fencing", from_work_and_prices,
             &YearlyWork::young_cost_eur_pha},
            {"fixed_cost_eur_pha", 2, "cost of entries and cable lines, where regimes.work_costs has it",
             from_work_and_prices, &YearlyWork::fixed_cost_eur_pha},
            {"contribution_margin_eur_pha", 2, "revenue less these costs, without overhead",
             from_work_and_prices, &YearlyWork::margin_eur_pha}};
}

MemberTable<WorkRow> margins() {
    return {"margins.csv",
            "Revenue, costs and contribution margin of each year with work, per hectare.",
            "a year with work",
            {member_columns<WorkRow>(), money_columns()}};
}

MemberTable<WorkRow> work_table() {
    return {"work_by_year.csv",
            "Wood felled, salvaged, removed and left, revenue and costs of each year, per hectare.",
            "a year, also one without work; per hectare of the whole forest",
            {member_columns<WorkRow>(),

             {"felled_m3pha", 4, "stem wood of living trees that were cut, taken or left",
              &YearlyWork::felled_m3pha},
             {"salvaged_m3pha", 4, "stem wood of dead trees that salvage worked up, taken or left",
              &YearlyWork::salvaged_m3pha},
             {"removed_m3pha", 4, "stem wood that left the forest; felled + salvaged = removed + left",
              &YearlyWork::removed_m3pha},
             {"left_m3pha", 4, "felled or salvaged stem wood that stayed as logs and stumps",
              &YearlyWork::left_m3pha},
             money_columns(),

             {"machine_hours_pha", 3, "to bring the removed wood out", "input regimes.machine_m3_per_hour",
              &YearlyWork::machine_hours_pha},
             {"cable_setups", 0, "corridors in the whole forest from which timber was taken",
              &YearlyWork::cable_setups},
             {"standing_value_eur_pha", 2,
              "what the trees that stand at the end of the year would bring if they were felled and hauled; "
              "classes that do not pay for it count as 0",
              "prices of regimes.timber_prices", &YearlyWork::standing_value_eur_pha}}};
}

MemberTable<RemovedRow> removed_trees() {
    return {
        "removed_trees.csv",
        "Trees of 7 cm and more that left the forest, each with its cause: those that rocks broke or "
        "uprooted (rock) or that died of old wounds (wound); on demand all.",
        "a tree of 7 cm and more that rocks or old wounds took, or any cause with output.all_removed_trees",
        {member_columns<RemovedRow>(),
         tree_columns<RemovedRow>(),
         {"reason",
          "rock: broken or uprooted by a rock; wound: died of an old wound; others as in mortality.csv",
          [](const auto& row) { return forest::name_of(row.cause); }}}};
}

template <class Row>
bool any(std::span<const MemberYears> members, std::vector<Row> MemberYears::*rows) {
    return std::any_of(members.begin(), members.end(),
                       [&](const MemberYears& member) { return !(member.*rows).empty(); });
}

}  // namespace

std::vector<TableLayout> work_layouts() {
    return {interventions(), timber(), margins(), work_table(), removed_trees()};
}

std::vector<WrittenFile> write_work_tables(const std::filesystem::path& folder, const Names& names,
                                           std::span<const MemberYears> members, double area_ha) {
    std::vector<WrittenFile> written;
    if (any(members, &MemberYears::harvest)) {
        const auto of_margins = [&](const MemberYears& member, const auto& add) {
            for (const MarginRow& year : member.margins) {
                add(WorkRow{{.revenue_eur_pha = year.margin.revenue_eur / area_ha,
                             .harvest_cost_eur_pha = year.margin.harvest_eur / area_ha,
                             .young_cost_eur_pha = year.margin.young_eur / area_ha,
                             .fixed_cost_eur_pha = year.margin.fixed_eur / area_ha},
                            year.year});
            }
        };
        written = {interventions().write(folder, member_rows(names, members, &MemberYears::harvest)),
                   timber().write(folder, member_rows(names, members, &MemberYears::timber)),
                   margins().write(folder, member_rows(names, members, of_margins))};
    }
    const auto of_work = [&](const MemberYears& member, const auto& add) {
        std::int32_t year = 0;
        for (const YearlyWork& work : work_by_year(names, member, area_ha)) {
            add(WorkRow{work, year++});
        }
    };
    written.push_back(work_table().write(folder, member_rows(names, members, of_work)));
    if (any(members, &MemberYears::removed)) {
        written.push_back(removed_trees().write(folder, member_rows(names, members, &MemberYears::removed)));
    }
    return written;
}

}  // namespace coupling::decades
