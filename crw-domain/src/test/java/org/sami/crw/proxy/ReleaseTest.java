package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.FleetEvent;

/** A release of a stopped boat is asked for only within the term in which it was ordered (docs/link.md). */
class ReleaseTest {
    private final List<String> dropped = new ArrayList<>();
    private final ScriptedBoat boat = new ScriptedBoat(event -> {
        if (event instanceof FleetEvent.ReleaseDropped release) {
            dropped.add(release.boat() + ": " + release.reason());
        }
    });

    private void welcomes(Role role, String term) {
        boat.says(new Welcome("boat1", "b1", role, term, "", false, Optional.empty()));
        boat.says(new Progress("", 0, false));
    }

    private void isStopped() {
        welcomes(Role.COMMANDER, "b1.1");
        boat.proxy.fleetStop();
        boat.acknowledges(FleetStop.class);
        boat.says(new Telemetry(45, 10, 0, 0, 80, BoatMode.FLEET_STOP, 1));
    }

    private long sent(Class<? extends LinkMessage> kind) {
        return boat.said.stream().filter(kind::isInstance).count();
    }

    private void assertDropped(String why) {
        long before = sent(FleetRelease.class);
        boat.alive(10);
        assertThat(sent(FleetRelease.class)).as("releases").isEqualTo(before);
        assertThat(dropped).singleElement().asString().contains(why);
        assertThat(boat.proxy.isAwaitingFleetAnswer()).isFalse();
    }

    @Test
    void aReleaseIsRepeatedUntilTheBoatAnswers() {
        isStopped();
        boat.proxy.fleetRelease();
        boat.alive(30);
        assertThat(sent(FleetRelease.class)).isGreaterThan(20);

        welcomes(Role.COMMANDER, "b1.1");
        boat.alive(2);
        assertThat(boat.proxy.isAwaitingFleetAnswer())
                .as("a welcome in the same term")
                .isTrue();
        boat.acknowledges(FleetRelease.class);
        assertThat(boat.proxy.isAwaitingFleetAnswer()).isFalse();
        assertThat(dropped).isEmpty();
    }

    @Test
    void aReleaseThatTheLinkDidNotCarryIsNotSentOverTheNextOne() {
        isStopped();
        boat.proxy.fleetRelease();
        boat.silent(5);
        welcomes(Role.COMMANDER, "b1.2");

        assertDropped("its link was lost");
    }

    @Test
    void aReleaseIsDroppedWhenTheBoatNamesANewTerm() {
        isStopped();
        boat.proxy.fleetRelease();
        welcomes(Role.COMMANDER, "b1.2");

        assertDropped("stopped by another base");
    }

    @Test
    void aReleaseIsDroppedWhenAnotherBaseTakesTheCommand() {
        isStopped();
        boat.proxy.fleetRelease();
        welcomes(Role.OBSERVER, "");

        assertDropped("another base commands it");
        welcomes(Role.COMMANDER, "b1.3");
        boat.alive(5);
        assertThat(sent(FleetRelease.class)).as("when the command is back").isEqualTo(1);
    }

    @Test
    void aReleaseThatTheBoatRefusesIsDropped() {
        isStopped();
        boat.proxy.fleetRelease();
        boat.says(new Nack(boat.last(FleetRelease.class).commandId(), NackReason.NOT_GREETED, "another term"));

        assertDropped("the boat refused it");
    }

    @Test
    void aReleaseOfABoatThatThisBaseDoesNotCommandIsNotSentLaterEither() {
        isStopped();
        welcomes(Role.OBSERVER, "");
        boat.proxy.fleetRelease();
        welcomes(Role.COMMANDER, "b1.3");

        assertDropped("another base commands it");
        assertThat(sent(FleetRelease.class)).isZero();
    }

    @Test
    void aStopIsRepeatedOverLostLinksAndNewTerms() {
        welcomes(Role.COMMANDER, "b1.1");
        boat.proxy.fleetStop();
        boat.silent(5);
        welcomes(Role.COMMANDER, "b1.2");
        boat.says(new Nack(boat.last(FleetStop.class).commandId(), NackReason.NOT_GREETED, "say hello"));
        welcomes(Role.COMMANDER, "b1.3");
        long before = sent(FleetStop.class);
        boat.alive(5);

        assertThat(sent(FleetStop.class)).isGreaterThanOrEqualTo(before + 4);
    }

    @Test
    void aReleaseTakesBackAStopThatNeverReachedTheBoat() {
        boat.proxy.fleetStop();
        boat.proxy.fleetRelease();
        long before = sent(FleetStop.class);
        welcomes(Role.COMMANDER, "b1.1");
        boat.alive(5);

        assertThat(sent(FleetStop.class)).isEqualTo(before);
        assertThat(sent(FleetRelease.class)).isZero();
    }
}
