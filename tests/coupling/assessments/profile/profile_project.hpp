#pragma once

#include <string>

#include "coupling/assessments/profile/falls/profile_site.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// A project along a profile: 40 deg, a road, 30 deg, flat; two ground types of its own and a shipped one.
inline void make_profile_project(const SampleProject& project) {
    for (const char* name : {"dem.asc", "dem.prj", "surface.asc", "source.asc", "trees.csv", "targets.csv"}) {
        project.remove(name);
    }
    project.write("scenario.ini",
                  "[terrain]\nprofile = profile.csv\nsurface_types = surface_types.csv\n"
                  "[profile]\nstations = stations.csv\n"
                  "[release]\nrocks = 500\ndiameter_m = 0.95\n");
    project.write("profile.csv",
                  "distance_m,height_m,surface\n0,500,1\n100,416,road\n104,416,3\n240,337.5,3\n300,337.5,\n");
    project.write("stations.csv", "name,distance_m\nroad,102\nfoot,240\n");
}

/// The site of a project, or what is wrong with it, without the temporary folder.
struct OpenedProfile {
    std::unique_ptr<Scenario> scenario;
    std::unique_ptr<profile::ProfileSite> site;
    config::Warnings warnings;
    std::string errors;
};

inline OpenedProfile open_profile_of(const SampleProject& project,
                                     const std::vector<std::string>& overrides = {}) {
    OpenedProfile opened;
    try {
        opened.scenario = read_scenario(project.file("scenario.ini"), overrides);
        opened.site =
            std::make_unique<profile::ProfileSite>(profile::open_profile(*opened.scenario, opened.warnings));
    } catch (const config::InputError& error) {
        for (const config::Problem& problem : error.problems()) {
            opened.errors += config::to_string(problem) + "\n";
        }
    }
    return opened;
}

}  // namespace coupling
