"""The algorithms of the toolbox: each is one command of the program bannwald."""

import os

from qgis.core import (
    QgsLayerDefinition,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingException,
    QgsProcessingOutputFile,
    QgsProcessingOutputString,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProcessingUtils,
    QgsProject,
    QgsVectorLayer,
)

from .program import call

# Files that the program reads as they are.
LAYER_FORMATS = ["gpkg", "shp", "geojson", "json", "csv"]


def kept_file(path, name):
    """A path that will still be there tomorrow: a project refers to its files."""
    plain = path.split("|")[0]
    if not os.path.isfile(plain) or os.path.abspath(plain).startswith(os.path.abspath(QgsProcessingUtils.tempFolder())):
        raise QgsProcessingException(
            f"{name}: the layer is no file of a format that bannwald reads (GeoPackage, Shapefile, GeoJSON, CSV; "
            "GeoTIFF or ESRI ASCII for grids): save it as a file first, a project refers to it"
        )
    return path


class Algorithm(QgsProcessingAlgorithm):
    """What all have in common."""

    ID = TITLE = HELP = ""

    def createInstance(self):
        return type(self)()

    def name(self):
        return self.ID

    def displayName(self):
        return self.TITLE

    def shortHelpString(self):
        return self.HELP

    def layer_file(self, parameters, name, context, feedback):
        """A layer as the program takes it, file.gpkg|layer; None where none is given."""
        if self.parameterAsSource(parameters, name, context) is None:
            return None
        path, layer = self.parameterAsCompatibleSourceLayerPathAndLayerName(
            parameters, name, context, LAYER_FORMATS, "gpkg", feedback
        )
        path = kept_file(path, name)
        return f"{path}|{layer}" if layer and path.lower().endswith(".gpkg") else path

    def new_folder(self, parameters, context):
        folder = self.parameterAsString(parameters, "PROJECT", context)
        if not folder or folder == QgsProcessing.TEMPORARY_OUTPUT:
            folder = QgsProcessingUtils.generateTempFilename("bannwald_project")
        return folder

    def scenario(self, parameters, context):
        file = self.parameterAsFile(parameters, "SCENARIO", context)
        if not os.path.isfile(file):
            raise QgsProcessingException(f"{file}: no such file; choose the scenario.ini of a project")
        return file


class DrawProject(Algorithm):
    ID, TITLE = "draw", "New project to draw in"
    HELP = (
        "Makes a project of bannwald from the terrain alone: bannwald init DIR --dem FILE --draw. drawing.gpkg holds "
        "empty layers for sources, roads, houses, nets, stands and ground types; drawing.qgs shows them over a "
        "hillshade. Draw, save the layers, and run scenario.ini: layers that are still empty count as not given."
    )

    def initAlgorithm(self, config=None):
        self.addParameter(QgsProcessingParameterRasterLayer("DEM", "Terrain heights"))
        self.addParameter(QgsProcessingParameterFolderDestination("PROJECT", "New folder of the project"))
        self.addOutput(QgsProcessingOutputFile("SCENARIO", "Scenario"))
        self.addOutput(QgsProcessingOutputFile("MAP", "QGIS project to draw in"))

    def processAlgorithm(self, parameters, context, feedback):
        folder = self.new_folder(parameters, context)
        dem = self.parameterAsRasterLayer(parameters, "DEM", context)
        if dem is None:
            raise QgsProcessingException(self.invalidRasterError(parameters, "DEM"))
        call(["init", folder, "--dem", kept_file(dem.source(), "DEM"), "--draw"], feedback)
        return {
            "PROJECT": folder,
            "SCENARIO": os.path.join(folder, "scenario.ini"),
            "MAP": os.path.join(folder, "drawing.qgs"),
        }


class NewProject(Algorithm):
    ID, TITLE = "newproject", "New project from layers"
    HELP = (
        "Makes a project of bannwald from layers: bannwald init DIR --dem ... The layers stay where they are. "
        "The log says what is taken for what; guesses are marked in scenario.ini. Without sources, steep cells "
        "are taken as sources, which is a guess too."
    )
    LAYERS = [
        ("SOURCES", "--sources", "Where rocks break off", QgsProcessing.TypeVectorAnyGeometry),
        ("TARGETS", "--targets", "What is to be protected: lines, polygons", QgsProcessing.TypeVectorAnyGeometry),
        ("TREES", "--trees", "Trees: points", QgsProcessing.TypeVectorPoint),
        ("STANDS", "--stands", "Instead of trees: polygons of stands", QgsProcessing.TypeVectorPolygon),
        ("GROUNDS", "--grounds", "Ground types: polygons", QgsProcessing.TypeVectorPolygon),
    ]

    def initAlgorithm(self, config=None):
        self.addParameter(QgsProcessingParameterRasterLayer("DEM", "Terrain heights"))
        for name, _, title, kind in self.LAYERS:
            self.addParameter(QgsProcessingParameterFeatureSource(name, title, [kind], optional=True))
        self.addParameter(QgsProcessingParameterFolderDestination("PROJECT", "New folder of the project"))
        self.addOutput(QgsProcessingOutputFile("SCENARIO", "Scenario"))

    def processAlgorithm(self, parameters, context, feedback):
        folder = self.new_folder(parameters, context)
        dem = self.parameterAsRasterLayer(parameters, "DEM", context)
        if dem is None:
            raise QgsProcessingException(self.invalidRasterError(parameters, "DEM"))
        arguments = ["init", folder, "--dem", kept_file(dem.source(), "DEM")]
        for name, option, _, _ in self.LAYERS:
            file = self.layer_file(parameters, name, context, feedback)
            if file is not None:
                arguments += [option, file]
        call(arguments, feedback)
        return {"PROJECT": folder, "SCENARIO": os.path.join(folder, "scenario.ini")}


class Check(Algorithm):
    ID, TITLE = "check", "Check a project"
    HELP = "Reads all files of a scenario and lists every problem; the log says how large the run is."

    def initAlgorithm(self, config=None):
        self.addParameter(QgsProcessingParameterFile("SCENARIO", "Scenario", extension="ini"))
        self.addOutput(QgsProcessingOutputString("ANSWER", "What was found"))

    def processAlgorithm(self, parameters, context, feedback):
        return {"ANSWER": "\n".join(call(["check", self.scenario(parameters, context)], feedback))}


class Run(Algorithm):
    ID, TITLE = "run", "Run"
    SHOWN = "E_95"  # the first map of this name, with forest, is switched on
    HELP = (
        "Simulates rockfall with and without the forest and adds the results to the map, styled. A cancelled run "
        "keeps its finished parts: the same call goes on from there."
    )

    def initAlgorithm(self, config=None):
        self.addParameter(QgsProcessingParameterFile("SCENARIO", "Scenario", extension="ini"))
        self.add_settings()
        self.addParameter(
            QgsProcessingParameterString(
                "SETTINGS", "Settings that differ, one a line: release.rocks=2000", multiLine=True, optional=True
            )
        )
        self.addParameter(
            QgsProcessingParameterNumber("THREADS", "Threads (0: all of the machine)", defaultValue=0, minValue=0)
        )
        self.addParameter(QgsProcessingParameterBoolean("OVERWRITE", "Replace results in the folder", False))
        self.addParameter(QgsProcessingParameterBoolean("LOAD", "Add the results to the map", True))
        self.addParameter(QgsProcessingParameterFolderDestination("RESULTS", "Folder of the results"))
        self.addOutput(QgsProcessingOutputFile("PAGE", "The page with all answers"))

    def add_settings(self):
        """Parameters of a special kind of run."""

    def shown(self, folder):
        """Where the page and the layers of this kind of run lie."""
        return folder

    def settings(self, parameters, context, feedback):
        text = self.parameterAsString(parameters, "SETTINGS", context)
        return [line.strip() for line in text.splitlines() if line.strip()]

    def processAlgorithm(self, parameters, context, feedback):
        folder = self.parameterAsString(parameters, "RESULTS", context)
        arguments = ["run", self.scenario(parameters, context), "--out", folder]
        for setting in self.settings(parameters, context, feedback):
            arguments += ["--set", setting]
        threads = self.parameterAsInt(parameters, "THREADS", context)
        if threads > 0:
            arguments += ["--threads", str(threads)]
        if self.parameterAsBoolean(parameters, "OVERWRITE", context):
            arguments.append("--overwrite")
        call(arguments, feedback)
        shown = self.shown(folder)
        self.tree = os.path.join(shown, "results.qlr") if self.parameterAsBoolean(parameters, "LOAD", context) else ""
        return {"RESULTS": folder, "PAGE": os.path.join(shown, "report.html")}

    def postProcessAlgorithm(self, context, feedback):
        """Runs in the thread of the map."""
        if self.tree and os.path.isfile(self.tree):
            project = context.project() or QgsProject.instance()
            done, message = QgsLayerDefinition.loadLayerDefinition(self.tree, project, project.layerTreeRoot())
            if done:
                for layer in [found for found in project.layerTreeRoot().findLayers() if found.name() == self.SHOWN][:1]:
                    layer.setItemVisibilityChecked(True)
                valid = sum(layer.isValid() for layer in project.mapLayers().values())
                feedback.pushInfo(f"{valid} of {len(project.mapLayers())} layers of the project can be drawn")
            else:
                feedback.reportError(f"{self.tree} cannot be added to the map: {message}")
        elif self.tree:
            feedback.pushWarning("The run wrote no results.qlr (output.geopackage = no): add its rasters by hand")
        return {}


class Hazard(Run):
    ID, TITLE = "hazard", "Hazard map"
    SHOWN = "Hazard_level"
    HELP = (
        "Runs a scenario with blocks by zone and return period (hazard.blocks) and adds the hazard map to the "
        "project. The table has the columns that coupling/assessments/hazard/README.md lists."
    )

    def add_settings(self):
        self.addParameter(
            QgsProcessingParameterFile("BLOCKS", "Blocks by zone and return period (hazard.blocks)", extension="csv")
        )

    def shown(self, folder):
        return os.path.join(folder, "hazard")

    def settings(self, parameters, context, feedback):
        blocks = os.path.abspath(self.parameterAsFile(parameters, "BLOCKS", context))
        return [f"hazard.blocks={blocks}", *super().settings(parameters, context, feedback)]


class NetPlace(Algorithm):
    ID, TITLE = "netplace", "Place nets"
    SHOWN = [("net_stretches", "Stretches where works are needed"), ("nets", "Best nets")]
    HELP = (
        "Says where along lines to protect, such as a road, nets are needed, and which: stretches, and the best net "
        "upslope of each. The run has to have been made with nets.keep_paths = yes. Lines with the columns of nets "
        "(height_m, and capacity_kj or class) are also moved upslope as they are. The page has the reasons."
    )

    def initAlgorithm(self, config=None):
        self.addParameter(
            QgsProcessingParameterFile("RUN", "Folder of a run", behavior=QgsProcessingParameterFile.Folder)
        )
        self.addParameter(
            QgsProcessingParameterFeatureSource(
                "NETS", "Lines to protect, such as a road, or nets", [QgsProcessing.TypeVectorLine]
            )
        )
        self.addParameter(QgsProcessingParameterString("DISTANCES", "Distances in plan, m: 0,10,20", optional=True))
        self.addParameter(QgsProcessingParameterFolderDestination("RESULTS", "Folder of the results"))
        self.addOutput(QgsProcessingOutputFile("PAGE", "The page with all answers"))
        self.addOutput(QgsProcessingOutputFile("STRETCHES", "Table of stretches with the best net of each"))
        self.addOutput(QgsProcessingOutputFile("PLACES", "Table of places of given nets; without such none"))

    def processAlgorithm(self, parameters, context, feedback):
        folder = self.parameterAsString(parameters, "RESULTS", context)
        nets = self.layer_file(parameters, "NETS", context, feedback)
        arguments = ["net", "place", self.parameterAsFile(parameters, "RUN", context), "--nets", nets, "--out", folder]
        distances = self.parameterAsString(parameters, "DISTANCES", context).strip()
        if distances:
            arguments += ["--distances", distances]
        call(arguments, feedback)
        self.layers = os.path.join(folder, "net_place.gpkg")
        results = {
            "RESULTS": folder,
            "PAGE": os.path.join(folder, "report.html"),
            "STRETCHES": os.path.join(folder, "net_stretches.csv"),
        }
        places = os.path.join(folder, "net_places.csv")
        return {**results, "PLACES": places} if os.path.isfile(places) else results

    def postProcessAlgorithm(self, context, feedback):
        for table, title in self.SHOWN:
            layer = QgsVectorLayer(f"{self.layers}|layername={table}", title, "ogr")
            if not layer.isValid():
                feedback.reportError(f"{self.layers}: the layer {table} cannot be added to the map")
            elif layer.featureCount() == 0:
                feedback.pushInfo(f"{title}: none")
            else:
                (context.project() or QgsProject.instance()).addMapLayer(layer)
                feedback.pushInfo(f"{title}: {layer.featureCount()} on the map")
        return {}
