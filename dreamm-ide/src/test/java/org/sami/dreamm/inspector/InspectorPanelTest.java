package org.sami.dreamm.inspector;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.FieldType;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Look;

/** The inspector without a window: each field makes an edit, and no text is cut. */
@Tag("long")
@Isolated("the look is one for all windows of a process")
@ExtendWith(OnEventThread.class)
class InspectorPanelTest {
    private static final int WIDTH = 340;
    private static final int HEIGHT = 2600;

    private DreammContext context;
    private InspectorPanel panel;

    @AfterEach
    void close() {
        context.close();
        Look.apply(Theme.LIGHT, 100);
    }

    private void open(String domain, String plan, String... selected) {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/" + domain).orThrow();
        context = new DreammContext(
                library, new ProjectDocument(library.vocabulary(), library.combined(), Optional.empty()), Profile.ALL);
        context.editor().open(plan);
        context.editor().select(List.of(selected));
        panel = new InspectorPanel(
                context, new LiveFindings(context.document(), Runnable::run, Runnable::run, System::nanoTime));
    }

    private Plan plan() {
        return context.editor().plan().orElseThrow();
    }

    private <C extends JComponent> C find(String name, Class<C> type) {
        return Layout.find(panel, name, type).orElseThrow(() -> new AssertionError("there is no " + name));
    }

    private void choose(String name, Object item) {
        find(name, JComboBox.class).setSelectedItem(item);
    }

    private OutputEventSpec event(String place) {
        return plan().place(place).orElseThrow().outputs().get(0);
    }

    @Test
    void nameOfAPlaceIsGivenWithEnterAndTakenBack() {
        open("crw", "clv", "execute");

        JTextField name = find("inspector-name", JTextField.class);
        name.setText("Drive");
        name.postActionEvent();

        assertThat(plan().place("execute").orElseThrow().name()).isEqualTo("Drive");
        context.undo();
        assertThat(find("inspector-name", JTextField.class).getText()).isEqualTo("Execute paths");
    }

    @Test
    void whatIsTypedIsTakenWhenAnotherVertexIsSelected() {
        open("crw", "station-keep", "assemble");
        find("inspector-name", JTextField.class).setText("Meet");

        context.editor().select(Set.of("go"));

        assertThat(plan().place("assemble").orElseThrow().name()).isEqualTo("Meet");
        assertThat(find("inspector-name", JTextField.class).getText())
                .isEqualTo(plan().place("go").orElseThrow().name());
    }

    @Test
    void severalSelectedShowWhatTheyHaveInCommon() {
        open("crw", "clv", "execute", "visited", "execute.visited");

        choose("inspector-mode", Mode.RECOVERY);

        assertThat(plan().place("execute").orElseThrow().mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan().transition("visited").orElseThrow().mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan().inEdges().stream().filter(e -> e.id().equals("execute.visited")))
                .extracting(InEdge::mode)
                .containsExactly(Mode.RECOVERY);
        context.undo();
        assertThat(plan().place("execute").orElseThrow().mode()).isEqualTo(Mode.NOMINAL);
    }

    @Test
    void fieldComesFromAVariableANewOneOrTheOperator() {
        open("crw", "clv", "execute");

        choose("field-paths-source", FieldOrigin.ASKED);
        assertThat(event("execute").fields().get("paths")).isEqualTo(new FieldSource.Asked(Optional.empty(), true));
        choose("field-paths-source", FieldOrigin.VARIABLE);
        assertThat(event("execute").fields().get("paths")).isEqualTo(new FieldSource.FromVariable("@paths"));
        JComboBox<?> read = find("field-paths-variable", JComboBox.class);
        read.setSelectedIndex(read.getItemCount() - 1);
        assertThat(event("execute").fields().get("paths")).isEqualTo(new FieldSource.FromVariable("@paths2"));
        assertThat(plan().variables()).extracting(v -> v.name()).contains("@paths2");
        choose("field-paths-write", "@paths");
        assertThat(event("execute").writes()).containsEntry("paths", "@paths");
    }

    @Test
    void taskIsOfferedWhereATaskComesAndNowhereElse() {
        open("crw", "panorama", "go");
        assertThat(offered("field-location-source")).contains(FieldOrigin.TASK);

        context.editor().open("clv");
        context.editor().select(List.of("execute"));
        assertThat(offered("field-paths-source")).doesNotContain(FieldOrigin.TASK);
    }

    private List<Object> offered(String box) {
        JComboBox<?> found = find(box, JComboBox.class);
        List<Object> items = new ArrayList<>();
        for (int i = 0; i < found.getItemCount(); i++) {
            items.add(found.getItemAt(i));
        }
        return items;
    }

    @Test
    void neededFieldIsOfferedTheAnswersAndVariablesThatReachItNearestFirst() {
        open("crw", "clv", "execute");
        context.apply(new FieldEdit.ClearField("clv", event("execute").id(), "paths"));

        find("field-paths-propose-0", AbstractButton.class).doClick();

        assertThat(event("execute").fields().get("paths")).isEqualTo(new FieldSource.FromVariable("@paths"));
        JComboBox<?> read = find("field-paths-variable", JComboBox.class);
        assertThat(((ReadingChoice) read.getItemAt(0)).words())
                .isEqualTo("Operator Accepted Allocation: paths (@paths), 1 step before");
    }

    @Test
    void valueIsGivenWithTheEditorOfItsTypeAndCannotBeWhatItIsNot() {
        open("crw", "station-keep", "assemble");
        choose("field-spacing-source", FieldOrigin.VALUE);

        ValueRow row = valueRow("spacing");
        JTextField text = text(row);
        text.setText("far");
        row.give();
        assertThat(row.editor().entry().reason()).isPresent();
        text.setText("4.5");
        row.give();

        assertThat(event("assemble").fields().get("spacing")).isEqualTo(new FieldSource.Fixed(new RealValue(4.5)));
    }

    @Test
    void classOfTasksIsChosenAmongThoseOfTheDomain() {
        open("crw", "measure", "make");
        JComboBox<?> classes = find("field-task-class-value", JComboBox.class);

        assertThat(classes.getSelectedItem()).isEqualTo("Temperature");
        choose("field-task-class-value", "Camera");

        assertThat(event("make").fields().get("taskClass"))
                .isEqualTo(new FieldSource.Asked(Optional.of(new TextValue("Camera")), true));
        context.undo();
        choose("field-task-class-source", FieldOrigin.NOTHING);
        choose("field-task-class-source", FieldOrigin.VALUE);
        assertThat(find("field-task-class-value", JComboBox.class).getSelectedItem())
                .as("nothing is chosen for the author")
                .isEqualTo("");
        choose("field-task-class-value", "Temperature");
        assertThat(event("make").fields().get("taskClass"))
                .isEqualTo(new FieldSource.Fixed(new TextValue("Temperature")));
    }

    @Test
    void classOfTasksThatTheDomainDoesNotHaveStays() {
        open("crw", "measure", "make");

        context.apply(new FieldEdit.SetField(
                "measure", "make-tasks", "taskClass", new FieldSource.Fixed(new TextValue("Depth"))));

        JComboBox<?> classes = find("field-task-class-value", JComboBox.class);
        assertThat(classes.getSelectedItem()).isEqualTo("Depth");
        assertThat(classes.getItemCount())
                .isEqualTo(context.vocabulary().taskClasses().size() + 1);
    }

    @Test
    void keysThatPassSeveralSourcesLeaveOneEditor() {
        open("crw", "station-keep", "hold");
        choose("field-duration-source", FieldOrigin.NOTHING);

        choose("field-duration-source", FieldOrigin.VALUE);
        choose("field-duration-source", FieldOrigin.LOCKED);

        List<ValueRow> rows = new ArrayList<>();
        collect(panel, ValueRow.class, rows);
        assertThat(rows).hasSize(1);
    }

    /** As with all editors: what is asked for stands below the choice that asks, and above what has nothing to do with it. */
    @Test
    void valueThatASourceNeedsIsAskedBelowTheChoiceOfTheSource() {
        open("crw", "station-keep", "hold");
        choose("field-duration-source", FieldOrigin.NOTHING);

        choose("field-duration-source", FieldOrigin.VALUE);

        Layout.layOut(panel, Look.px(WIDTH), Look.px(HEIGHT));
        assertThat(top(valueRow("duration")))
                .isGreaterThan(top(find("field-duration-source", JComboBox.class)))
                .isLessThan(top(find("field-duration-write", JComboBox.class)));
    }

    private int top(JComponent component) {
        return SwingUtilities.convertPoint(component, 0, 0, panel).y;
    }

    @Test
    void selectedVertexShowsTheFindingsThatTheIssuesViewShows() {
        open("crw", "station-keep", "assemble");

        context.apply(new FieldEdit.ClearField("station-keep", event("assemble").id(), "spacing"));

        assertThat(Layout.find(panel, "inspector-findings", JComponent.class)
                        .orElseThrow()
                        .getComponentCount())
                .isPositive();
    }

    private ValueRow valueRow(String field) {
        List<ValueRow> rows = new ArrayList<>();
        collect(panel, ValueRow.class, rows);
        return rows.stream()
                .filter(r -> r.editor().field().path().equals(field))
                .findFirst()
                .orElseThrow();
    }

    private static JTextField text(ValueRow row) {
        List<JTextField> texts = new ArrayList<>();
        collect(row, JTextField.class, texts);
        return texts.get(0);
    }

    private static <C> void collect(java.awt.Container root, Class<C> type, List<C> found) {
        for (java.awt.Component child : root.getComponents()) {
            if (type.isInstance(child)) {
                found.add(type.cast(child));
            }
            if (child instanceof java.awt.Container inner) {
                collect(inner, type, found);
            }
        }
    }

    @Test
    void requirementsAreSaidInChoicesAndComputedOnDemand() {
        open("crw", "clv", "execute.visited");
        List<String> before = words();

        find("inspector-add-requirement", AbstractButton.class).doClick();
        assertThat(words()).hasSize(before.size() + 1);
        context.undo();
        find("inspector-implied-generic", AbstractButton.class).doClick();
        assertThat(words()).contains("≥ 1 Generic");
        find("inspector-compute", AbstractButton.class).doClick();
        assertThat(words()).contains("All Relevant");
        find("inspector-locked", AbstractButton.class).doClick();
        assertThat(find("inspector-compute", AbstractButton.class).isEnabled()).isFalse();
        assertThat(find("inspector-compute", AbstractButton.class).getToolTipText())
                .contains("locked");
    }

    @Test
    void requirementsAreProposedThatMakeSenseOnTheEdge() {
        open("crw", "panorama", "finished.all-finished");
        assertThat(offered("inspector-kind-0")).doesNotContain(TokenKind.RELEVANT);
        find("inspector-remove-requirement-0", AbstractButton.class).doClick();
        assertThat(find("inspector-propose-requirement-0", AbstractButton.class).getText())
                .doesNotContain("Relevant");

        String edge = plan().inEdges().stream()
                .filter(e -> e.transition().equals("all-finished") && e.place().equals("go"))
                .findFirst()
                .orElseThrow()
                .id();
        context.editor().select(List.of(edge));
        while (Layout.find(panel, "inspector-remove-requirement-0", AbstractButton.class)
                .isPresent()) {
            find("inspector-remove-requirement-0", AbstractButton.class).doClick();
        }
        find("inspector-add-requirement", AbstractButton.class).doClick();

        assertThat(plan().inEdges().stream()
                        .filter(e -> e.id().equals(edge))
                        .flatMap(e -> e.requirements().stream())
                        .map(RequirementWords::of))
                .containsExactly("No Task");
    }

    private List<String> words() {
        return plan().inEdges().stream()
                .filter(e -> e.id().equals("execute.visited"))
                .flatMap(e -> e.requirements().stream())
                .map(RequirementWords::of)
                .toList();
    }

    @Test
    void markupWhoseOptionsAreAllThereIsAddedAndRemoved() {
        open("crw", "clv", "execute");

        choose("event-add-markup", "Priority");
        if (event("execute").markups().stream().noneMatch(m -> m.type().equals("Priority"))) {
            AbstractButton add = find("markup-priority-add", AbstractButton.class);
            assertThat(add.isEnabled()).isFalse();
            assertThat(add.getToolTipText()).isNotEmpty();
        }
        find("markup-relevant-proxy-remove", AbstractButton.class).doClick();
        assertThat(event("execute").markups()).extracting(m -> m.type()).doesNotContain("RelevantProxy");
    }

    @Test
    void deletedEventTakesAlongWhatOnlyItNeeded() {
        open("crw", "clv", "execute");

        find("event-0-delete", AbstractButton.class).doClick();

        assertThat(plan().place("execute").orElseThrow().outputs()).isEmpty();
    }

    /**
     * No editor needs code for a domain: every event, markup and field of both domains is shown and can be edited. Of elements that differ in their
     * names and values only, one is shown.
     */
    @ParameterizedTest
    @ValueSource(strings = {"crw", "uav"})
    void everyKindOfVertexAndEdgeOfADomainsPlansHasItsEditors(String domain) {
        open(domain, "look");
        Set<Object> seen = new HashSet<>();
        for (Plan plan : context.document().project().plans()) {
            for (Place place : plan.places()) {
                if (seen.add(kind(place))) {
                    select(plan, place.id());
                    place.outputs().forEach(this::findFields);
                }
            }
            plan.transitions().stream()
                    .filter(t -> seen.add(
                            t.inputs().stream().map(InspectorPanelTest::kind).toList()))
                    .forEach(t -> select(plan, t.id()));
            plan.inEdges().stream()
                    .filter(e -> seen.add(e.requirements().stream()
                            .map(r -> List.of(r.kind(), r.match(), r.task().isEmpty()))
                            .toList()))
                    .forEach(e -> select(plan, e.id()));
            plan.outEdges().stream()
                    .filter(e -> seen.add(e.requirements().stream()
                            .map(r -> List.of(r.kind(), r.action(), r.task().isEmpty()))
                            .toList()))
                    .forEach(e -> {
                        select(plan, e.id());
                        find("inspector-implied-generic", AbstractButton.class);
                    });
        }
        assertThat(seen).as("kinds of elements").hasSizeGreaterThan(domain.equals("crw") ? 100 : 10);
    }

    private static Object kind(Place place) {
        return List.of(
                place.start(),
                place.end(),
                place.subMissions().size(),
                place.outputs().stream().map(InspectorPanelTest::kind).toList());
    }

    private static Object kind(OutputEventSpec event) {
        return List.of(
                event.type(),
                event.fields().entrySet().stream()
                        .map(f -> List.of(f.getKey(), f.getValue().getClass()))
                        .toList(),
                event.writes().keySet(),
                event.markups().stream().map(MarkupSpec::type).toList());
    }

    private static Object kind(InputEventSpec event) {
        return List.of(
                event.type(),
                event.fields().keySet(),
                event.writes().keySet(),
                event.markups().stream().map(MarkupSpec::type).toList());
    }

    private void select(Plan plan, String element) {
        if (!context.editor().planId().equals(Optional.of(plan.id()))) {
            context.editor().open(plan.id());
        }
        context.editor().select(Set.of(element));
    }

    private void findFields(OutputEventSpec event) {
        for (FieldType field :
                context.vocabulary().event(event.type()).orElseThrow().fields()) {
            String name = field.name().replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(Locale.ROOT);
            find("field-" + name + "-source", JComboBox.class);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150})
    void noTextIsCut(int scale) {
        Look.apply(Theme.LIGHT, scale);
        open("crw", "clv");
        for (List<String> selection : List.of(
                List.<String>of(),
                List.of("execute"),
                List.of("accepted"),
                List.of("execute.visited"),
                List.of("execute", "visited"))) {
            context.editor().select(selection);
            Layout.layOut(panel, Look.px(WIDTH), Look.px(HEIGHT));

            assertThat(TextFit.faults(panel)).as("%s", selection).isEmpty();
        }
    }
}
