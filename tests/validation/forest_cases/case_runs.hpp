#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "config/errors/input_error.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/validate.hpp"

namespace coupling::validation::forest_cases {

/// A case as it is shipped.
inline CaseFiles shipped(const std::string& name) {
    for (CaseFiles& files : shipped_cases()) {
        if (files.name == name) {
            return std::move(files);
        }
    }
    ADD_FAILURE() << "no case " << name;
    return {};
}

/// What `bannwald validate` finds in it.
inline CaseResult result_of(const CaseFiles& files, const CaseChanges& changes = {}, int threads = 2) {
    return validate(read_case(files, changes), {.threads = threads, .quiet = true});
}

/// The row of a figure.
inline const VerdictRow& row_of(const CaseResult& result, const std::string& quantity) {
    for (const VerdictRow& row : result.rows) {
        if (row.quantity == quantity) {
            return row;
        }
    }
    throw std::runtime_error{"no row " + quantity};
}

/// Whether a case says that it changes a law of the forest.
inline bool changes_a_law(const ValidationCase& of) {
    return std::any_of(of.notes.begin(), of.notes.end(),
                       [](const std::string& note) { return note.starts_with("not the defaults of a run"); });
}

/// Replaces what a text must hold.
inline void replace(std::string& text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
}

/// The first thing that reading a case refuses; nothing if it reads.
inline std::string problem_of(const CaseFiles& files, const CaseChanges& changes = {}) {
    try {
        read_case(files, changes);
    } catch (const config::InputError& error) {
        return config::to_string(error.problems().front());
    }
    return "";
}

}  // namespace coupling::validation::forest_cases
