package org.sami.crw.cli.analysis;

import java.util.function.BooleanSupplier;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.petri.graph.GraphWatch;

/** Shows on the terminal how far a search of a net is, and lets Ctrl-C end it. */
final class SearchProgress {
    private SearchProgress() {}

    static GraphWatch watch(ProgressDisplay progress, BooleanSupplier isStopped) {
        return new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                progress.show(() -> states + " states looked at, " + waiting + " known and waiting");
            }

            @Override
            public boolean isCancelled() {
                return isStopped.getAsBoolean();
            }
        };
    }
}
