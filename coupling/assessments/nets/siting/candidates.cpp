#include "coupling/assessments/nets/siting/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/places/line_through.hpp"

namespace coupling::siting {
namespace {

using config::j_per_kj;

/// Length of the mean of unit vectors below which rocks come from no common direction [choice].
constexpr double least_in_common = 0.2;

rockfall::NetIndex index_of_lines(std::vector<std::vector<Eigen::Vector2d>> lines) {
    std::vector<NetRecord> records;
    for (auto& line : lines) {
        records.push_back({"", "", {std::move(line), 1.0, 0.0, j_per_kj}});
    }
    return lines_alone(records);
}

rockfall::NetIndex net_index_of(std::span<const ProtectedLine> lines) {
    std::vector<std::vector<Eigen::Vector2d>> corners;
    for (const ProtectedLine& line : lines) {
        corners.push_back(line.line_m);
    }
    return index_of_lines(std::move(corners));
}

rockfall::NetIndex net_index_of(std::span<const Candidate> candidates) {
    std::vector<std::vector<Eigen::Vector2d>> corners;
    for (const Candidate& candidate : candidates) {
        corners.push_back(candidate.line_m);
    }
    return index_of_lines(std::move(corners));
}

double energy_kj(const NetRow& row) {
    return static_cast<double>(row.crossing.energy_j) / j_per_kj;
}

bool lies_on(double along_m, const Stretch& stretch) {
    return along_m >= stretch.from_m && along_m <= stretch.to_m;
}

/// A rock that comes to a line for the first time.
struct FirstArrival {
    std::uint32_t line;
    double along_m;
    double energy_kj;
    std::pair<std::size_t, double> when;
    std::size_t piece;
};

std::vector<FirstArrival> first_arrivals(const rockfall::NetIndex& lines, const rockfall::Terrain& terrain,
                                         const StoredPath& path) {
    TriedNets tried;
    try_nets(lines, terrain, path, tried);
    std::vector<FirstArrival> found;
    for (std::size_t i = 0; i < tried.rows.size(); ++i) {
        const NetRow& row = tried.rows[i];
        if (row.crossing.first) {
            found.push_back({row.crossing.net, static_cast<double>(row.crossing.along_m), energy_kj(row),
                             tried.when[i], tried.when[i].first});
        }
    }
    return found;
}

}  // namespace

std::optional<Candidate> candidate_at(const ProtectedLine& line, const SitedStretch& stretch,
                                      double distance_m, const rockfall::Terrain& terrain,
                                      std::span<const rockfall::Target> houses) {
    if (!stretch.uphill) {
        return std::nullopt;
    }
    for (const double beside_m : {distance_m, 0.5 * distance_m, 0.25 * distance_m, 0.0}) {
        Candidate candidate{
            0, distance_m,
            piece_of(line.line_m, stretch.stretch.from_m - beside_m, stretch.stretch.to_m + beside_m),
            stretch.stretch.from_m - beside_m};
        for (Eigen::Vector2d& corner : candidate.line_m) {
            corner += distance_m * stretch.uphill->direction;
        }
        if (!first_place_off_ground({candidate.line_m, 1.0, 0.0, 1.0}, terrain) &&
            targets_under(candidate.line_m, houses, runs_over).empty()) {
            return candidate;
        }
    }
    return std::nullopt;
}

LineWatch::LineWatch(std::span<const ProtectedLine> lines, const rockfall::Terrain& terrain)
    : terrain_{terrain}, index_{net_index_of(lines)}, arrivals_(lines.size()) {}

void LineWatch::look(const StoredPath& path) {
    const auto cover = static_cast<std::size_t>(path.cover);
    for (const FirstArrival& arrival : first_arrivals(index_, terrain_, path)) {
        const StoredPiece& piece = path.pieces[arrival.piece];
        const Eigen::Vector3d way = piece.flies ? piece.other : Eigen::Vector3d{piece.other - piece.start_m};
        arrivals_[arrival.line].by_cover[cover].push_back({arrival.along_m, arrival.energy_kj});
        const Eigen::Vector2d in_plan = way.head<2>();
        arrivals_[arrival.line].directions[cover].push_back(in_plan.norm() > 0.0 ? in_plan.normalized()
                                                                                 : Eigen::Vector2d::Zero());
    }
}

CandidateWatch::CandidateWatch(std::span<const ProtectedLine> lines, std::span<const SitedStretch> stretches,
                               std::span<const Candidate> candidates, const rockfall::Terrain& terrain,
                               const config::GridFrame& frame, const rockfall::Strata& strata)
    : stretches_{stretches},
      candidates_{candidates},
      terrain_{terrain},
      strata_{strata},
      lines_{net_index_of(lines)},
      index_{net_index_of(candidates)},
      passing_(candidates.size()),
      ways_{config::Raster<float>{frame, std::numeric_limits<float>::quiet_NaN()},
            config::Raster<float>{frame, std::numeric_limits<float>::quiet_NaN()}},
      last_path_{frame, 0} {}

void CandidateWatch::look(const StoredPath& path) {
    ++paths_;
    const auto cover = static_cast<std::size_t>(path.cover);
    const std::vector<FirstArrival> arrivals = first_arrivals(lines_, terrain_, path);
    TriedNets tried;
    try_nets(index_, terrain_, path, tried);
    for (const NetRow& row : tried.rows) {
        passing_[row.crossing.net][cover].all.push_back({paths_, row.crossing.along_m, row.crossing.energy_j,
                                                         row.crossing.height_m, row.crossing.radius_m,
                                                         strata_.of(path.rock)});
    }
    for (const FirstArrival& arrival : arrivals) {
        mark_way(path, arrival.when);
        for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
            const SitedStretch& stretch = stretches_[candidates_[i].stretch];
            if (stretch.line != arrival.line || !lies_on(arrival.along_m, stretch.stretch)) {
                continue;
            }
            CrossingRock& rock =
                passing_[i][cover].of_stretch.emplace_back(CrossingRock{{}, arrival.energy_kj});
            for (std::size_t k = 0; k < tried.rows.size() && tried.when[k] <= arrival.when; ++k) {
                const NetRow& row = tried.rows[k];
                if (row.crossing.net == i) {
                    rock.crossings.push_back({static_cast<double>(row.crossing.along_m),
                                              static_cast<double>(row.crossing.height_m), energy_kj(row)});
                }
            }
        }
    }
}

void CandidateWatch::mark_way(const StoredPath& path, std::pair<std::size_t, double> until) {
    config::Raster<float>& ways = ways_[static_cast<std::size_t>(path.cover)];
    const config::GridFrame& frame = ways.frame;
    const double step_m = 0.5 * std::min(frame.cell_width_m, frame.cell_height_m);
    for (std::size_t i = 0; i <= until.first && i < path.pieces.size(); ++i) {
        const StoredPiece& piece = path.pieces[i];
        const Eigen::Vector2d from = piece.start_m.head<2>();
        Eigen::Vector2d way = piece.flies ? Eigen::Vector2d{piece.first * piece.other.head<2>()}
                                          : Eigen::Vector2d{piece.other.head<2>() - from};
        if (i == until.first) {  // seconds of a flight, share of a way on the ground
            way = piece.flies ? Eigen::Vector2d{until.second * piece.other.head<2>()}
                              : Eigen::Vector2d{until.second * way};
        }
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / step_m)));
        for (int k = 0; k <= steps; ++k) {
            const Eigen::Vector2d place = from + static_cast<double>(k) / steps * way;
            const config::Cell cell = frame.cell_at(place.x(), place.y());
            if (frame.contains(cell) && last_path_.at(cell) != paths_) {
                last_path_.at(cell) = paths_;
                float& count = ways.at(cell);
                count = std::isnan(count) ? 1.0F : count + 1.0F;
            }
        }
    }
}

LeftWatch::LeftWatch(std::span<const ProtectedLine> lines, std::span<const NetRecord> nets,
                     const rockfall::Terrain& terrain)
    : terrain_{terrain}, lines_{net_index_of(lines)}, left_(lines.size()) {
    std::vector<rockfall::Net> walls;
    for (const NetRecord& record : nets) {
        walls.push_back(record.net);
    }
    nets_ = rockfall::NetIndex{walls};
}

void LeftWatch::look(const StoredPath& path) {
    TriedNets tried;
    try_nets(nets_, terrain_, path, tried);
    const bool held = !tried.rows.empty() && tried.rows.back().crossing.outcome == rockfall::NetOutcome::held;
    for (const FirstArrival& arrival : first_arrivals(lines_, terrain_, path)) {
        if (!held || tried.when.back() > arrival.when) {
            left_[arrival.line][static_cast<std::size_t>(path.cover)].push_back(
                {arrival.along_m, arrival.energy_kj});
        }
    }
}

std::optional<Uphill> uphill_of(const ProtectedLine& line, const Stretch& stretch, const Arrivals& arrivals,
                                const rockfall::Terrain& terrain) {
    for (const rockfall::Cover cover : {rockfall::Cover::forest, rockfall::Cover::bare}) {
        const auto c = static_cast<std::size_t>(cover);
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        std::uint64_t rocks = 0;
        for (std::size_t i = 0; i < arrivals.by_cover[c].size(); ++i) {
            if (lies_on(arrivals.by_cover[c][i].along_m, stretch)) {
                sum += arrivals.directions[c][i];
                ++rocks;
            }
        }
        if (rocks > 0 && sum.norm() >= least_in_common * static_cast<double>(rocks)) {
            return Uphill{-sum.normalized(), Uphill::From::rocks, rocks};
        }
    }
    const rockfall::Net piece{piece_of(line.line_m, stretch.from_m, stretch.to_m), 1.0, 0.0, 1.0};
    const auto gradient = uphill_across(piece, terrain);
    return gradient ? std::optional{Uphill{*gradient, Uphill::From::gradient}} : std::nullopt;
}

}  // namespace coupling::siting
