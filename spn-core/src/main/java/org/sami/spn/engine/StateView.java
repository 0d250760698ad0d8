package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.rule.Interrupts;
import org.sami.spn.engine.rule.MissionStart;
import org.sami.spn.engine.rule.Routing;
import org.sami.spn.engine.rule.VariableScopes;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Vocabulary;

/** Answers questions about a state. */
final class StateView implements EngineView {
    private final NetState state;

    StateView(EngineState state) {
        this.state = state.net;
    }

    @Override
    public List<MissionView> missions() {
        return state.missions.values().stream().map(StateView::view).toList();
    }

    @Override
    public Optional<MissionView> mission(long id) {
        return Optional.ofNullable(state.missions.get(id)).map(StateView::view);
    }

    private static MissionView view(MissionState m) {
        Map<String, List<Token>> marking = new LinkedHashMap<>();
        for (PlaceState place : m.places) {
            if (place != null && place.total() > 0) {
                marking.put(
                        place.place.id(),
                        place.inOrder().stream().map(e -> e.token).toList());
            }
        }
        return new MissionView(
                m.id,
                m.parent == null ? Ids.NONE : m.parent.id,
                m.root.id,
                m.instance == null ? "" : m.instance.place.place.id(),
                m.plan.plan.id(),
                m.name,
                m.status,
                marking,
                m.plan.project.version,
                m.startedAt == MissionState.UNKNOWN ? OptionalLong.empty() : OptionalLong.of(m.startedAt),
                m.firings);
    }

    @Override
    public List<Effect> markingAsEffects() {
        List<Effect> effects = new ArrayList<>();
        for (MissionState m : state.missions.values()) {
            effects.add(MissionStart.started(m));
            for (Visit v = m.firstVisit(); v != null; v = v.next) {
                effects.add(new Effect.Entered(m.id, v.place.place.id(), v.id, v.left()));
            }
        }
        return effects;
    }

    @Override
    public Optional<Plan> plan(String id) {
        return project().plan(id);
    }

    @Override
    public Project project() {
        return state.newest().project;
    }

    @Override
    public int projectVersion() {
        return state.newest().version;
    }

    @Override
    public Optional<Plan> planOf(long mission) {
        return Optional.ofNullable(state.missions.get(mission)).map(m -> m.plan.plan);
    }

    @Override
    public Map<String, Value> globals() {
        Map<String, Value> globals = new LinkedHashMap<>();
        for (VariableSpec declared : project().globals()) {
            Value value = state.globals.get(declared.name());
            if (value != null) {
                globals.put(declared.name(), value);
            }
        }
        return globals;
    }

    @Override
    public Vocabulary vocabulary() {
        return state.first.vocabulary;
    }

    @Override
    public List<Decision> decisions() {
        return state.decisions.values().stream().map(d -> d.decision).toList();
    }

    @Override
    public Optional<String> subject(long decision) {
        return Optional.ofNullable(state.decisions.get(decision))
                .filter(open -> open.purpose == OpenDecision.Purpose.DOMAIN)
                .map(open -> open.subject);
    }

    @Override
    public List<InterruptButton> interrupts() {
        List<InterruptButton> buttons = new ArrayList<>();
        for (MissionState m : state.missions.values()) {
            if (m.runs()) {
                addButtons(m, buttons);
            }
        }
        return buttons;
    }

    private static void addButtons(MissionState m, List<InterruptButton> buttons) {
        Map<String, Boolean> names = new LinkedHashMap<>();
        for (CompiledTransition t : m.plan.transitions) {
            for (CompiledInput input : t.inputs) {
                if (input.role == EventRole.INTERRUPT) {
                    names.merge(Interrupts.nameOf(input), t.speaksOfRelevant, Boolean::logicalOr);
                }
            }
        }
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
                if (sent.open && Interrupts.isInterrupt(sent.output.role)) {
                    names.merge(
                            Interrupts.nameOf(sent), sent.output.role == EventRole.PROXY_INTERRUPT, Boolean::logicalOr);
                }
            }
        }
        names.forEach((name, asks) -> buttons.add(new InterruptButton(m.id, name, asks)));
    }

    @Override
    public List<String> proxies() {
        return List.copyOf(state.proxies());
    }

    @Override
    public Optional<Value> variable(long mission, String name) {
        return Optional.ofNullable(VariableScopes.read(state, state.missions.get(mission), name));
    }

    @Override
    public Optional<Value> parameter(long mission, String key) {
        return Optional.ofNullable(state.missions.get(mission)).map(m -> m.parameters.get(key));
    }

    @Override
    public Map<TaskId, String> allocation() {
        Map<TaskId, String> result = new LinkedHashMap<>();
        for (MissionState m : state.missions.values()) {
            for (TaskState task : m.tasks.values()) {
                if (!task.proxy().isEmpty()) {
                    result.put(task.id, task.proxy());
                }
            }
        }
        return result;
    }

    @Override
    public List<TaskId> namesOf(TaskId task) {
        TaskState found = state.task(task);
        if (found == null) {
            return List.of();
        }
        TaskState owned = found.owned();
        List<TaskId> names = new ArrayList<>(List.of(owned.id));
        MissionState owner = state.missions.get(owned.id.mission());
        if (owner != null) {
            addNames(owner, owned, names);
        }
        return names;
    }

    private static void addNames(MissionState owner, TaskState owned, List<TaskId> names) {
        for (MissionState child : owner.children.values()) {
            for (TaskState task : child.tasks.values()) {
                if (task.original != null && task.owned() == owned) {
                    names.add(task.id);
                }
            }
            addNames(child, owned, names);
        }
    }

    @Override
    public Optional<Map<String, Value>> task(TaskId task) {
        TaskState found = state.task(task);
        if (found == null) {
            return Optional.empty();
        }
        Map<String, Value> fields = new LinkedHashMap<>(found.fields);
        if (found.original != null) {
            fields.putAll(found.original.fields);
        }
        return Optional.of(fields);
    }

    @Override
    public boolean awaits(String inputEvent) {
        int type = state.newest().knownTypeId(inputEvent);
        for (MissionState m : state.attentive(type).values()) {
            if (m.runs()) {
                for (CompiledTransition t : m.plan.waitingFor(type)) {
                    if (Routing.isAttentive(m, t)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    @Override
    public Optional<Value> memory(long mission, String key) {
        if (mission == Ids.NONE) {
            return Optional.ofNullable(state.memory.get(key));
        }
        MissionState m = state.missions.get(mission);
        return m == null ? Optional.empty() : Optional.ofNullable(m.memory.get(key));
    }

    @Override
    public Optional<Activation> activation(long id) {
        return Optional.ofNullable(state.sent.get(id)).filter(s -> s.open).map(s -> s.activation);
    }

    @Override
    public List<Activation> openActivations() {
        return state.sent.all().stream()
                .filter(s -> s.open)
                .map(s -> s.activation)
                .sorted(java.util.Comparator.comparingLong(Activation::id))
                .toList();
    }

    @Override
    public List<PendingAnswer> pendingAnswers(long mission) {
        List<PendingAnswer> kept = new ArrayList<>();
        MissionState m = state.missions.get(mission);
        if (m != null) {
            for (TransitionState t : m.transitions) {
                for (TransitionState.Queue queue : t == null ? new TransitionState.Queue[0] : t.queues) {
                    for (PendingOccurrence p = queue.first; p != null; p = p.next) {
                        kept.add(new PendingAnswer(t.transition.id(), p.input.spec.id(), p.occurrence));
                    }
                }
            }
        }
        return kept;
    }

    @Override
    public OptionalLong nextDueMillis() {
        return state.timers.isEmpty()
                ? OptionalLong.empty()
                : OptionalLong.of(state.timers.first().due());
    }

    @Override
    public List<Long> dueMillis() {
        return state.timers.stream().map(RunningTimer::due).distinct().toList();
    }

    @Override
    public EnablingExplanation whyNotEnabled(long mission, String transition) {
        return new EnablingExplainer(state).explain(mission, transition);
    }
}
