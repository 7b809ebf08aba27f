#include "validation/engine/validate.hpp"

#include "config/text/joined.hpp"
#include "coupling/run/progress.hpp"
#include "rockfall/motion/models.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/case/coverage.hpp"
#include "validation/engine/factors/factors.hpp"
#include "validation/engine/factors/outcome.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/paper_variants.hpp"

namespace coupling::validation {
namespace {

using config::joined;

/// Works through one case.
class CaseRun {
public:
    CaseRun(const ValidationCase& of, const ValidateRequest& request)
        : case_{of},
          request_{request},
          open_{of.needs_open()},
          progress_{of.files.name, all_rocks(), 0, request.quiet} {}

    CaseResult run() {
        const std::unique_ptr<Recipe> recipe = case_.recipe("default");
        result_.name = case_.files.name;
        result_.is_own = case_.files.is_own();
        result_.title = recipe->head.title;
        result_.citation = recipe->head.citation;
        result_.rebuilt = recipe->head.rebuilt;
        result_.profile = with_slope_change(case_.profile(*recipe), recipe->slope_change_deg);
        result_.rocks = recipe->rocks;
        result_.series = recipe->series;
        result_.rocks_per_series = recipe->rocks_per_series;
        result_.extent = extent_of(*recipe);
        result_.notes = case_.notes;
        for (const VariantSpec& variant : case_.variants) {
            result_.variants.push_back(run_variant(variant));
        }
        run_choices();
        result_.rows = verdict_rows(case_, result_.variants[0].values, result_.variants[1].values);
        for (VerdictRow& row : result_.rows) {
            row.model = rockfall::description_of(recipe->rockfall.fall.motion.model).name;
        }
        if (request_.draws) {
            take_coverage();
        }
        take_scatter_values(result_);
        if (case_.replaces_profile()) {
            note_own_profile();
        }
        add_sections();
        progress_.finish();
        result_.seconds = progress_.seconds();
        return std::move(result_);
    }

private:
    /// What the case says of its rebuilt slope does not hold for a slope that somebody surveyed.
    void note_own_profile() {
        result_.rebuilt = joined("The profile is ", case_.changes.profile_file,
                                 ", the user's own; the rest of the recipe and the stations are the case's.");
        for (VerdictRow& row : result_.rows) {
            row.cause.clear();
            if (case_.kind == CaseKind::profile) {
                row.rests_on = "independent";
            }
        }
    }

    [[nodiscard]] std::uint64_t all_rocks() const {
        std::uint64_t rocks = 0;
        for (const VariantSpec& variant : case_.variants) {
            rocks += rocks_of(*case_.recipe(variant.preset, variant.overrides));
        }
        for (const ChoiceSpec& choice : with_base()) {
            rocks += 2 * rocks_of(*choice_recipe("default", choice));
        }
        return rocks;
    }

    /// The choices, led by none at all.
    [[nodiscard]] std::vector<ChoiceSpec> with_base() const {
        std::vector<ChoiceSpec> choices;
        if (!case_.choices.empty()) {
            choices.push_back({as_rebuilt, {}, "nothing moved; as few rocks as below"});
            choices.insert(choices.end(), case_.choices.begin(), case_.choices.end());
        }
        return choices;
    }

    [[nodiscard]] std::unique_ptr<Recipe> choice_recipe(const std::string& preset,
                                                        const ChoiceSpec& choice) const {
        std::unique_ptr<Recipe> recipe = case_.recipe(preset, choice.overrides);
        recipe->rocks = recipe->choice_rocks;
        recipe->series = 0;
        return recipe;
    }

    [[nodiscard]] Ensembles fall(const Recipe& recipe, const RebuiltSlope& slope) {
        return simulate_falls(recipe, slope,
                              {.open_too = open_,
                               .threads = request_.threads,
                               .fallen = [this](std::uint64_t rocks) { progress_.add(rocks); }});
    }

    VariantOutcome run_variant(const VariantSpec& variant) {
        const std::unique_ptr<Recipe> recipe = case_.recipe(variant.preset, variant.overrides);
        const RebuiltSlope slope = rebuild(*recipe, case_.profile(*recipe));
        VariantOutcome outcome = outcome_of(fall(*recipe, slope), frame_of(*recipe, slope, case_.sections),
                                            slope, recipe->has_stand());
        outcome.variant = variant.name;
        outcome.meaning = variant.meaning;
        return outcome;
    }

    Values run_choice(const std::string& preset, const ChoiceSpec& choice) {
        const std::unique_ptr<Recipe> recipe = choice_recipe(preset, choice);
        const RebuiltSlope slope = rebuild(*recipe, case_.profile(*recipe));
        return values_of(fall(*recipe, slope), frame_of(*recipe, slope, case_.sections));
    }

    /// As few rocks as the moved choices have, once for each draw.
    void take_coverage() {
        const VariantSpec& ours = case_.variants[1];
        const std::unique_ptr<Recipe> recipe = choice_recipe(ours.preset, {as_rebuilt, ours.overrides, ""});
        RebuiltSlope slope = rebuild(*recipe, case_.profile(*recipe));
        const FigureFrame frame = frame_of(*recipe, slope, case_.sections);
        const std::vector<rockfall::FallDraw> draws =
            draws_for(recipe->rockfall.fall, slope.slope.types, recipe->seed);
        std::vector<std::map<std::string, double>> values;
        for (const rockfall::FallDraw& draw : draws) {
            recipe->rockfall.fall = draw.law;
            slope.slope.types = draw.types;
            std::map<std::string, double>& of_draw = values.emplace_back();
            for (const auto& [name, value] : values_of(fall(*recipe, slope), frame)) {
                of_draw[name] = value.value;
            }
        }
        std::map<std::string, double> deviations;
        for (const auto& [name, value] : result_.variants[1].values) {
            if (value.deviation) {
                deviations[name] = *value.deviation;
            }
        }
        result_.coverage = coverage_of(result_.rows, deviations, values);
    }

    void run_choices() {
        const VariantSpec& strict = case_.variants[0];
        const VariantSpec& ours = case_.variants[1];
        for (const ChoiceSpec& choice : with_base()) {
            const auto after = [&](const VariantSpec& variant) {
                ChoiceSpec moved = choice;
                moved.overrides.insert(moved.overrides.begin(), variant.overrides.begin(),
                                       variant.overrides.end());
                return run_choice(variant.preset, moved);
            };
            std::string overrides;
            for (const std::string& one : choice.overrides) {
                overrides += (overrides.empty() ? "" : " ") + one;
            }
            result_.choices.push_back(
                {choice.name, std::move(overrides), choice.reason, after(strict), after(ours)});
        }
    }

    void add_sections() {
        for (const Section& section : case_.sections) {
            const std::string figure = joined("stopped_share:", section.name);
            SectionShare share{section.name, section.from_m, section.to_m, {}, {}};
            if (const auto observed = case_.observed.find(figure); observed != case_.observed.end()) {
                share.observed = observed->second.value;
            }
            if (const auto published = case_.published.find(figure); published != case_.published.end()) {
                share.published = published->second.value;
            }
            result_.sections.push_back(std::move(share));
        }
    }

    const ValidationCase& case_;
    const ValidateRequest& request_;
    bool open_;
    CaseResult result_;
    Progress progress_;
};

/// Computes a part of the model and holds it against its reference.
CaseResult compare(const ValidationCase& of, const ValidateRequest& request) {
    Progress progress{of.files.name, of.comparison->pieces, 0, request.quiet};
    Work work{request.threads, [&progress](std::uint64_t pieces) { progress.add(pieces); }};
    work.deviations = request.draws;
    Outcome outcome = of.comparison->run(work);
    VariantOutcome variant;
    variant.variant = "default";
    for (const auto& [name, value] : outcome.values) {
        const auto deviation = outcome.seed_deviations.find(name);
        variant.values[name] = deviation == outcome.seed_deviations.end()
                                   ? Value{value, {}, {}}
                                   : Value{value, value, deviation->second};
    }
    CaseResult result;
    result.name = of.files.name;
    result.is_own = of.files.is_own();
    result.title = of.head.title;
    result.citation = of.head.citation;
    result.rebuilt = of.head.rebuilt;
    result.notes = of.notes;
    result.warnings = of.warnings;
    result.has_strict = of.has_strict();
    result.extent = of.comparison->extent;
    result.rows = verdict_rows(of, {}, variant.values);
    if (!outcome.deviations.empty()) {
        std::vector<std::map<std::string, double>> draws;
        for (std::size_t draw = 0; draw < coverage_draws; ++draw) {
            draws.push_back(of.comparison->run({request.threads, [](std::uint64_t) {}, draw}).values);
        }
        result.coverage = coverage_of(result.rows, outcome.deviations, draws);
    }
    result.variants = {std::move(variant)};
    result.plots = std::move(outcome.plots);
    result.tables = std::move(outcome.tables);
    result.details = std::move(outcome.details);
    progress.finish();
    result.seconds = progress.seconds();
    return result;
}

}  // namespace

CaseResult validate(const ValidationCase& of, const ValidateRequest& request) {
    if (of.comparison) {
        return compare(of, request);
    }
    return of.kind == CaseKind::factors ? validate_factors(of, request.threads, request.quiet)
                                        : CaseRun{of, request}.run();
}

}  // namespace coupling::validation
