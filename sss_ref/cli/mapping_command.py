"""`sss-ref mapping`, an application of its own, loaded when asked for: its help has every key of a mapping file."""

from typing import Annotated

from cyclopts import App, Parameter

from sss_ref.cli.console import out
from sss_ref.cli.options import NO_CHANGES, Changes
from sss_ref.dump.mapping_template import key_reference, mapping_template

mapping = App(
    name="mapping",
    help="Print a mapping file to edit, with every buffer of a scene.",
    help_epilogue=f"The keys of a mapping file:\n\n{key_reference()}",
    result_action="return_value",
)


@mapping.default
def _printed(
    scene: Annotated[str, Parameter(help="A scene file, a bundle, or the name of a shipped scene.")] = "default",
    *,
    changes: Changes = NO_CHANGES,
) -> int:
    from sss_ref.scene.load import load_scene

    out.print(mapping_template(load_scene(scene, **changes.overrides())), markup=False, end="")
    return 0
