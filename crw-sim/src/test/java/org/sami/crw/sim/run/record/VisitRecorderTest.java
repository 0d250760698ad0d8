package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.report.LocationResult;

/** Which visit of a location counts. */
class VisitRecorderTest {
    @Test
    void theEarliestVisitCountsInWhateverOrderVisitsBecomeKnown() {
        VisitRecorder inOrder = told(1000, "anna", 1200, "bert");
        VisitRecorder theOtherWayRound = told(1200, "bert", 1000, "anna");

        assertThat(inOrder.locations()).isEqualTo(theOtherWayRound.locations());
        LocationResult location = inOrder.locations().get(0);
        assertThat(location.visitedBy()).isEqualTo("anna");
        assertThat(location.visitedAtMillis()).hasValue(1000);
        assertThat(theOtherWayRound.visited()).isEqualTo(1);
    }

    private static VisitRecorder told(long firstMs, String first, long secondMs, String second) {
        VisitRecorder visits = new VisitRecorder();
        visits.add(45.4, 10.9, 0, 0);
        visits.visited(45.4, 10.9, firstMs, first);
        visits.visited(45.4, 10.9, secondMs, second);
        return visits;
    }
}
