"""QGIS calls classFactory of this package when it loads the plugin."""


def classFactory(iface):
    from .plugin import Plugin

    return Plugin(iface)
