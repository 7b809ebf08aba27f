import os

from qgis.core import QgsApplication, QgsRasterLayer

from .provider import Provider

TITLE = "New Bannwald project from a terrain"


class Plugin:
    """Adds the provider to the Processing toolbox, and a button that makes a project to draw in, as long as the
    plugin is loaded."""

    def __init__(self, iface=None):
        self.iface = iface
        self.provider = None
        self.button = None

    def initProcessing(self):
        """All that qgis_process needs."""
        self.provider = Provider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self):
        from qgis.PyQt.QtWidgets import QAction

        self.initProcessing()
        self.button = QAction(QgsApplication.getThemeIcon("/mActionFileNew.svg"), TITLE, self.iface.mainWindow())
        self.button.triggered.connect(lambda: self.draw())
        self.iface.addToolBarIcon(self.button)
        self.iface.addPluginToMenu("Bannwald", self.button)

    def draw(self):
        """Asks for the terrain, the active layer to begin with, and a folder; then opens the new project."""
        import processing

        layer = self.iface.activeLayer()
        answer = processing.execAlgorithmDialog(
            "bannwald:draw", {"DEM": layer.id()} if isinstance(layer, QgsRasterLayer) else {}
        )
        drawing = (answer or {}).get("MAP", "")
        if os.path.isfile(drawing):
            self.iface.addProject(drawing)  # QGIS asks before it drops unsaved changes

    def unload(self):
        if self.button is not None:
            self.iface.removePluginMenu("Bannwald", self.button)
            self.iface.removeToolBarIcon(self.button)
            self.button = None
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
