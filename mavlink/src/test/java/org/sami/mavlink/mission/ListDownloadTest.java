package org.sami.mavlink.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.mavlink.vehicle.VehicleId;

/** Downloads from a vehicle that holds forty points, over a link that loses, doubles and reorders. */
class ListDownloadTest {
    private static final int POINTS = 40;

    private final List<Object> sent = new ArrayList<>();
    private final ListDownload download = new ListDownload(new VehicleId(3, 1), HeldKind.MISSION, sent::add);

    private static Object answer(Object request) {
        if (request instanceof MissionRequestList list) {
            return MissionCount.builder()
                    .count(POINTS)
                    .missionType(list.missionType())
                    .build();
        } else if (request instanceof MissionRequestInt item) {
            return item(item.seq(), MavMissionType.MAV_MISSION_TYPE_MISSION);
        }
        return new Object();
    }

    private static MissionItemInt item(int number, MavMissionType type) {
        return MissionItemInt.builder()
                .seq(number)
                .command(MavCmd.MAV_CMD_NAV_WAYPOINT)
                .frame(MavFrame.MAV_FRAME_GLOBAL_INT)
                .x(457_000_000 + number)
                .y(107_200_000)
                .z(5)
                .missionType(type)
                .build();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.05, 0.2})
    void listIsReadWholeAndInOrderOverALinkThatLoses(double loss) {
        SplittableRandom random = new SplittableRandom(7);
        ArrayDeque<Object> way = new ArrayDeque<>();
        download.begin(0);
        for (int ms = 0; !download.isOver() && ms < 600_000; ms += 100) {
            for (Object request : List.copyOf(sent)) {
                if (random.nextDouble() >= loss) {
                    way.addLast(answer(request));
                    if (random.nextDouble() < loss) {
                        way.addFirst(answer(request)); // twice, and before others
                    }
                }
            }
            sent.clear();
            while (!way.isEmpty()) {
                Object message = way.removeFirst();
                if (random.nextDouble() >= loss) {
                    download.take(message, ms);
                }
            }
            download.tick(ms);
        }

        assertThat(download.failure()).isEmpty();
        assertThat(download.items()).hasSize(POINTS);
        assertThat(download.items())
                .extracting(MissionItem::number)
                .containsExactlyElementsOf(IntStream.range(0, POINTS).boxed().toList());
        assertThat(download.items().get(1).commandName()).isEqualTo("nav waypoint");
        assertThat(download.items().get(1).latDeg()).isCloseTo(45.7000001, within(1e-9));
    }

    @Test
    void vehicleIsToldOnceThatAllHasCome() {
        download.begin(0);
        download.take(
                MissionCount.builder()
                        .count(0)
                        .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                        .build(),
                5);
        download.tick(10_000);

        assertThat(download.isOver()).isTrue();
        assertThat(sent).hasSize(2);
        assertThat(sent.get(1)).isInstanceOf(MissionAck.class);
    }

    @Test
    void vehicleThatDoesNotAnswerIsAskedEightTimesAndThenNamed() {
        download.begin(0);
        for (int ms = 0; ms < 20_000; ms += 100) {
            download.tick(ms);
        }

        assertThat(sent).hasSize(8);
        assertThat(download.failure())
                .hasValueSatisfying(why ->
                        assertThat(why).hasMessage("vehicle 3 does not answer when it is asked for its mission"));
    }

    @Test
    void refusalIsInTheVehiclesWords() {
        download.begin(0);
        download.take(
                MissionAck.builder()
                        .type(MavMissionResult.MAV_MISSION_DENIED)
                        .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                        .build(),
                10);

        assertThat(download.failure())
                .hasValueSatisfying(why -> assertThat(why)
                        .hasMessageStartingWith("vehicle 3 refuses to send its mission: ")
                        .hasMessageEndingWith("(MAV_MISSION_DENIED)"));
    }

    @Test
    void moreItemsThanFitIntoAnyAutopilotAreNotRead() {
        download.begin(0);
        download.take(
                MissionCount.builder()
                        .count(65_535)
                        .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                        .build(),
                10);

        assertThat(download.failure()).hasValueSatisfying(why -> assertThat(why).hasMessageContaining("65535 items"));
    }

    @Test
    void answersOfAnotherListChangeNothing() {
        download.begin(0);
        download.take(
                MissionCount.builder()
                        .count(3)
                        .missionType(MavMissionType.MAV_MISSION_TYPE_FENCE)
                        .build(),
                10);
        download.take(item(0, MavMissionType.MAV_MISSION_TYPE_MISSION), 20);

        assertThat(download.isOver()).isFalse();
        assertThat(download.items()).isEmpty();
        assertThat(sent).hasSize(1);
    }

    @Test
    void listThatIsShortenedWhileItIsReadIsNamed() {
        download.begin(0);
        for (int ms = 0; !download.isOver() && ms < 60_000; ms += 100) {
            List<Object> requests = List.copyOf(sent);
            sent.clear();
            for (Object request : requests) {
                boolean isGone = request instanceof MissionRequestInt asked && asked.seq() >= POINTS / 2;
                download.take(isGone ? noSuchItem() : answer(request), ms);
            }
            download.tick(ms);
        }

        assertThat(download.failure().orElseThrow())
                .hasMessage("vehicle 3 changed its mission while it was read: it sent 20 of 40 items and has no others "
                        + "any longer");
    }

    private static MissionAck noSuchItem() {
        return MissionAck.builder()
                .type(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }
}
