-- What every case over years can be judged by. Views first; sites.csv and expected.csv are of the case.

CREATE VIEW judged AS
  SELECT stands.* FROM stands, asked WHERE stand = 'all' AND year >= from_year;
CREATE VIEW judged_years AS
  SELECT forest_years.*, snags_m3pha + logs_m3pha AS dead_wood_m3pha
  FROM forest_years, asked WHERE year >= from_year;
CREATE VIEW judged_losses AS
  SELECT mortality.* FROM mortality, asked WHERE year >= from_year;
CREATE VIEW judged_deaths AS
  SELECT removed_trees.* FROM removed_trees, asked WHERE year >= from_year;
CREATE VIEW judged_classes AS
  SELECT dbh_classes.* FROM dbh_classes, asked WHERE species = 'all' AND year >= from_year;
-- Sums over years and replicates; shares are ratios of them.
CREATE VIEW biomass AS
  SELECT site, species, sum(above_ground_tpha) AS tpha FROM judged GROUP BY site, species;
CREATE VIEW replicate_biomass AS
  SELECT site, replicate, species, sum(above_ground_tpha) AS tpha FROM judged
  GROUP BY site, replicate, species;
CREATE VIEW states AS
  SELECT site, count(*) AS states, sum(above_ground_tpha) AS all_tpha FROM judged WHERE species = 'all'
  GROUP BY site;
CREATE VIEW species_biomass AS
  SELECT sites.rowid AS number, site, words, elevation_m, changed, latin_name, tpha / states AS tpha, all_tpha / states AS all_tpha,
    100.0 * tpha / all_tpha AS percent
  FROM sites JOIN places USING (site) JOIN states USING (site) JOIN biomass USING (site)
  JOIN species_names USING (species);
-- Sites of the same elevation make one place of a chart over elevation: their mean.
CREATE VIEW elevations AS
  SELECT elevation_m, count(*) AS places_there FROM places WHERE NOT changed GROUP BY elevation_m;
CREATE VIEW grouped AS
  SELECT expected.*, words, replace("group", '_', ' and ') AS group_words
  FROM sites JOIN expected USING (site) ORDER BY sites.rowid, expected.rowid;
-- Figures that are known, as numbers and as texts: printf would make 0 of NULL.
CREATE VIEW site_figures AS
  SELECT site, words, sites.rowid AS number, substr(figure, 1, length(figure) - length(site) - 1) AS name, value,
    printf('%.0f', value) AS whole, printf('%.1f', value) AS tenths, printf('%.2f', value) AS hundredths,
    printf('%.2f', 100 * value) AS percent
  FROM sites JOIN figures ON substr(figure, -length(site) - 1) = ':' || site
  WHERE value IS NOT NULL;
CREATE VIEW decay_classes AS SELECT sites.site, words, value AS class FROM sites, json_each('[1,2,3,4,5]');
CREATE VIEW sizes AS
  SELECT sites.site, words, area_ha, all_deaths, json_extract(value, '$[0]') AS low,
    json_extract(value, '$[1]') AS high
  FROM sites JOIN places USING (site), json_each('[[12,20],[20,40],[40,60],[60,1000]]');

-- figure biomass_tpha:{site} | sites | biomass above ground at {words} | t/ha
SELECT avg(above_ground_tpha) FROM judged WHERE site = :site AND species = 'all';
-- figure volume_m3pha:{site} | sites | stem wood at {words} | m3/ha
SELECT avg(volume_m3pha) FROM judged WHERE site = :site AND species = 'all';
-- figure basal_area_m2pha:{site} | sites | basal area at {words} | m2/ha
SELECT avg(basal_area_m2pha) FROM judged WHERE site = :site AND species = 'all';
-- figure top_height_m:{site} | sites | height of the 100 thickest at {words} | m
SELECT avg(dominant_height_m) FROM judged WHERE site = :site AND species = 'all';
-- figure drought_index:{site} | sites | drought index at {words} | -
SELECT avg(drought_index) FROM judged WHERE site = :site AND species = 'all';
-- figure stems_60cm_pha:{site} | sites | stems above 60 cm at {words} | 1/ha
SELECT coalesce(sum(stems_pha), 0) / (SELECT count(*) FROM judged WHERE site = :site AND species = 'all')
FROM judged_classes WHERE site = :site AND dbh_from_cm >= 60;
-- figure dead_wood_m3pha:{site} | sites | dead wood at {words} | m3/ha
SELECT avg(dead_wood_m3pha) FROM judged_years WHERE site = :site;
-- figure dead_wood_class{class}_m3pha:{site} | decay_classes | dead wood of class {class} at {words} | m3/ha
SELECT avg(CASE :class WHEN '1' THEN dead_wood_class1_m3pha WHEN '2' THEN dead_wood_class2_m3pha
  WHEN '3' THEN dead_wood_class3_m3pha WHEN '4' THEN dead_wood_class4_m3pha
  ELSE dead_wood_class5_m3pha END) FROM judged_years WHERE site = :site;
-- figure lost_to_wind_m3pha:{site} | sites | stem wood thrown by storms a year at {words} | m3/ha
SELECT coalesce(sum(volume_m3pha), 0) / (SELECT count(*) FROM judged_years WHERE site = :site)
FROM judged_losses WHERE site = :site AND cause = 'wind';
-- figure lost_to_snow_m3pha:{site} | sites | stem wood broken by wet snow a year at {words} | m3/ha
SELECT coalesce(sum(volume_m3pha), 0) / (SELECT count(*) FROM judged_years WHERE site = :site)
FROM judged_losses WHERE site = :site AND cause = 'snow';
-- figure lost_to_beetle_m3pha:{site} | sites | stem wood killed by bark beetles a year at {words} | m3/ha
SELECT coalesce(sum(volume_m3pha), 0) / (SELECT count(*) FROM judged_years WHERE site = :site)
FROM judged_losses WHERE site = :site AND cause = 'beetle';
-- removed_trees has all deaths with output.all_removed_trees alone.
-- figure death_rate_from_{low}cm:{site} | sizes | deaths a year from {low} cm on, in the class, {words} | -
SELECT (SELECT count(*) FROM judged_deaths WHERE site = :site AND dbh_cm >= :low AND dbh_cm < :high)
  / CAST(:area_ha AS REAL) / (SELECT count(*) FROM judged_years WHERE site = :site)
  / (SELECT sum(stems_pha) / (SELECT count(*) FROM judged WHERE site = :site AND species = 'all')
     FROM judged_classes WHERE site = :site AND dbh_from_cm >= :low AND dbh_from_cm < :high)
WHERE :all_deaths = '1';

-- A group's share of the biomass; above 0 its margin means that it leads.
-- figure share:{group}:{site} | grouped | share of {group_words} at {words} | -
SELECT coalesce(sum(tpha) / nullif((SELECT tpha FROM biomass WHERE site = :site AND species = 'all'), 0), 0)
FROM biomass WHERE site = :site AND instr(' ' || :species || ' ', ' ' || species || ' ') > 0;
-- figure margin:{group}:{site} | grouped | lead of {group_words} at {words} | -
SELECT coalesce((coalesce(sum(tpha) FILTER (WHERE instr(' ' || :species || ' ', ' ' || species || ' ') > 0), 0)
  - coalesce(max(tpha) FILTER (WHERE species <> 'all' AND instr(' ' || :species || ' ', ' ' || species || ' ') = 0), 0))
  / nullif(sum(tpha) FILTER (WHERE species = 'all'), 0), 0) FROM biomass WHERE site = :site;

-- The page.
-- stack Belts: means over the years {from_year} to {last_year} and all replicates, straight between the sites
SELECT 'Shares of the biomass', latin_name, elevation_m AS "Elevation, m",
  sum(percent) / places_there AS "Share of the biomass above ground, %"
FROM species_biomass JOIN elevations USING (elevation_m)
WHERE NOT changed AND (SELECT count(*) FROM elevations) > 1 GROUP BY latin_name, elevation_m;
-- stack Belts: means over the years {from_year} to {last_year} and all replicates, straight between the sites
SELECT 'Biomass', latin_name, elevation_m AS "Elevation, m", sum(tpha) / places_there AS "Biomass above ground, t/ha"
FROM species_biomass JOIN elevations USING (elevation_m)
WHERE NOT changed AND (SELECT count(*) FROM elevations) > 1 GROUP BY latin_name, elevation_m;
-- stack Succession, by site
SELECT words, latin_name, year AS "Years since the start", tpha AS "Biomass above ground, t/ha" FROM
  (SELECT site, species, year, sum(above_ground_tpha) / max(replicates) AS tpha
   FROM stands JOIN (SELECT site, max(replicate) AS replicates FROM stands GROUP BY site) USING (site)
   WHERE stand = 'all' GROUP BY site, species, year
   UNION ALL SELECT site, species, 0, 0.0 FROM sites, species_names)
JOIN sites USING (site) JOIN species_names USING (species) ORDER BY sites.rowid, year;

-- table Biomass above ground, t/ha, and its share in %: mean over the years {from_year} to {last_year}
SELECT words AS place, printf('%.0f', all_tpha) AS "all, t/ha",
  group_concat(latin_name || ' ' || printf('%.0f (%.0f)', tpha, percent), ', ') AS "species, t/ha (%)"
FROM (SELECT * FROM species_biomass WHERE percent >= 0.5 ORDER BY number, tpha DESC)
GROUP BY number ORDER BY number;
-- table Structure, and deaths in % of the trees of a diameter class a year
SELECT words AS place,
  max(whole) FILTER (WHERE name = 'volume_m3pha') AS "stem wood, m3/ha",
  max(tenths) FILTER (WHERE name = 'basal_area_m2pha') AS "basal area, m2/ha",
  max(whole) FILTER (WHERE name = 'stems_60cm_pha') AS "stems above 60 cm, 1/ha",
  max(tenths) FILTER (WHERE name = 'top_height_m') AS "top height, m",
  max(whole) FILTER (WHERE name = 'dead_wood_m3pha') AS "dead wood, m3/ha",
  max(hundredths) FILTER (WHERE name = 'drought_index') AS "drought index",
  max(percent) FILTER (WHERE name = 'death_rate_from_12cm') AS "deaths from 12 cm",
  max(percent) FILTER (WHERE name = 'death_rate_from_20cm') AS "from 20 cm",
  max(percent) FILTER (WHERE name = 'death_rate_from_40cm') AS "from 40 cm",
  max(percent) FILTER (WHERE name = 'death_rate_from_60cm') AS "from 60 cm"
FROM site_figures GROUP BY number ORDER BY number;
-- table Dead wood by decay class, 1 fresh to 5 falling to pieces
SELECT words AS place,
  max(whole) FILTER (WHERE name = 'dead_wood_m3pha') AS "all, m3/ha",
  max(whole) FILTER (WHERE name = 'dead_wood_class1_m3pha') AS "class 1",
  max(whole) FILTER (WHERE name = 'dead_wood_class2_m3pha') AS "class 2",
  max(whole) FILTER (WHERE name = 'dead_wood_class3_m3pha') AS "class 3",
  max(whole) FILTER (WHERE name = 'dead_wood_class4_m3pha') AS "class 4",
  max(whole) FILTER (WHERE name = 'dead_wood_class5_m3pha') AS "class 5"
FROM site_figures GROUP BY number ORDER BY number;
-- table What grows there by the literature, and what grew here
SELECT words AS place, group_words AS "group",
  (SELECT printf('%.2f', value) FROM figures WHERE figure = 'share:' || "group" || ':' || site)
    AS "share of the biomass [-]",
  (SELECT printf('%.2f to %.2f', min(share), max(share)) FROM
    (SELECT coalesce(sum(tpha) FILTER (WHERE instr(' ' || grouped.species || ' ', ' ' || r.species || ' ') > 0), 0)
       / nullif(sum(tpha) FILTER (WHERE r.species = 'all'), 0) AS share
     FROM replicate_biomass r WHERE r.site = grouped.site GROUP BY replicate)) AS "by replicate [-]",
  (SELECT printf('%.2f', value) FROM figures WHERE figure = 'margin:' || "group" || ':' || site)
    AS "lead over the greatest other species [-]",
  published || ' (' || source || ')' AS "the literature"
FROM grouped;
-- table Stem wood taken a year, m3/ha, mean over the years {from_year} to {last_year}
SELECT words AS place,
  max(hundredths) FILTER (WHERE name = 'lost_to_wind_m3pha') AS "storms",
  max(hundredths) FILTER (WHERE name = 'lost_to_snow_m3pha') AS "wet snow",
  max(hundredths) FILTER (WHERE name = 'lost_to_beetle_m3pha') AS "bark beetles"
FROM site_figures WHERE (SELECT sum(value) FROM figures WHERE figure LIKE 'lost_to_%') > 0
GROUP BY number ORDER BY number;
