package org.sami.crw.handler;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.engine.PendingAnswer;
import org.sami.spn.host.EngineFunction;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** An engine without plans: it has the effects that a test wants, remembers what handlers ask it to, and keeps what comes in. */
final class ScriptedEngine implements EngineFunction, EngineView {
    final List<Input> inputs = new ArrayList<>();
    final List<Activation> open = new ArrayList<>();
    final Map<Long, MissionView> missions = new LinkedHashMap<>();
    final Set<String> awaited = new HashSet<>();
    final Map<TaskId, Map<String, Value>> tasks = new LinkedHashMap<>();
    private final ArrayDeque<Effect> next = new ArrayDeque<>();
    private final Map<String, Value> memory = new LinkedHashMap<>();
    private final List<String> proxies = new ArrayList<>();
    private final Vocabulary vocabulary;

    ScriptedEngine(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** These effects come with the next input. */
    void willDo(Effect... effects) {
        next.addAll(List.of(effects));
    }

    /** The input events received so far of one type, in order. */
    List<Occurrence> received(String type) {
        return inputs.stream()
                .filter(Input.Received.class::isInstance)
                .map(input -> ((Input.Received) input).occurrence())
                .filter(occurrence -> occurrence.type().equals(type))
                .toList();
    }

    @Override
    public void step(long nowMillis, Input input, Consumer<? super Effect> effects) {
        inputs.add(input);
        if (input instanceof Input.Remember remember) {
            memory.put(remember.mission() + "/" + remember.key(), remember.value());
        } else if (input instanceof Input.ProxyJoined joined) {
            proxies.add(joined.proxy());
        } else if (input instanceof Input.TimeReached) {
            next.forEach(effects);
            next.clear();
        }
    }

    @Override
    public EngineView view() {
        return this;
    }

    @Override
    public byte[] encode() {
        return new byte[0];
    }

    @Override
    public Vocabulary vocabulary() {
        return vocabulary;
    }

    @Override
    public List<MissionView> missions() {
        return List.copyOf(missions.values());
    }

    @Override
    public List<PendingAnswer> pendingAnswers(long mission) {
        return List.of();
    }

    @Override
    public List<Effect> markingAsEffects() {
        return List.of();
    }

    @Override
    public Optional<MissionView> mission(long id) {
        return Optional.ofNullable(missions.get(id));
    }

    @Override
    public Optional<Plan> plan(String id) {
        return Optional.empty();
    }

    @Override
    public Optional<Plan> planOf(long mission) {
        return Optional.empty();
    }

    @Override
    public Project project() {
        throw new UnsupportedOperationException("a script has no project");
    }

    @Override
    public int projectVersion() {
        return 1;
    }

    @Override
    public Map<String, Value> globals() {
        return Map.of();
    }

    @Override
    public Optional<String> subject(long decision) {
        return Optional.empty();
    }

    @Override
    public List<Decision> decisions() {
        return List.of();
    }

    @Override
    public List<InterruptButton> interrupts() {
        return List.of();
    }

    @Override
    public List<String> proxies() {
        return List.copyOf(proxies);
    }

    @Override
    public Optional<Value> variable(long mission, String name) {
        return Optional.empty();
    }

    @Override
    public Optional<Value> parameter(long mission, String key) {
        return Optional.empty();
    }

    @Override
    public Map<TaskId, String> allocation() {
        return Map.of();
    }

    @Override
    public List<TaskId> namesOf(TaskId task) {
        return tasks.containsKey(task) ? List.of(task) : List.of();
    }

    @Override
    public Optional<Map<String, Value>> task(TaskId task) {
        return Optional.ofNullable(tasks.get(task));
    }

    @Override
    public boolean awaits(String inputEvent) {
        return awaited.contains(inputEvent);
    }

    @Override
    public Optional<Value> memory(long mission, String key) {
        return Optional.ofNullable(memory.get(mission + "/" + key));
    }

    @Override
    public Optional<Activation> activation(long id) {
        return openActivations().stream()
                .filter(activation -> activation.id() == id)
                .findFirst();
    }

    @Override
    public List<Activation> openActivations() {
        return List.copyOf(open);
    }

    @Override
    public OptionalLong nextDueMillis() {
        return OptionalLong.empty();
    }

    @Override
    public List<Long> dueMillis() {
        return List.of();
    }

    @Override
    public EnablingExplanation whyNotEnabled(long mission, String transition) {
        return new EnablingExplanation(true, List.of());
    }
}
