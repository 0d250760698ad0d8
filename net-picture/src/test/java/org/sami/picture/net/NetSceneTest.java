package org.sami.picture.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;

class NetSceneTest {
    private static final Plan CLV = ShippedPlans.plan("clv");
    private static final NetDrawing DRAWING = draw(CLV);

    @Test
    void noLabelOfAShippedPlanHidesAnother() {
        ShippedPlans.LIBRARY.plans().forEach(plan -> {
            assertNothingIsHidden(plan, draw(plan));
            assertNothingIsHidden(plan, NetLayout.layered(plan, ShippedPlans.VOCABULARY, NetFonts::width));
        });
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void noLabelOfAFieldPlanHidesAnother(String name) {
        Path file = Path.of("../../shared/legacy-plans", name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        LegacyTableReader.fromClassPath(ShippedPlans.CRW + "/legacy.json", ShippedPlans.VOCABULARY);
        LegacyImport.Result imported = new LegacyImport(
                        ShippedPlans.VOCABULARY,
                        LegacyTableReader.fromClassPath(ShippedPlans.CRW + "/legacy.json", ShippedPlans.VOCABULARY)
                                .orThrow())
                .read(file);

        imported.project().orElseThrow().plans().forEach(plan -> assertNothingIsHidden(plan, draw(plan)));
    }

    private static NetDrawing draw(Plan plan) {
        return NetLayout.given(plan, ShippedPlans.VOCABULARY, NetFonts::width);
    }

    private static void assertNothingIsHidden(Plan plan, NetDrawing drawing) {
        NetScene scene = NetScene.of(plan, drawing, NetMode.ALL, Set.of());
        assertThat(scene.vertices())
                .hasSize(plan.places().size() + plan.transitions().size());
        List<DrawingBox> boxes = new ArrayList<>();
        scene.vertices().forEach(vertex -> boxes.add(vertex.box()));
        scene.labels().forEach(label -> boxes.add(label.box()));
        for (int i = 0; i < boxes.size(); i++) {
            for (int j = i + 1; j < boxes.size(); j++) {
                assertThat(boxes.get(i).intersects(boxes.get(j)))
                        .as("%s: %s and %s", plan.id(), boxes.get(i), boxes.get(j))
                        .isFalse();
            }
        }
    }

    @Test
    void nominalModeHidesWhatWasDrawnInRecoveryMode() {
        NetScene scene = NetScene.of(CLV, DRAWING, NetMode.NOMINAL, Set.of());

        assertThat(scene.vertices()).noneMatch(Vertex::recovery).isNotEmpty();
        assertThat(scene.silhouettes()).isEmpty();
        assertThat(scene.edges()).noneMatch(Edge::recovery).isNotEmpty();
        Set<String> shown = ids(scene);
        assertThat(scene.labels()).extracting(Label::of).allMatch(shown::contains);
        assertThat(CLV.places().stream().filter(place -> place.mode() == Mode.RECOVERY))
                .isNotEmpty();
    }

    @Test
    void recoveryModeShowsSilhouettesWithoutWordsAndLines() {
        NetScene scene = NetScene.of(CLV, DRAWING, NetMode.RECOVERY, Set.of());

        assertThat(scene.silhouettes()).hasSize(DRAWING.vertices().size());
        assertThat(scene.vertices()).isEmpty();
        assertThat(scene.edges()).isEmpty();
        assertThat(scene.labels()).isEmpty();
    }

    /** Thesis, Figure 5.2 (d). */
    @Test
    void recoveryModeShowsTheNeighboursOfWhatIsSelectedInFull() {
        String selected = CLV.transitions().get(0).id();

        NetScene scene = NetScene.of(CLV, DRAWING, NetMode.RECOVERY, Set.of(selected));

        List<String> neighbours = new ArrayList<>(List.of(selected));
        CLV.inEdgesOf(selected).forEach(edge -> neighbours.add(edge.place()));
        CLV.outEdgesOf(selected).forEach(edge -> neighbours.add(edge.place()));
        assertThat(scene.vertices()).extracting(Vertex::id).containsExactlyInAnyOrderElementsOf(neighbours);
        assertThat(scene.edges())
                .hasSize(CLV.inEdgesOf(selected).size()
                        + CLV.outEdgesOf(selected).size());
        assertThat(scene.vertices().size() + scene.silhouettes().size())
                .isEqualTo(DRAWING.vertices().size());
    }

    @Test
    void findsWhatLiesAtAPoint() {
        NetScene scene = NetScene.of(CLV, DRAWING, NetMode.ALL, Set.of());
        Vertex vertex = scene.vertices().get(2);
        Label words = scene.labels().stream()
                .filter(label -> label.of().equals(vertex.id()))
                .findFirst()
                .orElseThrow();
        Edge edge = scene.edges().get(0);
        double x = (edge.points().get(0).x() + edge.points().get(1).x()) / 2;
        double y = (edge.points().get(0).y() + edge.points().get(1).y()) / 2;

        assertThat(scene.vertexAt(vertex.centre().x(), vertex.centre().y(), 0)).contains(vertex);
        assertThat(scene.vertexAt(words.x() + 1, words.y() + 1, 0)).contains(vertex);
        assertThat(scene.edgeAt(x, y, 2)).contains(edge);
        assertThat(scene.vertexAt(-9999, -9999, 5)).isEmpty();
        assertThat(scene.edgeAt(-9999, -9999, 5)).isEmpty();
    }

    private static Set<String> ids(NetScene scene) {
        Set<String> ids = new java.util.HashSet<>();
        scene.vertices().forEach(vertex -> ids.add(vertex.id()));
        scene.edges().forEach(edge -> ids.add(edge.id()));
        return ids;
    }
}
