package org.sami.dreamm.inspector;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.ui.check.Layout;

/** The requirements of an edge where a profile has generic tokens only, as in the first lesson on requirements. */
@ExtendWith(OnEventThread.class)
class GenericRequirementsTest {
    private static final Profile GENERIC_ONLY = new Profile(
            "generic",
            Stream.of("any-proxy", "any-task", "any-token", "task", "relevant", "unconditional", "sub-mission-tokens")
                    .flatMap(kind -> Stream.of("requirement-in-" + kind, "requirement-out-" + kind))
                    .toList(),
            List.of(),
            List.of());

    private DreammContext context;
    private InspectorPanel panel;

    private void open(boolean in) {
        Plan plan = new PlanBuilder("p")
                .start("a")
                .transition("t")
                .in("a", "t")
                .out("t", "b", OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC))
                .build();
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = new Project("p", "", "crw", List.of(), List.of(), List.of(plan));
        context = new DreammContext(
                library, new ProjectDocument(library.vocabulary(), project, Optional.empty()), GENERIC_ONLY);
        context.editor().open("p");
        context.editor()
                .select(List.of(
                        in ? plan.inEdges().get(0).id() : plan.outEdges().get(0).id()));
        panel = new InspectorPanel(
                context, new LiveFindings(context.document(), Runnable::run, Runnable::run, System::nanoTime));
    }

    @AfterEach
    void close() {
        context.close();
    }

    private <C extends JComponent> C find(String name, Class<C> type) {
        return Layout.find(panel, name, type).orElseThrow(() -> new AssertionError("there is no " + name));
    }

    private void set(String box, boolean on) {
        AbstractButton implied = find(box, AbstractButton.class);
        if (implied.isSelected() != on) {
            implied.doClick();
        }
    }

    private List<String> in() {
        return context.editor().plan().orElseThrow().inEdges().get(0).requirements().stream()
                .map(RequirementWords::of)
                .toList();
    }

    private List<String> out() {
        return context.editor().plan().orElseThrow().outEdges().get(0).requirements().stream()
                .map(RequirementWords::of)
                .toList();
    }

    @Test
    void requirementBesideTheImpliedOneHasARowInWhichItIsChanged() {
        open(true);
        set("inspector-implied-generic", true);

        find("inspector-add-requirement", AbstractButton.class).doClick();

        assertThat(in()).hasSize(2).doesNotHaveDuplicates();
        find("inspector-match-1", JComboBox.class).setSelectedItem(Match.LESS_THAN);
        assertThat(in()).hasSize(2).first().isEqualTo("≥ 1 Generic");
        set("inspector-implied-generic", false);
        find("inspector-match-0", JComboBox.class).setSelectedItem(Match.ZERO);
        assertThat(in()).containsExactly("No Generic");
    }

    @Test
    void firstRequirementOfAnEdgeToATransitionHasARow() {
        open(true);
        set("inspector-implied-generic", false);

        find("inspector-add-requirement", AbstractButton.class).doClick();

        assertThat(in()).hasSize(1).doesNotContain("≥ 1 Generic");
        find("inspector-match-0", JComboBox.class).setSelectedItem(Match.ZERO);
        assertThat(in()).containsExactly("No Generic");
    }

    @Test
    void requirementOfAnEdgeToAPlaceHasARowInWhichNewTokensAreAdded() {
        open(false);

        find("inspector-add-requirement", AbstractButton.class).doClick();
        find("inspector-action-1", JComboBox.class).setSelectedItem(Action.ADD);

        assertThat(out()).hasSize(2).first().isEqualTo("Take 1 Generic");
        assertThat(out().get(1)).startsWith("Add");
    }

    @Test
    void numberIsChosenWithoutTheRowGoingIntoTheCheckBox() {
        open(false);
        set("inspector-implied-generic", false);
        find("inspector-add-requirement", AbstractButton.class).doClick();

        find("inspector-quantity-0", JComboBox.class).setSelectedItem(false);

        assertThat(out()).containsExactly("Take 2 Generic");
        close();
        open(true);
        set("inspector-implied-generic", false);
        find("inspector-add-requirement", AbstractButton.class).doClick();
        find("inspector-match-0", JComboBox.class).setSelectedItem(Match.ZERO);
        find("inspector-match-0", JComboBox.class).setSelectedItem(Match.AT_LEAST);
        assertThat(in()).containsExactly("≥ 2 Generic");
    }
}
