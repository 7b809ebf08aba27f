#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/report/calibration_page.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/report/map/map_colours.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;
using report::Axis;
using report::Chart;
using report::ChartPoint;
using report::ChartRange;
using report::page_text;

constexpr double in_percent = 100.0;
constexpr std::size_t lowest_band = 0;
constexpr std::size_t middle_band = 2;
constexpr std::size_t highest_band = band_shares.size() - 1;

std::string axis_of(Seen seen) {
    switch (seen) {
        case Seen::stops:
            return page_text("Distance from the sources towards the observed stops, m");
        case Seen::run_out:
            return page_text("Distance from the release or the nearest source, m");
        case Seen::scar_heights:
            return page_text("Height above the ground, m");
        case Seen::scar_places:
            return page_text("Distance from the sources towards the scars, m");
        case Seen::speed:
            return page_text("Speed, m/s");
        case Seen::height:
            return page_text("Height of the underside above the ground, m");
        case Seen::energy:
        case Seen::translation:
            return page_text("Energy, kJ");
        case Seen::tree_dbh:
            return page_text("DBH of hit stems, cm");
        case Seen::tree_places:
            return page_text("Distance from the sources towards the hit stems, m");
        case Seen::tree_scars:
            return page_text("Scars of a stem");
        case Seen::jumps:
            return page_text("Length of a jump, m");
        case Seen::passing:
        case Seen::outline_share:
        case Seen::outline_reach:
            return "";
    }
    return "";
}

std::string curve_chart(const Calibration& calibration, std::size_t number) {
    const Observation& observation = calibration.observations[number];
    const std::vector<CurvePoint>& curve = calibration.judgement.observations[number].curve;
    Chart chart{name_on_page(observation, calibration),
                {axis_of(observation.seen), curve.front().value, curve.back().value},
                Axis::from_zero(page_text("% of them below"), in_percent)};
    std::vector<ChartRange> inner;
    std::vector<ChartRange> outer;
    std::vector<ChartPoint> before_low;
    std::vector<ChartPoint> before_high;
    std::vector<ChartPoint> median;
    std::vector<ChartPoint> seen;
    for (const CurvePoint& point : curve) {
        outer.push_back({point.value, in_percent * point.predicted[lowest_band],
                         in_percent * point.predicted[highest_band]});
        inner.push_back({point.value, in_percent * point.predicted[lowest_band + 1],
                         in_percent * point.predicted[highest_band - 1]});
        median.push_back({point.value, in_percent * point.predicted[middle_band]});
        seen.push_back({point.value, in_percent * point.observed});
        before_low.push_back({point.value, in_percent * point.before[lowest_band]});
        before_high.push_back({point.value, in_percent * point.before[highest_band]});
    }
    chart.add_band("forest", outer);
    chart.add_band("forest", inner);
    chart.add_line("most", before_low);
    chart.add_line("most", before_high);
    chart.add_line("forest", median);
    chart.add_line("observed", seen);
    chart.add_name("observed", page_text("observed"));
    chart.add_name("forest", page_text("sets that were kept, median"));
    chart.add_band_name("forest", page_text("50 and 90 %, as many as observed"));
    chart.add_name("most", page_text("90 % by the widths alone"));
    return chart.figure("");
}

/// A diamond around a place, for a map.
config::Shape diamond(const Eigen::Vector2d& place_m, double radius_m) {
    config::Shape shape;
    shape.kind = config::Shape::Kind::polygon;
    const double x = place_m.x();
    const double y = place_m.y();
    shape.parts = {
        {{x - radius_m, y}, {x, y + radius_m}, {x + radius_m, y}, {x, y - radius_m}, {x - radius_m, y}}};
    return shape;
}

bool sees_stops(const Calibration& calibration, std::size_t site) {
    return std::any_of(calibration.observations.begin(), calibration.observations.end(),
                       [&](const Observation& observation) {
                           return observation.seen == Seen::stops && observation.site == site;
                       });
}

/// What sets show of the stops at a site.
std::vector<const Sample*> simulated_stops(const Calibration& calibration, std::size_t site) {
    std::vector<const Sample*> samples;
    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
        if (calibration.observations[i].seen == Seen::stops && calibration.observations[i].site == site) {
            for (const Sample& sample : calibration.judgement.observations[i].sets) {
                samples.push_back(&sample);
            }
        }
    }
    if (samples.empty()) {
        for (const Sample& sample : calibration.judgement.sites[site].stops) {
            samples.push_back(&sample);
        }
    }
    return samples;
}

/// Stops of all sets, as shares of all of them, in cells of a raster.
config::Raster<float> density_of(const Calibration& calibration, std::size_t number) {
    const Site& site = calibration.sites[number]->site;
    config::Raster<float> density{site.map_frame, 0.0F};
    double all = 0.0;
    for (const Sample* sample : simulated_stops(calibration, number)) {
        for (const Eigen::Vector2d& point : sample->points) {
            const Eigen::Vector2d place = point + site.origin_m();
            if (site.map_frame.covers(place.x(), place.y())) {
                density.at(site.map_frame.cell_at(place.x(), place.y())) += 1.0F;
            }
            all += 1.0;
        }
    }
    for (float& value : density.values) {
        value *= static_cast<float>(1000.0 / std::max(1.0, all));
    }
    return density;
}

/// A further map of a page has names of its own for what its parts refer to.
std::string with_own_names(std::string map, const std::string& ending) {
    for (const auto& [begin, end] :
         {std::pair{"id=\"", "\""}, std::pair{"href=\"#", "\""}, std::pair{"url(#", ")"}}) {
        const std::string_view opening{begin};
        for (std::size_t at = map.find(opening); at != std::string::npos;) {
            const std::size_t close = map.find(end, at + opening.size());
            map.insert(close, ending);
            at = map.find(opening, close);
        }
    }
    return map;
}

}  // namespace

namespace {

std::string name_at_site(const Observation& observation, const Site& site) {
    const auto at_target = [&](const std::string& quantity) {
        return page_text(
            "{quantity} at {target}",
            {{"quantity", quantity}, {"target", report::escaped(site.targets[observation.target].name)}});
    };
    const auto of_group = [&](const std::string& what) {
        const auto colon = observation.name.find(':');
        return colon == std::string::npos
                   ? what
                   : joined(what, ", ", report::escaped(observation.name.substr(colon + 1)));
    };
    switch (observation.seen) {
        case Seen::stops:
            return of_group(page_text("Stops"));
        case Seen::run_out:
            return of_group(page_text("Run-out"));
        case Seen::scar_heights:
            return page_text("Heights of scars");
        case Seen::scar_places:
            return page_text("Places of scars");
        case Seen::speed:
            return at_target(page_text("Speed"));
        case Seen::height:
            return at_target(page_text("Height"));
        case Seen::energy:
            return at_target(page_text("Energy"));
        case Seen::translation:
            return at_target(page_text("Energy of translation"));
        case Seen::passing:
            return at_target(page_text("Share of rocks that pass"));
        case Seen::tree_dbh:
            return page_text("DBH of hit stems");
        case Seen::tree_places:
            return page_text("Places of hit stems");
        case Seen::tree_scars:
            return page_text("Scars of a stem");
        case Seen::outline_share:
            return page_text("Share of stops within the outline");
        case Seen::outline_reach:
            return page_text("Reach of the outline from the sources");
        case Seen::jumps:
            return page_text("Lengths of jumps");
    }
    return "";
}

}  // namespace

std::string at_site(const std::string& what, const Calibration& calibration, std::size_t site) {
    return calibration.has_several_sites()
               ? page_text("{what} ({site})",
                           {{"what", what}, {"site", report::escaped(calibration.sites[site]->name)}})
               : what;
}

std::string name_on_page(const Observation& observation, const Calibration& calibration) {
    return at_site(name_at_site(observation, calibration.site_of(observation).site), calibration,
                   observation.site);
}

std::string curve_charts(const Calibration& calibration) {
    std::string charts;
    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
        const Seen seen = calibration.observations[i].seen;
        const bool is_one_figure =
            seen == Seen::passing || seen == Seen::outline_share || seen == Seen::outline_reach;
        if (!is_one_figure && !calibration.judgement.observations[i].curve.empty()) {
            charts += curve_chart(calibration, i);
        }
    }
    return charts;
}

std::string factor_chart(const Calibration& calibration) {
    const std::vector<Learned>& parameters = calibration.judgement.parameters;
    constexpr double deviations_of_90 = 1.645;
    double least = 1.0;
    double most = 1.0;
    std::vector<ChartRange> before;
    std::vector<ChartRange> after;
    std::vector<ChartPoint> medians;
    std::vector<std::string> names;
    for (const Learned& learned : parameters) {
        const double wide = std::exp(deviations_of_90 * learned.component.width);
        names.push_back(std::to_string(names.size() + 1));
        const auto place = static_cast<double>(names.size());
        constexpr double apart = 0.12;
        before.push_back({place - apart, 1.0 / wide, wide});
        after.push_back({place + apart, learned.low, learned.high});
        medians.push_back({place + apart, learned.median});
        least = std::min({least, 1.0 / wide, learned.low});
        most = std::max({most, wide, learned.high});
    }
    Axis x{page_text("Row of the table"), 0.5, static_cast<double>(names.size()) + 0.5};
    x.names = names;
    Chart chart{page_text("Factors before and after"), std::move(x),
                Axis{page_text("Factor"), std::floor(10.0 * least) / 10.0, std::ceil(10.0 * most) / 10.0}};
    chart.add_whiskers("bare", before);
    chart.add_whiskers("forest", after);
    chart.add_dots("forest", medians);
    chart.add_name("bare", page_text("90 % before"));
    chart.add_name("forest", page_text("median and 90 % after"));
    return chart.figure("");
}

namespace {

std::string stop_map_of(const Calibration& calibration, std::size_t number) {
    const Site& site = calibration.sites[number]->site;
    const std::vector<config::Shape>& outline = site.observed_events.outline;
    const bool has_stops = sees_stops(calibration, number);
    if (!has_stops && outline.empty()) {
        return "";
    }
    const config::Raster<float> density = density_of(calibration, number);
    const config::Raster<float> shown = report::without_zeros(density);
    const report::ColourScale scale =
        report::ColourScale::linear(Palette::deposits, report::bulk_of(shown), "‰");
    const report::MapSheet sheet{site};
    std::string drawing = sheet.picture(shown, scale);
    std::string outlines;
    for (const config::Shape& polygon : outline) {
        outlines += sheet.polygon(polygon);
    }
    if (!outlines.empty()) {
        drawing += report::element("g", {{"class", "seen-outline-halo"}}, outlines);
        drawing += report::element("g", {{"class", "seen-outline"}}, outlines);
    }
    const double radius_m = 0.006 * site.map_frame.columns * site.map_frame.cell_width_m;
    for (const Observation& observation : calibration.observations) {
        if (observation.seen != Seen::stops || observation.site != number) {
            continue;
        }
        for (const auto& [sample, style] :
             {std::pair{&observation.fit, "seen-fitted"}, std::pair{&observation.held_out, "seen-held"}}) {
            std::string diamonds;
            for (const Eigen::Vector2d& point : sample->points) {
                diamonds += sheet.polygon(diamond(point + site.origin_m(), radius_m));
            }
            drawing += report::element("g", {{"class", style}}, diamonds);
        }
    }
    const std::string title = at_site(page_text(has_stops ? "Observed stops over those of the sets"
                                                          : "Observed outline over stops of the sets"),
                                      calibration, number);
    std::string caption =
        page_text(has_stops ? "Colours: stops of all sets, of 1000 rocks in a cell. Diamonds: "
                              "observed; filled ones were fitted to, hollow ones held out."
                            : "Colours: stops of all sets, of 1000 rocks in a cell.");
    if (!outline.empty()) {
        caption += joined(" ", page_text("Line: the observed outline."));
    }
    const std::string map = joined(
        sheet.definitions(),
        sheet.figure({title, title, drawing, scale.legend("stops"), caption, {}}, report::MapSize::half));
    return number == 0 ? map : with_own_names(map, joined("_", std::to_string(number)));
}

}  // namespace

std::string stop_map(const Calibration& calibration) {
    std::string maps;
    for (std::size_t site = 0; site < calibration.sites.size(); ++site) {
        maps += stop_map_of(calibration, site);
    }
    return maps;
}

}  // namespace coupling::calibrate
