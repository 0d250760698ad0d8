package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.sami.crw.decision.BoatDescriptions;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;

/** Where boats are and stay, what they see and measure there, what they are called, and their links. */
final class SurroundingsEventCases {
    private static final GeoPoint STATION = PlanScene.at(40, 40);
    private static final GeoArea AREA = new GeoArea(
            List.of(PlanScene.at(-2, 20), PlanScene.at(30, 20), PlanScene.at(30, 60), PlanScene.at(-2, 60)), List.of());

    private SurroundingsEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "ProxyStationKeep",
                        Seen.ON_A_BOAT,
                        "a boat that is carried away from its station comes back",
                        SurroundingsEventCases::station)
                .shows(
                        "ProxyLeaveArea",
                        Seen.ON_A_BOAT,
                        "the boat that is inside lies outside of the nearest edge, the other one stays where it is",
                        SurroundingsEventCases::leaveArea)
                .shows(
                        "ProxyAreaSubscription",
                        Seen.IN_THE_MARKING,
                        "the boat that is inside moves on at once, the other one stays",
                        SurroundingsEventCases::subscription)
                .shows(
                        "ProxyEnteredArea",
                        Seen.IN_THE_MARKING,
                        "the boat that comes into the area moves on",
                        () -> area("ProxyEnteredArea", 0, 30))
                .shows(
                        "ProxyLeftArea",
                        Seen.IN_THE_MARKING,
                        "the boat that goes out of the area moves on",
                        () -> area("ProxyLeftArea", 30, -30))
                .shows(
                        "TakeMeasurement",
                        Seen.IN_THE_MARKING,
                        "the boat whose sensor has read moves on, the one without a sensor stays",
                        SurroundingsEventCases::measurement)
                .shows(
                        "MeasurementTaken",
                        Seen.IN_A_REPORT,
                        "what the sensor read is in the variable",
                        () -> assertThat(measured().variable("@value")).isEqualTo(new RealValue(17.5)))
                .shows(
                        "MeasurementFailed",
                        Seen.IN_THE_MARKING,
                        "a boat without the sensor moves on, where a transition waits for that",
                        () -> new PlanScene(
                                        new PlanSketch()
                                                .asks("measure", "TakeMeasurement", "sensor", new TextValue("salinity"))
                                                .on("measure", "MeasurementFailed", "failed"),
                                        1)
                                .untilBoat("boat-1", "failed"))
                .shows(
                        "PanoramaFailed",
                        Seen.IN_THE_MARKING,
                        "a boat without a camera moves on, where a transition waits for that",
                        () -> new PlanScene(
                                        new PlanSketch()
                                                .asks("look", "TakePanorama")
                                                .on("look", "PanoramaFailed", "failed"),
                                        1)
                                .untilBoat("boat-1", "failed"))
                .shows(
                        "TakePanorama",
                        Seen.ON_A_BOAT,
                        "the boat has turned all round and taken eight pictures",
                        () -> assertThat(pictured().world.hull("boat-1").pictures())
                                .hasSize(8))
                .shows(
                        "PanoramaTaken",
                        Seen.IN_A_REPORT,
                        "how many pictures there are is in the variable",
                        () -> assertThat(pictured().variable("@pictures")).isEqualTo(new IntegerValue(8)))
                .shows(
                        "ProxySetDescription",
                        Seen.IN_A_REPORT,
                        "the session knows by what word each boat is called, and a choice with a filter goes by it",
                        SurroundingsEventCases::description)
                .shows(
                        "DisconnectServer",
                        Seen.ON_A_BOAT,
                        "the link is down, and the boat stops under way as it does without one",
                        SurroundingsEventCases::disconnected)
                .shows(
                        "ReconnectServer",
                        Seen.ON_A_BOAT,
                        "the link is up again, and the boat goes on to where it was sent",
                        SurroundingsEventCases::reconnected);
    }

    private static void station() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "keep",
                                "ProxyStationKeep",
                                "points",
                                ProxyMaps.toValue(Map.of("boat-1", STATION)),
                                "radius",
                                new RealValue(10)),
                1);
        scene.until("the boat is at its station", () -> distance(scene, STATION) < 5);
        scene.run(5);
        scene.world.hull("boat-1").drift(20, 0);
        assertThat(distance(scene, STATION)).isGreaterThan(12);
        scene.until("the boat is back at its station", () -> distance(scene, STATION) < 5);
    }

    private static void leaveArea() {
        PlanScene scene = new PlanScene(
                new PlanSketch().asks("leave", "ProxyLeaveArea", "area", AREA).on("leave", "ProxyPathCompleted", "out"),
                2,
                hull -> {
                    if (Geodesy.distanceM(hull.position(), PlanScene.at(4, 0)) < 1) {
                        hull.drift(0, 35);
                    }
                });
        scene.untilBoat("boat-1", "out").untilBoat("boat-2", "out");
        assertThat(distance(scene, PlanScene.at(-7, 35))).isLessThan(4);
        assertThat(Geodesy.distanceM(scene.world.hull("boat-2").position(), PlanScene.at(8, 0)))
                .isLessThan(1);
    }

    private static void subscription() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("watch", "ProxyAreaSubscription", "area", AREA)
                        .on("watch", "ProxyEnteredArea", "inside"),
                2,
                hull -> {
                    if (Geodesy.distanceM(hull.position(), PlanScene.at(4, 0)) < 1) {
                        hull.drift(0, 30);
                    }
                });
        scene.untilBoat("boat-1", "inside");
        scene.run(5);
        assertThat(scene.stands(PlanScene.boat("boat-2"), "watch")).isTrue();
    }

    private static void area(String event, double northM, double thenNorthM) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("watch", "ProxyAreaSubscription", "area", AREA)
                        .on("watch", event, "moved"),
                1,
                hull -> hull.drift(0, northM));
        scene.run(5);
        assertThat(scene.stands(PlanScene.boat("boat-1"), "watch")).isTrue();
        scene.world.hull("boat-1").drift(0, thenNorthM);
        scene.untilBoat("boat-1", "moved");
    }

    private static void measurement() {
        PlanScene scene = measured();
        assertThat(scene.stands(PlanScene.boat("boat-2"), "measure")).isTrue();
    }

    private static PlanScene measured() {
        return new PlanScene(
                        new PlanSketch()
                                .variable("@value", "real")
                                .asks("measure", "TakeMeasurement", "sensor", new TextValue("temperature"))
                                .on("measure", "MeasurementTaken", "done")
                                .writing("value", "@value"),
                        2,
                        hull -> {
                            if (Geodesy.distanceM(hull.position(), PlanScene.at(4, 0)) < 1) {
                                hull.measures("water", "temperature", 17.5);
                            }
                        })
                .untilBoat("boat-1", "done");
    }

    private static PlanScene pictured() {
        return new PlanScene(
                        new PlanSketch()
                                .variable("@pictures", "integer")
                                .asks("look", "TakePanorama")
                                .on("look", "PanoramaTaken", "done")
                                .writing("pictures", "@pictures"),
                        1,
                        TestHull::photographs)
                .untilBoat("boat-1", "done");
    }

    private static void description() {
        PlanScene scene = new PlanScene(
                new PlanSketch().asks("name", "ProxySetDescription", "description", new TextValue("SHORE")), 2);
        scene.run(1);
        String described =
                scene.world.host.ask(view -> BoatDescriptions.of(view, "boat-2").orElse(""));
        assertThat(described).isEqualTo("SHORE");
    }

    private static void disconnected() {
        PlanScene scene = cutOff();
        GeoPoint held = scene.world.hull("boat-1").position();
        scene.run(20);
        assertThat(link(scene)).isEqualTo(LinkState.LOST);
        assertThat(Geodesy.distanceM(held, scene.world.hull("boat-1").position()))
                .isLessThan(6);
    }

    private static void reconnected() {
        PlanScene scene = cutOff();
        scene.press("On");
        scene.until("the boat is where it was sent", () -> distance(scene, STATION) < 5);
        assertThat(link(scene)).isEqualTo(LinkState.LINKED);
    }

    /** A boat on its way, whose link a button has cut; another button takes it up again. */
    private static PlanScene cutOff() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", STATION)
                        .on(
                                "go",
                                "OperatorInterruptReceived",
                                "off",
                                "any-token",
                                "interruptName",
                                new TextValue("Off"))
                        .asks("off", "DisconnectServer")
                        .on("off", "OperatorInterruptReceived", "on", "any-token", "interruptName", new TextValue("On"))
                        .asks("on", "ReconnectServer")
                        .asks("on", "ProxyGotoLatLon", "location", STATION),
                1);
        scene.run(8);
        assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
        scene.press("Off");
        scene.until("the link is down", () -> link(scene) == LinkState.LOST);
        scene.run(10);
        return scene;
    }

    private static LinkState link(PlanScene scene) {
        return scene.world.boats.find("boat-1").orElseThrow().status().link();
    }

    private static double distance(PlanScene scene, GeoPoint point) {
        return Geodesy.distanceM(scene.world.hull("boat-1").position(), point);
    }
}
