"""What is read from records, notebooks, witnesses, results, masks, pictures and shaders, as comparable facts."""

from functools import cache

from fuzzed_readers import dumped_scene, facts

from sss_ref.batch.sweep_file import Sweep
from sss_ref.truth.photon import Setup, Volume
from sss_ref.truth.tally import Walk

SWEEP = Sweep(scene="teaching", outputs=("npz",), keep=("image",), vary={"camera.azimuth": [0.0, 30.0]})


@cache
def walk():
    """What a tally is of."""
    return Walk(Volume(1.5, 0.1, 0.0, 1.4), Setup(2.5, False), (0.5, 1.0, 2.0))


@cache
def tracing():
    """What sums are of."""
    from sss_ref.truth.media import volumes
    from sss_ref.truth.tracing import Tracing

    return Tracing(dumped_scene(), volumes("skin1"))


def of_material(path):
    """The volumes of a material."""
    from sss_ref.truth.material_record import volumes_of

    return list(facts("material", [each._asdict() for each in volumes_of(str(path))]))


def of_tally(path):
    """A tally, on which more photons can be counted."""
    from sss_ref.truth.tally import nothing_walked, read_tally

    tally = read_tally(path, walk())
    assert tally.counts.shape == nothing_walked(walk()).counts.shape and tally.counts.min() >= 0
    return list(facts("tally", {"counts": tally.counts, "photons": tally.photons}))


def of_sums(path):
    """Sums of a tracing, to which more samples can be added."""
    from sss_ref.truth.radiance import nothing_gathered, read_radiance

    found, right = read_radiance(path, tracing()), nothing_gathered(tracing())
    assert found.samples >= 0
    for one, other in zip(found.sums, right.sums, strict=True):
        assert (one.dtype, one.shape) == (other.dtype, other.shape)
    return list(facts("sums", {**found.sums._asdict(), "samples": found.samples}))


def of_batch(path):
    """The batch that a folder is of."""
    from sss_ref.batch.batch_folder import claim

    assert claim(path.parent, SWEEP) == path.parent
    return list(facts("batch", path.name))


def of_item(path):
    """The record of an item, whose settings are checked where they are used."""
    from sss_ref.batch.item_folder import read_record

    return [(name, content, True) for name, content, _ in facts("item", read_record(path.parent))]


def of_witness(path):
    """A single pixel, judged by its file; its bits may be any, so infinite ones too."""
    from sss_ref.validation.witness.recalling import Standing, recalled
    from sss_ref.validation.witness.stand_alone import stand_alone
    from sss_ref.validation.witness.witness_record import read_record

    record = read_record(path)
    found = recalled(record, str(path))
    standing = Standing.of(record, found.situation.stage)
    told = (found.outcome, found.got.tobytes(), found.reach.tobytes(), standing.other, stand_alone(found))
    return [("witness", told, True)]


def of_mask(path):
    """The pixels that a mask leaves out."""
    from sss_ref.dump.selection import read_exclusion

    scene = dumped_scene()
    return list(facts("mask", read_exclusion(path, scene.settings.camera.width, scene.settings.camera.height)))


def of_results(path):
    """How two folders of buffers differ; NaN in them is the shader's."""
    from sss_ref.results.diff import diff

    return [("results", repr(diff(path.parent, path.parents[1] / "b")), True)]


def of_pictures(path):
    """The surfaces of a folder of pictures without names."""
    from sss_ref.capture.surfaces import surfaces_of

    surfaces, notes = surfaces_of(path.parent)
    found = [(each.path.name, each.content, each.channels, each.is_blank, each.is_even) for each in surfaces]
    return [("pictures", (found, len(notes)), True)]


def of_notebook(path):
    """The code of a notebook that a student hands in."""
    from sss_ref.course.notebook_file import code_cells

    return list(facts("notebook", code_cells(path.read_bytes().decode("utf-8", "replace"), str(path))))


def of_course(path):
    """What a student's folder was given before."""
    from sss_ref.course.own_folder import written_before

    return list(facts("course", written_before(path.parent)))


def of_shader(path):
    """What the user's shaders say that they write, in the language that they are in."""
    from sss_ref.blame.stacks import WGSL as IN_WGSL
    from sss_ref.blame.stacks import language_of
    from sss_ref.gl.shaders import shader_folder, user_shaders
    from sss_ref.interpret.shader.glsl import GLSL
    from sss_ref.interpret.shader.wgsl import WGSL
    from sss_ref.scene.catalogue import method_of

    settings = dumped_scene().settings
    files = shader_folder(path.parent, settings)
    dialect = WGSL if language_of(files) == IN_WGSL else GLSL
    passes = {each.name: each for each in method_of(settings).passes}
    pairs = [pair for name, own in files.items() for pair in user_shaders(passes[name], own, {}, dialect)]
    return list(facts("shader", [(pair.fragment, pair.outputs) for pair in pairs]))


RECORD_KINDS = {
    "material": of_material,
    "tally": of_tally,
    "sums": of_sums,
    "batch": of_batch,
    "item": of_item,
    "witness": of_witness,
    "mask": of_mask,
    "results": of_results,
    "pictures": of_pictures,
    "notebook": of_notebook,
    "course": of_course,
    "shader": of_shader,
}
