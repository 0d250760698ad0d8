package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledPlan;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;

/** Reads what {@link StateEncoder} wrote. */
public final class StateDecoder {
    private final ProtocolDecoder in;
    private final Map<Long, Visit> visits = new HashMap<>();
    private final Map<Long, SentActivation> sent = new HashMap<>();
    private final Map<Instance, Return> returnsOfVisits = new HashMap<>();
    private final Map<Integer, CompiledProject> projects = new HashMap<>();
    private final NetState state;
    private int version;

    /**
     * Bytes of a state.
     *
     * @param first the project of the engine
     */
    public StateDecoder(byte[] bytes, CompiledProject first) {
        this.in = new ProtocolDecoder(bytes);
        this.state = new NetState(first);
        projects.put(first.version, first);
    }

    /**
     * Reads the state.
     *
     * @param loaded finds the projects that the session loaded
     */
    public NetState read(LoadedProjects loaded) {
        if (in.integer() != StateEncoder.MAGIC) {
            throw new IllegalArgumentException("This is not an engine's state");
        }
        version = in.integer();
        if (version < 1 || version > StateEncoder.VERSION) {
            throw new IllegalArgumentException(
                    "The state is of version " + version + ", not of 1 to " + StateEncoder.VERSION);
        }
        for (int i = hasLoaded() ? in.integer() : 0; i > 0; i--) {
            CompiledProject project = loaded.compiled(state.newest(), in.integer(), in.text());
            projects.put(project.version, project);
            state.load(project);
        }
        state.now = in.number();
        state.lastMission = in.number();
        state.lastActivation = in.number();
        state.lastVisit = in.number();
        state.lastDecision = in.number();
        state.lastTimer = in.number();
        state.firings = in.number();
        state.stamp = in.number();
        state.addProxies(in.texts());
        state.globals.replace(in.values());
        if (version > 1) {
            state.memory.replace(in.values()); // before, there was none
        }
        for (int i = in.integer(); i > 0; i--) {
            state.discardedNews.put(in.text(), in.number());
        }
        for (int i = in.integer(); i > 0; i--) {
            mission();
        }
        for (int i = in.integer(); i > 0; i--) {
            decision();
        }
        for (int i = in.integer(); i > 0; i--) {
            timer();
        }
        for (int i = version > 2 ? in.integer() : 0; i > 0; i--) {
            there(state.missions.get(in.number()), "mission").asked = Outcome.valueOf(in.text());
        }
        if (version >= StateEncoder.WITH_TIMES) {
            for (MissionState m : state.missions.values()) {
                m.startedAt = in.number();
                m.firings = in.number();
            }
        }
        return state;
    }

    /** Whether the state names projects that were loaded. */
    private boolean hasLoaded() {
        return version == 4 || version == StateEncoder.VERSION;
    }

    /** Whether unused returns of static instances still have to be posted: before version 3 one's value replaced the one before. */
    public boolean omitsUsedReturns() {
        return version < 3;
    }

    private void mission() {
        long id = in.number();
        String planId = in.text();
        CompiledProject project = projects.get(hasLoaded() ? in.integer() : state.first.version);
        CompiledPlan plan = project == null ? null : project.plan(planId);
        if (plan == null) {
            throw new IllegalArgumentException("The state speaks of the plan '" + planId + "', which is not there");
        }
        String name = in.text();
        MissionState parent = state.missions.get(in.number());
        Instance instance = parent == null ? null : instanceReference(parent);
        MissionState m = new MissionState(id, plan, name, parent, instance);
        if (instance != null) {
            instance.child = m;
        }
        m.status = MissionStatus.valueOf(in.text());
        m.variables = in.values();
        m.memory = in.values();
        m.parameters = in.values();
        m.returnValue = in.text();
        m.generatedTasks = in.integer();
        state.add(m);
        for (int i = in.integer(); i > 0; i--) {
            task(m);
        }
        for (int i = in.integer(); i > 0; i--) {
            m.addWaiting(in.tokens());
        }
        shared(m);
        visits(m);
        marking(m);
        pending(m);
    }

    private void task(MissionState m) {
        TaskId id = (TaskId) in.value();
        String taskClass = in.text();
        Map<String, Value> fields = in.values();
        if (in.flag()) {
            m.addTask(new TaskState(id, taskClass, fields, state.task((TaskId) in.value())));
        } else {
            TaskState task = new TaskState(id, taskClass, fields, null);
            task.allocate(in.text());
            m.addTask(task);
        }
    }

    private Instance instanceReference(MissionState parent) {
        PlaceState place = parent.place(in.integer());
        long visit = in.number();
        int spec = in.integer();
        return visit == Ids.NONE
                ? place.shared[spec].instance
                : there(visits.get(visit), "visit").instances.get(spec);
    }

    private Instance instance(@Nullable Visit visit, PlaceState place, int spec) {
        Instance.Status status = Instance.Status.valueOf(in.text());
        Instance i = new Instance(visit, place, spec, in.tokens());
        i.status = status;
        i.returned.addAll(in.tokens());
        i.returnValue = in.text();
        return i;
    }

    private void shared(MissionState m) {
        for (CompiledPlace place : m.plan.places) {
            if (place.shared.isEmpty()) {
                continue;
            }
            PlaceState state = m.place(place.index);
            state.shared = new SharedRun[in.integer()];
            for (int i = 0; i < state.shared.length; i++) {
                state.shared[i] = new SharedRun(instance(null, state, i));
                for (int r = in.integer(); r > 0; r--) {
                    List<Token> tokens = in.tokens();
                    state.shared[i].returns.add(new Return(state.shared[i].instance, tokens, in.text()));
                }
            }
        }
    }

    private void visits(MissionState m) {
        for (int i = in.integer(); i > 0; i--) {
            visit(m);
        }
        for (int p = 0; p < m.places.length; p++) {
            int size = in.integer();
            if (size > 0) {
                Map<Token, Visit> last = new LinkedHashMap<>();
                for (int i = 0; i < size; i++) {
                    last.put(in.token(), there(visits.get(in.number()), "visit"));
                }
                m.place(p).lastVisits = last;
            }
        }
    }

    private void visit(MissionState m) {
        long id = in.number();
        PlaceState place = m.place(in.integer());
        boolean ended = in.flag();
        boolean held = in.flag();
        boolean used = in.flag();
        int remembered = in.integer();
        Visit v = new Visit(id, place, List.copyOf(in.tokens()));
        v.ended = ended;
        v.held = held;
        v.used = used;
        v.remembered = remembered;
        visits.put(id, v);
        int instances = in.integer();
        if (instances > 0) {
            v.instances = new ArrayList<>();
            place.addInstanceVisit(v);
            for (int i = 0; i < instances; i++) {
                v.instances.add(instance(v, place, i));
            }
        }
        for (int i = in.integer(); i > 0; i--) {
            CompiledOutput output = place.place.outputs[in.integer()];
            Activation activation = in.activation();
            SentActivation s = new SentActivation(activation, v, output);
            s.open = !ended;
            v.addSent(s);
            sent.put(activation.id(), s);
            if (!ended || remembered > 0) {
                state.sent.put(activation.id(), s);
            }
        }
        if (!ended) {
            m.addVisit(v);
            if (v.byNobody) {
                place.addByNobody(v);
            }
        }
    }

    private void marking(MissionState m) {
        for (int p = 0; p < m.places.length; p++) {
            StandingTokens standing = new StandingTokens();
            for (int i = in.integer(); i > 0; i--) {
                Token token = in.token();
                long order = in.number();
                standing.add(there(visits.get(in.number()), "visit"), token, order);
            }
            standing.enter();
        }
    }

    private void pending(MissionState m) {
        for (CompiledTransition t : m.plan.transitions) {
            for (int i = in.integer(); i > 0; i--) {
                pending(m.transition(t.index));
            }
        }
    }

    private void pending(TransitionState t) {
        CompiledInput input = t.transition.inputs[in.integer()];
        Occurrence occurrence = in.occurrence();
        SentActivation answered = sent.get(in.number());
        Visit bound = visits.get(in.number());
        Return told = version > 2 ? told(t.mission) : toldBefore(input, bound);
        PendingOccurrence p = told == null
                ? new PendingOccurrence(occurrence, input, answered, bound)
                : new PendingOccurrence(occurrence, input, told);
        p.names = new NamedToken[in.integer()];
        for (int i = 0; i < p.names.length; i++) {
            NamedToken n = new NamedToken(in.token());
            n.tokens = in.tokens().toArray(Token[]::new);
            n.struck = in.flag();
            n.stood = in.flag();
            p.names[i] = n;
            p.namesLeft += n.struck ? 0 : 1;
        }
        if (version > 2 || input.role != EventRole.CHECK_RETURN || told != null) {
            t.add(p);
        }
    }

    private @Nullable Return told(MissionState m) {
        if (!in.flag()) {
            return null;
        }
        Instance instance = instanceReference(m);
        if (instance.isShared()) {
            return instance.place.shared[instance.specIndex].returns.get(in.integer());
        }
        return returnOf(instance);
    }

    private Return returnOf(Instance instance) {
        return returnsOfVisits.computeIfAbsent(instance, i -> new Return(i, List.of(), i.returnValue));
    }

    /** Before version 3 an occurrence with the value of a visit's instance named only the visit. */
    private @Nullable Return toldBefore(CompiledInput input, @Nullable Visit bound) {
        return bound == null
                ? null
                : bound.instances.stream()
                        .filter(i -> input.checks(i.returnValue, i.plan()))
                        .findFirst()
                        .map(this::returnOf)
                        .orElse(null);
    }

    private void decision() {
        Decision decision = in.decision();
        OpenDecision.Purpose purpose = OpenDecision.Purpose.valueOf(in.text());
        MissionState m = state.missions.get(in.number());
        SentActivation asking = sent.get(in.number());
        Instance instance = in.flag() ? instanceReference(there(m, "mission")) : null;
        OpenDecision d = new OpenDecision(decision, purpose, m, asking, instance, in.text());
        state.decisions.put(decision.id(), d);
        if (purpose != OpenDecision.Purpose.DOMAIN) {
            there(m, "mission").addDecision(decision.id());
        }
        if (asking != null && purpose == OpenDecision.Purpose.ACTIVATION) {
            asking.decision = decision.id();
        }
    }

    /** What the state refers to, which stands before it in the bytes. */
    private static <T> T there(@Nullable T found, String what) {
        if (found == null) {
            throw new IllegalArgumentException("The state names a " + what + " that is not there");
        }
        return found;
    }

    private void timer() {
        long due = in.number();
        long id = in.number();
        SentActivation asking = sent.get(in.number());
        Token token = in.token();
        OpenDecision decision = state.decisions.get(in.number());
        RunningTimer timer = new RunningTimer(
                due,
                id,
                asking == null ? Ids.NONE : asking.activation.id(),
                token,
                decision == null ? Ids.NONE : decision.decision.id());
        state.timers.add(timer);
        if (asking != null) {
            asking.add(timer);
        }
        if (decision != null) {
            decision.deadline = timer;
        }
    }
}
