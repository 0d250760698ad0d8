package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** A running plan: a root mission or a sub-mission instance. What it does not use, it does not allocate. */
final class Mission {
    final long id;
    final CompiledPlan plan;
    final String name;
    /** The instance of the parent that this mission is; null for a root. */
    final Instance instance;

    final Mission parent;
    final Mission root;
    final int depth;
    MissionStatus status = MissionStatus.WAITING;
    boolean ended;
    /** What was asked of it and is its outcome, however it ends: aborted or completed; null while neither was. */
    Outcome asked;

    final PlaceState[] places;
    final TransitionState[] transitions;
    Map<String, Value> variables = Map.of();
    Map<String, TaskState> tasks = Map.of();
    Map<String, Value> memory = Map.of();
    Map<String, Value> parameters = Map.of();
    Map<Long, Mission> children = Map.of();
    Map<Long, OpenDecision> decisions = Map.of();
    /** Visits that wait for the parameters: tokens that entered, in order; for a root none. */
    List<List<Token>> waiting = List.of();

    String returnValue = "";
    int generatedTasks;
    /** Firings since the chain began, and which chain that is. */
    int chain;

    long chainNumber;
    private Visit firstVisit;
    private Visit lastVisit;

    Mission(long id, CompiledPlan plan, String name, Mission parent, Instance instance) {
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

    boolean runs() {
        return !ended && status == MissionStatus.RUNNING;
    }

    PlaceState place(int index) {
        PlaceState p = places[index];
        if (p == null) {
            p = new PlaceState(this, plan.places[index]);
            places[index] = p;
        }
        return p;
    }

    TransitionState transition(int index) {
        TransitionState t = transitions[index];
        if (t == null) {
            t = new TransitionState(this, plan.transitions[index]);
            transitions[index] = t;
        }
        return t;
    }

    void addVisit(Visit v) {
        v.previous = lastVisit;
        if (lastVisit == null) {
            firstVisit = v;
        } else {
            lastVisit.next = v;
        }
        lastVisit = v;
    }

    void removeVisit(Visit v) {
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
    Visit firstVisit() {
        return firstVisit;
    }

    void addWaiting(List<Token> tokens) {
        if (waiting.isEmpty()) {
            waiting = new ArrayList<>();
        }
        waiting.add(new ArrayList<>(tokens));
    }

    void addChild(Mission child) {
        if (children.isEmpty()) {
            children = new LinkedHashMap<>();
        }
        children.put(child.id, child);
    }

    void addDecision(OpenDecision decision) {
        if (decisions.isEmpty()) {
            decisions = new LinkedHashMap<>();
        }
        decisions.put(decision.decision.id(), decision);
    }

    void addTask(TaskState task) {
        if (tasks.isEmpty()) {
            tasks = new LinkedHashMap<>();
        }
        tasks.put(task.id.name(), task);
    }

    void setVariable(String variable, Value value) {
        if (variables.isEmpty()) {
            variables = new LinkedHashMap<>();
        }
        variables.put(variable, value);
    }

    void remember(String key, Value value) {
        if (memory.isEmpty()) {
            memory = new LinkedHashMap<>();
        }
        memory.put(key, value);
    }

    TaskId taskId(String task) {
        return new TaskId(id, task);
    }
}
