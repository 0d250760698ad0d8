package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wizard.EventTarget;

/** What an author is given who does not know yet what requirements and sequences are: the profiles of the first lessons. */
@ExtendWith(OnEventThread.class)
class BeforeRequirementsTest {
    private static EditorScene scene(String... hide) {
        Plan plan = new PlanBuilder("p")
                .start("a")
                .transition("t")
                .in("a", "t")
                .out("t", "b", OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_PROXY))
                .at("a", 100, 100)
                .at("t", 300, 100)
                .at("b", 500, 100)
                .build();
        Project project = new Project("p", "", "crw", List.of(), List.of(), List.of(plan));
        return new EditorScene(project, new Profile("lesson", List.of(hide), List.of(), List.of()));
    }

    private static int transitionsAfterTimer(EditorScene scene) {
        var additions = scene.context.additions();
        additions.add(additions.event("StartSystemTimer", new EventTarget.OnVertex("a")));
        return scene.plan().transitions().size();
    }

    @Test
    void eventIsAddedAloneWhereSequencesAreHidden() {
        try (EditorScene free = scene();
                EditorScene lesson = scene(ProfileIds.SEQUENCES)) {
            assertThat(transitionsAfterTimer(free)).isEqualTo(2);
            assertThat(transitionsAfterTimer(lesson)).isEqualTo(1);
            assertThat(lesson.plan().place("a").orElseThrow().outputs()).hasSize(1);
        }
    }

    private static List<String> lines(EditorScene scene) {
        return scene.view.net().scene().labels().stream()
                .flatMap(label -> label.text().lines().stream())
                .map(line -> line.text())
                .toList();
    }

    @Test
    void netWritesNoRequirementsWhereThoseOfEdgesAreHidden() {
        try (EditorScene free = scene();
                EditorScene lesson = scene(ProfileIds.EDGE, ProfileIds.MISSING_REQUIREMENT)) {
            assertThat(lines(free)).contains("Take All Proxy");
            assertThat(lines(lesson)).doesNotContain("Take All Proxy");
        }
    }

    @Test
    void plusBesideVertexIsOnlyWhereWhatComesNextIsOffered() {
        try (EditorScene scene = scene()) {
            Handles both = new Handles(scene.vertex("a"), 1, true);
            Handles one = new Handles(scene.vertex("a"), 1, false);
            double x = both.append().orElseThrow().x() + 5;
            double y = both.append().orElseThrow().y() + 10;

            assertThat(both.isAppendAt(x, y)).isTrue();
            assertThat(one.isAppendAt(x, y)).isFalse();
            assertThat(one.isAt(x, y)).isFalse();
        }
    }
}
