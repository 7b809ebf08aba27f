#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/options/options.hpp"

namespace config {

/// A declared parameter with its target behind functions of text.
struct Options::Parameter {
    std::string key{};
    ParameterInfo info{};
    std::string kind{};
    std::string expected{};            ///< in words, for messages: "a number in [0, 2] m"
    std::vector<std::string> words{};  ///< legal values of a choice
    std::function<bool(std::string_view)> accepts{};
    std::function<void(std::string_view)> set{};  ///< requires an accepted text
    std::function<std::string()> get{};
    std::string default_text{};
    Place place{};  ///< where it was set{}; no line at its default
    bool was_set = false;
    std::string comment{};  ///< behind the value in the file

    [[nodiscard]] std::string section() const {
        const std::size_t dot = key.rfind('.');
        return dot == std::string::npos ? "" : key.substr(0, dot);
    }
    [[nodiscard]] std::string name() const {
        const std::size_t dot = key.rfind('.');
        return dot == std::string::npos ? key : key.substr(dot + 1);
    }
};

}  // namespace config
