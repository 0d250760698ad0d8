package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.EventRole;

/** Writes what one mission means; its parent was written before it. */
final class CanonicalMission {
    private static final TransitionState.Queue[] NO_QUEUES = {};
    private static final Comparator<Visit> BY_PLACE =
            Comparator.comparingInt((Visit v) -> v.place.place.index).thenComparingLong(v -> v.id);

    private final NetState state;
    private final CanonicalNumbers numbers;
    private final ProtocolEncoder out;

    CanonicalMission(NetState state, CanonicalNumbers numbers, ProtocolEncoder out) {
        this.state = state;
        this.numbers = numbers;
        this.out = out;
    }

    void write(MissionState m) {
        out.text(m.plan.plan.id());
        out.text(m.name);
        out.flag(m.parent != null);
        if (m.parent != null) {
            out.number(numbers.mission(m.parent.id));
            reference(m.asInstance());
        }
        out.text(m.status.name());
        out.text(m.asked == null ? "" : m.asked.name());
        out.values(m.variables);
        out.values(m.memory);
        out.values(m.parameters);
        out.text(m.returnValue);
        out.integer(m.generatedTasks);
        out.integer(m.tasks.size());
        m.tasks.values().forEach(this::task);
        out.integer(m.waiting.size());
        m.waiting.forEach(out::tokens);
        visits(m);
        for (PlaceState place : m.places) {
            place(place);
        }
        interrupts(m);
        for (TransitionState t : m.transitions) {
            pending(t);
        }
        decisions(m);
    }

    private void task(TaskState t) {
        out.task(t.id);
        out.text(t.taskClass);
        out.values(t.fields);
        out.flag(t.original != null);
        if (t.original != null) {
            out.task(t.original.id);
        } else {
            out.text(t.proxy());
        }
    }

    private void reference(Instance i) {
        out.integer(i.place.place.index);
        out.number(numbers.visit(i.visit));
        out.integer(i.specIndex);
    }

    private void instance(Instance i) {
        out.text(i.status.name());
        out.tokens(i.starting);
        out.tokens(i.returned);
        out.text(i.returnValue);
    }

    /** Visits that go on, and ended ones of which something still speaks; by place, a place's in the order in which they began. */
    private void visits(MissionState m) {
        List<Visit> visits = new ArrayList<>();
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            visits.add(v);
        }
        for (PlaceState place : m.places) {
            if (place != null && place.lastVisits != null) {
                visits.addAll(place.lastVisits.values()); // they have ended
            }
        }
        for (TransitionState t : m.transitions) {
            for (TransitionState.Queue q : t == null || t.pending == 0 ? NO_QUEUES : t.queues) {
                for (PendingOccurrence p = q.first; p != null; p = p.next) {
                    if (p.visit() != null) {
                        visits.add(p.visit());
                    }
                }
            }
        }
        visits.sort(BY_PLACE);
        List<Visit> once = withoutCopies(visits);
        out.integer(once.size());
        once.forEach(this::visit);
    }

    /** Copies lie next to one another. */
    private static List<Visit> withoutCopies(List<Visit> sorted) {
        List<Visit> once = new ArrayList<>(sorted.size());
        Visit last = null;
        for (Visit v : sorted) {
            if (v != last) {
                once.add(v);
            }
            last = v;
        }
        return once;
    }

    private void visit(Visit v) {
        out.integer(v.place.place.index);
        out.number(numbers.visit(v));
        out.flag(v.ended);
        out.flag(v.held);
        out.flag(v.used);
        out.tokens(v.entered);
        List<Instance> instances = v.ended ? List.of() : v.instances;
        out.integer(instances.size());
        instances.forEach(this::instance);
        out.integer(v.countSent());
        for (SentActivation s = v.firstSent(); s != null; s = s.next()) {
            out.number(numbers.activation(s.activation.id()));
            out.integer(v.place.place.indexOf(s.output));
            out.content(s.activation, v.entered);
            out.flag(s.decision != Ids.NONE);
            if (s.decision != Ids.NONE) {
                out.content(state.decision(s.decision).decision);
            }
        }
    }

    private void place(@Nullable PlaceState place) {
        if (place == null) {
            out.integer(0);
            out.integer(0);
            out.integer(0);
            return;
        }
        out.integer(place.total());
        place.forEach((token, visit) -> {
            out.token(token);
            out.number(numbers.visit(visit));
        });
        SharedRun[] shared = place.shared;
        out.integer(shared.length);
        for (SharedRun run : shared) {
            instance(run.instance);
            out.integer(run.returns.size());
            run.returns.forEach(r -> {
                out.tokens(r.tokens);
                out.text(r.value);
            });
        }
        if (place.lastVisits == null || place.lastVisits.isEmpty()) {
            out.integer(0);
            return;
        }
        out.integer(place.lastVisits.size());
        place.lastVisits.entrySet().stream()
                .sorted(Map.Entry.comparingByKey(byMeaning()))
                .forEach(e -> {
                    out.token(e.getKey());
                    out.number(numbers.visit(e.getValue()));
                });
    }

    private Comparator<Token> byMeaning() {
        return Comparator.comparingInt(PlacedToken::kindOf)
                .thenComparingLong(t -> t instanceof Token.Task task
                        ? numbers.mission(task.task().mission())
                        : 0)
                .thenComparing(t -> t instanceof Token.Task task ? task.task().name() : t.toString());
    }

    /** Open interrupt places are pressed in the order in which they were entered, in all places. */
    private void interrupts(MissionState m) {
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            for (SentActivation s = v.firstSent(); s != null; s = s.next()) {
                EventRole role = s.output.role;
                if (s.open && (role == EventRole.GENERAL_INTERRUPT || role == EventRole.PROXY_INTERRUPT)) {
                    out.number(numbers.activation(s.activation.id()));
                }
            }
        }
    }

    private void pending(TransitionState t) {
        out.integer(t == null ? 0 : t.pending);
        if (t == null || t.pending == 0) {
            return;
        }
        for (TransitionState.Queue q : t.queues) {
            out.integer(q.size);
            for (PendingOccurrence p = q.first; p != null; p = p.next) {
                pending(p);
            }
        }
    }

    private void pending(PendingOccurrence p) {
        Occurrence o = p.occurrence;
        out.text(o.type());
        out.number(numbers.mission(o.mission()));
        out.number(numbers.activation(o.activation()));
        out.texts(o.proxies());
        out.valueList(o.tasks());
        out.values(o.values());
        out.flag(p.answered != null);
        out.number(numbers.visit(p.visit()));
        out.flag(p.told != null);
        if (p.told != null) {
            reference(p.told.instance);
            if (p.told.instance.isShared()) {
                out.integer(
                        p.told.place().shared[p.told.instance.specIndex].returns.indexOf(p.told));
            }
        }
        out.integer(p.names.length);
        for (NamedToken n : p.names) {
            out.token(n.token);
            out.tokens(Arrays.asList(n.tokens));
            out.flag(n.struck);
            out.flag(n.stood);
        }
    }

    /** Decisions that no activation asks; several of one interrupt in the order in which it was pressed. */
    private void decisions(MissionState m) {
        if (m.decisions.isEmpty()) {
            out.integer(0);
            return;
        }
        List<OpenDecision> open = state.decisionsOf(m).stream()
                .filter(d -> d.purpose != OpenDecision.Purpose.ACTIVATION)
                .sorted(Comparator.comparing((OpenDecision d) -> d.purpose)
                        .thenComparing(d -> d.subject)
                        .thenComparingInt(d -> d.instance == null ? 0 : d.instance.place.place.index)
                        .thenComparingLong(d -> d.instance == null ? 0 : numbers.visit(d.instance.visit))
                        .thenComparingInt(d -> d.instance == null ? 0 : d.instance.specIndex))
                .toList();
        out.integer(open.size());
        for (OpenDecision d : open) {
            out.text(d.purpose.name());
            out.text(d.subject);
            out.flag(d.instance != null);
            if (d.instance != null) {
                reference(d.instance);
            }
            out.content(d.decision);
        }
    }
}
