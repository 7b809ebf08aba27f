#pragma once

#include <string>
#include <vector>

#include "config/errors/warnings.hpp"

namespace coupling::hazard {

/// Warnings and notes of several return periods: equal ones stand once, with the periods that they came from
/// and the gravest of their effects. Such with other figures stay apart: a figure may be a name, and none
/// stands for another. Only of some is it known which figures are no names. Nets that no rock reaches stand
/// once, without these figures where they differ. Of rocks that leave the terrain the worst stands, with its
/// return period and the others that warn of it, too. Targets that no rock of one return period
/// reaches may be reached in another one: the map names those of none (warn_of_unreached).
class SharedWarnings {
public:
    void add(double years, const config::Warnings& warnings);
    void add_to(config::Warnings& warnings) const;

private:
    struct Entry {
        std::string sentence;
        std::vector<std::string> years;  ///< whose sentence this is
        config::Effect effect;
        std::vector<std::string> years_of_less{};  ///< of departures: that warn of a smaller share
    };
    static void add(std::vector<Entry>& entries, double years, const std::string& sentence,
                    config::Effect effect);
    static bool add_departures(std::vector<Entry>& entries, const std::string& period,
                               const std::string& sentence, config::Effect effect);

    std::vector<Entry> warnings_;
    std::vector<Entry> notes_;
};

}  // namespace coupling::hazard
