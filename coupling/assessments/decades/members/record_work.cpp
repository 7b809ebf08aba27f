#include "coupling/assessments/decades/members/record_work.hpp"

#include <algorithm>

namespace coupling::decades {
namespace {

std::uint32_t row_of(const Regime& regime, const std::string& name) {
    const auto& rows = regime.interventions();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Intervention& row) { return row.name == name; });
    return static_cast<std::uint32_t>(found - rows.begin());
}

}  // namespace

void record_work(const RegimeReport& report, const Regime& regime, const PriceTable& prices,
                 double machine_m3ph, std::int32_t year, MemberYears& kept) {
    if (report.entries.empty()) {
        return;
    }
    for (const Entry& entry : report.entries) {
        kept.harvest.push_back({.year = year,
                                .intervention = row_of(regime, entry.intervention),
                                .areas = static_cast<std::uint32_t>(entry.areas),
                                .found_nothing = entry.found_nothing(),
                                .area_ha = entry.area_ha,
                                .stems = entry.stems,
                                .taken_m3 = entry.taken_m3,
                                .left_m3 = entry.left_m3,
                                .plants = entry.plants,
                                .guarded = entry.guarded,
                                .tended = entry.tended,
                                .fenced_ha = entry.fenced_ha});
        for (const forest::PatchId patch : entry.cut_patches) {
            if (kept.member.replicate == 0) {
                kept.cut_patches.push_back(
                    {year, kept.harvest.back().intervention, static_cast<std::uint32_t>(index_of(patch))});
            }
        }
    }
    for (std::uint32_t s = 0; s < report.timber.by_species.size(); ++s) {
        for (std::uint32_t c = 0; c < forest::dbh_classes; ++c) {
            const forest::TimberClass& timber = report.timber.by_species[s][c];
            if (timber.stems > 0.0) {
                kept.timber.push_back({year, s, c, timber});
            }
        }
    }
    MarginRow work;
    work.year = year;
    for (const Entry& entry : report.entries) {
        work.machine_hours += entry.taken_m3 / machine_m3ph;
        const Intervention& row = regime.interventions()[row_of(regime, entry.intervention)];
        const bool is_setup = row.ground.where == Where::corridors && entry.taken_m3 > 0.0;
        work.cable_setups += is_setup ? static_cast<double>(entry.areas) : 0.0;
    }
    work.margin = contribution_margin(report, prices, work.cable_setups);
    kept.margins.push_back(work);
}

}  // namespace coupling::decades
