package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.sami.crw.markup.MapRelevance.MapType;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.map.LayerState;
import org.sami.crw.operator.map.LayerState.Reason;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.NamedArea;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownBoat;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.operator.map.ShownPart;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/** What markups do to the map. Pressing Look, which names the first of two boats, receives the event that has them. */
final class MapMarkupCases {
    private static final BooleanValue YES = new BooleanValue(true);
    private static final GeoPoint POINT = PlanScene.at(300, 300);
    private static final GeoArea AREA = new GeoArea(
            List.of(PlanScene.at(200, 200), PlanScene.at(400, 200), PlanScene.at(400, 400), PlanScene.at(200, 400)),
            List.of());

    private MapMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        proxy(catalogue);
        area(catalogue);
        modification(catalogue);
        information(catalogue);
        frequency(catalogue);
        component(catalogue);
    }

    private static PlanSketch look() {
        return new PlanSketch()
                .on("start", "OperatorInterruptReceived", "start", "generic", "interruptName", new TextValue("Look"));
    }

    /** Two boats 500 m apart, with a thermometer each; nobody has looked yet. */
    private static PlanScene scene(PlanSketch plan) {
        PlanScene scene = new PlanScene(plan, 0);
        scene.world.addBoat("boat-1", 0, 0, hull -> hull.measures("thermometer", "water", 5));
        scene.world.addBoat("boat-2", 500, 0, hull -> hull.measures("thermometer", "water", 9));
        scene.run(3);
        return scene;
    }

    private static MapSnapshot looked(PlanSketch plan) {
        PlanScene scene = scene(plan);
        scene.press("Look", "boat-1");
        return later(scene);
    }

    private static MapSnapshot later(PlanScene scene) {
        scene.run(2.5); // data are computed once a second
        return map(scene).snapshot();
    }

    private static MapModel map(PlanScene scene) {
        return scene.world.operator.map();
    }

    private static void proxy(MarkupCatalogue catalogue) {
        catalogue.shows(
                "RelevantProxy.proxy=RELEVANT_PROXIES",
                "the named boats are highlighted",
                () -> assertThat(highlighted(looked(look().marked("RelevantProxy", "proxy", "RELEVANT_PROXIES"))))
                        .containsExactly("boat-1"));
        catalogue.shows(
                "RelevantProxy.proxy=ALL_PROXIES",
                "all boats are highlighted",
                () -> assertThat(highlighted(looked(look().marked("RelevantProxy", "proxy", "ALL_PROXIES"))))
                        .containsExactly("boat-1", "boat-2"));
        catalogue.shows(
                "RelevantProxy.showPath",
                "future paths of these boats are drawn",
                () -> assertShownOfFirst(showing("showPath"), ShownLayer.FUTURE_PATHS));
        catalogue.shows(
                "RelevantProxy.showDiagnostic",
                "the state of these boats is written beside them",
                () -> assertShownOfFirst(showing("showDiagnostic"), ShownLayer.BOAT_STATE));
        catalogue.shows("RelevantProxy.showData", "what these boats measured is drawn, and nothing else", () -> {
            MapSnapshot map = showing("showData");

            assertShownOfFirst(map, ShownLayer.SENSOR_DATA);
            assertThat(map.data())
                    .singleElement()
                    .satisfies(layer -> assertThat(layer.legend().greatest()).isEqualTo(5));
        });
    }

    private static List<String> highlighted(MapSnapshot map) {
        return map.boats().stream()
                .filter(ShownBoat::highlighted)
                .map(ShownBoat::boat)
                .toList();
    }

    private static MapSnapshot showing(String option) {
        assertThat(looked(look()).layers()).extracting(LayerState::reason).containsOnly(Reason.DEFAULT);
        return looked(look().marked("RelevantProxy", "proxy", "RELEVANT_PROXIES", option, YES));
    }

    private static void assertShownOfFirst(MapSnapshot map, ShownLayer layer) {
        LayerState state = map.layer(layer);

        assertThat(state.reason()).isEqualTo(Reason.MARKUP);
        assertThat(state.why()).isEqualTo("OperatorInterruptReceived of root");
        assertThat(state.shows("boat-1")).isTrue();
        assertThat(state.shows("boat-2")).isFalse();
    }

    private static void area(MarkupCatalogue catalogue) {
        catalogue.shows("RelevantArea.source=AREA", "the map goes to the area", () -> {
            ShownPart view = looked(toArea()).view().orElseThrow();

            AREA.outline().forEach(corner -> assertThat(has(view, corner)).isTrue());
            assertThat(has(view, TestWorld.HOME)).isFalse();
        });
        catalogue.shows(
                "RelevantArea.area",
                "the area is drawn",
                () -> assertThat(looked(toArea()).areas())
                        .contains(new NamedArea(
                                ShownLayer.RELEVANT_AREA,
                                PlanScene.MISSION,
                                "OperatorInterruptReceived of root",
                                AREA)));
        catalogue.shows("RelevantArea.source=POINT", "the map goes to the point", () -> {
            ShownPart view = looked(toPoint()).view().orElseThrow();

            assertThat(has(view, POINT)).isTrue();
            assertThat(has(view, AREA.outline().get(0))).isFalse();
        });
        catalogue.shows(
                "RelevantArea.point",
                "the point is drawn",
                () -> assertThat(looked(toPoint()).places())
                        .contains(new ShownPlace(PlanScene.MISSION, "OperatorInterruptReceived of root", POINT)));
        catalogue.shows("RelevantArea.source=ALL_PROXIES", "the map goes to all boats", () -> {
            ShownPart view = looked(look().marked("RelevantArea", "source", "ALL_PROXIES"))
                    .view()
                    .orElseThrow();

            assertThat(has(view, PlanScene.at(0, 0))).isTrue();
            assertThat(has(view, PlanScene.at(500, 0))).isTrue();
        });
        catalogue.shows("RelevantArea.source=RELEVANT_PROXIES", "the map goes to the named boats", () -> {
            ShownPart view = looked(look().marked("RelevantArea", "source", "RELEVANT_PROXIES"))
                    .view()
                    .orElseThrow();

            assertThat(has(view, PlanScene.at(0, 0))).isTrue();
            assertThat(has(view, PlanScene.at(500, 0))).isFalse();
        });
        for (MapType background : MapType.values()) {
            catalogue.shows(
                    "RelevantArea.mapType=" + background,
                    "the map's background is that",
                    () -> assertThat(looked(look().marked(
                                                    "RelevantArea",
                                                    "source",
                                                    "ALL_PROXIES",
                                                    "mapType",
                                                    background.name()))
                                    .view())
                            .map(ShownPart::background)
                            .contains(background));
        }
    }

    private static PlanSketch toArea() {
        return look().marked("RelevantArea", "source", "AREA", "area", AREA);
    }

    private static PlanSketch toPoint() {
        return look().marked("RelevantArea", "source", "POINT", "point", POINT);
    }

    private static boolean has(ShownPart view, GeoPoint point) {
        return view.southDeg() <= point.latDeg()
                && point.latDeg() <= view.northDeg()
                && view.westDeg() <= point.lonDeg()
                && point.lonDeg() <= view.eastDeg();
    }

    private static void modification(MarkupCatalogue catalogue) {
        GeoPoint southWest = PlanScene.at(-100, -100);
        GeoPoint northEast = PlanScene.at(300, 300); // the middle of the area
        catalogue.shows("RelevantArea.modification=EXPAND", "what is shown is widened to the area", () -> {
            ShownPart view = modified("EXPAND", southWest, northEast);

            assertThat(has(view, southWest)).isTrue();
            assertThat(has(view, AREA.outline().get(2))).isTrue();
        });
        catalogue.shows("RelevantArea.modification=REDUCE", "what is shown is narrowed to the area", () -> {
            ShownPart view = modified("REDUCE", southWest, northEast);

            assertThat(has(view, southWest)).isFalse();
            assertThat(has(view, AREA.outline().get(0))).isTrue();
            assertThat(has(view, AREA.outline().get(2))).isFalse();
        });
    }

    private static ShownPart modified(String how, GeoPoint southWest, GeoPoint northEast) {
        PlanScene scene = scene(look().marked("RelevantArea", "source", "AREA", "area", AREA, "modification", how));
        map(scene).moved(southWest.latDeg(), southWest.lonDeg(), northEast.latDeg(), northEast.lonDeg());
        scene.press("Look", "boat-1");
        return later(scene).view().orElseThrow();
    }

    private static void information(MarkupCatalogue catalogue) {
        catalogue.shows("RelevantInformation.source", "what the sensor measured is drawn", () -> {
            assertThat(informed("thermometer", "HEATMAP").data()).hasSize(1);
            assertThat(informed("sonar", "HEATMAP").data()).isEmpty();
        });
        catalogue.shows("RelevantInformation.visualization=HEATMAP", "each cell has the colour of its value", () -> {
            SensorLayer layer = informed("thermometer", "HEATMAP").data().get(0);

            assertThat(layer.visualization()).isEqualTo(Visualization.HEATMAP);
            assertThat(layer.isDrawn(0, 0)).isTrue();
            assertThat(layer.grid().value(0, 0)).hasValue(5);
            assertThat(layer.legend().least()).isEqualTo(5);
            assertThat(layer.legend().greatest()).isEqualTo(9);
        });
        catalogue.shows("RelevantInformation.visualization=CONTOUR", "lines are drawn at the legend's marks", () -> {
            SensorLayer layer = informed("thermometer", "CONTOUR").data().get(0);

            assertThat(layer.contours())
                    .extracting(line -> line.value())
                    .isEqualTo(layer.legend().marks());
            assertThat(layer.contours()).isNotEmpty();
        });
        catalogue.shows("RelevantInformation.visualization=THRESHOLD", "cells below are not drawn", () -> {
            SensorLayer layer = informed("thermometer", "THRESHOLD").data().get(0);

            assertThat(layer.threshold()).isEqualTo(7);
            assertThat(layer.isDrawn(0, 0)).isFalse();
            assertThat(layer.isDrawn(layer.grid().columns() - 1, 0)).isTrue();
        });
    }

    private static MapSnapshot informed(String sensor, String visualization) {
        MapSnapshot map = looked(
                look().marked("RelevantInformation", "source", new TextValue(sensor), "visualization", visualization));
        assertThat(map.layer(ShownLayer.SENSOR_DATA).reason()).isEqualTo(Reason.MARKUP);
        return map;
    }

    private static void frequency(MarkupCatalogue catalogue) {
        catalogue.shows("ManipulationFrequency.limit=SUPPRESS", "what comes too soon is left out", () -> {
            PlanScene scene = scene(limited("ManipulationFrequency", "SUPPRESS"));
            ShownPart second = lookedAtBoth(scene);

            assertThat(has(second, PlanScene.at(0, 0))).isTrue();
            scene.run(20);
            assertThat(map(scene).snapshot().view()).contains(second);
            scene.press("Look", "boat-2");
            assertThat(has(later(scene).view().orElseThrow(), PlanScene.at(500, 0)))
                    .isTrue();
        });
        catalogue.shows("ManipulationFrequency.limit=TIMED_BATCH", "what comes too soon is shown later", () -> {
            PlanScene scene = scene(limited("ManipulationFrequency", "TIMED_BATCH"));
            ShownPart second = lookedAtBoth(scene);

            assertThat(has(second, PlanScene.at(0, 0))).isTrue();
            scene.run(20);
            assertThat(has(map(scene).snapshot().view().orElseThrow(), PlanScene.at(500, 0)))
                    .isTrue();
        });
    }

    private static PlanSketch limited(String markup, String limit) {
        return look().marked("RelevantArea", "source", "RELEVANT_PROXIES").marked(markup, "limit", limit);
    }

    /** Looks at the first boat and at once at the second. */
    private static ShownPart lookedAtBoth(PlanScene scene) {
        scene.press("Look", "boat-1");
        scene.press("Look", "boat-2");
        MapSnapshot map = later(scene);
        assertThat(map.heldBack()).contains("of root").contains("map");
        return map.view().orElseThrow();
    }

    private static void component(MarkupCatalogue catalogue) {
        catalogue.shows("ManipulationComponent.limit=FOCUS_SUPPRESS", "the map is left alone in focus", () -> {
            PlanScene scene = scene(limited("ManipulationComponent", "FOCUS_SUPPRESS"));
            map(scene).focus(true);
            scene.press("Look", "boat-1");
            assertThat(later(scene).view()).isEqualTo(Optional.empty());

            map(scene).focus(false);
            scene.press("Look", "boat-1");
            assertThat(later(scene).view()).isPresent();
        });
        catalogue.shows("ManipulationComponent.limit=TIMED_SUPPRESS", "the map is left alone after its use", () -> {
            PlanScene scene = scene(limited("ManipulationComponent", "TIMED_SUPPRESS"));
            map(scene).touched();
            scene.press("Look", "boat-1");
            assertThat(later(scene).view()).isEqualTo(Optional.empty());

            scene.run(10);
            scene.press("Look", "boat-1");
            assertThat(later(scene).view()).isPresent();
        });
    }
}
