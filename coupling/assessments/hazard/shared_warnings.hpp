#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"

namespace coupling::hazard {

/// Warnings and notes of several return periods, each sentence once with the periods that it came from.
class SharedWarnings {
public:
    void add(double years, const config::Warnings& warnings);
    void add_to(config::Warnings& warnings) const;

private:
    struct Entry {
        std::string sentence;
        std::string years;
        std::size_t periods;
        config::Effect effect;
    };
    static void add(std::vector<Entry>& entries, double years, const std::string& sentence,
                    config::Effect effect);

    std::vector<Entry> warnings_;
    std::vector<Entry> notes_;
};

}  // namespace coupling::hazard
