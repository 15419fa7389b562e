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
# # 10. Diffusion: a photon walks
#
# > **Aims.** Walk photons through skin, say how sure a counted share is, and know profile, dipole and albedo
# > inversion. **Before.** Lesson 4. **Time.** 15 minutes.
#
# The paper blurs a picture and multiplies it by $x^y/d^{0.6}$. Both imitate one thing: light goes into a body,
# loses its way, and comes out somewhere else. To be right, "you have to simulate every individual light ray and
# calculate its path through a material", which is too slow for real time (paper 1.1). Here we do it, for it is
# twenty lines, and get the curve that every blur is an imitation of.

# %%
import numpy as np

from sss_ref.course import checks, diffusion_figures, figures
from sss_ref.truth.chandrasekhar import half_space_reflectance
from sss_ref.truth.dipole import dipole, dipole_density, dipole_reflectance
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume
from sss_ref.truth.searchlight import searchlight

COLORS = ("red", "green", "blue")
generator = np.random.default_rng(10)

# %% [markdown]
# ## What a material is
#
# Two numbers for each colour. On every millimetre light is scattered with the coefficient $\sigma_s'$ and absorbed
# with $\sigma_a$. Together they are the extinction $\sigma_t = \sigma_s' + \sigma_a$: a photon goes straight for a
# length $t$ with the density
#
# $$p(t) = \sigma_t\, e^{-\sigma_t t}, \qquad \text{on average } \ell = \frac{1}{\sigma_t},$$
#
# the *mean free path*. Then it is scattered with the probability $\alpha = \sigma_s'/\sigma_t$, the *albedo* of one
# event, or absorbed. (The prime says *reduced*: tissue scatters forwards, and $\sigma_s' = \sigma_s (1 - g)$ with
# the mean cosine $g$ is what an even scattering would need to turn light round as fast.) Skin, as Jensen et al.
# measured it:

# %%
skin = dict(zip(COLORS, volumes("skin1"), strict=True))
for name, (scattering, absorption, _, _) in skin.items():
    extinction = scattering + absorption
    free_path, albedo = 1 / extinction, scattering / extinction
    print(f"{name:5}: mean free path {free_path:.2f} mm, albedo {albedo:.3f}, {1 / (1 - albedo):.0f} events in a life")

# %% [markdown]
# Blue meets something twice as often as red, and does not survive it. That is all there is to the colour of skin.
#
# ## One photon
#
# It comes from above, straight down. Each line of the loop is one of the sentences above.


# %%
def directions(count):
    """Unit vectors (count, 3), evenly in all directions."""
    cosine, turn = generator.uniform(-1, 1, count), generator.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(turn), sine * np.sin(turn), cosine], axis=-1)


# %%
def one_path(scattering, absorption):
    """The places (N, 3) of a photon, mm, z down; the last one is above the skin, or where it was absorbed."""
    path, direction = [np.zeros(3)], np.array([0.0, 0.0, 1.0])
    while path[-1][2] >= 0:
        path.append(path[-1] + direction * generator.exponential(1 / (scattering + absorption)))
        if generator.random() >= scattering / (scattering + absorption):
            break
        direction = directions(1)[0]
    return np.array(path)


# %%
_, axes = figures.row(3, height=3.0, width=3.3)
for panel, (name, volume) in zip(axes, skin.items(), strict=True):
    paths = [one_path(volume.scattering, volume.absorption) for _ in range(60)]
    out = diffusion_figures.paths(panel, paths, reach=6.0)
    panel.set(title=f"{name}: {out} of 60 come out")

# %% [markdown]
# A line ends above the skin, or with a dot where the photon was absorbed. Red wanders for millimetres; blue either
# turns back at once or is lost.
#
# ## BSSRDF and profile
#
# What light does between going in and coming out has a name, the *bidirectional scattering-surface reflectance
# distribution function*: how much of what falls on $x_i$ from $\omega_i$ leaves at $x_o$ towards $\omega_o$.
#
# $$L_o(x_o, \omega_o) = \int_A \int_{2\pi} S(x_i, \omega_i; x_o, \omega_o)\, L_i(x_i, \omega_i) \cos\theta_i
# \, d\omega_i\, dA$$
#
# A BRDF, Phong's too, is the case in which all of it leaves where it came in. $S$ has eight dimensions. Jensen et
# al. (2001) keep one: after many events light has forgotten where it came from, it "is effectively isotropic"
# (paper 2), so on a flat body only the distance $r = |x_o - x_i|$ counts. What is left is the **profile** $R(r)$,
# the share that comes out per square millimetre at distance $r$ from a thin beam. A blur kernel is a picture of it.
#
# ## Fifty thousand photons
#
# The same loop for all photons at once. What has left is taken back to the surface, what is absorbed is dropped.


# %%
def left_at(scattering, absorption, photons):
    """Where photons of a beam leave again (N, 2), mm."""
    extinction, left = scattering + absorption, []
    at, direction = np.zeros((photons, 3)), np.tile([0.0, 0.0, 1.0], (photons, 1))
    while len(at):
        ahead = at + direction * generator.exponential(1 / extinction, (len(at), 1))
        out = ahead[:, 2] < 0
        left.append(at[out, :2] - direction[out, :2] * (at[out, 2:] / direction[out, 2:]))
        goes_on = ~out & (generator.random(len(at)) < scattering / extinction)
        at, direction = ahead[goes_on], directions(goes_on.sum())
    return np.concatenate(left)


# %% [markdown]
# How sure is a share $p$ that was counted among $n$ photons? Each photon is a toss, so its standard error is
#
# $$\epsilon = \sqrt{\frac{p\,(1 - p)}{n}}.$$
#
# Beside it `searchlight`, the package's walk, which has other random numbers and no line in common with ours, and
# Chandrasekhar's exact solution (1950). The border is left out for now (`ior=1`): light does not notice the
# surface.

# %%
photons = 50_000
for name, volume in skin.items():
    share = len(left_at(volume.scattering, volume.absorption, photons)) / photons
    error = np.sqrt(share * (1 - share) / photons)
    theirs = searchlight(volume._replace(ior=1.0), photons)
    exact = half_space_reflectance(volume.scattering / (volume.scattering + volume.absorption))
    print(f"{name:5}: {share:.4f} ± {error:.4f}; searchlight {theirs.reflectance:.4f}; exact {exact:.4f}")
    assert abs(share - exact) < 4 * error and abs(theirs.reflectance - exact) < 4 * error

# %% [markdown]
# Three answers, one number. Where they come out should agree as well: the radius within which half of them do.

# %%
red = skin["red"]._replace(ior=1.0)
radius = np.hypot(*left_at(red.scattering, red.absorption, photons).T)
theirs = searchlight(red, photons)
for share in (0.25, 0.5, 0.75, 0.9):
    ours, error = np.quantile(radius, share), theirs.quantile_error(share)
    print(f"{share:.0%} of red within {ours:.2f} mm; searchlight {theirs.quantile(share):.2f} ± {error:.2f} mm")
    assert abs(ours - theirs.quantile(share)) < 4 * np.sqrt(2) * error

# %% [markdown]
# ## The profile, and the dipole beside it
#
# From here on with skin's border, index 1.3: inside, much of the light that wants out is thrown back. Jensen's
# **dipole** is the classic formula for $R$. Light scatters first at one depth, the mean free path, and diffuses
# from there; a second, negative source above the skin lets the light vanish that leaves. With $d$ the distance to a
# source, $z$ its height and $\sigma_{tr} = \sqrt{3 \sigma_a \sigma_t}$,
#
# $$R(r) = \frac{\alpha}{4\pi} \sum_{\text{both}} z\,(\sigma_{tr} d + 1)\, \frac{e^{-\sigma_{tr} d}}{d^3}.$$

# %%
profiles = {name: searchlight(volume, 200_000) for name, volume in skin.items()}
_, (panel,) = figures.row(1, height=3.8, width=6.6)
r = np.linspace(0.02, 8, 400)
for color, (name, profile) in zip(figures.CHANNELS, profiles.items(), strict=True):
    diffusion_figures.profile(panel, profile, color, name)
    panel.plot(r, dipole_density(dipole(skin[name]), r), color=color, linestyle="--", linewidth=1.2)
_ = panel.set(title="Skin: the walk (lines, with ± 2 errors) and the dipole (dashed)", xlim=(0, 8), ylim=(1e-5, 3))

# %% [markdown]
# Far away the dipole is right, and near the beam it is not: it has all light begin a free path below. Sums hide
# that:

# %%
for name, profile in profiles.items():
    source, walked = dipole(skin[name]), profile.reflectance
    off, error = dipole_reflectance(source) / walked - 1, profile.reflectance_error / walked
    by_walk = np.interp([0.1, 0.25], *diffusion_figures.ringed(profile)[:2])
    near = dipole_density(source, np.array([0.1, 0.25])) / by_walk
    print(f"{name:5}: in all {walked:.3f}, dipole {off:+.1%} ± {error:.1%}; at .1 and .25 mm it has", near.round(2))
    assert near[0] < 0.4

# %% [markdown]
# (By two million photons: -0.9, +6.7 and +13.6 %.) The errors grow with absorption: diffusion wants many events in
# a life, and blue has three.
#
# What the curves look like on skin, if the beam is white. The steep middle and the long red tail are what a
# Gaussian does not have, and why the paper's kernel has three rings of taps.

# %%
x = np.linspace(-5, 5, 301)
r = np.hypot(*np.meshgrid(x, x))
walked = np.dstack([np.interp(r, *diffusion_figures.ringed(each)[:2]) for each in profiles.values()])
by_dipole = np.dstack([dipole_density(dipole(volume), r) for volume in skin.values()])
_, axes = figures.row(2, height=3.4)
figures.picture(axes[0], 12 * walked, "a white beam on skin, 10 mm across")
figures.picture(axes[1], 12 * by_dipole, "the same, by the dipole")

# %% [markdown]
# ## How far is far?
#
# A kernel's size is best told in quantiles: the radius within which half, or nine tenths, of what comes out does
# so.

# %%
for name, profile in profiles.items():
    half, most = profile.quantile(0.5), profile.quantile(0.9)
    print(f"{name:5}: half within {half:.2f} mm, nine tenths within {most:.2f} mm")
assert profiles["red"].quantile(0.5) > 5 * profiles["blue"].quantile(0.5)

# %% [markdown]
# ## From albedo to colour, and back
#
# One event of red skin keeps 96 % of the light, and the body gives back less than half. The curve from the albedo
# $\alpha$ to the reflectance $A$ is steep at its end. An artist paints $A$, a walk needs $\alpha$: so the curve has
# to be read backwards, the **albedo inversion** that every renderer has. A handy one is van de Hulst's, $\alpha
# \approx 1 - \left(\frac{1 - A}{1 + 2A}\right)^2$.

# %%
albedo = np.linspace(0.02, 0.999, 60)
exact = np.array([half_space_reflectance(each) for each in albedo])
handy = np.linspace(0, 0.97, 200)
_, (panel,) = figures.row(1, height=3.2, width=4.6)
panel.plot(albedo, exact, color=figures.BLUE, label="exact")
panel.plot(1 - ((1 - handy) / (1 + 2 * handy)) ** 2, handy, "--", color=figures.AMBER, label="van de Hulst")
panel.set(title="A half-space without border", xlabel="albedo of one event", ylabel="reflectance")
_ = panel.legend()

# %% [markdown]
# ## Your own material
#
# `scattering` and `absorption` per millimetre. Watch the spot: more scattering makes it smaller, more absorption
# smaller *and* darker. Whole milk is near 3 and 0.002.


# %%
def material(scattering, absorption):
    profile = searchlight(Volume(scattering, absorption, 0.0, 1.3), 20_000)
    figure, (spot, curve) = figures.row(2, height=3.2, width=3.7)
    shown = np.interp(r, *diffusion_figures.ringed(profile)[:2])
    figures.picture(spot, 12 * np.dstack([shown] * 3), "a beam, 10 mm across")
    diffusion_figures.profile(curve, profile, figures.BLUE, f"half within {profile.quantile(0.5):.2f} mm")
    curve.set(title=f"{profile.reflectance:.0%} comes out again", xlim=(0, 5), ylim=(1e-4, 10))
    return figure


figures.Sliders(material, scattering=(0.2, 0.74, 4.0), absorption=(0.002, 0.03, 0.5))

# %% [markdown]
# ## Exercises
#
# **1.** Computers draw numbers evenly between 0 and 1. Turn such a number, `chance`, into the length of a free path
# in a material with this `extinction`, per mm.


# %%
def free_path(chance, extinction):
    return chance / extinction  # change this line


checks.verdict(checks.free_path, free_path)

# %% [markdown]
# **2.** You want a share, of about `share`, to be known to the relative error `relative`: 0.01 means that the
# standard error is a hundredth of the share. How many photons does that take?


# %%
def photons_needed(share, relative):
    return 1 / relative**2  # change this line


checks.verdict(checks.photons_needed, photons_needed)

# %% [markdown]
# **3.** Invert the albedo: `half_space_reflectance(albedo)` is the exact curve above. Return the albedo of the
# half-space that gives back `reflectance`, to a thousandth. Van de Hulst's formula is not as exact.


# %%
def albedo_of(reflectance):
    return reflectance  # change this line


checks.verdict(checks.albedo_of, albedo_of)

# %% [markdown]
# ## Read on
#
# - H. W. Jensen, S. R. Marschner, M. Levoy and P. Hanrahan, "A Practical Model for Subsurface Light Transport"
#   (2001): the paper's [JMLH01], with the dipole, a term for light that scatters once, and the measured table that
#   skin1 is from.
# - P. Christensen and B. Burley, "Approximate Reflectance Profiles for Efficient Subsurface Scattering" (2015): two
#   exponentials that are nearer to a walk than the dipole is, with nothing to invert.
# - The page *The truth* of the documentation: how the package walks with the same bits on every machine, and what
#   it is held against.
