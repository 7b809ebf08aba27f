#include "coupling/inputs/formats/height_unit.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/proj_handles.hpp"

namespace coupling::formats {

std::optional<HeightUnit> height_unit_of_system(int epsg) {
    const ProjContext context = silent_context();
    const ProjSystem system{proj_create_from_database(context.get(), "EPSG", std::to_string(epsg).c_str(),
                                                      PJ_CATEGORY_CRS, 0, nullptr)};
    if (!system || proj_get_type(system.get()) != PJ_TYPE_VERTICAL_CRS) {
        return std::nullopt;
    }
    const ProjSystem axes{proj_crs_get_coordinate_system(context.get(), system.get())};
    const char* direction = nullptr;
    double metres = 1.0;
    if (!axes || proj_cs_get_axis_info(context.get(), axes.get(), 0, nullptr, nullptr, &direction, &metres,
                                       nullptr, nullptr, nullptr) == 0) {
        return std::nullopt;
    }
    return HeightUnit{proj_get_name(system.get()), metres,
                      direction != nullptr && std::string_view{direction} == "down"};
}

std::optional<HeightUnit> height_unit_of_unit(int epsg) {
    const ProjContext context = silent_context();
    const char* name = nullptr;
    const char* category = nullptr;
    double metres = 1.0;
    if (proj_uom_get_info_from_database(context.get(), "EPSG", std::to_string(epsg).c_str(), &name, &metres,
                                        &category) == 0 ||
        name == nullptr || category == nullptr || std::string_view{category} != "linear") {
        return std::nullopt;
    }
    return HeightUnit{name, metres, false};
}

std::optional<HeightUnit> height_unit_in_words(const std::string& word) {
    struct Named {
        std::string_view word;
        double metres;
    };
    constexpr double foot_m = 0.3048;
    constexpr double us_survey_foot_m = 1200.0 / 3937.0;
    constexpr std::array known{Named{"m", 1.0},
                               Named{"metre", 1.0},
                               Named{"meter", 1.0},
                               Named{"metres", 1.0},
                               Named{"meters", 1.0},
                               Named{"ft", foot_m},
                               Named{"foot", foot_m},
                               Named{"feet", foot_m},
                               Named{"international foot", foot_m},
                               Named{"us survey foot", us_survey_foot_m},
                               Named{"us survey feet", us_survey_foot_m},
                               Named{"foot_us", us_survey_foot_m},
                               Named{"us-ft", us_survey_foot_m},
                               Named{"ftus", us_survey_foot_m},
                               Named{"cm", 0.01},
                               Named{"dm", 0.1},
                               Named{"mm", 0.001},
                               Named{"km", 1000.0}};
    const std::string lower = config::in_lower_case(std::string{config::trimmed(word)});
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const Named& named) { return named.word == lower; });
    return found == known.end() ? std::nullopt : std::optional{HeightUnit{word, found->metres, false}};
}

std::string vertical_text(const HeightUnit& unit) {
    std::string name = unit.name;
    std::erase(name, '"');
    return config::joined("VERTCS[\"", name, "\",PARAMETER[\"Direction\",", unit.is_depth ? "-1.0" : "1.0",
                          "],UNIT[\"unit\",", config::to_text(unit.metres), "]]");
}

}  // namespace coupling::formats
