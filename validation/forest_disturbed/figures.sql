-- Species that grow at a site by nature: in how many replicates trees of them are left at the end.
CREATE VIEW natives AS
  SELECT native.site, native.species, species_names.code, latin_name, words
  FROM native JOIN sites USING (site) JOIN species_names USING (species);

-- figure kept:{code}:{site} | natives | replicates with thick {latin_name} at {words} | -
SELECT count(DISTINCT replicate) FROM trees, asked
WHERE site = :site AND species = :species AND year = last_year AND dbh_cm >= 10;
-- figure alive:{code}:{site} | natives | replicates with {latin_name} at {words} | -
SELECT count(DISTINCT replicate) FROM trees, asked
WHERE site = :site AND species = :species AND year = last_year;
