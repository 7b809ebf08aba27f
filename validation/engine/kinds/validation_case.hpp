#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/profile.hpp"
#include "validation/engine/slope/quantities.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation {

/// A figure measured in the field.
struct ObservedFigure {
    double value = 0.0;
    std::string source;
};

/// A figure simulated by the model's authors.
struct PublishedFigure {
    std::optional<double> value;        ///< of their large ensemble; of the series where that is all there is
    std::optional<double> series_mean;  ///< over small series
    std::optional<double> deviation;    ///< as published: between series, or between rocks (see source)
    std::string source;
};

struct Comparison;

/// What a figure has to keep to; set before the model was run.
struct Criterion {
    double low = 0.0;
    double high = 0.0;
    std::string
        rests_on;  ///< independent; rebuilding: used to rebuild the slope; fitted: to calibrate the model
    std::string rule;
    std::string cause;  ///< likely cause of a miss, "" without
};

/// Settings that stand side by side.
struct VariantSpec {
    std::string name;
    std::string preset;
    std::vector<std::string> overrides;
    std::string meaning;
};

/// A free choice of the rebuilding, moved within reason.
struct ChoiceSpec {
    std::string name;
    std::vector<std::string> overrides;
    std::string reason;
};

/// What the user wants of a case beside what its folder says.
struct CaseChanges {
    std::vector<std::string> overrides;       ///< section.key=value, the last to win
    std::optional<std::uint64_t> most_rocks;  ///< of the large ensemble; everything else shrinks with it
    std::string profile_text;                 ///< takes the place of every profile of the case, "" without
    std::string profile_file;                 ///< its name in messages
};

/// A case as its folder describes it, read and checked.
struct ValidationCase {
    CaseFiles files;
    CaseChanges changes;
    CaseKind kind = CaseKind::slope;
    std::vector<Section> sections;
    std::vector<std::string> figures;  ///< observed, published or with a criterion, in order of appearance
    std::map<std::string, ObservedFigure> observed;
    std::map<std::string, PublishedFigure> published;
    std::map<std::string, Criterion> criteria;
    std::vector<VariantSpec> variants;  ///< strict and default first; none without rocks
    std::vector<ChoiceSpec> choices;
    std::vector<std::string> notes;
    std::vector<std::string> warnings;
    CaseHead head;
    std::shared_ptr<const Comparison> comparison;  ///< of a kind of the forest, and of the field

    /// Whether the settings of a paper are held against its figures beside ours.
    [[nodiscard]] bool has_strict() const { return !comparison; }
    /// Of a figure for people; empty for a name that there is not.
    [[nodiscard]] std::string label_of(const std::string& figure) const;
    [[nodiscard]] std::string unit_of(const std::string& figure) const;
    [[nodiscard]] bool replaces_profile() const { return !changes.profile_file.empty(); }
    /// The settings under a named set with overrides of a variant or choice and the user's after them.
    [[nodiscard]] std::unique_ptr<Recipe> recipe(const std::string& preset,
                                                 const std::vector<std::string>& overrides = {}) const;
    /// The profile that a recipe names, as its file has it; the user's where the user replaced it. Throws
    /// InputError (file, data).
    [[nodiscard]] Profile profile(const Recipe& recipe) const;
    /// Whether any figure needs the same rocks over the bare slope.
    [[nodiscard]] bool needs_open() const;
};

/// Reads and checks all files of a case. Throws InputError with every problem of every file: file, line,
/// column, what was found, what was expected. For factors the names of figures are left to factors.hpp.
ValidationCase read_case(const CaseFiles& files, const CaseChanges& changes = {});

}  // namespace coupling::validation
