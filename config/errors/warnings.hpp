#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace config {

/// What is only suspicious: the run goes on, and the results carry the sentence.
class Warnings {
public:
    /// What the user should look at; stands before all notes.
    void add(std::string sentence) {
        sentences_.insert(sentences_.begin() + static_cast<std::ptrdiff_t>(doubts_++), std::move(sentence));
    }
    /// What the program assumed or filled in: worth knowing, seldom wrong.
    void add_note(std::string sentence) { sentences_.push_back(std::move(sentence)); }
    /// Doubts first, then notes, each in the order they were added.
    [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::vector<std::string> sentences_;
    std::size_t doubts_ = 0;
};

}  // namespace config
