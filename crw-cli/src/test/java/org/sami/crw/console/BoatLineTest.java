package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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

/** A robot's line in the list of all. */
class BoatLineTest {
    private static BoatSnapshot at(double altM) {
        return new BoatSnapshot(
                "c1",
                LinkState.LINKED,
                OptionalLong.empty(),
                Optional.of(new BoatPose(new GeoPoint(45.7005, 10.72, altM), 0, 0, 0)),
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

    @Test
    void copterIsSaidToBeAsHighAsItIs() {
        assertThat(BoatCommands.line(at(29.8).flying(true), 0))
                .isEqualTo("c1  link linked  0.0 m/s  45.70050,10.72000  30 m high  c1 is there");
    }

    @Test
    void boatHasNoHeight() {
        assertThat(BoatCommands.line(at(0), 0)).isEqualTo("c1  link linked  0.0 m/s  45.70050,10.72000  c1 is there");
    }
}
