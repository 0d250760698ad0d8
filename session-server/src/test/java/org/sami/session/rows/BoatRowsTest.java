package org.sami.session.rows;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.value.GeoPoint;

/** What a front is told of where robots are. */
class BoatRowsTest {
    private static BoatSnapshot at(double altM) {
        return new BoatSnapshot(
                "c1",
                LinkState.LINKED,
                OptionalLong.empty(),
                Optional.of(new BoatPose(new GeoPoint(45.7, 10.72, altM), 0, 0, 0)),
                0,
                Optional.empty(),
                Optional.empty(),
                Commander.THIS_BASE,
                Optional.empty(),
                0,
                0,
                new BoatExplanation(false, Cause.NO_COMMAND, "c1 is there"),
                List.of());
    }

    private static ObjectNode row(BoatSnapshot boat) {
        return BoatRows.boats(List.of(boat), List.of(), List.of(), Map.of())
                .rows()
                .get("c1");
    }

    @Test
    void rowOfOneThatFliesHasItsHeight() {
        assertThat(row(at(29.84).flying(true)).path("alt").asDouble()).isEqualTo(29.8);
    }

    @Test
    void rowOfABoatHasNoHeight() {
        assertThat(row(at(0)).has("alt")).isFalse();
    }
}
