package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.InputEvent;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Plan;

/** Frames around parts of a net, by pointer and keys. */
class FramesTest {
    private static final String FRAME = NetScene.idOfFrame(0);

    private final EditorScene scene = EditorScene.of("clv");

    @AfterEach
    void close() {
        scene.close();
    }

    private FrameBox frame() {
        return scene.view.net().drawing().frames().get(0);
    }

    private Point2D at(double x, double y) {
        return scene.view.net().pixel(x, y);
    }

    private void frameTwo() {
        scene.click("select", 0);
        scene.click("locations", InputEvent.SHIFT_DOWN_MASK);
        scene.key("ctrl G");
        scene.key("ESCAPE");
        scene.context.editor().select(Set.of());
    }

    @Test
    void aFrameLiesAroundTheSelectionWithItsWords() {
        scene.click("select", 0);
        scene.click("locations", InputEvent.SHIFT_DOWN_MASK);

        scene.key("ctrl G");

        assertThat(scene.plan().frames()).hasSize(1);
        assertThat(scene.context.editor().selection()).containsExactly(FRAME);
        for (String vertex : List.of("select", "locations")) {
            assertThat(frame().box().contains(scene.vertex(vertex).box())).isTrue();
        }
        assertThat(frame().box().contains(scene.vertex("execute").box())).isFalse();
        scene.context.undo();
        assertThat(scene.plan().frames()).isEmpty();
    }

    @Test
    void aFrameThatIsDraggedTakesAlongWhatLiesInItAsOneEdit() {
        frameTwo();
        Plan before = scene.plan();
        LayoutPoint select = scene.vertex("select").centre();
        LayoutPoint execute = scene.vertex("execute").centre();
        double x = frame().x();
        Point2D head = at(frame().x() + 12, frame().y() + 6);

        scene.drag(head, 0, 90, 0);

        assertThat(scene.context.editor().selection()).containsExactly(FRAME);
        double moved = scene.vertex("select").centre().y() - select.y();
        assertThat(moved).isGreaterThan(40);
        assertThat(frame().x()).isCloseTo(x, within(1.0));
        assertThat(scene.vertex("execute").centre()).isEqualTo(execute);
        scene.context.undo();
        assertThat(scene.plan()).isEqualTo(before);
    }

    @Test
    void withinAFrameABoxStillSelects() {
        frameTwo();
        Point2D inside = at(frame().x() + 14, frame().head().maxY() + 10);

        scene.drag(inside, 60, at(0, frame().box().maxY()).getY() - inside.getY() - 6, 0);

        assertThat(scene.context.editor().selection()).doesNotContain(FRAME);
        assertThat(scene.plan().frames()).hasSize(1);
    }

    @Test
    void itsCornerResizesIt() {
        frameTwo();
        scene.context.editor().select(Set.of(FRAME));
        double width = frame().width();
        LayoutPoint select = scene.vertex("select").centre();

        scene.drag(at(frame().box().maxX() - 2, frame().box().maxY() - 2), 80, 40, 0);

        assertThat(frame().width()).isGreaterThan(width + 20);
        assertThat(scene.vertex("select").centre()).isEqualTo(select);
    }

    @Test
    void deletingAFrameLeavesWhatLiesInIt() {
        frameTwo();
        scene.context.editor().select(Set.of(FRAME));

        scene.key("DELETE");

        assertThat(scene.plan().frames()).isEmpty();
        assertThat(scene.plan().place("select")).isPresent();
    }

    @Test
    void framesAreShownInEveryMode() {
        frameTwo();
        for (NetMode mode : NetMode.values()) {
            scene.context.editor().setMode(mode);
            assertThat(scene.view.net().scene().frames()).as(mode.label()).hasSize(1);
        }
        assertThat(scene.plan().place("select").orElseThrow().mode()).isEqualTo(Mode.NOMINAL);
    }

    @Test
    void noWordsLieOnATitle() {
        scene.context.apply(new FrameEdit.AddFrame(
                "clv",
                new NetFrame(
                        "What boats visit",
                        FrameColor.TEAL,
                        scene.plan().layout().get("select"),
                        400,
                        200)));

        assertThat(scene.view.net().drawing().labels())
                .noneMatch(label -> label.box().intersects(frame().titleBox()));
    }

    @Test
    void disablingIsOneEditAndSaysSoOnTheNet() {
        scene.click("select", 0);
        scene.key("ctrl E");

        assertThat(scene.plan().place("select").orElseThrow().disabled()).isTrue();
        assertThat(scene.view.net().drawing().labels())
                .filteredOn(label -> label.of().equals("select"))
                .anyMatch(label -> label.text().lines().stream()
                        .anyMatch(line -> line.text().contains("disabled")));
        scene.key("ctrl E");
        assertThat(scene.plan().place("select").orElseThrow().disabled()).isFalse();
    }
}
