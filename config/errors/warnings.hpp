#pragma once

#include <string>
#include <vector>

namespace config {

/// What is only suspicious: the run goes on, and the results carry the sentence.
class Warnings {
public:
    void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
    [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::vector<std::string> sentences_;
};

}  // namespace config
