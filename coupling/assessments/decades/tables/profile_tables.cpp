#include "coupling/assessments/decades/tables/profile_tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/yearly_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling::decades {
namespace {

using config::joined;

void write_gaps(std::ostream& out, const Names& names, std::span<const MemberYears> members) {
    TableRows row{out, yearly_layouts(), "gaps.csv"};
    for (const MemberYears& member : members) {
        for (const GapRow& gap : member.gaps) {
            begin_row(row, names, member.member, gap.year);
            add_unit(row, gap.unit);
            const forest::GapFigures& f = gap.figures;
            row.number<2>(f.patches * forest::patch_area_m2 / 10'000.0);
            row.number<2>(100.0 * f.open_patches / std::max(f.patches, 1U)).whole(f.gaps);
            row.number<1>(f.mean_m).number<1>(f.p95_m).number<1>(f.max_m);
            row.end();
        }
    }
}

void write_checks(std::ostream& out, const Names& names, std::span<const MemberYears> members,
                  const forest::TargetProfile& profile) {
    TableRows row{out, yearly_layouts(), "target_profile.csv"};
    const std::string stems = joined("stems_from_", std::to_string(std::lround(profile.dbh_from_cm)), "_cm");
    for (const MemberYears& member : members) {
        for (const StandCheck& stand : checks_of(member, profile)) {
            const auto begin = [&](const std::string& criterion) {
                begin_row(row, names, member.member, stand.year);
                add_unit(row, stand.unit);
                row.text(criterion);
            };
            begin(stems);
            row.number<1>(stand.check.stems_pha).text("1/ha").number<0>(profile.least_stems_pha).empty();
            row.text(stand.check.has_stems ? "yes" : "no").text(stand.check.has_ideal_stems ? "yes" : "no");
            row.end();
            begin("longest_gap");
            row.number<1>(stand.check.gap_m).text("m").empty().number<0>(profile.longest_gap_m);
            row.text(stand.check.has_short_gaps ? "yes" : "no").empty();
            row.end();
        }
    }
}

}  // namespace

std::optional<forest::TargetProfile> profile_for(const Scenario& scenario, const Site& site) {
    return forest::target_profile(rockfall::diameter_range(start_law(scenario), site.sources).mean_m);
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

std::vector<WrittenFile> write_profile_tables(const std::filesystem::path& folder, const Names& names,
                                              std::span<const MemberYears> members,
                                              const std::optional<forest::TargetProfile>& profile) {
    std::vector<WrittenFile> written;
    written.push_back(write_table(folder, "gaps.csv",
                                  "Gaps along the fall line each year, by stand: how many and how long.",
                                  [&](std::ostream& out) { write_gaps(out, names, members); }));
    if (profile) {
        written.push_back(write_table(
            folder, "target_profile.csv",
            "Each stand in each year against the target profile for the scenario's rocks: stems and gaps.",
            [&](std::ostream& out) { write_checks(out, names, members, *profile); }));
    }
    return written;
}

}  // namespace coupling::decades
