"""The shaders of a pass: our own, translated from its stages, or a user's files in their place."""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from sss_ref.errors import ShaderError
from sss_ref.errors.text_file import text_of
from sss_ref.interpret.shader import GLSL, OUT, Dialect, draws, fragment_shader, vertex_shader
from sss_ref.language.names import Name
from sss_ref.language.pipeline import Pass
from sss_ref.scene.catalogue import method_of
from sss_ref.scene_file.settings import SceneFile

if TYPE_CHECKING:
    from moderngl import Context, Program

SAMPLER = re.compile(r"^uniform \w*sampler2D", re.MULTILINE)
Files = str | PathLike[str] | Sequence[str | PathLike[str]]
ENDINGS = (".vert", ".frag")  # of the files that are read
COMPANIONS = ("readme", "license", "makefile", ".gitignore", ".ds_store", "thumbs")  # stand in folders of any kind


@dataclass(frozen=True)
class ShaderPair:
    """A vertex and a fragment shader, and the buffers that the latter writes, by location; name: for messages."""

    name: str
    vertex: str
    fragment: str
    outputs: tuple[str, ...]

    def compiled(self, context: "Context") -> "Program":
        """The program; raises ShaderError with what the driver says."""
        import moderngl

        try:
            return context.program(vertex_shader=self.vertex, fragment_shader=self.fragment)
        except moderngl.Error as error:
            self.check_units(context.info["GL_MAX_TEXTURE_IMAGE_UNITS"])
            raise ShaderError(f"{self.name}: expected shaders that compile and link, got {error}") from None

    def check_units(self, units: int) -> None:
        """Raise ShaderError if the fragment shader reads more textures than the units that OpenGL has for them."""
        textures = len(SAMPLER.findall(self.fragment))
        if textures > units:
            raise ShaderError(
                f"{self.name}: expected at most {units} textures, as this OpenGL has units for, got {textures}; "
                "draw fewer lights, each of which has a shadow map"
            )


def own_shaders(
    this_pass: Pass,
    buffers: Collection[str],
    wanted: Collection[str],
    lengths: Mapping[str, int],
    vertex: Path | None = None,
    dialect: Dialect = GLSL,
) -> list[ShaderPair]:
    """The shaders of a pass, translated; vertex: the file of the user's vertex shader, if it is drawn with that.

    The other arguments as `fragment_shader` takes them.
    """
    text = _source(vertex, dialect) if vertex else vertex_shader(this_pass, lengths, dialect)
    return [
        ShaderPair(str(vertex or name), text, fragment_shader(this_pass, buffers, outputs, lengths, dialect), outputs)
        for name, outputs in draws(this_pass, wanted, dialect).items()
    ]


def _source(path: Path, dialect: Dialect) -> str:
    return text_of(path, f"{dialect.title} source", ShaderError)


def shader_folder(folder: Path, settings: SceneFile) -> dict[str, list[Path]]:
    """The files of a folder by the pass they stand for: camera.frag, camera_1.frag, camera.vert are of pass camera.

    Those of a pass on demand are left out. Raises ShaderError for a folder without any, and for a file that no pass has
    the name of.
    """
    on_demand = {each.name: each.on_demand for each in method_of(settings).passes}
    passes = [name for name in on_demand if not on_demand[name]]
    paths = sorted(path for path in folder.glob("*") if path.suffix in ENDINGS)
    if not paths:
        raise ShaderError(
            f"{folder}: expected files NAME.frag or NAME.vert, NAME a pass ({', '.join(passes)}), got none"
        )
    files: dict[str, list[Path]] = {}
    for path in paths:
        name = next((name for name in (path.stem, str(Name.of(path.stem).of_light(0))) if name in on_demand), None)
        if name is None:
            raise ShaderError(f"{path}: expected the name of a pass ({', '.join(passes)}), got {path.stem}; rename it")
        files.setdefault(name, []).append(path)
    return {name: files[name] for name in passes if name in files}


def passed_over(folder: Path, files: Mapping[str, Sequence[Path]]) -> dict[str, str]:
    """Name -> why it is not read, of what a folder holds beside these shaders of its passes and usual companions."""
    read = {path for of_pass in files.values() for path in of_pass}
    others = [path for path in sorted(folder.iterdir()) if path not in read and path.stem.lower() not in COMPANIONS]
    return {path.name: _why_unread(path) for path in others}


def _why_unread(path: Path) -> str:
    if path.is_dir():
        return "a folder"
    return "of a pass on demand" if path.suffix in ENDINGS else f"no {' or '.join(ENDINGS)}"


def listed(files: Files) -> list[Path]:
    """One file or several as paths."""
    return [Path(files)] if isinstance(files, str | PathLike) else [Path(path) for path in files]


def user_vertex_file(files: Files) -> Path | None:
    """The vertex shader among a pass's files, known by its suffix .vert. Raises ShaderError for a second one."""
    found = [path for path in listed(files) if path.suffix == ".vert"]
    if len(found) > 1:
        raise ShaderError(f"{found[1]}: expected one vertex shader a pass, got {found[0]} as well; remove one")
    return found[0] if found else None


def user_shaders(
    this_pass: Pass, files: Files, lengths: Mapping[str, int], dialect: Dialect = GLSL
) -> list[ShaderPair]:
    """The fragment shaders among a pass's files, each with the user's vertex shader, or else ours.

    A fragment shader says what it writes, as ours do: layout(location = 0) out vec3 out_lit. It reads uniforms and
    textures by the names of the translated shaders. Raises ShaderError where a file cannot be read or writes what the
    pass does not.
    """
    file = user_vertex_file(files)
    vertex = _source(file, dialect) if file else vertex_shader(this_pass, lengths, dialect)
    texts = {path: _source(path, dialect) for path in listed(files) if path.suffix != ".vert"}
    return [
        ShaderPair(str(path), vertex, text, _outputs(this_pass, path, text, dialect)) for path, text in texts.items()
    ]


def _outputs(this_pass: Pass, path: Path, text: str, dialect: Dialect) -> tuple[str, ...]:
    """The buffers that a fragment shader says it writes, by location."""
    ours, outputs = {dialect.out(name): name for name in this_pass.values}, re.finditer(dialect.written.output, text)
    found = sorted((int(each["at"]), ours.get(OUT + each["name"], each["name"])) for each in outputs)
    names = tuple(name for _, name in found)
    listed = ", ".join(this_pass.values)
    if not found or [location for location, _ in found] != list(range(min(len(found), dialect.most_outputs))):
        raise ShaderError(
            f"{path}: expected outputs at locations 0, 1 ... of 1 to {dialect.most_outputs} buffers ({listed}), "
            f"got {len(found)}; declare each as {dialect.written.example}"
        )
    for name in names:
        if name not in this_pass.values:
            raise ShaderError(
                f"{path}: expected outputs of pass {this_pass.name} ({listed}), got {OUT}{name}; rename it"
            )
    return names
