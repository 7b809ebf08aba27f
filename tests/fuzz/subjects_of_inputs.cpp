#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/profile/falls/profile_site.hpp"
#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/terrain/terrain.hpp"
#include "tests/coupling/assessments/profile/profile_project.hpp"
#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"
#include "tests/coupling/inputs/formats/open_package.hpp"
#include "tests/coupling/inputs/meshes/mesh_texts.hpp"
#include "tests/fuzz/subject.hpp"

namespace fuzz {
namespace {

using coupling::ForestProject;
using coupling::SampleProject;

/// Reads all that a run of the scenario would read.
void read_project(const SampleProject& project) {
    config::Warnings warnings;
    const auto scenario = coupling::read_scenario(project.file("scenario.ini"), {});
    if (!scenario->terrain.profile.empty()) {
        coupling::profile::open_profile(*scenario, warnings);
        return;
    }
    if (!scenario->hazard.blocks.empty()) {
        coupling::hazard::read_plan(*scenario);
    }
    const coupling::Site site = coupling::open_site(*scenario, warnings);
    if (site.forest) {
        coupling::decades::read_management(*scenario, *site.forest, warnings);
    }
}

void append(const SampleProject& project, const std::string& name, const std::string& text) {
    project.write(name, project.read(name) + text);
}

std::unique_ptr<SampleProject> today() {
    auto project = std::make_unique<SampleProject>();
    project->replace("scenario.ini", "[trees]\n", "stopping = stopping.csv\n[trees]\nlogs = logs.csv\n");
    project->replace("scenario.ini", "diameter_m = 0.5\n", "");
    append(*project, "scenario.ini",
           "[nets]\nfile = nets.csv\n[hazard]\nblocks = blocks.csv\nmatrix = matrix.csv\n"
           "return_period_years = 100\n[risk]\nassess = yes\ncurves = curves.csv\n");
    project->write("curves.csv", std::string{config::shipped_table("risk_curves.csv")});
    project->write("targets.csv",
                   "target_id,name,wkt,vehicles_per_day,speed_kmph,persons_per_vehicle,vehicle_length_m,"
                   "persons,hours_per_day,house_value\n"
                   "road,road,\"LINESTRING (1105 2010, 1105 2090)\",1200,60,1.6,4.5,,,\n"
                   "house,house,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\",,,,,4,"
                   "16,900000\n");
    project->write(
        "logs.csv",
        "log_id,x1_m,y1_m,x2_m,y2_m,species,diameter1_cm,diameter2_cm,clearance_m,strength,anchored\n"
        "a,1060,2050,1060,2062,piab,40,25,0.3,0.8,yes\nb,1070,2050,1075,2050,Fagus sylvatica,30,30,,,\n");
    project->write("stopping.csv",
                   "code,diameter_m,p_stop,rolling_stops_per_m\n1,0.3,0.001,0.01\n1,1,0.0005,0.005\n"
                   "3,0.3,0.02,0.1\n3,1,0.01,0.05\n");
    project->write("nets.csv",
                   "name,height_m,capacity_kj,class,gap_m,wkt\n"
                   "upper,1.2,5,,0.1,\"LINESTRING (1075 2010, 1078 2050, 1075 2090)\"\n"
                   "lower,3,,1,,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    project->write(
        "blocks.csv",
        "return_period_years,zone,diameter_m,volume_m3,blocks\n10,1,0.3,,\n100,1,,1.5,60\n300,1,2,,\n");
    project->write("matrix.csv", std::string{config::shipped_table("hazard_matrix.csv")});
    project->replace("scenario.ini", "[terrain]",
                     "[run]\nparameter_draws = yes\nparameters = parameters.csv\n[terrain]");
    project->write("parameters.csv",
                   "parameter,width,goes_with,correlation\nlosses,0.3,,\nlosses_on.3,0.1,friction,-0.5\ntree_"
                   "energy,0,,\n");
    return project;
}

/// What was seen in the field, and the sample of a calibration.
std::unique_ptr<SampleProject> observed() {
    auto project = std::make_unique<SampleProject>();
    append(*project, "scenario.ini",
           "[observed]\nstops = stops.csv\npassages = passages.csv\nimpacts = impacts.csv\n"
           "scars = scars.csv\ntrees = searched.csv\noutline = outline.csv\nrocks = 50\n[calibrate]\nwindow "
           "= window.csv\n");
    project->replace("scenario.ini", "[terrain]", "[run]\nparameters = posterior.csv\n[terrain]");
    project->write("stops.csv",
                   "x_m,y_m,x_release_m,y_release_m,zone,group\n1060,2050,1025,2050,1,a\n1080,2040,,,1,b\n");
    project->write("passages.csv",
                   "target_id,speed_mps,height_m,energy_kj,translational_kj,group\nroad,12,0.5,20,16,a\n");
    project->write("impacts.csv",
                   "ground,speed_in_mps,speed_out_mps,angle_in_deg,angle_out_deg,x_m,y_m,track,group\n"
                   "3,10,7,30,20,,,,a\n3,,,,,1060,2050,t,a\n3,,,,,1066,2050,t,a\n");
    project->write("searched.csv", "x_m,y_m,scars,dbh_cm\n1060,2050,2,32.5\n1070,2042,0,\n");
    project->write("outline.csv",
                   "wkt\n\"POLYGON ((1040 2030, 1090 2030, 1090 2070, 1040 2070, 1040 2030))\"\n");
    project->write("scars.csv", "height_m,x_m,y_m,dbh_cm,group\n0.8,1060,2050,32.5,a\n1.2,,,,\n");
    project->write("window.csv",
                   "wkt\n\"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))\"\n");
    project->write("posterior.csv", "set,weight,losses,losses_on.3\n1,0.25,0.8,2\n2,0.75,1.25,0.5\n");
    return project;
}

std::unique_ptr<SampleProject> packed() {
    auto project = std::make_unique<SampleProject>();
    project->replace("scenario.ini", "dem.asc", "dem.asc.gz");
    if (std::system(("gzip -n '" + project->file("dem.asc").string() + "'").c_str()) != 0) {
        throw std::runtime_error{"gzip"};
    }
    return project;
}

/// Points, polygons and shapes instead of grids, under pir3d.
std::unique_ptr<SampleProject> shapes() {
    auto project = std::make_unique<SampleProject>();
    std::string points;
    for (int x = 1005; x < 1120; x += 10) {
        for (int y = 2005; y < 2100; y += 10) {
            points += std::to_string(x) + ' ' + std::to_string(y + x % 3) + ' ' +
                      std::to_string(400 - 7 * (x - 1000) / 10) + '\n';
        }
    }
    project->write("points.xyz", points);
    project->write("scenario.ini",
                   "[terrain]\npoints = points.xyz\nlongest_edge_m = 30\nsurface_polygons = areas.csv\n"
                   "surface_types = surface_types.csv\nsoils = soils.csv\nground = road\n"
                   "[release]\nsource_shapes = cliff.csv\nrocks = 100\ndiameter_kind = classes\n"
                   "diameter_classes_m = 0.5, 1\ndiameter_shares = 60, 40\n"
                   "[targets]\nfile = targets.csv\n[rockfall]\nmotion = pir3d\n");
    project->write("areas.csv",
                   "code,wkt\n3,\"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))\"\n"
                   "1,\"POLYGON ((1000 2000, 1030 2000, 1030 2100, 1000 2100, 1000 2000))\"\n");
    project->write("soils.csv", "name,like,r_t,threshold_deg\nmeadow,soft_soil_step_1,0.75,5\n");
    project->write("surface_types.csv", "code,like,soil\n1,solid_rock,meadow\n3,solid_rock,\n");
    project->write("cliff.csv",
                   "wkt,zone,speed_mps,mass_t\n\"LINESTRING (1025 2020, 1030 2060)\",1,4,2\n"
                   "\"LINESTRING (1025 2070, 1032 2080)\",2,3,1\n");
    return project;
}

/// The terrain of the sample project as a list of triangles.
rockfall::Terrain sloping_square() {
    std::vector<rockfall::Vertex> vertices{
        {0, 0, 400}, {120, 0, 316}, {120, 100, 316}, {0, 100, 400}, {60, 50, 357}};
    constexpr std::uint32_t none = rockfall::no_triangle;
    std::vector<rockfall::Triangle> triangles{{{0, 1, 4}, {none, 1, 3}},
                                              {{1, 2, 4}, {none, 2, 0}},
                                              {{2, 3, 4}, {none, 3, 1}},
                                              {{3, 0, 4}, {none, 0, 2}}};
    return {{1000, 2000}, std::move(vertices), std::move(triangles)};
}

std::unique_ptr<SampleProject> mesh() {
    auto project = std::make_unique<SampleProject>();
    const rockfall::Terrain terrain = sloping_square();
    const coupling::meshes::MeshTexts texts{terrain};
    project->write("slope.ply", texts.ply_with_codes([](double x, double) { return x < 1050 ? 1 : 3; }));
    project->write("cliff.csv", "wkt\nPOINT (1030 2050)\n");
    project->replace("scenario.ini", "dem = dem.asc\nsurface = surface.asc\n", "mesh = slope.ply\n");
    project->replace("scenario.ini", "source = source.asc", "source_shapes = cliff.csv");
    return project;
}

/// Rocks with shapes, by settings and by columns.
std::unique_ptr<SampleProject> blocks() {
    auto project = std::make_unique<SampleProject>();
    project->replace("scenario.ini", "source = source.asc",
                     "source_shapes = cliffs.csv\nshape = hull, box\nshape_shares = 2, 1\n"
                     "shape_file = hull.csv\nsides = 1, 0.8, 0.5\nsides_scatter = 0.2\n"
                     "attitude = 0, -1, 0, 1, 0, 0, 0, 0, 1");
    append(*project, "scenario.ini", "[rockfall]\nmotion = rigid\n[rigid]\nfriction = 0.6\n");
    project->write("hull.csv", "x_m,y_m,z_m\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n0.7,0.7,0.6\n");
    project->write("stone.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                   "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    project->write("cliffs.csv",
                   "wkt,shape,side_a_m,side_b_m,side_c_m,sides_scatter,shape_file,mass_t\n"
                   "\"LINESTRING (1020 2030, 1020 2060)\",rounded,2,1,0.5,0.1,,1.5\n"
                   "\"LINESTRING (1030 2050, 1030 2055)\",,,,,,stone.ply,\n"
                   "\"LINESTRING (1030 2040, 1030 2045)\",plate,,,,,,\n");
    project->write(
        "surface_types.csv",
        "code,label,r_n,r_t,p_stop,rigid_ground,friction_law,friction,friction_max,slip_beta_ps,"
        "slip_kappa_pm,contact_drag_ps,restitution,rolling_resistance\n"
        "1,rock,0.40,0.90,0.0005,hard,,,,,,,,\n3,soil,0.3,0.8,0.01,,slip,0.3,2,150,2,0.5,0.1,0.05\n");
    return project;
}

/// A forest of listed trees in two climates under two regimes, with tables of the user's own.
std::unique_ptr<SampleProject> years() {
    auto project = std::make_unique<ForestProject>();
    append(*project, "scenario.ini",
           "variants = climates.csv\n[regimes]\nlist = none, mine.csv\ntimber_prices = prices.csv\n"
           "work_costs = work.csv\n");
    project->replace("scenario.ini", "[forest]\n", "[forest]\nspecies = species.csv\n");
    project->write("climates.csv",
                   "name,file,change,temperature_change_k,precipitation_change\npresent,,,,\nwarm,,,2,0.9\n"
                   "other,climate.csv,change.csv,,\n");
    std::string change = "month,temperature_k,precipitation\n";
    for (int month = 1; month <= 12; ++month) {
        change += std::to_string(month) + ",1.5,0.95\n";
    }
    project->write("change.csv", change);
    project->write("mine.csv",
                   "name,treatment,first_year,where,polygons,share,after,after_years,species,plants_pha\n"
                   "cut,clear_cut,1,,,,,,,\nthin,thin_below,3,polygons,lots.csv,0.2,,,,\n"
                   "plant,plant,,,,,cut,1,piab abal,500 300\n");
    project->write("lots.csv",
                   "wkt\n\"POLYGON ((1050 2010, 1090 2010, 1090 2060, 1050 2060, 1050 2010))\"\n");
    project->write("species.csv", std::string{config::shipped_table("species.csv")});
    project->write("prices.csv", std::string{config::shipped_table("timber_prices.csv")});
    project->write("work.csv", std::string{config::shipped_table("work_costs.csv")});
    return project;
}

/// Climate of days, as services have it: lines above the header, days of the year, units of their own, a
/// header in a comment, a table of the place above that of the days.
std::unique_ptr<SampleProject> days() {
    auto project = std::make_unique<ForestProject>();
    project->replace("scenario.ini", "file = climate.csv\nelevation_m = 500\n",
                     "file = daymet.csv\nsequence = random\nvariants = climates.csv\n");
    project->write("climates.csv", "name,file\nfirst,\nsecond,swiss.csv\nthird,knmi.txt\nfourth,meteo.csv\n");
    std::string daymet =
        "Elevation: 500 meters\n"
        "year,yday,dayl (s),prcp (mm/day),srad (W/m^2),tmax (deg c),tmin (deg c)\n";
    std::string swiss = "station_abbr;reference_timestamp;tre200dn;tre200dx;rre150d0;gre000d0;elev_m\n";
    for (int day = 1; day <= 365; ++day) {
        daymet += "2001," + std::to_string(day) + ",43200,3,260,15,5\n";
    }
    for (int month = 1; month <= 12; ++month) {
        for (int day = 1; day <= 28; ++day) {  // the others are missing, as single days may be
            swiss +=
                "DAV;" + std::to_string(day) + "." + std::to_string(month) + ".2001 00:00;5;15;3;140;500\n";
        }
    }
    project->write("daymet.csv", daymet);
    project->write("swiss.csv", swiss);
    std::string knmi =
        "SOURCE: KNMI\n\nTN        = Minimum temperature (in 0.1 degrees Celsius)\n"
        "TX        = Maximum temperature (in 0.1 degrees Celsius)\n"
        "Q         = Global radiation (in J/cm2)\n"
        "RH        = Daily precipitation amount (in 0.1 mm) (-1 for <0.05 mm)\n"
        "elev_m    = height of the place (m)\n\n# STN,YYYYMMDD,   TN,   TX,    Q,   RH, elev_m\n\n";
    std::string meteo =
        "latitude,longitude,elevation,utc_offset_seconds,timezone,timezone_abbreviation\n"
        "47.2,11.4,500,0,GMT,GMT\n\ntime,temperature_2m_max (°C),temperature_2m_min (°F),"
        "precipitation_sum (inch)\n";
    for (int month = 1; month <= 12; ++month) {
        for (int day = 1; day <= 28; ++day) {
            const std::string date = std::to_string(20010000 + 100 * month + day);
            const char* rain = day % 2 == 0 ? "60" : "-1";
            knmi += "  260," + date + ",   50,  150, 1200, " + rain + ", 500\n";
            meteo += date + ",15,41,0.12\n";
        }
    }
    project->write("knmi.txt", knmi);
    project->write("meteo.csv", meteo);
    return project;
}

/// A forest of stand records in polygons.
std::unique_ptr<SampleProject> stands() {
    auto project = std::make_unique<ForestProject>();
    project->replace("scenario.ini", "map = stands.asc\n", "polygons = stands.csv\nrecords = records.csv\n");
    project->replace("scenario.ini", "[trees]\nfile = trees.csv\n", "");
    project->write("stands.csv",
                   "stand,wkt\n7,\"POLYGON ((1040 2000, 1120 2000, 1120 2050, 1040 2050, 1040 2000))\"\n"
                   "8,\"POLYGON ((1040 2050, 1120 2050, 1120 2100, 1040 2100, 1040 2050))\"\n");
    return project;
}

/// What an inventory adds to records, and a target profile.
std::unique_ptr<SampleProject> inventory() {
    auto project = std::make_unique<ForestProject>();
    project->replace("scenario.ini", "map = stands.asc\n",
                     "map = stands.asc\nrecords = records.csv\ndead_wood = wood.csv\nsaplings = young.csv\n"
                     "dbh_classes = classes.csv\ntarget_profile = profile.csv\n");
    project->replace("scenario.ini", "[trees]\nfile = trees.csv\n", "");
    project->write("records.csv", "stand,species,stems_pha,mean_dbh_cm\n7,PIAB,600,25\n");
    project->write("classes.csv",
                   "stand,species,dbh_from_cm,dbh_to_cm,stems_pha,height_m\n8,FASY,12,24,400,15\n");
    project->write("wood.csv",
                   "stand,species,kind,volume_m3pha,dbh_cm,length_m,decay_class,log_angle_deg,anchored\n"
                   "7,PIAB,snag,30,20,,2,,\nall,PIAB,log,50,20,6,3,70,yes\n");
    project->write("young.csv",
                   "stand,species,height_class,stems_pha,browsed_percent,height_m,age_years\n"
                   "all,ABAL,10-40,600,40,,3\n8,PIAB,,300,,0.3,\n");
    project->write("profile.csv",
                   "stand,site_type,hazard,criterion,minimal,ideal\nall,55,rockfall,gap_m,40,20\n"
                   "8,46,rockfall,mixture_ABAL_percent,10-90,30-60\n");
    return project;
}

/// A logo of each kind, one for a page.
std::unique_ptr<SampleProject> with_logo(const std::string& name, const std::string& bytes) {
    auto project = std::make_unique<SampleProject>();
    append(*project, "scenario.ini", "[report]\ntitle = Road\nlogo = " + name + "\n");
    project->write(name, bytes);
    return project;
}
std::unique_ptr<SampleProject> png() {
    using namespace std::string_literals;
    auto project = with_logo("logo.png",
                             "\x89PNG\r\n\x1a\n"s
                             "\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55"s
                             "\0\0\0\nIDAT\x78\x9c\x63\x60\0\0\0\2\0\1\x48\xaf\xa4\x71"s
                             "\0\0\0\0IEND\xae\x42\x60\x82"s);
    // The same as the picture behind the maps.
    project->replace("scenario.ini", "[terrain]\n", "[terrain]\npicture = logo.png\n");
    project->write("logo.pgw", "120\n0\n0\n-120\n1060\n2050\n");
    return project;
}
std::unique_ptr<SampleProject> jpeg() {
    using namespace std::string_literals;
    return with_logo("logo.jpg", "\xff\xd8\xff\xe0\0\4ab\xff\xda\0\4cd1234\xff\xd9"s);
}
std::unique_ptr<SampleProject> svg() {
    return with_logo("logo.svg",
                     "<?xml version=\"1.0\"?>\n<!-- a circle --><svg viewBox=\"0 0 2 2\"><circle cx=\"1\" "
                     "cy=\"1\" r=\"1\" fill=\"url(#g)\"/></svg>\n");
}

/// The shipped regime with the most columns, as a file of the user's.
std::unique_ptr<SampleProject> regime() {
    auto project = std::make_unique<ForestProject>();
    project->replace("scenario.ini", "years = 4\n", "years = 100\n");  // interventions come within them
    project->replace("scenario.ini", "elevation_m = 500\n", "elevation_m = 500\nsequence = repeat\n");
    append(*project, "scenario.ini", "[regimes]\nlist = shelter.csv, slits.csv\n");
    project->write("shelter.csv", std::string{coupling::shipped_regime("bau_shelterwood")});
    project->write("slits.csv", std::string{coupling::shipped_regime("pfm2")});
    return project;
}

/// The sample project as a GIS hands it over.
std::unique_ptr<SampleProject> gis() {
    auto project = std::make_unique<SampleProject>();
    coupling::take_given_files(*project);
    project->write("scenario.ini",
                   "[terrain]\ndem = dem.tif\nsurface = surface.tif\nsurface_types = surface_types.csv\n"
                   "[trees]\nfile = trees.shp\n[release]\nsource_shapes = layers.gpkg|cliff\nrocks = 100\n"
                   "diameter_m = 0.5\n[targets]\nfile = targets.geojson\n");
    return project;
}

/// The shape of a target in well-known binary: a circle of arcs, as cadastres have them.
std::string disc() {
    return "X'47500001DF0B0000"  // GP, version 0, little endian, no box, system 3035
           "010A00000001000000"  // CURVEPOLYGON of one ring
           "010800000003000000"  // CIRCULARSTRING of three points
           "0000000000449140"    // 1105
           "00000000006A9F40"    // 2010.5
           "00000000006C9140"    // 1115
           "00000000006A9F40"    // 2010.5
           "0000000000449140"    // 1105
           "00000000006A9F40'";  // 2010.5
}

/// Layers of a GeoPackage with changes in its write-ahead log, shapes with arcs, a grid with words.
std::unique_ptr<SampleProject> open_layers() {
    auto project = std::make_unique<SampleProject>();
    const coupling::OpenPackage package;
    package.run("UPDATE trees SET species = 'Fichte' WHERE fid = 2");
    package.run("UPDATE targets SET geom = " + disc() + " WHERE fid = 2");
    project->write("layers.gpkg", package.main());
    project->write("layers.gpkg-wal", package.log());
    std::string dem = project->read("dem.asc");
    const std::size_t last = dem.find_last_of(" \n", dem.find_last_not_of(" \n"));
    project->write("dem.asc", dem.substr(0, last + 1) + "-1.#IND\n");
    project->write("cliff.csv",
                   "wkt\n\"COMPOUNDCURVE ((1025 2020, 1030 2060), CIRCULARSTRING (1030 2060, 1035 2070, 1030 "
                   "2080))\"\n");
    project->replace("scenario.ini", "source = source.asc", "source_shapes = cliff.csv");
    project->replace("scenario.ini", "targets.csv", "layers.gpkg|targets");
    project->replace("scenario.ini", "trees.csv", "layers.gpkg|trees");
    return project;
}

/// As a spreadsheet writes it.
std::unique_ptr<SampleProject> spreadsheet() {
    auto project = std::make_unique<SampleProject>();
    project->write("trees.csv",
                   "sep=;\r\nNr;Ost;Nord;Baumart;BHD;H\xF6he\r\n1;1060;2050;Wei\xDF"
                   "tanne;32,5;25\r\n2;1070;2042;Fi;20;18\r\n");
    project->write("targets.csv", "WKT\tid\n\"LINESTRING (1105 2010, 1105 2090)\"\troad\n");
    return project;
}

std::unique_ptr<SampleProject> profile() {
    auto project = std::make_unique<SampleProject>();
    coupling::make_profile_project(*project);
    return project;
}

}  // namespace

std::vector<Subject> subjects_of_inputs() {
    return {
        {"today",
         {"scenario.ini", "dem.asc", "dem.prj", "surface.asc", "surface_types.csv", "source.asc", "trees.csv",
          "logs.csv", "targets.csv", "stopping.csv", "nets.csv", "blocks.csv", "matrix.csv", "curves.csv",
          "parameters.csv"},
         today,
         read_project},
        {"observed",
         {"stops.csv", "passages.csv", "impacts.csv", "scars.csv", "searched.csv", "outline.csv",
          "window.csv", "posterior.csv"},
         observed,
         read_project},
        {"packed", {"dem.asc.gz"}, packed, read_project},
        {"shapes",
         {"scenario.ini", "points.xyz", "areas.csv", "soils.csv", "surface_types.csv", "cliff.csv",
          "targets.csv"},
         shapes,
         read_project},
        {"mesh", {"slope.ply"}, mesh, read_project},
        {"blocks",
         {"scenario.ini", "hull.csv", "stone.ply", "cliffs.csv", "surface_types.csv"},
         blocks,
         read_project},
        {"years",
         {"scenario.ini", "dem.asc", "trees.csv", "stands.asc", "soil.asc", "soils.csv", "climate.csv",
          "climates.csv", "change.csv", "mine.csv", "lots.csv", "species.csv", "prices.csv", "work.csv"},
         years,
         read_project},
        {"days", {"daymet.csv", "swiss.csv", "knmi.txt", "meteo.csv"}, days, read_project},
        {"stands", {"scenario.ini", "stands.csv", "records.csv"}, stands, read_project},
        {"inventory", {"wood.csv", "young.csv", "classes.csv", "profile.csv"}, inventory, read_project},
        {"png", {"logo.png"}, png, read_project},
        {"jpeg", {"logo.jpg"}, jpeg, read_project},
        {"svg", {"logo.svg"}, svg, read_project},
        {"regime", {"shelter.csv", "slits.csv"}, regime, read_project},
        {"gis",
         {"dem.tif", "surface.tif", "trees.shp", "trees.shx", "trees.dbf", "trees.prj", "trees.cpg",
          "layers.gpkg", "targets.geojson"},
         gis,
         read_project},
        {"open_layers",
         {"layers.gpkg", "layers.gpkg-wal", "dem.asc", "cliff.csv", "scenario.ini"},
         open_layers,
         read_project},
        {"spreadsheet", {"trees.csv", "targets.csv"}, spreadsheet, read_project},
        {"profile", {"scenario.ini", "profile.csv", "stations.csv"}, profile, read_project},
    };
}

}  // namespace fuzz
