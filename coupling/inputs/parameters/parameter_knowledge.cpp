#include "coupling/inputs/parameters/parameter_knowledge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"

namespace coupling {
namespace {

constexpr const char* role = "parameters";
constexpr const char* setting = "run.parameters";
constexpr const char* weight_column = "weight";
constexpr const char* number_column = "set";

JointSample sample_in(const config::Table& table, const std::vector<ParameterWidth>& known,
                      const std::vector<std::string>& grounds) {
    JointSample sample{.file = table.file(), .parameters = {}, .factors = {}, .weights = {}};
    const std::vector<std::string> names = parameter_names(known, grounds);
    for (const std::string& column : table.columns()) {
        if (column == weight_column || column == number_column) {
            continue;
        }
        if (std::find(names.begin(), names.end(), column) == names.end()) {
            const std::string nearest = config::nearest_word(column, names);
            config::fail(
                config::ExitCode::data, {table.file()}, config::joined("column ", config::in_quotes(column)),
                nearest.empty()
                    ? "a parameter of `bannwald info parameter_widths`"
                    : config::joined("a parameter of `bannwald info parameter_widths` (", nearest, "?)"),
                "a sample of another site has its grounds: calibrate here, or delete the column");
        }
        sample.parameters.push_back(column);
    }
    if (sample.parameters.empty() || table.rows() == 0) {
        config::fail(config::ExitCode::data, {table.file()},
                     table.rows() == 0 ? "a sample without a set" : "a sample without a parameter",
                     "a row for each set, a column for each parameter");
    }
    constexpr config::NumberRange factors{1e-3, 1e3};
    constexpr config::NumberRange weights{0.0, 1e9};
    double sum = 0.0;
    config::Problems problems;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        sample.weights.push_back(table.number(row, weight_column, weights, problems).value_or(0.0));
        sum += sample.weights.back();
        std::vector<double>& set = sample.factors.emplace_back();
        for (const std::string& parameter : sample.parameters) {
            set.push_back(table.number(row, parameter, factors, problems).value_or(1.0));
        }
    }
    if (table.has(number_column)) {
        (void)table.text(0, number_column);
    }
    problems.throw_if_any();
    if (!(sum > 0.0)) {
        config::fail(config::ExitCode::data, {table.file()}, "weights that are all 0", "a sum above 0");
    }
    for (double& weight : sample.weights) {
        weight /= sum;
    }
    return sample;
}

/// By which parameters may name ground types: those that the program ships, and codes of the site.
std::vector<std::string> names_of(const std::vector<rockfall::SurfaceType>& types) {
    std::vector<std::string> names;
    for (const ShippedSurface& surface : shipped_surfaces()) {
        names.push_back(surface.name);
    }
    for (const rockfall::SurfaceType& type : types) {
        names.push_back(std::to_string(type.code));
    }
    return names;
}

}  // namespace

std::optional<std::size_t> JointSample::find(const std::string& parameter) const {
    const auto found = std::find(parameters.begin(), parameters.end(), parameter);
    return found == parameters.end() ? std::nullopt
                                     : std::optional{static_cast<std::size_t>(found - parameters.begin())};
}

std::size_t JointSample::set_at(double uniform) const {
    double below = 0.0;
    for (std::size_t set = 0; set < weights.size(); ++set) {
        below += weights[set];
        if (uniform < below) {
            return set;
        }
    }
    return weights.size() - 1;
}

std::vector<double> JointSample::centre() const {
    std::vector<double> logs(parameters.size(), 0.0);
    for (std::size_t set = 0; set < factors.size(); ++set) {
        for (std::size_t i = 0; i < logs.size(); ++i) {
            logs[i] += weights[set] * std::log(factors[set][i]);
        }
    }
    for (double& value : logs) {
        value = std::exp(value);
    }
    return logs;
}

bool ParameterKnowledge::has_spread() const {
    return is_drawn && (sample || std::any_of(widths.begin(), widths.end(),
                                              [](const ParameterWidth& one) { return one.width > 0.0; }));
}

std::shared_ptr<const ParameterKnowledge> read_parameter_knowledge(
    const std::vector<rockfall::SurfaceType>& types, Reading& reading) {
    const std::vector<std::string> grounds = names_of(types);
    ParameterKnowledge knowledge{.widths = shipped_parameter_widths(),
                                 .is_drawn = reading.run().parameter_draws};
    if (const std::string& name = reading.run().parameters; !name.empty()) {
        const config::Table table = reading.table(setting, role, name);
        if (table.has(weight_column)) {
            knowledge.sample = sample_in(table, knowledge.widths, grounds);
        } else if (knowledge.is_drawn) {
            change_parameter_widths(knowledge.widths, table, grounds, reading);
        } else {
            reading.note(
                config::joined(reading.shown(name), " has no effect: widths, and run.parameter_draws is no"));
        }
    }
    return std::make_shared<const ParameterKnowledge>(std::move(knowledge));
}

}  // namespace coupling
