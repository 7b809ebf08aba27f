#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/outcome/calibration.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// A set that was kept.
struct SetRow {
    std::size_t number = 0;
    double weight = 0.0;
    std::vector<double> factors;
};

TableOf<SetRow> sample_table(const std::string& file,
                             const std::vector<ParameterDraws::Component>& components) {
    ColumnsOf<SetRow> columns{
        {"set", "number of the parameter set", "order of the first parameter",
         [](const SetRow& row) { return row.number; }},
        {"weight", "-", as_given, "share of the sample that the set stands for; all sum to 1",
         "sequential Monte Carlo (Del Moral et al. 2012)", &SetRow::weight}};
    for (std::size_t i = 0; i < components.size(); ++i) {
        columns += ColumnsOf<SetRow>{components[i].parameter,
                                     "-",
                                     as_given,
                                     "factor on what `bannwald info parameter_widths` says of it",
                                     "calibrated",
                                     [i](const SetRow& row) { return row.factors[i]; }};
    }
    return {file, "The parameter sets that agree with what was observed; run.parameters reads it.",
            "a parameter set", columns};
}

TableOf<Wave> wave_table() {
    return {"search.csv",
            "The rounds of the search: sets tried, sets kept, how near they are.",
            "a round of the search",
            {{"tried", "parameter sets that fell", &Wave::tried},
             {"kept", "of these, sets within the tolerance", &Wave::kept},
             {"tolerance", "-", 4,
              "distance up to which sets were kept, in medians of samples of the model; of several sites the "
              "largest, in what 90 % of samples stay below there",
              "median of the round before, not below the goal", &Wave::tolerance},
             {"goal", "-", 4, "what 90 % of samples of the model itself stay below", "self-distance",
              &Wave::goal}}};
}

struct ParameterRow {
    const Learned& learned;
    std::string sites;
};

TableOf<ParameterRow> parameter_table() {
    using R = ParameterRow;
    constexpr const char* of_sample = "weighted sample of posterior.csv";
    return {
        "parameters.csv",
        "What the observations say about each parameter.",
        "a parameter",
        {{"parameter", "what is not known, as in parameter_widths", "definition",
          [](const R& row) { return row.learned.component.parameter; }},
         {"ground", "ground type that it concerns alone; empty: all", "ground types of the site",
          [](const R& row) { return row.learned.component.ground; }},
         {"site", "sites that it belongs to; empty: all", "calibrate.sites", &R::sites},
         {"width_before", "-", 4, "standard deviation of ln(factor) before", "run.parameters",
          [](const R& row) { return row.learned.component.width; }},
         {"factor_p50", "-", 4, "median of the factor", of_sample,
          [](const R& row) { return row.learned.median; }},
         {"factor_p05", "-", 4, "5 % of the factors lie below", of_sample,
          [](const R& row) { return row.learned.low; }},
         {"factor_p95", "-", 4, "95 % of the factors lie below", of_sample,
          [](const R& row) { return row.learned.high; }},
         {"learned", "-", 4,
          "how much narrower ln(factor) is than before; below 0: wider. Not above learned_by_chance: "
          "cannot be distinguished from chance",
          "1 - deviation after / deviation before", [](const R& row) { return row.learned.learned; }},
         {"learned_by_chance", "-", 4,
          "what sets of such weights show in one of twenty cases where nothing was learned; 1: too few sets",
          "chi-square of a weighted variance", [](const R& row) { return row.learned.by_chance; }},
         {"partner", "parameter with which it trades off most", of_sample,
          [](const R& row) { return row.learned.partner; }},
         {"correlation", "-", 4, "of the logarithms of the two", of_sample,
          [](const R& row) { return row.learned.correlation; }}}};
}

struct ObservationRow {
    std::string site;
    const Observation& observation;
    const Judged& judged;
    bool is_held_out = false;

    [[nodiscard]] const Side& side() const { return is_held_out ? judged.held_out : judged.fit; }
};

TableOf<ObservationRow> observation_table() {
    using R = ObservationRow;
    constexpr const char* as_row_says = "as the row says";
    const auto predicted = [&](const char* name, const char* meaning, std::size_t place) {
        return ColumnsOf<R>{name,
                            as_row_says,
                            3,
                            meaning,
                            "sets of the sample, as many rocks as were observed",
                            [place](const R& row) { return row.side().predicted[place]; }};
    };
    return {"observations.csv",
            "What was observed beside what the kept sets predict, fitted and held out.",
            "an observation, fitted to or held out",
            {{"site", "name of the site", "scenario file", &R::site},
             {"observation", "what was observed", "section [observed]",
              [](const R& row) { return row.observation.name; }},
             {"use", "fit or held_out", "calibrate.hold_out_percent, calibrate.hold_out_group",
              [](const R& row) { return row.is_held_out ? "held_out" : "fit"; }},
             {"count", "number of observations", [](const R& row) { return row.side().observed; }},
             {"observed", as_row_says, 3,
              "mean; of places the mean distance along the line from the sources to the stops",
              "section [observed]", [](const R& row) { return row.side().figure; }},
             predicted("predicted_p05", "5 % of predictions lie below", 0),
             predicted("predicted_p50", "median of predictions", 2),
             predicted("predicted_p95", "95 % of predictions lie below", 4),
             {"inside_90", "whether the observed figure lies between the two",
              [](const R& row) { return row.side().is_inside(); }},
             {"before_p05", as_row_says, 3, "5 % of predictions by the widths alone lie below",
              "run.parameters", [](const R& row) { return row.side().before.front(); }},
             {"before_p95", as_row_says, 3, "95 % of predictions by the widths alone lie below",
              "run.parameters", [](const R& row) { return row.side().before.back(); }},
             {"energy_distance", as_row_says, 4, "2 E|X - Y| - E|X - X'| - E|Y - Y'|, mean over the sets",
              "Szekely & Rizzo 2013", [](const R& row) { return row.side().distance; }},
             {"as_far", "-", 4, "share of samples of the model itself that are as far away or further",
              "sets of the sample", [](const R& row) { return row.side().as_far; }}}};
}

struct SensitivityRow {
    const Sensitivity& sensitivity;
    std::string site;
    std::string parameter;
    double share = 0.0;
};

TableOf<SensitivityRow> sensitivity_table() {
    using R = SensitivityRow;
    return {"sensitivity.csv",
            "Which figures of a field survey would tell which parameter, from the first round.",
            "a figure and a parameter",
            {{"site", "name of the site", "scenario file", &R::site},
             {"figure", "what a survey could measure", "simulated",
              [](const R& row) { return row.sensitivity.figure.name; }},
             {"parameter", "what is not known, as in parameter_widths", "definition", &R::parameter},
             {"share", "-", 4, "share of the variance of the figure that goes with the parameter alone",
              "correlation ratio over eight ranges, without what chance gives", &R::share}}};
}

struct CurveRow {
    std::string site;
    const Observation& observation;
    const CurvePoint& point;
};

TableOf<CurveRow> curve_table() {
    using R = CurveRow;
    const auto band = [&](const char* name, const char* meaning, Band CurvePoint::*which, std::size_t place) {
        return ColumnsOf<R>{name,   "-",
                            4,      meaning,
                            "sets", [which, place](const R& row) { return (row.point.*which)[place]; }};
    };
    return {"curves.csv",
            "Shares of observed and predicted values below a value: curves of the page.",
            "a value of an observation",
            {{"site", "name of the site", "scenario file", &R::site},
             {"observation", "what was observed", "section [observed]",
              [](const R& row) { return row.observation.name; }},
             {"value", "as the row says", 3, "value; of places distance along the line", "axis of the curve",
              [](const R& row) { return row.point.value; }},
             {"observed", "-", 4, "share observed below", "section [observed]",
              [](const R& row) { return row.point.observed; }},
             band("predicted_p05", "5 % of samples as large as the observed one have less below",
                  &CurvePoint::predicted, 0),
             band("predicted_p50", "median of such samples", &CurvePoint::predicted, 2),
             band("predicted_p95", "95 % of such samples have less below", &CurvePoint::predicted, 4),
             band("before_p05", "the same by the widths alone, 5 %", &CurvePoint::before, 0),
             band("before_p95", "the same by the widths alone, 95 %", &CurvePoint::before, 4)}};
}

struct SiteRow {
    std::string name;
    const SiteJudged& judged;
};

TableOf<SiteRow> site_table() {
    using R = SiteRow;
    return {"sites.csv",
            "How far what was observed at each site is from the kept sets.",
            "a site",
            {{"site", "name of the site", "scenario file", &R::name},
             {"fit_as_far", "-", 4,
              "share of samples of the model itself that are as far away as what was fitted to, or further",
              "sets of the sample", [](const R& row) { return row.judged.fit_as_far; }},
             {"held_out_as_far", "-", 4, "the same of what was held out", "sets of the sample",
              [](const R& row) { return row.judged.held_out_as_far; }}}};
}

struct RuledOutRow {
    std::string site;
    const Observation& observation;
    const RuledOut& ruled_out;
};

TableOf<RuledOutRow> ruled_out_table() {
    using R = RuledOutRow;
    return {
        "ruled_out.csv",
        "Which observations ruled out parameter sets that were not simulated; only with calibrate.emulator.",
        "an observation that was fitted to",
        {{"site", "name of the site", "scenario file", &R::site},
         {"observation", "what was observed", "section [observed]",
          [](const R& row) { return row.observation.name; }},
         {"ruled_out", "-", 4, "share of what the widths allow that this observation alone rules out",
          "emulators, implausibility above 3", [](const R& row) { return row.ruled_out.share; }},
         {"explained", "-", 4,
          "share of the variance of its best emulated figure that the emulator predicts, over the first "
          "round",
          "sets left out one by one", [](const R& row) { return row.ruled_out.explained; }}}};
}

struct TransferRow {
    std::string site;
    const Observation& observation;
    const Side& side;
    const Band& before;
    const Transfer& transfer;
};

TableOf<TransferRow> transfer_table() {
    using R = TransferRow;
    constexpr const char* as_row_says = "as the row says";
    constexpr const char* of_others = "sets fitted to all other sites";
    const auto predicted = [&](const char* name, const char* meaning, std::size_t place) {
        return ColumnsOf<R>{name,      as_row_says,
                            3,         meaning,
                            of_others, [place](const R& row) { return row.side.predicted[place]; }};
    };
    return {
        "transfer.csv",
        "What was observed at a site beside what the other sites alone predict for it; only with several.",
        "an observation of a site",
        {{"site", "name of the site", "scenario file", &R::site},
         {"observation", "what was observed", "section [observed]",
          [](const R& row) { return row.observation.name; }},
         {"use", "fit, held_out or both: what the search at all sites used it for",
          "calibrate.hold_out_percent, calibrate.hold_out_group",
          [](const R& row) {
              return row.observation.held_out.empty() ? "fit"
                     : row.observation.fit.empty()    ? "held_out"
                                                      : "both";
          }},
         {"count", "number of observations", [](const R& row) { return row.side.observed; }},
         {"observed", as_row_says, 3,
          "mean; of places the mean distance along the line from the sources to the stops",
          "section [observed]", [](const R& row) { return row.side.figure; }},
         predicted("predicted_p05", "5 % of predictions lie below", 0),
         predicted("predicted_p50", "median of predictions", 2),
         predicted("predicted_p95", "95 % of predictions lie below", 4),
         {"inside_90", "whether the observed figure lies between the two",
          [](const R& row) { return row.side.is_inside(); }},
         {"before_p05", as_row_says, 3, "5 % of predictions by the widths alone lie below", "run.parameters",
          [](const R& row) { return row.before.front(); }},
         {"before_p95", as_row_says, 3, "95 % of predictions by the widths alone lie below", "run.parameters",
          [](const R& row) { return row.before.back(); }},
         {"as_far", "-", 4, "share of samples of the model itself that are as far away or further", of_others,
          [](const R& row) { return row.side.as_far; }},
         {"site_as_far", "-", 4, "the same of all observations of the site together", of_others,
          [](const R& row) { return row.transfer.as_far; }},
         {"shows_too_few",
          "whether too few simulated rocks show some of it for a verdict; site_as_far is that of the rest",
          of_others, [](const R& row) { return row.transfer.shows_too_few; }},
         {"site_least_as_far", "-", 4, "below it the site does not agree: 5 % by the number of sites",
          "Bonferroni", [](const R& row) { return row.transfer.least_as_far(); }},
         {"search_came_close", "whether the search at the other sites came to its goal", "search",
          [](const R& row) { return row.transfer.end == SearchEnd::close; }}}};
}

/// Factors of the components of a site, set by set. The order is that of the first site's factors: a set has
/// the same number in the tables of all sites.
std::vector<SetRow> sets_of(const Calibration& calibration, std::size_t site) {
    struct Set {
        std::vector<double> order;
        SetRow row;
    };
    const auto of_site = [&](const std::vector<double>& factors, std::size_t number) {
        std::vector<double> own;
        for (const std::size_t place : calibration.shared.places[number]) {
            own.push_back(factors[place]);
        }
        return own;
    };
    std::vector<Set> sets;
    for (const Member& member : calibration.state.population) {
        const std::vector<double> factors = calibration.space.factors_of(member.point);
        std::vector<double> order = of_site(factors, 0);
        order.insert(order.end(), factors.begin(), factors.end());
        sets.push_back({std::move(order), {0, member.weight, of_site(factors, site)}});
    }
    std::sort(sets.begin(), sets.end(), [](const Set& a, const Set& b) { return a.order < b.order; });
    std::vector<SetRow> rows;
    for (Set& set : sets) {
        set.row.number = rows.size() + 1;
        rows.push_back(std::move(set.row));
    }
    return rows;
}

/// What each observation of the first site, then of the next one, ... was named.
std::vector<TransferRow> transfers_of(const Calibration& calibration) {
    std::vector<TransferRow> rows;
    for (const Transfer& transfer : calibration.judgement.transfers) {
        std::size_t side = 0;
        for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
            const Observation& observation = calibration.observations[i];
            if (observation.site == transfer.site) {
                rows.push_back({calibration.sites[transfer.site]->name, observation, transfer.sides[side++],
                                calibration.judgement.observations[i].before, transfer});
            }
        }
    }
    return rows;
}

std::string with_name(const Calibration& calibration, std::size_t site, const char* stem,
                      const char* ending) {
    return joined(stem, site == 0 ? std::string{} : joined("_", calibration.sites[site]->name), ending);
}

}  // namespace

std::string Calibration::users_of(std::size_t component) const {
    std::string names;
    if (shared.users[component].size() < sites.size()) {
        for (const std::size_t site : shared.users[component]) {
            names += joined(names.empty() ? "" : " ", sites[site]->name);
        }
    }
    return names;
}

std::string sample_file(const Calibration& calibration, std::size_t site) {
    return with_name(calibration, site, "posterior", ".csv");
}

std::string calibrated_file(const Calibration& calibration, std::size_t site) {
    return with_name(calibration, site, "calibrated", ".ini");
}

std::vector<TableLayout> calibration_layouts(const Calibration& calibration) {
    std::vector<TableLayout> layouts;
    for (std::size_t site = 0; site < calibration.sites.size(); ++site) {
        layouts.push_back(sample_table(sample_file(calibration, site), calibration.sites[site]->components));
    }
    layouts = together(std::move(layouts),
                       std::vector<TableLayout>{wave_table(), parameter_table(), observation_table(),
                                                sensitivity_table(), curve_table(), site_table()});
    if (!calibration.judgement.transfers.empty()) {
        layouts.push_back(transfer_table());
    }
    if (calibration.plan.emulates) {
        layouts.push_back(ruled_out_table());
    }
    return layouts;
}

const std::vector<TableLayout>& common_calibration_layouts() {
    static const std::vector<TableLayout> layouts{sample_table("posterior.csv", {}),
                                                  wave_table(),
                                                  parameter_table(),
                                                  observation_table(),
                                                  sensitivity_table(),
                                                  curve_table(),
                                                  site_table(),
                                                  transfer_table(),
                                                  ruled_out_table()};
    return layouts;
}

std::vector<WrittenFile> write_tables(const Calibration& calibration, const std::filesystem::path& folder) {
    const Judgement& judgement = calibration.judgement;
    const auto site_of = [&](std::size_t observation) {
        return calibration.site_of(calibration.observations[observation]).name;
    };
    std::vector<WrittenFile> files;
    for (std::size_t site = 0; site < calibration.sites.size(); ++site) {
        files.push_back(sample_table(sample_file(calibration, site), calibration.sites[site]->components)
                            .write(folder, [&](auto& rows) { rows.add_all(sets_of(calibration, site)); }));
    }
    files.push_back(parameter_table().write(folder, [&](auto& rows) {
        for (std::size_t i = 0; i < judgement.parameters.size(); ++i) {
            rows.add({judgement.parameters[i], calibration.users_of(i)});
        }
    }));
    files.push_back(observation_table().write(folder, [&](auto& rows) {
        for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
            for (const bool is_held_out : {false, true}) {
                const ObservationRow row{site_of(i), calibration.observations[i], judgement.observations[i],
                                         is_held_out};
                if (row.side().observed > 0) {
                    rows.add(row);
                }
            }
        }
    }));
    files.push_back(sensitivity_table().write(folder, [&](auto& rows) {
        for (const Sensitivity& sensitivity : judgement.sensitivities) {
            for (std::size_t i = 0; i < sensitivity.shares.size(); ++i) {
                rows.add({sensitivity, calibration.sites[sensitivity.figure.site]->name,
                          calibration.space.components()[i].parameter, sensitivity.shares[i]});
            }
        }
    }));
    files.push_back(curve_table().write(folder, [&](auto& rows) {
        for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
            for (const CurvePoint& point : judgement.observations[i].curve) {
                rows.add({site_of(i), calibration.observations[i], point});
            }
        }
    }));
    files.push_back(site_table().write(folder, [&](auto& rows) {
        for (std::size_t site = 0; site < judgement.sites.size(); ++site) {
            rows.add({calibration.sites[site]->name, judgement.sites[site]});
        }
    }));
    if (!judgement.transfers.empty()) {
        files.push_back(
            transfer_table().write(folder, [&](auto& rows) { rows.add_all(transfers_of(calibration)); }));
    }
    if (calibration.plan.emulates) {
        files.push_back(ruled_out_table().write(folder, [&](auto& rows) {
            for (const RuledOut& each : judgement.ruled_out) {
                rows.add({site_of(each.observation), calibration.observations[each.observation], each});
            }
        }));
    }
    files.push_back(wave_table().write(folder, [&](auto& rows) { rows.add_all(calibration.state.waves); }));
    return files;
}

}  // namespace coupling::calibrate
