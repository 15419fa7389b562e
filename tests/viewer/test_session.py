"""What a page has in hand: changes one by one, mistakes included, without a server."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tabs import SMALL

from sss_ref.errors import SceneError, SssRefError
from sss_ref.scene.load import load_scene
from sss_ref.viewer import messages
from sss_ref.viewer.dropped import DroppedFiles
from sss_ref.viewer.menu import menu
from sss_ref.viewer.messages import message_of
from sss_ref.viewer.session import Session, framed, plain, without
from sss_ref.viewer.studio import Studio, starting_point


@pytest.fixture
def session():
    document = starting_point("default", SMALL)
    found = Session(document.data)
    found.accept(found.data, load_scene("default", **SMALL))
    return found


def take(session, kind, **facts):
    session.take(message_of(json.dumps({"kind": kind, **facts})))


def test_a_key_is_set_and_left_to_the_preset_again(session):
    before = session.data
    take(session, "set", key="translucency.x", value=3)
    assert session.data["translucency"] == {"x": 3} and session.version == 1
    take(session, "set", key="translucency.x", value=None)
    assert session.data == before | {"translucency": {}} and session.version == 2
    take(session, "set", key="no.such.table", value=None)
    assert session.data == before | {"translucency": {}}


def test_what_was_started_with_never_changes(session):
    document = starting_point("default", SMALL)
    kept = plain(document.data)
    other = Session(document.data)
    other.accept(other.data, load_scene("default", **SMALL))
    for kind, facts in (("turn", {"right": 1, "up": 0}), ("set", {"key": "lights.0.color", "value": [1, 0, 0]})):
        take(other, kind, **facts)
    assert document.data == kept


@pytest.mark.parametrize("key", ["lights.7.intensity", "lights.x.intensity"])
def test_a_key_that_leads_nowhere_is_refused_and_changes_nothing(session, key):
    before = session.data
    with pytest.raises(SceneError, match=r"expected an index below 2, got"):
        take(session, "set", key=key, value=1)
    assert session.data is before and session.version == 0


def test_a_camera_with_mistakes_is_not_moved(session):
    take(session, "set", key="camera.fov_y", value="wide")
    with pytest.raises(SceneError, match=r"^camera: expected one that can be moved, got one with mistakes; "):
        take(session, "turn", right=0.1, up=0.0)
    take(session, "back")
    take(session, "turn", right=0.1, up=0.0)
    assert session.camera().azimuth == 10.0


def test_moves_add_up_before_anything_is_drawn(session):
    for _ in range(3):
        take(session, "turn", right=0.1, up=0.0)
        take(session, "move_light", light=0, right=0.1, up=0.0, behind=False)
    assert session.camera().azimuth == pytest.approx(28 - 54)
    assert session.data["lights"][0]["position"][0] > session.scene.settings.lights[0].position[0] + 1


def test_a_light_on_an_orbit_gets_a_position(session):
    session.data = {**session.data, "lights": [{"azimuth": 10, "elevation": 20, "distance": 4}]}
    session.accept(session.data, load_scene(session.data))
    take(session, "move_light", light=0, right=0.1, up=0.0, behind=False)
    (light,) = session.data["lights"]
    assert set(light) == {"position"}
    assert load_scene(session.data).lights[0].position.tolist() == light["position"]


def test_a_light_that_is_not_there_is_refused(session):
    with pytest.raises(SceneError, match=r"^lights\.5: expected a light that can be moved, got none, or one with mis"):
        take(session, "move_light", light=5, right=0, up=0, behind=False)


def test_the_mesh_is_framed_as_in_a_first_scene(session):
    take(session, "camera", type="free")
    take(session, "fly", right=9, up=0, ahead=0)
    take(session, "frame")
    camera = session.camera()
    assert (camera.type, camera.azimuth, camera.width) == ("orbit", 25.0, 64)
    assert framed(session.scene)["height"] == 64


@pytest.mark.parametrize("value", [7, "all", [], [7, 7], [{"position": "here"}, {}], {"0": {}}])
def test_lights_with_mistakes_are_not_moved(session, value):
    take(session, "set", key="lights", value=value)
    with pytest.raises(SceneError, match=r"^lights\.0: expected a light that can be moved, got "):
        take(session, "move_light", light=0, right=0, up=0, behind=False)


KEYS = [".".join((*table["path"][:1], each["key"])) for table in menu() for each in table["controls"]]
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=4),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=4), inner, max_size=3),
    max_leaves=6,
)
CHANGES = st.fixed_dictionaries(
    {"kind": st.just("set"), "key": st.sampled_from(KEYS) | st.text(max_size=9), "value": JSON}
)
TURN = st.just({"kind": "turn", "right": 0.3, "up": -0.2}) | st.just({"kind": "fly", "right": 1, "up": 0, "ahead": 1})
MOVE = st.just({"kind": "move_light", "light": 1, "right": 1, "up": 0, "behind": True, "factor": 0.1})
OTHER = st.sampled_from(["orbit", "look_at", "free", "orthographic"]).map(lambda kind: {"kind": "camera", "type": kind})


@given(st.lists(CHANGES | TURN | MOVE | OTHER, max_size=6))
@settings(max_examples=150)
def test_whatever_a_page_says_the_worst_is_one_of_our_errors(tmp_path_factory, said):
    document = starting_point("default", SMALL)
    studio = Studio(document, DroppedFiles(tmp_path_factory.mktemp("files")))
    session = Session(document.data)
    session.accept(session.data, studio.scene(session.data))
    for facts in said:
        try:
            session.take(message_of(json.dumps(facts)))
            session.accept(session.data, studio.scene(session.data))
        except SssRefError as error:
            assert str(error)


def test_no_scene_yet_and_nothing_moves():
    with pytest.raises(SceneError, match=r"^scene: expected one that can be drawn, got none yet; "):
        take(Session(starting_point("default", SMALL).data), "turn", right=0, up=0)


def test_every_kind_of_message_is_read_and_no_other_key():
    kinds = [each.model_fields["kind"].annotation.__args__[0] for each in messages.Message.__subclasses__()]
    assert len({*kinds}) == len(kinds) == 15
    assert [message_of(json.dumps({"kind": kind})).kind for kind in ("frame", "back", "drawn")] == [
        "frame",
        "back",
        "drawn",
    ]
    for kind in kinds:
        with pytest.raises(SceneError, match=r"^message: "):
            message_of(json.dumps({"kind": kind, "surplus": 1}))


def test_keys_are_taken_out_of_tables_and_arrays():
    tables = {"a": {"b": 1, "c": 2}, "l": [{"x": 1}, {"x": 2}]}
    assert without(tables, ["a", "b"]) == {"a": {"c": 2}, "l": tables["l"]}
    assert without(tables, ["l", "1", "x"]) == {"a": tables["a"], "l": [{"x": 1}, {}]}
    for path in (["z"], ["l", "5", "x"], ["l", "1"], ["a", "b", "c"]):
        assert without(tables, path) == tables
