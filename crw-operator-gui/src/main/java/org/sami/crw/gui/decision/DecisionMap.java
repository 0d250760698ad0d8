package org.sami.crw.gui.decision;

import java.util.List;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.value.Value;

/** Where on the main map a decision is seen. On the event thread. */
public interface DecisionMap {
    /** There is no map. */
    DecisionMap NONE = new DecisionMap() {
        @Override
        public void show(DecisionPresentation decision, List<Value> values) {}

        @Override
        public void clear() {}
    };

    /**
     * Highlights what a decision speaks of, and dims everything else.
     *
     * @param values what is chosen or filled in so far
     */
    void show(DecisionPresentation decision, List<Value> values);

    /** Highlights nothing: no decision is shown. */
    void clear();
}
