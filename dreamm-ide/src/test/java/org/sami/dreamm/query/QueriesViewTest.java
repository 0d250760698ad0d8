package org.sami.dreamm.query;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.tryout.SavedCases;
import org.sami.dreamm.tryout.StartMarkingSetup;
import org.sami.dreamm.tryout.TryOut;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.palette.Theme;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;

/** Queries are kept, answered and shown by the names of fields and commands; the search waits until it is let go on. */
@ExtendWith(OnEventThread.class)
class QueriesViewTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final Deque<Runnable> searches = new ArrayDeque<>();
    private final AtomicReference<TestCase> played = new AtomicReference<>();
    private DreammContext context;
    private QueriesView view;
    private StatesOfPlan states;
    private BoundsOfPlan bounds;
    private final StartMarkingSetup setup = new StartMarkingSetup();
    private boolean hasErrors;

    /** The project of clv, whose author has saved no query yet. */
    private static Project withoutQueries() {
        Project clv = BOATS.projectOf("clv").orElseThrow();
        return clv.withPlans(
                clv.plans().stream().map(plan -> plan.withQueries(List.of())).toList());
    }

    @BeforeEach
    void open() {
        Look.apply(Theme.LIGHT, 100);
        context = new DreammContext(
                BOATS, new ProjectDocument(BOATS.vocabulary(), withoutQueries(), Optional.empty()), Profile.ALL);
        TryOut tryOut = new TryOut(context.document());
        SavedCases cases = new SavedCases(context.document(), context.editor(), Runnable::run, Runnable::run);
        QueryAnswers answers = new QueryAnswers(context.document(), context.editor(), searches::add, Runnable::run);
        TryOutOverlay overlay = new TryOutOverlay(context, tryOut, setup, cases);
        WitnessOnNet witness = new WitnessOnNet(context.overlay(), overlay);
        bounds = new BoundsOfPlan(context, overlay, () -> List.of("robot-1", "robot-2"), searches::add, Runnable::run);
        QueryCommands commands = new QueryCommands(
                context,
                answers,
                witness,
                () -> List.of("robot-1", "robot-2"),
                () -> setup.start().map(TestStart::marking),
                () -> hasErrors,
                played::set);
        states = new StatesOfPlan(context, witness, () -> List.of("robot-1", "robot-2"), searches::add, Runnable::run);
        view = new QueriesView(context, answers, witness, commands, states, bounds);
        Layout.layOut(view, 800, 300);
    }

    @AfterEach
    void close() {
        context.close();
    }

    private void keep(String name, String text) {
        Layout.find(view, "query-name", JTextField.class).orElseThrow().setText(name);
        Layout.find(view, "query-text", JTextField.class).orElseThrow().setText(text);
        Layout.find(view, "query-keep", JButton.class).orElseThrow().doClick();
    }

    private JTable table() {
        return Layout.find(view, "queries-table", JTable.class).orElseThrow();
    }

    private String message() {
        return Layout.find(view, "queries-message", JLabel.class).orElseThrow().getText();
    }

    private boolean can(String command) {
        return context.commands().get(command).isEnabled();
    }

    private List<PlanQuery> saved() {
        return context.editor().plan().orElseThrow().queries();
    }

    @Test
    void queryIsKeptAnsweredAndItsRunIsShownOnTheNetAndPlayed() {
        keep("both sail", "reachable m(execute.robots) = 2");
        assertThat(saved()).extracting(PlanQuery::name).containsExactly("both sail");
        assertThat(can("query-show")).isFalse();

        context.commands().get("query-one").run();
        assertThat(message()).isEqualTo("Asking…");
        assertThat(can("query-stop")).isTrue();
        searches.remove().run();

        assertThat(table().getValueAt(0, 0)).hasToString("met");
        assertThat(table().getValueAt(0, 2).toString()).contains("and the engine comes there by 4 steps");
        context.commands().get("query-show").run();
        assertThat(shown()).containsExactly("select");
        for (int i = 0; i < 4; i++) {
            context.commands().get("query-next").run();
        }
        assertThat(shown()).containsExactly("execute");
        assertThat(message())
                .startsWith("firing 4 of 4: Allocation accepted (robot-1, robot-2): generic robot-1 robot-2 Choose"
                        + " allocation → Execute paths");
        assertThat(can("query-next")).isFalse();
        context.commands().get("query-play").run();
        assertThat(shown()).isEmpty();
        assertThat(played.get().steps()).hasSize(4);
    }

    @Test
    void whetherRobotsCanStandInPlacesIsAskedBySelectingOrMarkingThem() {
        assertThat(can("query-happen")).isFalse();

        context.editor().select(List.of("execute", "finished"));
        context.commands().get("query-happen").run();
        searches.remove().run();

        assertThat(saved())
                .extracting(PlanQuery::text)
                .containsExactly("reachable m(execute.robots) >= 1 and m(finished.robots) >= 1");
        assertThat(table().getValueAt(0, 0)).hasToString("met");
        assertThat(can("query-play")).as("the run that shows it").isTrue();

        setup.put(new StartMarking.Tokens("finished", 0, List.of("robot-1", "robot-2", "robot-3"), List.of()));
        context.commands().get("query-happen").run();
        searches.remove().run();

        assertThat(saved().get(1).text()).isEqualTo("reachable m(finished.robots) >= 3");
        assertThat(message()).as("there are two").startsWith("no: ");
    }

    @Test
    void statesAndFiringsOfTheGraphAreShownOnTheNet() {
        context.commands().get("query-graph").run();
        assertThat(message()).isEqualTo("Searching…");
        searches.remove().run();

        assertThat(message()).isEqualTo("all 64 states up to symmetry");
        states.selectState(0);
        assertThat(shown()).containsExactly("select");
        assertThat(message()).startsWith("state 0: Select boats: generic robot-1 robot-2");
        states.selectArrow(0);
        assertThat(shown()).contains("locations");
        assertThat(message()).startsWith("from state 0 to ").contains(": Boats chosen");

        context.commands().get("query-graph").run();
        assertThat(shown()).isEmpty();
        assertThat(message()).isBlank();
    }

    @Test
    void boundsOfPlacesStandAtThemWithWhatLimitsThem() {
        context.commands().get("query-bounds").run();
        assertThat(message()).isEqualTo("Searching for bounds…");
        assertThat(context.overlay().shown().badges().bounds()).isEmpty();
        searches.remove().run();

        assertThat(message()).isEqualTo("bounds of all 64 states");
        assertThat(context.overlay().shown().badges().bounds()).containsEntry("execute", "≤ 2");
        assertThat(context.overlay().shown().why().apply("execute"))
                .hasValueSatisfying(
                        words -> assertThat(words).startsWith("at most 2 of 2 robots: the team has no more"));

        context.commands().get("query-bounds").run();
        assertThat(context.overlay().shown().badges().bounds()).isEmpty();
        assertThat(message()).isBlank();
    }

    @Test
    void boundsOfAPlanThatRunsOtherwiseAreForgotten() {
        context.commands().get("query-bounds").run();
        searches.remove().run();

        context.apply(new RemoveElements(context.editor().planId().orElseThrow(), Set.of("visited")));

        assertThat(bounds.bounds()).isEmpty();
        assertThat(context.overlay().shown().badges().bounds()).isEmpty();
    }

    @Test
    void graphOfAPlanThatRunsOtherwiseIsForgotten() {
        context.commands().get("query-graph").run();
        searches.remove().run();
        states.selectState(2);

        context.apply(new RemoveElements(context.editor().planId().orElseThrow(), Set.of("visited")));

        assertThat(states.isShown()).isFalse();
        assertThat(shown()).isEmpty();
    }

    private List<String> shown() {
        return List.copyOf(context.overlay().shown().marking().tokens().keySet());
    }

    @Test
    void answersAreForgottenWhereThePlanRunsOtherwiseAndUndoBringsAQueryBack() {
        keep("misspelt", "reachable m(exceute) >= 1");
        keep("never stuck", "deadlock");
        context.commands().get("query-all").run();
        searches.remove().run();
        assertThat(table().getValueAt(0, 0)).hasToString("fault");
        assertThat(table().getValueAt(1, 0)).hasToString("NOT MET");

        context.apply(new RemoveElements("clv", Set.of("rejected")));
        assertThat(table().getValueAt(0, 0)).hasToString("not asked");

        context.undo();
        table().setRowSelectionInterval(0, 0);
        context.commands().get("query-remove").run();
        assertThat(saved()).extracting(PlanQuery::name).containsExactly("never stuck");
        context.undo();
        assertThat(saved()).hasSize(2);
    }

    @Test
    void searchThatIsStoppedAnswersNothingAndPlansWithErrorsAreNotSearched() {
        keep("never stuck", "deadlock");
        context.commands().get("query-all").run();
        context.commands().get("query-stop").run();
        searches.remove().run();

        assertThat(table().getValueAt(0, 0)).hasToString("not asked");
        assertThat(message()).isEqualTo("Stopped");
        hasErrors = true;
        context.commands().refresh();
        assertThat(can("query-all")).isFalse();
    }
}
