#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"

namespace coupling::hazard {

/// Warnings and notes of several return periods, each once with the periods that it came from. Those that say
/// the same with other figures are joined, too: the sentence of the longest period stands for all, and names
/// the others, whose figures stand on their pages. What stands in quotes has to be equal.
class SharedWarnings {
public:
    /// By rising return period.
    void add(double years, const config::Warnings& warnings);
    void add_to(config::Warnings& warnings) const;

private:
    struct Entry {
        std::string sentence;
        std::string kind;                        ///< the sentence without its figures
        std::vector<std::string> years;          ///< periods with this very sentence
        std::vector<std::string> other_figures;  ///< periods in which it has other figures
        config::Effect effect;
    };
    static void add(std::vector<Entry>& entries, double years, const std::string& sentence,
                    config::Effect effect);

    std::vector<Entry> warnings_;
    std::vector<Entry> notes_;
};

}  // namespace coupling::hazard
