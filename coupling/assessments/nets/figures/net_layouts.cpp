#include "coupling/assessments/nets/figures/net_layouts.hpp"

#include <string>

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/figures/siting_layouts.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr const char* simulated = "simulated";
constexpr const char* counted = "counted over the simulated rocks";
constexpr const char* from_list = "input nets.file";
constexpr const char* exact_interval = "Clopper and Pearson 1934";
constexpr const char* ranks = "order statistics by the binomial law";
constexpr const char* how_needed = "coupling/assessments/nets/README.md";

Column net_column() {
    return {"net", "text", "name of the net", from_list};
}

std::vector<Column> quantity_columns(const std::string& name, const std::string& unit,
                                     const std::string& unit_shown, const std::string& meaning) {
    std::vector<Column> columns;
    const auto add = [&](const std::string& figure, const std::string& words, const char* source) {
        columns.push_back(
            {joined(name, "_", figure, "_", unit), unit_shown, joined(words, " of ", meaning), source});
    };
    add("mean", "mean", simulated);
    add("50", "median", simulated);
    add("90", "90th percentile (empty: fewer than 10 rocks)", simulated);
    add("95", "95th percentile (empty: fewer than 20 rocks)", simulated);
    add("95_low", "lower end of the 95 % interval of the 95th percentile", ranks);
    add("95_high", "upper end (empty: fewer than 72 rocks) of the 95 % interval of the 95th percentile",
        ranks);
    add("99", "99th percentile (empty: fewer than 100 rocks)", simulated);
    add("99_low", "lower end of the 95 % interval of the 99th percentile", ranks);
    add("99_high", "upper end (empty: fewer than 367 rocks) of the 95 % interval of the 99th percentile",
        ranks);
    add("max", "largest value", simulated);
    return columns;
}

TableLayout nets() {
    std::vector<Column> first{
        net_column(),
        cover_column(),
        {"class", "text", "energy class of the net; empty where capacity_kj was given", from_list},
        {"capacity_kj", "kJ", "kinetic energy that the net takes at most", from_list},
        {"net_height_m", "m", "upper edge above the ground", from_list},
        {"gap_m", "m", "lower edge above the ground", from_list},
        {"length_m", "m", "length of the net in plan", from_list},
        {"rocks", "-", "rocks that fell", counted},
        {"reached", "-", "rocks that crossed the line of the net; each counts once, as it first did",
         counted},
        {"reached_percent", "%", "share of the rocks that fell", counted},
        {"reached_low_percent", "%", "lower end of its 95 % interval", exact_interval},
        {"reached_high_percent", "%", "upper end of its 95 % interval", exact_interval},
        {"inexact_rocks", "-",
         "`bannwald net try` alone: rocks that break through another net and would cross this line where no "
         "net stands; whether they reach it is not known, and all figures of the row leave them out",
         counted}};
    for (const auto& [name, meaning] :
         {std::pair{"held", "rocks that the net held"}, std::pair{"over", "rocks that passed over it"},
          std::pair{"below", "rocks that passed through the gap below it"},
          std::pair{"broke", "rocks that broke through it"}}) {
        first.push_back({name, "-", meaning, counted});
        first.push_back({joined(name, "_percent"), "%", "share of the rocks that reached the net", counted});
        first.push_back(
            {joined(name, "_low_percent"), "%", "lower end of its 95 % interval", exact_interval});
        first.push_back(
            {joined(name, "_high_percent"), "%", "upper end of its 95 % interval", exact_interval});
    }
    const std::vector<Column> last{
        {"wanted_percent", "%", "share of the rocks that reach the net which it should hold",
         "input nets.wanted_share"},
        {"class_needed", "text",
         "energy class needed for it; empty: too few rocks reach the net for an estimate (below 1 / (1 - "
         "wanted))",
         how_needed},
        {"energy_needed_kj", "kJ", "energy that half of what may pass does exceed at most", how_needed},
        {"height_needed_m", "m",
         "lowest height of that class that holds the wanted share: what rocks' centres pass below; radius "
         "and "
         "margins come on top",
         how_needed},
        {"held_then_percent", "%", "share of the rocks that such a net would hold", counted},
        {"held_then_low_percent", "%", "lower end of its 95 % interval", exact_interval},
        {"held_then_high_percent", "%", "upper end of its 95 % interval", exact_interval}};
    return {"nets.csv", "a net on one slope",
            together(first,
                     quantity_columns("energy", "kj", "kJ",
                                      joined("the kinetic energy in front of the net (",
                                             rockfall::what_energies_count(), ")")),
                     quantity_columns("height", "m", "m",
                                      "the height of the rock's centre above the ground, vertical"),
                     last)};
}

TableLayout net_needs() {
    return {
        "net_needs.csv",
        "an energy class at a net on one slope; none where too few rocks reach it for an estimate",
        {net_column(),
         cover_column(),
         {"class", "text", "energy class", "net_classes.csv"},
         {"mel_kj", "kJ", "maximum energy level of the class; empty: open", "net_classes.csv"},
         {"height_needed_m", "m",
          "lowest height at which the class holds the wanted share of the rocks that reach the net, rounded "
          "up to 10 cm; empty: not at any height",
          how_needed},
         {"held_percent", "%", "share that it holds then; where no height suffices, at any height", counted},
         {"recommended", "text", "yes: the class that nets.csv names", how_needed}}};
}

TableLayout net_crossings() {
    return {"net_crossings.csv",
            "a rock that crossed the line of a net on one slope",
            {{"rock", "-", "number of the rock; the same rock falls with forest and over the bare slope",
              simulated},
             cover_column(),
             net_column(),
             {"outcome", "text", "held, over, below or broke", simulated},
             {"first", "text", "yes: the rock crossed this line for the first time", simulated},
             {"along_m", "m", "place along the line of the net in plan, from its first corner", simulated},
             {"height_m", "m", "height of the rock's centre above the ground, vertical", simulated},
             {"x_m", "m", "easting of the crossing", simulated},
             {"y_m", "m", "northing of the crossing", simulated},
             {"energy_kj", "kJ",
              joined("kinetic energy in front of the net, ", rockfall::what_energies_count()), simulated},
             {"translational_kj", "kJ", "the translational part of it", simulated},
             {"speed_mps", "m/s", "speed in front of the net", simulated}}};
}

TableLayout net_inexact() {
    return {"net_inexact.csv",
            "a rock that breaks through a net on one slope",
            {{"rock", "-", "number of the rock; what it does behind the net is not known", simulated},
             cover_column(),
             net_column()}};
}

TableLayout net_places() {
    return {
        "net_places.csv",
        "a place of a net on one slope",
        {{"net", "text", "name of the line to protect", "input --nets"},
         {"distance_m", "m", "in plan, upslope of the line", "definition"},
         {"azimuth_deg", "deg", "direction upslope in which the net is moved, clockwise from north",
          how_needed},
         {"azimuth_from", "text",
          "where it comes from: rocks that reach the line, gradient of the ground or given (--azimuth)",
          how_needed},
         cover_column(),
         {"rocks", "-", "rocks that fell", counted},
         {"arrive", "-", "rocks that reach the line where no net stands", counted},
         {"kept", "-", "those of them that a net at this place holds", counted},
         {"kept_percent", "%", "share of them", counted},
         {"residual_kj", "kJ",
          "energy on the line of the rocks that the net does not hold, per rock that fell; of rocks that "
          "break through as without the net",
          how_needed},
         {"reached", "-", "rocks that reach the net at this place", counted},
         {"held_percent", "%", "share of them that it holds", counted},
         {"energy_95_kj", "kJ", "95th percentile of the energy in front of the net", simulated},
         {"energy_99_kj", "kJ", "99th percentile of it", simulated},
         {"height_95_m", "m", "95th percentile of the height of the rock's centre above the ground",
          simulated},
         {"height_99_m", "m", "99th percentile of it", simulated},
         {"class_needed", "text", "energy class needed here to hold the wanted share", how_needed},
         {"height_needed_m", "m", "height needed with it", how_needed},
         {"best", "text",
          "yes: least residual energy of all places of the line, with forest if there is one; none where no "
          "place keeps a rock from it",
          how_needed},
         {"tie", "text", "yes: leaves at most a tenth more energy than the best", how_needed}}};
}

}  // namespace

std::vector<TableLayout> net_place_layouts() {
    std::vector<TableLayout> all = siting::siting_layouts();
    all.push_back(net_places());
    return all;
}

std::vector<TableLayout> net_try_layouts() {
    std::vector<TableLayout> all = net_layouts();
    all.push_back(net_inexact());
    return all;
}

const std::vector<TableLayout>& net_command_layouts() {
    static const std::vector<TableLayout> layouts = [] {
        std::vector<TableLayout> all = net_place_layouts();
        all.push_back(net_inexact());
        return all;
    }();
    return layouts;
}

std::vector<TableLayout> net_layouts() {
    return {nets(), net_needs(), net_crossings()};
}

}  // namespace coupling
