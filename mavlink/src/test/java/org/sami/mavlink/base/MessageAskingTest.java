package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.ReceivedMessage;
import org.sami.mavlink.vehicle.MessageOrigin;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleTable;

/** What vehicles are asked to send, on a clock of the test's own. They send heartbeats and positions, and answer what the test says. */
class MessageAskingTest {
    private static final MavlinkAddress RADIO = AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600");
    private static final int FILTER = 193; // EKF_STATUS_REPORT
    private static final int MESSAGES = 9; // that each vehicle is asked for
    private static final int TICK_MS = 100;
    private static final int SECOND_MS = 1_000;

    private long nowMs = 100_000;
    private final VehicleTable table = new VehicleTable();
    private final BaseThread thread = new BaseThread();
    private final List<Sent> sent = new ArrayList<>();
    private final VehicleRequests requests =
            new VehicleRequests(table, MavlinkBaseOptions.none(), () -> nowMs, thread, this::send);
    private final MessageAsking asking = new MessageAsking(table, false, () -> nowMs);
    private final Map<Integer, Integer> numbers = new TreeMap<>(); // of the next message, by vehicle
    private IntFunction<List<MavResult>> answers = message -> List.of(MavResult.MAV_RESULT_ACCEPTED);
    private boolean isHeard = true;

    /** A request for a message. */
    private record Sent(int vehicle, int message, double everyS) {}

    @AfterEach
    void end() {
        thread.close();
    }

    private void send(VehicleId vehicle, Object message) {
        if (message instanceof CommandLong command
                && command.command().entry() == MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL) {
            sent.add(new Sent(vehicle.system(), (int) command.param1(), command.param2() / 1e6));
        }
    }

    private void hears(int vehicle, Object payload) {
        int number = numbers.merge(vehicle, 1, (last, one) -> (last + one) % 256);
        VehicleId id = new VehicleId(vehicle, 1);
        boolean isNew = !table.has(id);
        var events = table.heard(new MessageOrigin(RADIO, vehicle, 1, number), payload, nowMs);
        if (isNew) {
            asking.renew(id);
        }
        requests.take(id, new ReceivedMessage(vehicle, 1, number, false, payload), events, nowMs);
    }

    private void pass(int seconds, int... vehicles) {
        for (int i = 0; i < seconds * SECOND_MS / TICK_MS; i++) {
            nowMs += TICK_MS;
            if (isHeard && nowMs % SECOND_MS == 0) {
                for (int vehicle : vehicles) {
                    speaks(vehicle);
                }
            }
            int before = sent.size();
            requests.tick(nowMs);
            asking.tick(requests);
            List.copyOf(sent.subList(before, sent.size())).forEach(this::answer);
        }
    }

    private void speaks(int vehicle) {
        hears(
                vehicle,
                Heartbeat.builder()
                        .type(MavType.MAV_TYPE_SURFACE_BOAT)
                        .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                        .baseMode(MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED)
                        .systemStatus(MavState.MAV_STATE_STANDBY)
                        .build());
        hears(
                vehicle,
                GlobalPositionInt.builder()
                        .timeBootMs(nowMs)
                        .lat(457_000_000)
                        .lon(107_000_000 + vehicle * 1_000)
                        .build());
    }

    /** Each answer has the next request sent, which is answered too. */
    private void answer(Sent request) {
        for (MavResult result : answers.apply(request.message())) {
            int before = sent.size();
            hears(
                    request.vehicle(),
                    CommandAck.builder()
                            .command(MavCmd.MAV_CMD_SET_MESSAGE_INTERVAL)
                            .result(result)
                            .build());
            List.copyOf(sent.subList(before, sent.size())).forEach(this::answer);
        }
    }

    private long times(int message) {
        return sent.stream().filter(one -> one.message() == message).count();
    }

    private void answersExceptFor(int silent, List<MavResult> itsAnswers) {
        answers = message -> message == silent ? itsAnswers : List.of(MavResult.MAV_RESULT_ACCEPTED);
    }

    @Test
    void reportThatWasNotConfirmedIsAskedForAgainUntilItIs() {
        answersExceptFor(FILTER, List.of());
        pass(12, 3);
        assertThat(times(FILTER)).isEqualTo(5); // the tries of a request
        assertThat(times(1)).isEqualTo(1);

        answersExceptFor(FILTER, List.of(MavResult.MAV_RESULT_ACCEPTED));
        pass(30, 3);

        assertThat(times(FILTER)).isEqualTo(6);
        assertThat(times(1)).as("confirmed already").isEqualTo(1);
    }

    @Test
    void reportThatTheVehicleCannotSendNowIsAskedForAgainEverMoreSeldom() {
        answersExceptFor(FILTER, List.of(MavResult.MAV_RESULT_TEMPORARILY_REJECTED));
        pass(600, 3);

        assertThat(times(FILTER)).isBetween(7L, 12L);
    }

    @Test
    void reportThatTheVehicleRefusesIsNotAskedForAgain() {
        answers = message -> switch (message) {
            case FILTER -> List.of(MavResult.MAV_RESULT_DENIED);
            case 162 -> List.of(MavResult.MAV_RESULT_UNSUPPORTED);
            case 173 -> List.of(MavResult.MAV_RESULT_FAILED);
            default -> List.of(MavResult.MAV_RESULT_ACCEPTED);
        };
        pass(600, 3);

        assertThat(sent).doesNotHaveDuplicates().hasSize(MESSAGES);
    }

    @Test
    void vehicleThatIsSilentIsNotAskedAgainUntilItIsHeard() {
        answersExceptFor(FILTER, List.of());
        pass(8, 3);
        isHeard = false;
        pass(40, 3);
        assertThat(times(FILTER)).isEqualTo(5);

        isHeard = true;
        pass(3, 3);
        assertThat(times(FILTER)).isGreaterThan(5);
    }

    private double positionEveryS(int vehicle) {
        return sent.stream()
                .filter(one -> one.vehicle() == vehicle && one.message() == 33)
                .reduce((before, later) -> later)
                .orElseThrow()
                .everyS();
    }

    private static double planned(int vehicles) {
        return MessagePlan.of(RADIO, vehicles, false).messages().get(0).everyS();
    }

    @Test
    void vehiclesThatLeftDoNotSlowDownThoseThatAreStillHeard() {
        int[] all = IntStream.rangeClosed(1, 25).toArray();
        pass(10, all);
        assertThat(positionEveryS(1)).isCloseTo(planned(25), within(1e-3));
        sent.clear();

        pass(50, 1, 2, 3);
        assertThat(sent).as("the others may be back soon").isEmpty();
        pass(40, 1, 2, 3);

        assertThat(positionEveryS(1)).isCloseTo(planned(3), within(1e-3));
        assertThat(sent)
                .as("each is asked once, and nobody who has left")
                .hasSize(3 * MESSAGES)
                .extracting(Sent::vehicle)
                .containsOnly(1, 2, 3);
        assertThat(asking.plan(RADIO).vehicles()).isEqualTo(3);
    }

    @Test
    void vehiclesThatComeBackAreCountedAgainAtOnce() {
        int[] all = IntStream.rangeClosed(1, 25).toArray();
        pass(10, all);
        pass(90, 1, 2, 3);
        sent.clear();

        pass(10, all);

        assertThat(positionEveryS(1)).isCloseTo(planned(25), within(1e-3));
        assertThat(sent.stream().filter(one -> one.vehicle() == 1)).hasSize(MESSAGES);
    }
}
