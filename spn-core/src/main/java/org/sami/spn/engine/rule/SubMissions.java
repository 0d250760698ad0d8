package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledPlan;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventRole;

/**
 * Starts dynamic instances, takes robots out of them, and brings their ends to the parent.
 *
 * <p>Implements R-LOOK-10, R-INT-7, R-SUB-1, R-SUB-5, R-SUB-8, R-SUB-9.
 */
public final class SubMissions {
    /** Instances within instances that are allowed; a plan that starts itself would go on forever. */
    private static final int DEEPEST = 100;

    private final MissionRules rules;

    public SubMissions(MissionRules rules) {
        this.rules = rules;
    }

    /** Tokens, or nobody, entered a place: dynamic instances start, static ones are joined. */
    public void entered(Visit v) {
        CompiledPlace place = v.place.place;
        if (!place.dynamic.isEmpty()) {
            startDynamic(v);
        }
        for (SharedRun run : v.place.shared) {
            rules.sharedInstances.join(run, v);
        }
    }

    private void startDynamic(Visit v) {
        if (v.place.mission.depth >= DEEPEST) {
            rules.missionEnd.halt(v.place.mission, DEEPEST + " instances within instances");
            return;
        }
        v.instances = new ArrayList<>(1);
        v.place.addInstanceVisit(v);
        List<SubMissionSpec> specs = v.place.place.dynamic;
        for (int i = 0; i < specs.size(); i++) {
            v.instances.add(new Instance(v, v.place, i, v.entered));
        }
        v.setHeld(true);
        for (Instance instance : List.copyOf(v.instances)) {
            MissionState child = make(instance, specs.get(instance.specIndex));
            if (child != null) {
                List<Token> tokens = new ArrayList<>();
                v.entered.forEach(token -> tokens.add(ChildTokens.toChild(child, token)));
                child.tasks.values().stream()
                        .filter(t -> t.original == null && !isMapped(child, t))
                        .forEach(t -> tokens.add(new Token.Task(t.id)));
                child.addWaiting(tokens);
                rules.missionStart.ask(child, rules.missionStart.parametersOf(child.plan));
            }
        }
    }

    /** Makes the mission of an instance; null, with a note, where its plan cannot run. */
    public @Nullable MissionState make(Instance instance, SubMissionSpec spec) {
        MissionState parent = instance.place.mission;
        CompiledPlan plan = parent.plan.project.plan(spec.plan());
        if (plan == null || plan.start == null) {
            rules.note(
                    NoteKind.HANDLER_FAILED,
                    parent.id,
                    "'" + instance.place.place + "' cannot start a sub-mission: there is no plan '" + spec.plan()
                            + "' with a start place");
            return null;
        }
        MissionState child = rules.missionStart.make(plan, plan.plan.title(), parent, instance);
        instance.child = child;
        for (Map.Entry<String, String> mapped : spec.tasks().entrySet()) {
            TaskState original = findTask(parent, mapped.getKey());
            TaskState own = child.tasks.get(mapped.getValue());
            if (original != null) {
                child.addTask(new TaskState(
                        child.taskId(mapped.getValue()),
                        own == null ? original.taskClass : own.taskClass,
                        own == null ? Map.of() : own.fields,
                        original));
            }
        }
        return child;
    }

    private static @Nullable TaskState findTask(MissionState mission, String name) {
        for (MissionState m = mission; m != null; m = m.parent) {
            TaskState task = m.tasks.get(name);
            if (task != null) {
                return task;
            }
        }
        return null;
    }

    private static boolean isMapped(MissionState child, TaskState task) {
        SubMissionSpec spec = child.subMission();
        return spec != null && spec.tasks().containsValue(task.id.name());
    }

    /** Takes what stands in the end places of a mission that ends as its returned tokens, and its return value. */
    public void collect(MissionState m) {
        Instance instance = m.asInstance();
        instance.returnValue = m.returnValue;
        for (PlaceState place : m.places) {
            if (place != null && place.place.isEnd()) {
                for (PlacedToken e : place.inOrder()) {
                    Token token = ChildTokens.toParent(m, e.token);
                    if (token != null) {
                        instance.returned.add(token);
                    }
                }
            }
        }
    }

    /** A child ended, or was completed from outside. */
    public void completed(Instance instance) {
        if (instance.isShared()) {
            rules.sharedInstances.ended(instance);
            return;
        }
        instance.status = Instance.Status.COMPLETE;
        List<Token> missing = new ArrayList<>(instance.starting);
        instance.returned.forEach(missing::remove);
        if (!missing.isEmpty()) {
            rules.note(
                    NoteKind.NOT_RETURNED,
                    instance.place.mission.id,
                    "From the sub-mission on '" + instance.place.place + "' did not come back: "
                            + TokenWords.of(missing));
        }
        complete(instance.startedBy());
    }

    /** Looks at the place again if the visit is complete now. */
    public void complete(Visit v) {
        if (!v.complete() || v.ended) {
            return;
        }
        v.setHeld(false);
        for (Instance i : v.instances) {
            post(new Return(i, List.of(), i.returnValue));
        }
        rules.work.entered(v.place);
    }

    /** Tells a return's value to those who check it, once the work list is empty. */
    public void post(Return r) {
        for (CompiledTransition t : r.place().place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.checks(r.value, r.instance.plan())) {
                    rules.post(() -> rules.pendings.tell(r));
                    return;
                }
            }
        }
    }

    /** A child was aborted: that is an outcome of its own. */
    public void aborted(Instance instance) {
        instance.status = Instance.Status.ABORTED;
        instance.returned.clear();
        MissionState m = instance.place.mission;
        if (instance.isShared()) {
            rules.sharedInstances.gone(instance);
        }
        rules.post(() -> postAborted(m, instance));
    }

    private void postAborted(MissionState m, Instance instance) {
        if (!m.runs() || (instance.visit != null && instance.visit.ended)) {
            return;
        }
        List<String> robots = new ArrayList<>();
        List<TaskId> tasks = new ArrayList<>();
        for (Token token : new LinkedHashSet<>(instance.starting)) {
            if (token instanceof Token.Proxy proxy) {
                robots.add(proxy.proxy());
            } else if (token instanceof Token.Task task) {
                tasks.add(task.task());
            }
        }
        boolean received = false;
        for (CompiledTransition t : instance.place.place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.role == EventRole.SUB_MISSION_ABORTED) {
                    Occurrence o = new Occurrence(input.spec.type(), m.id, Ids.NONE, robots, tasks, Map.of());
                    TransitionState state = m.transition(t.index);
                    List<Token> names = PendingOccurrences.names(o, input.role);
                    if (!names.isEmpty()
                            && names.stream()
                                    .allMatch(n -> rules.enabling.wantsAbsence(t, instance.place.place, n, true))) {
                        continue;
                    }
                    rules.pendings.add(state, rules.pendings.make(state, input, o, names, null, instance.visit));
                    received = true;
                }
            }
        }
        if (!received) {
            rules.questions.openAborted(instance, TokenWords.of(instance.starting));
        }
    }

    /** The operator, or autonomy, decided about an aborted child: return its tokens to the plan, or keep them where they are. */
    public void decided(Instance instance, boolean giveBack) {
        if (!giveBack || instance.status != Instance.Status.ABORTED) {
            return;
        }
        if (instance.isShared()) {
            rules.sharedInstances.giveBack(instance);
            return;
        }
        instance.status = Instance.Status.COMPLETE;
        instance.returned.addAll(instance.starting);
        complete(instance.startedBy());
    }

    /**
     * A token is taken out of a dynamic instance and its descendants, unless a copy of it stays in the visit; with its last
     * starting token the instance is aborted.
     */
    public void withdraw(Instance instance, Token token) {
        if (!instance.starting.remove(token) || instance.child == null) {
            return;
        }
        if (PlacedToken.kindOf(token) != PlacedToken.GENERIC
                && !instance.startedBy().has(token)) {
            rules.robotRemoval.takeOut(instance.child, ChildTokens.toChild(instance.child, token));
        }
        if (instance.starting.isEmpty()) {
            instance.status = Instance.Status.ABORTED;
            rules.missionEnd.stopSilently(instance.child, Outcome.ABORTED);
        }
    }

    /** The visit of an instance ended while it may run. */
    public void visitEnded(Instance instance) {
        if (instance.child != null) {
            instance.status = Instance.Status.ABORTED;
            rules.missionEnd.stopSilently(instance.child, Outcome.ABORTED);
        }
        for (OpenDecision d : rules.state().decisionsOf(instance.place.mission)) {
            if (d.instance == instance) {
                rules.questions.close(d);
            }
        }
    }
}
