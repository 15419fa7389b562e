"""The limits of this room are those that the rules tell."""

from told_limits import of_a_room


def test_limits_are_those_of_the_rules():
    rules, package = of_a_room("course")
    assert package == rules
