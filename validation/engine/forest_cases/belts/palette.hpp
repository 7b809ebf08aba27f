#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/belts/belt_data.hpp"

namespace coupling::validation::forest_cases::belts {

/// The species by what they make up over all places, greatest first, each with its style: the colours go to
/// the first ones, grey to the others together.
class Palette {
public:
    static constexpr std::size_t colours = 7;

    Palette(const BeltData& data, const std::vector<std::vector<double>>& biomass_tpha) {
        std::vector<double> sums(data.species.size(), 0.0);
        for (const std::vector<double>& site : biomass_tpha) {
            std::transform(site.begin(), site.end(), sums.begin(), sums.begin(), std::plus<>{});
        }
        order_.resize(sums.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
        for (std::size_t rank = 0; rank < std::min(colours, order_.size()); ++rank) {
            names_.push_back(data.species.all()[order_[rank]].latin_name);
        }
        if (order_.size() > colours) {
            names_.emplace_back("other species");
        }
    }

    /// Layers of a stack, the lowest first.
    [[nodiscard]] std::size_t layers() const { return names_.size(); }
    [[nodiscard]] const std::string& name(std::size_t layer) const { return names_[layer]; }
    [[nodiscard]] std::string style(std::size_t layer) const {
        return config::joined("layer", std::to_string(layer));
    }
    /// Figures of all species as those of the layers.
    [[nodiscard]] std::vector<double> layered(const std::vector<double>& by_species) const {
        std::vector<double> sums(layers(), 0.0);
        for (std::size_t rank = 0; rank < order_.size(); ++rank) {
            sums[std::min(rank, layers() - 1)] += by_species[order_[rank]];
        }
        return sums;
    }

private:
    std::vector<std::size_t> order_;
    std::vector<std::string> names_;
};

}  // namespace coupling::validation::forest_cases::belts
