#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// So many sites are fitted together at most: distances are held against 300 samples, so that of 16 sites
/// none could be further away than chance allows.
inline constexpr std::size_t most_sites = 15;

/// A site of a calibration as it was read.
struct OpenedSite {
    std::string name;
    std::unique_ptr<Scenario> scenario;
    Site site;
};

/// The scenario of the command and those of calibrate.sites, in this order, all files read and all
/// observations checked. `lead`: moved into the first one. Throws InputError, of sites behind the first one
/// with "site NAME:" in front of the file; also where two are the same site, or where laws of the fall
/// differ.
std::vector<OpenedSite> open_sites(std::unique_ptr<Scenario> lead, config::Warnings& warnings);

/// Names of sites from their scenario files: that of the file, of several sites that of its folder where the
/// file is called scenario.ini. Letters, digits, `-` and `_` alone, all different.
std::vector<std::string> names_of_sites(const std::vector<std::filesystem::path>& scenarios);

/// Seeds of the rocks of each site: the first one has that of the search.
std::uint64_t seed_of_site(std::uint64_t seed, std::size_t site);

/// Inputs of all sites, as results in the folder of the first one name them.
std::vector<InputFile> inputs_of(const std::vector<OpenedSite>& sites);

}  // namespace coupling::calibrate
