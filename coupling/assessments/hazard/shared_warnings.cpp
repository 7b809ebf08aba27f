#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <algorithm>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::hazard {

using config::joined;

namespace {

/// A sentence with each number outside quotes replaced by '#'.
std::string without_figures(const std::string& sentence) {
    std::string kind;
    bool in_quotes = false;
    for (const char c : sentence) {
        in_quotes = in_quotes != (c == '\'');
        const bool after_figure = !in_quotes && kind.ends_with('#');
        const bool is_digit = c >= '0' && c <= '9';
        if (in_quotes || !(is_digit || (after_figure && c == '.'))) {
            kind += c;
        } else if (!after_figure) {
            kind += '#';
        }
    }
    return kind;
}

/// Numbers of zones and names tell things apart: of such sentences none stands for another.
bool names_something(const std::string& sentence) {
    return sentence.find("zone") != sentence.npos || sentence.find('\'') != sentence.npos;
}

std::string listed(const std::vector<std::string>& years) {
    std::string text;
    for (const std::string& one : years) {
        text += joined(text.empty() ? "" : ", ", one);
    }
    return text;
}

}  // namespace

void SharedWarnings::add(std::vector<Entry>& entries, double years, const std::string& sentence,
                         config::Effect effect) {
    const std::string period = config::to_text(years);
    const auto same = std::find_if(entries.begin(), entries.end(),
                                   [&](const Entry& entry) { return entry.sentence == sentence; });
    if (same != entries.end()) {
        same->years.push_back(period);
        return;
    }
    std::string kind = without_figures(sentence);
    const auto alike = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return !names_something(sentence) && entry.kind == kind && entry.years.back() != period;
    });
    if (alike == entries.end()) {
        entries.push_back({sentence, std::move(kind), {period}, {}, effect});
        return;
    }
    alike->sentence = sentence;
    alike->other_figures.insert(alike->other_figures.end(), alike->years.begin(), alike->years.end());
    alike->years = {period};
}

void SharedWarnings::add(double years, const config::Warnings& warnings) {
    for (std::size_t i = 0; i < warnings.warnings().size(); ++i) {
        add(warnings_, years, warnings.warnings()[i], warnings.effects()[i]);
    }
    for (const std::string& sentence : warnings.notes()) {
        add(notes_, years, sentence, config::Effect::detail);
    }
}

void SharedWarnings::add_to(config::Warnings& warnings) const {
    const auto with_periods = [](const Entry& entry) {
        const std::string others = entry.other_figures.empty()
                                       ? std::string{}
                                       : joined("; with other figures also: ", listed(entry.other_figures));
        return joined(entry.sentence, entry.years.size() == 1 ? " (return period: " : " (return periods: ",
                      listed(entry.years), others, ")");
    };
    for (const Entry& entry : warnings_) {
        warnings.add(with_periods(entry), entry.effect);
    }
    for (const Entry& entry : notes_) {
        warnings.add_note(with_periods(entry));
    }
}

}  // namespace coupling::hazard
