#include "coupling/assessments/nets/figures/net_words.hpp"

#include <cmath>

#include "coupling/inputs/nets/net_classes.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {
namespace {

/// "95 % of energies below 312 kJ, of heights below 1.2 m", as far as they are known.
std::string percentiles_in_words(const NetFigures& figures) {
    if (std::isnan(figures.energy_kj.p95.value)) {
        return "";
    }
    return report::page_text(
        "95 % of energies below {energy_kj_p95} kJ, of heights of the centre below {height_m_p95} m",
        {{"energy_kj_p95", report::three_digits(figures.energy_kj.p95.value)},
         {"height_m_p95", report::three_digits(figures.height_m.p95.value)}});
}

}  // namespace

std::string need_in_words(const NetFigures& figures, double wanted_share) {
    if (figures.reached.part == 0) {
        return "–";
    }
    if (figures.needs.empty()) {
        return report::page_text(
            "too few rocks reach it for an estimate: {reached_part} of at least {rocks_to_tell_wanted_share}",
            {{"reached_part", report::grouped(figures.reached.part)},
             {"rocks_to_tell_wanted_share", report::grouped(rocks_to_tell(wanted_share))}});
    }
    const NetNeed& need = figures.needs[figures.recommended];
    const std::string level =
        std::isfinite(need.mel_kj)
            ? report::page_text("{need_mel_kj} kJ",
                                {{"need_mel_kj", report::grouped(static_cast<std::uint64_t>(need.mel_kj))}})
            : report::page_text("above 4 500 kJ: {energy_needed_kj} kJ",
                                {{"energy_needed_kj", report::three_digits(figures.energy_needed_kj)}});
    if (!need.height_m) {
        return report::page_text("class {class} ({level}), at no height",
                                 {{"class", need.energy_class}, {"level", level}});
    }
    const std::string height_m = report::fixed(*need.height_m, 1);
    return *need.height_m > highest_usual_net_m
               ? report::page_text(
                     "class {class} ({level}), {height_m} m high; no usual net is that high: they end "
                     "at {highest_m} m",
                     {{"class", need.energy_class},
                      {"level", level},
                      {"height_m", height_m},
                      {"highest_m", report::tick_text(highest_usual_net_m)}})
               : report::page_text("class {class} ({level}), {height_m} m high",
                                   {{"class", need.energy_class}, {"level", level}, {"height_m", height_m}});
}

std::string in_words(const NetRecord& net, const NetFigures& figures, double wanted_share) {
    const std::string& slope = figures.cover == rockfall::Cover::forest ? report::page_text("with forest")
                                                                        : report::page_text("bare slope");
    const std::string reach = std::to_string(figures.reached.part);
    const std::string rocks = std::to_string(figures.reached.whole);
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
                   {"inexact", std::to_string(figures.inexact)}})
            : report::page_text("{net}, {slope}: {reach} of {rocks} rocks reach it",
                                {{"net", net.name}, {"slope", slope}, {"reach", reach}, {"rocks", rocks}});
    if (figures.reached.part == 0) {
        return text;
    }
    return report::join_with_semicolons(
        {text,
         report::page_text(is_least ? "of those known it holds {share}" : "it holds {share}",
                           {{"share", report::percent(figures.outcome[0].value)}}),
         percentiles_in_words(figures),
         report::page_text("to hold {wanted}: {need}", {{"wanted", report::percent(wanted_share)},
                                                        {"need", need_in_words(figures, wanted_share)}})});
}

}  // namespace coupling
