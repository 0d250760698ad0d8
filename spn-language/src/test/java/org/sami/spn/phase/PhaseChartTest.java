package org.sami.spn.phase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/** Phases, rows, branches and progress of thesis 5.2.3. */
class PhaseChartTest {
    /** Locations are given; an assignment is computed, shown, and refused until it is accepted; then it is executed. */
    private static final Plan SEARCH = marked(
            new NetBuilder("search")
                    .start("Where")
                    .output("Where", "Provide", item("Locations", "OPERATOR"))
                    .output("Compute", "Do", item("Assignment", "SAMI"))
                    .output("Ask", "Approve", item("Assignment", "OPERATOR"))
                    .output("Go", "Do", item("Execution", "PROXY"))
                    .end("Over")
                    .transition("given", "Provided")
                    .in("Where", "given", "generic >= 1")
                    .out("given", "Compute", "take all generic")
                    .transition("computed", "Done")
                    .in("Compute", "computed", "generic >= 1")
                    .out("computed", "Ask", "take all generic")
                    .transition("accepted", "Yes")
                    .in("Ask", "accepted", "generic >= 1")
                    .out("accepted", "Go", "take all generic")
                    .transition("refused", "No")
                    .in("Ask", "refused", "generic >= 1")
                    .out("refused", "Compute", "take all generic")
                    .transition("gone", "Done")
                    .in("Go", "gone", "generic >= 1")
                    .out("gone", "Over", "take all generic")
                    .build(),
            Map.of("accepted", branch("It is good", ""), "refused", branch("Another one", "")));

    private static final PhaseChart CHART = PhaseChart.of(SEARCH, TestVocabulary.TEST);

    private static MarkupSpec item(String phase, String actor) {
        return new MarkupSpec(
                Reserved.PHASE_ITEM,
                Map.of(Reserved.PHASE_NAME, new TextValue(phase), Reserved.ACTOR, new EnumValue("Actor", actor)));
    }

    private static MarkupSpec branch(String action, String phase) {
        return new MarkupSpec(
                Reserved.PHASE_BRANCH,
                Map.of(
                        Reserved.ACTION_NAME,
                        new TextValue(action),
                        Reserved.PHASE_NAME,
                        new TextValue(phase),
                        Reserved.ACTOR,
                        new EnumValue("Actor", "OPERATOR")));
    }

    /** The plan with markups on the first input event of transitions. */
    private static Plan marked(Plan plan, Map<String, MarkupSpec> markups) {
        List<Transition> transitions = plan.transitions().stream()
                .map(t -> markups.containsKey(t.id()) ? marked(t, markups.get(t.id())) : t)
                .toList();
        return new Plan(
                plan.id(),
                plan.name(),
                plan.description(),
                plan.places(),
                transitions,
                plan.inEdges(),
                plan.outEdges(),
                plan.variables(),
                plan.reads(),
                plan.tasks(),
                plan.layout(),
                plan.notes(),
                plan.testCases());
    }

    private static Transition marked(Transition t, MarkupSpec markup) {
        List<InputEventSpec> inputs = t.inputs().stream()
                .map(i -> new InputEventSpec(i.id(), i.type(), i.fields(), i.writes(), List.of(markup)))
                .toList();
        return new Transition(t.id(), t.name(), t.mode(), t.waitFor(), inputs);
    }

    private static Stream<String> boxes(PhaseView view) {
        return view.boxes().stream()
                .map(box -> box.column() + " " + view.actors().get(box.row()) + " "
                        + box.action().label());
    }

    @Test
    void phasesComeInTheOrderInWhichTheyAreReached() {
        assertThat(CHART.phases()).containsExactly("Locations", "Assignment", "Execution");
        assertThat(PhaseChart.of(new NetBuilder("p").start("s").build(), TestVocabulary.TEST)
                        .isEmpty())
                .isTrue();
    }

    @Test
    void branchIsAButtonOnTheNearestActionBefore() {
        assertThat(CHART.options("Ask.Approve"))
                .extracting(PhaseAction::label)
                .containsExactly("It is good", "Another one");
        assertThat(CHART.options("Compute.Do")).isEmpty();
        assertThat(CHART.action("accepted.Yes")).map(PhaseAction::phase).contains("Assignment");
    }

    @Test
    void phaseShowsItsActionsByActorAndTheEffectOfAChoice() {
        PhaseView good = CHART.view("Assignment", Map.of());
        PhaseView again = CHART.view("Assignment", Map.of("Ask.Approve", "refused.No"));

        assertThat(boxes(good)).containsExactly("0 SAMI Compute", "1 OPERATOR Ask", "2 OPERATOR It is good");
        assertThat(good.next()).containsExactly("Execution");
        assertThat(good.boxes().get(1).chosen()).isEqualTo("accepted.Yes");
        assertThat(boxes(again)).containsExactly("0 SAMI Compute", "1 OPERATOR Ask", "2 OPERATOR Another one");
        assertThat(again.next()).as("back to its own beginning").isEmpty();
    }

    @Test
    void lastPhaseLeadsNowhereAndTheFirstToTheSecond() {
        assertThat(CHART.view("Locations", Map.of()).next()).containsExactly("Assignment");
        assertThat(CHART.view("Execution", Map.of()).next()).isEmpty();
        assertThatThrownBy(() -> CHART.view("Exection", Map.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Exection");
    }

    @Test
    void choiceThatIsNoneShowsTheFirstOption() {
        assertThat(CHART.view("Assignment", Map.of("Ask.Approve", "gone")))
                .isEqualTo(CHART.view("Assignment", Map.of()));
    }

    @Test
    void actionsOfOneVertexFollowOneAnother() {
        PhaseChart chart = PhaseChart.of(
                new NetBuilder("two")
                        .start("s")
                        .output("s", "Do", item("One", "SAMI"))
                        .output("s", "Approve", item("One", "OPERATOR"))
                        .build(),
                TestVocabulary.TEST);

        assertThat(chart.view("One", Map.of()).boxes())
                .extracting(PhaseView.Box::column)
                .containsExactly(0, 1);
    }

    @Test
    void branchIntoAnotherPhaseBelongsToThatOne() {
        Plan plan = marked(SEARCH, Map.of("accepted", branch("It is good", "Execution")));
        PhaseChart chart = PhaseChart.of(plan, TestVocabulary.TEST);

        assertThat(chart.view("Assignment", Map.of()).next()).containsExactly("Execution");
        assertThat(boxes(chart.view("Execution", Map.of()))).containsExactly("0 OPERATOR It is good", "1 PROXY Go");
    }

    @Test
    void transitionThatAsksForAbsenceDoesNotFollowThePlace() {
        NetBuilder net = new NetBuilder("inhibited")
                .start("s")
                .output("s", "Do", item("Work", "SAMI"))
                .places("Team", "Home", "elsewhere")
                .output("Home", "Do", item("Way back", "PROXY"))
                .transition("done", "Done")
                .in("s", "done", "generic >= 1")
                .out("done", "Team", "take all generic")
                .transition("all-done")
                .in("s", "all-done", "proxy = 0")
                .out("all-done", "Home", "take all generic");

        PhaseChart alone = PhaseChart.of(net.build(), TestVocabulary.TEST);
        PhaseChart behind =
                PhaseChart.of(net.in("elsewhere", "all-done", "generic >= 1").build(), TestVocabulary.TEST);

        assertThat(alone.view("Work", Map.of()).next()).containsExactly("Way back");
        assertThat(behind.view("Work", Map.of()).next()).isEmpty();
    }

    @Test
    void missionsProgressIsSeenInTheBoxes() {
        Session session = new Session(SEARCH);
        PhaseProgress progress = new PhaseProgress(CHART, SEARCH, 1);
        long mission = session.start("search");
        assertThat(mission).isEqualTo(1);
        last(session).forEach(progress);
        assertThat(progress.status("Where.Provide")).isEqualTo(PhaseProgress.Status.ACTIVE);
        assertThat(progress.status("Ask.Approve")).isEqualTo(PhaseProgress.Status.AHEAD);

        session.decide(new Answer.Fields(Map.of("number", new IntegerValue(1)))).forEach(progress);
        session.answer("Done", "Compute").forEach(progress);
        assertThat(progress.status("Where.Provide")).isEqualTo(PhaseProgress.Status.DONE);
        assertThat(progress.status("Compute.Do")).isEqualTo(PhaseProgress.Status.DONE);
        assertThat(progress.status("Ask.Approve")).isEqualTo(PhaseProgress.Status.ACTIVE);
        assertThat(progress.taken()).isEmpty();

        session.decide(new Answer.YesNo(false)).forEach(progress);
        assertThat(progress.taken()).containsExactly(Map.entry("Ask.Approve", "refused.No"));
        assertThat(progress.status("Compute.Do")).as("again").isEqualTo(PhaseProgress.Status.ACTIVE);
        assertThat(progress.executions("Compute.Do")).isEqualTo(2);

        session.answer("Done", "Compute").forEach(progress);
        session.decide(new Answer.YesNo(true)).forEach(progress);
        assertThat(progress.taken()).containsExactly(Map.entry("Ask.Approve", "accepted.Yes"));
        session.answer("Done", "Go").forEach(progress);
        assertThat(progress.status("Go.Do")).isEqualTo(PhaseProgress.Status.DONE);
    }

    private static List<Effect> last(Session session) {
        return session.last();
    }
}
