#include "coupling/assessments/models/figures/model_figures.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling::models {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr std::array covers{"forest", "bare"};
constexpr std::array statistics{"mean", "p50", "p90", "p95", "p98", "p99", "max"};
constexpr std::array target_quantities{"energy_kj", "speed_mps", "height_m", "top_height_m"};
constexpr std::array slope_quantities{"run_out_m", "run_out_at_least_m"};

/// Columns of nets.csv that stand side by side.
constexpr std::array net_columns{"reached_percent",  "held_percent", "energy_95_kj",    "height_95_m",
                                 "design_energy_kj", "design_class", "design_height_m", "sold_height_m"};

/// The percentiles of energy and height at a net have their statistic in the name of the column.
std::pair<std::string, std::string> quantity_of_net(const std::string& column) {
    return column == "energy_95_kj"  ? std::pair<std::string, std::string>{"energy_kj", "p95"}
           : column == "height_95_m" ? std::pair<std::string, std::string>{"height_m", "p95"}
                                     : std::pair<std::string, std::string>{column, ""};
}

double value_in(const Json& json) {
    return json.is_number() ? json.get<double>() : Figure::unknown;
}

Interval interval_in(const Json& parent, const char* name) {
    const auto found = parent.find(name);
    return found == parent.end() || !found->is_array()
               ? Interval{Figure::unknown, Figure::unknown}
               : Interval{value_in(found->at(0)), value_in(found->at(1))};
}

/// A part of a part, null where one of them is missing.
const Json& part_of_json(const Json& json, std::initializer_list<const char*> names) {
    static const Json nothing;
    const Json* found = &json;
    for (const char* name : names) {
        if (!found->is_object() || !found->contains(name)) {
            return nothing;
        }
        found = &found->at(name);
    }
    return *found;
}

/// What `with_parameters` says of a target, null where it says nothing.
const Json& drawn_target(const Json& summary, const std::string& id) {
    static const Json nothing;
    const Json& targets = part_of_json(summary, {"with_parameters", "targets"});
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [&](const Json& target) { return target.at("id") == id; });
    return found == targets.end() ? nothing : *found;
}

/// Adds the intervals that `with_parameters` has of a figure.
void add_drawn(const Json& drawn, Figure& figure) {
    if (!drawn.is_object()) {
        return;
    }
    figure.of_all = interval_in(drawn, "interval_95_of_all");
    if (!(figure.of_rocks.low <= figure.of_rocks.high)) {
        figure.of_rocks = interval_in(drawn, "interval_95_of_rocks");
    }
}

/// Figures of a run in the order in which they are read.
class FiguresOfRun {
public:
    explicit FiguresOfRun(double return_period_years) : return_period_years_{return_period_years} {}

    void add(FigureKey key, Figure figure) {
        key.return_period_years = return_period_years_;
        figures_.emplace_back(std::move(key), figure);
    }
    /// "mean" to "max" of a distribution; `drawn` has "energy_95_kj" and the like, or is null.
    void add_distribution(const FigureKey& key, const Json& distribution, const Json& drawn) {
        const auto end = key.quantity.rfind('_');
        for (const char* statistic : statistics) {
            Figure figure{.value = value_in(distribution.at(statistic))};
            if (std::string_view{statistic} == "p95") {
                figure.of_rocks = interval_in(distribution, "p95_interval_95");
            }
            const std::string in_name = std::string_view{statistic} == "p95" ? "95" : statistic;
            const std::string drawn_name =
                joined(key.quantity.substr(0, end), "_", in_name, key.quantity.substr(end));
            add_drawn(part_of_json(drawn, {drawn_name.c_str()}), figure);
            FigureKey of = key;
            of.statistic = statistic;
            add(std::move(of), figure);
        }
    }
    [[nodiscard]] const std::vector<std::pair<FigureKey, Figure>>& figures() const { return figures_; }

private:
    double return_period_years_;
    std::vector<std::pair<FigureKey, Figure>> figures_;
};

/// As on the page of the run: not known from too few rocks.
Figure protection_in(const Json& protection, const Json& drawn) {
    Figure figure;
    if (!protection.is_object() || protection.at("too_few_rocks").get<bool>()) {
        return figure;
    }
    figure.of_rocks = interval_in(protection, "interval_95_percent");
    if (says_nothing(figure.of_rocks.low, figure.of_rocks.high)) {
        return {};
    }
    figure.value = value_in(protection.at("effect_percent"));
    add_drawn(part_of_json(drawn, {"protection_percent"}), figure);
    return figure;
}

void add_target(const Json& summary, const Json& target, FiguresOfRun& run) {
    const std::string id = target.at("id").get<std::string>();
    const Json& drawn = drawn_target(summary, id);
    const FigureKey at{.about = "target", .id = id, .name = target.at("name").get<std::string>()};
    const auto key = [&](const char* cover, const char* quantity) {
        FigureKey one = at;
        one.cover = cover;
        one.quantity = quantity;
        return one;
    };
    if (target.contains("protection")) {
        run.add(key("", "protection_percent"), protection_in(target.at("protection"), drawn));
    }
    for (const char* cover : covers) {
        const Json& slope = part_of_json(target, {cover});
        if (!slope.is_object()) {
            continue;
        }
        const Json& reached = slope.at("reached");
        Figure share{.value = value_in(reached.at("percent")),
                     .of_rocks = interval_in(reached, "interval_95_percent")};
        add_drawn(part_of_json(drawn, {cover, "reached_percent"}), share);
        run.add(key(cover, "reached_percent"), share);
        for (const char* quantity : target_quantities) {
            run.add_distribution(key(cover, quantity), slope.at(quantity), part_of_json(drawn, {cover}));
        }
    }
}

void add_slopes(const Json& summary, FiguresOfRun& run) {
    for (const char* cover : covers) {
        const Json& slope = part_of_json(summary, {"slopes", cover});
        if (!slope.is_object()) {
            continue;
        }
        for (const char* quantity : slope_quantities) {
            if (slope.contains(quantity)) {
                run.add_distribution({.about = "slope", .cover = cover, .quantity = quantity},
                                     slope.at(quantity),
                                     part_of_json(summary, {"with_parameters", "slopes", cover}));
            }
        }
        const Json& left = part_of_json(slope, {"stop_reasons", "left_terrain"});
        run.add({.about = "slope", .cover = cover, .quantity = "left_terrain_percent"},
                {.value = value_in(part_of_json(left, {"percent"})),
                 .of_rocks = left.is_object() ? interval_in(left, "interval_95_percent")
                                              : Interval{Figure::unknown, Figure::unknown}});
    }
}

void add_nets_of(const fs::path& folder, FiguresOfRun& run) {
    if (!compare::has_table(folder, "nets.csv")) {
        return;
    }
    std::vector<std::string> wanted{"net",
                                    "cover",
                                    "reached_low_percent",
                                    "reached_high_percent",
                                    "held_low_percent",
                                    "held_high_percent",
                                    "energy_95_low_kj",
                                    "energy_95_high_kj",
                                    "height_95_low_m",
                                    "height_95_high_m"};
    wanted.insert(wanted.end(), net_columns.begin(), net_columns.end());
    const config::Table table = compare::read_table(folder, "nets.csv", wanted);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto number = [&](const std::string& column) {
            // A class need not be a number ("none").
            return column == "design_class"
                       ? config::parse_number(table.text(row, column)).value_or(Figure::unknown)
                       : compare::number(table, row, column);
        };
        for (const std::string column : net_columns) {
            const auto [quantity, statistic] = quantity_of_net(column);
            Figure figure{.value = number(column)};
            const auto unit = column.rfind('_');
            const std::string low = joined(column.substr(0, unit), "_low", column.substr(unit));
            if (table.has(low)) {
                figure.of_rocks = {number(low),
                                   number(joined(column.substr(0, unit), "_high", column.substr(unit)))};
            }
            const std::string& net = table.text(row, "net");
            run.add({.about = "net",
                     .id = net,
                     .name = net,
                     .cover = table.text(row, "cover"),
                     .quantity = quantity,
                     .statistic = statistic},
                    figure);
        }
    }
}

Json summary_in(const fs::path& folder) {
    const fs::path file = folder / "summary.json";
    const FileBytes bytes = open_file(file, {file.string()}, "the summary of a finished run");
    Json json = Json::parse(bytes.text(), nullptr, false);
    if (!json.is_object()) {
        config::fail(config::ExitCode::data, {file.string()}, "no summary of a run",
                     "summary.json as `bannwald run` writes it");
    }
    return json;
}

/// Reads by `read` and says of which file it is that no run wrote it.
template <class Read>
void read_as_summary(const fs::path& folder, const Read& read) {
    const Json summary = summary_in(folder);
    try {
        read(summary);
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {(folder / "summary.json").string()}, "no summary of such a run",
                     "summary.json as `bannwald run` writes it");
    }
}

}  // namespace

std::string judged_quantity(const FigureKey& key) {
    const auto begins = [&](const char* begin) { return key.quantity.starts_with(begin); };
    return begins("energy") || begins("design_energy") || begins("design_class") ? "energy"
           : begins("speed")                                                     ? "speed"
           : begins("height") || begins("top_height") || begins("design_height") || begins("sold_height")
               ? "height"
           : begins("reached") || begins("run_out") || begins("left_terrain") ? "stops"
                                                                              : "";
}

std::vector<ModelFigure> read_figures(std::span<const fs::path> folders, double return_period_years) {
    std::vector<ModelFigure> all;
    for (std::size_t model = 0; model < folders.size(); ++model) {
        FiguresOfRun run{return_period_years};
        read_as_summary(folders[model], [&](const Json& summary) {
            for (const Json& target : summary.at("targets")) {
                add_target(summary, target, run);
            }
            add_slopes(summary, run);
        });
        add_nets_of(folders[model], run);
        std::size_t place = 0;  // behind the figure before, where a run has one that others lack
        for (const auto& [key, figure] : run.figures()) {
            auto found =
                std::find_if(all.begin(), all.end(), [&](const ModelFigure& one) { return one.key == key; });
            if (found == all.end()) {
                found = all.insert(all.begin() + static_cast<std::ptrdiff_t>(place),
                                   {key, std::vector<Figure>(folders.size())});
            }
            found->by_model[model] = figure;
            place = static_cast<std::size_t>(found - all.begin()) + 1;
        }
    }
    return all;
}

std::vector<LevelOfModels> read_levels(std::span<const fs::path> folders) {
    std::vector<LevelOfModels> all;
    for (std::size_t model = 0; model < folders.size(); ++model) {
        read_as_summary(folders[model], [&](const Json& summary) {
            for (const Json& target : summary.at("targets")) {
                for (const char* cover : covers) {
                    const Json& level = part_of_json(target, {cover, "level"});
                    if (!level.is_string()) {
                        continue;
                    }
                    const std::string id = target.at("id").get<std::string>();
                    auto found = std::find_if(all.begin(), all.end(), [&](const LevelOfModels& one) {
                        return one.id == id && one.cover == cover;
                    });
                    if (found == all.end()) {
                        all.push_back({id, target.at("name").get<std::string>(), cover,
                                       std::vector<std::string>(folders.size())});
                        found = all.end() - 1;
                    }
                    found->by_model[model] = level.get<std::string>();
                }
            }
        });
    }
    return all;
}

}  // namespace coupling::models
