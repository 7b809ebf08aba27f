#pragma once

#include <string>
#include <vector>

namespace coupling::validation {

/// Sources in the order of their first mention, each with one number however often it is cited.
class Notes {
public:
    /// The number as a raised sign with the source as its tooltip; empty for an empty source.
    std::string cite(const std::string& source);
    /// The numbered list; empty without sources.
    [[nodiscard]] std::string html() const;

private:
    std::vector<std::string> sources_;
};

}  // namespace coupling::validation
