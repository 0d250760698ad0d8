package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;

/** Events by which boats drop what missions want of them. */
final class AbortEventCases {
    private static final long OTHER_MISSION = 99;
    private static final GeoPoint FAR = PlanScene.at(0, 900);

    private AbortEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "ProxyAbortMission",
                        Seen.ON_A_BOAT,
                        "the boat leaves this mission's way and takes up the other mission's",
                        () -> assertThat(queueAfter("ProxyAbortMission")).containsExactly(OTHER_MISSION))
                .shows(
                        "SendAbortMission",
                        Seen.ON_A_BOAT,
                        "the boat leaves this mission's way and takes up the other mission's",
                        () -> assertThat(queueAfter("SendAbortMission")).containsExactly(OTHER_MISSION))
                .shows(
                        "SendProxyAbortAllMissions",
                        Seen.ON_A_BOAT,
                        "nothing is wanted of the boat any longer, and it stops",
                        () -> {
                            PlanScene scene = asked("SendProxyAbortAllMissions");
                            assertThat(queue(scene)).isEmpty();
                            assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
                        })
                .shows(
                        "SendProxyAbortFutureMissions",
                        Seen.ON_A_BOAT,
                        "the boat goes on with what it does, and what waited is gone",
                        () -> {
                            PlanScene scene = asked("SendProxyAbortFutureMissions");
                            assertThat(queue(scene)).containsExactly(PlanScene.MISSION);
                            assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
                        })
                .shows("ProxyEmergencyAbort", Seen.ON_A_BOAT, "the motors are off, and nothing waits", () -> {
                    PlanScene scene = asked("ProxyEmergencyAbort");
                    assertThat(queue(scene)).isEmpty();
                    assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
                })
                .shows(
                        "ProxyAbortMissionReceived",
                        Seen.IN_THE_MARKING,
                        "the boat that was made to signal moves on, the other one stays",
                        AbortEventCases::signal);
    }

    private static void signal() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "go",
                                "ProxyGotoPoint",
                                "points",
                                ProxyMaps.toValue(Map.of("boat-1", PlanScene.at(4, 10), "boat-2", FAR)))
                        .on("go", "ProxyPathCompleted", "ask")
                        .asks("ask", "SendAbortMission")
                        .on("ask", "ProxyAbortMissionReceived", "off"),
                2);
        scene.untilBoat("boat-1", "off");
        assertThat(scene.stands(PlanScene.boat("boat-2"), "go")).isTrue();
    }

    private static List<Long> queueAfter(String event) {
        PlanScene scene = asked(event);
        assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
        return queue(scene);
    }

    /** A boat is under way for the mission, another mission's command waits, and then the mission asks for the event. */
    private static PlanScene asked(String event) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", FAR)
                        .asks("go", "StartSystemTimer", "duration", new DurationValue(10_000))
                        .on("go", "TimerExpired", "ask", "any-token")
                        .asks("ask", event),
                1);
        boat(scene)
                .commands()
                .submit(FollowPath.goTo("other", OTHER_MISSION, 1, PlanScene.at(900, 0), Priority.MEDIUM));
        scene.run(5);
        assertThat(queue(scene)).containsExactly(PlanScene.MISSION, OTHER_MISSION);
        assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
        scene.run(10);
        assertThat(scene.stands(PlanScene.boat("boat-1"), "ask")).isTrue();
        return scene;
    }

    private static BoatProxy boat(PlanScene scene) {
        return scene.world.boats.find("boat-1").orElseThrow();
    }

    /** The missions that want something of the boat, in the order of their turn. */
    private static List<Long> queue(PlanScene scene) {
        List<Long> missions = new ArrayList<>();
        boat(scene).commands().current().ifPresent(command -> missions.add(command.mission()));
        boat(scene).commands().waiting().forEach(command -> missions.add(command.mission()));
        return missions;
    }
}
