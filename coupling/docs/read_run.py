"""Reads the tables of a finished run and draws its protection.

    python3 read_run.py OUT [protection.png]

OUT is the folder of the results. Needs the standard library alone; with matplotlib it also draws: of a run over
years a panel for each target and climate with a line for each regime and the 90 % interval of the mean as a band,
of an assessment of today a bar for each target with its 95 % interval.
"""

import csv
import os
import sys

# Okabe and Ito's colours: distinct for colour-blind readers. From the eighth regime on they come again with
# another kind of line: 28 regimes look different.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
LINES = ["-", "--", ":", "-."]


def read_table(out, name):
    with open(os.path.join(out, "tables", name), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def number(text):
    """An empty field is not known."""
    return float(text) if text else float("nan")


def meaning(out, table, column):
    """What a column means, from the dictionary of the run."""
    for row in read_table(out, "data_dictionary.csv"):
        if row["table"] == table and row["column"] == column:
            return f"{row['meaning']} [{row['unit']}]"
    raise KeyError(f"{table} has no column {column}")


def names(rows, column):
    """Different values in the order in which they come."""
    return list(dict.fromkeys(row[column] for row in rows))


def protection_over_years(out):
    """{(target, climate): {regime: [(year, mean, low, high), ...]}} in percent."""
    protection = {}
    for row in read_table(out, "regimes_by_year.csv"):
        if row["quantity"] == "protection_percent":
            mean = number(row["mean"])
            low, high = (number(row[end]) if row[end] else mean for end in ("mean_low_90", "mean_high_90"))
            panel = protection.setdefault((row["target_id"], row["climate"]), {})
            panel.setdefault(row["regime"], []).append((int(row["year"]), mean, low, high))
    return protection


def protection_today(out):
    """[(target, percent, low, high), ...] of the targets at which enough rocks arrive"""
    return [
        (row["target_id"], number(row["protection_percent"]), number(row["protection_low_percent"]),
         number(row["protection_high_percent"]))
        for row in read_table(out, "protection.csv")
        if row["too_few_rocks"] == "no"
    ]


def draw_years(pyplot, protection):
    targets = list(dict.fromkeys(target for target, _ in protection))
    climates = list(dict.fromkeys(climate for _, climate in protection))
    regimes = list(dict.fromkeys(regime for panel in protection.values() for regime in panel))
    figure, panels = pyplot.subplots(len(targets), len(climates), sharex=True, sharey=True, squeeze=False,
                                     figsize=(7 * len(climates), 4.5 * len(targets)))
    for (target, climate), lines in protection.items():
        panel = panels[targets.index(target)][climates.index(climate)]
        for regime, line in lines.items():
            years, mean, low, high = zip(*line)
            style = regimes.index(regime)
            colour = COLOURS[style % len(COLOURS)]
            panel.fill_between(years, low, high, color=colour, alpha=0.2, linewidth=0)
            panel.plot(years, mean, color=colour, label=regime,
                       linestyle=LINES[style // len(COLOURS) % len(LINES)])
        panel.set(title=f"Rocks stopped by the forest: {target}, {climate}", xlabel="year",
                  ylabel="protection effect [%]")
        panel.legend(title="mean, 90 % interval")
    return figure


def draw_today(pyplot, protection):
    figure, panel = pyplot.subplots(figsize=(6, 4.5))
    for target, percent, low, high in protection:
        panel.bar(target, percent, color=COLOURS[0])
        panel.plot([target, target], [low, high], color="black", marker="_", markersize=14)
    panel.set(title="Rocks stopped by the forest, with 95 % interval", xlabel="target",
              ylabel="protection effect [%]", ylim=(0, 100))
    return figure


def main(arguments):
    if not arguments:
        sys.exit("usage: python3 read_run.py OUT [protection.png]")
    out = arguments[0]
    picture = arguments[1] if len(arguments) > 1 else "protection.png"
    if not os.path.exists(os.path.join(out, "tables", "protection.csv")):
        sys.exit(f"{out} holds no table of protection: no rocks, no targets or no forest")
    print("protection_percent:", meaning(out, "protection.csv", "protection_percent"))
    over_years = os.path.exists(os.path.join(out, "tables", "regimes_by_year.csv"))
    protection = protection_over_years(out) if over_years else protection_today(out)
    if not protection:
        sys.exit(f"{out}: too few rocks arrive over the bare slope for a protection figure; simulate more rocks")
    if over_years:
        for (target, climate), regimes in protection.items():
            for regime, line in regimes.items():
                year, mean, low, high = line[-1]
                print(f"{target}, {climate}, {regime}: {mean:.1f} % ({low:.1f} to {high:.1f}) in year {year}")
    else:
        for target, percent, low, high in protection:
            print(f"{target}: {percent:.1f} % ({low:.1f} to {high:.1f})")
    try:
        import matplotlib
    except ImportError:
        print("matplotlib is not installed: nothing is drawn")
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure = draw_years(pyplot, protection) if over_years else draw_today(pyplot, protection)
    figure.tight_layout()
    figure.savefig(picture, dpi=120)
    print("drawn:", picture)


if __name__ == "__main__":
    main(sys.argv[1:])
