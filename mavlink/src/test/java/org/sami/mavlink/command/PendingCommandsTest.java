package org.sami.mavlink.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.ManualControl;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.SetPositionTargetGlobalInt;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;

/** Commands on a clock of the test's own, to a vehicle that answers what the test says. */
class PendingCommandsTest {
    private final List<Object> sent = new ArrayList<>();
    private final List<Integer> percents = new ArrayList<>();
    private final List<CommandOutcome> ended = new ArrayList<>();
    private final PendingCommands commands = new PendingCommands(new VehicleId(3, 1), sent::add);

    private void give(VehicleCommand command, long nowMs) {
        commands.give(command, nowMs, percents::add, ended::add);
    }

    private void answer(MavCmd command, MavResult result, int progress, long nowMs) {
        commands.take(
                CommandAck.builder()
                        .command(command)
                        .result(result)
                        .progress(progress)
                        .build(),
                nowMs);
    }

    private void answer(MavCmd command, MavResult result, long nowMs) {
        answer(command, result, 0, nowMs);
    }

    private void passUntil(long ms) {
        for (long now = 0; now <= ms; now += 100) {
            commands.tick(now);
        }
    }

    @Test
    void commandIsSentAgainUntilItIsAnswered() {
        give(VehicleCommand.arm(), 0);
        passUntil(2_500);
        answer(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, MavResult.MAV_RESULT_ACCEPTED, 2_600);

        assertThat(sent)
                .extracting(message -> ((CommandLong) message).confirmation())
                .containsExactly(0, 1, 2);
        assertThat(ended).hasSize(1);
        assertThat(ended.get(0).isAccepted()).isTrue();
    }

    @Test
    void vehicleThatNeverAnswersIsNamedAfterFiveTries() {
        give(VehicleCommand.arm(), 0);
        passUntil(20_000);

        assertThat(sent).hasSize(5);
        assertThat(ended).extracting(CommandOutcome::verdict).containsExactly(CommandVerdict.UNANSWERED);
        assertThat(ended.get(0).inWords()).isEqualTo("vehicle 3 does not answer when it is asked to arm");
    }

    @Test
    void refusalHasTheAutopilotsWordsAlsoThoseThatFollowTheAnswer() {
        give(VehicleCommand.arm(), 0);
        commands.heard(new StatusText(TextSeverity.CRITICAL, "PreArm: GPS 1: Bad fix", 20));
        answer(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, MavResult.MAV_RESULT_FAILED, 30);
        commands.heard(new StatusText(TextSeverity.INFO, "EKF3 IMU0 initialised", 40));
        commands.heard(new StatusText(TextSeverity.CRITICAL, "PreArm: Compass not healthy", 50));
        assertThat(ended).isEmpty();
        passUntil(1_000);

        assertThat(ended.get(0).inWords())
                .isEqualTo("vehicle 3 fails to arm: PreArm: GPS 1: Bad fix; PreArm: Compass not healthy");
    }

    @Test
    void firmwareWithoutTheCommandIsNamedWithWhatToDo() {
        give(VehicleCommand.arm(), 0);
        answer(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM, MavResult.MAV_RESULT_UNSUPPORTED, 100);
        passUntil(2_000);

        assertThat(sent).hasSize(1);
        assertThat(ended).extracting(CommandOutcome::verdict).containsExactly(CommandVerdict.UNKNOWN_TO_IT);
        assertThat(ended.get(0).inWords())
                .isEqualTo("vehicle 3 does not know how to arm (its firmware lacks this command: update it)");
    }

    @Test
    void progressIsReportedAndWaitedFor() {
        give(VehicleCommand.of(241, "calibrate"), 0);
        answer(MavCmd.MAV_CMD_PREFLIGHT_CALIBRATION, MavResult.MAV_RESULT_IN_PROGRESS, 40, 500);
        passUntil(9_000);
        answer(MavCmd.MAV_CMD_PREFLIGHT_CALIBRATION, MavResult.MAV_RESULT_ACCEPTED, 9_100);

        assertThat(sent).hasSize(1);
        assertThat(percents).containsExactly(40);
        assertThat(ended.get(0).isAccepted()).isTrue();
    }

    @Test
    void commandsOfOneNumberGoOneAfterTheOther() {
        give(VehicleCommand.sendEvery(33, 0.5), 0);
        give(VehicleCommand.sendEvery(24, 2), 0);
        assertThat(sent).hasSize(1);
        answer(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL, MavResult.MAV_RESULT_ACCEPTED, 10);

        assertThat(sent).extracting(message -> ((CommandLong) message).param1()).containsExactly(33f, 24f);
        assertThat(((CommandLong) sent.get(1)).param2()).isEqualTo(2e6f);
    }

    @Test
    void commandsThatAreWithdrawnAreNotSentButTheOneThatWasIsAnswered() {
        give(VehicleCommand.sendEvery(33, 0.5), 0);
        give(VehicleCommand.sendEvery(24, 2), 0);

        commands.withdrawUnsent(VehicleCommand.SEND_EVERY);
        give(VehicleCommand.sendEvery(30, 1), 10);
        assertThat(ended).extracting(CommandOutcome::verdict).containsExactly(CommandVerdict.REPLACED);
        answer(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL, MavResult.MAV_RESULT_ACCEPTED, 20);

        assertThat(sent).extracting(message -> ((CommandLong) message).param1()).containsExactly(33f, 30f);
        assertThat(ended.get(1).isAccepted()).isTrue();
    }

    @Test
    void laterModeTakesThePlaceOfAnEarlierOneWhoseAnswerIsNotCounted() {
        give(VehicleCommand.setMode(10, "AUTO"), 0);
        give(VehicleCommand.setMode(4, "HOLD"), 50);
        assertThat(ended).extracting(CommandOutcome::verdict).containsExactly(CommandVerdict.REPLACED);

        answer(MavCmd.MAV_CMD_DO_SET_MODE, MavResult.MAV_RESULT_ACCEPTED, 60); // may be AUTO's
        assertThat(ended).hasSize(1);
        answer(MavCmd.MAV_CMD_DO_SET_MODE, MavResult.MAV_RESULT_ACCEPTED, 70);

        assertThat(ended).hasSize(2);
        assertThat(ended.get(1).command().does()).isEqualTo("change to HOLD");
        assertThat(sent).extracting(message -> ((CommandLong) message).param2()).containsExactly(10f, 4f, 4f);
    }

    @Test
    void placesAreSentToTheCentimetre() {
        CommandPlace place = new CommandPlace(45.1234567, -10.7654321, 12);
        give(VehicleCommand.reposition(place, Optional.empty()), 0);

        CommandInt command = (CommandInt) sent.get(0);
        assertThat(command.x()).isEqualTo(451_234_567);
        assertThat(command.y()).isEqualTo(-107_654_321);
        assertThat(command.param2()).as("whether it changes the mode").isZero();

        var target = (SetPositionTargetGlobalInt) new GuidedTarget(place).message(new VehicleId(3, 1));
        assertThat(target.latInt()).isEqualTo(451_234_567);
        assertThat(target.typeMask().value() & 0b111).isZero();
    }

    @Test
    void sticksAreThoseThatAutopilotsOfBoatsAndCoptersExpect() {
        HandControl ahead = new HandControl(0.5, 0, 0, -1);
        ManualControl boat = (ManualControl) ahead.message(new VehicleId(3, 1), VehicleKind.BOAT);
        ManualControl copter = (ManualControl) ahead.message(new VehicleId(3, 1), VehicleKind.COPTER);

        assertThat(List.of(boat.x(), boat.y(), boat.z(), boat.r())).containsExactly(0, -1000, 500, 0);
        assertThat(List.of(copter.x(), copter.y(), copter.z(), copter.r())).containsExactly(500, 0, 500, -1000);
    }

    @Test
    void whatCannotBeIsRefusedBeforeItIsSent() {
        assertThatThrownBy(() -> new CommandPlace(Double.NaN, 0, 0)).hasMessageContaining("no place");
        assertThatThrownBy(() -> new HandControl(1.1, 0, 0, 0)).hasMessageContaining("forward");
        assertThatThrownBy(() -> new RadioOverride(Map.of(9, 1500))).hasMessageContaining("channel 9");
    }

    @Test
    void closingEndsWhatIsOpen() {
        IntStream.range(0, 3).forEach(i -> give(VehicleCommand.sendEvery(i, 1), 0));
        commands.close();

        assertThat(ended).extracting(CommandOutcome::verdict).containsOnly(CommandVerdict.UNANSWERED);
        assertThat(ended).hasSize(3);
    }

    @Test
    void eachPictureHasANumberSoThatACommandThatComesTwiceIsOnePicture() {
        assertThat(VehicleCommand.takePicture(3).params()).startsWith(0.0, 0.0, 1.0, 3.0);
    }
}
