-- What a cause took in a year of a replicate, and what stood at the end of the year before.
CREATE VIEW agents AS SELECT value AS cause FROM json_each('["wind","snow","beetle"]');
CREATE VIEW years_of_stands AS
  SELECT site, replicate, year, volume_m3pha FROM stands WHERE stand = 'all' AND species = 'all';
CREATE VIEW lost AS
  SELECT s.site, s.replicate, s.year, cause, s.volume_m3pha AS stock,
    coalesce((SELECT sum(m.volume_m3pha) FROM mortality m WHERE m.site = s.site AND m.replicate = s.replicate
      AND m.year = s.year + 1 AND m.cause = agents.cause), 0) AS taken
  FROM years_of_stands s, agents, asked WHERE s.year < last_year;
CREATE VIEW rates AS SELECT sites.site, words, cause,
  CASE cause WHEN 'beetle' THEN 'beetles take' ELSE cause || ' takes' END AS takes FROM sites, agents;

-- figure loss:{cause}:{site} | rates | stock that {takes} in a year at {words} | %
SELECT 100 * sum(taken) / sum(stock) FROM lost WHERE site = :site AND cause = :cause;
-- figure total_loss:{site} | sites | stands that beetles take whole within 40 years at {words} | %
SELECT 100.0 * avg(gone) FROM (SELECT sum(taken) > 0.8 * max(stock) AS gone FROM lost
  WHERE site = :site AND cause = 'beetle' GROUP BY replicate);
CREATE VIEW one AS SELECT 1 AS one;
-- figure warm_ratio | one | loss to beetles in the three warm years and the two after / in the usual ones | -
SELECT (SELECT sum(taken)/sum(stock) FROM lost WHERE site = 'warm' AND cause = 'beetle' AND year BETWEEN 10 AND 14) /
  (SELECT sum(taken)/sum(stock) FROM lost WHERE site = 'usual' AND cause = 'beetle' AND year BETWEEN 10 AND 14);
