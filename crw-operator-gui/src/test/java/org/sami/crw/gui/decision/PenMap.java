package org.sami.crw.gui.decision;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoSketch;

/** A large map of which the test says whether it is shown and free, and on which the test does what an operator would. */
final class PenMap implements DecisionMap {
    boolean seen;
    boolean free = true;
    Optional<GeoSketch> sketch = Optional.empty();
    Optional<BoatPick> pick = Optional.empty();
    Consumer<PenEnd> ended = end -> {};
    String said = "";

    /** The operator ends what the pen does there. */
    void end(PenEnd end) {
        putDown();
        ended.accept(end);
    }

    @Override
    public void show(DecisionPresentation decision, List<Value> values) {}

    @Override
    public void clear() {}

    @Override
    public boolean isSeen() {
        return seen;
    }

    @Override
    public boolean isFree() {
        return free;
    }

    @Override
    public void draw(GeoSketch drawn, Consumer<PenEnd> told) {
        sketch = Optional.of(drawn);
        ended = told;
    }

    @Override
    public void pick(BoatPick boats, Consumer<PenEnd> told) {
        pick = Optional.of(boats);
        ended = told;
    }

    @Override
    public void putDown() {
        sketch = Optional.empty();
        pick = Optional.empty();
    }

    @Override
    public void focus() {}

    @Override
    public void say(String words) {
        said = words;
    }
}
