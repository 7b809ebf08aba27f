#include "rockfall/release/release.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"

namespace rockfall {

void allot(std::vector<ReleaseSource>& sources, std::uint64_t total) {
    spread(sources, total);
    number_rocks(sources);
}

void spread(std::span<ReleaseSource> sources, std::uint64_t total) {
    const double weights = std::accumulate(sources.begin(), sources.end(), 0.0,
                                           [](double sum, const ReleaseSource& s) { return sum + s.weight; });
    const auto all = static_cast<double>(total);
    double end = 0.0;
    std::uint64_t given = 0;
    for (ReleaseSource& source : sources) {
        end += source.weight / weights;
        // Middles (k + 1/2) / total below the end of this source; all of them below that of the last.
        const bool last = &source == &sources.back();
        const double middles_below = std::ceil(end * all - 0.5);
        const std::uint64_t until =
            last ? total
                 : static_cast<std::uint64_t>(std::clamp(middles_below, static_cast<double>(given), all));
        source.rocks = static_cast<std::uint32_t>(until - given);
        given = until;
    }
}

void number_rocks(std::span<ReleaseSource> sources) {
    std::uint64_t first = 0;
    for (ReleaseSource& source : sources) {
        source.first_rock = first;
        first += source.rocks;
    }
}

DiameterLaw DiameterLaw::fixed(double diameter_m) {
    DiameterLaw law;
    law.knots_ = {{0.0, diameter_m}, {1.0, diameter_m}};
    return law;
}

DiameterLaw DiameterLaw::classes(std::vector<double> diameters_m, const std::vector<double>& shares) {
    assert(!diameters_m.empty() && diameters_m.size() == shares.size());
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    DiameterLaw law;
    law.steps_ = true;
    double below = 0.0;
    for (std::size_t i = 0; i < diameters_m.size(); ++i) {
        law.knots_.emplace_back(below, diameters_m[i]);
        below += shares[i] / sum;
    }
    return law;
}

DiameterLaw DiameterLaw::uniform(double low_m, double high_m) {
    DiameterLaw law;
    law.knots_ = {{0.0, low_m}, {1.0, high_m}};
    return law;
}

DiameterLaw DiameterLaw::lognormal(double mean_m, double deviation_m, double low_m, double high_m) {
    const double ratio = deviation_m / mean_m;
    const double log_deviation = std::sqrt(config::ln_of(1.0 + ratio * ratio));
    const double log_mean = config::ln_of(mean_m) - 0.5 * log_deviation * log_deviation;
    constexpr int knots = 4096;
    DiameterLaw law;
    for (int i = 0; i <= knots; ++i) {
        const double share = std::clamp(static_cast<double>(i) / knots, 1e-6, 1.0 - 1e-6);
        const double diameter_m = config::exp_of(log_mean + log_deviation * config::normal_quantile(share));
        law.knots_.emplace_back(static_cast<double>(i) / knots, std::clamp(diameter_m, low_m, high_m));
    }
    return law;
}

double DiameterLaw::at(double u) const {
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), u,
                                        [](double value, const auto& knot) { return value < knot.first; });
    if (above == knots_.end()) {
        return knots_.back().second;
    }
    const auto& [share_high, high_m] = *above;
    const auto& [share_low, low_m] = *(above - 1);
    return steps_ ? low_m : low_m + (high_m - low_m) * (u - share_low) / (share_high - share_low);
}

double DiameterLaw::largest_m() const {
    return std::max_element(knots_.begin(), knots_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->second;
}

double DiameterLaw::smallest_m() const {
    return std::min_element(knots_.begin(), knots_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->second;
}

double DiameterLaw::mean_m() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const double next_share = i + 1 < knots_.size() ? knots_[i + 1].first : 1.0;
        const double next_m = i + 1 < knots_.size() && !steps_ ? knots_[i + 1].second : knots_[i].second;
        sum += (next_share - knots_[i].first) * 0.5 * (knots_[i].second + next_m);
    }
    return sum;
}

DiameterRange diameter_range(const StartLaw& common, std::span<const ReleaseSource> sources) {
    DiameterRange range{common.diameter.smallest_m(), common.diameter.largest_m(), common.diameter.mean_m()};
    // Laws of many knots are asked once for all neighbours that share them.
    std::vector<std::pair<const StartLaw*, std::uint64_t>> laws;
    for (const ReleaseSource& source : sources) {
        const StartLaw* law = source.own_start ? source.own_start.get() : &common;
        if (laws.empty() || laws.back().first != law) {
            laws.emplace_back(law, 0);
        }
        laws.back().second += source.rocks;
    }
    std::uint64_t rocks = 0;
    double sum_m = 0.0;
    for (const auto& [law, of_law] : laws) {
        if (of_law > 0) {
            const double largest_m = law->diameter.largest_m();
            const double smallest_m = law->diameter.smallest_m();
            range.smallest_m = rocks == 0 ? smallest_m : std::min(range.smallest_m, smallest_m);
            range.largest_m = rocks == 0 ? largest_m : std::max(range.largest_m, largest_m);
            rocks += of_law;
            sum_m += static_cast<double>(of_law) * law->diameter.mean_m();
        }
    }
    // A single law gives its own mean to the last bit.
    range.mean_m = laws.size() == 1 ? laws.front().first->diameter.mean_m()
                   : rocks > 0      ? sum_m / static_cast<double>(rocks)
                                    : range.mean_m;
    return range;
}

double largest_radius_m(const StartLaw& common, std::span<const ReleaseSource> sources) {
    double largest_m = 0.5 * diameter_range(common, sources).largest_m;
    const auto widen = [&](const StartLaw& law) {
        if (law.shape) {
            largest_m = std::max(largest_m, law.shape->largest_radius_m(law.diameter.largest_m()));
        }
    };
    widen(common);
    const StartLaw* last = nullptr;
    for (const ReleaseSource& source : sources) {
        if (source.own_start && source.own_start.get() != last) {
            last = source.own_start.get();
            widen(*last);
        }
    }
    return largest_m;
}

namespace {

/// Unit vector in plan at a share of the full circle.
Eigen::Vector2d any_direction(double share) {
    const double quarters = 4.0 * share;
    const int quarter = static_cast<int>(quarters);
    const config::SinCos turn = config::sin_cos_of((quarters - quarter) * 0.5 * std::numbers::pi);
    const Eigen::Vector2d first{turn.cos, turn.sin};
    const Eigen::Vector2d next{-turn.sin, turn.cos};
    return (quarter >= 2 ? -1.0 : 1.0) * (quarter % 2 == 0 ? first : next);
}

/// A place in a source: anywhere, or its middle; in the rock's own stretch where rocks are spread evenly.
Eigen::Vector2d place_in(const ReleaseSource& source, std::uint64_t rock, bool anywhere,
                         const config::FourUniforms& draws) {
    const double drawn = anywhere ? draws[0] : 0.5;
    const double u =
        source.evenly && source.rocks > 0
            ? (static_cast<double>(rock - source.first_rock) + drawn) / static_cast<double>(source.rocks)
            : drawn;
    const double v = anywhere ? draws[1] : 0.5;
    const Eigen::Vector2d span_m = source.last_m - source.first_m;
    const bool cell = source.kind == ReleaseSource::Kind::cell;
    return source.first_m + Eigen::Vector2d{u * span_m.x(), (cell ? v : u) * span_m.y()};
}

/// Draws the place of a rock and returns its triangle. A source may reach over the border of the terrain or
/// of its polygon: places beyond are drawn again. A polygon fills half of the rectangle about it, a thin one
/// across it a hundredth; 1000 draws miss that with a chance of 4e-5, and its inner place is taken then
/// [choice].
std::optional<std::uint32_t> place_on(const Slope& slope, const ReleaseSource& source, const StartLaw& law,
                                      config::StreamKey key, const config::RandomStream& stream,
                                      Eigen::Vector2d& place) {
    const std::uint32_t most_places = !source.outline ? 16 : law.random_place ? 1000 : 0;
    for (std::uint32_t k = 0; k < most_places; ++k) {
        place = place_in(source, key.id, law.random_place, stream.uniforms_of(k == 0 ? 0 : k + 1));
        if (source.outline && !config::point_in_polygon(source.outline->polygon, {place.x(), place.y()})) {
            continue;
        }
        if (const auto triangle = slope.terrain.locate(place.x(), place.y())) {
            return triangle;
        }
    }
    if (!source.outline) {
        return std::nullopt;
    }
    place = source.outline->inner_m;
    return slope.terrain.locate(place.x(), place.y());
}

/// The heading in plan before it is scattered. `any` is a uniform draw, for flat ground, which has no fall
/// line.
Eigen::Vector2d heading_on(const Plane& plane, const StartLaw& law, double any) {
    if (law.azimuth) {
        // Clockwise from north instead of counter-clockwise from east: x and y change places.
        const double turns = law.azimuth->in_radians() / (2.0 * std::numbers::pi);
        const Eigen::Vector2d mirrored = any_direction(turns - std::floor(turns));
        return {mirrored.y(), mirrored.x()};
    }
    const double steepness = plane.gradient.norm();
    // The contact zone leaves rounding errors of a gradient on flat ground.
    constexpr double flat = 1e-9;
    if (steepness > (law.along_x_on_flat ? flat : 0.0)) {
        return -plane.gradient / steepness;
    }
    return law.along_x_on_flat ? Eigen::Vector2d{Eigen::Vector2d::UnitX()} : any_direction(any);
}

}  // namespace

std::optional<RockStart> start_of(const Slope& slope, const ReleaseSource& source,
                                  std::uint32_t source_number, const StartLaw& common, config::StreamKey key,
                                  double size_factor) {
    const StartLaw& law = source.own_start ? *source.own_start : common;
    const config::RandomStream stream{key, config::Purpose::release};
    const config::FourUniforms rest = stream.uniforms_of(1);
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    const std::optional<std::uint32_t> triangle = place_on(slope, source, law, key, stream, place);
    if (!triangle) {
        return std::nullopt;
    }
    const double x_m = place.x();
    const double y_m = place.y();
    const Plane plane = slope.terrain.plane_of(*triangle);
    const Eigen::Vector2d heading = heading_on(plane, law, rest[2]);
    const config::SinCos turn = config::sin_cos_of((2.0 * rest[1] - 1.0) * law.heading_scatter.in_radians());
    const Eigen::Vector2d direction{turn.cos * heading.x() - turn.sin * heading.y(),
                                    turn.sin * heading.x() + turn.cos * heading.y()};
    const config::SinCos dip = config::sin_cos_of(law.dip.in_radians());
    RockStart start;
    start.id = key.id;
    start.source = source_number;
    start.triangle = *triangle;
    const double drawn_m = law.diameter.at(rest[0]) * (source.own_start ? 1.0 : size_factor);
    start.rock = Rock::sphere(drawn_m, law.density_kgpm3);
    start.rolling = law.height_m <= 0.0;
    const Eigen::Vector3d down_dip{direction.x(), direction.y(),
                                   start.rolling ? plane.gradient.dot(direction) : -dip.sin / dip.cos};
    start.position_m = {x_m, y_m, plane.height_m(x_m, y_m) + std::max(0.0, law.height_m)};
    start.velocity_mps = law.speed_mps * down_dip.normalized();
    start.heading = direction;
    if (law.shape) {
        start.block = law.shape->draw(start.rock.diameter_m, law.density_kgpm3, key);
        const solids::Solid& solid = *start.block.solid;
        if (!solid.is_sphere()) {
            // The volume of a hull gives back the drawn diameter but for rounding; tables by size go by it.
            constexpr double rounding = 1e-9;
            const bool as_drawn = std::abs(solid.diameter_m() - drawn_m) <= rounding * drawn_m;
            start.rock = Rock::sphere(as_drawn ? drawn_m : solid.diameter_m(), law.density_kgpm3);
            start.rock.mass_kg = solid.mass_kg;
        }
    }
    const config::FourUniforms own = config::RandomStream{key, config::Purpose::rock_losses}.uniforms_of(0);
    static const config::TruncatedNormal within_two_deviations{2.0};
    start.rock.elongation = law.elongation.at(own[0], within_two_deviations(own[1]));
    start.rock.own_losses = within_two_deviations(own[2]);
    return start;
}

}  // namespace rockfall
