package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** A sketched plan that runs with everything real but the hulls: engine, host, handlers, proxies, boat servers. */
final class PlanScene {
    /** The mission of the sketched plan. */
    static final long MISSION = 1;

    private static final int LONGEST_S = 600;

    final TestWorld world;
    final List<Effect> effects = new ArrayList<>();

    /** Starts the mission with boats named boat-1, boat-2 and so on, four metres apart along the quay east of home. */
    PlanScene(PlanSketch plan, int boats) {
        this(plan, boats, hull -> {});
    }

    /** As the other, with hulls that are made ready before their boats are heard of. */
    PlanScene(PlanSketch plan, int boats, Consumer<TestHull> ready) {
        this(plan.project(), PlanSketch.ROOT, boats, ready);
    }

    /** A plan of a project, on boats as in the others. */
    PlanScene(Project project, String plan, int boats, Consumer<TestHull> ready) {
        this(new TestWorld(new HostedEngine(project)));
        for (int boat = 1; boat <= boats; boat++) {
            world.addBoat("boat-" + boat, 4.0 * boat, 0, ready);
        }
        world.run(2);
        post(new Input.StartMission(plan, "test", Map.of()));
    }

    /** A world in which nothing runs yet. */
    PlanScene(TestWorld world) {
        this.world = world;
        world.host.addListener((index, atMillis, input, stepped, view) -> effects.addAll(stepped));
    }

    static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }

    void post(Input input) {
        world.host.post(input);
        world.run(0.1);
    }

    void run(double seconds) {
        world.run(seconds);
    }

    /** Lets time pass until something is so; fails if it is not within ten minutes. */
    PlanScene until(String what, BooleanSupplier isSo) {
        for (int tick = 0; tick < LONGEST_S * 10 && !isSo.getAsBoolean(); tick++) {
            world.run(0.1);
        }
        assertThat(isSo.getAsBoolean()).as(what + "; noted: " + notes()).isTrue();
        return this;
    }

    /** Waits until a boat's token stands in a place. */
    PlanScene untilBoat(String boat, String place) {
        return until(boat + " stands in " + place, () -> stands(new Token.Proxy(boat), place));
    }

    /** Waits until a task's token stands in a place. */
    PlanScene untilTask(String task, String place) {
        return until(task + " stands in " + place, () -> stands(new Token.Task(new TaskId(MISSION, task)), place));
    }

    /** Waits until the generic token stands in a place. */
    PlanScene untilGeneric(String place) {
        return until("the generic token stands in " + place, () -> stands(Token.GENERIC, place));
    }

    boolean stands(Token token, String place) {
        return marking(MISSION, place).contains(token);
    }

    List<Token> marking(long mission, String place) {
        return world.host.ask(view -> view.mission(mission)
                .map(MissionView::marking)
                .map(marking -> marking.getOrDefault(place, List.of()))
                .orElse(List.of()));
    }

    Value variable(String name) {
        return world.host.ask(view -> view.variable(MISSION, name)).orElseThrow();
    }

    /** The one decision that is open. */
    Decision decision() {
        List<Decision> open = world.host.ask(view -> view.decisions());
        assertThat(open).as("open decisions; noted: " + notes()).hasSize(1);
        return open.get(0);
    }

    void answer(Answer answer) {
        post(new Input.AnswerDecision(decision().id(), answer, Answerer.OPERATOR));
    }

    /** An answer is refused with a message that says a word, and the question stays open. */
    void assertRefused(Answer answer, String word) {
        Decision asked = decision();
        int before = notes().size();
        answer(answer);
        assertThat(notes().subList(before, notes().size()))
                .as("what is said of " + answer)
                .singleElement()
                .satisfies(note -> assertThat(note).contains("does not fit").contains(word));
        assertThat(decision().id()).isEqualTo(asked.id());
    }

    /** Presses a button. */
    void press(String name, String... boats) {
        post(new Input.Interrupt(MISSION, name, List.of(boats)));
    }

    /** The names of the buttons that are offered. */
    List<String> buttons() {
        List<InterruptButton> offered = world.host.ask(EngineView::interrupts);
        return offered.stream().map(InterruptButton::name).toList();
    }

    static Token boat(String boat) {
        return new Token.Proxy(boat);
    }

    /** How a mission ended; fails where it has not. */
    Outcome outcome(long mission) {
        return effects.stream()
                .filter(effect -> effect instanceof Effect.MissionEnded ended && ended.mission() == mission)
                .map(effect -> ((Effect.MissionEnded) effect).outcome())
                .findFirst()
                .orElseThrow(() -> new AssertionError("The mission has not ended; noted: " + notes()));
    }

    /** The open activation of an output event. */
    Activation asked(String output) {
        return world.host.ask(view -> view.openActivations()).stream()
                .filter(activation -> activation.type().equals(output))
                .findFirst()
                .orElseThrow();
    }

    /** The occurrences of a type that transitions used, in order. */
    List<Occurrence> used(String input) {
        return effects.stream()
                .filter(Effect.Fired.class::isInstance)
                .flatMap(effect -> ((Effect.Fired) effect).used().stream())
                .filter(occurrence -> occurrence.type().equals(input))
                .toList();
    }

    List<String> notes() {
        return effects.stream()
                .filter(Effect.Noted.class::isInstance)
                .map(effect -> ((Effect.Noted) effect).message())
                .toList();
    }

    List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }
}
