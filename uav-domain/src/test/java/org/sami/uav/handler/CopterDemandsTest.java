package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.alarm.MissingCapabilities;
import org.sami.crw.operator.alarm.MissingCapabilities.Robot;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/** What copters' plans demand of cameras, and what is said of a copter that lacks it. */
class CopterDemandsTest {
    private static final String WHY = "vehicle 6 has no camera (CAM1_TYPE 0)";
    private static final BoatCapabilities BLIND =
            new BoatCapabilities(Map.of(BoatCapabilities.PANORAMA, WHY), Optional.of(List.of("autopilot/battery")));
    private static final BoatCapabilities DETECTOR =
            new BoatCapabilities(Map.of(BoatCapabilities.PANORAMA, WHY), Optional.of(List.of("camera/target")));
    private static final Robot BLIND_COPTER = new Robot("mav6", true, true, BLIND);

    private static Optional<String> missing(BoatCapabilities can, String event) {
        return HandlerModules.missing("mav6", can, event, Map.of());
    }

    private static List<String> missing(String domain, String plan, RobotKind robots, Robot... fleet) {
        Project project = DomainLibrary.fromClassPath("/org/sami/domain/" + domain)
                .orThrow()
                .projectOf(plan)
                .orElseThrow();
        return MissingCapabilities.ofRobots(project.plan(plan).orElseThrow(), project, List.of(fleet), robots)
                .missing();
    }

    @Test
    void copterWithoutACameraCannotLookAround() {
        assertThat(missing(BLIND, "LookAround")).contains("mav6 cannot take pictures all round: " + WHY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"SearchAround", "WatchTargets"})
    void copterWithoutACameraMaySeeNoTargetsUnlessItHasReportedOne(String event) {
        assertThat(missing(BLIND, event)).contains("mav6 may see no targets: " + WHY);
        assertThat(missing(DETECTOR, event)).isEmpty();
    }

    @Test
    void copterMayMeasureNoWindUnlessItHasReportedSome() {
        BoatCapabilities estimates =
                new BoatCapabilities(Map.of(), Optional.of(List.of("autopilot/battery", "autopilot/wind")));
        BoatCapabilities silent = new BoatCapabilities(Map.of(BoatCapabilities.PANORAMA, WHY), Optional.empty());

        assertThat(missing(BLIND, "WatchWind")).contains("mav6 may measure no wind: it has reported none so far");
        assertThat(missing(silent, "WatchWind")).isPresent();
        assertThat(missing(estimates, "WatchWind")).isEmpty();
        assertThat(missing(BoatCapabilities.UNKNOWN, "WatchWind")).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"search-area", "wind-watch"})
    void plansThatBringCoptersHomeInStrongWindNameEachThatMayMeasureNone(String plan) {
        assertThat(missing("uav", plan, RobotKind.COPTER, BLIND_COPTER))
                .contains("mav6 may measure no wind: it has reported none so far");
    }

    @Test
    void copterWithoutACameraFliesAndOneThatSaysNothingIsTakenToBeAble() {
        assertThat(missing(BLIND, "FlyTo")).isEmpty();
        assertThat(missing(BoatCapabilities.UNKNOWN, "LookAround")).isEmpty();
        assertThat(missing(BoatCapabilities.UNKNOWN, "SearchAround")).isEmpty();
    }

    @Test
    void planOfCoptersNamesEachCopterThatCannotDoIt() {
        Robot able = new Robot("mav7", true, true, BoatCapabilities.UNKNOWN);

        assertThat(missing("uav", "look", RobotKind.COPTER, BLIND_COPTER, able))
                .containsExactly("mav6 cannot take pictures all round: " + WHY);
        assertThat(missing("uav", "search", RobotKind.COPTER, BLIND_COPTER, able))
                .containsExactly("mav6 may see no targets: " + WHY);
        assertThat(missing("uav", "first-flight", RobotKind.COPTER, BLIND_COPTER))
                .isEmpty();
    }

    @Test
    void teamLacksWhatNoneOfItsCoptersCanDo() {
        Robot boat = new Robot("anna", true, false, BoatCapabilities.UNKNOWN);
        Robot able = new Robot("mav7", true, true, BoatCapabilities.UNKNOWN);

        assertThat(missing("team", "scout-and-sample", RobotKind.ROBOT, BLIND_COPTER, boat))
                .contains("no robot can do WatchTargets: mav6 may see no targets: " + WHY + ", anna does not fly");
        assertThat(missing("team", "scout-and-sample", RobotKind.ROBOT, BLIND_COPTER, boat, able))
                .isEmpty();
    }
}
