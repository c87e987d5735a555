"""Draws the figure of a mesh file and says where it is."""

from argparse import Namespace

from . import mesh, style


def report_mesh(options: Namespace) -> int:
    """0; InputError if the file is no mesh in space."""
    style.use()
    source = options.directory
    figure = mesh.draw(source, options.up)
    folder = options.output or source.parent
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{source.stem}.{options.format}"
    print(style.save(figure, target, options.dpi, options.format))
    return 0
