package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.get;
import static org.sami.crw.gui.SessionWorld.press;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.type;
import static org.sami.crw.gui.SessionWorld.until;

import java.awt.event.MouseEvent;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentType;
import org.sami.spn.component.Interactions;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.ui.check.Layout;
import org.sami.ui.map.MapView;
import org.sami.ui.value.MapMaker;

/**
 * Each component that Algorithms 4 to 6 may choose for an answer is answered once in the panel of decisions, by its own buttons and fields,
 * before a real session: the mission's variable has what was given then.
 */
@Tag("long")
@Timeout(900)
@TestInstance(Lifecycle.PER_CLASS)
class ComponentAnswersTest {
    private static final ComponentChoice CHOICE = new ComponentChoice(
            SessionWorld.LIBRARY.components(), SessionWorld.LIBRARY.vocabulary().types());

    private SessionWorld world;
    private DecisionsPanel panel;

    @BeforeAll
    void open() throws Exception {
        world = new SessionWorld(AskedValues.project(), "anna", "bert");
        panel = onEventThread(() -> {
            DecisionsPanel made = SessionDecisions.panel(
                    world.context,
                    SessionWorld.LIBRARY.components(),
                    DecisionMap.NONE,
                    MapMaker.PLAIN,
                    new ShownPictures(world.context));
            Layout.layOut(made, 1000, 900);
            return made;
        });
        world.start(AskedValues.TASKS);
    }

    @AfterAll
    void close() throws Exception {
        world.close();
    }

    static Stream<AskedValues.Asked> asked() {
        return AskedValues.ALL.stream();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("asked")
    void whatIsGivenIsInTheVariable(AskedValues.Asked asked) throws Exception {
        Decision decision = ask(asked.id());
        assertThat(names(chosen(decision), new HashSet<>())).containsExactlyInAnyOrderElementsOf(asked.components());

        asked.acts().forEach(this::act);
        answer(decision);

        untilOver(decision);
        assertThat(global(asked.variable())).isEqualTo(asked.given());
    }

    @Test
    void everyComponentOfTheDomainIsAnswered() {
        assertThat(AskedValues.ALL.stream().flatMap(asked -> asked.components().stream()))
                .containsAll(SessionWorld.LIBRARY.components().components().stream()
                        .map(ComponentType::name)
                        .toList());
    }

    @Test
    void aWayIsDrawnWithThePointer() throws Exception {
        Decision decision = ask("way");
        type(panel, "value-way-text", ""); // another test may have given it a value
        MapView map = find(panel, "value-way-map", MapView.class);
        JComponent canvas = find(panel, "value-way-canvas", JComponent.class);
        GeoPoint first = onEventThread(() -> map.frame().point(40, 30));
        GeoPoint second = onEventThread(() -> map.frame().point(120, 70));

        click(canvas, 40, 30);
        click(canvas, 120, 70);
        answer(decision);

        untilOver(decision);
        List<GeoPoint> drawn = ((GeoPath) global("@way")).points();
        assertThat(drawn).hasSize(2);
        for (int i = 0; i < 2; i++) {
            GeoPoint wanted = List.of(first, second).get(i);
            assertThat(drawn.get(i).latDeg()).isCloseTo(wanted.latDeg(), within(1e-6));
            assertThat(drawn.get(i).lonDeg()).isCloseTo(wanted.lonDeg(), within(1e-6));
        }
    }

    private static void click(JComponent canvas, int x, int y) {
        onEventThread(() -> {
            for (int what : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
                canvas.dispatchEvent(new MouseEvent(canvas, what, 0, 0, x, y, 1, false, MouseEvent.BUTTON1));
            }
            return canvas;
        });
    }

    @Test
    void yesIsAnAnswerAtOnce() throws Exception {
        Decision decision = ask("approve");

        press(panel, "value-decision-yes");

        untilOver(decision);
    }

    @Test
    void whatOnlyHasToBeDoneIsAnsweredWithoutAnyValue() throws Exception {
        Decision decision = ask("done");
        onEventThread(() -> {
            panel.focusDecision();
            return panel;
        });

        press(panel, "decision-answer");

        untilOver(decision);
    }

    @Test
    void aTypeThatNoComponentAsksForIsWarnedOfAndTheMissionCanBeAborted() throws Exception {
        Decision decision = ask("anything");

        assertThat(text(panel, "value-anything-warning")).isEqualTo("▲ No component can ask for a value of type any");
        assertThat(text(panel, "decision-problem")).isEqualTo("Anything: No component can ask for a value of type any");
        assertThat(onEventThread(() ->
                        find(panel, "decision-answer", AbstractButton.class).isEnabled()))
                .isFalse();
        get(world.session.abort(decision.mission()));
        untilOver(decision);
    }

    /** A question that a failed test left open is not to be the next one's. */
    @AfterEach
    void endOthers() throws Exception {
        for (PendingDecision pending : world.context.models().decisions().snapshot()) {
            get(world.session.abort(pending.decision().mission()));
        }
        until(
                "nothing is asked",
                () -> world.context.models().decisions().snapshot().isEmpty());
    }

    private Decision ask(String plan) throws Exception {
        world.start(plan);
        until(
                plan + " asks",
                () -> text(panel, "decision-asker").startsWith(plan)
                        && world.context.models().decisions().snapshot().size() == 1);
        onEventThread(() -> {
            Layout.layOut(panel, 1000, 900);
            return panel;
        });
        PendingDecision pending = onEventThread(
                () -> world.context.models().decisions().snapshot().get(0));
        return pending.decision();
    }

    /** Presses Answer, and once more where something of the answer is to be minded first, such as places far away. */
    private void answer(Decision decision) {
        press(panel, "decision-answer");
        until(
                "it is given or asked about",
                () -> isOver(decision) || text(panel, "decision-problem").equals("Answer gives it all the same"));
        if (!isOver(decision)) {
            press(panel, "decision-answer");
        }
    }

    private boolean isOver(Decision decision) {
        return world.context.models().decisions().snapshot().stream()
                .noneMatch(pending -> pending.decision().id() == decision.id());
    }

    private void untilOver(Decision decision) {
        until(decision.type() + " waits no longer", () -> isOver(decision));
    }

    private Value global(String name) throws Exception {
        return get(world.session.ask(EngineView::globals)).get(name);
    }

    /** Does what a line of the table says: presses a button, chooses in a box, or types into a field. */
    private void act(String line) {
        String[] words = line.split(" ", 3);
        switch (words[0]) {
            case "press" -> press(panel, "value-" + words[1]);
            case "choose" ->
                onEventThread(() -> {
                    find(panel, "value-" + words[1], JComboBox.class).setSelectedItem(words[2]);
                    return panel;
                });
            default -> type(panel, "value-" + words[1], words[2].replace(" / ", "\n"));
        }
    }

    private static ChosenComponent chosen(Decision decision) {
        return new Interactions(SessionWorld.LIBRARY.vocabulary())
                .of(decision)
                .map(CHOICE::choose)
                .orElseThrow();
    }

    /** The names of the components of a choice. */
    private static Set<String> names(ChosenComponent chosen, Set<String> names) {
        if (chosen instanceof ChosenComponent.Direct direct) {
            names.add(direct.component().name());
        } else if (chosen instanceof ChosenComponent.Repeated repeated) {
            names(repeated.element(), names);
        } else if (chosen instanceof ChosenComponent.Entries entries) {
            names(entries.key(), names);
            names(entries.value(), names);
        } else if (chosen instanceof ChosenComponent.Form form) {
            form.fields().values().forEach(part -> names(part, names));
        }
        return names;
    }
}
