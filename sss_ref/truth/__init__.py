"""How light really goes: random walks through a body, with the standard error of every number.

    from sss_ref.truth.searchlight import searchlight
    from sss_ref.truth.media import volumes
    red, green, blue = volumes("skin1")
    profile = searchlight(red, photons=1_000_000)
    profile.share, profile.share_error, profile.quantile(0.5)

`numerics.random_numbers` and `samplers` give what a walk draws, `photon` walks one, `counting` counts many and `tally`
keeps the counts, in any number of threads with the same bits. `searchlight` and `slab` are what is counted; `dipole`,
`burley_fit` and `chandrasekhar` are the formulas it is held against, `small_feature` says what an error means.
"""
