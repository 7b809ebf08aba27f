#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
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

/// A warning of rocks that leave the terrain: their share, and on which slope.
struct Leaving {
    double percent = 0.0;
    std::string_view slope{};
};

std::optional<Leaving> leaving_in(std::string_view sentence) {
    constexpr std::string_view words = " % of the rocks leave the terrain ";
    const std::size_t at = sentence.find(words);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<double> percent = config::parse_number(std::string{sentence.substr(0, at)});
    const std::string_view rest = sentence.substr(at + words.size());
    return percent ? std::optional{Leaving{*percent, rest.substr(0, rest.find(" ("))}} : std::nullopt;
}

}  // namespace

void SharedWarnings::add(std::vector<Entry>& entries, double years, const std::string& sentence,
                         config::Effect effect) {
    const std::string period = config::to_text(years);
    // Of rocks that leave the terrain the return period that loses most of them says it for all.
    if (const auto leaving = leaving_in(sentence)) {
        for (Entry& entry : entries) {
            const auto before = leaving_in(entry.sentence);
            if (before && before->slope == leaving->slope && entry.sentence != sentence) {
                if (leaving->percent > before->percent) {
                    entry = {sentence, {period}, std::min(entry.effect, effect)};
                }
                return;
            }
        }
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
