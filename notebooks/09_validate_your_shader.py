# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # 9. Validate your shader
#
# > **Aims.** Find the stage of a shader that is wrong from the buffers it drew, and tell why. **Before.** Lessons 5
# > and 8. **Time.** 60 minutes.
#
# You have written the paper's shaders, and they draw something that looks right. Are they? This notebook plays a
# graphics processor with one mistake in its shaders, and finds the mistake from nothing but the buffers it drew.

# %%
from dataclasses import replace

import numpy as np

import sss_ref
from sss_ref.course import checks, figures, small_scenes, together
from sss_ref.course.dumps import three_dumps
from sss_ref.language import dot, max, normalize, select, vec3
from sss_ref.passes.irradiance import Irradiance
from sss_ref.results.diff import differing_pixels

HEAD = "bust"
SIZE = 256
PATIENT = sss_ref.Scope(seconds=600)  # for explanations, which take seconds; a slow machine may take its time

# %% [markdown]
# ## It looks right
#
# Somebody typed 0.61 for the exponent 0.6 of $x^y / d^{0.6}$. All the "processor" hands over is its buffers.

# %%
scene = small_scenes.load("figure3_with", HEAD, SIZE, **small_scenes.BY_THE_TEXT)
oracle = sss_ref.render(scene)
mistyped = small_scenes.load("figure3_with", HEAD, SIZE, **(small_scenes.BY_THE_TEXT | {"translucency.exponent": 0.61}))
dump = dict(sss_ref.render(mistyped).buffers)


# %%
def side_by_side(dump, limit):
    _, axes = figures.row(3, height=3.1, width=3.3)
    figures.picture(axes[0], oracle.image, "The oracle")
    figures.picture(axes[1], dump["image"], "The processor")
    gap = (dump["image"] - oracle.image).mean(axis=-1)
    figures.difference(axes[2], gap, "processor minus oracle", "linear", oracle["coverage"], limit)
    square = (dump["image"] - oracle.image) ** 2
    print(f"root of the mean square difference: {np.sqrt(square.mean()):.2g}")


side_by_side(dump, 0.005)

# %% [markdown]
# No eye tells the two apart; only the third picture shows them, and its colours end at 0.005. A number for the whole
# picture says that hardly anything is wrong. A threshold on
# such a number either lets this pass or rejects processors that merely round differently.
#
# ## Ask stage by stage
#
# `validate` gives every stage what the *processor* had before it, and asks whether what the processor made of it is
# something that a right one may have made: inside the interval of notebook 8. The first stage that fails is where the
# mistake is. Then it tries out what would explain it, on the very pixels: other numbers for each uniform, other stages,
# every small change to the source.

# %%
report = sss_ref.validate(oracle, dump, explain=PATIENT)
print(report.summary)
print(*report.explanations, sep="\n")
assert report.culprit.stage == "translucency_ratio" and "0.61" in report.explanations[0]

# %% [markdown]
# ## The map of the error
#
# The finding holds the buffer of that stage: what came, what was expected, and how far off it may be, the **reach**.
# Their ratio is the error in a unit that means something: below 1, a right processor may do that.


# %%
def error_map(check):
    apart = np.abs(check.got.astype(np.float64) - check.expected)
    ratio = apart / np.maximum(check.reach, 1e-12)
    wrong = check.where & (apart > check.reach)
    _, (left, right) = figures.row(2, height=3.4, width=4.2)
    figures.values(left, check.got, f"{check.buffer} as drawn", check.buffer, check.where)
    decades = np.log10(np.maximum(ratio, 1))
    figures.values(right, decades, "How far out of reach", "log10 of error/reach", wrong)


error_map(report.finding.check)

# %% [markdown]
# Wrong are the pixels into which light comes through the body; where it falls directly, $T$ needs no $d$. And the
# dark lines are thicknesses near 1, for $1^{0.61} = 1^{0.6}$. An error map often tells as much as the explanation.
#
# ## Consequences
#
# The processor's `lit`, `scattered` and `image` differ from the oracle's as well. Compared buffer by buffer, as one
# usually does, four are wrong, and nothing says what went wrong in which. Judged by what each stage was given, one is:
# the stages after it did the right thing with a wrong number.


# %%
def consequences(dump, report):
    names = [verdict.buffer for verdict in report.verdicts]
    compared = np.array([verdict.compared for verdict in report.verdicts])
    differing = [np.count_nonzero(differing_pixels(dump[name], oracle[name])) for name in names]
    chained = np.array(differing) / compared
    rebased = 1 - np.array([verdict.within for verdict in report.verdicts]) / compared
    lines = {"other than the oracle's": chained, "out of reach, given what was drawn before": rebased}
    figures.shares(names, lines, "% of the pixels of each buffer, in the order of the stages")
    return np.count_nonzero(chained), np.count_nonzero(rebased)


assert consequences(dump, report) == (4, 1)

# %% [markdown]
# ## A mistake in the source
#
# Numbers are easy. `mutants` lists mistakes that people make in the source of a stage: a forgotten `normalize`, a sign,
# two swapped operands. `with_stage` lets the "processor" run one of them. Here Phong's direction to the light has lost
# the position of the surface, as if the light were far away; the picture still looks like a head in the light.

# %%
from sss_ref.passes import phong
from sss_ref.validation.cause.mutants import mutants


def drawn_with(stage, wrong):
    """The buffers of a processor on which one line of a stage is wrong."""
    body = next(mutant.body for mutant in mutants(stage) if mutant.wrong == wrong)
    faulty = sss_ref.with_stage(scene, stage.name, replace(stage, body=body))
    return dict(sss_ref.render(faulty).buffers)


# %%
dump = drawn_with(phong.phong_shading, "to_light = normalize(light_position)")
side_by_side(dump, 0.2)

# %%
report = sss_ref.validate(oracle, dump, explain=PATIENT)
print(report.summary)
print(*report.explanations, sep="\n")
assert report.culprit.stage == "phong_shading"
assert any("`to_light = normalize(light_position)`" in each for each in report.explanations)

# %% [markdown]
# A value that may be any number tells much: of all that was tried, one mistake gives the numbers of all these pixels.
# Where a stage says only yes or no, as the shadow test does, several may fit, and no buffer can tell them apart; you
# know which one your source can contain. And again only one stage is to blame for all the buffers that differ:

# %%
differing, wrong = consequences(dump, report)
assert differing > 3 and wrong == 1

# %% [markdown]
# ## What validation cannot see
#
# *A mistake that the scene does not provoke.* Phong's highlight needs the light in front of the surface. Drop that
# condition, and this scene's buffers stay the same, to the bit. Validate with more than one scene, and with a light at
# grazing angles.

# %%
dump = drawn_with(phong.phong_shading, "visible = mirrored > 0.0")
assert sss_ref.validate(oracle, dump).passed

# %% [markdown]
# *A buffer that is not there.* What you do not dump comes from the oracle. With the last picture alone, the last stage
# gets the blame for whatever happened before it; with one more buffer, the search moves closer.

# %%
dump = dict(sss_ref.render(mistyped).buffers)
for given in (["image"], ["lit", "image"], ["translucency", "lit", "image"]):
    culprit = sss_ref.validate(oracle, {name: dump[name] for name in given}, explain=False).culprit
    print(f"given {', '.join(given)}: {culprit.stage}")
assert culprit.stage == "translucency_ratio"

# %% [markdown]
# With your own renderer: save each buffer as `NAME.npy` into a folder and run `sss-ref validate`, which does all of
# this and writes a page with the pictures. Without one: `sss-ref webgl figure3_with --judge` writes a page in which
# your browser draws each stage on your own GPU; change a shader there, or plant a mistake, and see which is named.
#
# ## Exercises
#
# ### A line
#
# Three dumps, by processors that promise what Vulkan asks: `dumps["A"].buffers`, and so for B and C. `reference` is
# the oracle's rendering of the same scene. One of the three is right, although its bits are not the oracle's. For each
# of the others name the stage that is wrong.

# %%
reference, dumps = three_dumps(HEAD)
_, axes = figures.row(3, height=3.1)
for panel, (name, each) in zip(axes, dumps.items(), strict=True):
    same = np.mean(~differing_pixels(each.image, reference.image))
    figures.picture(panel, each.image, f"{name}: {same:.0%} of the pixels as the oracle's")


# %%
def answer():
    return {"A": None, "B": None, "C": None}  # None: right; else the name of the wrong stage


checks.verdict(checks.wrong_stages, answer)

# %% [markdown]
# ### A stage
#
# A colleague's Lambert, with two mistakes. A fragment gets light where it is lit directly, and where the shadow map
# knows nothing of it.


# %%
def mended(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    incident_light: vec3,
    directly_lit: bool,
    shadow_valid: bool,
) -> Irradiance:
    to_light = normalize(position_world - light_position)
    facing = max(dot(normal_world, to_light), 0.0)
    return Irradiance(incident_light * select(directly_lit, facing, select(shadow_valid, facing, 0.0)))


checks.verdict(checks.mended_lambert, mended)
together.right_and_yours(checks.mended_lambert, mended, HEAD)

# %% [markdown]
# ### A shader
#
# And the last line of many a renderer: a linear value encoded for a screen (sRGB). Two mistakes here, too; both make a
# picture that looks like one.

# %%
ENCODED = """
float encoded(float linear) {
    return linear <= 0.04045 ? 12.92 * linear : 1.055 * pow(linear, 2.4) - 0.055;
}
"""
checks.verdict(checks.mended_srgb_in_glsl, ENCODED)
