#include "coupling/assessments/nets/figures/net_tables.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/design_columns.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::joined;
using config::percent;

constexpr const char* from_list = "input nets.file";
constexpr const char* how_needed = "coupling/assessments/nets/README.md";

/// A net on one slope.
struct NetOnSlope : NetFigures {
    const NetRecord& record;
    double design_percentile;
};

template <class Row>
ColumnsOf<Row> net_columns() {
    return {{net_name_column(), [](const Row& row) { return row.record.name; }},
            {cover_column(), [](const Row& row) { return name_of(row.cover); }}};
}

/// Rocks, their share and, unless there are none at all, its interval: held, held_percent, ...
ColumnsOf<Share> outcome_share_columns(const std::string& name, const char* meaning, const char* share) {
    return {{name, meaning, from_counting, &Share::part},
            {share_columns(name, share), [](const Share& of) {
                 constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
                 return of.whole > 0 ? of : Share{of.part, of.whole, of.value, {unknown, unknown}};
             }}};
}

ColumnsOf<NetOnSlope> given_columns() {
    return {net_columns<NetOnSlope>(),
            {"class", "energy class of the net; empty where capacity_kj was given", from_list,
             [](const auto& row) { return row.record.energy_class; }},
            {"capacity_kj", 1, "kinetic energy that the net takes at most", from_list,
             [](const auto& row) { return row.record.net.capacity_j / j_per_kj; }},
            {"net_height_m", 2, "upper edge above the ground", from_list,
             [](const auto& row) { return row.record.net.height_m; }},
            {"gap_m", 2, "lower edge above the ground", from_list,
             [](const auto& row) { return row.record.net.gap_m; }},
            {"length_m", 2, "length of the net in plan", from_list,
             [](const auto& row) { return length_m(row.record.net); }}};
}

/// Which rocks reach a net and what becomes of them.
ColumnsOf<NetFigures> outcome_columns() {
    const auto outcome = [](std::size_t number) {
        return [number](const NetFigures& of) -> const Share& { return of.outcome[number]; };
    };
    constexpr const char* of_reached = "share of the rocks that reached the net";
    return {
        {"rocks", "rocks that fell", from_counting, [](const auto& of) { return of.reached.whole; }},
        {outcome_share_columns("reached",
                               "rocks that crossed the line of the net; each counts once, as it first did",
                               "share of the rocks that fell"),
         &NetFigures::reached},
        {"inexact_rocks",
         "`bannwald net try` alone: rocks that break through another net and would cross this line where no "
         "net stands; whether they reach it is not known, and all figures of the row leave them out",
         from_counting, &NetFigures::inexact},
        {outcome_share_columns("held", "rocks that the net held", of_reached), outcome(0)},
        {outcome_share_columns("over", "rocks that passed over it", of_reached), outcome(1)},
        {outcome_share_columns("below", "rocks that passed through the gap below it", of_reached),
         outcome(2)},
        {outcome_share_columns("broke", "rocks that broke through it", of_reached), outcome(3)}};
}

TableOf<NetOnSlope> net_table() {
    return {
        "nets.csv",
        "Each net on each slope: rocks that reach it, held, over, below, broken through; energy and height "
        "with intervals; the design that its rocks ask for.",
        "a net on one slope",
        {given_columns(),
         outcome_columns(),
         {net_quantity_columns(
              "energy", "kj",
              joined("the kinetic energy in front of the net (", rockfall::what_energies_count(), ")")),
          &NetFigures::energy_kj},
         {net_quantity_columns("height", "m",
                               "the height of passage: the rock's upper edge (centre plus radius) above the "
                               "ground, vertical"),
          &NetFigures::height_m},
         {"design_percentile", 2, "percentile by which the net is designed", "input design.percentile",
          &NetOnSlope::design_percentile},
         {design_columns(), &NetFigures::design}}};
}

/// An energy class at a net on one slope.
struct NeedRow : ClassOutcome {
    const NetRecord& record;
    Cover cover;
};

TableOf<NeedRow> need_table() {
    return {
        "net_needs.csv",
        "What each energy class would hold at the height of the design of each net.",
        "an energy class at a net on one slope; none where too few rocks reach it for an estimate",
        {net_columns<NeedRow>(),

         {"class", "energy class", "net_classes.csv", &ClassOutcome::energy_class},
         {"mel_kj", 0, "maximum energy level of the class; empty: open", "net_classes.csv",
          &ClassOutcome::mel_kj},
         {"sel_kj", 0, "service energy level of the class; empty: none", "net_classes.csv",
          &ClassOutcome::sel_kj},
         {"height_m", 2,
          "height of the design: the next one on offer; where none is that high, the design height rounded "
          "up to 10 cm",
          how_needed, &ClassOutcome::height_m},
         {"held_percent", 4, "share of the rocks that reach the net which it would hold", from_counting,
          [](const auto& row) { return percent * row.held.value; }},
         {"over", "rocks that would pass over it", from_counting,
          [](const auto& row) { return row.over.part; }},
         {"through", "rocks that would break through it", from_counting,
          [](const auto& row) { return row.through.part; }},
         {"recommended", "yes: the class of the design", how_needed, &ClassOutcome::recommended}}};
}

/// A rock that crossed the line of a net.
struct CrossingRow : rockfall::NetCrossingRecord {
    const NetRecord& record;
    const NetRow& entry;
    const Eigen::Vector2d& origin_m;
};

TableOf<CrossingRow> crossing_table() {
    using Crossing = rockfall::NetCrossingRecord;
    return {
        "net_crossings.csv",
        "Each rock in the plane of each net: where, how high, how fast, what became of it.",
        "a rock that crossed the line of a net on one slope",
        {{rock_column(), [](const auto& row) { return row.entry.rock; }},
         {cover_column(), [](const auto& row) { return name_of(row.entry.cover); }},
         {net_name_column(), [](const auto& row) { return row.record.name; }},

         {"outcome", "held, over, below or broke",
          [](const auto& crossing) { return name_of(crossing.outcome); }},
         {"first", "yes: the rock crossed this line for the first time", &Crossing::first},
         {"along_m", 2, "place along the line of the net in plan, from its first corner", &Crossing::along_m},
         {"height_m", 3, "height of the rock's centre above the ground, vertical", &Crossing::height_m},
         {"radius_m", 3, "radius of the rock: its upper edge is height_m plus this above the ground",
          &Crossing::radius_m},
         {"x_m", 2, "easting of the crossing",
          [](const auto& row) { return static_cast<double>(row.x_m) + row.origin_m.x(); }},
         {"y_m", 2, "northing of the crossing",
          [](const auto& row) { return static_cast<double>(row.y_m) + row.origin_m.y(); }},

         {"energy_kj", 3, joined("kinetic energy in front of the net, ", rockfall::what_energies_count()),
          [](const auto& crossing) { return static_cast<double>(crossing.energy_j) / j_per_kj; }},
         {"translational_kj", 3, "the translational part of it",
          [](const auto& crossing) { return static_cast<double>(crossing.translational_j) / j_per_kj; }},
         {"speed_mps", 3, "speed in front of the net", &Crossing::speed_mps}}};
}

}  // namespace

ColumnsOf<NetQuantity> net_quantity_columns(const std::string& name, const std::string& ending,
                                            const std::string& meaning) {
    constexpr const char* ranks = "order statistics by the binomial law";
    const auto figure = [&](const char* of, const char* words, const char* source, auto value) {
        return ColumnsOf<NetQuantity>{joined(name, "_", of, "_", ending), 3, joined(words, " of ", meaning),
                                      source, value};
    };
    const auto low = [](QuantileEstimate NetQuantity::*of) {
        return [of](const NetQuantity& q) {
            return std::isnan((q.*of).value) ? (q.*of).value : (q.*of).interval.low;
        };
    };
    const auto high = [](QuantileEstimate NetQuantity::*of) {
        return [of](const NetQuantity& q) {
            return std::isnan((q.*of).value) ? (q.*of).value : (q.*of).interval.high;
        };
    };
    return {figure("mean", "mean", from_simulation, &NetQuantity::mean),
            figure("50", "median", from_simulation, &NetQuantity::p50),
            figure("90", "90th percentile (empty: fewer than 10 rocks)", from_simulation, &NetQuantity::p90),
            figure("95", "95th percentile (empty: fewer than 20 rocks)", from_simulation,
                   [](const NetQuantity& q) { return q.p95.value; }),
            figure("95_low", "lower end of the 95 % interval of the 95th percentile", ranks,
                   low(&NetQuantity::p95)),
            figure("95_high",
                   "upper end (empty: fewer than 72 rocks) of the 95 % interval of the 95th percentile",
                   ranks, high(&NetQuantity::p95)),
            figure("99", "99th percentile (empty: fewer than 100 rocks)", from_simulation,
                   [](const NetQuantity& q) { return q.p99.value; }),
            figure("99_low", "lower end of the 95 % interval of the 99th percentile", ranks,
                   low(&NetQuantity::p99)),
            figure("99_high",
                   "upper end (empty: fewer than 367 rocks) of the 95 % interval of the 99th percentile",
                   ranks, high(&NetQuantity::p99)),
            figure("max", "largest value", from_simulation, &NetQuantity::max)};
}

Column net_name_column() {
    return {"net", "text", "name of the net", from_list};
}

std::vector<TableLayout> net_layouts() {
    return {net_table(), need_table(), crossing_table()};
}

void write_nets(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetFigures> figures,
                const DesignSettings& design) {
    net_table().write_to(out, [&](auto& rows) {
        for (const NetFigures& of : figures) {
            rows.add({of, nets[of.net], design.percentile});
        }
    });
}

void write_net_needs(std::ostream& out, std::span<const NetRecord> nets,
                     std::span<const NetFigures> figures) {
    need_table().write_to(out, [&](auto& rows) {
        for (const NetFigures& of : figures) {
            for (const ClassOutcome& outcome : of.classes) {
                rows.add({outcome, nets[of.net], of.cover});
            }
        }
    });
}

void write_net_crossings(std::ostream& out, std::span<const NetRecord> nets,
                         std::span<const NetRow> crossings, const Eigen::Vector2d& origin_m) {
    crossing_table().write_to(out, [&](auto& rows) {
        for (const NetRow& entry : crossings) {
            rows.add({entry.crossing, nets[entry.crossing.net], entry, origin_m});
        }
    });
}

std::vector<NetFigures> net_figures(const RunResults& results) {
    std::vector<NetFigures> all;
    const rockfall::Strata strata =
        results.draws == nullptr ? rockfall::Strata{} : results.draws->strata(results.scenario.run.seed);
    for (const Cover cover : covers_of(results)) {
        const std::vector<NetFigures> of_slope =
            net_figures(results.site.nets, results.net_rows, cover, results.tally.runs[index_of(cover)].rocks,
                        results.scenario.design, strata);
        all.insert(all.end(), of_slope.begin(), of_slope.end());
    }
    return all;
}

std::vector<WrittenFile> write_net_tables(const RunResults& results, const std::filesystem::path& folder) {
    const std::vector<NetRecord>& nets = results.site.nets;
    if (nets.empty()) {
        return {};
    }
    const std::vector<NetFigures> figures = net_figures(results);
    const auto write = [&](const auto& table, const auto& fill) {
        return write_table(folder, table.file, table.sentence, fill);
    };
    return {write(net_table(),
                  [&](std::ostream& out) { write_nets(out, nets, figures, results.scenario.design); }),
            write(need_table(), [&](std::ostream& out) { write_net_needs(out, nets, figures); }),
            write(crossing_table(), [&](std::ostream& out) {
                write_net_crossings(out, nets, results.net_rows, results.site.origin_m());
            })};
}

}  // namespace coupling
