#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "config/table/table.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases {

/// A table of a case as it is shipped, such as "forest_yield".
inline config::Table shipped_table(const std::string& name, const std::string& file) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/" + name + "/" + file};
    return config::Table::read(in, file);
}

/// Its text.
inline std::string shipped_text(const std::string& name, const std::string& file) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/" + name + "/" + file};
    return {std::istreambuf_iterator<char>{in}, {}};
}

/// The forest settings of its case.ini.
inline forest::Parameters shipped_parameters(const std::string& name, CaseKind kind) {
    config::Options options;
    CaseHead head;
    Settings settings;
    validation::declare(options, head);
    declare(options, settings, kind);
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/" + name + "/case.ini"};
    options.read(in, "case.ini", {});
    return settings.forest;
}

}  // namespace coupling::validation::forest_cases
