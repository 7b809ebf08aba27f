#include "coupling/assessments/compare/runs/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::compare {
namespace {

using config::joined;

constexpr const char* none = "–";

/// Inputs and settings that say what slope, rocks and targets a run speaks of: with others it answers another
/// question.
struct Question {
    std::string_view begin;    ///< of a role or a key
    const char* if_different;  ///< what is said then
};
constexpr const char* terrains_differ = "the terrains differ";
constexpr std::array question_inputs{Question{"dem", terrains_differ},
                                     Question{"points", terrains_differ},
                                     Question{"mesh", terrains_differ},
                                     Question{"profile", terrains_differ},
                                     Question{"targets", "the targets differ"},
                                     Question{"stations", "the stations differ"},
                                     Question{"source", "the release places differ"},
                                     Question{"release", "the release places differ"}};
constexpr std::array question_settings{Question{"release.", "the rocks differ"}};
/// How many rocks fall changes how sure a figure is, not what it means.
constexpr std::array counts{"release.rocks", "release.rocks_per_source"};

std::string pair(const SideBySide& comparison, const Disagreement& d) {
    std::string text;
    for (std::size_t i = 0; i < d.values.size(); ++i) {
        text +=
            joined(i == 0 ? "" : ", ", comparison.letters[i], " ", d.values[i].empty() ? none : d.values[i]);
    }
    return text;
}

/// "energies of A, B count translation and rotation, of C translation alone": what energies count under the
/// motion models with these names, each once; "energies of all count translation and rotation" where it is
/// the same.
std::string energies_of(const std::vector<std::string>& names) {
    std::map<std::string_view, std::string, std::greater<>> models_by_energy;
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        const rockfall::ModelDescription& description = rockfall::description_of(model);
        if (std::find(names.begin(), names.end(), description.name) != names.end()) {
            std::string& models = models_by_energy[description.energy];
            models += joined(models.empty() ? "" : ", ", description.name);
        }
    }
    if (models_by_energy.size() == 1) {
        return joined("energies of all count ", models_by_energy.begin()->first);
    }
    std::string text;
    for (const auto& [energy, models] : models_by_energy) {
        text +=
            joined(text.empty() ? "energies of " : ", of ", models, text.empty() ? " count " : " ", energy);
    }
    return text;
}

/// Settings of rocks that motion models use each in its own way, such as their shape: they are part of the
/// model.
bool is_of_models(const std::string& key) {
    if (key.starts_with("release.shape") || key.starts_with("release.sides")) {
        return true;
    }
    const auto& models = rockfall::all_models();
    return std::any_of(models.begin(), models.end(), [&](rockfall::MotionModel model) {
        const auto& used = rockfall::description_of(model).shared_settings;
        return std::find(used.begin(), used.end(), key) != used.end();
    });
}

/// Keys of settings that name a file: the file is an input, and judged as that.
const std::set<std::string>& keys_of_files() {
    static const std::set<std::string> keys = [] {
        Scenario scenario;
        config::Options options;
        declare(options, scenario);
        std::set<std::string> of_files;
        for (const config::ParameterRow& row : options.rows()) {
            if (row.files == config::NamesFiles::one) {
                of_files.insert(row.key);
            }
        }
        return of_files;
    }();
    return keys;
}

/// By name of a row, its value in each run.
using Values = std::vector<Disagreement>;

/// Rows of (name, value) lists, in the order of the first run that has them.
template <class Row, class Name, class Value>
Values values_by_name(std::span<const FinishedRun> runs, std::vector<Row> SummaryOfRun::*rows, Name name,
                      Value value) {
    Values found;
    std::vector<std::string> seen;
    for (const FinishedRun& run : runs) {
        for (const Row& row : run.summary.*rows) {
            if (std::find(seen.begin(), seen.end(), name(row)) != seen.end()) {
                continue;
            }
            seen.push_back(name(row));
            Disagreement d{name(row), {}};
            for (const FinishedRun& other : runs) {
                const auto& list = other.summary.*rows;
                const auto same = std::find_if(list.begin(), list.end(),
                                               [&](const Row& r) { return name(r) == name(row); });
                d.values.push_back(same == list.end() ? std::string{none} : value(*same));
            }
            found.push_back(std::move(d));
        }
    }
    return found;
}

bool is_same_everywhere(const Disagreement& d) {
    return std::adjacent_find(d.values.begin(), d.values.end(), std::not_equal_to<>{}) == d.values.end();
}

void take_settings(std::span<const FinishedRun> runs, SideBySide& comparison) {
    Values settings = values_by_name(
        runs, &SummaryOfRun::settings, [](const SummaryOfRun::Setting& row) { return row.key; },
        // A switch as scenarios write it.
        [](const SummaryOfRun::Setting& row) -> std::string {
            return row.value == "true" ? "yes" : row.value == "false" ? "no" : row.value;
        });
    std::erase_if(settings, [](const Disagreement& d) {
        return is_same_everywhere(d) || keys_of_files().contains(d.what);
    });
    comparison.settings = std::move(settings);
}

/// Inputs are judged by their hash and named by their file.
void take_inputs(std::span<const FinishedRun> runs, SideBySide& comparison) {
    const auto role = [](const SummaryOfRun::Input& row) { return row.role; };
    const Values hashes = values_by_name(runs, &SummaryOfRun::inputs, role,
                                         [](const SummaryOfRun::Input& row) { return row.hash; });
    Values files = values_by_name(runs, &SummaryOfRun::inputs, role,
                                  [](const SummaryOfRun::Input& row) { return row.file; });
    constexpr std::size_t shown_digits = 8;
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        if (is_same_everywhere(hashes[i])) {
            comparison.same_inputs.push_back(hashes[i].what);
            continue;
        }
        std::vector<std::string>& names = files[i].values;
        const bool are_distinct = std::set<std::string>{names.begin(), names.end()}.size() == names.size();
        for (std::size_t run = 0; run < names.size() && !are_distinct; ++run) {
            names[run] += hashes[i].values[run] == none
                              ? ""
                              : joined(" (", hashes[i].values[run].substr(0, shown_digits), ")");
        }
        comparison.inputs.push_back(std::move(files[i]));
    }
}

template <std::size_t n>
const char* question_of(const std::array<Question, n>& questions, const std::string& name) {
    const auto found = std::find_if(questions.begin(), questions.end(),
                                    [&](const Question& q) { return name.starts_with(q.begin); });
    return found == questions.end() ? nullptr : found->if_different;
}

void judge(SideBySide& comparison, std::span<const FinishedRun> runs) {
    for (const Disagreement& d : comparison.inputs) {
        if (const char* what = question_of(question_inputs, d.what)) {
            comparison.not_comparable.push_back(joined(what, " (", d.what, ": ", pair(comparison, d), ")"));
        }
    }
    for (const Disagreement& d : comparison.settings) {
        const char* what = question_of(question_settings, d.what);
        const bool is_count = std::find(counts.begin(), counts.end(), d.what) != counts.end();
        if (what != nullptr && !is_count && !is_of_models(d.what)) {
            comparison.not_comparable.push_back(joined(what, " (", d.what, ": ", pair(comparison, d), ")"));
        }
        if (d.what == "run.years" || d.what == "run.rockfall_every") {
            comparison.not_comparable.push_back(joined(
                "means, last and worst years are taken from different years (", pair(comparison, d), ")"));
        }
    }
    for (const Disagreement& d : comparison.settings) {
        if (d.what == "rockfall.motion") {
            comparison.notes.push_back(
                joined("the motion models differ (", pair(comparison, d), "): ", energies_of(d.values)));
        } else if (d.what.starts_with("release.") && is_of_models(d.what)) {
            comparison.notes.push_back(joined("the blocks differ (", d.what, ": ", pair(comparison, d), ")"));
        }
    }
    const auto differs = [&](auto value) {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const FinishedRun& run) { return value(run) != value(runs.front()); });
    };
    if (differs([](const FinishedRun& run) { return run.summary.version; })) {
        comparison.notes.emplace_back("the runs come from different versions of the program");
    }
}

const Figure* find(const FinishedRun& run, const FigureKey& key) {
    const auto found =
        std::find_if(run.figures.begin(), run.figures.end(), [&](const Figure& f) { return f.key == key; });
    return found == run.figures.end() ? nullptr : &*found;
}

/// 0 for a part of a whole, such as a species, that a run lacks while it has the whole: the replicates are
/// those of the wood in the same regime and climate.
std::optional<Figure> without_part(const FinishedRun& run, const Figure& part) {
    const FigureKey whole{"", part.key.regime, "volume_m3pha", over_years, part.key.climate};
    const Figure* wood = part.is_part ? find(run, whole) : nullptr;
    if (wood == nullptr) {
        return std::nullopt;
    }
    std::map<long long, double> zeros = wood->by_replicate;
    for (auto& [replicate, value] : zeros) {
        value = 0.0;
    }
    Figure figure = over_replicates(part.key, std::move(zeros));
    figure.is_part = true;
    return figure;
}

Line line_of(const Figure& figure, std::span<const FinishedRun> runs, bool paired) {
    Line line{figure.key, {}, {}};
    for (const FinishedRun& run : runs) {
        const Figure* here = find(run, figure.key);
        line.figures.push_back(here == nullptr ? without_part(run, figure) : std::optional{*here});
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& here = line.figures[i];
        const auto& first = line.figures.front();
        line.differences.push_back(i == 0 || !here || !first ? std::nullopt
                                                             : difference(*here, *first, paired));
    }
    return line;
}

/// The order of the first run; what only later ones know stands behind what comes before it there.
std::vector<Line> lines_of(std::span<const FinishedRun> runs, bool paired) {
    std::vector<Line> lines;
    for (const FinishedRun& run : runs) {
        auto next = static_cast<std::ptrdiff_t>(lines.size());
        for (const Figure& figure : run.figures) {
            const auto known = std::find_if(lines.begin(), lines.end(),
                                            [&](const Line& line) { return line.key == figure.key; });
            if (known != lines.end()) {
                next = known - lines.begin() + 1;
                continue;
            }
            lines.insert(lines.begin() + next, line_of(figure, runs, paired));
            ++next;
        }
    }
    // Figures of a target, regime and climate stand together.
    std::vector<std::tuple<std::string, std::string, std::string>> groups;
    const auto place = [&](const Line& line) {
        const std::tuple group{line.key.target, line.key.regime, line.key.climate};
        const auto at = std::find(groups.begin(), groups.end(), group);
        if (at == groups.end()) {
            groups.push_back(group);
            return static_cast<std::ptrdiff_t>(groups.size()) - 1;
        }
        return at - groups.begin();
    };
    for (const Line& line : lines) {
        place(line);
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [&](const Line& a, const Line& b) { return place(a) < place(b); });
    return lines;
}

}  // namespace

std::optional<Difference> difference(const Figure& figure, const Figure& first, bool paired) {
    if (std::isnan(figure.value) || std::isnan(first.value)) {
        return std::nullopt;
    }
    Difference d;
    d.value = figure.value - first.value;
    std::map<long long, double> differences;
    for (const auto& [replicate, value] : figure.by_replicate) {
        const auto there = first.by_replicate.find(replicate);
        if (paired && there != first.by_replicate.end()) {
            differences[replicate] = value - there->second;
        }
    }
    const bool all_pairs =
        differences.size() == figure.by_replicate.size() && differences.size() == first.by_replicate.size();
    if (differences.size() > 1 && all_pairs) {
        const Figure mean = over_replicates({}, std::move(differences));
        d.low = mean.low;
        d.high = mean.high;
    } else if (figure.is_interval && first.is_interval) {
        const auto square = [](double x) { return x * x; };
        d.low = d.value - std::sqrt(square(figure.value - figure.low) + square(first.high - first.value));
        d.high = d.value + std::sqrt(square(figure.high - figure.value) + square(first.value - first.low));
    }
    return d;
}

bool is_nothing_everywhere(const Line& line) {
    return std::all_of(line.figures.begin(), line.figures.end(), [](const std::optional<Figure>& figure) {
        return !figure || (figure->is_part && figure->value == 0.0);
    });
}

bool all_of_one_replicate(std::span<const FinishedRun> runs) {
    return std::all_of(runs.begin(), runs.end(), [](const FinishedRun& run) {
        return run.summary.years > 0 && run.summary.replicates <= 1;
    });
}

SideBySide side_by_side(std::span<const FinishedRun> runs) {
    constexpr std::size_t most = 26;
    if (runs.size() > most) {
        config::fail(config::ExitCode::settings, {}, joined(std::to_string(runs.size()), " runs"),
                     "at most 26");
    }
    for (const FinishedRun& run : runs) {
        if (run.summary.kind != runs.front().summary.kind) {
            config::fail(config::ExitCode::settings, {run.folder.string()},
                         joined("a run of the kind '", run.summary.kind, "'"),
                         joined("one of the kind '", runs.front().summary.kind, "' as in ",
                                runs.front().folder.string()));
        }
    }
    SideBySide comparison;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        comparison.letters.emplace_back(1, static_cast<char>('A' + i));
    }
    take_inputs(runs, comparison);
    take_settings(runs, comparison);
    comparison.names = comparison.letters;
    for (const std::string_view key : {"rockfall.motion", "release.shape"}) {
        for (const Disagreement& d : comparison.settings) {
            for (std::size_t i = 0; i < runs.size() && d.what == key; ++i) {
                comparison.names[i] += " " + d.values[i];
            }
        }
    }
    judge(comparison, runs);
    const bool same_chance = std::all_of(runs.begin(), runs.end(), [&](const FinishedRun& run) {
        return run.summary.seed == runs.front().summary.seed &&
               run.summary.replicates == runs.front().summary.replicates;
    });
    comparison.lines = lines_of(runs, same_chance && comparison.not_comparable.empty());
    return comparison;
}

}  // namespace coupling::compare
