"""What a run shares with its caller: stages, progress, the request to stop."""
import threading

import advlayers_core as core
import pytest
from core_meshes import mesh, mesher, model, shape_text

STAGES = ["", "read", "boundary", "triangulate", "layers", "core"]


def test_the_stages_follow_each_other_and_their_shares_rise():
    context = core.RunContext()
    seen = [context.progress]
    shape = core.read_brep(shape_text("bracket"), 0.0, context)
    seen.append(context.progress)
    run = core.Mesher(shape, core.Settings(size=1.0, first_height=0.1), context)
    for _ in run:
        seen.append(context.progress)
    run.result()
    seen.append(context.progress)
    stages = [stage for stage, _ in seen]
    assert stages == sorted(stages, key=STAGES.index)
    assert set(stages) == {"", "read", "layers", "core"}
    shares = [share for stage, share in seen if stage == "layers"]
    assert shares == sorted(shares) and 0.0 <= shares[0] and shares[-1] == 1.0
    assert seen[-1] == ("core", 1.0)
    assert list(context.seconds) == STAGES[1:]
    assert all(seconds > 0.0 for seconds in context.seconds.values())


def test_a_cancelled_run_reads_nothing_and_makes_no_mesher(tmp_path):
    path = tmp_path / "box.brep"
    path.write_text(shape_text("box"))
    context = core.RunContext()
    assert not context.cancelled
    context.cancel()
    assert context.cancelled
    with pytest.raises(core.Cancelled):
        core.read_brep(shape_text("box"), 0.0, context)
    with pytest.raises(core.Cancelled):
        core.read_file(path, context=context)
    with pytest.raises(core.Cancelled):
        next(core.Mesher(model("box"), core.Settings(size=1.0, first_height=0.1), context))


def test_a_mesher_stops_with_its_context():
    context = core.RunContext()
    run = core.Mesher(model("box"), core.Settings(size=1.0, first_height=0.1), context)
    next(run)
    context.cancel()
    with pytest.raises(core.Cancelled):
        next(run)
    other = mesher("box")
    next(other)
    other.cancel()
    with pytest.raises(core.Cancelled):
        other.result()


def test_a_mesher_is_made_of_a_model_and_settings():
    settings = core.Settings(size=1.0, first_height=0.1)
    with pytest.raises(TypeError):
        core.Mesher(None, settings)
    with pytest.raises(TypeError):
        core.Mesher(model("box"), None)


def test_result_runs_the_loop_where_nobody_did():
    looped, alone = mesh("square"), mesher("square").result()
    assert alone.layer_of_quad.max() > 1
    assert alone.nodes.tobytes() == looped.nodes.tobytes()
    assert alone.quads.tobytes() == looped.quads.tobytes()


def test_threads_that_ask_for_the_result_get_the_same_one():
    run = mesher("bracket", size=0.5)
    results = []
    threads = [threading.Thread(target=lambda: results.append(run.result())) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4 and all(result is results[0] for result in results)
