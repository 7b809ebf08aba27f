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

TableOf<SetRow> sample_table(const Space& space) {
    ColumnsOf<SetRow> columns{
        {"set", "number of the parameter set", "order of the first parameter",
         [](const SetRow& row) { return row.number; }},
        {"weight", "-", as_given, "share of the sample that the set stands for; all sum to 1",
         "sequential Monte Carlo (Del Moral et al. 2012)", &SetRow::weight}};
    for (std::size_t i = 0; i < space.size(); ++i) {
        columns += ColumnsOf<SetRow>{space.components()[i].parameter,
                                     "-",
                                     as_given,
                                     "factor on what `bannwald info parameter_widths` says of it",
                                     "calibrated",
                                     [i](const SetRow& row) { return row.factors[i]; }};
    }
    return {sample_file, "The parameter sets that agree with what was observed; run.parameters reads it.",
            "a parameter set", columns};
}

TableOf<Wave> wave_table() {
    return {"search.csv",
            "The rounds of the search: sets tried, sets kept, how near they are.",
            "a round of the search",
            {{"tried", "parameter sets that fell", &Wave::tried},
             {"kept", "of these, sets within the tolerance", &Wave::kept},
             {"tolerance", "-", 4, "distance up to which sets were kept, in medians of samples of the model",
              "median of the round before, not below the goal", &Wave::tolerance},
             {"goal", "-", 4, "what 90 % of samples of the model itself stay below", "self-distance",
              &Wave::goal}}};
}

struct ParameterRow {
    const Learned& learned;
};

TableOf<ParameterRow> parameter_table() {
    using R = ParameterRow;
    constexpr const char* of_sample = "weighted sample of posterior.csv";
    return {"parameters.csv",
            "What the observations say about each parameter.",
            "a parameter",
            {{"parameter", "what is not known, as in parameter_widths", "definition",
              [](const R& row) { return row.learned.component.parameter; }},
             {"ground", "ground type that it concerns alone; empty: all", "ground types of the site",
              [](const R& row) { return row.learned.component.ground; }},
             {"width_before", "-", 4, "standard deviation of ln(factor) before", "run.parameters",
              [](const R& row) { return row.learned.component.width; }},
             {"factor_p50", "-", 4, "median of the factor", of_sample,
              [](const R& row) { return row.learned.median; }},
             {"factor_p05", "-", 4, "5 % of the factors lie below", of_sample,
              [](const R& row) { return row.learned.low; }},
             {"factor_p95", "-", 4, "95 % of the factors lie below", of_sample,
              [](const R& row) { return row.learned.high; }},
             {"learned", "-", 4, "how much narrower ln(factor) is than before; below 0: wider by chance",
              "1 - deviation after / deviation before", [](const R& row) { return row.learned.learned; }},
             {"partner", "parameter with which it trades off most", of_sample,
              [](const R& row) { return row.learned.partner; }},
             {"correlation", "-", 4, "of the logarithms of the two", of_sample,
              [](const R& row) { return row.learned.correlation; }}}};
}

struct ObservationRow {
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
            {{"observation", "what was observed", "section [observed]",
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
              "run.parameters", [](const R& row) { return row.judged.before.front(); }},
             {"before_p95", as_row_says, 3, "95 % of predictions by the widths alone lie below",
              "run.parameters", [](const R& row) { return row.judged.before.back(); }},
             {"energy_distance", as_row_says, 4, "2 E|X - Y| - E|X - X'| - E|Y - Y'|, mean over the sets",
              "Szekely & Rizzo 2013", [](const R& row) { return row.side().distance; }},
             {"as_far", "-", 4, "share of samples of the model itself that are as far away or further",
              "sets of the sample", [](const R& row) { return row.side().as_far; }}}};
}

struct SensitivityRow {
    const Sensitivity& sensitivity;
    std::string parameter;
    double share = 0.0;
};

TableOf<SensitivityRow> sensitivity_table() {
    using R = SensitivityRow;
    return {"sensitivity.csv",
            "Which figures of a field survey would tell which parameter, from the first round.",
            "a figure and a parameter",
            {{"figure", "what a survey could measure", "simulated",
              [](const R& row) { return row.sensitivity.figure; }},
             {"parameter", "what is not known, as in parameter_widths", "definition", &R::parameter},
             {"share", "-", 4, "share of the variance of the figure that goes with the parameter alone",
              "correlation ratio over eight ranges, without what chance gives", &R::share}}};
}

struct CurveRow {
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
            {{"observation", "what was observed", "section [observed]",
              [](const R& row) { return row.observation.name; }},
             {"value", "as the row says", 3, "value; of places distance along the line", "axis of the curve",
              [](const R& row) { return row.point.value; }},
             {"observed", "-", 4, "share observed below", "section [observed]",
              [](const R& row) { return row.point.observed; }},
             band("predicted_p05", "5 % of sets have a smaller share below", &CurvePoint::predicted, 0),
             band("predicted_p50", "median of the sets", &CurvePoint::predicted, 2),
             band("predicted_p95", "95 % of sets have a smaller share below", &CurvePoint::predicted, 4),
             band("before_p05", "the same by the widths alone, 5 %", &CurvePoint::before, 0),
             band("before_p95", "the same by the widths alone, 95 %", &CurvePoint::before, 4)}};
}

std::vector<SetRow> sets_of(const Calibration& calibration) {
    std::vector<SetRow> rows;
    for (const Member& member : calibration.state.population) {
        rows.push_back({0, member.weight, calibration.space.factors_of(member.point)});
    }
    std::sort(rows.begin(), rows.end(),
              [](const SetRow& a, const SetRow& b) { return a.factors < b.factors; });
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].number = i + 1;
    }
    return rows;
}

}  // namespace

std::vector<TableLayout> calibration_layouts(const Space& space) {
    return {sample_table(space), wave_table(),        parameter_table(),
            observation_table(), sensitivity_table(), curve_table()};
}

const std::vector<TableLayout>& common_calibration_layouts() {
    static const std::vector<TableLayout> layouts = calibration_layouts(Space{{}});
    return layouts;
}

std::vector<WrittenFile> write_tables(const Calibration& calibration, const std::filesystem::path& folder) {
    const Judgement& judgement = calibration.judgement;
    return {sample_table(calibration.space)
                .write(folder, [&](auto& rows) { rows.add_all(sets_of(calibration)); }),
            parameter_table().write(folder,
                                    [&](auto& rows) {
                                        for (const Learned& learned : judgement.parameters) {
                                            rows.add({learned});
                                        }
                                    }),
            observation_table().write(folder,
                                      [&](auto& rows) {
                                          for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
                                              for (const bool is_held_out : {false, true}) {
                                                  const ObservationRow row{calibration.observations[i],
                                                                           judgement.observations[i],
                                                                           is_held_out};
                                                  if (row.side().observed > 0) {
                                                      rows.add(row);
                                                  }
                                              }
                                          }
                                      }),
            sensitivity_table().write(folder,
                                      [&](auto& rows) {
                                          for (const Sensitivity& sensitivity : judgement.sensitivities) {
                                              for (std::size_t i = 0; i < sensitivity.shares.size(); ++i) {
                                                  rows.add({sensitivity,
                                                            calibration.space.components()[i].parameter,
                                                            sensitivity.shares[i]});
                                              }
                                          }
                                      }),
            curve_table().write(folder,
                                [&](auto& rows) {
                                    for (std::size_t i = 0; i < calibration.observations.size(); ++i) {
                                        for (const CurvePoint& point : judgement.observations[i].curve) {
                                            rows.add({calibration.observations[i], point});
                                        }
                                    }
                                }),
            wave_table().write(folder, [&](auto& rows) { rows.add_all(calibration.state.waves); })};
}

}  // namespace coupling::calibrate
