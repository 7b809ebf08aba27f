#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/figures/departures.hpp"
#include "coupling/results/figures/unreached.hpp"

namespace coupling::hazard {

using config::joined;

namespace {

std::string listed(const std::vector<std::string>& years) {
    std::string text;
    for (const std::string& one : years) {
        text += joined(text.empty() ? "" : ", ", one);
    }
    return text;
}

bool is_like(const DepartingShare& one, const std::string& sentence) {
    const std::optional<DepartingShare> other = departing_share(sentence);
    return other && other->of_whom == one.of_whom;
}

}  // namespace

/// Whether the sentence is of rocks that leave the terrain; then it is part of the entry of those.
bool SharedWarnings::add_departures(std::vector<Entry>& entries, const std::string& period,
                                    const std::string& sentence, config::Effect effect) {
    const std::optional<DepartingShare> share = departing_share(sentence);
    if (!share) {
        return false;
    }
    const auto like = std::find_if(entries.begin(), entries.end(),
                                   [&](const Entry& entry) { return is_like(*share, entry.sentence); });
    if (like == entries.end()) {
        entries.push_back({sentence, {period}, effect});
        return true;
    }
    like->effect = std::min(like->effect, effect);
    if (like->sentence == sentence) {
        like->years.push_back(period);
    } else if (share->percent > departing_share(like->sentence)->percent) {
        like->years_of_less.insert(like->years_of_less.end(), like->years.begin(), like->years.end());
        like->sentence = sentence;
        like->years = {period};
    } else {
        like->years_of_less.push_back(period);
    }
    return true;
}

void SharedWarnings::add(std::vector<Entry>& entries, double years, const std::string& sentence,
                         config::Effect effect) {
    const std::string period = config::to_text(years);
    if (add_departures(entries, period, sentence, effect)) {
        return;
    }
    const auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return without_figures_of_unreached(entry.sentence) == without_figures_of_unreached(sentence);
    });
    if (same == entries.end()) {
        entries.push_back({sentence, {period}, effect});
        return;
    }
    if (same->sentence != sentence) {
        same->sentence = std::string{without_figures_of_unreached(sentence)};
    }
    same->years.push_back(period);
    same->effect = std::min(same->effect, effect);  // the first of them is the gravest
}

void SharedWarnings::add(double years, const config::Warnings& warnings) {
    for (std::size_t i = 0; i < warnings.warnings().size(); ++i) {
        if (!is_of_unreached_targets(warnings.warnings()[i])) {
            add(warnings_, years, warnings.warnings()[i], warnings.effects()[i]);
        }
    }
    for (const std::string& sentence : warnings.notes()) {
        if (!is_of_unreached_targets(sentence)) {
            add(notes_, years, sentence, config::Effect::detail);
        }
    }
}

void SharedWarnings::add_to(config::Warnings& warnings) const {
    const auto with_periods = [](const Entry& entry) {
        if (!entry.years_of_less.empty()) {
            return joined(entry.sentence, " (most with return period: ", listed(entry.years),
                          "; also with: ", listed(entry.years_of_less), ")");
        }
        return joined(entry.sentence, entry.years.size() == 1 ? " (return period: " : " (return periods: ",
                      listed(entry.years), ")");
    };
    for (const Entry& entry : warnings_) {
        warnings.add(with_periods(entry), entry.effect);
    }
    for (const Entry& entry : notes_) {
        warnings.add_note(with_periods(entry));
    }
}

}  // namespace coupling::hazard
