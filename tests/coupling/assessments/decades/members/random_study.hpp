#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::decades {

/// A study that is run for a few years and then for more, with settings drawn at random.
struct RandomStudy {
    std::vector<std::string> settings;     ///< of both runs
    std::vector<std::string> first_lists;  ///< lists and maps of the shorter run, and
    std::vector<std::string> lists;        ///< of the longer one
    int first = 0;                         ///< years of the shorter run
    int more = 0;
    std::size_t members = 0;
    bool goes_on = true;  ///< the longer run can go on from the shorter one

    [[nodiscard]] std::vector<std::string> shorter() const { return with(first, first_lists); }
    [[nodiscard]] std::vector<std::string> longer() const { return with(first + more, lists); }
    [[nodiscard]] std::string in_words() const {
        std::string text = std::to_string(first) + " and " + std::to_string(more) + " years:";
        for (const std::string& setting : longer()) {
            text += "\n  " + setting;
        }
        return text;
    }

private:
    [[nodiscard]] std::vector<std::string> with(int years, const std::vector<std::string>& also) const {
        std::vector<std::string> both = settings;
        both.push_back("run.years=" + std::to_string(years));
        both.insert(both.end(), also.begin(), also.end());
        return both;
    }
};

/// Regimes and climates that the studies name.
inline void write_random_study_files(const ForestProject& project) {
    project.write(
        "gaps.csv",
        "name,treatment,first_year,every_years,side_m,area_share,where,after,after_years,fence_years,"
        "species,plants_pha\n"
        "gaps,group_cut,1,3,20,0.2,,,,,,\nfences,fence,,,,,cuts_of:gaps,,,10,,\n"
        "plants,plant,,,,,cuts_of:gaps,,1,,abal,2500\n");
    project.write("strips.csv",
                  "name,treatment,first_year,every_years,last_year,after,after_years,where,entries,width_m,"
                  "angle_deg,share\n"
                  "opening,shelter_cut,0,2,6,,,strips,3,30,0,0.4\n"
                  "clearance,clear_cut,,,,opening,3,,,,,\n");
    project.write(
        "climates.csv",
        "name,temperature_change_k,precipitation_change,change_years\nas_it_was,0,1,\nslowly,3,0.9,6\n");
}

inline RandomStudy random_study(std::uint32_t seed) {
    std::mt19937 engine{seed};
    const auto below = [&](std::uint32_t count) { return static_cast<int>(engine() % count); };
    const auto one_of = [&](const std::vector<std::string>& choices) {
        return choices[static_cast<std::size_t>(below(static_cast<std::uint32_t>(choices.size())))];
    };
    RandomStudy study;
    study.first = 1 + below(5);
    study.more = 1 + below(3);
    const int every = std::vector<int>{0, 1, 1, 3, 10}[static_cast<std::size_t>(below(5))];
    const bool feedback = every == 1 && below(3) > 0;
    const int spin_up = std::vector<int>{0, 0, 1, 5}[static_cast<std::size_t>(below(4))];
    const std::string regimes = one_of({"gaps.csv", "strips.csv", "gaps.csv, strips.csv"});
    const bool variants = below(3) == 0;
    study.members = (regimes.find(',') != std::string::npos ? 2U : 1U) * (variants ? 2U : 1U) * 2U;
    study.settings = {"trees.file=",
                      "stands.records=records.csv",
                      "release.rocks=100",
                      "run.replicates=2",
                      "output.all_removed_trees=yes",
                      "run.rockfall_every=" + std::to_string(every),
                      "stands.spin_up_years=" + std::to_string(spin_up),
                      "regimes.list=" + regimes,
                      "climate.sequence=" + one_of({"once", "repeat", "random"})};
    const auto add = [&](const std::vector<std::string>& more) {
        study.settings.insert(study.settings.end(), more.begin(), more.end());
    };
    if (variants) {
        add({"climate.variants=climates.csv"});
    } else if (below(2) == 0) {
        add({"climate.temperature_change_k=2", "climate.change_years=" + std::to_string(below(8))});
    }
    if (feedback) {
        add({"feedback.on=yes", "feedback.rocks_per_year=80"});
    }
    if (below(2) == 0) {
        add({"disturbance.wind=yes", "disturbance.storm_interval=2", "disturbance.snow=yes",
             "disturbance.beetle=yes", "disturbance.beetle_background=0.3"});
    }
    if (below(3) == 0) {
        add({"climate.dry_years=2002, 2006", "disturbance.storm_years=2003"});
    }
    const bool has_rocks_as_the_last_year = every > 0 && study.first % every != 0;
    study.goes_on = spin_up <= study.first && !has_rocks_as_the_last_year;
    switch (below(4)) {
        case 0:
            study.first_lists = {"output.tree_list_years=0, 1", "output.map_years=1"};
            study.lists = {"output.tree_list_years=1, " + std::to_string(study.first + 1),
                           "output.map_years=1, " + std::to_string(study.first + study.more)};
            break;
        case 1:  // a map of a year that the shorter run has without
            study.lists = {"output.map_years=1"};
            study.goes_on = study.goes_on && study.first == 1;
            break;
        default:  // the first year and the last
            break;
    }
    return study;
}

}  // namespace coupling::decades
