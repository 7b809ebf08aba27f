#include "coupling/assessments/decades/tables/yearly_work.hpp"

#include <cassert>

#include "coupling/exchange/regimes/intervention.hpp"

namespace coupling::decades {

YearlyWork& YearlyWork::operator+=(const YearlyWork& other) {
    felled_m3pha += other.felled_m3pha;
    salvaged_m3pha += other.salvaged_m3pha;
    removed_m3pha += other.removed_m3pha;
    left_m3pha += other.left_m3pha;
    revenue_eur_pha += other.revenue_eur_pha;
    harvest_cost_eur_pha += other.harvest_cost_eur_pha;
    young_cost_eur_pha += other.young_cost_eur_pha;
    fixed_cost_eur_pha += other.fixed_cost_eur_pha;
    machine_hours_pha += other.machine_hours_pha;
    cable_setups += other.cable_setups;
    standing_value_eur_pha += other.standing_value_eur_pha;
    return *this;
}

std::vector<YearlyWork> work_by_year(const Names& names, const MemberYears& member, double area_ha) {
    assert(area_ha > 0.0);
    static const std::string salvage = name_of(Treatment::salvage);
    std::vector<YearlyWork> years(member.years.size());
    for (const HarvestRow& row : member.harvest) {
        YearlyWork& work = years[static_cast<std::size_t>(row.year)];
        const std::string& treatment = names.interventions[member.member.regime][row.intervention].second;
        (treatment == salvage ? work.salvaged_m3pha : work.felled_m3pha) +=
            (row.taken_m3 + row.left_m3) / area_ha;
        work.removed_m3pha += row.taken_m3 / area_ha;
        work.left_m3pha += row.left_m3 / area_ha;
    }
    for (std::size_t year = 0; year < years.size(); ++year) {
        years[year].standing_value_eur_pha = member.years[year].standing_value_eur / area_ha;
    }
    for (const MarginRow& row : member.margins) {
        YearlyWork& work = years[static_cast<std::size_t>(row.year)];
        work.revenue_eur_pha += row.margin.revenue_eur / area_ha;
        work.harvest_cost_eur_pha += row.margin.harvest_eur / area_ha;
        work.young_cost_eur_pha += row.margin.young_eur / area_ha;
        work.fixed_cost_eur_pha += row.margin.fixed_eur / area_ha;
        work.machine_hours_pha += row.machine_hours / area_ha;
        work.cable_setups += row.cable_setups;
    }
    return years;
}

const std::vector<WorkFigure>& work_figures() {
    static const std::vector<WorkFigure> figures{
        {"felled_m3pha", [](const YearlyWork& work) { return work.felled_m3pha; }},
        {"salvaged_m3pha", [](const YearlyWork& work) { return work.salvaged_m3pha; }},
        {"removed_m3pha", [](const YearlyWork& work) { return work.removed_m3pha; }},
        {"left_m3pha", [](const YearlyWork& work) { return work.left_m3pha; }},
        {"contribution_margin_eur_pha", [](const YearlyWork& work) { return work.margin_eur_pha(); }},
        {"machine_hours_pha", [](const YearlyWork& work) { return work.machine_hours_pha; }},
        {"cable_setups", [](const YearlyWork& work) { return work.cable_setups; }},
        {"standing_value_eur_pha", [](const YearlyWork& work) { return work.standing_value_eur_pha; }}};
    return figures;
}

}  // namespace coupling::decades
