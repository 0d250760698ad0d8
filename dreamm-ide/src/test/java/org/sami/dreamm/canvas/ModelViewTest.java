package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.document.DocumentListener;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.ui.EventThread;
import org.sami.ui.net.NetKey;

class ModelViewTest {
    private final EditorScene scene = EditorScene.of("clv");

    @AfterEach
    void close() {
        scene.close();
    }

    @Test
    void aDragMovesWhatIsSelectedAsOneEdit() {
        Plan before = scene.plan();
        scene.click("choose", 0);
        scene.click("execute", InputEvent.SHIFT_DOWN_MASK);
        LayoutPoint execute = scene.vertex("execute").centre();
        LayoutPoint choose = scene.vertex("choose").centre();

        scene.drag(scene.pixel("choose"), 0, 120, 0);

        double moved = scene.vertex("choose").centre().y() - choose.y();
        assertThat(moved).isGreaterThan(60);
        assertThat(scene.vertex("execute").centre().y() - execute.y()).isCloseTo(moved, within(1.0));
        assertThat(scene.plan().layout().get("select"))
                .isEqualTo(before.layout().get("select"));
        scene.context.undo();
        assertThat(scene.plan()).isEqualTo(before);
    }

    @Test
    void aBoxSelectsWhatItHolds() {
        Point2D first = scene.pixel("select");
        Point2D second = scene.pixel("locations");

        scene.drag(new Point2D.Double(first.getX() - 40, first.getY() - 60), second.getX() - first.getX() + 80, 120, 0);

        assertThat(scene.context.editor().selection())
                .contains("select", "locations")
                .doesNotContain("finished");
        scene.key("ctrl A");
        assertThat(scene.context.editor().selection()).contains("finished");
        scene.key("ESCAPE");
        assertThat(scene.context.editor().selection()).isEmpty();
    }

    @Test
    void anEdgeFromPlaceToPlaceIsRefusedAndSaysWhy() {
        Plan before = scene.plan();
        Point2D handle = handle("execute");
        Point2D target = scene.pixel("finished");

        scene.drag(handle, target.getX() - handle.getX(), target.getY() - handle.getY(), 0);

        assertThat(scene.plan()).isEqualTo(before);
        assertThat(scene.lastNotice()).contains("execute and finished are both places");
    }

    private Point2D handle(String id) {
        Point2D vertex = scene.pixel(id);
        scene.mouse(MouseEvent.MOUSE_MOVED, vertex.getX(), vertex.getY(), 0, 0);
        DrawingBox box = new Handles(scene.vertex(id), 1 / scene.view.net().zoom(), true).connect();
        return scene.view.net().pixel(box.x() + box.width() / 2, box.y() + box.height() / 2);
    }

    @Test
    void anEdgeToFreeSpaceGetsAVertexOfTheOtherKind() {
        Plan before = scene.plan();

        scene.drag(handle("execute"), 40, 260, 0);

        assertThat(scene.plan().transitions()).hasSize(before.transitions().size() + 1);
        assertThat(scene.plan().inEdges()).hasSize(before.inEdges().size() + 1);
        String made = scene.context.editor().selection().iterator().next();
        assertThat(scene.plan().inEdgesOf(made))
                .extracting(edge -> edge.place())
                .containsExactly("execute");
    }

    @Test
    void keysConnectTwoVertices() {
        scene.context.editor().select(Set.of("finished"));
        int before = scene.plan().inEdges().size();

        scene.key("C");
        scene.key("LEFT");
        scene.key("ENTER");

        assertThat(scene.plan().inEdges()).hasSize(before + 1);
    }

    @Test
    void arrowsWalkAlongEdges() {
        scene.context.editor().select(Set.of("select"));

        scene.key("RIGHT");
        String transition = scene.context.editor().selection().iterator().next();
        scene.key("RIGHT");

        assertThat(scene.plan().transition(transition)).isPresent();
        assertThat(scene.context.editor().selection()).containsExactly("locations");
        scene.key("shift LEFT");
        assertThat(scene.context.editor().selection()).containsExactly("locations", transition);
    }

    @Test
    void aDoubleClickOnFreeSpaceAddsAPlaceAndKeysAddEither() {
        int places = scene.plan().places().size();
        int transitions = scene.plan().transitions().size();

        scene.doubleClick(700, 820);
        scene.key("T");

        assertThat(scene.plan().places()).hasSize(places + 1);
        assertThat(scene.plan().transitions()).hasSize(transitions + 1);
    }

    @Test
    void aNameIsWrittenWhereItStands() {
        scene.context.editor().select(Set.of("finished"));

        scene.key("F2");
        JTextField field = (JTextField) scene.view.net().getComponent(0);
        assertThat(field.getText()).isEqualTo("Finished");
        field.setText("All home");
        field.getActionMap().get("ENTER").actionPerformed(null);

        assertThat(scene.plan().place("finished").orElseThrow().name()).isEqualTo("All home");
    }

    /** Thesis 5.1. */
    @Test
    void whatIsMadeInRecoveryModeIsARecoveryPartAndHiddenInNominalMode() {
        scene.key("R");
        assertThat(scene.context.editor().mode()).isEqualTo(NetMode.RECOVERY);
        scene.doubleClick(700, 820);
        String made = scene.context.editor().selection().iterator().next();
        assertThat(scene.plan().place(made).orElseThrow().mode()).isEqualTo(Mode.RECOVERY);

        scene.key("R");

        assertThat(scene.view.net().scene().vertices()).extracting(Vertex::id).doesNotContain(made);
        scene.context.editor().setMode(NetMode.ALL);
        assertThat(scene.view.net().scene().vertices()).extracting(Vertex::id).contains(made);
    }

    @Test
    void deletingTellsWhatWentAlong() {
        scene.context.editor().select(Set.of("execute"));

        scene.key("DELETE");

        assertThat(scene.plan().place("execute")).isEmpty();
        assertThat(scene.lastNotice()).contains("went along");
        scene.context.undo();
        assertThat(scene.plan().place("execute")).isPresent();
    }

    @Test
    void whatIsCopiedIsPastedIntoAnotherPlanWithItsEdges() {
        scene.context.editor().select(Set.of("select", "locations"));
        scene.key("shift RIGHT");
        scene.context.editor().select(List.of("select", "locations", transitionBetween("select", "locations")));
        scene.key("ctrl C");
        scene.context.editor().open("station-keep");
        int edges = scene.plan().inEdges().size();
        int places = scene.plan().places().size();

        scene.key("ctrl V");

        assertThat(scene.plan().places()).hasSize(places + 2);
        assertThat(scene.plan().inEdges()).hasSize(edges + 1);
        assertThat(scene.context.editor().selection()).hasSize(3);
    }

    private String transitionBetween(String from, String to) {
        return scene.plan().transitions().stream()
                .map(transition -> transition.id())
                .filter(id -> scene.plan().inEdgesOf(id).stream()
                        .anyMatch(e -> e.place().equals(from)))
                .filter(id -> scene.plan().outEdgesOf(id).stream()
                        .anyMatch(e -> e.place().equals(to)))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aFirstPointInAPlanWithoutLayoutMovesNothingElse() {
        Plan bare = scene.plan().withId("bare").withLayout(Map.of());
        scene.context.apply(new ProjectEdit.AddPlan(bare));
        scene.context.editor().open("bare");
        Map<String, LayoutPoint> before = centres();

        scene.context.editor().select(Set.of("execute"));
        scene.key("ctrl DOWN");

        before.forEach((id, at) -> {
            double down = id.equals("execute") ? SnapWhileDragging.GRID : 0;
            assertThat(scene.vertex(id).centre().x()).as(id).isCloseTo(at.x(), within(0.2));
            assertThat(scene.vertex(id).centre().y()).as(id).isCloseTo(at.y() + down, within(0.2));
        });
    }

    @Test
    void undoOfWhatMovedMostOfTheNetShowsAllOfItAgain() {
        double before = scene.view.net().zoom();
        Map<String, LayoutPoint> wide = new LinkedHashMap<>();
        scene.plan().layout().forEach((id, at) -> wide.put(id, new LayoutPoint(3 * at.x(), 3 * at.y())));
        scene.context.apply(new VertexEdit.MoveVertices("clv", wide));
        scene.view.net().fit();
        assertThat(scene.view.net().zoom()).isLessThan(before);

        scene.run("undo");
        assertThat(scene.view.net().zoom()).isCloseTo(before, within(0.01));
    }

    @Test
    void undoOfWhatMovedOneVertexLeavesTheViewWhereItIs() {
        scene.context.editor().select(Set.of("execute"));
        scene.key("ctrl DOWN");
        scene.view.net().press(NetKey.ZOOM_IN);
        double before = scene.view.net().zoom();

        scene.run("undo");
        assertThat(scene.view.net().zoom()).isEqualTo(before);
    }

    private Map<String, LayoutPoint> centres() {
        Map<String, LayoutPoint> centres = new LinkedHashMap<>();
        scene.view.net().drawing().vertices().forEach(vertex -> centres.put(vertex.id(), vertex.centre()));
        return centres;
    }

    @Test
    void noLabelHidesAnotherWhileThePlanIsEdited() {
        for (String key : List.of("T", "P", "ctrl D", "M", "E")) {
            scene.context.editor().select(Set.of("choose", "execute"));
            scene.key(key);
            List<DrawingBox> boxes = scene.view.net().drawing().labels().stream()
                    .map(label -> label.box())
                    .toList();
            for (int i = 0; i < boxes.size(); i++) {
                for (int j = i + 1; j < boxes.size(); j++) {
                    assertThat(boxes.get(i).intersects(boxes.get(j)))
                            .as("after %s", key)
                            .isFalse();
                }
            }
        }
    }

    @Test
    void anEdgeWithoutRequirementHasAMark() {
        scene.context.editor().select(Set.of("finished"));
        scene.key("C");
        scene.key("LEFT");
        scene.key("ENTER");
        String edge =
                scene.plan().inEdges().get(scene.plan().inEdges().size() - 1).id();

        assertThat(scene.view.net().drawing().labels()).anySatisfy(label -> {
            assertThat(label.of()).isEqualTo(edge);
            assertThat(label.text().lines().get(0).text()).isEqualTo("!");
        });
    }

    @Test
    void aNoteIsAddedWrittenMovedAndDeleted() {
        int index = scene.plan().notes().size();
        scene.run("net-add-note");
        String note = NetScene.idOf(index);
        assertThat(scene.context.editor().selection()).containsExactly(note);
        LayoutPoint before = scene.plan().notes().get(index).at().orElseThrow();

        scene.key("ctrl RIGHT");

        assertThat(scene.plan().notes().get(index).at().orElseThrow().x()).isGreaterThan(before.x());
        scene.key("DELETE");
        assertThat(scene.plan().notes()).hasSize(index);
    }

    @Test
    void aLayoutIsOneEditMadeBesideTheEventThread() throws InterruptedException {
        for (String command : List.of("net-layout-layers", "net-layout-forces", "net-layout-distances")) {
            Plan before = scene.plan();
            CountDownLatch done = new CountDownLatch(1);
            DocumentListener listener = change -> done.countDown();
            scene.context.document().addListener(listener);

            EventThread.later(() -> scene.run(command));

            assertThat(done.await(60, TimeUnit.SECONDS)).as(command).isTrue();
            scene.context.document().removeListener(listener);
            assertThat(scene.plan().layout()).isNotEqualTo(before.layout());
            assertThat(scene.plan().withLayout(Map.of())).isEqualTo(before.withLayout(Map.of()));
            scene.context.undo();
            assertThat(scene.plan()).isEqualTo(before);
        }
    }

    @Test
    void aLayoutThatIsCancelledMovesNothing() throws InterruptedException {
        Plan before = scene.plan();
        CountDownLatch told = new CountDownLatch(1);
        scene.context.notices().addListener(notice -> {
            if (notice.text().contains("cancelled")) {
                told.countDown();
            }
        });

        EventThread.later(() -> {
            scene.run("net-layout-forces");
            scene.key("ESCAPE");
        });

        assertThat(told.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(scene.plan()).isEqualTo(before);
    }

    @Test
    void aDropOntoAVertexIsRefusedWhereTheSyntaxForbidsIt() {
        NetDrop drop = new Ask();
        scene.context.editor().select(Set.of("choose"));
        scene.view.put(drop);
        assertThat(scene.plan().place("choose").orElseThrow().outputs()).hasSize(2);

        int places = scene.plan().places().size();
        scene.context.editor().select(Set.of(scene.plan().transitions().get(0).id()));
        scene.view.put(drop); // a place of its own
        assertThat(scene.plan().places()).hasSize(places + 1);
        Set<String> made = new LinkedHashSet<>(scene.context.editor().selection());
        assertThat(made).hasSize(1);
        assertThat(scene.plan().place(made.iterator().next()).orElseThrow().outputs())
                .hasSize(1);
    }

    /** An output event as a palette offers it. */
    private static final class Ask implements NetDrop {
        @Override
        public String label() {
            return "Select boats";
        }

        @Override
        public Optional<String> whyNotOnto(Plan plan, String vertex) {
            return plan.place(vertex).isPresent()
                    ? Optional.empty()
                    : Optional.of("An output event belongs to a place");
        }

        @Override
        public Edit onto(Plan plan, String vertex, Mode mode) {
            return new EventEdit.AddOutput(plan.id(), vertex, event("ask-anew"));
        }

        @Override
        public Edit at(Plan plan, LayoutPoint at, Mode mode) {
            return new VertexEdit.AddPlace(
                    plan.id(),
                    new Place(
                            "asked", "", false, false, false, mode, List.of(event("asked-anew")), List.of(), List.of()),
                    Optional.of(at));
        }

        private static OutputEventSpec event(String id) {
            return new OutputEventSpec(id, "OperatorSelectBoatList", Map.of(), Map.of(), List.of());
        }
    }

    @Test
    void aSelectionBecomesASubMission() {
        scene.context.editor().select(List.of("allocate", transitionBetween("allocate", "choose")));
        assertThat(scene.context.commands().get("net-extract").whyNot()).isEmpty();

        scene.run("net-extract");

        assertThat(scene.context.document().plan("clv-part-1")).isPresent();
        String made = scene.context.editor().selection().iterator().next();
        assertThat(scene.plan().place(made).orElseThrow().subMissions()).hasSize(1);
    }
}
