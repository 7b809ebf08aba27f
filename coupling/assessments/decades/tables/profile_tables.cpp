#include "coupling/assessments/decades/tables/profile_tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {
namespace {

using config::joined;

MemberTable<GapRow> gaps() {
    using Figures = forest::GapFigures;
    constexpr const char* measured = "simulated, on patches of 10 m";
    return {"gaps.csv",
            "Gaps along the fall line each year, by stand: how many and how long.",
            "a stand, or all, at the end of a year",
            {member_columns<GapRow>(),
             unit_column<GapRow>(),
             {ColumnsOf<Figures>{
                  {"area_ha", 2, "area of the stand on the map", "input stands.map",
                   [](const auto& f) { return f.patches * forest::patch_area_m2 / 10'000.0; }},
                  {"open_percent", 2, "of the area on patches without a living stem of 12 cm", measured,
                   [](const auto& f) { return 100.0 * f.open_patches / std::max(f.patches, 1U); }},
                  {"gaps", "lines of open patches down the fall line that touch the stand", measured,
                   &Figures::gaps},
                  {"gap_mean_m", 1, "their mean length along the ground; 0 without gaps", measured,
                   &Figures::mean_m},
                  {"gap_95_m", 1, "95th percentile of their lengths, linearly interpolated", measured,
                   &Figures::p95_m},
                  {"gap_max_m", 1, "the longest of them", measured, &Figures::max_m}},
              &GapRow::figures}}};
}

/// A criterion of the target profile for a stand in a year.
struct Criterion {
    std::int32_t year;
    std::uint32_t unit;
    std::string name;
    double value;
    const char* of_unit;
    std::optional<double> at_least;
    std::optional<double> at_most;
    bool met;
    std::optional<bool> ideal;
};

MemberTable<Criterion> target_profile() {
    constexpr const char* guideline = "NaiS (Frehner et al. 2005), for the mean diameter of the rocks";
    return {"target_profile.csv",
            "Each stand in each year against the target profile for the scenario's rocks: stems and gaps.",
            "a criterion for a stand, or all, at the end of a year with a profile",
            {member_columns<Criterion>(),
             unit_column<Criterion>(),

             {"criterion", "stems_from_N_cm: stems of N cm and more; longest_gap: along the fall line",
              guideline, &Criterion::name},
             {"value", "as the unit says", 1, "what the stand has", from_simulation, &Criterion::value},
             {"unit", "of value and limits", "definition", &Criterion::of_unit},
             {"at_least", "as the unit says", 0, "least value; empty: none", guideline, &Criterion::at_least},
             {"at_most", "as the unit says", 0, "largest value; empty: none", guideline, &Criterion::at_most},
             {"met", "yes or no", &Criterion::met},
             {"ideal", "yes or no: whether the ideal number of stems is there; empty for gaps",
              &Criterion::ideal}}};
}

}  // namespace

std::optional<forest::TargetProfile> profile_for(const Scenario& scenario, const Site& site) {
    return forest::target_profile(rockfall::diameter_range(start_law(scenario.release), site.sources).mean_m);
}

std::vector<StandCheck> checks_of(const MemberYears& member, const forest::TargetProfile& profile) {
    std::map<std::pair<std::int32_t, std::uint32_t>, const forest::StandFigures*> stands;
    for (const StandRow& stand : member.stands) {
        if (stand.species == all) {
            stands[{stand.year, stand.unit}] = &stand.figures;
        }
    }
    std::vector<StandCheck> checks;
    for (const GapRow& gap : member.gaps) {
        checks.push_back({gap.year, gap.unit, gap.figures,
                          forest::check(profile, *stands.at({gap.year, gap.unit}), gap.figures)});
    }
    return checks;
}

std::map<std::int32_t, double> share_met(const MemberYears& member, const forest::TargetProfile& profile) {
    struct Patches {
        double whole = 0.0;  ///< of the forest
        double whole_met = 0.0;
        double units = 0.0;
        double units_met = 0.0;
    };
    std::map<std::int32_t, Patches> years;
    for (const StandCheck& stand : checks_of(member, profile)) {
        Patches& year = years[stand.year];
        const double met = stand.check.met() ? stand.gaps.patches : 0.0;
        (stand.unit == all ? year.whole : year.units) += stand.gaps.patches;
        (stand.unit == all ? year.whole_met : year.units_met) += met;
    }
    std::map<std::int32_t, double> shares;
    for (const auto& [year, patches] : years) {
        shares[year] =
            patches.units > 0.0 ? patches.units_met / patches.units : patches.whole_met / patches.whole;
    }
    return shares;
}

std::vector<TableLayout> profile_layouts() {
    return {gaps(), target_profile()};
}

std::vector<WrittenFile> write_profile_tables(const std::filesystem::path& folder, const Names& names,
                                              std::span<const MemberYears> members,
                                              const std::optional<forest::TargetProfile>& profile) {
    std::vector<WrittenFile> written{gaps().write(folder, member_rows(names, members, &MemberYears::gaps))};
    if (profile) {
        const std::string stems =
            joined("stems_from_", std::to_string(std::lround(profile->dbh_from_cm)), "_cm");
        const auto criteria = [&](const MemberYears& member, const auto& add) {
            for (const auto& [year, unit, found, check] : checks_of(member, *profile)) {
                add(Criterion{year, unit, stems, check.stems_pha, "1/ha", profile->least_stems_pha,
                              std::nullopt, check.has_stems, check.has_ideal_stems});
                add(Criterion{year, unit, "longest_gap", check.gap_m, "m", std::nullopt,
                              profile->longest_gap_m, check.has_short_gaps, std::nullopt});
            }
        };
        written.push_back(target_profile().write(folder, member_rows(names, members, criteria)));
    }
    return written;
}

}  // namespace coupling::decades
