#include "validation/engine/slope/artificial_stand.hpp"

#include <algorithm>
#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"

namespace coupling::validation {

namespace {

/// DBHs of n trees: quantiles of the gamma distribution at equal steps.
std::vector<double> diameters_cm(const Recipe& recipe, std::size_t trees) {
    std::vector<double> diameters(trees, recipe.dbh_mean_cm);
    if (recipe.dbh_deviation_cm <= 0.0) {
        return diameters;
    }
    const double variation = recipe.dbh_deviation_cm / recipe.dbh_mean_cm;
    const double shape = 1.0 / (variation * variation);
    const double scale = recipe.dbh_mean_cm / shape;
    constexpr double thinnest_cm = 1.0;
    for (std::size_t i = 0; i < trees; ++i) {
        const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(trees);
        diameters[i] = std::max(thinnest_cm, config::gamma(u, shape, scale));
    }
    return diameters;
}

/// Fisher and Yates.
void shuffle(std::vector<double>& values, config::RandomStream& stream) {
    for (std::size_t i = values.size(); i > 1; --i) {
        const auto j = static_cast<std::size_t>(stream.uniform() * static_cast<double>(i));
        std::swap(values[i - 1], values[j]);
    }
}

/// Places that keep a distance from each other, found by a grid of cells of that distance.
class Places {
public:
    Places(const StandArea& area, double spacing_m)
        : area_{area}, spacing_m_{spacing_m}, cell_m_{std::max(spacing_m, 0.25)} {
        columns_ = static_cast<std::size_t>((area.to_m - area.from_m) / cell_m_) + 1;
        rows_ = static_cast<std::size_t>(area.width_m / cell_m_) + 1;
        cells_.resize(columns_ * rows_);
    }

    Eigen::Vector2d draw(config::RandomStream& stream) {
        constexpr int most_tries = 100'000;
        for (int i = 0; i < most_tries; ++i) {
            const double u = stream.uniform();
            const double v = stream.uniform();
            const Eigen::Vector2d place{area_.from_m + u * (area_.to_m - area_.from_m),
                                        (v - 0.5) * area_.width_m};
            if (is_free(place)) {
                cells_[column(place.x()) + columns_ * row(place.y())].push_back(place);
                return place;
            }
        }
        config::fail(config::ExitCode::settings, {}, "no place left for another tree",
                     "a smaller stand.spacing_m or fewer stems");
    }

private:
    [[nodiscard]] std::size_t column(double x_m) const {
        return static_cast<std::size_t>((x_m - area_.from_m) / cell_m_);
    }
    [[nodiscard]] std::size_t row(double y_m) const {
        return static_cast<std::size_t>((y_m + 0.5 * area_.width_m) / cell_m_);
    }
    [[nodiscard]] bool is_free(const Eigen::Vector2d& place) const {
        const std::size_t c = column(place.x());
        const std::size_t r = row(place.y());
        for (std::size_t j = r == 0 ? 0 : r - 1; j <= std::min(r + 1, rows_ - 1); ++j) {
            for (std::size_t i = c == 0 ? 0 : c - 1; i <= std::min(c + 1, columns_ - 1); ++i) {
                for (const Eigen::Vector2d& other : cells_[i + columns_ * j]) {
                    if ((other - place).squaredNorm() < spacing_m_ * spacing_m_) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    StandArea area_;
    double spacing_m_;
    double cell_m_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<std::vector<Eigen::Vector2d>> cells_;
};

/// Gives each tree to the species that then lacks most basal area.
class SpeciesDealer {
public:
    explicit SpeciesDealer(const std::vector<SpeciesShare>& species)
        : species_{species}, given_(species.size(), 0.0) {}

    std::size_t deal(double dbh_cm) {
        const double basal_area = dbh_cm * dbh_cm;
        all_ += basal_area;
        std::size_t neediest = 0;
        double most = -all_;
        for (std::size_t i = 0; i < species_.size(); ++i) {
            const double lacking = species_[i].share * all_ - given_[i];
            if (lacking > most) {
                most = lacking;
                neediest = i;
            }
        }
        given_[neediest] += basal_area;
        return neediest;
    }

private:
    const std::vector<SpeciesShare>& species_;
    std::vector<double> given_;  ///< sum of squared DBHs
    double all_ = 0.0;
};

}  // namespace

double height_of_dbh_m(double dbh_cm) {
    const double root = dbh_cm / (1.54 + 0.17 * dbh_cm);
    return rockfall::breast_height_m + root * root;
}

ArtificialStands::ArtificialStands(const Recipe& recipe, const StandArea& area)
    : recipe_{recipe},
      area_{area},
      dbhs_cm_{diameters_cm(recipe,
                            static_cast<std::size_t>(std::lround(recipe.stems_per_ha * area.hectares())))} {}

std::vector<ArtificialTree> ArtificialStands::draw(std::uint32_t stand) const {
    config::RandomStream stream{{.seed = recipe_.seed, .replicate = stand}, config::Purpose::stand};
    std::vector<double> dbhs_cm = dbhs_cm_;
    shuffle(dbhs_cm, stream);
    Places places{area_, recipe_.spacing_m};
    SpeciesDealer dealer{recipe_.species};
    std::vector<ArtificialTree> trees;
    trees.reserve(dbhs_cm.size());
    for (const double dbh_cm : dbhs_cm) {
        const Eigen::Vector2d place = places.draw(stream);
        const std::size_t species = dealer.deal(dbh_cm);
        trees.push_back({{place.x(), place.y(), dbh_cm, height_of_dbh_m(dbh_cm),
                          recipe_.species[species].fracture_energy},
                         species});
    }
    return trees;
}

std::vector<rockfall::Stem> stems_of(const std::vector<ArtificialTree>& trees) {
    std::vector<rockfall::Stem> stems;
    stems.reserve(trees.size());
    for (const ArtificialTree& tree : trees) {
        stems.push_back(tree.stem);
    }
    return stems;
}

}  // namespace coupling::validation
