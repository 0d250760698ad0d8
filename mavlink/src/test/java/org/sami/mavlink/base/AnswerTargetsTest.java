package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MissionAck;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.link.MavlinkLink;

/** A vehicle's answers tell which other ground station it has obeyed. */
class AnswerTargetsTest {
    private static final int OTHER = 252;

    private static CommandAck answer(MavCmd command, MavResult result, int station) {
        return CommandAck.builder()
                .command(command)
                .result(result)
                .targetSystem(station)
                .build();
    }

    private static MissionAck list(MavMissionType type, MavMissionResult result) {
        return MissionAck.builder()
                .missionType(type)
                .type(result)
                .targetSystem(OTHER)
                .build();
    }

    @Test
    void stationWhoseModeItTookWasObeyed() {
        assertThat(AnswerTargets.obeyed(answer(MavCmd.MAV_CMD_DO_SET_MODE, MavResult.MAV_RESULT_ACCEPTED, OTHER)))
                .isEqualTo(OptionalInt.of(OTHER));
    }

    @Test
    void stationThatItRefusedOrOnlyToldSomethingWasNot() {
        assertThat(AnswerTargets.obeyed(answer(MavCmd.MAV_CMD_DO_SET_MODE, MavResult.MAV_RESULT_FAILED, OTHER)))
                .isEmpty();
        assertThat(AnswerTargets.obeyed(answer(MavCmd.MAV_CMD_REQUEST_MESSAGE, MavResult.MAV_RESULT_ACCEPTED, OTHER)))
                .isEmpty();
    }

    @Test
    void theBaseItselfIsNoOther() {
        assertThat(AnswerTargets.obeyed(
                        answer(MavCmd.MAV_CMD_DO_SET_MODE, MavResult.MAV_RESULT_ACCEPTED, MavlinkLink.GROUND_SYSTEM)))
                .isEmpty();
    }

    @Test
    void stationWhoseMissionItTookWasObeyedAndOneThatGaveItAFenceWasNot() {
        assertThat(AnswerTargets.obeyed(
                        list(MavMissionType.MAV_MISSION_TYPE_MISSION, MavMissionResult.MAV_MISSION_ACCEPTED)))
                .isEqualTo(OptionalInt.of(OTHER));
        assertThat(AnswerTargets.obeyed(
                        list(MavMissionType.MAV_MISSION_TYPE_FENCE, MavMissionResult.MAV_MISSION_ACCEPTED)))
                .isEmpty();
    }
}
