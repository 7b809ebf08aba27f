#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"

namespace coupling::calibrate {

/// What is known of the parameters of a site before, and of which grounds it has them.
struct SiteParameters {
    std::string name;                                   ///< of the site
    std::string scenario;                               ///< its file, for messages
    std::vector<ParameterDraws::Component> components;  ///< of the site alone
    const std::vector<rockfall::SurfaceType>* types = nullptr;
    std::vector<bool> occurs;        ///< by type
    bool ground_is_guessed = false;  ///< its map of ground types
    double tree_energy_width = 0.0;  ///< without that of derived diameters
};

/// The parameters of several sites together: what describes motion, trees and grounds of the same name is one
/// component for all of them; block sizes, and losses where the map of grounds was guessed, belong to a site.
struct SharedComponents {
    std::vector<ParameterDraws::Component> components;  ///< own ones of a site are named "block_size:north"
    std::vector<std::vector<std::size_t>> places;       ///< by site, by its component
    std::vector<std::vector<std::size_t>> users;        ///< by component: its sites, rising

    /// Those of some of the sites, rising, in the same order and by the same names.
    [[nodiscard]] SharedComponents of(std::span<const std::size_t> sites) const;
    /// Where a component is; `components.size()` where there is none of that name.
    [[nodiscard]] std::size_t find(const std::string& parameter) const;
};

/// Throws InputError (settings) where sites know something else before of what they share, and (data) where
/// a ground type has the name of one of another site, and other values.
SharedComponents share(std::span<const SiteParameters> sites);

/// The first figure in which two ground types differ, with both values; "" where they are the same but for
/// their codes.
std::string difference_of(const rockfall::SurfaceType& one, const rockfall::SurfaceType& other);

}  // namespace coupling::calibrate
