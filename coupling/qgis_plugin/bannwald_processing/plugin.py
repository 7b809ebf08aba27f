from qgis.core import QgsApplication

from .provider import Provider


class Plugin:
    """Adds the provider to the Processing toolbox as long as the plugin is loaded."""

    def __init__(self):
        self.provider = None

    def initProcessing(self):
        """All that qgis_process needs."""
        self.provider = Provider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
