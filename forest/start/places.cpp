#include "forest/start/places.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <queue>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"

namespace forest {

namespace {

constexpr int tries = 30;
constexpr double kept_share_of_spacing = 0.5;
constexpr double trees_per_cluster = 20.0;
constexpr double cluster_radius_m = 6.0;
constexpr double lowest_target = 0.75;
constexpr double highest_target = 1.25;

config::RandomStream stream_of(const PlaceKey& key, std::uint64_t id, config::Purpose purpose) {
    return config::RandomStream{{key.seed, key.replicate, 0, id}, purpose};
}

/// A random point of a patch, never quite on its edge.
Place point_in(const PatchGrid& grid, PatchId patch, config::RandomStream& stream) {
    const auto from_centre_m = [&stream] { return (0.98 * stream.uniform() - 0.49) * patch_side_m; };
    const double dx_m = from_centre_m();
    const double dy_m = from_centre_m();
    return {patch, grid.x_centre_m(patch) + dx_m, grid.y_centre_m(patch) + dy_m};
}

/// Places by patch, to ask how near the next tree stands.
class Neighbours {
public:
    explicit Neighbours(const PatchGrid& grid) : grid_{grid}, on_patch_(grid.size()) {}

    void add(const Place& place) { on_patch_[index_of(place.patch)].push_back(place); }

    /// Squared distance to the nearest one on the patch and those around it, at most that of a patch's side.
    [[nodiscard]] double nearest2_m2(const Place& place) const {
        double nearest = patch_side_m * patch_side_m;
        const config::Cell middle = grid_[place.patch].cell;
        for (int dr = -1; dr <= 1; ++dr) {
            for (int dc = -1; dc <= 1; ++dc) {
                const auto patch = grid_.at(config::Cell{middle.column + dc, middle.row + dr});
                if (!patch) {
                    continue;
                }
                for (const Place& other : on_patch_[index_of(*patch)]) {
                    const double dx = other.x_m - place.x_m;
                    const double dy = other.y_m - place.y_m;
                    nearest = std::min(nearest, dx * dx + dy * dy);
                }
            }
        }
        return nearest;
    }

private:
    const PatchGrid& grid_;
    std::vector<std::vector<Place>> on_patch_;
};

Place place_apart(const PatchGrid& grid, PatchId patch, const Neighbours& neighbours, double apart_m,
                  config::RandomStream& stream) {
    Place best = point_in(grid, patch, stream);
    double best2_m2 = neighbours.nearest2_m2(best);
    for (int i = 1; i < tries && best2_m2 < apart_m * apart_m; ++i) {
        const Place next = point_in(grid, patch, stream);
        const double next2_m2 = neighbours.nearest2_m2(next);
        if (next2_m2 > best2_m2) {
            best = next;
            best2_m2 = next2_m2;
        }
    }
    return best;
}

/// A patch with what its crowns cover beside the others.
struct CoveredPatch {
    PatchId patch{};
    double cover = 1.0;  ///< > 0
    double up_to = 0.0;  ///< sum of the cover of all patches up to this one
};

/// Those that may have trees, in the order of their numbers.
std::vector<CoveredPatch> covered(std::span<const PatchId> patches, std::span<const double> cover) {
    assert(cover.empty() || cover.size() == patches.size());
    std::vector<CoveredPatch> with_cover;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        if (cover.empty() || cover[i] > 0.0) {
            with_cover.push_back({.patch = patches[i], .cover = cover.empty() ? 1.0 : cover[i]});
        }
    }
    std::sort(with_cover.begin(), with_cover.end(),
              [](const CoveredPatch& a, const CoveredPatch& b) { return a.patch < b.patch; });
    double sum = 0.0;
    for (CoveredPatch& patch : with_cover) {
        sum += patch.cover;
        patch.up_to = sum;
    }
    return with_cover;
}

/// Which patch each tree goes to, so that patches share basal area about evenly, or in proportion to cover.
std::vector<PatchId> patches_for(std::span<const CoveredPatch> patches, std::span<const double> dbh_cm,
                                 const PlaceKey& key) {
    struct Filling {
        double share = 0.0;  ///< of what the patch is to have
        double target = 1.0;
        std::size_t patch = 0;
        bool operator>(const Filling& other) const {
            return share != other.share ? share > other.share : patch > other.patch;
        }
    };
    std::priority_queue<Filling, std::vector<Filling>, std::greater<>> emptiest;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        config::RandomStream stream =
            stream_of(key, key.first_id + index_of(patches[i].patch), config::Purpose::group_centre);
        const double target =
            patches[i].cover * (lowest_target + (highest_target - lowest_target) * stream.uniform());
        // Which patch comes first is chance, too: a grain of basal area is there already.
        emptiest.push({1e-6 * stream.uniform(), target, i});
    }
    std::vector<PatchId> chosen;
    chosen.reserve(dbh_cm.size());
    for (const double dbh : dbh_cm) {
        Filling next = emptiest.top();
        emptiest.pop();
        chosen.push_back(patches[next.patch].patch);
        next.share += dbh * dbh / next.target;
        emptiest.push(next);
    }
    return chosen;
}

/// The patch of a share [0, 1) of all cover.
PatchId patch_at_share(std::span<const CoveredPatch> patches, double share) {
    const double wanted = share * patches.back().up_to;
    const auto found =
        std::upper_bound(patches.begin(), patches.end(), wanted,
                         [](double value, const CoveredPatch& patch) { return value < patch.up_to; });
    return found == patches.end() ? patches.back().patch : found->patch;
}

bool holds(std::span<const CoveredPatch> patches, PatchId wanted) {
    const auto found =
        std::lower_bound(patches.begin(), patches.end(), wanted,
                         [](const CoveredPatch& one, PatchId other) { return one.patch < other; });
    return found != patches.end() && found->patch == wanted;
}

/// A place near the centre of the tree's cluster; one that falls outside the stand is drawn again.
Place place_in_cluster(const PatchGrid& grid, std::span<const CoveredPatch> patches, std::uint64_t clusters,
                       const PlaceKey& key, config::RandomStream& stream) {
    const auto cluster = static_cast<std::uint64_t>(stream.uniform() * static_cast<double>(clusters));
    config::RandomStream centre_stream =
        stream_of(key, key.first_id + grid.size() + cluster, config::Purpose::group_centre);
    const PatchId home = patch_at_share(patches, centre_stream.uniform());
    const Place centre = point_in(grid, home, centre_stream);
    for (int i = 0; i < tries; ++i) {
        const double x_m =
            centre.x_m + config::normal(stream.uniform(), 0.0, cluster_radius_m / std::sqrt(2.0));
        const double y_m =
            centre.y_m + config::normal(stream.uniform(), 0.0, cluster_radius_m / std::sqrt(2.0));
        const auto patch = grid.at(x_m, y_m);
        if (patch && holds(patches, *patch)) {
            return {*patch, x_m, y_m};
        }
    }
    return centre;
}

}  // namespace

std::vector<Place> places_for(const PatchGrid& grid, std::span<const PatchId> patches,
                              std::span<const double> dbh_cm, Structure structure, const PlaceKey& key,
                              std::span<const Place> taken, std::span<const double> cover) {
    const std::vector<CoveredPatch> sorted = covered(patches, cover);
    assert(!sorted.empty());
    const auto trees = static_cast<double>(std::max<std::size_t>(dbh_cm.size(), 1));
    const double spacing_m = std::sqrt(static_cast<double>(sorted.size()) * patch_area_m2 / trees);
    const double apart_m =
        structure == Structure::plenter ? 0.0 : std::min(kept_share_of_spacing * spacing_m, patch_side_m);
    const auto clusters = static_cast<std::uint64_t>(std::ceil(trees / trees_per_cluster));

    Neighbours neighbours{grid};
    for (const Place& place : taken) {
        neighbours.add(place);
    }
    const std::vector<PatchId> patch_of = patches_for(sorted, dbh_cm, key);
    std::vector<Place> places;
    places.reserve(dbh_cm.size());
    for (std::size_t i = 0; i < dbh_cm.size(); ++i) {
        config::RandomStream stream = stream_of(key, key.first_id + i, config::Purpose::starting_tree);
        places.push_back(structure == Structure::groups
                             ? place_in_cluster(grid, sorted, clusters, key, stream)
                             : place_apart(grid, patch_of[i], neighbours, apart_m, stream));
        neighbours.add(places.back());
    }
    return places;
}

}  // namespace forest
