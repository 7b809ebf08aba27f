#include "coupling/decades/record_work.hpp"

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
                 std::int32_t year, MemberYears& kept) {
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
    }
    for (std::uint32_t s = 0; s < report.timber.by_species.size(); ++s) {
        for (std::uint32_t c = 0; c < forest::dbh_classes; ++c) {
            const forest::TimberClass& timber = report.timber.by_species[s][c];
            if (timber.stems > 0.0) {
                kept.timber.push_back({year, s, c, timber});
            }
        }
    }
    kept.margins.push_back({year, contribution_margin(report, prices)});
}

}  // namespace coupling::decades
