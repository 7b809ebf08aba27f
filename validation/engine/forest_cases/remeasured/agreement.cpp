#include "validation/engine/forest_cases/remeasured/agreement.hpp"

#include <cmath>

#include "forest/stand/allometry.hpp"

namespace coupling::validation::forest_cases::remeasured {
namespace {

/// The class of a diameter; none below the first.
std::optional<std::size_t> size_class_of(const RemeasuredData& data, double dbh_cm) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < data.settings.classes_cm.size(); ++i) {
        if (dbh_cm >= data.settings.classes_cm[i]) {
            found = i;
        }
    }
    return found;
}

bool is_in(const RemeasuredData& data, const TreeGroup& group, forest::SpeciesId species, double dbh_cm) {
    return (!group.species || *group.species == species) &&
           (!group.size || size_class_of(data, dbh_cm) == group.size);
}

}  // namespace

Observed observed_of(const RemeasuredData& data, const TreeGroup& group) {
    Observed found;
    for (const MeasuredTree& tree : data.stand.trees) {
        if (tree.felled || !is_in(data, group, tree.species, tree.dbh_cm)) {
            continue;
        }
        ++found.trees;
        if (tree.end_dbh_cm) {
            ++found.survivors;
            found.increment_cm += (*tree.end_dbh_cm - tree.dbh_cm) / data.stand.years();
        }
    }
    if (found.survivors > 0) {
        found.increment_cm /= static_cast<double>(found.survivors);
    }
    return found;
}

std::vector<TreeGroup> groups_of(const RemeasuredData& data) {
    std::vector<std::optional<forest::SpeciesId>> species{std::nullopt};
    species.insert(species.end(), data.kinds.begin(), data.kinds.end());
    std::vector<TreeGroup> groups;
    for (const auto& kind : species) {
        for (std::size_t size = 0; size <= data.settings.classes_cm.size(); ++size) {
            const TreeGroup group{kind, size == 0 ? std::nullopt : std::optional{size - 1}};
            if (observed_of(data, group).trees > 0) {
                groups.push_back(group);
            }
        }
    }
    return groups;
}

TreeMeans means_of(const RemeasuredData& data, const std::vector<Regrown>& runs) {
    TreeMeans means;
    for (std::size_t i = 0; i < data.stand.trees.size(); ++i) {
        double sum_cm = 0.0;
        double standing = 0.0;
        for (const Regrown& run : runs) {
            sum_cm += run.end_dbh_cm[i].value_or(0.0);
            standing += run.end_dbh_cm[i] ? 1.0 : 0.0;
        }
        means.end_dbh_cm.push_back(standing > 0.0 ? sum_cm / standing : 0.0);
        means.survival.push_back(standing / static_cast<double>(runs.size()));
    }
    return means;
}

Simulated simulated_of(const RemeasuredData& data, const TreeGroup& group, const TreeMeans& means) {
    Simulated found;
    double trees = 0.0;
    double paired = 0.0;
    double increment_cm = 0.0;
    double bias_cm = 0.0;
    double squares_cm2 = 0.0;
    for (std::size_t i = 0; i < data.stand.trees.size(); ++i) {
        const MeasuredTree& tree = data.stand.trees[i];
        if (tree.felled || !is_in(data, group, tree.species, tree.dbh_cm)) {
            continue;
        }
        trees += 1.0;
        found.survival += means.survival[i];
        if (tree.end_dbh_cm && means.survival[i] > 0.0) {
            const double difference_cm = means.end_dbh_cm[i] - *tree.end_dbh_cm;
            paired += 1.0;
            increment_cm += (means.end_dbh_cm[i] - tree.dbh_cm) / data.stand.years();
            bias_cm += difference_cm;
            squares_cm2 += difference_cm * difference_cm;
        }
    }
    found.survival /= trees;
    if (paired > 0.0) {
        found.increment_cm = increment_cm / paired;
        found.bias_cm = bias_cm / paired;
        found.rmse_cm = std::sqrt(squares_cm2 / paired);
    }
    return found;
}

EndStand observed_end(const RemeasuredData& data, const std::optional<forest::SpeciesId>& species) {
    EndStand end;
    const TreeGroup group{species, std::nullopt};
    const double area_ha = data.stand.area_ha();
    const auto add = [&](forest::SpeciesId kind, double dbh_cm, bool is_new) {
        if (is_in(data, group, kind, dbh_cm) && dbh_cm >= data.stand.least_dbh_cm) {
            end.stems_pha += 1.0 / area_ha;
            end.basal_area_m2pha += forest::basal_area_m2(dbh_cm) / area_ha;
            end.ingrown_pha += is_new ? 1.0 / area_ha : 0.0;
        }
    };
    for (const MeasuredTree& tree : data.stand.trees) {
        if (tree.end_dbh_cm) {
            add(tree.species, *tree.end_dbh_cm, false);
        }
    }
    for (const IngrownTree& tree : data.stand.ingrown) {
        add(tree.species, tree.dbh_cm, true);
    }
    return end;
}

EndStand simulated_end(const RemeasuredData& data, const std::optional<forest::SpeciesId>& species,
                       const std::vector<Regrown>& runs) {
    EndStand end;
    const double per_stem = 1.0 / (data.stand.area_ha() * static_cast<double>(runs.size()));
    const auto add = [&](forest::SpeciesId kind, double dbh_cm, bool is_new) {
        if (!species || *species == kind) {
            end.stems_pha += per_stem;
            end.basal_area_m2pha += forest::basal_area_m2(dbh_cm) * per_stem;
            end.ingrown_pha += is_new ? per_stem : 0.0;
        }
    };
    for (const Regrown& run : runs) {
        for (std::size_t i = 0; i < data.stand.trees.size(); ++i) {
            if (run.end_dbh_cm[i]) {
                add(data.stand.trees[i].species, *run.end_dbh_cm[i], false);
            }
        }
        for (const IngrownTree& tree : run.ingrown) {
            add(tree.species, tree.dbh_cm, true);
        }
    }
    return end;
}

}  // namespace coupling::validation::forest_cases::remeasured
