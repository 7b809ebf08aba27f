-- Cells: a species at a place of its range, trees of one size among larger ones.
CREATE VIEW cells AS
  SELECT sites.*, code, latin_name, degree_days, wetness, growth_mm_pyear, mortality_pyear
  FROM sites JOIN species_names USING (species)
  JOIN reference USING (species, place, dbh_cm, larger_m2pha);
-- The thin trees of a cell at the start, and what they are at the end; NULL for the dead.
CREATE VIEW fates AS
  SELECT start.site, start.dbh_cm AS first_cm, last.dbh_cm AS last_cm, last_year AS years
  FROM asked JOIN trees AS start ON start.year = 0
  LEFT JOIN trees AS last ON last.year = last_year AND last.site = start.site
    AND last.replicate = start.replicate AND last.tree_id = start.tree_id;

-- figure growth_mm_pyear:{site} | cells | diameter growth, {latin_name} of {dbh_cm} cm under {larger_m2pha} m2/ha, {words} | mm
SELECT 10.0 * avg(last_cm - first_cm) / max(years) FROM fates WHERE site = :site AND first_cm < :dbh_cm + 5;
-- figure mortality_pyear:{site} | cells | deaths a year, {latin_name} of {dbh_cm} cm under {larger_m2pha} m2/ha, {words} | -
SELECT 1 - power(1.0 * count(last_cm) / count(*), 1.0 / max(years)) FROM fates WHERE site = :site AND first_cm < :dbh_cm + 5;
-- figure growth_ratio:{site} | cells | growth / inventories, {latin_name} of {dbh_cm} cm under {larger_m2pha} m2/ha, {words} | -
SELECT value / :growth_mm_pyear FROM figures WHERE figure = 'growth_mm_pyear:' || :site;
-- figure mortality_ratio:{site} | cells | mortality / inventories, {latin_name} of {dbh_cm} cm under {larger_m2pha} m2/ha, {words} | -
SELECT value / :mortality_pyear FROM figures WHERE figure = 'mortality_pyear:' || :site;

-- Shares of cells that agree, of each species and of all.
CREATE VIEW ranges AS
  SELECT DISTINCT 'all' AS who, place, words AS place_words, 'all species' AS who_words, '%' AS pattern
  FROM sites
  UNION SELECT DISTINCT code, place, words, latin_name, code FROM cells;
-- figure share_growth:{who}:{place} | ranges | cells whose growth agrees with inventories, {who_words}, {place_words} | -
SELECT avg(coalesce(value, 0) BETWEEN 0.6 AND 1.6) FROM figures
WHERE figure LIKE 'growth_ratio:' || :pattern || ':' || :place || ':%:%';
-- figure share_mortality:{who}:{place} | ranges | cells whose mortality agrees with inventories, {who_words}, {place_words} | -
SELECT avg(coalesce(value, 0) BETWEEN 1.0 / 3 AND 3) FROM figures
WHERE figure LIKE 'mortality_ratio:' || :pattern || ':' || :place || ':%:%';
-- The species that make most mountain forests, at the optimum: how close their deaths are.
CREATE VIEW closeness AS SELECT 1.5 AS factor UNION SELECT 2.5;
-- figure share_mortality_within:{factor} | closeness | cells of spruce, fir, beech and larch at the optimum whose mortality agrees within a factor of {factor} | -
SELECT avg(coalesce(value, 0) BETWEEN 1 / (:factor + 0) AND :factor + 0) FROM figures
WHERE figure GLOB 'mortality_ratio:piab:2:*' OR figure GLOB 'mortality_ratio:abal:2:*'
   OR figure GLOB 'mortality_ratio:fasy:2:*' OR figure GLOB 'mortality_ratio:lade:2:*';

-- table Trees among larger ones of their species: simulated / inventories
SELECT latin_name AS species, words AS place, degree_days AS "degree-days", wetness AS "(P - PET) / PET", dbh_cm AS "DBH, cm", larger_m2pha AS "larger trees, m2/ha",
  coalesce((SELECT printf('%.1f', value) FROM figures WHERE figure = 'growth_mm_pyear:' || site AND value IS NOT NULL), '-') || ' / '
    || printf('%.1f', growth_mm_pyear) AS "growth, mm a year",
  coalesce((SELECT printf('%.2f', 100 * value) FROM figures WHERE figure = 'mortality_pyear:' || site AND value IS NOT NULL), '-') || ' / '
    || printf('%.2f', 100 * mortality_pyear) AS "deaths, % a year"
FROM cells;
