package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A boat that drives along a list of this base, which has no command for it, is stopped once its link is back. */
class UnwantedDriveTest {
    private static final GeoPoint HERE = GeoPoint.of(45, 10);
    private static final String EARLIER = "c#base.0.7";

    private final ScriptedBoat boat = new ScriptedBoat(event -> {});

    private void comesBack(String list, boolean completed) {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress(list, 1, completed));
    }

    private long stops() {
        return boat.said.stream()
                .filter(StopMotors.class::isInstance)
                .map(message -> ((StopMotors) message).commandId())
                .distinct()
                .count();
    }

    @Test
    void aListOfThisStartIsStoppedAtOnce() {
        comesBack(EARLIER, false);
        assertThat(stops()).as("it may lie still").isZero();
        boat.onPathAt(HERE, 80, 1);

        assertThat(stops()).isEqualTo(1);
    }

    @Test
    void aListOfAnEarlierStartIsStoppedWhenItsCommandDoesNotComeAgain() {
        comesBack("c#base.3.7", false);
        boat.onPathAt(HERE, 80, 10);
        assertThat(stops()).isZero();
        boat.onPathAt(HERE, 80, 2);

        assertThat(stops()).isEqualTo(1);
    }

    @Test
    void aCommandThatComesAgainInTimeGoesOn() {
        comesBack("c#base.3.7", false);
        boat.onPathAt(HERE, 80, 5);
        boat.proxy.commands().submit(FollowPath.of("c", 1, 1, List.of(GeoPoint.of(45.01, 10)), Priority.MEDIUM));
        boat.setsOut();
        boat.onPathAt(HERE, 80, 20);

        assertThat(stops()).isZero();
    }

    @Test
    void aBoatWhoseCommandWaitsForAPositionDrivesOnUntilThatIsDecided() {
        boat.proxy.commands().awaitPosition(true);
        comesBack(EARLIER, false);
        boat.onPathAt(HERE, 80, 20);
        assertThat(stops()).isZero();
        boat.proxy.commands().awaitPosition(false);
        boat.onPathAt(HERE, 80, 1);

        assertThat(stops()).isEqualTo(1);
    }

    @Test
    void aListOfAnotherBaseIsLeftToDrive() {
        comesBack("c#base2.0.7", false);
        boat.onPathAt(HERE, 80, 20);

        assertThat(stops()).isZero();
    }

    @Test
    void aBoatThatLiesStillIsNotStopped() {
        comesBack(EARLIER, false);
        boat.silent(1);
        boat.says(new Telemetry(45, 10, 0, 0, 80, BoatMode.HOLD, 1));
        boat.onPathAt(HERE, 80, 1);
        comesBack("c#base.0.8", true);
        boat.onPathAt(HERE, 80, 20);

        assertThat(stops()).isZero();
    }
}
