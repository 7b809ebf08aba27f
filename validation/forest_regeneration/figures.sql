-- Young trees of the gap from 0.2 m on, years after its storm (year 1).
CREATE VIEW young AS
  SELECT site, year - 1 AS age, species, avg(stems_pha + saplings_from_20cm_pha) AS young_pha,
    avg(stems_pha) AS trees_pha, avg(dominant_height_m) AS tallest_m
  FROM stands WHERE stand = '1' GROUP BY site, year, species;
CREATE VIEW all_young AS SELECT * FROM young WHERE species = 'all';
CREATE VIEW cut_gaps AS
  SELECT sites.site, words, value AS age FROM sites, json_each('[5,10,20]')
  WHERE sites.site LIKE 'low%' OR sites.site LIKE 'high%' OR sites.site LIKE 'cut%';
CREATE VIEW gap_sites AS SELECT DISTINCT site, words FROM cut_gaps;
CREATE VIEW pairs AS
  SELECT column1 AS pair, column2 AS more, column3 AS less, column4 AS at, column5 AS words FROM
  (VALUES ('low', 'low_cleared', 'low_left', 10, 'cleared / left at 860 m after 10 years'),
    ('high', 'high_cleared', 'high_left', 20, 'cleared / left at 1428 m after 20 years'));
CREATE VIEW fir_pairs AS
  SELECT column1 AS pair, column2 AS more, column3 AS less, column4 AS words FROM
  (VALUES ('fence', 'cut_fenced', 'low_cleared', 'fenced / not fenced'),
    ('planting', 'cut_planted', 'low_cleared', 'planted / not planted'),
    ('fence_of_planted', 'cut_both', 'cut_planted', 'planted in a fence / planted'));
CREATE VIEW uneven_sites AS SELECT site, words FROM sites WHERE site IN ('fir_beech', 'mixed');
CREATE VIEW aged AS
  SELECT uneven_sites.*, code, species_names.species, latin_name FROM uneven_sites, species_names
  WHERE code IN ('piab', 'abal');
CREATE VIEW deer AS
  SELECT code, species_names.species, latin_name FROM species_names
  WHERE code IN ('abal', 'qupe', 'acps', 'soau', 'piab', 'fasy');
CREATE VIEW one AS SELECT 'old_spruce' AS site;

-- figure young_pha:{site}:{age} | cut_gaps | young trees after {age} years, {words} | 1/ha
SELECT young_pha FROM all_young WHERE site = :site AND age = :age + 0;
-- figure tallest_m:{site}:{age} | cut_gaps | the 100 thickest after {age} years, {words} | m
SELECT tallest_m FROM all_young WHERE site = :site AND age = :age + 0;
-- figure order:{pair} | pairs | young trees, {words} | -
SELECT (SELECT young_pha FROM all_young WHERE site = :more AND age = :at + 0) /
  (SELECT young_pha FROM all_young WHERE site = :less AND age = :at + 0);
-- figure planting_adds_m | one | what planting adds to the height of the 100 thickest at 1428 m after 20 years | m
SELECT (SELECT tallest_m FROM all_young WHERE site = 'high_planted' AND age = 20) -
  (SELECT tallest_m FROM all_young WHERE site = 'high_cleared' AND age = 20);
-- figure firs:{pair} | fir_pairs | firs of 2 m and more after 30 years, {words} | -
SELECT (SELECT trees_pha FROM young WHERE site = :more AND age = 30 AND species = 'ABAL') /
  (SELECT trees_pha FROM young WHERE site = :less AND age = 30 AND species = 'ABAL');
-- figure firs_pha:{site} | gap_sites | firs of 2 m and more 20 years after the storm, {words} | 1/ha
SELECT coalesce((SELECT trees_pha FROM young WHERE site = :site AND age = 20 AND species = 'ABAL'), 0);
-- figure trees_pha:{site} | gap_sites | trees of 2 m and more 20 years after the storm, {words} | 1/ha
SELECT trees_pha FROM all_young WHERE site = :site AND age = 20;
-- figure recruits_pha:{site} | uneven_sites | trees that pass 10 cm in a year under {words} | 1/ha
SELECT count(*) / 20.0 / (SELECT area_ha FROM places WHERE site = :site) /
  (SELECT count(DISTINCT replicate) FROM stands WHERE site = :site)
FROM trees WHERE site = :site AND year = 80 AND dbh_cm >= 10 AND replicate || ' ' || tree_id NOT IN
  (SELECT replicate || ' ' || tree_id FROM trees WHERE site = :site AND year = 60 AND dbh_cm >= 10);
-- figure age_at_12cm:{code}:{site} | aged | age of {latin_name} at 12 cm under {words} | yr
SELECT avg(age_years) FROM trees
WHERE site = :site AND species = :species AND year = 80 AND dbh_cm BETWEEN 11 AND 13 AND
  replicate || ' ' || tree_id NOT IN
  (SELECT replicate || ' ' || tree_id FROM trees WHERE site = :site AND year = 0);
-- figure on_wood | one | saplings on rotten wood in the old spruce forest | %
SELECT 100 * sum(saplings_on_wood_pha) / sum(saplings_pha) FROM stands
WHERE site = :site AND stand = 'all' AND species = 'all' AND year > 30;
-- figure browsed:{code} | deer | leading shoots of {latin_name} browsed in a year | %
SELECT 100 * sum(saplings_browsed_pha) / sum(saplings_in_reach_pha) FROM stands
WHERE stand = 'all' AND species = :species AND year > 5;
