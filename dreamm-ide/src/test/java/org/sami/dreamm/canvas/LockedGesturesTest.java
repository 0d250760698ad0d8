package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.Optional;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;

/** Gestures on the net that a profile hides or locks by their ids. */
@ExtendWith(OnEventThread.class)
class LockedGesturesTest {
    private static EditorScene scene(List<String> hide, List<String> lock) {
        Plan plan = new PlanBuilder("p")
                .start("a")
                .transition("t")
                .in("a", "t")
                .at("a", 100, 100)
                .at("t", 300, 100)
                .build();
        Project project = new Project("p", "", "crw", List.of(), List.of(), List.of(plan));
        return new EditorScene(project, new Profile("lesson", hide, lock, List.of()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"net-move", "net-*"})
    void vertexThatMayNotBeMovedStays(String locked) {
        try (EditorScene free = scene(List.of(), List.of());
                EditorScene scene = scene(List.of(), List.of(locked))) {
            String before = scene.text();
            for (EditorScene each : List.of(free, scene)) {
                each.drag(each.pixel("a"), 60, 40, 0);
            }

            assertThat(free.text()).isNotEqualTo(before);
            assertThat(scene.text()).isEqualTo(before);
        }
    }

    @Test
    void nameThatMayNotBeWrittenOpensNoField() {
        try (EditorScene scene = scene(List.of(), List.of("net-rename"))) {
            Point2D at = scene.pixel("a");

            scene.doubleClick(at.getX(), at.getY());

            assertThat(Layout.find(scene.view, "net-name", JTextField.class)).isEmpty();
        }
    }

    @Test
    void whatMayNotBeDroppedIsRefusedAndSaysWhy() {
        try (EditorScene scene = scene(List.of(), List.of("net-drop"))) {
            String before = scene.text();

            scene.view.put(new BlankPlace());

            assertThat(scene.text()).isEqualTo(before);
            assertThat(scene.lastNotice()).isEqualTo("the profile lesson does not have it");
        }
    }

    @Test
    void markOnEdgesWithoutRequirementIsHidden() {
        try (EditorScene free = scene(List.of(), List.of());
                EditorScene scene = scene(List.of(ProfileIds.MISSING_REQUIREMENT), List.of())) {
            assertThat(marks(free)).isEqualTo(1);
            assertThat(marks(scene)).isZero();
        }
    }

    private static long marks(EditorScene scene) {
        return scene.view.net().scene().labels().stream()
                .flatMap(label -> label.text().lines().stream())
                .filter(line -> line.style() == TextStyle.MISSING)
                .count();
    }

    private record BlankPlace() implements NetDrop {
        @Override
        public String label() {
            return "Blank place";
        }

        @Override
        public Optional<String> whyNotOnto(Plan plan, String vertex) {
            return Optional.empty();
        }

        @Override
        public Edit onto(Plan plan, String vertex, Mode mode) {
            return VertexEdit.AddPlace.blank(plan.id(), "b", mode, new LayoutPoint(0, 0));
        }

        @Override
        public Edit at(Plan plan, LayoutPoint at, Mode mode) {
            return VertexEdit.AddPlace.blank(plan.id(), "b", mode, at);
        }
    }
}
