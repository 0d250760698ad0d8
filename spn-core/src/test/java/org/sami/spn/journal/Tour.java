package org.sami.spn.journal;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.HostStatus;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.ManualClock;
import org.sami.spn.host.ManualExecutor;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/**
 * A small mission with decisions, sub-missions, commands and a timer, and a world around it that reacts to nothing but
 * the engine's state: so that it goes on after a crash as it would have without.
 */
final class Tour {
    static final Project PROJECT = NetBuilder.project(
            List.of(new VariableSpec("@asked", ValueType.Simple.TEXT, Optional.empty())), tour(), leg());
    static final JournalHeader HEADER =
            JournalHeader.of("the plans of the tour", Map.of("domain.json", "its words"), Map.of("seed", "7"));

    private static final List<String> BOATS = List.of("b1", "b2", "b3", "b4", "b5");

    private final ManualExecutor executor = new ManualExecutor();
    private final ManualClock clock = new ManualClock();
    private final Engine engine;
    private final EngineState state;
    private final EngineHost host;
    private final List<Effect> effects = new ArrayList<>();
    private final Set<Long> commanded = new LinkedHashSet<>();

    Tour(InputJournal journal, EngineState state, Engine engine) {
        this.engine = engine;
        this.state = state;
        clock.moveTo(journal.lastMillis());
        host = EngineHostBuilder.of(engine, state)
                .journal(journal)
                .clock(clock)
                .executor(executor)
                .batchLimit(1)
                .build();
        host.addListener((index, at, input, ofStep, view) -> effects.addAll(ofStep));
        host.register("Drive", (activation, context) -> commanded.add(activation.id()), executor);
    }

    static Engine engine() {
        return new Engine(HostPlans.VOCABULARY, PROJECT);
    }

    static Tour fresh(InputJournal journal) {
        Engine engine = engine();
        return new Tour(journal, engine.newState(), engine);
    }

    /** Runs to the mission's end, whatever has happened already. */
    Tour run() {
        host.resume();
        while (turn()) {
            executor.runAll();
        }
        if (host.status().kind() != HostStatus.Kind.RUNNING) {
            throw new IllegalStateException(host.status().reason());
        }
        return this;
    }

    byte[] stateBytes() {
        return StateCodec.encode(state);
    }

    List<Effect> effects() {
        return effects;
    }

    /** The activations that the handler was given. */
    Set<Long> commanded() {
        return commanded;
    }

    private boolean turn() {
        executor.runAll();
        if (host.status().kind() != HostStatus.Kind.RUNNING) {
            return false;
        }
        EngineView view = engine.view(state);
        Optional<Input> next = begin(view).or(() -> arrival(view)).or(() -> answer(view));
        if (next.isPresent()) {
            return host.post(next.get());
        }
        view.nextDueMillis().ifPresent(clock::moveTo);
        return view.nextDueMillis().isPresent();
    }

    private static Optional<Input> begin(EngineView view) {
        for (String boat : BOATS) {
            if (!view.proxies().contains(boat)) {
                return Optional.of(new Input.ProxyJoined(boat));
            }
        }
        boolean over = view.variable(Ids.NONE, "@asked").isPresent();
        return view.missions().isEmpty() && !over
                ? Optional.of(new Input.StartMission("tour", "Tour", Map.of()))
                : Optional.empty();
    }

    private static Optional<Input> arrival(EngineView view) {
        for (Activation activation : view.openActivations()) {
            List<Token> here = view.mission(activation.mission())
                    .orElseThrow()
                    .marking()
                    .getOrDefault(activation.place(), List.of());
            for (Token token : here) {
                if (activation.type().equals("Drive") && token instanceof Token.Proxy proxy) {
                    return Optional.of(new Input.Received(
                            Occurrence.answer("Done", activation, List.of(proxy.proxy()), List.of(), Map.of())));
                }
            }
        }
        return Optional.empty();
    }

    private static Optional<Input> answer(EngineView view) {
        return view.decisions().stream()
                .findFirst()
                .map(decision -> new Input.AnswerDecision(decision.id(), answerTo(decision), Answerer.OPERATOR));
    }

    private static Answer answerTo(Decision decision) {
        return decision.question() instanceof Question.ChooseProxies choice
                ? new Answer.Proxies(choice.proxies())
                : new Answer.YesNo(true);
    }

    private static Plan tour() {
        return new NetBuilder("tour")
                .start("Select")
                .output("Select", "Choose")
                .sub("Work", "leg")
                .output(
                        "Clock",
                        "StartTimer",
                        Map.of("duration", new FieldSource.Fixed(new DurationValue(10_000))),
                        Map.of())
                .output(
                        "Ask",
                        "Approve",
                        Map.of("question", new FieldSource.Fixed(new TextValue("Home?"))),
                        Map.of("question", "@asked"))
                .places("Approved", "Back")
                .end("End")
                .transition("chosen", "Chosen")
                .in("Select", "chosen", "generic >= 1", "relevant all")
                .out("chosen", "Work", "take all relevant")
                .out("chosen", "Clock", "take 1 generic")
                .transition("back")
                .in("Work", "back", "proxy >= 1")
                .out("back", "Back", "take all sub")
                .transition("rung", "TimerExpired")
                .in("Clock", "rung", "generic >= 1")
                .out("rung", "Ask", "take 1 generic")
                .transition("yes", "Yes")
                .in("Ask", "yes", "generic >= 1")
                .out("yes", "Approved", "take 1 generic")
                .transition("finish")
                .in("Approved", "finish", "generic >= 1")
                .in("Back", "finish", "proxy >= 1")
                .out("finish", "End", "take all any")
                .build();
    }

    private static Plan leg() {
        return new NetBuilder("leg")
                .start("Go")
                .output("Go", "Drive")
                .places("There")
                .end("LegEnd")
                .transition("arrived", "Done")
                .in("Go", "arrived", "relevant all")
                .out("arrived", "There", "take all relevant")
                .transition("all")
                .in("Go", "all", "proxy = 0")
                .in("There", "all", "proxy >= 1")
                .out("all", "LegEnd", "take all any")
                .build();
    }
}
