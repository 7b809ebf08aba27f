#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// The target profile for the scenario's rocks: for a block of their mean diameter [choice]. Nothing if that
/// is larger than any that NaiS speaks of.
std::optional<forest::TargetProfile> profile_for(const Scenario& scenario, const Site& site);

/// A stand (a management unit, or the whole forest as `all`) at the end of a year.
struct StandCheck {
    std::int32_t year = 0;
    std::uint32_t unit = all;
    forest::GapFigures gaps;
    forest::ProfileCheck check;
};
/// All stands of a member in all years.
std::vector<StandCheck> checks_of(const MemberYears& member, const forest::TargetProfile& profile);

/// Share of the forest in stands that meet the profile, by year [0, 1]; without units the forest is one
/// stand.
std::map<std::int32_t, double> share_met(const MemberYears& member, const forest::TargetProfile& profile);

/// Writes tables/gaps.csv and, where there is a profile, tables/target_profile.csv. Throws config::InputError
/// (file).
std::vector<WrittenFile> write_profile_tables(const std::filesystem::path& folder, const Names& names,
                                              std::span<const MemberYears> members,
                                              const std::optional<forest::TargetProfile>& profile);
std::vector<TableLayout> profile_layouts();

}  // namespace coupling::decades
