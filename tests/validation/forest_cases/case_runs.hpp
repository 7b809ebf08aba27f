#pragma once

#include <gtest/gtest.h>

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
