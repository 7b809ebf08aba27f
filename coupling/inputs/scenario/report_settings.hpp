#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/options/options.hpp"
#include "config/text/language.hpp"

namespace coupling {

/// A picture for the head of pages, as it lies in its file.
struct Logo {
    std::string media_type;  ///< "image/png", "image/jpeg", "image/svg+xml"; empty: no logo
    std::string bytes;
};

/// The settings of section [report]: what stands over the pages of a run.
struct ReportSettings {
    std::string title;   ///< empty: what the page is about
    std::string client;  ///< for whom
    std::string author;
    std::string place;
    std::string date;  ///< 2026-11-24 or 24.11.2026; empty: none, for results know no time
    std::string logo;  ///< PNG, JPEG or SVG file
    config::Language language = config::Language::en;
    Logo picture;  ///< of the file, which is read with the scenario
};

void declare(config::Options& options, ReportSettings& report);

/// A date that is none, texts with line breaks or longer than a heading: problems of the settings.
void check(const ReportSettings& report, const config::Options& options, config::Problems& problems);

/// A picture that a page may hold. Throws InputError (data) for bytes that are no whole PNG, JPEG or SVG, for
/// more than 2 MB, and for an SVG with scripts or with addresses outside of it.
Logo read_logo(std::string_view bytes, const config::Place& place);

/// Whether pages have a head of their own: any of the settings but the language is given.
bool has_head(const ReportSettings& report);

}  // namespace coupling
