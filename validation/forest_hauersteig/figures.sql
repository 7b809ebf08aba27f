-- Trees measured twice. The plot has one site; classes of diameter at the first measurement by their lower ends.
CREATE VIEW classes(size, low, high, size_words) AS VALUES ('all', 0, 10000, ''), ('10cm', 10, 15, ' of 10 to 15 cm'),
  ('15cm', 15, 20, ' of 15 to 20 cm'), ('20cm', 20, 25, ' of 20 to 25 cm'), ('25cm', 25, 10000, ' from 25 cm on');
CREATE VIEW plot AS SELECT area_ha, least_dbh_cm, ingrowth = 'yes' AS ingrowth, last_year AS years FROM sites JOIN places USING (site), asked;

-- What no plot can have.
CREATE VIEW both AS
  SELECT last.line, first.tree_id, first.species, last.species AS last_species, first.dbh_cm, last.dbh_cm AS last_cm,
    (last.dbh_cm - first.dbh_cm) / (SELECT years FROM plot) AS growth_cm
  FROM measured_first AS first JOIN measured_last AS last USING (tree_id);
CREATE VIEW new_trees AS SELECT * FROM measured_last WHERE tree_id NOT IN (SELECT tree_id FROM measured_first);
-- error measured_first.csv | tree {tree_id} with dbh_cm {dbh_cm} | least_dbh_cm of sites.csv or more; leave the tree out of both tables: thinner trees were not all counted
SELECT line, tree_id, dbh_cm FROM measured_first, plot WHERE dbh_cm < least_dbh_cm;
-- error measured_last.csv | tree {tree_id} without a dbh_cm | living trees alone; leave the row out if the tree is dead or was felled
SELECT line, tree_id FROM measured_last WHERE NOT coalesce(dbh_cm > 0, 0) OR typeof(dbh_cm) = 'text';
-- error measured_last.csv | tree {tree_id} a second time | one row for each tree
SELECT max(line) AS line, tree_id FROM measured_last GROUP BY tree_id HAVING count(*) > 1;
-- error measured_last.csv | tree {tree_id} as {last_species} | the species of the first measurement, {species}
SELECT * FROM both WHERE last_species <> species;
-- error measured_last.csv | tree {tree_id} with dbh_cm {last_cm}, {dbh_cm} cm before | no tree thinner by more than a fifth; correct the number or the diameter, or leave the tree out of both tables
SELECT * FROM both WHERE last_cm < 0.8 * dbh_cm;
-- error measured_last.csv | mean diameter growth of {growth} cm a year | 3 cm a year or less; write dbh_cm in cm in both tables, and check run.years
SELECT NULL AS line, round(avg(growth_cm)) AS growth FROM both HAVING avg(growth_cm) > 3;
-- error measured_last.csv | no tree_id of the first measurement, and new trees that are too thick for ingrowth | the same tree_id for a tree in both tables
SELECT NULL AS line FROM new_trees, plot WHERE dbh_cm > least_dbh_cm + years AND NOT EXISTS (SELECT 1 FROM both) LIMIT 1;
-- error measured_last.csv | tree {tree_id}, which the first measurement has not | trees of measured_first.csv, or ingrowth = yes in sites.csv
SELECT line, tree_id FROM new_trees, plot WHERE NOT ingrowth;
-- error felled.csv | tree_id {tree_id} felled, but measured at the end | trees that are not in measured_last.csv
SELECT felled.line, tree_id FROM felled JOIN measured_last USING (tree_id);
-- warning measured_last.csv | more than 3 cm of diameter growth a year; correct tree_id or dbh_cm, or leave the tree out of both tables
SELECT line FROM both WHERE growth_cm > 3;
-- warning measured_last.csv | a diameter that shrinks by more than 0.5 cm, the error of a tape; correct tree_id or dbh_cm, or leave the tree out of both tables
SELECT line FROM both WHERE last_cm < dbh_cm - 0.5;
-- warning measured_last.csv | counted as ingrowth, but thicker than least_dbh_cm and 1 cm a year; correct tree_id if the tree was measured before, or add it to measured_first.csv if it was overlooked
SELECT line FROM new_trees, plot WHERE dbh_cm > least_dbh_cm + years;

-- Trees of the first measurement but for those felled: observed, and in the replicates in which they stand.
CREATE VIEW plot_runs AS SELECT max(replicate) AS replicates FROM trees;
CREATE VIEW ends AS
  SELECT tree_id, avg(dbh_cm) AS own_cm, count(*) AS standing FROM trees, asked WHERE year = last_year GROUP BY tree_id;
CREATE VIEW fates AS
  SELECT first.tree_id, first.species, first.dbh_cm, last.dbh_cm AS last_cm, own_cm,
    coalesce(standing, 0) * 1.0 / (SELECT replicates FROM plot_runs) AS survival
  FROM measured_first AS first LEFT JOIN measured_last AS last USING (tree_id) LEFT JOIN ends USING (tree_id)
  WHERE first.tree_id NOT IN (SELECT tree_id FROM felled);
CREATE VIEW who(number, species, code, who_words) AS
  SELECT 0, '%', 'all', 'all species'
  UNION ALL SELECT rowid, species, code, latin_name FROM species_names
  WHERE species IN (SELECT species FROM measured_first UNION SELECT species FROM measured_last);
CREATE VIEW tree_groups AS
  SELECT who.*, classes.*, count(*) AS number_of_trees, count(last_cm) AS survivors, count(last_cm) * 1.0 / count(*) AS observed_survival,
    avg(last_cm - dbh_cm) / (SELECT years FROM plot) AS observed_cm
  FROM who JOIN classes JOIN fates ON fates.species LIKE who.species AND dbh_cm >= low AND dbh_cm < high
  GROUP BY who.code, size ORDER BY who.number, low, high DESC;
CREATE VIEW grown_groups AS SELECT * FROM tree_groups WHERE survivors > 0;

-- figure survivors:{code}:{size} | tree_groups | share of trees that survive, {who_words}{size_words} | - | {observed_survival}
SELECT avg(survival) FROM fates WHERE species LIKE :species AND dbh_cm >= :low AND dbh_cm < :high;
-- figure survivors_difference:{code}:{size} | tree_groups | share of survivors - observed, {who_words}{size_words} | -
SELECT avg(survival) - :observed_survival FROM fates WHERE species LIKE :species AND dbh_cm >= :low AND dbh_cm < :high;
-- figure increment_cm:{code}:{size} | grown_groups | diameter growth a year, {who_words}{size_words} | cm | {observed_cm}
SELECT avg(own_cm - dbh_cm) / (SELECT years FROM plot) FROM fates
WHERE species LIKE :species AND dbh_cm >= :low AND dbh_cm < :high AND last_cm > 0 AND survival > 0;
-- figure increment_ratio:{code}:{size} | grown_groups | diameter growth / observed, {who_words}{size_words} | -
SELECT value / nullif(:observed_cm, 0) FROM figures WHERE figure = 'increment_cm:' || :code || ':' || :size;
-- figure dbh_bias_cm:{code}:{size} | grown_groups | diameters at the end - observed, mean, {who_words}{size_words} | cm
SELECT avg(own_cm - last_cm) FROM fates
WHERE species LIKE :species AND dbh_cm >= :low AND dbh_cm < :high AND last_cm > 0 AND survival > 0;
-- figure dbh_rmse_cm:{code}:{size} | grown_groups | diameters at the end, RMSE, {who_words}{size_words} | cm
SELECT sqrt(avg((own_cm - last_cm) * (own_cm - last_cm))) FROM fates
WHERE species LIKE :species AND dbh_cm >= :low AND dbh_cm < :high AND last_cm > 0 AND survival > 0;

-- How differently trees of one species and size grow: in each replicate, over trees that lived in the plot to the end.
CREATE VIEW own_growths AS
  SELECT replicate, first.species, first.dbh_cm AS first_cm, trees.dbh_cm - first.dbh_cm AS growth_cm
  FROM trees JOIN asked ON year = last_year JOIN measured_first AS first USING (tree_id)
  WHERE tree_id IN (SELECT tree_id FROM measured_last);
CREATE VIEW spread_groups AS
  SELECT grown_groups.*, (SELECT sqrt(sum((last_cm - dbh_cm - mean) * (last_cm - dbh_cm - mean)) / (survivors - 1))
      FROM fates, (SELECT observed_cm * (SELECT years FROM plot) AS mean)
      WHERE fates.species LIKE grown_groups.species AND dbh_cm >= low AND dbh_cm < high AND last_cm > 0) AS observed_spread_cm
  FROM grown_groups WHERE survivors >= 10;
-- figure growth_spread_cm:{code}:{size} | spread_groups | standard deviation of growth between trees, {who_words}{size_words} | cm | {observed_spread_cm}
SELECT avg(deviation) FROM (
  SELECT sqrt((sum(growth_cm * growth_cm) - sum(growth_cm) * sum(growth_cm) / count(*)) / (count(*) - 1)) AS deviation FROM own_growths
  WHERE species LIKE :species AND first_cm >= :low AND first_cm < :high GROUP BY replicate HAVING count(*) > 1);
-- figure growth_spread_ratio:{code}:{size} | spread_groups | standard deviation of growth between trees / observed, {who_words}{size_words} | -
SELECT value / nullif(:observed_spread_cm, 0) FROM figures WHERE figure = 'growth_spread_cm:' || :code || ':' || :size;

-- The stand at the end: trees from least_dbh_cm on, without those that grew in where nobody counted them.
CREATE VIEW last_trees AS
  SELECT measured_last.*, tree_id NOT IN (SELECT tree_id FROM measured_first) AS is_new FROM measured_last, plot WHERE dbh_cm >= least_dbh_cm;
CREATE VIEW own_last_trees AS
  SELECT trees.*, tree_id NOT IN (SELECT tree_id FROM measured_first) AS is_new
  FROM trees, asked, plot WHERE year = last_year AND dbh_cm >= least_dbh_cm
    AND (ingrowth OR tree_id IN (SELECT tree_id FROM measured_first));
CREATE VIEW thickest AS
  SELECT avg(dbh_cm) AS cm FROM (SELECT dbh_cm FROM last_trees ORDER BY dbh_cm DESC LIMIT (SELECT CAST(round(100 * area_ha) AS INTEGER) FROM plot));
CREATE VIEW stand_ends AS
  SELECT who.*, (SELECT count(*) / area_ha FROM last_trees WHERE species LIKE who.species) AS observed_pha,
    (SELECT coalesce(sum(pi() * dbh_cm * dbh_cm / 40000), 0) / area_ha FROM last_trees WHERE species LIKE who.species) AS observed_m2pha,
    (SELECT coalesce(sum(is_new), 0) / area_ha FROM last_trees WHERE species LIKE who.species) AS observed_new_pha
  FROM who, plot;
-- figure stems_pha:{code} | stand_ends | stems at the end, {who_words} | 1/ha | {observed_pha}
SELECT coalesce(sum(stems), 0) / area_ha / (SELECT replicates FROM plot_runs) FROM plot LEFT JOIN own_last_trees ON species LIKE :species;
-- figure stems_ratio:{code} | stand_ends | stems at the end / observed, {who_words} | -
SELECT value / nullif(:observed_pha, 0) FROM figures WHERE figure = 'stems_pha:' || :code;
-- figure basal_area_m2pha:{code} | stand_ends | basal area at the end, {who_words} | m2/ha | {observed_m2pha}
SELECT coalesce(sum(stems * pi() * dbh_cm * dbh_cm / 40000), 0) / area_ha / (SELECT replicates FROM plot_runs)
FROM plot LEFT JOIN own_last_trees ON species LIKE :species;
-- figure basal_area_ratio:{code} | stand_ends | basal area at the end / observed, {who_words} | -
SELECT value / nullif(:observed_m2pha, 0) FROM figures WHERE figure = 'basal_area_m2pha:' || :code;
CREATE VIEW counted_ends AS SELECT stand_ends.* FROM stand_ends, plot WHERE ingrowth;
-- figure ingrowth_pha:{code} | counted_ends | ingrowth, {who_words} | 1/ha | {observed_new_pha}
SELECT coalesce(sum(stems * is_new), 0) / area_ha / (SELECT replicates FROM plot_runs) FROM plot LEFT JOIN own_last_trees ON species LIKE :species;
-- figure ingrowth_difference_pha:{code} | counted_ends | ingrowth - observed, {who_words} | 1/ha
SELECT value - :observed_new_pha FROM figures WHERE figure = 'ingrowth_pha:' || :code;
-- figure thickest_dbh_cm:all | thickest | mean diameter of the 100 thickest a hectare | cm | {cm}
SELECT avg(dbh_cm) FROM (SELECT dbh_cm, row_number() OVER (PARTITION BY replicate ORDER BY dbh_cm DESC) AS rank FROM own_last_trees), plot
WHERE rank <= round(100 * area_ha);
-- figure thickest_dbh_ratio:all | thickest | mean diameter of the 100 thickest a hectare / observed | -
SELECT value / :cm FROM figures WHERE figure = 'thickest_dbh_cm:all';

-- The page.
CREATE VIEW growths AS
  SELECT latin_name, (last_cm - dbh_cm) / years AS observed, (own_cm - dbh_cm) / years AS own
  FROM fates JOIN species_names USING (species), plot WHERE last_cm > 0 AND survival > 0;
-- lines Diameter growth of each survivor, mean of the replicates in which it stands
SELECT latin_name, name, style, '', x AS "Observed, cm a year", y AS "Bannwald, cm a year" FROM
  (SELECT latin_name, 'equal' AS name, 'equal' AS style, 0.0 AS x, 0.0 AS y, 1 AS place FROM growths GROUP BY latin_name
   UNION ALL SELECT latin_name, 'equal', 'equal', max(max(observed), max(own)), max(max(observed), max(own)), 2 FROM growths GROUP BY latin_name
   UNION ALL SELECT latin_name, 'a tree', 'trees', observed, own, 3 FROM growths)
ORDER BY latin_name, place;
CREATE VIEW named AS SELECT figure, value FROM figures WHERE value IS NOT NULL;
-- table Trees of the first measurement: simulated / observed; felled ones left out
SELECT who_words || size_words AS trees, number_of_trees AS "number",
  (SELECT printf('%.0f / %.0f', 100 * value, 100 * observed_survival) FROM named WHERE figure = 'survivors:' || code || ':' || size) AS "survivors, %",
  (SELECT printf('%.3f / %.3f', value, observed_cm) FROM named WHERE figure = 'increment_cm:' || code || ':' || size) AS "growth of survivors, cm a year",
  (SELECT printf('%.2f', value) FROM named WHERE figure = 'dbh_bias_cm:' || code || ':' || size) AS "diameters at the end, bias, cm",
  (SELECT printf('%.2f', value) FROM named WHERE figure = 'dbh_rmse_cm:' || code || ':' || size) AS "RMSE, cm"
FROM tree_groups;
-- table The stand at the end: simulated / observed
SELECT who_words AS species,
  (SELECT printf('%.0f / %.0f', value, observed_pha) FROM named WHERE figure = 'stems_pha:' || code) AS "stems, 1/ha",
  (SELECT printf('%.1f / %.1f', value, observed_m2pha) FROM named WHERE figure = 'basal_area_m2pha:' || code) AS "basal area, m2/ha",
  (SELECT printf('%.0f / %.0f', value, observed_new_pha) FROM named WHERE figure = 'ingrowth_pha:' || code) AS "ingrowth, 1/ha"
FROM stand_ends;
