#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/calibrate/sites/shared_components.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// Keeps the first figure that differs.
class Comparison {
public:
    void add(const std::string& figure, double one, double other) {
        if (first_.empty() && one != other) {
            first_ = joined(figure, " ", config::to_text(other), " for ", config::to_text(one));
        }
    }
    void add(const std::string& figure, const std::string& one, const std::string& other) {
        if (first_.empty() && one != other) {
            first_ = joined(figure, " ", other.empty() ? "none" : other, " for ", one.empty() ? "none" : one);
        }
    }
    void add(const std::string& figure, const rockfall::Width& one, const rockfall::Width& other) {
        add(figure, one.slow, other.slow);
        add(figure, one.fast, other.fast);
        add(figure, one.limit_mps, other.limit_mps);
    }
    /// Over all diameters that rocks have.
    void add(const std::string& figure, const rockfall::StopCurve& one, const rockfall::StopCurve& other) {
        for (int step = -20; step <= 20; ++step) {
            const double diameter_m = std::pow(10.0, 0.1 * step);
            add(joined(figure, " at ", config::to_text(std::round(100.0 * diameter_m) / 100.0), " m"),
                one.at(diameter_m), other.at(diameter_m));
        }
    }
    [[nodiscard]] const std::string& first() const { return first_; }

private:
    std::string first_;
};

void add_soils(const std::optional<rockfall::Soil>& one, const std::optional<rockfall::Soil>& other,
               Comparison& comparison) {
    comparison.add("soil", one ? one->name : "", other ? other->name : "");
    if (!one || !other) {
        return;
    }
    comparison.add("r_n of the soil", one->restitution.normal, other->restitution.normal);
    comparison.add("r_t of the soil", one->restitution.tangential, other->restitution.tangential);
    comparison.add("friction of the soil", one->friction, other->friction);
    comparison.add("normal_share of the soil", one->normal_share, other->normal_share);
    comparison.add("tangential_share of the soil", one->tangential_share, other->tangential_share);
    comparison.add("friction_share of the soil", one->friction_share, other->friction_share);
    comparison.add("sideways of the soil", one->sideways_rad, other->sideways_rad);
    comparison.add("upwards of the soil", one->upwards_rad, other->upwards_rad);
    comparison.add("threshold of the soil", one->threshold_tangent, other->threshold_tangent);
}

void add_blocks(const rockfall::BlockGround& one, const rockfall::BlockGround& other,
                Comparison& comparison) {
    comparison.add("class of the ground for blocks", one.name, other.name);
    comparison.add("friction law of blocks", static_cast<double>(one.law), static_cast<double>(other.law));
    comparison.add("friction of blocks", one.friction, other.friction);
    comparison.add("friction_max of blocks", one.friction_max, other.friction_max);
    comparison.add("slip_beta of blocks", one.slip_beta_ps, other.slip_beta_ps);
    comparison.add("slip_kappa of blocks", one.slip_kappa_pm, other.slip_kappa_pm);
    comparison.add("drag of blocks", one.drag_ps, other.drag_ps);
    comparison.add("restitution of blocks", one.restitution, other.restitution);
    comparison.add("rolling resistance of blocks", one.rolling_resistance, other.rolling_resistance);
    comparison.add("soil strength of blocks", one.soil_strength_kpa, other.soil_strength_kpa);
}

}  // namespace

std::string difference_of(const rockfall::SurfaceType& one, const rockfall::SurfaceType& other) {
    Comparison comparison;
    comparison.add("like", one.like, other.like);
    comparison.add("r_n", one.restitution.normal, other.restitution.normal);
    comparison.add("r_t", one.restitution.tangential, other.restitution.tangential);
    comparison.add("published r_n", one.as_published().normal, other.as_published().normal);
    comparison.add("published r_t", one.as_published().tangential, other.as_published().tangential);
    comparison.add("jump_angle_factor", one.jump_angle_factor, other.jump_angle_factor);
    comparison.add("probability to stop", one.stopping, other.stopping);
    comparison.add("rate of rolling stops", one.rolling_stops_per_m, other.rolling_stops_per_m);
    comparison.add("rolling_friction", one.rolling_friction, other.rolling_friction);
    comparison.add("sliding_friction", one.sliding_friction, other.sliding_friction);
    comparison.add("roughness_m", one.roughness_m, other.roughness_m);
    add_soils(one.soil, other.soil, comparison);
    add_blocks(one.block, other.block, comparison);
    return comparison.first();
}

}  // namespace coupling::calibrate
