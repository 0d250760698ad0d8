package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.sami.crw.event.Allocation;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;

/** Requests to services and what they answer. */
final class ServiceEventCases {
    private static final GeoPoint SPOT = PlanScene.at(0, 20);

    private ServiceEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "AllocationRequest",
                        Seen.IN_THE_MARKING,
                        "each boat gets the locations near it, every location one boat",
                        ServiceEventCases::allocation)
                .shows(
                        "AllocationResponse",
                        Seen.IN_THE_MARKING,
                        "the boats move on, the allocations are in the variable",
                        ServiceEventCases::allocation)
                .shows(
                        "AssembleLocationRequest",
                        Seen.IN_THE_MARKING,
                        "each boat gets a location near the given one, no two closer than the spacing",
                        ServiceEventCases::assembly)
                .shows(
                        "AssembleLocationResponse",
                        Seen.IN_THE_MARKING,
                        "the boats move on, the locations are in the variable",
                        ServiceEventCases::assembly)
                .shows(
                        "ProxyCompareDistanceRequest",
                        Seen.IN_THE_MARKING,
                        "each boat moves on by how far it is from its own location",
                        () -> compare("boat-1", 10, "near"))
                .shows(
                        "QuantityGreater",
                        Seen.IN_THE_MARKING,
                        "a boat further away than the distance moves on",
                        () -> compare("boat-2", 10, "far"))
                .shows(
                        "QuantityLess",
                        Seen.IN_THE_MARKING,
                        "a boat nearer than the distance moves on",
                        () -> compare("boat-1", 10, "near"))
                .shows(
                        "QuantityEqual",
                        Seen.IN_THE_MARKING,
                        "a boat just as far as the distance moves on",
                        () -> compare("boat-1", 0, "equal"));
    }

    private static void allocation() {
        GeoPoint west = PlanScene.at(-30, 0);
        GeoPoint east = PlanScene.at(60, 0);
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@allocations", "list<Allocation>")
                        .asks("ask", "AllocationRequest", "locations", new ListValue(List.of(east, west)))
                        .on("ask", "AllocationResponse", "known")
                        .writing("allocations", "@allocations"),
                2);
        scene.untilBoat("boat-1", "known").untilBoat("boat-2", "known");
        Allocation best = Allocation.of(
                ((ListValue) scene.variable("@allocations")).items().get(0));
        assertThat(best.paths().get("boat-1").points()).containsExactly(west);
        assertThat(best.paths().get("boat-2").points()).containsExactly(east);
    }

    private static void assembly() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@points", "map<proxy,point>")
                        .asks("ask", "AssembleLocationRequest", "location", SPOT, "spacing", new RealValue(10))
                        .on("ask", "AssembleLocationResponse", "known")
                        .writing("points", "@points"),
                2);
        scene.untilBoat("boat-1", "known").untilBoat("boat-2", "known");
        Map<String, GeoPoint> points = ProxyMaps.read(scene.variable("@points"), GeoPoint.class);
        assertThat(Geodesy.distanceM(points.get("boat-1"), points.get("boat-2")))
                .isBetween(9.99, 25.0);
        assertThat(Geodesy.distanceM(points.get("boat-1"), SPOT)).isLessThan(25);
    }

    /** Boat 1 lies on its own location, boat 2 some 50 m from its own. */
    private static void compare(String boat, double distanceM, String place) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "ask",
                                "ProxyCompareDistanceRequest",
                                "location",
                                ProxyMaps.toValue(Map.of("boat-1", PlanScene.at(4, 0), "boat-2", PlanScene.at(8, 50))),
                                "distance",
                                new RealValue(distanceM))
                        .on("ask", "QuantityGreater", "far")
                        .on("ask", "QuantityLess", "near")
                        .on("ask", "QuantityEqual", "equal"),
                2);
        scene.untilBoat(boat, place);
    }
}
