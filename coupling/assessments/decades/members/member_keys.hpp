#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/members/year_blocks.hpp"

namespace coupling::decades {

/// Names members, and falls over the bare slope, by all that they depend on: a study that gets more
/// replicates, regimes or climates finds those again that it has. The same key, the same bytes.
///
/// A member depends on the program, on the settings and inputs that all members share, on the files of its
/// own regime, on the places of targets, and on the weather of its own climate and replicate in its years. It
/// does not depend on how many replicates, and on which other regimes and climates, a run compares, nor on
/// what is asked of the result ([decision], [risk], [report]). The first years of a member are those of a
/// longer run: of how many years it is stands beside the key, and which lists and maps it has in its part
/// (kept_member.hpp). Only a spin-up of more years than the run has takes the weather of the run over and
/// over; then its length counts.
class MemberKeys {
public:
    /// `site`: with the inputs of the scenario alone, not yet with those of `management`. Refers to
    /// `scenario` and `site`.
    MemberKeys(const Scenario& scenario, const Site& site, const Management& management);

    /// 32 hexadecimal digits: the member with all years of the run. From any thread.
    [[nodiscard]] std::string of(const Member& member) const;
    /// The member with its first years. Requires years <= run.years.
    [[nodiscard]] std::string of(const Member& member, std::int32_t years) const;
    /// Depends on which years are in the block, and which of them have cells.
    [[nodiscard]] std::string of_bare(std::uint32_t replicate, std::size_t block) const;
    [[nodiscard]] const Scenario& scenario() const { return scenario_; }

private:
    /// Key of the weather of a climate in the first years of a replicate.
    [[nodiscard]] std::string weather_of(std::uint32_t climate, std::uint32_t replicate,
                                         std::int32_t years) const;

    const Scenario& scenario_;
    const ForestSite& forest_;
    YearBlocks blocks_;
    std::vector<std::string> regimes_;
    std::string shared_;
    mutable std::mutex mutex_;
    /// By climate and replicate: keys of the first 0, 1, 2 ... years.
    mutable std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::string>> weather_;
};

}  // namespace coupling::decades
