# Reads the tables of a finished run and draws its protection.
#
#   Rscript read_run.R OUT [protection.png] [areas.png]
#
# OUT is the folder of the results. A run over years gives a panel for each target and climate with a line for each
# regime and the 90 % interval of the mean as a band; an assessment of today a bar for each target with its 95 %
# interval. Base R is enough; ggplot2 draws where it is installed, and with sf too the third argument is a map of
# the ground on which the regimes act. A name that ends with .pdf gives a PDF.

arguments <- commandArgs(trailingOnly = TRUE)
if (length(arguments) < 1) stop("usage: Rscript read_run.R OUT [protection.png] [areas.png]")
out <- arguments[1]
picture <- if (length(arguments) > 1) arguments[2] else "protection.png"
has_ggplot <- requireNamespace("ggplot2", quietly = TRUE)

read_table <- function(name) {
  read.csv(file.path(out, "tables", name), encoding = "UTF-8")
}

# What a column means, from the dictionary of the run.
meaning <- function(table, column) {
  dictionary <- read_table("data_dictionary.csv")
  row <- dictionary[dictionary$table == table & dictionary$column == column, ]
  paste0(row$meaning, " [", row$unit, "]")
}

# Tables over years leave out years in which too few rocks arrive.
stop_if_none <- function(rows) {
  if (nrow(rows) == 0) {
    stop(out, ": too few rocks arrive over the bare slope for a protection figure; simulate more rocks")
  }
}

open_picture <- function(width, height) {
  if (grepl("[.]pdf$", picture)) {
    pdf(picture, width = width, height = height)
  } else {
    png(picture, width = width, height = height, units = "in", res = 120, type = "cairo")
  }
}

# Okabe and Ito's colours: distinct for colour-blind readers. From the eighth regime on they come again with
# another kind of line: 42 regimes look different.
colours <- c("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
colour_of <- function(i) colours[(i - 1) %% length(colours) + 1]
line_of <- function(i) ((i - 1) %/% length(colours)) %% 6 + 1

read_years <- function() {
  bands <- read_table("regimes_by_year.csv")
  bands <- bands[bands$quantity == "protection_percent", ]
  stop_if_none(bands)
  bands$regime <- factor(bands$regime, levels = unique(bands$regime))
  # Without an interval (one replicate, or all equal) the band is the line.
  bands$mean_low_90 <- ifelse(is.na(bands$mean_low_90), bands$mean, bands$mean_low_90)
  bands$mean_high_90 <- ifelse(is.na(bands$mean_high_90), bands$mean, bands$mean_high_90)
  bands
}

draw_years_base <- function(bands) {
  targets <- unique(bands$target_id)
  climates <- unique(bands$climate)
  regimes <- levels(bands$regime)
  open_picture(7 * length(climates), 4.5 * length(targets))
  par(mfrow = c(length(targets), length(climates)), mar = c(4.5, 4.5, 3, 1))
  for (target in targets) {
    for (climate in climates) {
      here <- bands[bands$target_id == target & bands$climate == climate, ]
      plot(NA, xlim = range(bands$year), ylim = range(bands$mean_low_90, bands$mean_high_90), xlab = "year",
           ylab = "protection effect [%]", main = paste0("Rocks stopped: ", target, ", ", climate))
      for (i in seq_along(regimes)) {
        line <- here[here$regime == regimes[i], ]
        if (nrow(line) == 0) next
        polygon(c(line$year, rev(line$year)), c(line$mean_low_90, rev(line$mean_high_90)),
                col = adjustcolor(colour_of(i), alpha.f = 0.2), border = NA)
        lines(line$year, line$mean, col = colour_of(i), lwd = 2, lty = line_of(i))
      }
      legend("bottomright", legend = regimes, col = colour_of(seq_along(regimes)),
             lty = line_of(seq_along(regimes)), lwd = 2, bty = "n", title = "mean, 90 % interval")
    }
  }
  invisible(dev.off())
}

draw_years_ggplot <- function(bands) {
  library(ggplot2)
  styles <- seq_along(levels(bands$regime))
  names(styles) <- levels(bands$regime)
  plot <- ggplot(bands, aes(year, mean, colour = regime, linetype = regime)) +
    geom_ribbon(aes(ymin = mean_low_90, ymax = mean_high_90, fill = regime), alpha = 0.2, colour = NA) +
    geom_line() +
    facet_grid(target_id ~ climate) +
    scale_colour_manual(values = colour_of(styles)) +
    scale_fill_manual(values = colour_of(styles)) +
    scale_linetype_manual(values = line_of(styles)) +
    labs(x = "year", y = "protection effect [%]", title = "Rocks stopped by the forest: mean, 90 % interval") +
    theme_bw()
  panels <- c(length(unique(bands$climate)), length(unique(bands$target_id)))
  open_picture(2 + 4.5 * panels[1], 1.5 + 3.5 * panels[2])
  print(plot)
  invisible(dev.off())
}

draw_years <- function() {
  bands <- read_years()
  if (has_ggplot) draw_years_ggplot(bands) else draw_years_base(bands)
  worst <- read_table("regimes_worst_year.csv")
  print(worst[worst$quantity == "protection_percent",
              c("regime", "climate", "target_id", "year", "mean", "mean_low_90", "mean_high_90")], row.names = FALSE)
}

draw_today <- function() {
  protection <- read_table("protection.csv")
  protection <- protection[protection$too_few_rocks == "no", ]
  stop_if_none(protection)
  open_picture(6, 4.5)
  low <- pmax(protection$protection_low_percent, 0)
  at <- barplot(pmax(protection$protection_percent, 0), names.arg = protection$target_id, ylim = c(0, 100),
                col = colours[1], xlab = "target", ylab = "protection effect [%]",
                main = "Rocks stopped by the forest, with 95 % interval")
  arrows(at, low, at, pmax(protection$protection_high_percent, low + 0.01), angle = 90, code = 3, length = 0.08,
         lwd = 2)
  invisible(dev.off())
  print(protection[, c("target_id", "rocks", "reached_bare", "reached_forest", "protection_percent",
                       "protection_low_percent", "protection_high_percent")], row.names = FALSE)
}

# The ground of each row of each regime, and what is to be protected.
draw_areas <- function(file) {
  if (!has_ggplot || !requireNamespace("sf", quietly = TRUE)) {
    cat("no map of areas: ggplot2 or sf is not installed\n")
    return(invisible())
  }
  library(ggplot2)
  package <- file.path(out, "results.gpkg")
  if (!"intervention_areas" %in% sf::st_layers(package)$name) {
    cat("no map of areas: no regime has ground of its own\n")
    return(invisible())
  }
  areas <- sf::st_read(package, "intervention_areas", quiet = TRUE)
  targets <- sf::st_read(package, "targets", quiet = TRUE)
  plot <- ggplot() +
    geom_sf(data = areas, aes(fill = intervention), alpha = 0.5) +
    geom_sf(data = targets, colour = "red") +
    facet_wrap(~regime) +
    theme_bw()
  ggsave(file, plot, width = 8, height = 6, dpi = 120)
  cat("drawn:", file, "\n")
}

if (!file.exists(file.path(out, "tables", "protection.csv"))) {
  stop(out, " holds no table of protection: no rocks, no targets or no forest")
}
cat("protection_percent:", meaning("protection.csv", "protection_percent"), "\n")
if ("regime" %in% names(read_table("protection.csv"))) draw_years() else draw_today()
cat("drawn:", picture, "\n")
if (length(arguments) > 2) draw_areas(arguments[3])
