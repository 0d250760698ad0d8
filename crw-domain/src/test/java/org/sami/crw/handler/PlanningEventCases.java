package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;

/** The exploration of areas and the distribution of locations. */
final class PlanningEventCases {
    private PlanningEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "ProxyExploreArea",
                        Seen.ON_A_BOAT,
                        "the boats come near every point of the area, then each has completed",
                        PlanningEventCases::exploration)
                .shows(
                        "DistributeLocationsRequest",
                        Seen.IN_THE_MARKING,
                        "locations are spread over the area, each in the list of one boat",
                        PlanningEventCases::distribution)
                .shows(
                        "DistributeLocationsResponse",
                        Seen.IN_THE_MARKING,
                        "the boats move on, the lists are in the variable",
                        PlanningEventCases::distribution);
    }

    private static void exploration() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyExploreArea", "area", box(0, 10, 60, 50), "spacing", new RealValue(10))
                        .on("go", "ProxyPathCompleted", "done"),
                2);
        List<GeoPoint> driven = new ArrayList<>();
        scene.until("both have explored", () -> {
            driven.add(scene.world.hull("boat-1").position());
            driven.add(scene.world.hull("boat-2").position());
            return scene.stands(PlanScene.boat("boat-1"), "done") && scene.stands(PlanScene.boat("boat-2"), "done");
        });
        for (int eastM = 1; eastM < 60; eastM += 4) {
            for (int northM = 11; northM < 50; northM += 4) {
                GeoPoint point = PlanScene.at(eastM, northM);
                assertThat(driven)
                        .as("%s m east, %s m north", eastM, northM)
                        .anyMatch(at -> Geodesy.distanceM(at, point) < 5 + 4);
            }
        }
        assertThat(scene.messages())
                .anyMatch(text -> text.startsWith("Exploring 2400 m² in ") && text.contains("stay uncovered"));
    }

    private static void distribution() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@lists", "map<proxy,list<point>>")
                        .asks(
                                "ask",
                                "DistributeLocationsRequest",
                                "area",
                                box(0, 0, 100, 40),
                                "spacing",
                                new RealValue(15),
                                "avoid",
                                new ListValue(List.of(box(40, -10, 60, 50))))
                        .on("ask", "DistributeLocationsResponse", "known")
                        .writing("locations", "@lists"),
                2);
        scene.untilBoat("boat-1", "known").untilBoat("boat-2", "known");
        Map<String, ListValue> lists = ProxyMaps.read(scene.variable("@lists"), ListValue.class);
        List<GeoPoint> all = new ArrayList<>();
        lists.values().forEach(list -> list.items().forEach(item -> all.add((GeoPoint) item)));
        assertThat(lists).containsOnlyKeys("boat-1", "boat-2");
        assertThat(all).hasSizeGreaterThan(8).doesNotHaveDuplicates();
        for (GeoPoint one : all) {
            assertThat(one.lonDeg())
                    .matches(lon -> lon < PlanScene.at(32.6, 0).lonDeg()
                            || lon > PlanScene.at(67.4, 0).lonDeg());
            assertThat(all)
                    .filteredOn(other -> Geodesy.distanceM(one, other) < 14.9)
                    .hasSize(1);
        }
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(
                List.of(
                        PlanScene.at(west, south),
                        PlanScene.at(east, south),
                        PlanScene.at(east, north),
                        PlanScene.at(west, north)),
                List.of());
    }
}
