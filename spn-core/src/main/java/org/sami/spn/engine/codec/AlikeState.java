package org.sami.spn.engine.codec;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.RunningTimer;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Says what a state means in facts about robots, tasks, visits and activations, and not which of them is which, in what order they came, where
 * points lie or how long timers have to run. Robots and tasks of which plans speak by name keep their names. The order in which tokens entered
 * a place is stated only where a requirement takes some number of them.
 */
public final class AlikeState {
    private final NetState state;
    private final LabelledStructure facts = new LabelledStructure();
    private final AlikeNames names;
    private final AlikeValues values;
    private final Set<Object> said = new HashSet<>();
    private final Map<MissionState, Boolean> ordered = new HashMap<>();

    /**
     * The facts of a state.
     *
     * @param robots names of robots that are like one another
     */
    public AlikeState(NetState state, Set<String> robots) {
        this.state = state;
        this.names = new AlikeNames(state.missions, robots, facts);
        this.values = new AlikeValues(names, facts);
        state.missions.values().forEach(this::mission);
        state.proxies().forEach(robot -> facts.fact("known", names.robot(robot)));
        values.all("global", state.globals.all());
        values.all("memory", state.memory.all());
        timers();
        for (OpenDecision d : state.decisions.values()) {
            if (d.purpose != OpenDecision.Purpose.ACTIVATION) {
                asked(d);
            }
        }
    }

    /** The bytes: equal ones only where the facts are equal. */
    public byte[] bytes() {
        return facts.bytes();
    }

    /** States that a robot has a task left, as observers of its tasks know. */
    public void left(String robot, int turn, TaskId task, boolean begun) {
        facts.fact("left " + turn + begun, names.robot(robot), names.task(task));
    }

    // ---- Who

    private void tokens(String what, int of, Collection<Token> tokens) {
        tokens.forEach(token -> facts.fact(what, of, names.token(token)));
    }

    private int number(MissionState m) {
        return facts.object(m, "mission of " + m.plan.plan.id());
    }

    private int number(Visit v) {
        return facts.object(v, "visit");
    }

    private int number(SentActivation s) {
        return facts.object(s, "activation of " + s.activation.event());
    }

    private int number(Instance i) {
        return facts.object(i, "instance " + i.place.place.index + "." + i.specIndex);
    }

    // ---- Missions

    private void mission(MissionState m) {
        int mission = number(m);
        facts.fact(m.status + " " + m.asked + " " + m.returnValue + " " + m.plan.project.version, mission);
        if (m.parent != null) {
            facts.fact("runs for", mission, number(m.asInstance()));
            instance(m.parent, m.asInstance());
        }
        values.all("variable", m.variables, mission);
        values.all("memory", m.memory, mission);
        values.all("parameter", m.parameters, mission);
        for (int i = 0; i < m.waiting.size(); i++) {
            tokens("waits " + i, mission, m.waiting.get(i));
        }
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            visit(v);
        }
        for (PlaceState place : m.places) {
            if (place != null) {
                place(m, place);
            }
        }
        for (TransitionState t : m.transitions) {
            if (t != null && t.pending > 0) {
                new AlikePending(names, facts, values, this::visit).of(mission, t);
            }
        }
        m.tasks.values().forEach(t -> task(mission, t));
    }

    private void task(int mission, TaskState t) {
        int task = names.task(t.id);
        facts.fact("task of class " + t.taskClass, mission, task);
        values.all("field", t.fields, task);
        if (t.original != null) {
            facts.fact("stands for", task, names.task(t.original.id));
        } else if (!t.proxy().isEmpty()) {
            facts.fact("allocated", task, names.robot(t.proxy()));
        }
    }

    /** A visit, which may have ended, with what was asked in it. */
    private int visit(Visit v) {
        int visit = number(v);
        if (!said.add(v)) {
            return visit;
        }
        String what = "visit " + v.place.place.index + v.ended + v.held + v.used;
        facts.fact(what, number(v.place.mission), visit);
        tokens("entered", visit, v.entered);
        if (!v.ended) {
            v.instances.forEach(i -> {
                facts.fact("instance", visit, number(i));
                instance(v.place.mission, i);
            });
        }
        for (SentActivation s = v.firstSent(); s != null; s = s.next()) {
            sent(visit, s);
        }
        return visit;
    }

    private void instance(MissionState parent, Instance i) {
        int instance = number(i);
        if (!said.add(i)) {
            return;
        }
        facts.fact("in " + i.status + " " + i.returnValue, number(parent), instance);
        tokens("started", instance, i.starting);
        tokens("returned", instance, i.returned);
    }

    private void sent(int visit, SentActivation s) {
        int sent = number(s);
        facts.fact("asked" + s.open, visit, sent);
        values.all("value", s.activation.values(), sent);
        s.activation.taskValues().forEach((task, of) -> values.all("of task", of, sent, names.task(task)));
        tokens("asked of", sent, s.activation.tokens());
        s.activation
                .allocation()
                .forEach((task, robot) -> facts.fact("asked with", sent, names.task(task), names.robot(robot)));
        if (s.decision != Ids.NONE) {
            decision(sent, state.decision(s.decision).decision);
        }
    }

    private void place(MissionState m, PlaceState place) {
        int mission = number(m);
        int index = place.place.index;
        boolean inOrder = ordered.computeIfAbsent(m, AlikeState::readsOrder);
        List<PlacedToken> entries = place.inOrder();
        for (int i = 0; i < entries.size(); i++) {
            PlacedToken e = entries.get(i);
            facts.fact("stands " + index + (inOrder ? " " + i : ""), mission, names.token(e.token), number(e.visit));
        }
        for (SharedRun run : place.shared) {
            facts.fact("shared", mission, number(run.instance));
            instance(m, run.instance);
            for (int i = 0; i < run.returns.size(); i++) {
                Return r = run.returns.get(i);
                facts.fact("gave back " + i + " " + r.value, number(run.instance));
                tokens("gave " + i, number(run.instance), r.tokens);
            }
        }
        if (place.lastVisits != null) {
            place.lastVisits.forEach((token, v) -> facts.fact("last " + index, mission, names.token(token), visit(v)));
        }
    }

    /** Whether the plan takes some number of tokens: then it takes the oldest. */
    private static boolean readsOrder(MissionState m) {
        return m.plan.plan.outEdges().stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.n() != OutRequirement.ALL
                        && r.kind() != TokenKind.GENERIC
                        && r.kind() != TokenKind.UNCONDITIONAL);
    }

    // ---- Questions and timers

    private void timers() {
        long due = state.now;
        int turn = 0;
        for (RunningTimer t : state.timers) {
            turn += t.due() > due ? 1 : 0;
            due = t.due();
            SentActivation sent = state.activationOf(t);
            String what = "timer " + turn + t.isDeadline();
            if (t.isDeadline()) {
                facts.fact(what, number(sent));
            } else {
                facts.fact(what, number(sent), names.token(t.token()));
            }
        }
    }

    private void asked(OpenDecision d) {
        int asked = facts.object(d, "asked " + d.purpose);
        if (d.mission != null) {
            facts.fact("asked", number(d.mission), asked);
        }
        if (d.instance != null) {
            facts.fact("about", asked, number(d.instance));
        }
        facts.fact("about", asked, names.robot(d.subject));
        decision(asked, d.decision);
    }

    private void decision(int asked, Decision d) {
        facts.fact("asks " + d.type() + " " + d.automatic().isPresent(), asked);
        Question question = d.question();
        if (question instanceof Question.ChooseProxies choose) {
            facts.fact("chooses " + choose.min() + " to " + choose.max(), asked);
            choose.proxies().forEach(robot -> facts.fact("offers", asked, names.robot(robot)));
        } else if (question instanceof Question.ChooseOption choose) {
            facts.fact("options " + choose.options().size(), asked);
            for (int i = 0; i < choose.options().size(); i++) {
                Value option = choose.options().get(i);
                values.value("option " + i, option, asked);
            }
        } else if (question instanceof Question.FillIn fillIn) {
            fillIn.items().forEach(item -> {
                facts.fact("item " + item.key() + item.editable(), asked);
                item.defaultValue().ifPresent(value -> values.value("default " + item.key(), value, asked));
            });
        }
    }
}
