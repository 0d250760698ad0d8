package org.sami.crw.sim.report;

import java.util.List;

/**
 * What people read afterwards: how far missions came by their phase charts, and what the operator did.
 *
 * @param phases of missions whose plans have a chart, in the order of missions and of each chart
 * @param operator oldest first
 */
public record RunLog(List<PhaseResult> phases, List<OperatorAction> operator) {
    /** Nothing. */
    public static final RunLog EMPTY = new RunLog(List.of(), List.of());

    public RunLog {
        phases = List.copyOf(phases);
        operator = List.copyOf(operator);
    }
}
