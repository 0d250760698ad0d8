package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

class InterruptModelTest {
    private final ModelWorld world = new ModelWorld();

    /** The project with another text in it. */
    private String changed(String from, String to) {
        String text = new ProjectWriter(ModelWorld.VOCABULARY).text(world.project);
        assertThat(text).contains(from);
        String changed = text.replace(from, to);
        Project project = new ProjectReader(ModelWorld.VOCABULARY).read(changed).orThrow();
        return new ProjectWriter(ModelWorld.VOCABULARY).text(project);
    }

    @Test
    void buttonsOfAMissionAreThoseOfThePlanWithWhichItStarted() {
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("first"));
        world.step(new Input.LoadProject(changed("There and back", "Another")), ModelWorld.start("second"));
        world.refresh();

        assertThat(world.models.interrupts().snapshot())
                .extracting(button -> button.mission() + " " + button.plan())
                .contains("1 There and back", "2 Another")
                .doesNotContain("1 Another");
    }

    @Test
    void whatMarkupSaysOfAButtonStandsOnIt() {
        String marked = changed(
                "\"fields\": {\"interruptName\": \"Over\"}",
                "\"fields\": {\"interruptName\": \"Over\"}, \"markups\": ["
                        + "{\"type\": \"Priority\", \"options\": {\"rank\": \"CRITICAL\"}}, "
                        + "{\"type\": \"Description\", \"options\": {\"source\": \"Ends it\"}}]");
        world.step(new Input.LoadProject(marked), ModelWorld.start("marked"));
        world.refresh();

        assertThat(world.models.interrupts().snapshot())
                .filteredOn(button -> button.name().equals("Over"))
                .singleElement()
                .satisfies(button -> assertThat(button.priority()).isEqualTo(Priority.CRITICAL))
                .satisfies(button -> assertThat(button.description()).isEqualTo("Ends it"));
        assertThat(world.models.interrupts().snapshot())
                .filteredOn(button -> button.name().equals("Go"))
                .extracting(InterruptChoice::priority)
                .containsExactly(Priority.MEDIUM);
    }

    /** Boats work, have their batteries swapped and come back, or are taken out for good, as in explore-team. */
    private static final String BUTTONS = """
        {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
          "id": "p", "name": "Buttons",
          "places": [{"id": "start", "start": true}, {"id": "work", "name": "Work"},
            {"id": "swap-button", "outputs": [{"id": "s", "type": "ProxyInterrupt", "fields": {"interruptName": {"value": "swap"}}}]},
            {"id": "abort-button", "outputs": [{"id": "a", "type": "ProxyInterrupt", "fields": {"interruptName": {"value": "abort"}}}]},
            {"id": "swapped", "name": "Swapped"}, {"id": "out", "name": "Out"}],
          "transitions": [
            {"id": "begin", "inputs": [{"id": "i0", "type": "OperatorInterruptReceived", "fields": {"interruptName": "begin"}}]},
            {"id": "swap", "inputs": [{"id": "i1", "type": "ProxyInterruptReceived"}]},
            {"id": "abort", "inputs": [{"id": "i2", "type": "ProxyInterruptReceived"}]},
            {"id": "back", "inputs": [{"id": "i3", "type": "OperatorInterruptReceived", "fields": {"interruptName": "back"}}]}],
          "inEdges": [
            {"id": "e0", "place": "start", "transition": "begin", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
            {"id": "e1", "place": "swap-button", "transition": "swap", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
            {"id": "e2", "place": "work", "transition": "swap", "requirements": [{"match": "at-least", "n": 1, "kind": "relevant"}]},
            {"id": "e3", "place": "abort-button", "transition": "abort", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
            {"id": "e4", "place": "work", "transition": "abort", "requirements": [{"match": "at-least", "n": 1, "kind": "relevant"}]},
            {"id": "e5", "place": "swapped", "transition": "back", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]}],
          "outEdges": [
            {"id": "oa", "transition": "begin", "place": "work", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
            {"id": "ob", "transition": "begin", "place": "swap-button", "requirements": [{"action": "add", "n": 1, "kind": "generic"}]},
            {"id": "oc", "transition": "begin", "place": "abort-button", "requirements": [{"action": "add", "n": 1, "kind": "generic"}]},
            {"id": "o1", "transition": "swap", "place": "swap-button", "requirements": [{"action": "take", "n": 1, "kind": "generic"}]},
            {"id": "o2", "transition": "swap", "place": "swapped", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
            {"id": "o3", "transition": "abort", "place": "abort-button", "requirements": [{"action": "take", "n": 1, "kind": "generic"}]},
            {"id": "o4", "transition": "abort", "place": "out", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
            {"id": "o5", "transition": "back", "place": "work", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]}]}]}
        """;

    private static final Input BEGIN = new Input.Interrupt(1, "begin", List.of("anna"));

    private final ModelWorld buttons = new ModelWorld(BUTTONS);

    private List<InterruptChoice> offered() {
        buttons.refresh();
        return buttons.models.interrupts().snapshot();
    }

    @Test
    void aButtonKeepsItsPlaceAfterEachPress() {
        buttons.step(new Input.ProxyJoined("anna"), new Input.ProxyJoined("bert"), ModelWorld.start("first"), BEGIN);
        assertThat(offered()).extracting(InterruptChoice::name).containsExactly("begin", "back", "swap", "abort");

        buttons.step(new Input.Interrupt(1, "swap", List.of("anna")));

        assertThat(offered()).extracting(InterruptChoice::name).containsExactly("begin", "back", "swap", "abort");
        assertThat(buttons.models.missions().snapshot().mission(1))
                .hasValueSatisfying(mission -> assertThat(mission.firings()).isEqualTo(2));
    }

    @Test
    void aButtonSaysWhetherThePlanLeadsBack() {
        buttons.step(new Input.ProxyJoined("anna"), ModelWorld.start("first"));

        assertThat(offered())
                .extracting(InterruptChoice::noWayBack)
                .containsExactly(
                        "Nothing leads back from 'Work' to 'start'.",
                        "",
                        "",
                        "Nothing leads back from 'Out' to 'Work'.");
    }

    @Test
    void aButtonThatAsksForWhomNamesTheQuestionUntilItIsWithdrawn() {
        buttons.step(
                new Input.ProxyJoined("anna"),
                ModelWorld.start("first"),
                BEGIN,
                new Input.Interrupt(1, "swap", List.of()));
        OptionalLong asking = offered().get(2).asking();
        assertThat(asking)
                .hasValue(buttons.models.decisions().pending().get(0).decision().id());
        assertThat(offered().get(3).asking()).isEmpty();

        assertThat(buttons.models.decisions().check(asking.getAsLong(), new Answer.Rejected(), ModelWorld.VOCABULARY))
                .isEmpty();
        buttons.step(new Input.AnswerDecision(asking.getAsLong(), new Answer.Rejected(), Answerer.OPERATOR));

        assertThat(offered().get(2).asking()).isEmpty();
        assertThat(buttons.models.decisions().pending()).isEmpty();
    }
}
