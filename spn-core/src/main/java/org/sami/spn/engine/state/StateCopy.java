package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.value.Value;

/**
 * Copies a whole state, object by object: what a step changes is made again, what is immutable is shared. Makes what decoding
 * the state's bytes would make; between two steps only. Used once.
 */
public final class StateCopy {
    private final NetState from;
    private final NetState to;
    /** The copies of visits that were asked for, with those of their missions; and of visits that have ended. */
    private Map<Visit, Visit> copies = Map.of();
    /** Missions whose visits are all among them. Most copies ask for none. */
    private Set<MissionState> indexed = Set.of();
    /** Returns that pending occurrences tell; a visit's instance has its return in no list. Looked up only, never gone through. */
    private Map<Return, Return> returns = Map.of();

    /** The copy of the mission that was asked for last: mostly the next one is of it too. */
    private @Nullable MissionState copiedMission;

    private StateCopy(NetState from) {
        this.from = from;
        this.to = new NetState(from);
    }

    /** An independent state that behaves in the same way for all further inputs. */
    public static NetState of(NetState state) {
        return new StateCopy(state).copy();
    }

    private NetState copy() {
        for (MissionState m : from.missions.values()) { // a parent stands before its children
            copy(m);
        }
        for (OpenDecision d : from.decisions.values()) {
            copy(d);
        }
        for (RunningTimer timer : from.timers) {
            add(timer);
        }
        return to;
    }

    private void copy(MissionState old) {
        MissionState parent = old.parent == null ? null : to.missions.get(old.parent.id);
        Instance instance = old.instance == null ? null : instance(old.instance);
        MissionState m = new MissionState(old.id, old.plan, old.name, parent, instance);
        if (instance != null) {
            instance.child = m;
        }
        m.status = old.status;
        m.asked = old.asked;
        m.variables = changeable(old.variables);
        m.memory = changeable(old.memory);
        m.parameters = old.parameters; // replaced, never changed
        m.returnValue = old.returnValue;
        m.generatedTasks = old.generatedTasks;
        m.startedAt = old.startedAt;
        m.firings = old.firings;
        to.add(m);
        for (TaskState task : old.tasks.values()) {
            m.addTask(task.copy(task.original == null ? null : to.task(task.original.id)));
        }
        old.waiting.forEach(m::addWaiting);
        copyShared(old, m);
        for (Visit v = old.firstVisit(); v != null; v = v.next) {
            copy(v, m.place(v.place.place.index));
        }
        copyEndedVisits(old, m);
        copyPending(old, m);
    }

    private static Map<String, Value> changeable(Map<String, Value> values) {
        return values.isEmpty() ? Map.of() : new LinkedHashMap<>(values);
    }

    private void copyShared(MissionState old, MissionState m) {
        if (!old.plan.hasShared) {
            return;
        }
        for (PlaceState place : old.places) {
            if (place == null || place.shared.length == 0) {
                continue;
            }
            PlaceState copy = m.place(place.place.index);
            copy.shared = new SharedRun[place.shared.length];
            for (int i = 0; i < copy.shared.length; i++) {
                SharedRun run = place.shared[i];
                copy.shared[i] = new SharedRun(copy(run.instance, null, copy));
                for (Return r : run.returns) {
                    Return told = new Return(copy.shared[i].instance, r.tokens, r.value);
                    keep(r, told);
                    copy.shared[i].returns.add(told);
                }
            }
        }
    }

    /** The copy of a visit; of one that has ended it is made when first asked for. */
    private Visit visit(Visit wanted) {
        if (!indexed.contains(wanted.place.mission)) {
            indexed = indexed.isEmpty() ? new HashSet<>() : indexed;
            indexed.add(wanted.place.mission);
            Visit copy = place(wanted.place).mission.firstVisit();
            for (Visit v = wanted.place.mission.firstVisit(); v != null && copy != null; v = v.next) {
                keep(v, copy);
                copy = copy.next;
            }
        }
        Visit copy = copies.get(wanted);
        return copy != null ? copy : copy(wanted, place(wanted.place));
    }

    private void keep(Visit old, Visit copy) {
        copies = copies.isEmpty() ? new HashMap<>() : copies;
        copies.put(old, copy);
    }

    private void keep(Return old, Return copy) {
        returns = returns.isEmpty() ? new HashMap<>() : returns;
        returns.put(old, copy);
    }

    private Visit copy(Visit old, PlaceState place) {
        MissionState m = place.mission;
        Visit v = new Visit(old.id, place, old.entered);
        v.ended = old.ended;
        v.held = old.held;
        v.used = old.used;
        v.remembered = old.remembered;
        if (old.ended) {
            keep(old, v);
        }
        if (!old.ended && old.hasInstances()) {
            v.instances = new ArrayList<>(old.instances.size());
            place.addInstanceVisit(v);
            for (Instance instance : old.instances) {
                v.instances.add(copy(instance, v, place));
            }
        }
        for (SentActivation s = old.firstSent(); s != null; s = s.next()) {
            SentActivation sent = s.copy(v);
            sent.open = !old.ended;
            v.addSent(sent);
            if (!old.ended || old.remembered > 0) {
                to.sent.put(sent.activation.id(), sent);
            }
        }
        if (!old.ended) {
            m.addVisit(v);
            if (v.byNobody) {
                place.addByNobody(v);
            }
            v.enterAs(old);
        }
        return v;
    }

    private static Instance copy(Instance old, @Nullable Visit visit, PlaceState place) {
        Instance i = new Instance(visit, place, old.specIndex, old.starting);
        i.status = old.status;
        i.returned.addAll(old.returned);
        i.returnValue = old.returnValue;
        return i;
    }

    private void copyEndedVisits(MissionState old, MissionState m) {
        for (PlaceState place : old.places) {
            if (place != null && place.lastVisits != null && !place.lastVisits.isEmpty()) {
                PlaceState copy = m.place(place.place.index);
                copy.lastVisits = new LinkedHashMap<>();
                place.lastVisits.forEach((token, v) -> copy.lastVisits.put(token, visit(v)));
            }
        }
    }

    private void copyPending(MissionState old, MissionState m) {
        for (TransitionState t : old.transitions) {
            if (t == null || t.pending == 0) {
                continue;
            }
            TransitionState copy = m.transition(t.transition.index);
            for (TransitionState.Queue q : t.queues) {
                for (PendingOccurrence p = q.first; p != null; p = p.next) {
                    copy.add(copy(p));
                }
            }
        }
    }

    private PendingOccurrence copy(PendingOccurrence old) {
        PendingOccurrence p = old.told != null
                ? new PendingOccurrence(old.occurrence, old.input, told(old.told))
                : new PendingOccurrence(
                        old.occurrence, old.input, sent(old.answered), old.bound == null ? null : visit(old.bound));
        p.names = new NamedToken[old.names.length];
        for (int i = 0; i < p.names.length; i++) {
            p.names[i] = old.names[i].copy();
        }
        p.namesLeft = old.namesLeft;
        return p;
    }

    private Return told(Return old) {
        Return made = returns.get(old);
        if (made == null) {
            made = new Return(instance(old.instance), old.tokens, old.value);
            keep(old, made);
        }
        return made;
    }

    private Instance instance(Instance old) {
        return old.isShared()
                ? place(old.place).shared[old.specIndex].instance
                : visit(old.startedBy()).instances.get(old.specIndex);
    }

    private PlaceState place(PlaceState old) {
        if (copiedMission == null || copiedMission.id != old.mission.id) {
            copiedMission = Objects.requireNonNull(to.missions.get(old.mission.id), "a mission that was copied");
        }
        return copiedMission.place(old.place.index);
    }

    private @Nullable SentActivation sent(@Nullable SentActivation old) {
        if (old == null) {
            return null;
        }
        SentActivation copy = visit(old.visit).firstSent();
        for (SentActivation s = old.visit.firstSent(); s != old && s != null && copy != null; s = s.next()) {
            copy = copy.next();
        }
        return Objects.requireNonNull(copy, "an activation that was copied");
    }

    private void copy(OpenDecision old) {
        MissionState m = old.mission == null ? null : to.missions.get(old.mission.id);
        SentActivation sent = sent(old.sent);
        Instance instance = old.instance == null ? null : instance(old.instance);
        OpenDecision d = new OpenDecision(old.decision, old.purpose, m, sent, instance, old.subject);
        to.decisions.put(d.decision.id(), d);
        if (m != null) {
            m.addDecision(d.decision.id());
        }
        if (sent != null && d.purpose == OpenDecision.Purpose.ACTIVATION) {
            sent.decision = d.decision.id();
        }
    }

    private void add(RunningTimer timer) {
        to.timers.add(timer);
        if (timer.isDeadline()) {
            to.decision(timer.decision()).deadline = timer;
        } else {
            to.activationOf(timer).add(timer);
        }
    }
}
