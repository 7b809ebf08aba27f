#include "coupling/assessments/decades/decision/course_money.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace coupling::decades {
namespace {

const Series* find(std::span<const Series> all_series, const std::string& quantity) {
    const auto found = std::find_if(all_series.begin(), all_series.end(), [&](const Series& series) {
        return series.target.empty() && series.quantity == quantity;
    });
    return found == all_series.end() ? nullptr : &*found;
}

/// Sums over the years of each replicate, each year times its factor.
template <class Factor>
std::vector<double> sums_of(const Series* series, std::size_t course, Factor factor) {
    std::vector<double> sums;
    for (const auto& replicate :
         series != nullptr ? series->values[course] : std::vector<std::map<std::int32_t, double>>{}) {
        double sum = 0.0;
        for (const auto& [year, value] : replicate) {
            sum += factor(year) * value;
        }
        sums.push_back(sum);
    }
    return sums;
}

Band known_band(const std::vector<double>& values, const Bounds& bounds) {
    return values.empty() ? unknown_band : band_of(values, bounds);
}

}  // namespace

CourseMoney money_of(std::span<const Series> series, std::size_t course, const DecisionSettings& settings) {
    const Series* margin = find(series, "contribution_margin_eur_pha");
    const Series* removed = find(series, "removed_m3pha");
    const auto years = margin != nullptr ? years_of(*margin) : std::vector<std::int32_t>{};
    const double last = years.empty() ? 1.0 : std::max(1.0, static_cast<double>(years.back()));
    const auto a_year = [&](std::int32_t) { return 1.0 / last; };
    CourseMoney money{.course = course};
    const auto discounted = [&](std::int32_t year) {
        return std::pow(1.0 + settings.discount_percent / 100.0, -static_cast<double>(year));
    };
    const std::vector<double> work = sums_of(margin, course, discounted);
    const auto end = static_cast<std::int32_t>(last);
    std::vector<double> stock =
        sums_of(find(series, "standing_value_eur_pha"), course, [&](std::int32_t year) {
            return year == end ? discounted(year) : year == 0 ? -1.0 : 0.0;
        });
    stock.resize(work.size(), 0.0);
    money.work_value_eur_pha = known_band(work, {});
    money.stock_value_eur_pha = known_band(stock, {});
    std::transform(work.begin(), work.end(), stock.begin(), std::back_inserter(money.present_values_eur_pha),
                   std::plus<>{});
    money.present_value_eur_pha = known_band(money.present_values_eur_pha, {});
    money.net_eur_pha_a_year = known_band(sums_of(margin, course, a_year), {});
    money.removed_m3pha_a_year = known_band(sums_of(removed, course, a_year), not_negative);
    return money;
}

std::optional<PairedDifference> difference_in_value(const CourseMoney& a, const CourseMoney& b) {
    std::vector<double> differences;
    for (std::size_t r = 0; r < std::min(a.present_values_eur_pha.size(), b.present_values_eur_pha.size());
         ++r) {
        differences.push_back(a.present_values_eur_pha[r] - b.present_values_eur_pha[r]);
    }
    return differences.empty() ? std::nullopt : std::optional{difference_of(differences)};
}

}  // namespace coupling::decades
