#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/figures/indicators.hpp"

namespace coupling::models {

/// Which figure of a run of today: the same key under two models means the same thing.
struct FigureKey {
    double return_period_years = 0.0;  ///< of a hazard map; 0: none
    std::string about{};               ///< "target", "slope" or "net"
    std::string id{};                  ///< of the target, name of the net; empty for the slope
    std::string name{};                ///< of the target or net, for people
    std::string cover{};               ///< "forest", "bare", or empty: of both, such as what the forest stops
    std::string quantity{};            ///< with its unit at the end: "energy_kj"
    std::string statistic{};           ///< "mean", "p95", "max"; empty for shares and designs

    friend bool operator==(const FigureKey&, const FigureKey&) = default;
};

/// A figure of one model; NaN where it is not known.
struct Figure {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    double value = unknown;
    Interval of_rocks{unknown, unknown};  ///< 95 %, the chance in the rocks alone
    Interval of_all{unknown, unknown};    ///< 95 %, with what is not known of ground and trees
};

/// A figure under each model.
struct ModelFigure {
    FigureKey key;
    std::vector<Figure> by_model;
};

/// Level of a hazard map at a target, under each model; empty where a run has none.
struct LevelOfModels {
    std::string id;
    std::string name;
    std::string cover;  ///< "forest" or "bare"
    std::vector<std::string> by_model;
};

/// What field cases judge of a figure, as in model_verdicts.csv: "stops", "speed", "height", "energy"; empty
/// for what none of them judges, such as the share that a forest or a net stops.
std::string judged_quantity(const FigureKey& key);

/// The figures of runs of today, one folder a model: from their summary.json, of nets from tables/nets.csv.
/// A protection effect from too few rocks is not known, by the rule of the run's own page. Throws
/// config::InputError for a folder without finished results and for files that no run wrote.
std::vector<ModelFigure> read_figures(std::span<const std::filesystem::path> folders,
                                      double return_period_years);

/// Levels at the targets, from the summary.json of hazard maps, one folder a model.
std::vector<LevelOfModels> read_levels(std::span<const std::filesystem::path> folders);

}  // namespace coupling::models
