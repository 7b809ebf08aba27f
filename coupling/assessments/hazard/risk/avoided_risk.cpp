#include "coupling/assessments/hazard/risk/avoided_risk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "config/version.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/today/figures/ground_columns.hpp"
#include "coupling/assessments/today/figures/grounds.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/nets/net_lines.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/read_summary.hpp"

namespace coupling::hazard::risk {
namespace {

using config::joined;

namespace fs = std::filesystem;

/// Settings, or whole sections, that change no fall but by nets and works.
constexpr std::array settings_beside_the_rocks{"works.",           "nets.",    "risk.",
                                               "report.",          "design.",  "hazard.",
                                               "output.",          "run.seed", "run.rocks_per_part",
                                               "run.strict_inputs"};
/// Files that change no fall but by nets and works.
constexpr std::array roles_beside_the_rocks{"works", "nets", "picture", "logo", "risk_curves", "matrix"};

template <class Openings>
bool begins_with_one(std::string_view text, const Openings& openings) {
    return std::any_of(openings.begin(), openings.end(),
                       [&](const char* opening) { return text.starts_with(opening); });
}

[[noreturn]] void refuse_without(const fs::path& period, std::string found, std::string expected) {
    config::fail(config::ExitCode::settings, {joined("risk.without: ", period.string())}, std::move(found),
                 std::move(expected),
                 "run the scenario of this run without nets.file and works.file into that folder");
}

/// Whether a value of a summary, where flags are true or false and numbers shortened, is that of a setting.
bool is_same_value(const std::string& of_summary, const std::string& ours) {
    if (of_summary == ours || (of_summary == "true" && ours == "yes") ||
        (of_summary == "false" && ours == "no")) {
        return true;
    }
    const auto theirs = config::parse_number(of_summary);
    const auto number = config::parse_number(ours);
    return theirs && number && *theirs == *number;
}

/// Hashes of the inputs that decide how rocks fall, by their roles.
std::multimap<std::string, std::string> hashes_of(const auto& inputs) {
    std::multimap<std::string, std::string> hashes;
    for (const auto& input : inputs) {
        if (!begins_with_one(input.role, roles_beside_the_rocks)) {
            hashes.emplace(input.role, input.hash);
        }
    }
    return hashes;
}

/// Some columns of a table of a run by the text of the first of them; empty without the table.
std::map<std::string, std::vector<std::string>> columns_in(const fs::path& period, const char* name,
                                                           const std::vector<std::string>& columns) {
    std::map<std::string, std::vector<std::string>> found;
    if (!compare::has_table(period, name)) {
        return found;
    }
    const config::Table table = compare::read_table(period, name, columns);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::vector<std::string> fields;
        for (const std::string& column : columns) {
            fields.push_back(table.text(row, column));
        }
        found.emplace(fields.front(), fields);
    }
    return found;
}

/// What nets.csv and works.csv say of each net and work, name first.
const std::vector<std::string> net_figures_in{"net", "net_height_m", "capacity_kj", "gap_m", "length_m"};
const std::vector<std::string> work_figures_in{"work",     "work_height_m", "capacity_kj",
                                               "length_m", "volume_m3",     "area_m2"};
using BarriersInTable = std::map<std::string, std::vector<std::string>>;

BarriersInTable nets_in(const fs::path& period) {
    return columns_in(period, "nets.csv", net_figures_in);
}

BarriersInTable works_in(const fs::path& period) {
    return columns_in(period, "works.csv", work_figures_in);
}

/// Whether a figure of a table, rounded to so many decimals, is this one; an empty field is none.
bool is_same_figure(const std::string& of_table, double ours, int decimals) {
    const auto theirs = config::parse_number(of_table);
    return !std::isfinite(ours) || !theirs ? !std::isfinite(ours) && !theirs
                                           : std::abs(*theirs - ours) <= 0.6 * std::pow(10.0, -decimals);
}

struct Figure {
    double value;
    int decimals;
};

/// Barriers that both runs have must be the same, and the run without has no others: what is set against the
/// cost is what the new ones spare.
void check_named(const fs::path& period, const BarriersInTable& theirs, const std::string& name,
                 const std::vector<Figure>& figures) {
    const auto other = theirs.find(name);
    for (std::size_t i = 0; other != theirs.end() && i < figures.size(); ++i) {
        if (!is_same_figure(other->second[i + 1], figures[i].value, figures[i].decimals)) {
            refuse_without(period, joined(config::in_quotes(name), " of another size than in this run"),
                           "nets and works of one name that are the same in both, or names of their own");
        }
    }
}

void check_barriers(const fs::path& period, const Site& site) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const BarriersInTable nets = nets_in(period);
    const BarriersInTable works = works_in(period);
    std::set<std::string> ours;
    for (const NetRecord& net : site.nets) {
        ours.insert(net.name);
        check_named(period, nets, net.name,
                    {{net.net.height_m, 2},
                     {net.net.capacity_j / config::j_per_kj, 1},
                     {net.net.gap_m, 2},
                     {plan_length_m(net.net.line_m), 2}});
    }
    for (const WorkRecord& work : site.works) {
        ours.insert(work.name);
        const bool has_earth = is_of_earth(work.kind);
        check_named(period, works, work.name,
                    {{work.kind == WorkKind::gallery ? none : work.height_m, 2},
                     {work.capacity_j / config::j_per_kj, 1},
                     {plan_length_m(work.line_m), 2},
                     {has_earth ? work.volume_m3 : none, 1},
                     {has_earth ? work.ground_m2 : none, 1}});
    }
    for (const BarriersInTable* theirs : {&nets, &works}) {
        for (const auto& [name, figures] : *theirs) {
            if (!ours.contains(name)) {
                refuse_without(period, joined(config::in_quotes(name), ", which this run has not"),
                               "a run whose nets and works all stand in this one, too");
            }
        }
    }
    if (std::all_of(ours.begin(), ours.end(),
                    [&](const std::string& name) { return nets.contains(name) || works.contains(name); })) {
        refuse_without(period, "all nets and works of this run", "a run that lacks some of them");
    }
}

/// Grounds may be changed by settings that no summary lists. What lies on new works alone is no ground of
/// theirs.
void check_grounds(const fs::path& period, const Scenario& scenario, const Site& site) {
    std::vector<std::string> names{"code", std::string{soil_column}};
    for (const GroundColumn& column : ground_columns()) {
        if (column.name != soil_column) {
            names.emplace_back(column.name);
        }
    }
    const auto theirs = columns_in(period, "grounds.csv", names);
    for (const GroundFigures& ours : grounds_of(scenario, site)) {
        const auto other = theirs.find(std::to_string(ours.code));
        if (other == theirs.end()) {
            continue;
        }
        bool is_same = other->second[1] == ours.soil;
        std::size_t place = 2;
        for (std::size_t i = 0; i < ground_columns().size(); ++i) {
            if (ground_columns()[i].name != soil_column) {
                is_same = is_same && is_same_figure(other->second[place++], ours.figures[i],
                                                    ground_columns()[i].decimals);
            }
        }
        if (!is_same) {
            refuse_without(period, joined("other figures of ground ", other->first),
                           "the same grounds in both runs");
        }
    }
}

}  // namespace

fs::path run_without(const Scenario& scenario) {
    const std::string& without = scenario.risk.without;
    return scenario.risk.assess && !without.empty() ? fs::path{scenario.resolve(without)} : fs::path{};
}

std::optional<double> AvoidedRisk::cost_per_year() const {
    double sum = 0.0;
    for (const NewBarrier& barrier : barriers) {
        if (!barrier.cost_per_year) {
            return std::nullopt;
        }
        sum += *barrier.cost_per_year;
    }
    return barriers.empty() ? std::nullopt : std::optional{sum};
}

Ratio benefit_by_cost(const Estimate& money, double cost_per_year) {
    return {money.value / cost_per_year, money.low / cost_per_year, money.high / cost_per_year};
}

Ratio cost_of_each(const Estimate& spared, double cost_per_year) {
    const auto each = [&](double of) {
        return of > 0.0 ? cost_per_year / of : std::numeric_limits<double>::infinity();
    };
    return {each(spared.value), each(spared.high), each(spared.low)};
}

std::vector<NewBarrier> new_barriers(const Site& site, const fs::path& period, double interest_percent) {
    std::vector<NewBarrier> barriers;
    const auto add = [&](const std::string& name, const char* kind, const BarrierCost& cost) {
        barriers.push_back({name, kind, cost, annual_cost(cost, interest_percent)});
    };
    const BarriersInTable nets = nets_in(period);
    for (const NetRecord& net : site.nets) {
        if (!nets.contains(net.name)) {
            add(net.name, "net", net.cost);
        }
    }
    const BarriersInTable works = works_in(period);
    for (const WorkRecord& work : site.works) {
        if (!works.contains(work.name)) {
            add(work.name, name_of(work.kind), work.cost);
        }
    }
    return barriers;
}

void check_same_rocks(const fs::path& period, const Scenario& scenario, const Site& site) {
    const fs::path file = period / "summary.json";
    if (!path_exists(file)) {
        refuse_without(period, "no finished return period", "the folder of a finished hazard run, its --out");
    }
    const SummaryOfRun summary = read_summary(open_file(file, {}, "a summary").text(), file.string());
    if (summary.version != config::version()) {
        refuse_without(period, joined("results of version ", summary.version),
                       joined("those of this version, ", config::version()));
    }
    if (summary.seed != scenario.run.seed || summary.rocks != site.rocks()) {
        refuse_without(
            period, joined(std::to_string(summary.rocks), " rocks, run.seed ", std::to_string(summary.seed)),
            joined("the same rocks: ", std::to_string(site.rocks()), ", run.seed ",
                   std::to_string(scenario.run.seed)));
    }
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (row.files != config::NamesFiles::none || begins_with_one(row.key, settings_beside_the_rocks)) {
            continue;  // files by their hashes, below
        }
        const auto found =
            std::find_if(summary.settings.begin(), summary.settings.end(),
                         [&](const SummaryOfRun::Setting& setting) { return setting.key == row.key; });
        if (found == summary.settings.end() || !is_same_value(found->value, row.value_text)) {
            refuse_without(period,
                           joined(row.key, found == summary.settings.end() ? " not set" : " = ",
                                  found == summary.settings.end() ? "" : found->value),
                           joined(row.key, " = ", row.value_text));
        }
    }
    const auto theirs = hashes_of(summary.inputs);
    const auto ours = hashes_of(site.inputs);
    for (const auto& [role, hash] : ours) {
        const auto [first, last] = theirs.equal_range(role);
        if (std::none_of(first, last, [&](const auto& entry) { return entry.second == hash; })) {
            refuse_without(period, joined("other ", role, " than this run"), "the same inputs");
        }
    }
    if (theirs.size() != ours.size()) {
        refuse_without(period, "other inputs than this run", "the same inputs");
    }
    check_barriers(period, site);
    check_grounds(period, scenario, site);
}

}  // namespace coupling::hazard::risk
