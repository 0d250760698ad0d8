package org.sami.crw.gui.decision;

import java.util.List;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoSketch;

/** Where on the main map a decision is seen. On the event thread. */
public interface DecisionMap {
    /** There is no map. */
    DecisionMap NONE = new DecisionMap() {
        @Override
        public void show(DecisionPresentation decision, List<Value> values) {}

        @Override
        public void clear() {}

        @Override
        public void draw(GeoSketch sketch, Runnable ended) {}
    };

    /**
     * Highlights what a decision speaks of, and dims everything else.
     *
     * @param values what is chosen or filled in so far
     */
    void show(DecisionPresentation decision, List<Value> values);

    /** Highlights nothing, and ends drawing: no decision is shown. */
    void clear();

    /**
     * Lets the operator draw on the map, until it is ended there or another decision is shown.
     *
     * @param ended is told when the operator has ended it
     */
    void draw(GeoSketch sketch, Runnable ended);
}
