CREATE INDEX trees_by_year ON trees (year);
-- Tables that no stand can have: mean trees from 10 cm on, their wood from 15 cm on, where few stems are below 7 cm.
CREATE VIEW table_rows AS
  SELECT *, pi() * mean_dbh_cm * mean_dbh_cm / 40000 AS tree_m2, 100.0 * mean_height_m / mean_dbh_cm AS slenderness
  FROM yield_tables;
-- warning yield_tables.csv | stems and mean diameter that make another basal area; check stems_pha and mean_dbh_cm (cm)
SELECT line FROM table_rows
WHERE mean_dbh_cm >= 10 AND abs(basal_area_m2pha - stems_pha * tree_m2) > 0.15 * stems_pha * tree_m2;
-- warning yield_tables.csv | a mean tree that is less than 15 or more than 150 times as high as thick; check mean_height_m (m) and mean_dbh_cm (cm)
SELECT line FROM table_rows WHERE mean_dbh_cm >= 10 AND slenderness NOT BETWEEN 15 AND 150;
-- warning yield_tables.csv | a volume that is less than 0.15 or more than 0.75 of basal area times height; check volume_m3pha and stems_pha: are they swapped?
SELECT line FROM table_rows
WHERE mean_dbh_cm >= 15 AND volume_m3pha / (stems_pha * tree_m2 * mean_height_m) NOT BETWEEN 0.15 AND 0.75;
-- warning yield_tables.csv | more stems than at the age before; check stems_pha and age_years
SELECT line FROM (SELECT line, stems_pha, lag(stems_pha) OVER (PARTITION BY stand ORDER BY age_years) AS before FROM yield_tables)
WHERE stems_pha > before;
-- warning yield_tables.csv | most mean trees of 20 cm or more are more than 105 times as high as thick; check whether the columns mean_dbh_cm and mean_height_m are swapped
SELECT NULL AS line FROM (SELECT avg(slenderness > 105) AS slender FROM table_rows WHERE mean_dbh_cm >= 20) WHERE slender > 0.5;
-- error starts.csv | stand {stand} that does not start as the youngest row of its table | {wanted}
SELECT starts.line, starts.stand,
  printf('stems_pha %s, mean_dbh_cm %s, mean_height_m %s, age_years %s', young.stems_pha, young.mean_dbh_cm, young.mean_height_m, young.age_years) AS wanted
FROM starts JOIN yield_tables AS young USING (stand)
WHERE young.age_years = (SELECT min(age_years) FROM yield_tables WHERE stand = starts.stand)
  AND (starts.stems_pha, starts.mean_dbh_cm, starts.mean_height_m, starts.age_years)
    <> (young.stems_pha, young.mean_dbh_cm, young.mean_height_m, young.age_years);
-- error sites.csv | site {site} of {species} on stand {stand}, which is of {started} | the species of the stand in starts.csv
SELECT sites.line, site, sites.species, stand, starts.species AS started
FROM sites JOIN starts ON stand = "stands.number" WHERE sites.species <> starts.species;
-- error sites.csv | site {site}, thinned by a table that has no stand {stand} at two ages | regimes.list = none, or a stand of yield_tables.csv: {known}
SELECT sites.line, site, "stands.number" AS stand, (SELECT group_concat(DISTINCT stand) FROM yield_tables) AS known
FROM sites WHERE "regimes.list" <> 'none' AND (SELECT count(*) FROM yield_tables WHERE stand = "stands.number") < 2;

-- Ages that are compared: every ten years from 40 to 140 years, as far as the table goes; those of the fit and later ones.
CREATE VIEW compared(age) AS SELECT value FROM json_each('[40,50,60,70,80,90,100,110,120,130,140]');
CREATE VIEW plots AS
  SELECT sites.rowid AS number, site, words, species_names.code, latin_name, thinning_intercept, thinning_slope, elevation_m, fertility,
    "stands.number" AS stand, starts.age_years AS start
  FROM sites JOIN species_names USING (species) JOIN places USING (site)
  JOIN soils ON soils.code = "soil.type" JOIN starts ON starts.stand = "stands.number";
CREATE VIEW table_ages AS
  SELECT plots.*, age, age - start AS year, yield_tables."table", class, mean_height_m, stems_pha, basal_area_m2pha, mean_dbh_cm, volume_m3pha
  FROM plots JOIN yield_tables USING (stand) JOIN compared ON age = age_years WHERE age > start;
CREATE VIEW ages AS
  SELECT number, site, words, age, year FROM table_ages
  UNION ALL SELECT number, site, words, age, age - start FROM plots, compared
  WHERE stand NOT IN (SELECT stand FROM yield_tables);
-- The stand itself: its species, and of single trees those of its age, not what came up below them. Thinned as the table where there is
-- one, and left alone.
CREATE VIEW own AS
  SELECT stands.*, regime = 'none' AS is_alone, regime <> 'none' OR stand_number NOT IN (SELECT stand FROM yield_tables) AS is_thinned
  FROM stands JOIN (SELECT site, stand AS stand_number FROM plots) USING (site) JOIN sites USING (site, species) WHERE stand = 'all';
CREATE VIEW own_trees AS
  SELECT trees.*, regime = 'none' AS is_alone, regime <> 'none' OR plots.stand NOT IN (SELECT stand FROM yield_tables) AS is_thinned
  FROM trees JOIN plots USING (site) WHERE trees.age_years > start + year - 1;
CREATE VIEW densities AS
  SELECT site, year, dbh_cm, stems_pha / exp(thinning_intercept + thinning_slope * ln(dbh_cm)) AS density
  FROM (SELECT site, year, stems_from_7cm_pha AS stems_pha, sqrt(basal_area_from_7cm_m2pha / stems_from_7cm_pha * 40000 / pi()) AS dbh_cm
        FROM own WHERE is_alone AND year > 0 AND stems_from_7cm_pha > 0)
  JOIN plots USING (site);

-- figure volume_m3pha:{site}:{age} | ages | volume, {words}, age {age} | m3/ha
SELECT volume_m3pha FROM own WHERE is_thinned AND site = :site AND year = :year;
-- figure dbh_cm:{site}:{age} | ages | mean DBH, {words}, age {age} | cm
SELECT sqrt(sum(stems * dbh_cm * dbh_cm) / sum(stems)) FROM own_trees WHERE is_thinned AND site = :site AND year = :year;
-- Of stems near the mean diameter.
-- figure height_m:{site}:{age} | ages | mean height, {words}, age {age} | m
SELECT sum(stems * height_m) / sum(stems) FROM own_trees, figures
WHERE is_thinned AND site = :site AND year = :year AND figure = 'dbh_cm:' || :site || ':' || :age AND abs(dbh_cm - value) <= 0.1 * value;
-- figure stems_pha:{site}:{age} | ages | stems, {words}, age {age} | 1/ha
SELECT sum(stems) / area_ha FROM own_trees JOIN places USING (site) WHERE is_thinned AND site = :site AND year = :year;
-- figure volume_ratio:{site}:{age} | table_ages | volume / table, {words}, age {age} | -
SELECT value / :volume_m3pha FROM figures WHERE figure = 'volume_m3pha:' || :site || ':' || :age;
-- figure dbh_ratio:{site}:{age} | table_ages | mean DBH / table, {words}, age {age} | -
SELECT value / :mean_dbh_cm FROM figures WHERE figure = 'dbh_cm:' || :site || ':' || :age;
-- figure height_ratio:{site}:{age} | table_ages | mean height / table, {words}, age {age} | -
SELECT value / :mean_height_m FROM figures WHERE figure = 'height_m:' || :site || ':' || :age;
-- figure stems_ratio:{site}:{age} | table_ages | stems / table, {words}, age {age} | -
SELECT value / :stems_pha FROM figures WHERE figure = 'stems_pha:' || :site || ':' || :age;
-- figure twin_volume_m3pha:{site}:{age} | ages | volume, left alone, {words}, age {age} | m3/ha
SELECT volume_m3pha FROM own WHERE is_alone AND site = :site AND year = :year;
-- figure twin_stems_pha:{site}:{age} | ages | stems, left alone, {words}, age {age} | 1/ha
SELECT sum(stems) / area_ha FROM own_trees JOIN places USING (site) WHERE is_alone AND site = :site AND year = :year;
-- figure twin_stems_ratio:{site}:{age} | table_ages | stems, left alone / stems of the thinned table, {words}, age {age} | -
SELECT value / :stems_pha FROM figures WHERE figure = 'twin_stems_pha:' || :site || ':' || :age;
-- figure least_stems_ratio:{site} | plots | least stems / table at all ages, {words} | -
SELECT min(value) FROM figures WHERE figure LIKE 'stems_ratio:' || :site || ':%';
-- figure least_twin_stems_ratio:{site} | plots | least stems, left alone / stems of the thinned table at all ages, {words} | -
SELECT min(value) FROM figures WHERE figure LIKE 'twin_stems_ratio:' || :site || ':%';
-- Standard height curves (Sloboda et al. 1993) give the 100 thickest 1.05 to 1.11 times the height of the mean tree.
-- figure top_height_ratio:{site}:{age} | table_ages | top height / table, left alone, {words}, age {age} | -
SELECT dominant_height_m / (1.08 * :mean_height_m) FROM own WHERE is_alone AND site = :site AND year = :year;
-- figure slenderness:{site}:{age} | ages | slenderness of the 100 thickest, left alone, {words}, age {age} | m/m
SELECT 100 * avg(height_m) / avg(dbh_cm) FROM
  (SELECT height_m, dbh_cm FROM own_trees WHERE is_alone AND site = :site AND year = :year ORDER BY dbh_cm DESC
   LIMIT (SELECT CAST(round(100 * area_ha) AS INTEGER) FROM places WHERE site = :site));
-- figure greatest_density:{site} | plots | most stems / self-thinning line, {words} | -
SELECT max(density) FROM densities WHERE site = :site AND year <= (SELECT max(year) FROM ages WHERE site = :site);
-- figure density_at_25cm:{site} | plots | stems / self-thinning line at a mean DBH of 25 cm, {words} | -
SELECT density FROM densities WHERE site = :site AND dbh_cm >= 25 ORDER BY year LIMIT 1;

-- Shares of rows that agree, of each species and of all.
CREATE VIEW agreements AS
  SELECT code, age, value BETWEEN 0.85 AND 1.15 AS agrees FROM table_ages JOIN figures
  ON figure IN ('volume_ratio:' || site || ':' || age, 'dbh_ratio:' || site || ':' || age, 'height_ratio:' || site || ':' || age);
CREATE VIEW age_parts(part, part_words, low, high) AS
  VALUES ('to_100', 'ages up to 100', 0, 100), ('beyond_100', 'ages above 100', 101, 10000), ('all', 'all ages', 0, 10000);
CREATE VIEW shares AS
  SELECT 'all' AS who, 'volume, DBH and height within 15 % of the table, all species' AS who_words, '%' AS pattern, age_parts.* FROM age_parts
  UNION ALL SELECT DISTINCT code, 'the same, ' || latin_name, code, age_parts.* FROM table_ages JOIN age_parts ON age BETWEEN low AND high;
-- figure share_within:{who}:{part} | shares | {who_words}, {part_words} | -
SELECT avg(agrees) FROM agreements WHERE code LIKE :pattern AND age BETWEEN CAST(:low AS REAL) AND CAST(:high AS REAL);

-- The page.
CREATE VIEW rows_of_page AS
  SELECT table_ages.*, (SELECT value FROM figures WHERE figure = 'volume_m3pha:' || site || ':' || age) AS own_volume,
    (SELECT value FROM figures WHERE figure = 'dbh_cm:' || site || ':' || age) AS own_dbh,
    (SELECT value FROM figures WHERE figure = 'height_m:' || site || ':' || age) AS own_height,
    (SELECT value FROM figures WHERE figure = 'stems_pha:' || site || ':' || age) AS own_stems
  FROM table_ages;
CREATE VIEW kinds(kind, style) AS VALUES ('Bannwald, thinned as the table', 'line'), ('table, class of the site', 'dots');
-- lines Volume over age, by elevation
SELECT latin_name, kind, style, CASE style WHEN 'line' THEN elevation_m || ' m' ELSE '' END, age AS "Age, years", CASE style WHEN 'line' THEN own_volume ELSE volume_m3pha END AS "Volume, m3/ha"
FROM rows_of_page, kinds ORDER BY (SELECT min(number) FROM plots WHERE plots.latin_name = rows_of_page.latin_name), number, style DESC, age;
-- lines Mean diameter over age, by elevation
SELECT latin_name, kind, style, CASE style WHEN 'line' THEN elevation_m || ' m' ELSE '' END, age AS "Age, years", CASE style WHEN 'line' THEN own_dbh ELSE mean_dbh_cm END AS "Mean DBH, cm"
FROM rows_of_page, kinds ORDER BY (SELECT min(number) FROM plots WHERE plots.latin_name = rows_of_page.latin_name), number, style DESC, age;
-- lines Mean height over age, by elevation
SELECT latin_name, kind, style, CASE style WHEN 'line' THEN elevation_m || ' m' ELSE '' END, age AS "Age, years", CASE style WHEN 'line' THEN own_height ELSE mean_height_m END AS "Mean height, m"
FROM rows_of_page, kinds ORDER BY (SELECT min(number) FROM plots WHERE plots.latin_name = rows_of_page.latin_name), number, style DESC, age;
-- table Simulated / table at 70 and 100 years, thinned to the stems of the table
SELECT words AS site, fertility, class, age AS "age, years", printf('%.0f / %.0f', own_stems, stems_pha) AS "stems, 1/ha",
  printf('%.1f / %.1f', own_dbh, mean_dbh_cm) AS "mean DBH, cm", printf('%.1f / %.1f', own_height, mean_height_m) AS "mean height, m",
  printf('%.1f / %.1f', own_stems * pi() * own_dbh * own_dbh / 40000, stems_pha * pi() * mean_dbh_cm * mean_dbh_cm / 40000) AS "basal area, m2/ha",
  printf('%.0f / %.0f', own_volume, volume_m3pha) AS "volume, m3/ha"
FROM rows_of_page WHERE age IN (70, 100) ORDER BY number, age;
-- table Stands left alone, at 100 years or the last age of their table. The self-thinning line is an input of the model: stems beside it show that it is kept, not that it is right
SELECT words AS site, fertility, age AS "age, years",
  (SELECT printf('%.0f', value) FROM figures WHERE figure = 'twin_stems_pha:' || site || ':' || age) AS "stems, 1/ha",
  (SELECT printf('%.0f', value) FROM figures WHERE figure = 'twin_volume_m3pha:' || site || ':' || age) AS "volume, m3/ha",
  (SELECT printf('%.0f', value) FROM figures WHERE figure = 'slenderness:' || site || ':' || age) AS "slenderness of the 100 thickest, m/m",
  (SELECT printf('%.2f', value) FROM figures WHERE figure = 'top_height_ratio:' || site || ':' || age) AS "top height / table",
  (SELECT printf('%.2f', value) FROM figures WHERE figure = 'greatest_density:' || site) AS "most stems / line [input]",
  (SELECT coalesce(printf('%.2f', value), 'not reached') FROM figures WHERE figure = 'density_at_25cm:' || site) AS "stems / line at 25 cm [input]"
FROM (SELECT site, words, number, max(age) AS age FROM ages WHERE age <= 100 GROUP BY number) JOIN plots USING (number, site, words)
ORDER BY number;
