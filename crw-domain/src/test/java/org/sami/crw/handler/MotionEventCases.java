package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/** Events by which boats move. */
final class MotionEventCases {
    private static final double NEAR_M = 4;
    private static final GeoPoint NORTH = PlanScene.at(0, 40);
    private static final GeoPoint EAST = PlanScene.at(60, 40);

    private MotionEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "ProxyExecutePath",
                        Seen.ON_A_BOAT,
                        "each boat has been at every point of its path and lies at the last",
                        MotionEventCases::executePath)
                .shows("ProxyGotoPoint", Seen.ON_A_BOAT, "each boat lies at its own point", MotionEventCases::gotoPoint)
                .shows(
                        "ProxyGotoLatLon",
                        Seen.ON_A_BOAT,
                        "all boats lie at the one location",
                        MotionEventCases::gotoLatLon)
                .shows(
                        "BlockMovement",
                        Seen.ON_A_BOAT,
                        "a boat under way stops, and another mission's command waits",
                        MotionEventCases::blockMovement)
                .shows(
                        "ProxyPathCompleted",
                        Seen.IN_THE_MARKING,
                        "the boat that has arrived moves on, the other one stays until it has arrived too",
                        MotionEventCases::pathCompleted)
                .shows(
                        "ProxyPathFailed",
                        Seen.IN_THE_MARKING,
                        "the boat whose path a command of higher priority displaced moves on, and the reason is in the variable",
                        MotionEventCases::pathFailed);
    }

    private static void executePath() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyExecutePath", "paths", paths(Map.of("boat-1", List.of(NORTH, EAST))))
                        .on("go", "ProxyPathCompleted", "there"),
                1);
        scene.until("the boat is at the first point", () -> distance(scene, "boat-1", NORTH) < NEAR_M);
        scene.untilBoat("boat-1", "there");
        assertThat(distance(scene, "boat-1", EAST)).isLessThan(NEAR_M);
    }

    private static void gotoPoint() {
        PlanScene scene = goToPoints();
        scene.untilBoat("boat-1", "there").untilBoat("boat-2", "there");
        assertThat(distance(scene, "boat-1", NORTH)).isLessThan(NEAR_M);
        assertThat(distance(scene, "boat-2", EAST)).isLessThan(NEAR_M);
    }

    private static void gotoLatLon() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", NORTH)
                        .on("go", "ProxyPathCompleted", "there"),
                2);
        scene.untilBoat("boat-1", "there").untilBoat("boat-2", "there");
        assertThat(distance(scene, "boat-1", NORTH)).isLessThan(NEAR_M);
        assertThat(distance(scene, "boat-2", NORTH)).isLessThan(NEAR_M);
    }

    private static void blockMovement() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", NORTH)
                        .on("go", "OperatorInterruptReceived", "hold", "any-token", "interruptName", text("Hold"))
                        .asks("hold", "BlockMovement"),
                1);
        scene.run(5);
        assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
        scene.press("Hold");
        scene.run(3);
        assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        scene.world
                .boats
                .find("boat-1")
                .orElseThrow()
                .commands()
                .submit(FollowPath.goTo("another mission's", 99, 1, EAST, Priority.MEDIUM));
        scene.run(5);
        assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
    }

    private static void pathCompleted() {
        PlanScene scene = goToPoints();
        scene.untilBoat("boat-1", "there");
        assertThat(scene.stands(PlanScene.boat("boat-2"), "go")).isTrue();
        scene.untilBoat("boat-2", "there");
    }

    private static void pathFailed() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@why", "text")
                        .asks("go", "ProxyGotoLatLon", "location", NORTH)
                        .on("go", "ProxyPathFailed", "stuck")
                        .writing("reason", "@why"),
                1);
        scene.run(3);
        scene.world
                .boats
                .find("boat-1")
                .orElseThrow()
                .commands()
                .submit(FollowPath.goTo("another mission's", 99, 1, EAST, Priority.HIGH));
        scene.untilBoat("boat-1", "stuck");
        assertThat(((TextValue) scene.variable("@why")).value()).contains("higher priority");
    }

    private static PlanScene goToPoints() {
        return new PlanScene(
                new PlanSketch()
                        .asks(
                                "go",
                                "ProxyGotoPoint",
                                "points",
                                ProxyMaps.toValue(Map.of("boat-1", NORTH, "boat-2", EAST)))
                        .on("go", "ProxyPathCompleted", "there"),
                2);
    }

    private static org.sami.spn.value.Value paths(Map<String, List<GeoPoint>> points) {
        Map<String, GeoPath> paths = new java.util.TreeMap<>();
        points.forEach((boat, path) -> paths.put(boat, new GeoPath(path)));
        return ProxyMaps.toValue(paths);
    }

    private static TextValue text(String text) {
        return new TextValue(text);
    }

    private static double distance(PlanScene scene, String boat, GeoPoint point) {
        return Geodesy.distanceM(scene.world.hull(boat).position(), point);
    }
}
