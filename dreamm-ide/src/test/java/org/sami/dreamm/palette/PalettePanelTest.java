package org.sami.dreamm.palette;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JList;
import javax.swing.JRadioButton;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.canvas.AppendChoices;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.picture.net.NetMode;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;

/** The palette without a window: what it offers, where that may go, and what comes of it. */
@ExtendWith(OnEventThread.class)
class PalettePanelTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private DreammContext context;

    @BeforeEach
    void openAnEmptyPlan() {
        context = context(Profile.ALL);
    }

    @AfterEach
    void close() {
        context.close();
    }

    private static DreammContext context(Profile profile) {
        Project project = new Project("mine", "", "crw", List.of(), List.of(), List.of(new PlanBuilder("p").build()));
        return new DreammContext(BOATS, new ProjectDocument(BOATS.vocabulary(), project, Optional.empty()), profile);
    }

    private Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    private static JTextField search(PalettePanel panel) {
        return Layout.find(panel, "palette-search", JTextField.class).orElseThrow();
    }

    @SuppressWarnings("unchecked")
    private static JList<Object> list(PalettePanel panel) {
        return (JList<Object>) Layout.find(panel, "palette-list", JList.class).orElseThrow();
    }

    private PaletteItem item(String label) {
        return new PaletteGroups(context, i -> true)
                .matching(label).stream()
                        .flatMap(g -> g.items().stream())
                        .filter(i -> i.label().equals(label))
                        .findFirst()
                        .orElseThrow();
    }

    private PaletteDrop drag(String label) {
        return new PaletteDrop(context, item(label));
    }

    private void dropFree(String label, double x, double y) {
        context.apply(drag(label).at(plan(), new LayoutPoint(x, y), Mode.NOMINAL));
    }

    @Test
    void typingNarrowsTheListToWhatIsMeant() {
        PalettePanel panel = new PalettePanel(context);

        search(panel).setText("goto point block");

        assertThat(list(panel).getModel().getSize()).isEqualTo(2);
        assertThat(list(panel).getSelectedValue())
                .isInstanceOfSatisfying(
                        PaletteItem.class, i -> assertThat(i.label()).isEqualTo("Proxy Goto Point and Block"));
    }

    @Test
    void anItemThatStaysMarkedWhileTheListIsNarrowedIsSaidOnce() {
        PaletteList list = new PaletteList(context, "palette", item -> true, item -> {});
        List<String> said = new ArrayList<>();
        list.whenSelected(() -> said.add(list.selected().map(PaletteItem::label).orElse("nothing")));

        for (String typed : List.of("goto", "goto p", "goto point b", "goto point block", "zzz", "zzzz")) {
            list.searchField().setText(typed);
        }

        assertThat(said).containsExactly("Proxy Goto Point", "Proxy Goto Point and Block", "nothing");
    }

    @Test
    void eventDroppedOntoFreeSpaceMakesThePlaceAndWhatFollows() {
        dropFree("Start System Timer", 100, 100);

        assertThat(plan().places()).hasSize(2);
        assertThat(plan().transitions()).hasSize(1);
        assertThat(plan().layout()).containsEntry("start-system-timer", new LayoutPoint(100, 100));
        context.undo();
        assertThat(plan().places()).isEmpty();
    }

    @Test
    void itemThatCannotStandOnAVertexSaysWhyAndChangesNothing() {
        dropFree("Blank place", 0, 0);
        Plan before = plan();

        EditResult result = context.apply(drag("Timer Expired").onto(before, "place", Mode.NOMINAL));

        assertThat(result).isInstanceOf(EditResult.Refused.class);
        assertThat(drag("Timer Expired").whyNotOnto(before, "place"))
                .contains("Timer Expired is an input event: it stands on transitions, and place is a place");
        assertThat(drag("Blank transition").whyNotOnto(before, "place")).isPresent();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void whatIsMadeInRecoveryModeIsARecoveryPart() {
        context.editor().setMode(NetMode.RECOVERY);

        dropFree("Start System Timer", 100, 100);

        assertThat(plan().places()).extracting(Place::mode).containsOnly(Mode.RECOVERY);
        assertThat(plan().inEdges()).extracting(InEdge::mode).containsOnly(Mode.RECOVERY);
    }

    @Test
    void roleBecomesATaskOfThePlan() {
        String of = BOATS.vocabulary().taskClasses().keySet().iterator().next();

        dropFree("Task: " + of, 0, 0);

        assertThat(plan().tasks()).extracting(t -> t.taskClass()).containsExactly(of);
    }

    @Test
    void anotherSequenceTakesThePlaceOfTheOneThatCameAndIsOneStepToUndo() {
        PalettePanel panel = new PalettePanel(context);
        search(panel).setText("execute path");
        dropFree("Proxy Execute Path", 100, 100);
        assertThat(plan().inEdges()).extracting(InEdge::locked).containsOnly(false);

        Layout.find(panel, "wizard-sequence-go-on-when-the-last-is-there", JRadioButton.class)
                .orElseThrow()
                .doClick();

        assertThat(plan().inEdges()).hasSize(4).extracting(InEdge::locked).containsOnly(true);
        context.undo();
        assertThat(plan().places()).isEmpty();
    }

    @Test
    void whatCanComeNextAtAVertexIsWhatItsEventsCanCause() {
        dropFree("Operator Approve", 100, 100);
        String place = plan().places().get(0).id();

        List<AppendChoices.NextStep> steps = new PaletteSteps(context).after(plan(), place);

        assertThat(steps)
                .extracting(AppendChoices.NextStep::label)
                .containsExactly("Yes Option  (drawn already)", "No Option  (drawn already)");
        context.apply(steps.get(0).edit(plan(), place, new LayoutPoint(0, 0), Mode.NOMINAL));
        assertThat(plan().transitions()).hasSize(3);
        assertThat(plan().inEdges()).last().satisfies(e -> {
            assertThat(e.place()).isEqualTo(place);
            assertThat(e.requirements()).isNotEmpty();
        });
    }

    @Test
    void enterAddsWhatIsMarkedToWhatIsSelected() {
        PalettePanel panel = new PalettePanel(context);
        dropFree("Blank place", 100, 100);
        context.editor().select(List.of("place"));
        search(panel).setText("start system timer");

        for (KeyListener keys : search(panel).getKeyListeners()) {
            keys.keyPressed(new KeyEvent(
                    search(panel), KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_ENTER, KeyEvent.CHAR_UNDEFINED));
        }

        assertThat(plan().place("place").orElseThrow().outputs())
                .extracting(o -> o.type())
                .containsExactly("StartSystemTimer");
        assertThat(context.editor().selection()).containsExactly("place");
    }

    @Test
    void profileHidesGroupsAndItems() {
        context.close();
        context =
                context(new Profile("lesson 2", List.of("palette-group-*"), List.of(), List.of("palette-group-blank")));

        List<PaletteGroup> groups = new PaletteGroups(context, i -> true).matching("");

        assertThat(groups).extracting(PaletteGroup::id).containsExactly("palette-group-blank");
    }
}
