#include "coupling/assessments/decades/decision/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/decades/decision/judged_years.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::fixed;
using report::page_text;

/// From half a percent point on the rocks of a year blur whether a replicate keeps a threshold [choice].
constexpr double blurred_percent = 0.5;

class Speaker {
public:
    Speaker(const Names& names, const Decision& decision) : names_{names}, decision_{decision} {}

    std::vector<std::string> sentences() {
        const std::vector<std::size_t> keeping = decision_.keeping(names_);
        if (keeping.empty()) {
            none_keeps();
        } else {
            cheapest(keeping);
        }
        unjudged();
        undecided(keeping);
        not_counted();
        rocks();
        return std::move(sentences_);
    }

private:
    /// "protection of at least 90 % in all years with rocks (1 to 40) with a probability of 80 %, in all 2
    /// climates"
    [[nodiscard]] std::string asked() const {
        return report::join_with_commas(
            {page_text("protection of at least {percent} % in all years with rocks ({first_year} to "
                       "{last_year}) with "
                       "a probability of {probability} %",
                       {{"percent", plain(decision_.settings.protection_at_least_percent)},
                        {"first_year", std::to_string(decision_.first_year)},
                        {"last_year", std::to_string(decision_.last_year)},
                        {"probability", plain(100.0 * decision_.settings.probability)}}),
             names_.climates.size() > 1 ? page_text("in each of {climates} climates",
                                                    {{"climates", std::to_string(names_.climates.size())}})
                                        : ""});
    }

    /// Without decimals where there are none.
    static std::string plain(double value) { return fixed(value, std::round(value) == value ? 0 : 1); }

    [[nodiscard]] double mean_over_climates(std::size_t regime, Band CourseMoney::*band) const {
        double sum = 0.0;
        for (std::size_t climate = 0; climate < names_.climates.size(); ++climate) {
            sum += (decision_.money[names_.course(regime, climate)].*band).mean;
        }
        return sum / static_cast<double>(names_.climates.size());
    }

    void cheapest(const std::vector<std::size_t>& keeping) {
        const std::size_t best = keeping.front();
        sentences_.push_back(page_text(
            "Regime {regime} is the cheapest regime that keeps {asked}: present value {present_value} EUR/ha "
            "at {discount} % a year with what stands at the end, net {net} EUR/ha a year, {removed} m³/ha of "
            "timber removed a year.",
            {{"regime", names_.regimes[best]},
             {"asked", asked()},
             {"present_value", fixed(decision_.present_value_of(names_, best), 0)},
             {"discount", plain(decision_.settings.discount_percent)},
             {"net", fixed(mean_over_climates(best, &CourseMoney::net_eur_pha_a_year), 0)},
             {"removed", fixed(mean_over_climates(best, &CourseMoney::removed_m3pha_a_year), 1)}}));
        if (keeping.size() < 2) {
            return;
        }
        const auto difference = difference_in_value(decision_, names_, keeping[1], best);
        if (!difference) {
            return;
        }
        const bool is_known = difference->high < 0.0;
        const auto needed = replicates_needed(difference->mean, difference->deviation);
        const std::string& regime = names_.regimes[keeping[1]];
        const std::string value = fixed(-difference->mean, 0);
        const std::string low = fixed(-difference->high, 0);
        const std::string high = fixed(-difference->low, 0);
        sentences_.push_back(report::join_sentences(
            {std::isnan(difference->low)
                 ? page_text(
                       "Regime {regime} keeps it too; that it costs {difference} EUR/ha more is not known "
                       "beyond chance, interval unknown.",
                       {{"regime", regime}, {"difference", value}})
                 : page_text(
                       is_known
                           ? "Regime {regime} keeps it too and costs {difference} EUR/ha more, 95 % interval "
                             "{low} to {high}."
                           : "Regime {regime} keeps it too; that it costs {difference} EUR/ha more is not "
                             "known beyond chance, 95 % interval {low} to {high}.",
                       {{"regime", regime}, {"difference", value}, {"low", low}, {"high", high}}),
             is_known || !needed ? ""
                                 : page_text("About {replicates} replicates would tell the two apart.",
                                             {{"replicates", std::to_string(*needed)}})}));
    }

    /// The probability that the worst year keeps it; of too few replicates the share that do.
    [[nodiscard]] static double keeps_in(const CourseAtTarget& at) {
        return at.worst() != nullptr ? at.worst()->median() : at.kept.value();
    }

    /// Where a regime is worst: the course and target that keep it least likely, of equal ones that with the
    /// most percent-years lost.
    [[nodiscard]] const CourseAtTarget& worst_of(std::size_t regime) const {
        const CourseAtTarget* worst = nullptr;
        for (const CourseAtTarget& at : decision_.at_targets) {
            if (names_.regime_of(at.course) != regime || !at.is_known()) {
                continue;
            }
            if (worst == nullptr || keeps_in(at) < keeps_in(*worst) ||
                (keeps_in(at) == keeps_in(*worst) &&
                 at.forest.percent_years_lost.mean > worst->forest.percent_years_lost.mean)) {
                worst = &at;
            }
        }
        return worst != nullptr ? *worst : decision_.at_targets.front();
    }

    /// "where it is worst (climate warm, target road)".
    [[nodiscard]] std::string worst_place(const CourseAtTarget& at) const {
        const std::size_t targets = decision_.at_targets.size() / decision_.money.size();
        std::vector<std::string> place;
        if (names_.climates.size() > 1) {
            place.push_back(
                page_text("climate {climate}", {{"climate", names_.climates[names_.climate_of(at.course)]}}));
        }
        if (targets > 1) {
            place.push_back(page_text("target {target}", {{"target", at.target}}));
        }
        return place.empty()
                   ? page_text("where it is worst")
                   : page_text("where it is worst ({place})", {{"place", report::join_with_commas(place)}});
    }

    void none_keeps() {
        const bool all_fail = [&] {
            for (std::size_t regime = 0; regime < names_.regimes.size(); ++regime) {
                if (decision_.of_regime(names_, regime) != Keeps::no) {
                    return false;
                }
            }
            return true;
        }();
        sentences_.push_back(
            page_text(all_fail ? "No regime keeps {asked}."
                               : "No regime is known to keep {asked}: the replicates do not decide.",
                      {{"asked", asked()}}));
        if (!all_fail) {
            return;
        }
        std::size_t best = 0;
        for (std::size_t regime = 1; regime < names_.regimes.size(); ++regime) {
            const bool better = worst_of(regime).forest.percent_years_lost.mean <
                                worst_of(best).forest.percent_years_lost.mean;
            best = better ? regime : best;
        }
        const CourseAtTarget& at = worst_of(best);
        sentences_.push_back(
            page_text("Regime {regime} loses least: {where_worst}, {kept} of {replicates} "
                      "replicates keep it, protection is below for {years_below} years on average and lowest "
                      "in year {year} ({lowest} %).",
                      {{"regime", names_.regimes[best]},
                       {"where_worst", worst_place(at)},
                       {"kept", std::to_string(at.kept.kept)},
                       {"replicates", std::to_string(at.kept.replicates)},
                       {"years_below", fixed(at.forest.years_below.mean, 1)},
                       {"lowest", at.forest.lowest ? fixed(at.forest.lowest->value.band.mean, 1) : "–"},
                       {"year", at.forest.lowest ? std::to_string(at.forest.lowest->year) : "–"}}));
    }

    /// Regimes that cut where nobody looks.
    void unjudged() {
        for (std::size_t regime = 0; regime < decision_.unjudged_cuts.size(); ++regime) {
            const std::vector<std::int32_t>& cuts = decision_.unjudged_cuts[regime];
            if (!cuts.empty()) {
                sentences_.push_back(page_text(
                    "Regime {regime} cuts in years ({years}) in which no rocks fall, nor in the two years "
                    "after: its lowest years are not judged, and it cannot be said to keep protection. Let "
                    "rocks fall in every year (run.rockfall_every = 1), fewer of them: it takes no longer.",
                    {{"regime", names_.regimes[regime]}, {"years", years_in_words(cuts)}}));
            }
        }
    }

    /// How sure it is, and what would tell more.
    [[nodiscard]] std::string undecided_at(std::size_t regime, const CourseAtTarget& at) const {
        const auto replicates =
            replicates_to_judge(share_of(at), decision_.settings.probability, decision_.chances);
        const std::string needed =
            replicates ? page_text("about {replicates} replicates would decide",
                                   {{"replicates", std::to_string(*replicates)}})
                       : page_text(
                             "its share is too close to the probability asked for to decide by "
                             "replicates");
        if (at.worst() != nullptr) {
            const auto in_percent = [&](double part) { return fixed(100.0 * at.worst()->at(part), 0); };
            return page_text(
                "Regime {regime} is undecided: {where_worst}, its worst year keeps it with a probability of "
                "{probability} % (90 % interval {low} to {high} %); {needed}.",
                {{"regime", names_.regimes[regime]},
                 {"where_worst", worst_place(at)},
                 {"probability", in_percent(0.5)},
                 {"low", in_percent(0.05)},
                 {"high", in_percent(0.95)},
                 {"needed", needed}});
        }
        return page_text(
            "Regime {regime} is undecided: {where_worst}, {kept} of {replicates} replicates "
            "keep it ({low} to {high} %, for all regimes together with 95 %); {needed}.",
            {{"regime", names_.regimes[regime]},
             {"where_worst", worst_place(at)},
             {"kept", std::to_string(at.kept.kept)},
             {"replicates", std::to_string(at.kept.replicates)},
             {"low", fixed(100.0 * at.kept.verdict_low, 0)},
             {"high", fixed(100.0 * at.kept.verdict_high, 0)},
             {"needed", needed}});
    }

    /// Regimes that more replicates would decide: all where none keeps, else those that may be cheaper.
    void undecided(const std::vector<std::size_t>& keeping) {
        std::vector<std::size_t> regimes;
        for (std::size_t regime = 0; regime < names_.regimes.size(); ++regime) {
            const bool may_be_cheaper =
                keeping.empty() || decision_.present_value_of(names_, regime) >
                                       decision_.present_value_of(names_, keeping.front());
            const bool is_judged =
                regime >= decision_.unjudged_cuts.size() || decision_.unjudged_cuts[regime].empty();
            if (decision_.of_regime(names_, regime) == Keeps::undecided && may_be_cheaper && is_judged) {
                regimes.push_back(regime);
            }
        }
        const auto known = std::count_if(regimes.begin(), regimes.end(), [&](std::size_t regime) {
            return worst_of(regime).worst() != nullptr;
        });
        constexpr std::size_t few = 2;
        if (regimes.size() > few && (known == 0 || known == std::ssize(regimes))) {
            undecided_together(regimes, known > 0);
            return;
        }
        for (const std::size_t regime : regimes) {
            sentences_.push_back(undecided_at(regime, worst_of(regime)));
        }
    }

    [[nodiscard]] std::string probability_of(std::size_t regime, const CourseAtTarget& at) const {
        const auto in_percent = [&](double part) { return fixed(100.0 * at.worst()->at(part), 0); };
        return page_text("{regime} {probability} % ({low} to {high} %)", {{"regime", names_.regimes[regime]},
                                                                          {"probability", in_percent(0.5)},
                                                                          {"low", in_percent(0.05)},
                                                                          {"high", in_percent(0.95)}});
    }

    [[nodiscard]] std::string count_of(std::size_t regime, const CourseAtTarget& at) const {
        return page_text("{regime} {kept} of {replicates}",
                         {{"regime", names_.regimes[regime]},
                          {"kept", std::to_string(at.kept.kept)},
                          {"replicates", std::to_string(at.kept.replicates)}});
    }

    /// One sentence where each would say the same.
    void undecided_together(const std::vector<std::size_t>& regimes, bool has_probabilities) {
        std::vector<std::string> each;
        std::size_t most = 0;
        bool is_known = true;
        for (const std::size_t regime : regimes) {
            const CourseAtTarget& at = worst_of(regime);
            each.push_back(has_probabilities ? probability_of(regime, at) : count_of(regime, at));
            const auto replicates =
                replicates_to_judge(share_of(at), decision_.settings.probability, decision_.chances);
            is_known = is_known && replicates.has_value();
            most = std::max(most, replicates.value_or(0));
        }
        sentences_.push_back(report::join_sentences(
            {page_text(has_probabilities
                           ? "{count} regimes are undecided; the probability that the worst year keeps it, "
                             "where a regime is worst, with its 90 % interval: {regimes}."
                           : "{count} regimes are undecided; replicates that keep it, where a regime is "
                             "worst: {regimes}.",
                       {{"count", std::to_string(regimes.size())},
                        {"regimes", report::join_with_semicolons(each)}}),
             is_known ? page_text("About {replicates} replicates would decide all of them.",
                                  {{"replicates", std::to_string(most)}})
                      : ""}));
    }

    /// The replicates that keep it, without the noise of the rocks where that is known.
    [[nodiscard]] KeptShare share_of(const CourseAtTarget& at) const {
        if (at.worst() == nullptr) {
            return at.kept;
        }
        const double kept = at.worst()->median() * static_cast<double>(at.kept.replicates);
        return kept_share(static_cast<std::size_t>(std::lround(kept)), at.kept.replicates, decision_.chances);
    }

    /// A replicate in which no rock arrives over the bare slope says nothing of a regime.
    void not_counted() {
        if (std::any_of(decision_.at_targets.begin(), decision_.at_targets.end(), [](const auto& at) {
                return at.is_known() && at.kept.replicates < at.forest.records.size();
            })) {
            sentences_.push_back(
                page_text("Replicates without a protection figure in any year after the start are not "
                          "counted: too few of their rocks arrive over the bare slope."));
        }
    }

    /// What rocks leave open, beside what replicates do.
    void rocks() {
        double most = 0.0;
        bool matters = false;
        for (const CourseAtTarget& at : decision_.at_targets) {
            most = std::isnan(at.rock_error_percent) ? most : std::max(most, at.rock_error_percent);
            matters = matters || judge(at, decision_.settings, decision_.chances) != Keeps::yes;
        }
        if (matters && most >= blurred_percent) {
            sentences_.push_back(
                page_text("The rocks alone make a year of one replicate uncertain by up to ± {percent} "
                          "percentage points. As far as the replicates tell it, this noise is taken out; "
                          "more rocks a year would help to decide.",
                          {{"percent", fixed(most, 1)}}));
        }
    }

    const Names& names_;
    const Decision& decision_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> verdict(const Names& names, const Decision& decision) {
    return Speaker{names, decision}.sentences();
}

}  // namespace coupling::decades
