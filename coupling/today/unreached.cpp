#include "coupling/today/unreached.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/reading.hpp"

namespace coupling {
namespace {

using config::joined;

/// "target 'road'", "3 of 7 targets, such as 'road'".
std::string unreached_in_words(const std::vector<std::string>& names, std::size_t all,
                               const std::string& singular) {
    return names.size() == 1 ? joined(singular, " ", config::in_quotes(names.front()))
                             : joined(std::to_string(names.size()), " of ", counted(all, singular),
                                      ", such as ", config::in_quotes(names.front()));
}

}  // namespace

void warn_of_unreached(const Site& site, const rockfall::EnsembleTally& total, std::span<const NetRow> nets,
                       config::Warnings& warnings) {
    const std::uint64_t rocks = total.runs[static_cast<std::size_t>(rockfall::Cover::bare)].rocks;
    if (rocks == 0) {
        return;
    }
    std::vector<std::string> targets;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        const auto& covers = total.targets[i].by_cover;
        if (std::all_of(covers.begin(), covers.end(), [](const auto& cover) { return cover.reached == 0; })) {
            targets.push_back(site.targets[i].id);
        }
    }
    const std::string no_rock = joined("no rock of ", std::to_string(rocks), " reached ");
    if (!targets.empty() && targets.size() == site.targets.size()) {
        warnings.add(joined(no_rock,
                            "any target: check that the sources lie above the targets, and the heights: "
                            "crowns, steps and stripes in them stop rocks"),
                     config::Effect::answer);
    } else if (!targets.empty()) {
        warnings.add(
            joined(no_rock, unreached_in_words(targets, site.targets.size(), "target"), ", on either slope"));
    }
    std::vector<std::string> idle;
    for (std::size_t i = 0; i < site.nets.size(); ++i) {
        if (std::none_of(nets.begin(), nets.end(),
                         [&](const NetRow& row) { return row.crossing.net == i; })) {
            idle.push_back(site.nets[i].name);
        }
    }
    if (!idle.empty()) {
        warnings.add(joined(no_rock, unreached_in_words(idle, site.nets.size(), "net"), ", on either slope"));
    }
}

}  // namespace coupling
