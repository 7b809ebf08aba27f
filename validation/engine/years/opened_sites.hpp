#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "validation/engine/case/case_files.hpp"

namespace coupling::validation::years {

/// The scenario at one site, opened.
struct OpenedSite {
    std::string name;
    std::unique_ptr<Scenario> scenario;
    Site site;
    decades::Management management;
};

/// Tables that every case over years may have: its sites, a species table of its own, groups of species that
/// stand out at a site.
inline constexpr const char* sites_file = "sites.csv";
inline constexpr const char* species_file = "species.csv";
inline constexpr const char* groups_file = "expected.csv";
std::vector<std::string> group_columns();

/// A scenario of the folder at each row of sites.csv. `warnings`: of any of them. Throws InputError.
std::vector<OpenedSite> open_sites(const CaseFiles& files, const std::string& scenario_file,
                                   const std::vector<std::string>& overrides, config::Warnings& warnings);

}  // namespace coupling::validation::years
