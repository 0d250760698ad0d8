package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/** Proxy Leave Area: along what is left of a path that leads out, and across the nearest edge where none does. */
class LeaveAreaTest {
    private static final String OUT = "out";
    private static final double NEAR_M = 4;
    private static final GeoPoint INSIDE = PlanScene.at(4, 40);
    private static final GeoPoint NORTH = PlanScene.at(4, 120);
    private static final GeoArea AREA = new GeoArea(
            List.of(PlanScene.at(-6, 20), PlanScene.at(30, 20), PlanScene.at(30, 80), PlanScene.at(-6, 80)), List.of());

    /** The edge in the west is nearer, but the boat's path leads out in the north. */
    @Test
    void boatWhosePathWasTakenFromItGoesOutAlongIt() {
        PlanScene scene = driving(List.of(INSIDE, NORTH));
        scene.until("the boat is in the area", () -> distance(scene, INSIDE) < NEAR_M);
        scene.post(new Input.AbortMission(PlanScene.MISSION));

        leave(scene);

        assertThat(distance(scene, PlanScene.at(4, 85))).isLessThan(NEAR_M);
    }

    @Test
    void boatWhosePathEndsInsideGoesOutAcrossTheNearestEdge() {
        PlanScene scene = driving(List.of(INSIDE, PlanScene.at(4, 60)));
        scene.until("the boat is in the area", () -> distance(scene, INSIDE) < NEAR_M);
        scene.post(new Input.AbortMission(PlanScene.MISSION));

        leave(scene);

        assertThat(scene.world.hull("boat-1").position().lonDeg())
                .isLessThan(PlanScene.at(-6, 0).lonDeg());
    }

    /** The path that a boat has finished is not driven once more. */
    @Test
    void boatThatHasFinishedItsPathGoesOutAcrossTheNearestEdge() {
        PlanScene scene = driving(List.of(NORTH, INSIDE));
        scene.untilBoat("boat-1", "there");

        leave(scene);

        assertThat(distance(scene, PlanScene.at(-11, 40))).isLessThan(NEAR_M);
    }

    private static PlanScene driving(List<GeoPoint> points) {
        Value paths = ProxyMaps.toValue(Map.of("boat-1", new GeoPath(points)));
        return new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyExecutePath", "paths", paths)
                        .on("go", "ProxyPathCompleted", "there")
                        .plan("leave")
                        .asks("leave", "ProxyLeaveArea", "area", AREA)
                        .on("leave", "ProxyPathCompleted", OUT),
                1);
    }

    private static void leave(PlanScene scene) {
        scene.post(new Input.StartMission("leave", "test", Map.of()));
        scene.until(
                "the boat is out",
                () -> scene.marking(PlanScene.MISSION + 1, OUT).contains(PlanScene.boat("boat-1")));
    }

    private static double distance(PlanScene scene, GeoPoint point) {
        return Geodesy.distanceM(scene.world.hull("boat-1").position(), point);
    }
}
