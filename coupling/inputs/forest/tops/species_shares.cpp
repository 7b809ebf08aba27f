#include "coupling/inputs/forest/tops/species_shares.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling {
namespace {

using config::joined;

/// "PIAB 60 %": the name, and the number behind it where there is one.
SpeciesShare share_in(std::string_view item, bool is_alone) {
    if (item.ends_with('%')) {
        item = config::trimmed(item.substr(0, item.size() - 1));
    }
    const std::size_t blank = item.find_last_of(" \t");
    const std::optional<double> number =
        blank == std::string_view::npos ? std::nullopt : config::parse_number(item.substr(blank + 1));
    if (!number && is_alone) {
        return {std::string{item}, 1.0};
    }
    if (!number || !(*number >= 0.0)) {
        throw std::invalid_argument{joined(config::in_quotes(std::string{item}), " without a share")};
    }
    return {std::string{config::trimmed(item.substr(0, blank))}, *number};
}

}  // namespace

std::vector<SpeciesShare> species_shares(std::string_view text) {
    std::vector<SpeciesShare> shares;
    const bool is_alone = text.find_first_of(",;") == std::string_view::npos;
    double sum = 0.0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(",;"), text.size());
        if (const std::string_view item = config::trimmed(text.substr(0, end)); !item.empty()) {
            shares.push_back(share_in(item, is_alone));
            sum += shares.back().share;
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    constexpr double tolerance = 0.01;
    const bool are_percent = std::abs(sum - 100.0) <= 100.0 * tolerance;
    if (!are_percent && !(std::abs(sum - 1.0) <= tolerance)) {
        throw std::invalid_argument{joined("shares that add up to ", config::to_text(sum))};
    }
    for (SpeciesShare& one : shares) {
        one.share /= sum;
    }
    return shares;
}

const std::string& species_at(const std::vector<SpeciesShare>& shares, double uniform) {
    double below = 0.0;
    for (const SpeciesShare& one : shares) {
        below += one.share;
        if (uniform < below) {
            return one.name;
        }
    }
    // The sum of shares may be a rounding error below 1.
    std::size_t last = shares.size() - 1;
    while (last > 0 && shares[last].share <= 0.0) {
        --last;
    }
    return shares[last].name;
}

}  // namespace coupling
