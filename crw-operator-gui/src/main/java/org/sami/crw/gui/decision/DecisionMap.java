package org.sami.crw.gui.decision;

import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoSketch;

/** The large map, on which a decision is seen and answered. On the event thread. */
public interface DecisionMap {
    /** There is no map. */
    DecisionMap NONE = new DecisionMap() {
        @Override
        public void show(DecisionPresentation decision, List<Value> values) {}

        @Override
        public void clear() {}

        @Override
        public boolean isSeen() {
            return false;
        }

        @Override
        public boolean isFree() {
            return false;
        }

        @Override
        public void draw(GeoSketch sketch, Consumer<PenEnd> ended) {}

        @Override
        public void pick(BoatPick boats, Consumer<PenEnd> ended) {}

        @Override
        public void putDown() {}

        @Override
        public void focus() {}

        @Override
        public void say(String words) {}
    };

    /** How the pen came to be put down. */
    enum PenEnd {
        /** The operator is done: Enter or a double click. */
        DONE,
        /** The operator put it down: Escape. */
        PUT_DOWN,
        /** Something else begins on the map, such as sending boats by hand. */
        INTERRUPTED
    }

    /**
     * Highlights what a decision speaks of, and dims everything else.
     *
     * @param values what is chosen or filled in so far
     */
    void show(DecisionPresentation decision, List<Value> values);

    /** Highlights nothing: no decision is shown. */
    void clear();

    /** Whether the map is shown, so that one can answer there. */
    boolean isSeen();

    /** Whether nothing else is being done on it, or was a moment ago: no pen may come between. */
    boolean isFree();

    /**
     * Gives the operator a pen for a sketch, until it is put down.
     *
     * @param ended is called when it was put down on the map
     */
    void draw(GeoSketch sketch, Consumer<PenEnd> ended);

    /** Lets clicks and boxes on the map choose boats for the answer, likewise. */
    void pick(BoatPick boats, Consumer<PenEnd> ended);

    /** Puts the pen down without a notification. Does nothing where none is out. */
    void putDown();

    /** Brings the keyboard's focus to the map. */
    void focus();

    /** Shows a line on the map while no other is shown there; empty for none. */
    void say(String words);
}
