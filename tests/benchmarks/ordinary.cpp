#include "tests/benchmarks/ordinary.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_traits_xy_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <unordered_map>
#include <utility>

namespace benchmarks::ordinary {
namespace {

using Eigen::Vector3d;
using rockfall::Rock;

constexpr double step_s = 0.01;
constexpr double g = 9.81;

/// The ground under a point.
struct Ground {
    double height_m;
    Vector3d normal;
    const void* face;
};

class Terrain {
public:
    virtual ~Terrain() = default;
    virtual std::optional<Ground> ground_at(const Vector3d& position) = 0;
};

class TriangulatedTerrain : public Terrain {
public:
    explicit TriangulatedTerrain(std::span<const Vector3d> terrain) {
        std::vector<Kernel::Point_3> points;
        for (const Vector3d& p : terrain) {
            points.emplace_back(p.x(), p.y(), p.z());
        }
        mesh_.insert(points.begin(), points.end());
    }

    void use_hints(bool hinted) {
        hinted_ = hinted;
        last_face_ = Mesh::Face_handle{};
    }

    std::optional<Ground> ground_at(const Vector3d& position) override {
        const Kernel::Point_3 point{position.x(), position.y(), 0.0};
        const Mesh::Face_handle face = hinted_ ? mesh_.locate(point, last_face_) : mesh_.locate(point);
        if (mesh_.is_infinite(face)) {
            return std::nullopt;
        }
        last_face_ = face;
        const Vector3d a = vector_of(face->vertex(0)->point());
        const Vector3d b = vector_of(face->vertex(1)->point());
        const Vector3d c = vector_of(face->vertex(2)->point());
        const Vector3d normal = (b - a).cross(c - a).normalized();
        const double height_m =
            a.z() - (normal.x() * (position.x() - a.x()) + normal.y() * (position.y() - a.y())) / normal.z();
        return Ground{height_m, normal, &*face};
    }

private:
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<Kernel>>;

    static Vector3d vector_of(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

    Mesh mesh_;
    Mesh::Face_handle last_face_;
    bool hinted_ = false;
};

struct Motion {
    enum class State { flies, rolls, stopped, left };
    Vector3d position_m;
    Vector3d velocity_mps;
    double spin_radps = 0.0;
    State state = State::flies;
};

double energy_j(const Rock& rock, const Motion& motion) {
    return 0.5 * rock.mass_kg * motion.velocity_mps.squaredNorm() +
           0.5 * rock.inertia_kgm2 * motion.spin_radps * motion.spin_radps;
}

class Chance {
public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(engine_);
    }

private:
    std::mt19937 engine_{42};
};

class Rebound {
public:
    virtual ~Rebound() = default;
    virtual void meet_ground(const Rock& rock, const Vector3d& normal, Motion& motion, Chance& chance) = 0;
    virtual bool lift_off(const Rock& rock, const Vector3d& normal, Motion& motion) = 0;
};

/// Rammer et al. 2010, as rockfall/motion/picus/ground_contact.hpp has it.
class PicusRebound : public Rebound {
public:
    PicusRebound(const rockfall::picus::Law& law, const rockfall::SurfaceType& ground)
        : law_{law}, ground_{ground} {}

    void meet_ground(const Rock& rock, const Vector3d& normal, Motion& motion, Chance& chance) override {
        if (chance.between(0.0, 1.0) < ground_.stopping.at(rock.diameter_m)) {
            motion.state = Motion::State::stopped;
            return;
        }
        const double before_j = energy_j(rock, motion);
        const double speed_mps = motion.velocity_mps.norm();
        const double noise = law_.restitution.tangential_noise;
        const double damping = speed_mps > 10.0 ? std::pow(10.0 / speed_mps, 0.25) : 1.0;
        const double rt =
            damping * std::clamp(ground_.restitution.tangential + chance.between(-noise, noise), 0.0, 0.99);
        const double rn = damping * ground_.restitution.normal;
        const double into_mps = -motion.velocity_mps.dot(normal);
        const Vector3d along_mps = motion.velocity_mps + into_mps * normal;
        const double along_slope_mps = along_mps.norm();
        const double after_mps = std::hypot(rn * into_mps, rt * along_slope_mps);

        const double largest_rad = law_.lateral.at_rest.in_radians();
        const double turn_rad = chance.between(-largest_rad, largest_rad);
        const Vector3d heading =
            along_slope_mps > 0.0 ? Vector3d{along_mps / along_slope_mps} : Vector3d{normal.unitOrthogonal()};
        const Vector3d direction = std::cos(turn_rad) * heading + std::sin(turn_rad) * normal.cross(heading);

        const double steepness = std::acos(normal.z());
        if (after_mps < law_.stopping.slow_mps && std::tan(steepness) < law_.rolling.friction) {
            motion.state = Motion::State::stopped;
            return;
        }
        const double rolling_mps = law_.rolling.start_factor * std::sqrt(g * rock.radius_m * normal.z());
        const Vector3d leaving_mps = leaving(after_mps, direction, normal);
        if (after_mps < rolling_mps || hop_length_m(leaving_mps, normal) < rock.radius_m) {
            const double affordable_mps = std::sqrt(before_j / (0.7 * rock.mass_kg));
            motion.velocity_mps = std::min(rt * along_slope_mps, affordable_mps) * direction;
            motion.spin_radps = motion.velocity_mps.norm() / rock.radius_m;
            motion.state = Motion::State::rolls;
            return;
        }
        const double left_j = std::max(0.0, before_j - 0.5 * rock.mass_kg * after_mps * after_mps);
        motion.velocity_mps = leaving_mps;
        motion.spin_radps =
            std::min(rt * along_slope_mps / rock.radius_m, std::sqrt(2.0 * left_j / rock.inertia_kgm2));
        motion.state = Motion::State::flies;
    }

    bool lift_off(const Rock& rock, const Vector3d& normal, Motion& motion) override {
        const double speed_mps = motion.velocity_mps.norm();
        if (speed_mps < law_.rolling.launch_factor * std::sqrt(g * rock.radius_m * normal.z())) {
            return false;
        }
        const Vector3d leaving_mps = leaving(speed_mps, motion.velocity_mps / speed_mps, normal);
        if (hop_length_m(leaving_mps, normal) < rock.radius_m) {
            return false;
        }
        motion.velocity_mps = leaving_mps;
        motion.state = Motion::State::flies;
        return true;
    }

private:
    [[nodiscard]] Vector3d leaving(double speed_mps, const Vector3d& direction,
                                   const Vector3d& normal) const {
        const double angle_deg =
            std::min(law_.jump_angle.cap.in_degrees(), law_.jump_angle.coefficient.in_degrees() *
                                                           std::pow(speed_mps, -law_.jump_angle.exponent));
        const double angle_rad = angle_deg * std::numbers::pi / 180.0;
        return speed_mps * (std::cos(angle_rad) * direction + std::sin(angle_rad) * normal);
    }

    static double hop_length_m(const Vector3d& velocity_mps, const Vector3d& normal) {
        const double rising_mps = velocity_mps.dot(normal);
        const double time_s = 2.0 * rising_mps / (g * normal.z());
        const Vector3d gravity{0.0, 0.0, -g};
        const Vector3d gravity_along = gravity - gravity.dot(normal) * normal;
        return (time_s * (velocity_mps - rising_mps * normal) + 0.5 * time_s * time_s * gravity_along).norm();
    }

    rockfall::picus::Law law_;
    rockfall::SurfaceType ground_;
};

struct Tree {
    double x_m;
    double y_m;
    double dbh_cm;
    double height_m;
    double ground_m;
};

/// The trees that a rock hit and has not left.
using Touched = std::vector<std::shared_ptr<Tree>>;

class Forest {
public:
    virtual ~Forest() = default;
    /// A tree that the rock touches and moves towards, other than those known.
    virtual std::shared_ptr<Tree> touched(const Rock& rock, const Motion& motion, const Touched& known) = 0;
    virtual void meet(const Rock& rock, const Tree& tree, Motion& motion, Chance& chance) = 0;
};

class PatchForest : public Forest {
public:
    PatchForest(std::span<const rockfall::Stem> stems, Terrain& terrain, rockfall::TreeImpactLaw law)
        : law_{std::move(law)} {
        for (const rockfall::Stem& stem : stems) {
            const auto ground = terrain.ground_at({stem.x_m, stem.y_m, 0.0});
            if (ground) {
                patches_[patch_of(stem.x_m, stem.y_m)].push_back(std::make_shared<Tree>(
                    Tree{stem.x_m, stem.y_m, stem.dbh_cm, stem.height_m, ground->height_m}));
            }
        }
        for (const auto& [patch, trees] : patches_) {
            low_ = {std::min(low_.first, patch.first), std::min(low_.second, patch.second)};
            high_ = {std::max(high_.first, patch.first), std::max(high_.second, patch.second)};
        }
        rows_ = high_.second - low_.second + 1;
        grid_.resize(static_cast<std::size_t>((high_.first - low_.first + 1) * rows_));
        for (const auto& [patch, trees] : patches_) {
            grid_[index(patch)] = trees;
        }
    }

    std::shared_ptr<Tree> touched(const Rock& rock, const Motion& motion, const Touched& known) override {
        const Patch here = patch_of(motion.position_m.x(), motion.position_m.y());
        for (int i = std::max(here.first - 1, low_.first); i <= std::min(here.first + 1, high_.first); ++i) {
            for (int j = std::max(here.second - 1, low_.second); j <= std::min(here.second + 1, high_.second);
                 ++j) {
                for (const std::shared_ptr<Tree>& tree : grid_[index({i, j})]) {
                    if (touches(rock, motion, *tree) &&
                        std::find(known.begin(), known.end(), tree) == known.end()) {
                        return tree;
                    }
                }
            }
        }
        return nullptr;
    }

    void meet(const Rock& rock, const Tree& tree, Motion& motion, Chance& chance) override {
        const double rx = tree.x_m - motion.position_m.x();
        const double ry = tree.y_m - motion.position_m.y();
        const double plan_mps = motion.velocity_mps.head<2>().norm();
        const double offset_m = (motion.velocity_mps.x() * ry - motion.velocity_mps.y() * rx) / plan_mps;
        const double position = std::min(1.0, std::abs(offset_m) / reach_m(rock, tree));
        const double strength_j = 38.7 * std::pow(tree.dbh_cm, 2.31);
        const double share =
            std::max(0.0, -0.046 + (0.98 + 0.046) / (1.0 + std::pow(10.0, (position - 0.58) * 8.007)));
        const double available_j = share * strength_j;
        const double before_j = energy_j(rock, motion);
        const double kept = (before_j - std::min(before_j, available_j)) / before_j;
        if (kept < law_.stop_share) {
            motion.state = Motion::State::stopped;
            return;
        }
        const double limit = std::min(1.0, std::max(available_j, 0.02 * strength_j) / before_j);
        double turn_rad = std::min(drawn_deviation_rad(position, chance), std::asin(std::sqrt(limit)));
        if (offset_m > 0.0) {
            turn_rad = -turn_rad;
        }
        const double vx = motion.velocity_mps.x();
        const double vy = motion.velocity_mps.y();
        motion.velocity_mps.x() = std::cos(turn_rad) * vx - std::sin(turn_rad) * vy;
        motion.velocity_mps.y() = std::sin(turn_rad) * vx + std::cos(turn_rad) * vy;
        motion.velocity_mps *= std::sqrt(kept);
        motion.spin_radps *= std::sqrt(kept);
    }

    static double reach_m(const Rock& rock, const Tree& tree) { return rock.radius_m + 0.005 * tree.dbh_cm; }

private:
    using Patch = std::pair<int, int>;
    static Patch patch_of(double x_m, double y_m) {
        return {static_cast<int>(std::floor(x_m / 10.0)), static_cast<int>(std::floor(y_m / 10.0))};
    }
    [[nodiscard]] std::size_t index(Patch patch) const {
        return static_cast<std::size_t>((patch.first - low_.first) * rows_ + patch.second - low_.second);
    }

    static bool touches(const Rock& rock, const Motion& motion, const Tree& tree) {
        const double rx = tree.x_m - motion.position_m.x();
        const double ry = tree.y_m - motion.position_m.y();
        return std::sqrt(rx * rx + ry * ry) < reach_m(rock, tree) &&
               rx * motion.velocity_mps.x() + ry * motion.velocity_mps.y() > 0.0 &&
               motion.position_m.z() - tree.ground_m < tree.height_m;
    }

    [[nodiscard]] double drawn_deviation_rad(double position, Chance& chance) const {
        const auto type = static_cast<std::size_t>(position <= law_.frontal_limit   ? 0
                                                   : position <= law_.scratch_limit ? 1
                                                                                    : 2);
        const auto& shares = law_.deviation.shares[type];
        const double u = chance.between(0.0, 1.0);
        const std::size_t k = u < shares[0] ? 0 : u < shares[0] + shares[1] ? 1 : 2;
        return chance.between(law_.deviation.limits[k].in_radians(),
                              law_.deviation.limits[k + 1].in_radians());
    }

    rockfall::TreeImpactLaw law_;
    std::map<Patch, std::vector<std::shared_ptr<Tree>>> patches_;
    std::vector<std::vector<std::shared_ptr<Tree>>> grid_;
    Patch low_{1 << 20, 1 << 20};
    Patch high_{-(1 << 20), -(1 << 20)};
    int rows_ = 0;
};

/// Largest values of one rock in a cell; of all rocks their sums and maxima.
struct CellStatistics {
    std::uint32_t passages = 0;
    double energy_sum_j = 0.0, speed_sum_mps = 0.0, height_sum_m = 0.0;
    double energy_max_j = 0.0, speed_max_mps = 0.0, height_max_m = 0.0;
};

class Statistics {
public:
    explicit Statistics(const config::GridFrame& frame) : frame_{frame}, cells_(frame.size()) {}

    void watch(const Rock& rock, const Motion& motion, double ground_m) {
        const config::Cell cell = frame_.cell_at(motion.position_m.x(), motion.position_m.y());
        if (here_ == nullptr || !(cell == cell_)) {
            cell_ = cell;
            here_ = frame_.contains(cell) ? &of_rock_[frame_.index(cell)] : &elsewhere_;
        }
        here_->energy_max_j = std::max(here_->energy_max_j, energy_j(rock, motion));
        here_->speed_max_mps = std::max(here_->speed_max_mps, motion.velocity_mps.norm());
        here_->height_max_m = std::max(here_->height_max_m, motion.position_m.z() - ground_m);
    }

    void end_rock() {
        for (const auto& [index, visit] : of_rock_) {
            CellStatistics& sums = cells_[index];
            ++sums.passages;
            sums.energy_sum_j += visit.energy_max_j;
            sums.speed_sum_mps += visit.speed_max_mps;
            sums.height_sum_m += visit.height_max_m;
            sums.energy_max_j = std::max(sums.energy_max_j, visit.energy_max_j);
            sums.speed_max_mps = std::max(sums.speed_max_mps, visit.speed_max_mps);
            sums.height_max_m = std::max(sums.height_max_m, visit.height_max_m);
        }
        of_rock_.clear();
        here_ = nullptr;
    }

private:
    config::GridFrame frame_;
    std::vector<CellStatistics> cells_;
    std::unordered_map<std::size_t, CellStatistics> of_rock_;
    CellStatistics elsewhere_;
    CellStatistics* here_ = nullptr;
    config::Cell cell_;
};

/// What is kept of each rock.
struct Record {
    Vector3d start_m;
    Vector3d end_m;
    std::uint32_t impacts;
    std::uint32_t hits;
    bool left;
};

/// Lets one rock fall, step by step.
class Simulation {
public:
    Simulation(Terrain& terrain, Rebound& rebound, Forest* forest, Statistics* statistics, Chance& chance,
               const rockfall::FallLaw& law)
        : terrain_{terrain},
          rebound_{rebound},
          forest_{forest},
          statistics_{statistics},
          chance_{chance},
          law_{law} {}

    Record fall(const Rock& rock, const Vector3d& position_m, const Vector3d& velocity_mps) {
        rock_ = rock;
        motion_ = {position_m, velocity_mps, 0.0, Motion::State::flies};
        record_ = {position_m, position_m, 0, 0, false};
        touched_.clear();
        face_ = nullptr;
        while (motion_.state == Motion::State::flies || motion_.state == Motion::State::rolls) {
            motion_.state == Motion::State::flies ? fly() : roll();
            if (record_.impacts >= law_.motion.of<rockfall::picus::Model>().stopping.most_impacts) {
                motion_.state = Motion::State::stopped;
            }
        }
        if (statistics_ != nullptr) {
            statistics_->end_rock();
        }
        record_.end_m = motion_.position_m;
        record_.left = motion_.state == Motion::State::left;
        return record_;
    }

private:
    void fly() {
        motion_.position_m += step_s * motion_.velocity_mps;
        motion_.position_m.z() -= 0.5 * g * step_s * step_s;
        motion_.velocity_mps.z() -= g * step_s;
        const auto ground = terrain_.ground_at(motion_.position_m);
        if (!ground) {
            motion_.state = Motion::State::left;
            return;
        }
        face_ = ground->face;
        if (meets_tree()) {
            return;
        }
        if (motion_.position_m.z() <= ground->height_m) {
            motion_.position_m.z() = ground->height_m;
            touch(*ground);
        }
        watch(*ground);
    }

    void touch(const Ground& ground) {
        ++record_.impacts;
        if (motion_.velocity_mps.dot(ground.normal) < 0.0) {
            rebound_.meet_ground(rock_, ground.normal, motion_, chance_);
        }
    }

    void roll() {
        const auto ground = terrain_.ground_at(motion_.position_m);
        if (!ground) {
            motion_.state = Motion::State::left;
            return;
        }
        motion_.position_m.z() = ground->height_m;
        if (ground->face != face_ && face_ != nullptr && !stays_on(*ground)) {
            face_ = ground->face;
            return;
        }
        face_ = ground->face;
        watch(*ground);
        if (meets_tree() || rebound_.lift_off(rock_, ground->normal, motion_)) {
            return;
        }
        roll_on(ground->normal);
    }

    /// Takes a rolling rock over an edge; false if it takes off or hits the next face.
    bool stays_on(const Ground& ground) {
        const double off_mps = motion_.velocity_mps.dot(ground.normal);
        const double speed_mps = motion_.velocity_mps.norm();
        const Vector3d along_mps = motion_.velocity_mps - off_mps * ground.normal;
        if (std::abs(off_mps) >
            law_.motion.of<rockfall::picus::Model>().rolling.edge_angle_tangent * along_mps.norm()) {
            if (off_mps > 0.0) {
                motion_.state = Motion::State::flies;
            } else {
                touch(ground);
            }
            return false;
        }
        motion_.velocity_mps = speed_mps * along_mps.normalized();
        return true;
    }

    void roll_on(const Vector3d& normal) {
        const Vector3d gravity{0.0, 0.0, -g};
        const double speed_mps = motion_.velocity_mps.norm();
        const double friction = law_.motion.of<rockfall::picus::Model>().rolling.friction * g * normal.z();
        const Vector3d pull = gravity - gravity.dot(normal) * normal;
        const double slowing_mps = 5.0 / 7.0 * friction * step_s;
        Vector3d velocity_mps = motion_.velocity_mps + 5.0 / 7.0 * step_s * pull;
        const double pulled_mps = velocity_mps.norm();
        if (pulled_mps <= slowing_mps || (speed_mps < 1e-3 && pull.norm() < friction)) {
            motion_.state = Motion::State::stopped;
            return;
        }
        velocity_mps *= (pulled_mps - slowing_mps) / pulled_mps;
        motion_.position_m += 0.5 * step_s * (motion_.velocity_mps + velocity_mps);
        motion_.velocity_mps = velocity_mps;
        motion_.spin_radps = velocity_mps.norm() / rock_.radius_m;
    }

    bool meets_tree() {
        if (forest_ == nullptr) {
            return false;
        }
        std::erase_if(touched_, [&](const std::shared_ptr<Tree>& tree) {
            const double dx = motion_.position_m.x() - tree->x_m;
            const double dy = motion_.position_m.y() - tree->y_m;
            return std::sqrt(dx * dx + dy * dy) > PatchForest::reach_m(rock_, *tree) + 0.01;
        });
        const std::shared_ptr<Tree> tree = forest_->touched(rock_, motion_, touched_);
        if (tree == nullptr) {
            return false;
        }
        ++record_.hits;
        forest_->meet(rock_, *tree, motion_, chance_);
        touched_.push_back(tree);
        return true;
    }

    void watch(const Ground& ground) {
        if (statistics_ != nullptr) {
            statistics_->watch(rock_, motion_, ground.height_m);
        }
    }

    Terrain& terrain_;
    Rebound& rebound_;
    Forest* forest_;
    Statistics* statistics_;
    Chance& chance_;
    const rockfall::FallLaw& law_;

    Rock rock_;
    Motion motion_;
    Record record_{};
    Touched touched_;
    const void* face_ = nullptr;
};

}  // namespace

struct Program::World {
    TriangulatedTerrain terrain;
    PicusRebound rebound;
    PatchForest forest;
    Statistics statistics;
    rockfall::FallLaw law;
    Chance chance;
    std::vector<Record> records;

    World(std::span<const Vector3d> points, std::span<const rockfall::Stem> stems,
          const config::GridFrame& maps, const rockfall::FallLaw& law_in, const rockfall::SurfaceType& ground)
        : terrain{points},
          rebound{law_in.motion.of<rockfall::picus::Model>(), ground},
          forest{stems, terrain, law_in.tree},
          statistics{maps},
          law{law_in} {}
};

Program::Program(std::span<const Vector3d> terrain, std::span<const rockfall::Stem> stems,
                 const config::GridFrame& maps, const rockfall::FallLaw& law,
                 const rockfall::SurfaceType& ground)
    : world_{std::make_unique<World>(terrain, stems, maps, law, ground)} {}

Program::~Program() = default;

Totals Program::run(std::span<const rockfall::RockStart> starts, const Eigen::Vector2d& origin_m, Mode mode) {
    World& world = *world_;
    world.terrain.use_hints(mode.hinted);
    world.records.clear();
    Simulation simulation{world.terrain,
                          world.rebound,
                          mode.with_forest ? &world.forest : nullptr,
                          mode.with_forest ? &world.statistics : nullptr,
                          world.chance,
                          world.law};
    const Vector3d origin{origin_m.x(), origin_m.y(), 0.0};
    for (const rockfall::RockStart& start : starts) {
        world.records.push_back(simulation.fall(start.rock, start.position_m + origin, start.velocity_mps));
    }
    Totals totals;
    for (const Record& record : world.records) {
        rockfall::FallEnd end;
        end.position_m = record.end_m;
        end.ground_impacts = record.impacts;
        end.tree_hits = record.hits;
        totals.add(record.start_m, end);
    }
    return totals;
}

}  // namespace benchmarks::ordinary
