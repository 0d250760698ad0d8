package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledPlan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** A running plan: a root mission or a sub-mission instance. What it does not use, it does not allocate. */
public final class MissionState {
    /** A time that is not known. */
    public static final long UNKNOWN = -1;

    public final long id;
    public final CompiledPlan plan;
    public final String name;
    /** The instance of the parent that this mission is; null for a root. */
    public final @Nullable Instance instance;

    public final @Nullable MissionState parent;
    public final MissionState root;
    public final int depth;
    public MissionStatus status = MissionStatus.WAITING;
    public boolean ended;
    /** What was asked of it and is its outcome, however it ends: aborted or completed; null while neither was. */
    public @Nullable Outcome asked;

    public final PlaceState[] places;
    public final TransitionState[] transitions;
    public Map<String, Value> variables = Map.of();
    public Map<String, TaskState> tasks = Map.of();
    public Map<String, Value> memory = Map.of();
    public Map<String, Value> parameters = Map.of();
    public Map<Long, MissionState> children = Map.of();
    /** Ids of its open decisions, in the order in which they were asked. */
    public Set<Long> decisions = Set.of();

    /** Visits that wait for the parameters: tokens that entered, in order; for a root none. */
    public List<List<Token>> waiting = List.of();

    public String returnValue = "";
    public int generatedTasks;
    /** Firings since the chain began, and which chain that is. */
    public int chain;

    public long chainNumber;
    /** When it started, on the session's clock; {@link #UNKNOWN} in a state that an earlier version wrote. */
    public long startedAt = UNKNOWN;

    public long firings;
    private @Nullable Visit firstVisit;
    private @Nullable Visit lastVisit;

    public MissionState(
            long id, CompiledPlan plan, String name, @Nullable MissionState parent, @Nullable Instance instance) {
        this.id = id;
        this.plan = plan;
        this.name = name;
        this.parent = parent;
        this.instance = instance;
        this.root = parent == null ? this : parent.root;
        this.depth = parent == null ? 0 : parent.depth + 1;
        this.places = new PlaceState[plan.places.length];
        this.transitions = new TransitionState[plan.transitions.length];
    }

    /** The instance of the parent that this mission is; not for a root. */
    public Instance asInstance() {
        return Objects.requireNonNull(instance, "the instance of a root mission");
    }

    public boolean runs() {
        return !ended && status == MissionStatus.RUNNING;
    }

    public PlaceState place(int index) {
        PlaceState p = places[index];
        if (p == null) {
            p = new PlaceState(this, plan.places[index]);
            places[index] = p;
        }
        return p;
    }

    public TransitionState transition(int index) {
        TransitionState t = transitions[index];
        if (t == null) {
            t = new TransitionState(this, plan.transitions[index]);
            transitions[index] = t;
        }
        return t;
    }

    public void addVisit(Visit v) {
        v.previous = lastVisit;
        if (lastVisit == null) {
            firstVisit = v;
        } else {
            lastVisit.next = v;
        }
        lastVisit = v;
    }

    public void removeVisit(Visit v) {
        if (v.previous == null) {
            firstVisit = v.next;
        } else {
            v.previous.next = v.next;
        }
        if (v.next == null) {
            lastVisit = v.previous;
        } else {
            v.next.previous = v.previous;
        }
        v.previous = null;
        v.next = null;
    }

    /** The visit that began first of those that have not ended, or null. */
    public @Nullable Visit firstVisit() {
        return firstVisit;
    }

    public void addWaiting(List<Token> tokens) {
        if (waiting.isEmpty()) {
            waiting = new ArrayList<>();
        }
        waiting.add(new ArrayList<>(tokens));
    }

    public void addChild(MissionState child) {
        if (children.isEmpty()) {
            children = new LinkedHashMap<>();
        }
        children.put(child.id, child);
    }

    public void addDecision(long decision) {
        if (decisions.isEmpty()) {
            decisions = new LinkedHashSet<>();
        }
        decisions.add(decision);
    }

    public void addTask(TaskState task) {
        if (tasks.isEmpty()) {
            tasks = new LinkedHashMap<>();
        }
        tasks.put(task.id.name(), task);
    }

    public void setVariable(String variable, Value value) {
        if (variables.isEmpty()) {
            variables = new LinkedHashMap<>();
        }
        variables.put(variable, value);
    }

    public void remember(String key, Value value) {
        if (memory.isEmpty()) {
            memory = new LinkedHashMap<>();
        }
        memory.put(key, value);
    }

    public TaskId taskId(String task) {
        return new TaskId(id, task);
    }

    /** The specification by which it runs in its parent, null for a root. */
    public @Nullable SubMissionSpec subMission() {
        if (instance == null) {
            return null;
        }
        CompiledPlace place = instance.place.place;
        return (instance.isShared() ? place.shared : place.dynamic).get(instance.specIndex);
    }
}
