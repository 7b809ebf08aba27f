#include "coupling/assessments/decades/decision/drawn_protection.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "config/random/quantiles.hpp"
#include "config/random/stream.hpp"
#include "coupling/results/figures/ratio_parts.hpp"

namespace coupling::decades {
namespace {

/// A mean over replicates, draw by draw; each draw leaves open what its replicates do.
class DrawnMean {
public:
    /// `values`: of the replicates in a draw. `t`: a draw of Student's t.
    void add(std::span<const double> values, double t) {
        const MeanLaw law{values};
        sum_ += law.mean();
        drawn_.push_back(law.at_students(t));
    }
    /// Without an interval where there is but one replicate, or where all are equal in all draws.
    [[nodiscard]] Band band(std::size_t replicates, const Bounds& bounds) const {
        std::vector<double> rising = drawn_;
        std::sort(rising.begin(), rising.end());
        const auto at = [&](double share) {
            return rising[static_cast<std::size_t>(share * static_cast<double>(rising.size() - 1))];
        };
        Band band = unknown_band;
        band.mean = mean();
        if (replicates > 1 && rising.front() < rising.back()) {
            band.low = std::max(bounds.low, at(0.5 * (1.0 - interval_share)));
            band.high = std::min(bounds.high, at(0.5 * (1.0 + interval_share)));
        }
        return band;
    }
    [[nodiscard]] double mean() const { return sum_ / static_cast<double>(drawn_.size()); }

private:
    double sum_ = 0.0;
    std::vector<double> drawn_;
};

/// The years of a course, each with what it stands for.
std::vector<ForestYear> empty_years(std::span<const std::int32_t> years, const DecisionSettings& settings,
                                    std::span<const std::int32_t> rock_years) {
    std::vector<ForestYear> all;
    for (const std::int32_t year : years) {
        const auto next = std::lower_bound(rock_years.begin(), rock_years.end(), year);
        const std::int32_t before = next == rock_years.begin() ? 0 : *std::prev(next);
        all.push_back({.year = year,
                       .stands_for_years = static_cast<double>(year - before),
                       .beyond_years = year == years.back() ? settings.years_beyond : 0.0});
    }
    return all;
}

/// What one draw of a replicate says: each year is below or not.
ProtectionRecord record_of(std::vector<ForestYear> years, std::span<const double> percent,
                           double at_least_percent) {
    for (std::size_t i = 0; i < years.size(); ++i) {
        years[i].protection_percent = percent[i];
        years[i].p_below = percent[i] < at_least_percent ? 1.0 : 0.0;
        years[i].missing_percent = std::max(0.0, at_least_percent - percent[i]);
    }
    return {.years = std::move(years)};
}

void add(ProtectionRecord& mean, const ProtectionRecord& draw) {
    constexpr double share = 1.0 / static_cast<double>(CourseLaw::draws);
    for (std::size_t i = 0; i < mean.years.size(); ++i) {
        mean.years[i].protection_percent += share * draw.years[i].protection_percent;
        mean.years[i].p_below += share * draw.years[i].p_below;
        mean.years[i].missing_percent += share * draw.years[i].missing_percent;
    }
}

/// A number of Student's t of the replicates of a draw, apart from the numbers of their courses.
double students_t_of(std::size_t draw, std::size_t replicates) {
    constexpr double least_probability = 1e-9;  // the law has no end
    config::RandomStream numbers{{2, 0, 0, draw + 1}, config::Purpose::parameter};
    const double probability = std::max(least_probability, numbers.uniform());
    return replicates > 1 ? config::students_t_quantile(static_cast<double>(replicates - 1), probability)
                          : 0.0;
}

/// What each of the replicates brings to the mean of a year.
std::vector<double> parts_in_year(const std::vector<std::vector<double>>& courses, std::size_t year,
                                  std::span<const double> weights) {
    std::vector<double> values;
    for (const std::vector<double>& course : courses) {
        values.push_back(course[year]);
    }
    return weights.empty() ? values : parts_of_ratio(values, weights);
}

}  // namespace

double ProtectionRecord::years_below() const {
    double sum = 0.0;
    for (const ForestYear& year : years) {
        sum += year.stands_for_years * year.p_below;
    }
    return sum;
}

double ProtectionRecord::percent_years_lost() const {
    double sum = 0.0;
    for (const ForestYear& year : years) {
        sum += (year.stands_for_years + year.beyond_years) * year.missing_percent;
    }
    return sum;
}

DrawnProtection drawn_protection(const CourseYears& course, std::span<const double> weights,
                                 const DecisionSettings& settings, std::span<const std::int32_t> rock_years) {
    const CourseLaw law{course};
    const std::span<const std::size_t> replicates = law.replicates();
    DrawnProtection found;
    found.records.resize(course.of_replicates.size());
    if (replicates.empty()) {
        found.years_below = found.percent_years_lost = unknown_band;
        return found;
    }
    const std::vector<ForestYear> years = empty_years(law.years(), settings, rock_years);
    std::vector<double> own_weights;
    for (const std::size_t replicate : replicates) {
        found.records[replicate] = ProtectionRecord{years};
        if (!weights.empty()) {
            own_weights.push_back(weights[replicate]);
            found.records[replicate]->weight = weights[replicate];
        }
    }
    std::vector<std::size_t> kept_in_draws(CourseLaw::groups);
    DrawnMean years_below;
    DrawnMean percent_years_lost;
    std::vector<DrawnMean> means(years.size());
    for (std::size_t draw = 0; draw < CourseLaw::draws; ++draw) {
        const std::vector<std::vector<double>> courses = law.drawn(draw);
        std::vector<double> below;
        std::vector<double> lost;
        for (std::size_t r = 0; r < replicates.size(); ++r) {
            const ProtectionRecord record =
                record_of(years, courses[r], settings.protection_at_least_percent);
            add(*found.records[replicates[r]], record);
            below.push_back(record.years_below());
            lost.push_back(record.percent_years_lost());
            const double lowest = *std::min_element(courses[r].begin(), courses[r].end());
            kept_in_draws[draw / CourseLaw::draws_of_group] +=
                lowest >= settings.protection_at_least_percent ? 1 : 0;
        }
        const double t = students_t_of(draw, replicates.size());
        years_below.add(below, t);
        percent_years_lost.add(lost, t);
        for (std::size_t year = 0; year < means.size(); ++year) {
            means[year].add(parts_in_year(courses, year, own_weights), t);
        }
    }
    std::vector<double> kept;
    for (const std::size_t of_group : kept_in_draws) {
        kept.push_back(static_cast<double>(of_group) / static_cast<double>(CourseLaw::draws_of_group));
    }
    found.worst.emplace(kept, replicates.size());
    ProtectionRecord all_below{years};
    for (ForestYear& year : all_below.years) {
        year.p_below = 1.0;
    }
    found.years_below = years_below.band(replicates.size(), {0.0, all_below.years_below()});
    found.percent_years_lost = percent_years_lost.band(replicates.size(), not_negative);
    const auto lowest = std::min_element(means.begin(), means.end(),
                                         [](const auto& a, const auto& b) { return a.mean() < b.mean(); });
    found.lowest = Extreme{law.years()[static_cast<std::size_t>(lowest - means.begin())],
                           {replicates.size(), lowest->band(replicates.size(), {.high = 100.0})}};
    return found;
}

}  // namespace coupling::decades
