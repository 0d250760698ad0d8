package org.sami.spn.engine.codec;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;

/** Writes a whole state between two steps. What can be worked out again from the rest is left out. */
public final class StateEncoder {
    /** First bytes of every encoded state: "SPNS". */
    public static final int MAGIC = 0x53504e53;
    /** Version of the form. */
    public static final int VERSION = 6;

    /** Version of the form of a state that has loaded no project: all of its plans are the engine's. */
    private static final int WITHOUT_LOADED = 5;

    /** Since this version a state says when its missions started, and how often they fired. */
    static final int WITH_TIMES = 5;

    private final ProtocolEncoder out = new ProtocolEncoder();
    private boolean loaded;

    public byte[] write(NetState s) {
        out.integer(MAGIC);
        loaded = s.newest().version > 1;
        out.integer(loaded ? VERSION : WITHOUT_LOADED);
        if (loaded) {
            projects(s);
        }
        for (long n : new long[] {
            s.now, s.lastMission, s.lastActivation, s.lastVisit, s.lastDecision, s.lastTimer, s.firings, s.stamp
        }) {
            out.number(n);
        }
        out.texts(s.proxies());
        out.values(s.globals.all());
        out.values(s.memory.all());
        out.integer(s.discardedNews.all().size());
        s.discardedNews.all().forEach((type, n) -> {
            out.text(type);
            out.number(n);
        });
        out.integer(s.missions.size());
        s.missions.values().forEach(this::mission);
        out.integer(s.decisions.size());
        s.decisions.values().forEach(this::decision);
        out.integer(s.timers.size());
        for (RunningTimer t : s.timers) {
            out.number(t.due());
            out.number(t.id());
            out.number(t.activation());
            out.token(t.token());
            out.number(t.decision());
        }
        List<MissionState> asked =
                s.missions.values().stream().filter(m -> m.asked != null).toList();
        out.integer(asked.size());
        for (MissionState m : asked) {
            out.number(m.id);
            out.text(Objects.requireNonNull(m.asked).name());
        }
        for (MissionState m : s.missions.values()) {
            out.number(m.startedAt);
            out.number(m.firings);
        }
        return out.bytes();
    }

    private void mission(MissionState m) {
        out.number(m.id);
        out.text(m.plan.plan.id());
        if (loaded) {
            out.integer(m.plan.project.version);
        }
        out.text(m.name);
        out.number(m.parent == null ? Ids.NONE : m.parent.id);
        if (m.parent != null) {
            instanceReference(m.asInstance());
        }
        out.text(m.status.name());
        out.values(m.variables);
        out.values(m.memory);
        out.values(m.parameters);
        out.text(m.returnValue);
        out.integer(m.generatedTasks);
        out.integer(m.tasks.size());
        m.tasks.values().forEach(this::task);
        out.integer(m.waiting.size());
        m.waiting.forEach(out::tokens);
        shared(m);
        visits(m);
        marking(m);
        pending(m);
    }

    /** The loaded projects of which something runs or may start, by their documents; the newest is the last. */
    private void projects(NetState s) {
        TreeMap<Integer, CompiledProject> projects = new TreeMap<>();
        s.running().forEach(p -> projects.put(p.version, p));
        projects.put(s.newest().version, s.newest());
        projects.remove(s.first.version);
        out.integer(projects.size());
        for (CompiledProject p : projects.values()) {
            out.integer(p.version);
            out.text(p.sha256);
        }
    }

    private void task(TaskState t) {
        out.value(t.id);
        out.text(t.taskClass);
        out.values(t.fields);
        out.flag(t.original != null);
        if (t.original != null) {
            out.value(t.original.id);
        } else {
            out.text(t.proxy());
        }
    }

    private void instanceReference(Instance i) {
        out.integer(i.place.place.index);
        out.number(i.visit == null ? Ids.NONE : i.visit.id);
        out.integer(i.specIndex);
    }

    private void instance(Instance i) {
        out.text(i.status.name());
        out.tokens(i.starting);
        out.tokens(i.returned);
        out.text(i.returnValue);
    }

    private void shared(MissionState m) {
        for (CompiledPlace place : m.plan.places) {
            if (place.shared.isEmpty()) {
                continue;
            }
            PlaceState state = m.place(place.index);
            out.integer(state.shared.length);
            for (SharedRun run : state.shared) {
                instance(run.instance);
                out.integer(run.returns.size());
                run.returns.forEach(r -> {
                    out.tokens(r.tokens);
                    out.text(r.value);
                });
            }
        }
    }

    /** Visits that go on, and ended ones of which something still speaks. */
    private void visits(MissionState m) {
        TreeSet<Visit> visits = new TreeSet<>(Comparator.comparingLong((Visit v) -> v.id));
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            visits.add(v);
        }
        for (PlaceState place : m.places) {
            if (place != null && place.lastVisits != null) {
                visits.addAll(place.lastVisits.values());
            }
        }
        for (TransitionState t : m.transitions) {
            if (t != null) {
                for (TransitionState.Queue q : t.queues) {
                    for (PendingOccurrence p = q.first; p != null; p = p.next) {
                        if (p.visit() != null) {
                            visits.add(p.visit());
                        }
                    }
                }
            }
        }
        out.integer(visits.size());
        visits.forEach(this::visit);
        for (PlaceState place : m.places) {
            Map<Token, Visit> last = place == null || place.lastVisits == null ? Map.of() : place.lastVisits;
            out.integer(last.size());
            last.forEach((token, v) -> {
                out.token(token);
                out.number(v.id);
            });
        }
    }

    private void visit(Visit v) {
        out.number(v.id);
        out.integer(v.place.place.index);
        out.flag(v.ended);
        out.flag(v.held);
        out.flag(v.used);
        out.integer(v.remembered);
        out.tokens(v.entered);
        List<Instance> instances = v.ended ? List.of() : v.instances;
        out.integer(instances.size());
        instances.forEach(this::instance);
        out.integer(v.countSent());
        for (SentActivation s = v.firstSent(); s != null; s = s.next()) {
            out.integer(v.place.place.indexOf(s.output));
            out.activation(s.activation);
        }
    }

    private void marking(MissionState m) {
        for (PlaceState place : m.places) {
            List<PlacedToken> entries = place == null ? List.of() : place.inOrder();
            out.integer(entries.size());
            for (PlacedToken e : entries) {
                out.token(e.token);
                out.number(e.order());
                out.number(e.visit.id);
            }
        }
    }

    private void pending(MissionState m) {
        for (TransitionState t : m.transitions) {
            out.integer(t == null ? 0 : t.pending);
            if (t == null || t.pending == 0) {
                continue;
            }
            for (TransitionState.Queue q : t.queues) {
                for (PendingOccurrence p = q.first; p != null; p = p.next) {
                    pending(p);
                }
            }
        }
    }

    private void pending(PendingOccurrence p) {
        out.integer(p.input.index);
        out.occurrence(p.occurrence);
        out.number(p.answered == null ? Ids.NONE : p.answered.activation.id());
        out.number(p.bound == null ? Ids.NONE : p.bound.id);
        out.flag(p.told != null);
        if (p.told != null) {
            told(p.told);
        }
        out.integer(p.names.length);
        for (NamedToken n : p.names) {
            out.token(n.token);
            out.tokens(List.of(n.tokens));
            out.flag(n.struck);
            out.flag(n.stood);
        }
    }

    private void told(Return r) {
        instanceReference(r.instance);
        if (r.instance.isShared()) {
            out.integer(r.place().shared[r.instance.specIndex].returns.indexOf(r));
        }
    }

    private void decision(OpenDecision d) {
        out.decision(d.decision);
        out.text(d.purpose.name());
        out.number(d.mission == null ? Ids.NONE : d.mission.id);
        out.number(d.sent == null ? Ids.NONE : d.sent.activation.id());
        out.flag(d.instance != null);
        if (d.instance != null) {
            instanceReference(d.instance);
        }
        out.text(d.subject);
    }
}
