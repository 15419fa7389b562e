"""Object code that is linked: found by its names, and by none that it has not."""

import ctypes

from numba.core import registry

from sss_ref.cache.linked import address_of_linked, link, make_known
from sss_ref.cache.object_files import compiled_module

CALLER = "declare double @{0}(double)\ndefine double @{0}_twice(double %x) {{\n{1}ret double %b\n}}"
CALLS = "%a = call double @{0}(double %x)\n%b = call double @{0}(double %a)\n"


def linked(text):
    """A module, linked."""
    link(compiled_module(text, registry.cpu_target.target_context.codegen().magic_tuple()))


def test_a_name_that_nothing_has_is_at_0():
    linked("define i32 @test_linked_seven() {\nret i32 7\n}")
    assert address_of_linked("test_linked_eight") == 0
    assert ctypes.CFUNCTYPE(ctypes.c_int32)(address_of_linked("test_linked_seven"))() == 7


def test_what_is_known_may_be_called():
    kind = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)
    tripled = kind(lambda x: 3 * x)
    make_known("test_linked_tripled", ctypes.cast(tripled, ctypes.c_void_p).value)
    linked(CALLER.format("test_linked_tripled", CALLS.format("test_linked_tripled")))
    assert kind(address_of_linked("test_linked_tripled_twice"))(1.5) == 13.5
