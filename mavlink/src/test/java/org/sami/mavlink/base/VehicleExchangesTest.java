package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/** What is asked of a vehicle that another ground station speaks with too, on a clock of the test's own. */
@SuppressWarnings("deprecation") // ArduPilot still asks for items by the older message
class VehicleExchangesTest {
    private static final int OTHER = 230; // the component of another ground station, whose system is 255 as well
    private static final int OURS = 190;

    private final List<Object> sent = new ArrayList<>();
    private final List<CommandOutcome> ended = new ArrayList<>();
    private final VehicleExchanges vehicle = new VehicleExchanges(new VehicleId(3, 1), Optional.empty(), sent::add);

    private int messages;

    private void says(Object message) {
        vehicle.take(message, messages++, List.of(), 0);
    }

    private static CommandAck answer(int system, int component) {
        return CommandAck.builder()
                .command(MavCmd.MAV_CMD_COMPONENT_ARM_DISARM)
                .result(MavResult.MAV_RESULT_ACCEPTED)
                .targetSystem(system)
                .targetComponent(component)
                .build();
    }

    private void disarm() {
        vehicle.commands().give(VehicleCommand.disarm(), 0, percent -> {}, ended::add);
    }

    @Test
    void disarmGoesOnWhenTheVehicleAnswersAnotherStationThatArmsIt() {
        disarm();
        says(answer(255, OTHER));
        says(answer(254, OURS));
        assertThat(ended).isEmpty();
        vehicle.tick(1_500);
        assertThat(sent).hasSize(2).hasOnlyElementsOfType(CommandLong.class);

        says(answer(255, OURS));
        assertThat(ended).singleElement().matches(CommandOutcome::isAccepted);
    }

    @Test
    void anAnswerThatNamesNoStationIsTaken() {
        disarm();
        says(answer(0, 0));
        disarm();
        says(answer(255, 0));

        assertThat(ended).hasSize(2).allMatch(CommandOutcome::isAccepted);
    }

    private static MissionAck ack(MavMissionResult result, int component) {
        return MissionAck.builder()
                .targetSystem(255)
                .targetComponent(component)
                .type(result)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }

    private static MissionRequestInt request(int item, int component) {
        return MissionRequestInt.builder()
                .targetSystem(255)
                .targetComponent(component)
                .seq(item)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }

    private static MissionItem point(int number) {
        return MissionItem.waypoint(number, 45 + number * 1e-4, 10, 0, 0);
    }

    @Test
    void aListThatIsSentGoesOnWhenTheVehicleRefusesThatOfAnotherStation() {
        CompletableFuture<List<MissionItem>> result = new CompletableFuture<>();
        vehicle.lists().replace(HeldKind.MISSION, List.of(List.of(point(0), point(1))), 0, result);
        says(request(0, OURS));
        sent.clear();

        says(ack(MavMissionResult.MAV_MISSION_DENIED, OTHER));
        says(request(1, OTHER));
        says(MissionRequest.builder()
                .targetSystem(255)
                .targetComponent(OTHER)
                .seq(1)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build());
        assertThat(result).isNotDone();
        assertThat(sent).isEmpty();

        says(ack(MavMissionResult.MAV_MISSION_DENIED, OURS));
        assertThat(sent).hasOnlyElementsOfType(MissionCount.class); // once more
        says(ack(MavMissionResult.MAV_MISSION_DENIED, OURS));
        assertThat(result).isCompletedExceptionally();
    }
}
