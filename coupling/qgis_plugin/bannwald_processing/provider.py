from processing.core.ProcessingConfig import ProcessingConfig, Setting
from qgis.core import QgsProcessingProvider

from .algorithms import Check, DrawProject, Hazard, NetPlace, NewProject, Run
from .program import SETTING


class Provider(QgsProcessingProvider):
    def id(self):
        return "bannwald"

    def name(self):
        return "Bannwald"

    def load(self):
        ProcessingConfig.addSetting(
            Setting(self.name(), SETTING, "Program bannwald (empty: found on the PATH)", "", valuetype=Setting.FILE)
        )
        ProcessingConfig.readSettings()
        self.refreshAlgorithms()
        return True

    def unload(self):
        ProcessingConfig.removeSetting(SETTING)

    def loadAlgorithms(self):
        for algorithm in (DrawProject, NewProject, Check, Run, NetPlace, Hazard):
            self.addAlgorithm(algorithm())
