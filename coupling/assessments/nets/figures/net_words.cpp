#include "coupling/assessments/nets/figures/net_words.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/assessments/nets/figures/net_quantiles.hpp"
#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {
namespace {

/// "95 % of energies up to 312 kJ, of heights of passage up to 1.2 m", as far as they are known.
std::string percentiles_in_words(const NetFigures& figures, const DesignSettings& settings) {
    if (!figures.design) {
        return "";
    }
    return report::page_text(
        "{percentile} % of energies up to {energy_kj} kJ, of heights of passage up to {height_m} m",
        {{"percentile", report::exact(settings.percentile)},
         {"energy_kj", report::three_digits(figures.design->percentile_energy_kj)},
         {"height_m", report::three_digits(figures.design->percentile_height_m)}});
}

/// "design: class 3 (1 000 kJ), 2.5 m high, which would hold 97.1 %".
std::string design_in_words(const NetFigures& figures, const DesignSettings& settings) {
    const std::string need = need_in_words(figures, settings);
    return figures.design
               ? report::page_text("design: {need}, which would hold {held}",
                                   {{"need", need}, {"held", report::percent(figures.design->held.value)}})
               : report::page_text("design: {need}", {{"need", need}});
}

}  // namespace

const std::string& in_words(rockfall::NetOutcome outcome) {
    switch (outcome) {
        case rockfall::NetOutcome::over:
            return report::page_text("Pass over");
        case rockfall::NetOutcome::below:
            return report::page_text("Pass below");
        case rockfall::NetOutcome::broke:
            return report::page_text("Break through");
        case rockfall::NetOutcome::held:
            break;
    }
    return report::page_text("Held");
}

std::string in_words(const BarrierToOrder& barrier) {
    const auto& classes = net_classes();
    const auto known = std::find_if(classes.begin(), classes.end(),
                                    [&](const NetClass& each) { return each.name == barrier.energy_class; });
    const bool is_open = known != classes.end() && std::isinf(known->mel_kj);
    const std::string capacity_kj = report::grouped(static_cast<std::uint64_t>(barrier.capacity_kj));
    const std::string level =
        is_open ? report::page_text(
                      "above {closed_mel_kj} kJ: {energy_needed_kj} kJ",
                      {{"closed_mel_kj", report::grouped(static_cast<std::uint64_t>(strongest_closed_kj()))},
                       {"energy_needed_kj", capacity_kj}})
                : report::page_text("{need_mel_kj} kJ", {{"need_mel_kj", capacity_kj}});
    const std::string net = report::page_text(
        "class {class} ({level}), {height_m} m high",
        {{"class", barrier.energy_class}, {"level", level}, {"height_m", report::exact(barrier.height_m)}});
    return barrier.sold_height_m
               ? net
               : report::page_text("{net}; no net on offer is that high (design.sold_heights_m)",
                                   {{"net", net}});
}

std::string upper_in_words(const BarrierDesign& design) {
    if (!design.spread) {
        return "";
    }
    const BarrierToOrder& upper = design.spread->at_upper_ends;
    return upper.capacity_kj > design.capacity_kj || upper.height_m > design.height_m
               ? report::page_text("with all that is not known, up to {net}", {{"net", in_words(upper)}})
               : "";
}

std::string need_in_words(const NetFigures& figures, const DesignSettings& settings) {
    if (figures.reached.part == 0) {
        return "–";
    }
    if (!figures.design) {
        return report::page_text(
            "too few rocks reach it for an estimate: {reached_part} of at least {rocks_to_tell_wanted_share}",
            {{"reached_part", report::grouped(figures.reached.part)},
             {"rocks_to_tell_wanted_share", report::grouped(rocks_to_tell(settings.share()))}});
    }
    return in_words(*figures.design);
}

std::string design_rule_in_words(const DesignSettings& settings) {
    const DesignMargins margins = margins_of(settings);
    const std::string percentiles = report::page_text(
        "Design: the energy and the height that {percentile} % of the rocks at a net do not exceed; heights "
        "are those of their upper edge (centre plus radius).",
        {{"percentile", report::exact(settings.percentile)}});
    const std::string rule =
        settings.rule == DesignRule::none
            ? report::page_text(
                  "The next energy class and the next height on offer are taken. Neither partial factors nor "
                  "a freeboard are added: give those of your guideline in [design] before a net is ordered.")
            : report::page_text(
                  "Then energy × {energy_factor}, height × {height_factor} plus {freeboard_m} m of "
                  "freeboard; the next energy class and the next height on offer.",
                  {{"energy_factor", report::exact(margins.energy_factor)},
                   {"height_factor", report::exact(margins.height_factor)},
                   {"freeboard_m", report::exact(margins.freeboard_m)}});
    const std::string upright = report::page_text(
        "Heights are vertical above the ground: across a slope of 35° a net needs 0.82 of it, the cosine of "
        "the "
        "slope.");
    const std::string unchecked = report::page_text(
        "Energy classes are those of data sheets of nets. No worked example of a design could be read at its "
        "source: the design is not checked against one.");
    return report::join_sentences({percentiles, rule, upright, unchecked});
}

bool asks_for_more(const BarrierDesign& with_forest, const BarrierDesign& bare) {
    return with_forest.capacity_kj > bare.capacity_kj || with_forest.height_m > bare.height_m;
}

std::string in_words(const NetRecord& net, const NetFigures& figures, const DesignSettings& settings) {
    const std::string& slope = figures.cover == rockfall::Cover::forest ? report::page_text("with forest")
                                                                        : report::page_text("bare slope");
    const std::string reach = report::grouped(figures.reached.part);
    const std::string rocks = report::grouped(figures.reached.whole);
    const bool is_least = figures.inexact > 0;
    const std::string text =
        is_least
            ? report::page_text(
                  "{net}, {slope}: at least {reach} of {rocks} rocks reach it ({inexact} rocks that break "
                  "through another net are not counted here: run the scenario to include them)",
                  {{"net", net.name},
                   {"slope", slope},
                   {"reach", reach},
                   {"rocks", rocks},
                   {"inexact", report::grouped(figures.inexact)}})
            : report::page_text("{net}, {slope}: {reach} of {rocks} rocks reach it",
                                {{"net", net.name}, {"slope", slope}, {"reach", reach}, {"rocks", rocks}});
    if (figures.reached.part == 0) {
        return text;
    }
    return report::join_with_semicolons(
        {text,
         report::page_text(is_least ? "of those known it holds {share}" : "it holds {share}",
                           {{"share", report::percent(figures.outcome[0].value)}}),
         percentiles_in_words(figures, settings), design_in_words(figures, settings),
         figures.design ? upper_in_words(*figures.design) : ""});
}

}  // namespace coupling
