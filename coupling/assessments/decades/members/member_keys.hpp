#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/records.hpp"

namespace coupling::decades {

/// Names members, and falls over the bare slope, by all that they depend on: a study that gets more
/// replicates, regimes or climates finds those again that it has. The same key, the same bytes.
///
/// A member depends on the program, on the settings and inputs that all members share, on the files of its
/// own regime, on the places of targets, and on the weather of its own climate and replicate. It does not
/// depend on how many replicates, and on which other regimes and climates, a run compares, nor on what is
/// asked of the result
/// ([decision], [risk], [report]).
class MemberKeys {
public:
    /// `site`: with the inputs of the scenario alone, not yet with those of `management`. Refers to
    /// `scenario` and `site`.
    MemberKeys(const Scenario& scenario, const Site& site, const Management& management);

    /// 32 hexadecimal digits. From any thread.
    [[nodiscard]] std::string of(const Member& member) const;
    [[nodiscard]] std::string of_bare(std::uint32_t replicate, std::size_t block) const;

private:
    /// Key of the weather of a climate in the years of a replicate.
    [[nodiscard]] std::string weather_of(std::uint32_t climate, std::uint32_t replicate) const;

    const Scenario& scenario_;
    const ForestSite& forest_;
    std::vector<std::string> regimes_;
    std::string shared_;
    mutable std::mutex mutex_;
    mutable std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> weather_;
};

}  // namespace coupling::decades
