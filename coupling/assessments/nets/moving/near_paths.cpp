#include "coupling/assessments/nets/moving/near_paths.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/results/figures/figures.hpp"
#include "rockfall/laws/flight.hpp"

namespace coupling::moving {
namespace {

constexpr std::array widths_m{60.0, 40.0, 25.0, 15.0, 10.0};
/// Wider areas are not worth a sample [choice].
constexpr double widest_of_sample_m = 25.0;

constexpr std::size_t in_base64(std::size_t bytes) {
    return (bytes + 2) / 3 * 4;
}

bool is_same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

Eigen::Vector2d end_of(const StoredPiece& piece) {
    const Eigen::Vector3d end_m =
        piece.flies ? rockfall::Flight{piece.start_m, piece.other}.position_m(piece.first) : piece.other;
    return end_m.head<2>();
}

KeptGround ground_of(const rockfall::Terrain& terrain, const std::vector<AreaAround>& areas) {
    KeptGround ground;
    std::vector<std::uint32_t> number_of(terrain.vertices().size(), rockfall::no_triangle);
    for (const rockfall::Triangle& triangle : terrain.triangles()) {
        std::array<Eigen::Vector2d, 3> corners_m;
        for (std::size_t i = 0; i < 3; ++i) {
            const rockfall::Vertex& vertex = terrain.vertices()[triangle.corners[i]];
            corners_m[i] = {vertex.x_m, vertex.y_m};
        }
        if (std::none_of(areas.begin(), areas.end(),
                         [&](const AreaAround& area) { return area.may_touch(corners_m); })) {
            continue;
        }
        for (const std::uint32_t corner : triangle.corners) {
            if (number_of[corner] == rockfall::no_triangle) {
                number_of[corner] = static_cast<std::uint32_t>(ground.x_m.size());
                const rockfall::Vertex& vertex = terrain.vertices()[corner];
                ground.x_m.push_back(vertex.x_m);
                ground.y_m.push_back(vertex.y_m);
                ground.z_m.push_back(vertex.z_m);
            }
            ground.corners.push_back(number_of[corner]);
        }
    }
    return ground;
}

std::size_t bytes_of(const KeptGround& ground) {
    return in_base64(3 * sizeof(double) * ground.x_m.size() + sizeof(std::uint32_t) * ground.corners.size());
}

/// Keeps paths within a width of nets as long as they fit.
class Keeper {
public:
    Keeper(const rockfall::Terrain& terrain, std::span<const NetRecord> nets, double width_m,
           std::uint64_t every, std::size_t most_bytes)
        : most_bytes_{most_bytes} {
        kept_.width_m = width_m;
        kept_.every = every;
        for (const NetRecord& record : nets) {
            kept_.areas.emplace_back(record.net.line_m, width_m);
        }
        kept_.ground = ground_of(terrain, kept_.areas);
        ground_bytes_ = bytes_of(kept_.ground);
    }

    void add(const StoredPath& path) {
        std::uint32_t count = 0;
        const std::size_t kinds = kept_.paths.kinds.size();
        const StoredPiece* before = nullptr;
        Eigen::Vector2d end_before = Eigen::Vector2d::Zero();
        for (const StoredPiece& piece : path.pieces) {
            const Eigen::Vector2d end = end_of(piece);
            if (std::none_of(kept_.areas.begin(), kept_.areas.end(), [&](const AreaAround& area) {
                    return area.touches(piece.start_m.head<2>(), end);
                })) {
                continue;
            }
            add(piece, before, end_before);
            before = &piece;
            end_before = end;
            ++count;
        }
        if (count == 0) {
            return;
        }
        const std::array<double, 4> body{path.body.diameter_m, path.body.radius_m, path.body.mass_kg,
                                         path.body.inertia_kgm2};
        const auto [known, is_new] = bodies_.try_emplace(body, static_cast<std::uint32_t>(bodies_.size()));
        if (is_new) {
            kept_.paths.bodies.insert(kept_.paths.bodies.end(), body.begin(), body.end());
        }
        kept_.paths.covers.push_back(static_cast<std::uint8_t>(path.cover));
        kept_.paths.body_of.push_back(known->second);
        kept_.paths.counts.push_back(count);
        counted_bytes_ += 9 + (kept_.paths.kinds.size() - kinds) + (is_new ? sizeof(body) : 0);
        if (is_over()) {
            kept_.paths = {};  // from here on only counted
        }
    }

    [[nodiscard]] bool is_over() const { return bytes() > most_bytes_; }
    [[nodiscard]] bool ground_leaves_room() const { return 2 * ground_bytes_ <= most_bytes_; }
    [[nodiscard]] std::size_t bytes() const { return ground_bytes_ + in_base64(counted_bytes_); }
    [[nodiscard]] std::size_t ground_bytes() const { return ground_bytes_; }
    [[nodiscard]] double width_m() const { return kept_.width_m; }
    [[nodiscard]] NearPaths taken() && { return std::move(kept_); }

private:
    void add(const StoredPiece& piece, const StoredPiece* before, const Eigen::Vector2d& end_before) {
        const bool follows = before != nullptr && is_same(piece.start_m.x(), end_before.x()) &&
                             is_same(piece.start_m.y(), end_before.y());
        const bool keeps_speed =
            before != nullptr && !piece.flies && !before->flies && is_same(piece.first, before->second);
        const bool turns = piece.rotation_end_j >= 0.0;
        kept_.paths.kinds.push_back(static_cast<std::uint8_t>(
            (piece.flies ? piece_flies : 0) | (piece.slides ? piece_slides : 0) | (turns ? piece_turns : 0) |
            (follows ? piece_follows : 0) | (keeps_speed ? piece_keeps_speed : 0)));
        std::vector<double>& numbers = kept_.paths.numbers;
        const std::size_t numbers_before = numbers.size();
        if (!follows) {
            numbers.insert(numbers.end(), {piece.start_m.x(), piece.start_m.y()});
        }
        if (piece.flies) {
            numbers.insert(numbers.end(),
                           {piece.start_m.z(), piece.other.x(), piece.other.y(), piece.other.z()});
        } else {
            numbers.insert(numbers.end(), {piece.other.x(), piece.other.y()});
        }
        if (!keeps_speed) {
            numbers.push_back(piece.first);
        }
        numbers.push_back(piece.second);
        if (turns) {
            numbers.push_back(piece.rotation_start_j);
            numbers.push_back(piece.rotation_end_j);
        }
        counted_bytes_ += sizeof(double) * (numbers.size() - numbers_before);
    }

    std::size_t most_bytes_;
    NearPaths kept_;
    std::size_t ground_bytes_ = 0;
    std::size_t counted_bytes_ = 0;
    std::map<std::array<double, 4>, std::uint32_t> bodies_;
};

/// What the paths say of the nets where they stand.
class Counter {
public:
    explicit Counter(std::span<const NetRecord> nets) : nets_{nets} {
        std::vector<rockfall::Net> walls;
        for (const NetRecord& record : nets) {
            walls.push_back(record.net);
        }
        index_ = rockfall::NetIndex{walls};
    }
    void add(const StoredPath& path, const rockfall::Terrain& terrain) {
        ++rocks_[index_of(path.cover)];
        try_nets(index_, terrain, path, tried_);
    }
    /// Hands over the figures and how many rocks they are of.
    void finish(NearPaths& kept, const PathsHead& head) const {
        kept.rocks = kept.every == 1 ? head.rocks : rocks_;
        kept.figures = figures_of_tried(nets_, tried_, kept.rocks, head);
    }

private:
    std::span<const NetRecord> nets_;
    rockfall::NetIndex index_;
    TriedNets tried_;
    std::array<std::uint64_t, rockfall::covers> rocks_{};
};

/// One rock in so many.
std::optional<NearPaths> sample_near(NetPathsReader& paths, std::span<const NetRecord> nets, double width_m,
                                     std::uint64_t every, std::size_t most_bytes) {
    Keeper keeper{paths.terrain(), nets, width_m, every, most_bytes};
    Counter counter{nets};
    paths.each([&](const StoredPath& path) {
        if (path.rock % every == 0) {
            keeper.add(path);
            counter.add(path, paths.terrain());
        }
    });
    if (keeper.is_over()) {
        return std::nullopt;
    }
    NearPaths kept = std::move(keeper).taken();
    counter.finish(kept, paths.head());
    return kept;
}

}  // namespace

std::optional<NearPaths> paths_near(NetPathsReader& paths, std::span<const NetRecord> nets,
                                    std::size_t most_bytes) {
    std::vector<Keeper> keepers;
    for (const double width_m : widths_m) {
        keepers.emplace_back(paths.terrain(), nets, width_m, 1, most_bytes);
    }
    Counter counter{nets};
    paths.each([&](const StoredPath& path) {
        for (Keeper& keeper : keepers) {
            keeper.add(path);
        }
        counter.add(path, paths.terrain());
    });
    for (Keeper& keeper : keepers) {
        if (!keeper.is_over()) {
            NearPaths kept = std::move(keeper).taken();
            counter.finish(kept, paths.head());
            return kept;
        }
    }
    const auto chosen = std::find_if(keepers.begin(), keepers.end(), [](const Keeper& keeper) {
        return keeper.width_m() <= widest_of_sample_m && keeper.ground_leaves_room();
    });
    if (chosen == keepers.end()) {
        return std::nullopt;
    }
    const std::size_t room = most_bytes - chosen->ground_bytes();
    std::uint64_t every = (chosen->bytes() - chosen->ground_bytes()) / room + 1;
    for (;; every += 1 + every / 10) {
        if (std::optional<NearPaths> kept = sample_near(paths, nets, chosen->width_m(), every, most_bytes)) {
            return kept;
        }
    }
}

}  // namespace coupling::moving
