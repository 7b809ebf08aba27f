#include "coupling/assessments/calibrate/model/hold_out.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/inputs/files/file_bytes.hpp"

namespace coupling::calibrate {
namespace {

/// From so many groups on whole groups are held out: blocks of one event are no independent witnesses.
constexpr std::size_t least_groups = 5;

/// A number of 40 bits by which a group is drawn, whatever other groups there are.
std::uint64_t number_of_name(const std::string& name) {
    const std::uint64_t hash = fnv1a(name);
    return (hash ^ (hash >> 40U)) & 0xFF'FFFF'FFFFULL;
}

}  // namespace

std::vector<bool> HoldOut::of(std::uint16_t kind, const std::vector<std::string>& groups) {
    std::vector<bool> marks(groups.size());
    if (!settings_.hold_out_group.empty()) {
        std::transform(groups.begin(), groups.end(), marks.begin(),
                       [&](const std::string& group) { return group == settings_.hold_out_group; });
        found_group_ = found_group_ || std::find(marks.begin(), marks.end(), true) != marks.end();
        return marks;
    }
    const std::set<std::string> names(groups.begin(), groups.end());
    const bool by_group = names.size() >= least_groups;
    std::vector<std::pair<double, std::size_t>> order;  // by chance
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const std::uint64_t unit = by_group ? number_of_name(groups[i]) : i;
        const auto wave = by_group ? std::uint16_t{0} : kind;
        order.emplace_back(choices(seed_, wave, Choice::hold_out, unit).uniform(), i);
    }
    std::sort(order.begin(), order.end());
    const double wanted = settings_.hold_out_percent / 100.0 * static_cast<double>(groups.size());
    std::size_t taken = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same_group = by_group && k > 0 && order[k].first == order[k - 1].first;
        if (static_cast<double>(taken) >= wanted && !same_group) {
            break;
        }
        marks[order[k].second] = true;
        ++taken;
    }
    return marks;
}

}  // namespace coupling::calibrate
