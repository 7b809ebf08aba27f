#include "coupling/assessments/hazard/shared_warnings.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::hazard {

using config::joined;

void SharedWarnings::add(std::vector<Entry>& entries, double years, const std::string& sentence,
                         config::Effect effect) {
    const auto known = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.sentence == sentence; });
    if (known == entries.end()) {
        entries.push_back({sentence, config::to_text(years), 1, effect});
    } else {
        known->years += joined(", ", config::to_text(years));
        ++known->periods;
    }
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
        return joined(entry.sentence,
                      entry.periods == 1 ? " (return period: " : " (return periods: ", entry.years, ")");
    };
    for (const Entry& entry : warnings_) {
        warnings.add(with_periods(entry), entry.effect);
    }
    for (const Entry& entry : notes_) {
        warnings.add_note(with_periods(entry));
    }
}

}  // namespace coupling::hazard
