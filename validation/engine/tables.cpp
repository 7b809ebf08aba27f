#include "validation/engine/tables.hpp"

#include <limits>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "validation/engine/kinds/verdict.hpp"

namespace coupling::validation {
namespace {

using config::joined;

constexpr double no_entry = std::numeric_limits<double>::quiet_NaN();
constexpr int decimals = 5;

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::inside:
            return "inside";
        case Verdict::missed:
            return "missed";
        case Verdict::no_criterion:
            break;
    }
    return "";
}

void put(CsvRow& row, const std::optional<double>& value) {
    row.number<decimals>(value.value_or(no_entry));
}

void put(CsvRow& row, const Value& value) {
    row.number<decimals>(value.value);
    put(row, value.series);
    put(row, value.deviation);
}

void put(CsvRow& row, const Estimate& estimate) {
    row.number<decimals>(estimate.value).number<decimals>(estimate.low).number<decimals>(estimate.high);
}

/// Value and verdict of a figure under a moved choice.
void put_moved(CsvRow& row, const Values& values, const VerdictRow& of) {
    const auto found = values.find(of.quantity);
    const double value = found != values.end() ? found->second.value : no_entry;
    row.number<decimals>(value);
    row.text(of.low && of.high ? word_of(verdict_of(value, {*of.low, *of.high, {}, {}, {}})) : "");
}

}  // namespace

void write_verdicts(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,quantity,label,unit,observed,observed_source,published,published_deviation,published_source,"
           "strict,strict_series_mean,strict_series_deviation,default,default_series_mean,"
           "default_series_deviation,low,high,rests_on,rule,strict_verdict,default_verdict,cause,"
           "strict_scatter\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VerdictRow& row : result.rows) {
            line.text(result.name).text(row.quantity).text(row.label).text(row.unit);
            put(line, row.observed);
            line.text(row.observed_source);
            put(line, row.published);
            put(line, row.published_deviation);
            line.text(row.published_source);
            put(line, row.strict_value);
            put(line, row.default_value);
            put(line, row.low);
            put(line, row.high);
            line.text(row.rests_on).text(row.rule).text(word_of(row.strict_verdict));
            line.text(word_of(row.default_verdict)).text(row.cause);
            put(line, row.scatter_value ? std::optional{row.scatter_value->value} : std::nullopt);
            line.end();
        }
    }
}

void write_figures(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,quantity,value,series_mean,series_deviation\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VariantOutcome& variant : result.variants) {
            for (const auto& [quantity, value] : variant.values) {
                line.text(result.name).text(variant.variant).text(quantity);
                put(line, value);
                line.end();
            }
        }
    }
}

void write_plots(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,group,plot,x_title,y_title,series,x,y,y_low\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const PlotGroup& group : result.plots) {
            for (const Plot& plot : group.plots) {
                for (const PlotSeries& series : plot.series) {
                    const auto put_point = [&](double x, double y, double y_low) {
                        line.text(result.name).text(group.title).text(plot.title).text(plot.x.title);
                        line.text(plot.y.title).text(series.name);
                        line.number<decimals>(x).number<decimals>(y).number<decimals>(y_low).end();
                    };
                    for (const report::ChartPoint& point : series.points) {
                        put_point(point.x, point.y, no_entry);
                    }
                    for (const report::ChartRange& range : series.ranges) {
                        put_point(range.x, range.high, range.low);
                    }
                }
            }
        }
    }
}

void write_choices(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,choice,overrides,reason,quantity,unit,low,high,strict,strict_verdict,default,"
           "default_verdict\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const ChoiceOutcome& choice : result.choices) {
            for (const VerdictRow& row : result.rows) {
                line.text(result.name).text(choice.choice).text(choice.overrides).text(choice.reason);
                line.text(row.quantity).text(row.unit);
                put(line, row.low);
                put(line, row.high);
                put_moved(line, choice.strict_values, row);
                put_moved(line, choice.default_values, row);
                line.end();
            }
        }
    }
}

void write_run_out(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,distance_m,share,series_05,series_95\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VariantOutcome& variant : result.variants) {
            for (std::size_t k = 0; k < variant.run_out.size(); ++k) {
                line.text(result.name).text(variant.variant);
                line.number<decimals>(variant.run_out[k].x).number<decimals>(variant.run_out[k].y);
                line.number<decimals>(k < variant.run_out_low.size() ? variant.run_out_low[k].y : no_entry);
                line.number<decimals>(k < variant.run_out_high.size() ? variant.run_out_high[k].y : no_entry);
                line.end();
            }
        }
    }
}

void write_jumps(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,part,from_m,to_m,jumps,shortest_m,mean_m,longest_m,deviation_m,mean_height_m,"
           "highest_m\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VariantOutcome& variant : result.variants) {
            for (const SegmentJumps& segment : variant.jumps) {
                line.text(result.name).text(variant.variant).text(segment.upper ? "upper" : "lower");
                line.number<1>(segment.from_m).number<1>(segment.to_m).whole(segment.jumps);
                line.number<decimals>(segment.shortest_m).number<decimals>(segment.mean_m);
                line.number<decimals>(segment.longest_m).number<decimals>(segment.deviation_m);
                line.number<decimals>(segment.mean_height_m).number<decimals>(segment.highest_m).end();
            }
        }
    }
}

void write_tree_hits(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,hits,share_of_rocks,series_05,series_95\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VariantOutcome& variant : result.variants) {
            for (std::size_t hits = 0; hits < variant.tree_hits.size(); ++hits) {
                line.text(result.name).text(variant.variant).whole(hits);
                line.number<decimals>(variant.tree_hits[hits]);
                const bool has_range = hits < variant.tree_hits_low.size();
                line.number<decimals>(has_range ? variant.tree_hits_low[hits] : no_entry);
                line.number<decimals>(has_range ? variant.tree_hits_high[hits] : no_entry).end();
            }
        }
    }
}

void write_hit_heights(std::ostream& out, std::span<const CaseResult> cases) {
    constexpr double bin_m = 0.5;
    out << "case,variant,from_m,to_m,share_of_hits\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const VariantOutcome& variant : result.variants) {
            for (std::size_t bin = 0; bin < variant.hit_heights.size(); ++bin) {
                const double from_m = bin_m * static_cast<double>(bin);
                line.text(result.name).text(variant.variant).number<1>(from_m).number<1>(from_m + bin_m);
                line.number<decimals>(variant.hit_heights[bin]).end();
            }
        }
    }
}

void write_factors(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,settings,figure,value,low_95,high_95\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const FactorRow& row : result.factors) {
            std::string settings;
            for (std::size_t i = 0; i < row.settings.size(); ++i) {
                settings += joined(i == 0 ? "" : " ", result.factor_settings[i], "=",
                                   config::to_text(row.settings[i]));
            }
            for (const auto& [figure, estimate] : row.figures) {
                line.text(result.name).text(row.variant).text(settings).text(figure);
                put(line, estimate);
                line.end();
            }
        }
    }
}

void write_directions(std::ostream& out, std::span<const CaseResult> cases) {
    out << "case,variant,figure,setting,expected,source,change,low_95,high_95,steps_against,verdict\n";
    CsvRow line{out};
    for (const CaseResult& result : cases) {
        for (const DirectionRow& row : result.directions) {
            line.text(result.name).text(row.variant).text(row.figure).text(row.setting);
            line.text(row.rises ? "rises" : "falls").text(row.source);
            put(line, row.change);
            line.whole(row.steps_against).text(word_of(row.verdict)).end();
        }
    }
}

}  // namespace coupling::validation
