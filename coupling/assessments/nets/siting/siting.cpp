#include "coupling/assessments/nets/siting/siting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/assessments/nets/figures/site_for_maps.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::siting {
namespace {

using config::j_per_kj;
using config::joined;
using rockfall::Cover;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<Cover, rockfall::covers> both_covers{Cover::forest, Cover::bare};

std::size_t number_of(Cover cover) {
    return static_cast<std::size_t>(cover);
}

double percentile_95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return percentile_is_known(values.size(), 95) ? quantile_of(values, 0.95).value : nan;
}

void add_stretches(SitingResults& results, const LineWatch& arrivals, const SitingRequest& request,
                   const rockfall::Terrain& terrain) {
    for (std::uint32_t line = 0; line < results.lines.size(); ++line) {
        const auto& bins = results.by_line[line].bins[number_of(results.judged)];
        for (const Stretch& stretch : needed_stretches(bins, results.wish.share)) {
            StretchResult& found = results.stretches.emplace_back();
            found.sited = {line, stretch,
                           request.azimuth_deg
                               ? std::optional{uphill_along(*request.azimuth_deg)}
                               : uphill_of(results.lines[line], stretch, arrivals.of(line), terrain)};
            std::vector<double> energies_kj;
            for (const LineArrival& arrival : arrivals.of(line).by_cover[number_of(results.judged)]) {
                if (arrival.along_m >= stretch.from_m && arrival.along_m <= stretch.to_m) {
                    energies_kj.push_back(arrival.energy_kj);
                    found.energy_sum_kj += arrival.energy_kj;
                    found.energy_max_kj = std::max(found.energy_max_kj, arrival.energy_kj);
                }
            }
            found.rocks = energies_kj.size();
            found.energy_95_kj = percentile_95(std::move(energies_kj));
        }
    }
}

void add_candidates(SitingResults& results, const SitingRequest& request, const rockfall::Terrain& terrain) {
    for (std::uint32_t i = 0; i < results.stretches.size(); ++i) {
        StretchResult& stretch = results.stretches[i];
        std::vector<std::string> left_out;
        for (const double distance_m : request.distances_m) {
            auto candidate = candidate_at(results.lines[stretch.sited.line], stretch.sited, distance_m,
                                          terrain, request.houses);
            if (!candidate || meets_itself(candidate->line_m)) {
                left_out.push_back(config::to_text(distance_m));
                continue;
            }
            candidate->stretch = i;
            stretch.candidates.push_back(results.candidates.size());
            results.candidates.push_back(std::move(*candidate));
        }
        if (!left_out.empty()) {
            std::string list;
            for (const std::string& distance : left_out) {
                list += joined(list.empty() ? "" : ", ", distance);
            }
            results.remarks.push_back(joined(
                results.lines[stretch.sited.line].name, ", ", config::to_text(stretch.sited.stretch.from_m),
                "-", report::fixed(stretch.sited.stretch.to_m, 0), " m: ",
                stretch.sited.uphill
                    ? joined(
                          "no candidate ", list,
                          " m upslope: its line would leave the terrain, cross itself or run through a house")
                    : "no way is upslope: no rock comes from a common direction and the ground is "
                      "level; --azimuth gives one"));
        }
    }
}

CandidateFigures figures_of(const Candidate& candidate, const std::optional<NetDesign>& net,
                            const Passing& passing, const NetWish& wish) {
    CandidateFigures figures;
    figures.judged.distance_m = candidate.distance_m;
    figures.judged.net = net;
    figures.crossing = static_cast<std::uint64_t>(
        std::count_if(passing.of_stretch.begin(), passing.of_stretch.end(),
                      [](const CrossingRock& rock) { return !rock.crossings.empty(); }));
    figures.judged.left = left_below(passing.of_stretch, net.value_or(NetDesign{{}, 0.0, -1.0}));
    std::vector<double> energies_kj;
    if (net) {
        const std::vector<Passage> passages = passages_within(passing.all, net->from_m, net->to_m);
        figures.needed = design_barrier(passages, wish.design, wish.strata);
        for (const Passage& rock : passages) {
            energies_kj.push_back(rock.energy_kj);
            figures.energy_max_kj = std::max(figures.energy_max_kj, rock.energy_kj);
        }
    }
    figures.reached = energies_kj.size();
    figures.energy_95_kj = percentile_95(std::move(energies_kj));
    return figures;
}

void judge(SitingResults& results, const CandidateWatch& watch) {
    for (std::size_t i = 0; i < results.candidates.size(); ++i) {
        const Candidate& candidate = results.candidates[i];
        const Passing& judged = watch.of(i, results.judged);
        const std::optional<NetDesign> net =
            design_net(judged.of_stretch, judged.all, results.wish, length_m(candidate.line_m));
        auto& figures = results.figures.emplace_back();
        for (const Cover cover : both_covers) {
            figures[number_of(cover)] = figures_of(candidate, net, watch.of(i, cover), results.wish);
        }
    }
    for (StretchResult& stretch : results.stretches) {
        std::vector<Judged> judged;
        for (const std::size_t candidate : stretch.candidates) {
            judged.push_back(results.figures[candidate][number_of(results.judged)].judged);
        }
        stretch.ranking = rank(judged, results.wish.share);
    }
}

/// The best net of each stretch. Where it would stand in the place of one before it, it begins behind that.
void choose_nets(SitingResults& results) {
    std::vector<std::size_t> of_line(results.lines.size(), 0);
    for (const StretchResult& stretch : results.stretches) {
        results.net_of_stretch.emplace_back();
        const std::size_t number = ++of_line[stretch.sited.line];
        if (!stretch.ranking.best) {
            continue;
        }
        const std::size_t best = stretch.candidates[*stretch.ranking.best];
        const Candidate& candidate = results.candidates[best];
        const NetDesign& net = *results.figures[best][number_of(results.judged)].judged.net;
        NetRecord record{joined(results.lines[stretch.sited.line].name, " ", std::to_string(number)),
                         net.energy_class,
                         {piece_of(candidate.line_m, net.from_m, net.to_m), net.height_m, 0.0,
                          net.capacity_kj * j_per_kj}};
        double from_m = net.from_m;
        const auto in_place_of_another = [&] {
            return std::any_of(results.nets.begin(), results.nets.end(), [&](const NetRecord& other) {
                return length_in_one_place_m(other.net.line_m, record.net.line_m) > 0.0;
            });
        };
        while (in_place_of_another() && from_m + 1.0 < net.to_m) {
            from_m += 1.0;
            record.net.line_m = piece_of(candidate.line_m, from_m, net.to_m);
        }
        if (in_place_of_another()) {
            results.remarks.push_back(joined(record.name,
                                             ": its net would stand where another stands already; "
                                             "it is left out of nets.csv"));
            continue;
        }
        results.net_of_stretch.back() = results.nets.size();
        results.nets.push_back(std::move(record));
    }
}

}  // namespace

SitingResults site_nets(NetPathsReader& paths, std::vector<ProtectedLine> lines,
                        const SitingRequest& request) {
    const PathsHead& head = paths.head();
    const rockfall::Terrain& terrain = paths.terrain();
    SitingResults results;
    results.lines = std::move(lines);
    results.with_forest = head.with_forest;
    results.judged = head.with_forest ? Cover::forest : Cover::bare;
    results.paths = head;
    results.wish = {head.wanted_share, head.design, head.strata.count};
    results.rocks = head.rocks;
    results.frame = map_frame_of(terrain);

    LineWatch arrivals{results.lines, terrain};
    paths.each([&](const StoredPath& path) { arrivals.look(path); });
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        LineResult& of_line = results.by_line.emplace_back();
        for (const Cover cover : both_covers) {
            of_line.bins[number_of(cover)] = bins_along(length_m(results.lines[line].line_m),
                                                        arrivals.of(line).by_cover[number_of(cover)]);
        }
    }
    add_stretches(results, arrivals, request, terrain);
    add_candidates(results, request, terrain);

    std::vector<SitedStretch> sited;
    for (const StretchResult& stretch : results.stretches) {
        sited.push_back(stretch.sited);
    }
    CandidateWatch watch{results.lines, sited, results.candidates, terrain, results.frame, head.strata};
    paths.each([&](const StoredPath& path) { watch.look(path); });
    results.ways = watch.ways(results.judged);
    judge(results, watch);
    choose_nets(results);

    LeftWatch left{results.lines, results.nets, terrain};
    paths.each([&](const StoredPath& path) { left.look(path); });
    for (std::size_t line = 0; line < results.lines.size(); ++line) {
        for (const Cover cover : both_covers) {
            results.by_line[line].left[number_of(cover)] =
                bins_along(length_m(results.lines[line].line_m), left.of(line, cover));
        }
    }
    return results;
}

}  // namespace coupling::siting
