package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.boat.link.Gains;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Boats that join while plans run, what they hold and how they are set, and what the field plans ask besides. */
final class FleetEventCases {
    private static final double NEAR_M = 4;
    private static final GeoPoint NORTH = PlanScene.at(0, 40);
    private static final GeoPoint EAST = PlanScene.at(40, 40);
    private static final GeoPoint AFAR = PlanScene.at(0, 200);

    private FleetEventCases() {}

    static void add(EventCatalogue catalogue) {
        joining(catalogue);
        ways(catalogue);
        settings(catalogue);
        others(catalogue);
    }

    private static void joining(EventCatalogue catalogue) {
        catalogue.shows(
                "ConnectExistingProxy",
                Seen.IN_THE_MARKING,
                "the boat at the address has a token in the mission",
                () -> new PlanScene(
                                new PlanSketch()
                                        .asks(
                                                "ask",
                                                "ConnectExistingProxy",
                                                "name",
                                                new TextValue("red"),
                                                "server",
                                                new TextValue("10.0.0.1:11411"))
                                        .joining("ask", "ProxyCreated", "team"),
                                0)
                        .untilBoat("red at 10.0.0.1:11411", "team"));
        catalogue.shows(
                "ConnectExistingProxyId",
                Seen.IN_THE_MARKING,
                "the boat at the id's address has a token in the mission",
                () -> {
                    Map<String, Value> id = new LinkedHashMap<>();
                    id.put("name", new TextValue("green"));
                    id.put("color", new TextValue(""));
                    id.put("server", new TextValue("10.0.0.2:11411"));
                    id.put("imageStorageDirectory", new TextValue(""));
                    new PlanScene(
                                    new PlanSketch()
                                            .asks(
                                                    "ask",
                                                    "ConnectExistingProxyId",
                                                    "boatId",
                                                    new RecordValue("BoatId", id))
                                            .joining("ask", "ProxyCreated", "team"),
                                    0)
                            .untilBoat("green at 10.0.0.2:11411", "team");
                });
        catalogue.shows(
                "CreateSimulatedProxy",
                Seen.IN_THE_MARKING,
                "as many boats as are asked for have tokens in the mission",
                () -> new PlanScene(
                                new PlanSketch()
                                        .asks(
                                                "ask",
                                                "CreateSimulatedProxy",
                                                "name",
                                                new TextValue("toy"),
                                                "startLocation",
                                                NORTH,
                                                "numberToCreate",
                                                new IntegerValue(2))
                                        .joining("ask", "ProxyCreated", "team"),
                                0)
                        .untilBoat("toy0", "team")
                        .untilBoat("toy1", "team"));
    }

    private static void ways(EventCatalogue catalogue) {
        catalogue.shows(
                "ProxyExecutePathAndBlock",
                Seen.ON_A_BOAT,
                "the boat lies at the end of its path, and another mission's command waits",
                () -> assertBlocked(
                        "ProxyExecutePathAndBlock",
                        "paths",
                        ProxyMaps.toValue(Map.of("boat-1", new GeoPath(List.of(NORTH))))));
        catalogue.shows(
                "ProxyGotoPointAndBlock",
                Seen.ON_A_BOAT,
                "the boat lies at its point, and another mission's command waits",
                () -> assertBlocked("ProxyGotoPointAndBlock", "points", ProxyMaps.toValue(Map.of("boat-1", NORTH))));
        catalogue.shows("BlockMovementDone", Seen.IN_THE_MARKING, "the boat that has stopped moves on", () -> {
            PlanScene scene = new PlanScene(
                    new PlanSketch().asks("hold", "BlockMovement").on("hold", "BlockMovementDone", "held"), 1);
            scene.untilBoat("boat-1", "held");
            assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        });
        catalogue.shows(
                "ProxyGotoLocationList", Seen.ON_A_BOAT, "the boat goes one location further at each entry", () -> {
                    PlanScene scene = listed();
                    scene.until("boat-1 is at the first", () -> distance(scene, "boat-1", NORTH) < NEAR_M);
                    scene.until("boat-1 is at the second", () -> distance(scene, "boat-1", EAST) < NEAR_M);
                });
        catalogue.shows(
                "ProxyListCompleted",
                Seen.IN_THE_MARKING,
                "a boat that has been at all of its locations moves on",
                () -> {
                    PlanScene scene = listed();
                    scene.untilBoat("boat-1", "over");
                    assertThat(scene.used("ProxyPathCompleted")).hasSize(2);
                });
        catalogue.shows(
                "ProxyResendWaypoints",
                Seen.ON_A_BOAT,
                "the boat gets its waypoints once more, and comes to their end",
                () -> {
                    PlanScene scene = new PlanScene(
                            new PlanSketch()
                                    .asks("go", "ProxyGotoLatLon", "location", NORTH)
                                    .asks("go", "StartProxyTimer", "duration", new DurationValue(3000))
                                    .on("go", "ProxyTimerExpired", "again")
                                    .asks("again", "ProxyResendWaypoints")
                                    .on("again", "ProxyPathCompleted", "there"),
                            1);
                    scene.run(2);
                    long before = scene.world
                            .boats
                            .find("boat-1")
                            .orElseThrow()
                            .commands()
                            .uploads()
                            .sent();
                    scene.untilBoat("boat-1", "there");
                    assertThat(scene.world
                                    .boats
                                    .find("boat-1")
                                    .orElseThrow()
                                    .commands()
                                    .uploads()
                                    .sent())
                            .isEqualTo(before + 1);
                    assertThat(distance(scene, "boat-1", NORTH)).isLessThan(NEAR_M);
                });
        catalogue.shows(
                "PathRequest",
                Seen.IN_THE_MARKING,
                "there is a path from the boat to its location",
                FleetEventCases::assertPathFound);
        catalogue.shows(
                "PathResponse",
                Seen.IN_THE_MARKING,
                "the boat moves on, the sets of paths are in the variable",
                FleetEventCases::assertPathFound);
    }

    private static void assertBlocked(String output, String field, Value where) {
        PlanScene scene = new PlanScene(
                new PlanSketch().asks("go", output, field, where).on("go", "ProxyPathCompleted", "there"), 1);
        scene.untilBoat("boat-1", "there");
        scene.world
                .boats
                .find("boat-1")
                .orElseThrow()
                .commands()
                .submit(FollowPath.goTo("another mission's", 99, 1, EAST, Priority.MEDIUM));
        scene.run(20);
        assertThat(distance(scene, "boat-1", NORTH)).isLessThan(NEAR_M);
    }

    private static PlanScene listed() {
        Value list = ProxyMaps.toValue(Map.of("boat-1", new ListValue(List.of(NORTH, EAST))));
        return new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLocationList", "locations", list)
                        .on("go", "ProxyPathCompleted", "arrived")
                        .on("arrived", "", "go", "any-proxy")
                        .on("go", "ProxyListCompleted", "over"),
                1);
    }

    private static void assertPathFound() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@options", "list<PathOption>")
                        .asks("ask", "PathRequest", "points", ProxyMaps.toValue(Map.of("boat-1", EAST)))
                        .on("ask", "PathResponse", "known")
                        .writing("options", "@options"),
                1);
        scene.untilBoat("boat-1", "known");
        RecordValue best =
                (RecordValue) ((ListValue) scene.variable("@options")).items().get(0);
        List<GeoPoint> path = ProxyMaps.read(best.field("paths").orElseThrow(), GeoPath.class)
                .get("boat-1")
                .points();
        assertThat(Geodesy.distanceM(path.get(path.size() - 1), EAST)).isLessThan(0.1);
    }

    private static void settings(EventCatalogue catalogue) {
        catalogue.shows(
                "SetVelocityMultiplier",
                Seen.ON_A_BOAT,
                "at a quarter of the speed the boat comes a quarter as far, or less",
                () -> assertThat(metresIn20s(0.25)).isBetween(2.0, metresIn20s(1) * 0.4));
        catalogue.shows(
                "SetVelocityMultiplierSucceeded",
                Seen.IN_THE_MARKING,
                "the boat that has taken the multiplier over moves on",
                () -> multiplier(0.5).untilBoat("boat-1", "set"));
        catalogue.shows(
                "SetVelocityMultiplierFailed",
                Seen.IN_THE_MARKING,
                "a boat that cannot take the multiplier moves on, the reason is in the variable",
                () -> {
                    PlanScene scene = multiplier(1000);
                    scene.untilBoat("boat-1", "unset");
                    assertThat(((TextValue) scene.variable("@why")).value()).isNotBlank();
                });
        catalogue.shows("SetGains", Seen.ON_A_BOAT, "the gains are in force on the boat", () -> {
            PlanScene scene = gains(0.7);
            scene.untilBoat("boat-1", "set");
            assertThat(scene.world
                            .boats
                            .find("boat-1")
                            .orElseThrow()
                            .settings()
                            .inForce()
                            .orElseThrow()
                            .heading())
                    .isEqualTo(new Gains(0.7, 0, 0));
        });
        catalogue.shows(
                "SetGainsSucceeded",
                Seen.IN_THE_MARKING,
                "the boat that has taken the gains over moves on",
                () -> gains(0.7).untilBoat("boat-1", "set"));
        catalogue.shows(
                "SetGainsFailed",
                Seen.IN_THE_MARKING,
                "a boat that cannot take the gains moves on, the reason is in the variable",
                () -> {
                    PlanScene scene = gains(-5000);
                    scene.untilBoat("boat-1", "unset");
                    assertThat(((TextValue) scene.variable("@why")).value()).isNotBlank();
                });
    }

    private static double metresIn20s(double factor) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("set", "SetVelocityMultiplier", "multiplier", new RealValue(factor))
                        .on("set", "SetVelocityMultiplierSucceeded", "go")
                        .asks("go", "ProxyGotoLatLon", "location", AFAR),
                1);
        scene.untilBoat("boat-1", "go");
        scene.run(5); // it has turned towards its goal
        GeoPoint from = scene.world.hull("boat-1").position();
        scene.run(20);
        return Geodesy.distanceM(from, scene.world.hull("boat-1").position());
    }

    private static PlanScene multiplier(double factor) {
        return new PlanScene(
                new PlanSketch()
                        .variable("@why", "text")
                        .asks("ask", "SetVelocityMultiplier", "multiplier", new RealValue(factor))
                        .on("ask", "SetVelocityMultiplierSucceeded", "set")
                        .on("ask", "SetVelocityMultiplierFailed", "unset")
                        .writing("reason", "@why"),
                1);
    }

    private static PlanScene gains(double rudderP) {
        List<Object> fields = new ArrayList<>(List.of("rudderP", new RealValue(rudderP)));
        for (String other : List.of("rudderI", "rudderD", "thrustI", "thrustD")) {
            fields.addAll(List.of(other, new RealValue(0)));
        }
        fields.addAll(List.of("thrustP", new RealValue(0.3)));
        return new PlanScene(
                new PlanSketch()
                        .variable("@why", "text")
                        .asks("ask", "SetGains", fields.toArray())
                        .on("ask", "SetGainsSucceeded", "set")
                        .on("ask", "SetGainsFailed", "unset")
                        .writing("reason", "@why"),
                1);
    }

    private static void others(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorBackgroundAction",
                Seen.AS_A_DECISION,
                "the operator is asked to do it",
                () -> assertThat(background().decision().prompt()).isEqualTo("Look for other boats"));
        catalogue.shows(
                "OperatorBackgroundActionDone",
                Seen.IN_THE_MARKING,
                "the mission goes on when the operator says that it is done",
                () -> {
                    PlanScene scene = background();
                    scene.run(30);
                    assertThat(scene.marking(PlanScene.MISSION, "done")).isEmpty();
                    scene.answer(new Answer.Fields(Map.of()));
                    scene.untilGeneric("done");
                });
        catalogue.shows(
                "UnknownRequest",
                Seen.IN_A_REPORT,
                "the operator is told which request it was that nobody knows",
                () -> {
                    PlanScene scene = unknown();
                    scene.run(1);
                    assertThat(scene.messages()).anyMatch(text -> text.contains("crw.event.Dance"));
                });
        catalogue.shows("UnknownAnswer", Seen.IN_THE_MARKING, "the transition that waits for it does not fire", () -> {
            PlanScene scene = unknown();
            scene.run(60);
            assertThat(scene.marking(PlanScene.MISSION, "after")).isEmpty();
        });
    }

    private static PlanScene background() {
        return new PlanScene(
                new PlanSketch()
                        .asks(
                                "ask",
                                "OperatorBackgroundAction",
                                "question",
                                text("Look for other boats"),
                                "duration",
                                new DurationValue(10_000))
                        .on("ask", "OperatorBackgroundActionDone", "done"),
                0);
    }

    private static PlanScene unknown() {
        return new PlanScene(
                new PlanSketch()
                        .asks("here", "UnknownRequest", "class", text("crw.event.Dance"), "content", text("{}"))
                        .on("here", "UnknownAnswer", "after"),
                1);
    }

    private static TextValue text(String text) {
        return new TextValue(text);
    }

    private static double distance(PlanScene scene, String boat, GeoPoint point) {
        return Geodesy.distanceM(scene.world.hull(boat).position(), point);
    }
}
