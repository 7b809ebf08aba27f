# Reads the tables of a finished run and draws its protection, with base R alone.
#
#   Rscript read_run.R OUT [protection.png]
#
# OUT is the folder of the results. A run over years gives a line for each regime (in each climate) with the 90 %
# interval of the mean as a band; an assessment of today a bar for each target with its 95 % interval. A name
# that ends with .pdf gives a PDF.

arguments <- commandArgs(trailingOnly = TRUE)
if (length(arguments) < 1) stop("usage: Rscript read_run.R OUT [protection.png]")
out <- arguments[1]
picture <- if (length(arguments) > 1) arguments[2] else "protection.png"

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

# Okabe and Ito's colours: told apart by colour-blind readers.
colours <- c("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")

draw_years <- function() {
  bands <- read_table("regimes_by_year.csv")
  bands <- bands[bands$quantity == "protection_percent", ]
  stop_if_none(bands)
  if (length(unique(bands$climate)) > 1) bands$regime <- paste(bands$regime, bands$climate, sep = ", ")
  targets <- unique(bands$target_id)
  regimes <- unique(bands$regime)
  open_picture(8, 4.5 * length(targets))
  par(mfrow = c(length(targets), 1), mar = c(4.5, 4.5, 3, 1))
  for (target in targets) {
    here <- bands[bands$target_id == target, ]
    plot(NA, xlim = range(here$year), ylim = range(here$mean_low_90, here$mean_high_90), xlab = "year",
         ylab = "protection effect [%]", main = paste("Rocks stopped by the forest:", target))
    for (i in seq_along(regimes)) {
      line <- here[here$regime == regimes[i], ]
      if (nrow(line) == 0) next
      colour <- colours[(i - 1) %% length(colours) + 1]
      polygon(c(line$year, rev(line$year)), c(line$mean_low_90, rev(line$mean_high_90)),
              col = adjustcolor(colour, alpha.f = 0.2), border = NA)
      lines(line$year, line$mean, col = colour, lwd = 2, lty = i)
    }
    legend("bottomright", legend = regimes, col = colours[(seq_along(regimes) - 1) %% length(colours) + 1],
           lty = seq_along(regimes), lwd = 2, bty = "n", title = "mean, 90 % interval")
  }
  invisible(dev.off())
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

if (!file.exists(file.path(out, "tables", "protection.csv"))) {
  stop(out, " holds no table of protection: no rocks, no targets or no forest")
}
cat("protection_percent:", meaning("protection.csv", "protection_percent"), "\n")
if ("regime" %in% names(read_table("protection.csv"))) draw_years() else draw_today()
cat("drawn:", picture, "\n")
