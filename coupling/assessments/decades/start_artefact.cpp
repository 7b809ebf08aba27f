#include "coupling/assessments/decades/start_artefact.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::decades {
namespace {

constexpr double noticeable_percent = 2.0;

bool begins_without_dead_wood(const MemberYears& member) {
    return !member.years.empty() && member.years.front().logs_m3pha == 0.0 &&
           member.years.front().snags_m3pha == 0.0;
}

}  // namespace

std::optional<std::string> missing_dead_wood(const Names& names, std::span<const Series> series,
                                             std::span<const MemberYears> members) {
    const auto by_logs = std::find_if(series.begin(), series.end(), [](const Series& each) {
        return each.quantity == "stopped_by_log_percent";
    });
    if (by_logs == series.end() || !std::all_of(members.begin(), members.end(), begins_without_dead_wood)) {
        return std::nullopt;
    }
    double most_percent = 0.0;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        for (const std::int32_t year : years_of(*by_logs)) {
            const auto value = over_replicates(*by_logs, course, year);
            most_percent = value ? std::max(most_percent, value->band.mean) : most_percent;
        }
    }
    if (most_percent < noticeable_percent) {
        return std::nullopt;
    }
    return config::joined(
        "the start holds no dead wood, later logs stop up to ", report::fixed(most_percent, 1),
        " % of the rocks: part of the rise of protection comes from this; give the dead wood of "
        "the inventory (stands.dead_wood)");
}

}  // namespace coupling::decades
