package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * An engine with its state for a test: inputs in few words, markings as text. A marking reads {@code "generic A B #T"}:
 * tokens in order of entry, tasks with {@code #}.
 */
public final class Session {
    private final Engine engine;
    private EngineState state;
    private final List<Effect> effects = new ArrayList<>();
    private List<Effect> last = List.of();
    private long now;

    /** A session with plans of the {@link TestVocabulary}. */
    public Session(Plan... plans) {
        this(NetBuilder.project(plans));
    }

    /** A session with a project of the {@link TestVocabulary}. */
    public Session(Project project) {
        this(new Engine(TestVocabulary.TEST, project));
    }

    /** A session with an engine. */
    public Session(Engine engine) {
        this.engine = engine;
        this.state = engine.newState();
    }

    /** The engine. */
    public Engine engine() {
        return engine;
    }

    /** The state as it is now. */
    public EngineState state() {
        return state;
    }

    /** Goes on with another state of the same engine. */
    public void replaceState(EngineState other) {
        state = other;
    }

    /** Takes an input and returns what it caused. */
    public List<Effect> step(Input input) {
        last = engine.step(state, now, input);
        effects.addAll(last);
        return last;
    }

    /** Robots join. */
    public Session join(String... proxies) {
        Arrays.stream(proxies).forEach(p -> step(new Input.ProxyJoined(p)));
        return this;
    }

    /** Starts a mission and returns its id. */
    public long start(String plan) {
        return start(plan, Map.of());
    }

    /** Starts a mission with parameters and returns its id. */
    public long start(String plan, Map<String, Value> parameters) {
        step(new Input.StartMission(plan, plan, parameters));
        return last.stream()
                .filter(Effect.MissionStarted.class::isInstance)
                .map(e -> ((Effect.MissionStarted) e).mission())
                .findFirst()
                .orElse(Ids.NONE);
    }

    /** Lets time pass. */
    public Session advance(long millis) {
        now += millis;
        step(new Input.TimeReached());
        return this;
    }

    /** Sets the time of further inputs without telling the engine. */
    public Session at(long millis) {
        now = millis;
        return this;
    }

    /** Answers the latest activation of a place. */
    public List<Effect> answer(String type, String place, String... proxies) {
        return answer(type, latest(place), proxies);
    }

    /** Answers an activation. */
    public List<Effect> answer(String type, Activation activation, String... proxies) {
        return step(
                new Input.Received(Occurrence.answer(type, activation, Arrays.asList(proxies), List.of(), Map.of())));
    }

    /** Answers an activation, naming tasks. */
    public List<Effect> answerTasks(String type, Activation activation, TaskId... tasks) {
        return step(new Input.Received(Occurrence.answer(type, activation, List.of(), Arrays.asList(tasks), Map.of())));
    }

    /** News to all missions. */
    public List<Effect> news(String type, String... proxies) {
        return step(new Input.Received(Occurrence.news(type, Arrays.asList(proxies), Map.of())));
    }

    /** The operator answers the only open decision. */
    public List<Effect> decide(Answer answer) {
        return step(new Input.AnswerDecision(onlyDecision().id(), answer, Answerer.OPERATOR));
    }

    /** Presses an interrupt in every mission that offers it. */
    public List<Effect> press(String name, String... proxies) {
        return step(new Input.Interrupt(Ids.NONE, name, Arrays.asList(proxies)));
    }

    /** Questions about the state. */
    public EngineView view() {
        return engine.view(state);
    }

    /** The only open decision. */
    public Decision onlyDecision() {
        List<Decision> open = view().decisions();
        if (open.size() != 1) {
            throw new AssertionError("Open decisions: " + open);
        }
        return open.get(0);
    }

    /** The tokens of a place of a mission as text; empty where it has none or the mission is over. */
    public String marking(long mission, String place) {
        return view().mission(mission)
                .map(m -> m.marking().getOrDefault(place, List.of()))
                .map(Session::text)
                .orElse("");
    }

    /** The whole marking of a mission, by place. */
    public Map<String, String> marking(long mission) {
        Map<String, String> result = new LinkedHashMap<>();
        view().mission(mission).ifPresent(m -> m.marking().forEach((p, tokens) -> result.put(p, text(tokens))));
        return result;
    }

    /** The only running mission of a plan. */
    public Optional<MissionView> missionOf(String plan) {
        return view().missions().stream().filter(m -> m.plan().equals(plan)).findFirst();
    }

    /** Id of the only running mission of a plan. */
    public long idOf(String plan) {
        return missionOf(plan).map(MissionView::id).orElse(Ids.NONE);
    }

    /** The latest activation of a place. */
    public Activation latest(String place) {
        List<Activation> all = activations(place);
        return all.get(all.size() - 1);
    }

    /** All activations of a place, in order. */
    public List<Activation> activations(String place) {
        return effects.stream()
                .filter(Effect.Activated.class::isInstance)
                .map(e -> ((Effect.Activated) e).activation())
                .filter(a -> a.place().equals(place))
                .toList();
    }

    /** Transitions that fired in the last step, in order. */
    public List<String> fired() {
        return fired(last);
    }

    /** Transitions that fired since the session began, in order. */
    public List<String> allFired() {
        return fired(effects);
    }

    /** Kinds of notes of the last step, in order. */
    public List<NoteKind> notes() {
        return last.stream()
                .filter(Effect.Noted.class::isInstance)
                .map(e -> ((Effect.Noted) e).kind())
                .toList();
    }

    /** How a mission ended, empty while it runs. */
    public Optional<Outcome> outcome(long mission) {
        return effects.stream()
                .filter(e -> e instanceof Effect.MissionEnded m && m.mission() == mission)
                .map(e -> ((Effect.MissionEnded) e).outcome())
                .reduce((a, b) -> b);
    }

    /** Effects of the last step. */
    public List<Effect> last() {
        return last;
    }

    /** All effects. */
    public List<Effect> effects() {
        return effects;
    }

    private static List<String> fired(List<Effect> effects) {
        return effects.stream()
                .filter(Effect.Fired.class::isInstance)
                .map(e -> ((Effect.Fired) e).transition())
                .toList();
    }

    private static String text(List<Token> tokens) {
        return tokens.stream().map(Session::text).collect(Collectors.joining(" "));
    }

    private static String text(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? "#" + task.task().name() : "generic";
    }
}
