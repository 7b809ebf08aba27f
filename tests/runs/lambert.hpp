#pragma once

namespace coupling {

/// EPSG:31287 as ESRI writes it, no authority in the text, but with the origin of the sample project.
inline constexpr const char* lambert =
    "PROJCS[\"MGI_Austria_Lambert\",GEOGCS[\"GCS_MGI\",DATUM[\"D_MGI\",SPHEROID[\"Bessel_1841\",6377397.155,"
    "299.1528128]],"
    "PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"Lambert_Conformal_Conic\"],"
    "PARAMETER[\"False_Easting\",1000.0],PARAMETER[\"False_Northing\",2000.0],PARAMETER[\"Central_"
    "Meridian\","
    "13.3333333333333],PARAMETER[\"Standard_Parallel_1\",49.0],PARAMETER[\"Standard_Parallel_2\",46.0],"
    "PARAMETER[\"Latitude_Of_Origin\",47.5],UNIT[\"Meter\",1.0]]";

}  // namespace coupling
