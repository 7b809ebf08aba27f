#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/decision/course_money.hpp"
#include "coupling/assessments/decades/decision/drawn_protection.hpp"
#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/inputs/scenario/decision_settings.hpp"

namespace coupling::decades {

/// The chances that a verdict is wrong, of "yes" and of "no".
///
/// The verdicts on all regimes of a run are to hold together with 95 %. A wrong "yes" is possible for each
/// regime, and each climate and target has to be passed for it (an intersection-union test, Berger 1982), so
/// that its chance is divided by the regimes alone. A wrong "no" is possible at each of them (Bonferroni).
struct VerdictChances {
    double yes = 0.05;
    double no = 0.05;
};
/// Of so many regimes, each judged at so many places: climates times targets. Requires both > 0.
VerdictChances verdict_chances(std::size_t regimes, std::size_t places);

/// In how many replicates something held, with the exact 90 % interval of its probability (Clopper & Pearson
/// 1934) and the bounds by which a verdict is given.
struct KeptShare {
    std::size_t kept = 0;
    std::size_t replicates = 0;
    double low = 0.0;
    double high = 1.0;
    double verdict_low = 0.0;   ///< the probability lies below with the chance of a wrong "yes"
    double verdict_high = 1.0;  ///< above with that of a wrong "no"
    [[nodiscard]] double value() const { return static_cast<double>(kept) / static_cast<double>(replicates); }
};
/// Requires kept <= replicates, replicates > 0.
KeptShare kept_share(std::size_t kept, std::size_t replicates, const VerdictChances& chances = {});

/// The fewest replicates that can give a "yes": all of them keep it. Requires a probability in (0, 1).
std::size_t least_for_yes(double probability, const VerdictChances& chances);

/// Whether a regime keeps what is asked for with the probability asked for, as far as the replicates say.
enum class Keeps : std::uint8_t { yes, no, undecided };
Keeps judge(const KeptShare& share, double probability);
/// Of several climates and targets: no where any of them fails, yes where all are kept.
Keeps both(Keeps a, Keeps b);

/// The replicates with which a share of this size would be known to be above or below the probability.
/// Nothing for a share that equals it, and for more than 5000.
std::optional<std::size_t> replicates_to_judge(const KeptShare& share, double probability,
                                               const VerdictChances& chances = {});

/// The lowest years of the replicates of a course at a target.
struct Lowest {
    std::size_t replicates = 0;
    double mean_percent = 0.0;
    double deviation_percent = 0.0;  ///< n - 1; NaN of one
};

/// Whether the lowest years lie so far above a threshold that their distribution, taken as normal, keeps it
/// with the probability asked for (tolerance limit). Rocks of a year scatter them and lower them: both count
/// against it. False below six replicates [choice]: fewer do not show their spread.
bool is_above(const Lowest& lowest, double at_least_percent, double probability, double chance);

/// A course at a target.
struct CourseAtTarget {
    std::size_t course = 0;
    std::string target{};
    KeptShare kept{};               ///< as simulated, with the noise of the rocks
    Lowest lowest_of_replicates{};  ///< as simulated
    DrawnProtection forest{};       ///< without that noise
    bool has_gaps = false;          ///< some replicates show no protection in a year that others show
    /// Half of the 95 % interval of a year's protection in one replicate that its rocks alone leave, median
    /// over years and replicates [percent]. NaN where no interval is known.
    double rock_error_percent = 0.0;
    [[nodiscard]] bool is_known() const { return kept.replicates > 0; }
    /// The probability that the worst year keeps it; nothing of fewer replicates than
    /// least_replicates_of_courses.
    [[nodiscard]] const WorstYear* worst() const {
        return forest.worst && kept.replicates >= least_replicates_of_courses ? &*forest.worst : nullptr;
    }
};

/// Whether a course keeps protection at a target: yes by the share of replicates that do as simulated, or,
/// where all of them do, by how far they lie above the threshold, or by the probability of its worst year
/// (worst_year.hpp); no only if the noise of the rocks is not to blame. So neither too few rocks nor what
/// takes their noise out make a verdict.
Keeps judge(const CourseAtTarget& at, const DecisionSettings& settings, const VerdictChances& chances);

/// The answer to the question which regime keeps protection, at what cost.
struct Decision {
    DecisionSettings settings{};
    VerdictChances chances{};
    std::int32_t first_year = 0;  ///< with rocks after the start
    std::int32_t last_year = 0;
    std::vector<CourseAtTarget> at_targets{};  ///< course by course, targets in order
    std::vector<CourseMoney> money{};          ///< by course
    /// By regime: years in which it cuts and no rocks show what that costs (judged_years.hpp). A regime with
    /// such years cannot be said to keep protection.
    std::vector<std::vector<std::int32_t>> unjudged_cuts{};

    /// Nothing where no year is judged there.
    [[nodiscard]] const CourseAtTarget* find(std::size_t course, const std::string& target) const;
    /// At a target; undecided where a cut of its regime is not judged.
    [[nodiscard]] Keeps at_target(const Names& names, const CourseAtTarget& at) const;
    [[nodiscard]] Keeps of_course(std::size_t course) const;
    [[nodiscard]] Keeps of_regime(const Names& names, std::size_t regime) const;
    /// Mean over climates of the mean present value.
    [[nodiscard]] double present_value_of(const Names& names, std::size_t regime) const;
    /// Regimes that keep protection at every target in every climate, dearest last.
    [[nodiscard]] std::vector<std::size_t> keeping(const Names& names) const;
};

/// Nothing where no year after the start has a protection figure.
std::optional<Decision> decide(const Names& names, std::span<const Series> series,
                               std::span<const MemberYears> members, const DecisionSettings& settings);

/// Pairs of replicates of two courses: a minus b.
std::optional<PairedDifference> difference_in_percent_years(const CourseAtTarget& a, const CourseAtTarget& b);
/// Of the present value of two regimes, meaned over climates replicate by replicate.
std::optional<PairedDifference> difference_in_value(const Decision& decision, const Names& names,
                                                    std::size_t regime, std::size_t reference);

}  // namespace coupling::decades
