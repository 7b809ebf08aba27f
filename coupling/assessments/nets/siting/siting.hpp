#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/nets/siting/candidates.hpp"
#include "coupling/assessments/nets/siting/ranking.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling::siting {

/// A candidate on one slope.
struct CandidateFigures {
    Judged judged;
    std::uint64_t crossing = 0;           ///< rocks that come to the stretch and cross the line before
    std::uint64_t reached = 0;            ///< all rocks that cross it between the ends of the net
    std::optional<BarrierDesign> needed;  ///< what these rocks ask for; of the judged slope the net itself
    double energy_95_kj = 0.0;            ///< of these; NaN: fewer than 20
    double energy_max_kj = 0.0;
};

/// Candidates of a stretch with their designs, which rest on the judged slope, and what they do on each
/// slope.
struct StretchResult {
    SitedStretch sited;
    std::vector<std::size_t> candidates;  ///< numbers, by rising distance
    Ranking ranking;                      ///< places in `candidates`
    /// Of the rocks that come to the stretch on the judged slope.
    std::uint64_t rocks = 0;
    double energy_sum_kj = 0.0;
    double energy_95_kj = 0.0;  ///< NaN: fewer than 20
    double energy_max_kj = 0.0;
};

/// One line: what comes to it piece by piece on each slope, without nets and with those of all stretches.
struct LineResult {
    std::array<std::vector<LineBin>, rockfall::covers> bins;
    std::array<std::vector<LineBin>, rockfall::covers> left;
};

/// Where works are needed along lines, and which.
struct SitingResults {
    std::filesystem::path run;
    PathsHead paths;  ///< of its stored paths
    std::vector<ProtectedLine> lines;
    std::vector<LineResult> by_line;
    std::vector<StretchResult> stretches;
    std::vector<Candidate> candidates;
    std::vector<std::array<CandidateFigures, rockfall::covers>> figures;  ///< by candidate
    std::vector<NetRecord> nets;                                          ///< the best of each stretch
    std::vector<std::optional<std::size_t>> net_of_stretch;               ///< number in `nets`
    rockfall::Cover judged = rockfall::Cover::bare;
    NetWish wish;
    bool with_forest = false;
    std::array<std::uint64_t, rockfall::covers> rocks{};
    config::GridFrame frame;  ///< of the map, in coordinates of the terrain
    config::Raster<float> ways;
    std::vector<std::string> remarks;
};

/// What is asked.
struct SitingRequest {
    std::vector<double> distances_m;
    std::optional<double> azimuth_deg;
    std::span<const rockfall::Target> houses{};  ///< through which no net can run
};

/// Reads the stored paths three times: who comes to the lines, past which candidates, and what nets leave.
SitingResults site_nets(NetPathsReader& paths, std::vector<ProtectedLine> lines,
                        const SitingRequest& request);

/// A line for the screen for each line to protect and each stretch.
std::vector<std::string> in_words(const SitingResults& results);

/// net_stretches.csv, net_candidates.csv and net_along.csv.
std::vector<TableLayout> siting_layouts();

/// Writes net_stretches.csv, net_candidates.csv, net_along.csv, net_place.gpkg and report.html, and nets.csv
/// with the best net of each stretch where `with_nets`.
void write_siting(const SitingResults& results, const rockfall::Terrain& terrain, ShortRun& folder,
                  bool with_nets);

}  // namespace coupling::siting
