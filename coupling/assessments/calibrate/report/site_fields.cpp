#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/report/calibration_page.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;
using report::escaped;
using report::page_text;
using report::PageFields;
using report::three_digits;

std::size_t count_at(const Calibration& calibration, std::size_t site, Sample Observation::*side) {
    std::vector<Observation> own;
    for (const Observation& observation : calibration.observations) {
        if (observation.site == site) {
            own.push_back(observation);
        }
    }
    return number_of(own, side);
}

std::vector<PageFields> sites_of_page(const Calibration& calibration) {
    const Judgement& judgement = calibration.judgement;
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < judgement.sites.size(); ++i) {
        const bool is_predicted =
            !judgement.transfers.empty() && judgement.transfers[i].verdict() != TransferVerdict::too_few;
        rows.push_back(
            {{"site", calibration.sites[i]->name},
             {"fitted", report::grouped(count_at(calibration, i, &Observation::fit))},
             {"fit_as_far", share_or_dash(judgement.sites[i].fit_as_far)},
             {"held_out", report::grouped(count_at(calibration, i, &Observation::held_out))},
             {"held_out_as_far", share_or_dash(judgement.sites[i].held_out_as_far)},
             {"by_others", is_predicted ? share_or_dash(judgement.transfers[i].as_far) : std::string{"–"}}});
    }
    return rows;
}

/// What to think of a prediction from other sites.
std::string verdict_of(const Transfer& transfer, const std::string& site) {
    switch (transfer.verdict()) {
        case TransferVerdict::not_close:
            return page_text(
                "The search at the other sites did not come close to what was observed there: it does not "
                "say what they predict for {site}.",
                {{"site", site}});
        case TransferVerdict::too_few:
            return page_text(
                "The sets of the other sites show too little of what was observed at {site}: nothing can be "
                "said of whether they hold here.",
                {{"site", site}});
        case TransferVerdict::too_far:
            return page_text(
                "What was observed at {site} is further away from what the other sites predict than {share} "
                "of samples of the model, which among {sites} sites is more than chance: what was fitted "
                "there "
                "does not hold here.",
                {{"site", site},
                 {"share", joined(report::fixed(100.0 * (1.0 - transfer.least_as_far()), 1), "\u00a0%")},
                 {"sites", std::to_string(transfer.sites)}});
        case TransferVerdict::holds:
            break;
    }
    return page_text(
        "Taken together, what was observed at {site} agrees with what the other sites predict for it.",
        {{"site", site}});
}

/// The run-out that other sites predict, beside the observed one; "" where no stops were observed.
std::string run_out_in_words(const Calibration& calibration, const Transfer& transfer,
                             const std::string& site) {
    const std::vector<Observation>& observations = calibration.sites[transfer.site]->observations;
    const auto run_out = std::find_if(observations.begin(), observations.end(),
                                      [](const Observation& one) { return one.seen == Seen::run_out; });
    if (run_out == observations.end()) {
        return "";
    }
    const Side& side = transfer.sides[static_cast<std::size_t>(run_out - observations.begin())];
    if (!std::isfinite(side.predicted.front())) {
        return "";
    }
    return page_text(
        "Fitted to the other sites alone, the sets predict a mean run-out of {low} to {high} m at {site} "
        "(90 %); {observed} m were observed.",
        {{"low", three_digits(side.predicted.front())},
         {"high", three_digits(side.predicted.back())},
         {"site", site},
         {"observed", three_digits(side.figure)}});
}

std::vector<PageFields> sentences_of(const Calibration& calibration) {
    std::vector<PageFields> sentences;
    for (const Transfer& transfer : calibration.judgement.transfers) {
        const std::string site = escaped(calibration.sites[transfer.site]->name);
        sentences.push_back({{"run_out", run_out_in_words(calibration, transfer, site)},
                             {"verdict", verdict_of(transfer, site)},
                             {"far_alone", far_in_words(calibration, far_alone(calibration, transfer))}});
    }
    return sentences;
}

std::vector<PageFields> carried_of(const Calibration& calibration) {
    std::vector<PageFields> rows;
    for (const Transfer& transfer : calibration.judgement.transfers) {
        std::size_t number = 0;
        for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
            const Observation& observation = calibration.observations[i];
            if (observation.site != transfer.site) {
                continue;
            }
            const Side& side = transfer.sides[number++];
            const Band& before = calibration.judgement.observations[i].before;
            const char* use = observation.held_out.empty() ? "fitted"
                              : observation.fit.empty()    ? "held out"
                                                           : "fitted and held out";
            rows.push_back({{"what", name_on_page(observation, calibration)},
                            {"use", page_text(use)},
                            {"number", report::grouped(side.observed)},
                            {"observed", three_digits(side.figure)},
                            {"predicted", range_or_dash(side.predicted.front(), side.predicted.back())},
                            {"before", range_or_dash(before.front(), before.back())},
                            {"as_far", share_or_dash(side.as_far)}});
        }
    }
    return rows;
}

}  // namespace

std::optional<PageFields> site_fields(const Calibration& calibration) {
    if (!calibration.has_several_sites()) {
        return std::nullopt;
    }
    const std::size_t sites = calibration.judgement.sites.size();
    return PageFields{{"of_sites", sites_of_page(calibration)},
                      {"number_of_sites", report::grouped(sites)},
                      {"least_of_site", three_digits(100.0 * least_as_far / static_cast<double>(sites))},
                      {"is_transferred", !calibration.judgement.transfers.empty()},
                      {"transfers", sentences_of(calibration)},
                      {"carried", carried_of(calibration)}};
}

}  // namespace coupling::calibrate
