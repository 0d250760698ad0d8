package org.sami.crw.operator.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.crw.operator.alarm.LaunchCheck.Subject;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.value.GeoPoint;

class LaunchCheckTest {
    private static final long NOW = 10_000;
    private static final Gains GAINS = new Gains(1, 0, 0);

    @Test
    void aBoatOfWhichAllIsKnownAndGoodMayBeLaunched() {
        LaunchCheck check = check(boat(NOW, 80, BatteryLevel.NOMINAL), List.of(), LostLinkAction.HOLD, 0.5);

        assertThat(check.items()).extracting(LaunchCheck.Item::state).containsOnly(State.GOOD);
        assertThat(check.mayLaunch()).isTrue();
    }

    @Test
    void whatIsOldWrongOrEmptyIsBad() {
        assertThat(state(
                        check(boat(NOW - 4000, 80, BatteryLevel.NOMINAL), List.of(), LostLinkAction.HOLD, 0.5),
                        Subject.POSITION))
                .isEqualTo(State.BAD);
        assertThat(state(
                        check(boat(NOW, 3, BatteryLevel.CRITICAL), List.of(), LostLinkAction.HOLD, 0.5),
                        Subject.BATTERY))
                .isEqualTo(State.BAD);
        Alarm compass =
                new Alarm(1, Alarm.Kind.COMPASS_DOUBTFUL, "anna", "", "it goes sideways", 0, true, false, false);
        assertThat(state(
                        check(boat(NOW, 80, BatteryLevel.NOMINAL), List.of(compass), LostLinkAction.HOLD, 0.5),
                        Subject.COMPASS))
                .isEqualTo(State.BAD);
    }

    @Test
    void aBoatThatWouldDriftOrDidNotMoveIsDoubtfulAndMayBeLaunched() {
        LaunchCheck check = check(boat(NOW, 25, BatteryLevel.LOW), List.of(), LostLinkAction.DRIFT, 0.0);

        assertThat(state(check, Subject.LOST_LINK)).isEqualTo(State.DOUBTFUL);
        assertThat(state(check, Subject.MOTOR)).isEqualTo(State.DOUBTFUL);
        assertThat(state(check, Subject.BATTERY)).isEqualTo(State.DOUBTFUL);
        assertThat(check.mayLaunch()).isTrue();
    }

    @Test
    void whatWasNeverHeardIsUnknownAndKeepsTheBoatAshore() {
        LaunchCheck check = LaunchCheck.of(
                boat(NOW, 80, BatteryLevel.NOMINAL), List.of(), Optional.empty(), OptionalDouble.empty(), NOW);

        assertThat(state(check, Subject.LOST_LINK)).isEqualTo(State.UNKNOWN);
        assertThat(state(check, Subject.MOTOR)).isEqualTo(State.UNKNOWN);
        assertThat(check.mayLaunch()).isFalse();
    }

    private static State state(LaunchCheck check, Subject subject) {
        return check.items().stream()
                .filter(item -> item.subject() == subject)
                .findFirst()
                .orElseThrow()
                .state();
    }

    private static LaunchCheck check(BoatSnapshot boat, List<Alarm> alarms, LostLinkAction action, double triedMps) {
        return LaunchCheck.of(
                boat, alarms, Optional.of(new BoatTuning(GAINS, GAINS, 1, action)), OptionalDouble.of(triedMps), NOW);
    }

    private static BoatSnapshot boat(long poseAtMillis, double percent, BatteryLevel level) {
        return new BoatSnapshot(
                "anna",
                LinkState.LINKED,
                OptionalLong.of(NOW),
                Optional.of(new BoatPose(GeoPoint.of(45, 10), 0, 0, 0)),
                poseAtMillis,
                Optional.of(new BatteryState(percent, level)),
                Optional.of(BoatMode.STOPPED),
                Commander.THIS_BASE,
                Optional.empty(),
                0,
                0,
                new BoatExplanation(false, Cause.NO_COMMAND, "anna rests"),
                List.of());
    }
}
