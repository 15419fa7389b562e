"""The limits of this room are those that the rules tell."""

from told_limits import PLACES, of_a_room, told


def test_limits_are_those_of_the_rules():
    rules, package = of_a_room("errors")
    assert package == rules


def test_every_limit_of_the_rules_is_held():
    assert sorted(told()) == sorted(name for places in PLACES.values() for name, _ in places)
