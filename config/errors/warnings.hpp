#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace config {

/// What a warning may do to the answer; the largest effect is printed first.
enum class Effect {
    answer,  ///< the answer itself may be wrong: a wrong terrain, sources in the wrong place
    part,    ///< a part of the input or of the result is affected
    detail,  ///< a figure or a sentence beside the answer
};

/// What the user should know although the run goes on. A warning may change what the results mean and stands
/// where the answer stands; a note says how an input was understood and stands behind the results.
class Warnings {
public:
    /// What is suspicious. Warnings of the same effect keep their order.
    void add(std::string sentence, Effect effect = Effect::part) {
        if (!known_.insert(sentence).second) {
            return;
        }
        const auto behind = std::upper_bound(effects_.begin(), effects_.end(), effect);
        warnings_.insert(warnings_.begin() + (behind - effects_.begin()), std::move(sentence));
        effects_.insert(behind, effect);
    }
    /// What was assumed, filled in or understood: seldom wrong.
    void add_note(std::string sentence) {
        if (known_.insert(sentence).second) {
            notes_.push_back(std::move(sentence));
        }
    }

    /// The largest effect first.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// The effect of each of `warnings()`.
    [[nodiscard]] const std::vector<Effect>& effects() const { return effects_; }
    /// In the order in which they were added.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    /// Warnings, then notes.
    [[nodiscard]] std::vector<std::string> all() const {
        std::vector<std::string> all = warnings_;
        all.insert(all.end(), notes_.begin(), notes_.end());
        return all;
    }

private:
    std::vector<std::string> warnings_;
    std::vector<Effect> effects_;
    std::vector<std::string> notes_;
    std::set<std::string> known_;
};

}  // namespace config
