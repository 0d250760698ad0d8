package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.FieldType;

/** How missions and instances begin and end. */
final class Missions {
    private final World world;
    private final Places places;
    private final Attention attention;
    private final Variables variables;

    Missions(World world, Places places, Attention attention, Variables variables) {
        this.world = world;
        this.places = places;
        this.attention = attention;
        this.variables = variables;
    }

    // ---- Beginning

    Mission startRoot(Plan plan, String name, Map<String, Value> parameters) {
        Mission m = make(plan, name, Optional.empty());
        m.startsWithTokens = true;
        begin(m, parameters);
        return m;
    }

    private Mission make(Plan plan, String name, Optional<Instance> asChild) {
        Mission m = new Mission(world.nextMission++, plan, world, name, asChild);
        world.missions.add(m);
        plan.tasks().forEach(task -> m.tasks.put(task.name(), task));
        world.effects.add(new Effect.MissionStarted(
                m.id,
                m.parent().map(p -> p.id).orElse(Ids.NONE),
                asChild.map(instance -> instance.place.id()).orElse(""),
                plan.id(),
                name,
                m.projectVersion));
        return m;
    }

    /** Asks what is asked at the start; the start marking waits (R-ACT-4). */
    private void begin(Mission m, Map<String, Value> parameters) {
        m.plan.variables().forEach(v -> v.initial().ifPresent(value -> m.variables.put(v.name(), value)));
        parameters.forEach((key, value) -> {
            if (key.startsWith("@")) {
                variables.write(m, key, value);
            }
        });
        List<Question.Item> items = new ArrayList<>();
        for (Place place : m.plan.places()) {
            for (OutputEventSpec spec : place.outputs()) {
                for (FieldType field : world.eventType(spec.type()).fields()) {
                    if (spec.fields().get(field.name()) instanceof FieldSource.Asked asked) {
                        String key = spec.id() + "." + field.name();
                        asked.defaultValue().ifPresent(value -> m.asked.put(key, value));
                        if (parameters.containsKey(key)) {
                            m.asked.put(key, parameters.get(key));
                        } else {
                            items.add(new Question.Item(
                                    key, field.type(), field.unit(), asked.defaultValue(), asked.editable(), ""));
                        }
                    }
                }
            }
        }
        if (items.stream().noneMatch(Question.Item::editable)) {
            mark(m); // a locked field shows its default, there is nothing to ask
        } else {
            Decision decision = new Decision(
                    world.nextDecision++,
                    m.id,
                    Ids.NONE,
                    "",
                    "",
                    new Question.FillIn(items),
                    Optional.empty(),
                    OptionalLong.empty(),
                    Priority.MEDIUM,
                    List.of());
            world.questions.add(new World.Question(decision, Optional.empty()));
            world.effects.add(new Effect.DecisionOpened(decision));
        }
    }

    /** The start marking (R-TOK-2), after constants were written (R-ACT-3). */
    void mark(Mission m) {
        m.status = Mission.Status.RUNNING;
        for (Place place : m.plan.places()) {
            for (OutputEventSpec spec : place.outputs()) {
                spec.writes().forEach((field, variable) -> {
                    if (spec.fields().get(field) instanceof FieldSource.Fixed fixed) {
                        variables.write(m, variable, fixed.value());
                    } else if (spec.fields().get(field) instanceof FieldSource.Asked) {
                        variables.write(m, variable, m.asked.get(spec.id() + "." + field));
                    }
                });
            }
        }
        makeSharedInstances(m);
        if (m.startsWithTokens) {
            List<Token> tokens = new ArrayList<>();
            tokens.add(Token.GENERIC);
            world.proxies.forEach(proxy -> tokens.add(new Token.Proxy(proxy)));
            tokens.addAll(ownTasks(m));
            m.starting.add(tokens);
        }
        List<List<Token>> starting = List.copyOf(m.starting);
        m.starting.clear();
        starting.forEach(tokens -> places.enter(m, m.plan.startPlace().orElseThrow(), tokens));
    }

    /** Task tokens of the mission's own tasks, without those that stand for tasks of its parents. */
    private static List<Token> ownTasks(Mission m) {
        return m.plan.tasks().stream()
                .filter(task -> m.asChild
                        .map(i -> !i.spec.tasks().containsValue(task.name()))
                        .orElse(true))
                .<Token>map(task -> new Token.Task(new TaskId(m.id, task.name())))
                .toList();
    }

    /** Starts the static instances (R-SHR-1). */
    private void makeSharedInstances(Mission m) {
        for (Place place : m.plan.places()) {
            for (SubMissionSpec spec : place.subMissions()) {
                if (spec.shared()) {
                    Instance instance = new Instance(spec, m, place, Optional.empty());
                    m.statics.add(instance);
                    instance.child = makeChild(instance);
                    begin(instance.child, Map.of());
                }
            }
        }
    }

    private Mission makeChild(Instance instance) {
        Plan plan = instance.parent.project.plan(instance.spec.plan()).orElseThrow();
        Mission child = make(plan, plan.name(), Optional.of(instance));
        instance.spec
                .tasks()
                .forEach((parents, own) ->
                        nearest(instance.parent, parents).ifPresent(original -> stand(child, own, original)));
        return child;
    }

    /** The task of that name of the nearest mission, from this one outwards. */
    private static Optional<TaskId> nearest(Mission m, String task) {
        return m.tasks.containsKey(task)
                ? Optional.of(new TaskId(m.id, task))
                : m.parent().flatMap(parent -> nearest(parent, task));
    }

    /** A child's task stands for a parent's: it has the parent's fields, and its own where that has none. */
    private void stand(Mission child, String own, TaskId original) {
        TaskSpec theirs = world.task(original).orElseThrow();
        TaskSpec before = child.tasks.getOrDefault(own, new TaskSpec(own, theirs.taskClass(), Map.of()));
        Map<String, Value> fields = new LinkedHashMap<>(before.fields());
        fields.putAll(theirs.fields());
        child.tasks.put(own, new TaskSpec(own, before.taskClass(), fields));
        child.standsFor.put(own, original);
    }

    void startSubMissions(Visit visit, List<Token> tokens) {
        for (SubMissionSpec spec : visit.place.subMissions()) {
            if (spec.shared()) {
                // R-SHR-1
                visit.mission.statics.stream().filter(i -> i.spec.equals(spec)).forEach(i -> join(i, tokens));
            } else {
                // R-SUB-1
                Instance instance = new Instance(spec, visit.mission, visit.place, Optional.of(visit));
                visit.instances.add(instance);
                instance.child = makeChild(instance);
                List<Token> starting = named(instance, tokens);
                starting.addAll(ownTasks(instance.child));
                instance.child.starting.add(starting);
                begin(instance.child, Map.of());
            }
        }
    }

    private void join(Instance shared, List<Token> tokens) {
        Mission child = shared.child;
        if (child.reacts()) {
            shared.joined.addAll(tokens);
            places.enter(child, child.plan.startPlace().orElseThrow(), named(shared, tokens));
        } else if (child.status == Mission.Status.WAITING) {
            shared.joined.addAll(tokens);
            child.starting.add(named(shared, tokens));
        } else if (!tokens.isEmpty()) {
            // R-SHR-8
            world.note(NoteKind.NOT_RETURNED, shared.parent.id, shared.place.id());
        }
    }

    private static List<Token> named(Instance instance, List<Token> tokens) {
        return new ArrayList<>(tokens.stream().map(instance::toChild).toList());
    }

    // ---- Ending

    /** A mission is over: with it timers, pending occurrences, decisions and sub-missions. */
    void end(Mission m, Outcome way) {
        if (m.status == Mission.Status.ENDED) {
            return;
        }
        Outcome outcome = outcomeOf(m, way);
        m.status = Mission.Status.ENDED;
        world.allocation.keySet().removeIf(task -> task.mission() == m.id);
        // R-END-6
        for (Visit visit : m.visits) {
            visit.instances.forEach(i -> endChild(i, outcome));
        }
        m.statics.forEach(i -> endChild(i, outcome));
        List<Token> inEndPlaces = tokensInEndPlaces(m);
        List.copyOf(m.visits).forEach(places::end);
        m.pending.clear();
        world.questions.removeIf(q -> {
            boolean own = q.decision().mission() == m.id;
            if (own) {
                world.effects.add(new Effect.DecisionClosed(q.decision().id(), Optional.empty(), Optional.empty()));
            }
            return own;
        });
        if (!m.commandsWithdrawn) {
            world.effects.add(new Effect.CommandsWithdrawn(m.id, List.of()));
        }
        world.effects.add(new Effect.MissionEnded(m.id, outcome));
        m.asChild.ifPresent(instance -> tellParent(instance, outcome, inEndPlaces));
    }

    /** What was asked is the outcome (R-END-2). */
    private static Outcome outcomeOf(Mission m, Outcome way) {
        if (m.abortAsked || way == Outcome.ABORTED) {
            return Outcome.ABORTED;
        }
        return m.completionAsked ? Outcome.COMPLETED : way;
    }

    private void endChild(Instance instance, Outcome outcome) {
        if (instance.state == Instance.State.RUNNING) {
            end(instance.child, outcome);
        }
    }

    private static List<Token> tokensInEndPlaces(Mission m) {
        return m.plan.places().stream()
                .filter(Place::end)
                .flatMap(place -> m.tokensIn(place).stream())
                .map(copy -> copy.token)
                .flatMap(token -> m.asChild.flatMap(i -> i.toParent(token)).stream())
                .toList();
    }

    private void tellParent(Instance instance, Outcome outcome, List<Token> inEndPlaces) {
        instance.state = outcome == Outcome.ABORTED ? Instance.State.ABORTED : Instance.State.COMPLETE;
        boolean visitIsOver = instance.visit.map(v -> v.ended).orElse(false);
        if (instance.parent.status == Mission.Status.ENDED || visitIsOver) {
            return;
        }
        if (outcome == Outcome.ABORTED) {
            instance.child.returnValue = Optional.empty(); // what it would have returned counts no more (R-SUB-10)
            world.internal.add(() -> postAborted(instance));
            return;
        }
        if (instance.spec.shared()) {
            returns(instance, inEndPlaces); // what stands in its end places returns
        } else {
            instance.back.addAll(inEndPlaces);
            reportWhoDidNotComeBack(instance);
            completed(instance);
        }
    }

    /** Notes who did not come back (R-SUB-5). */
    private void reportWhoDidNotComeBack(Instance instance) {
        Visit visit = instance.visit.orElseThrow();
        List<Token> back = new ArrayList<>(instance.back);
        boolean someStay = false;
        for (Copy copy : visit.mission.tokensIn(visit.place)) {
            someStay |= copy.visit == visit && !back.remove(copy.token);
        }
        if (someStay) {
            world.note(NoteKind.NOT_RETURNED, visit.mission.id, visit.place.id());
        }
    }

    /** A visit is complete when all its instances are (R-LOOK-3, R-SUB-3). */
    private void completed(Instance instance) {
        Visit visit = instance.visit.orElseThrow();
        if (visit.complete()) {
            places.lookAfterEntry(instance.parent, instance.place);
            visit.instances.forEach(one -> tell(new Returned(one, List.of(), one.child.returnValue)));
        }
    }

    /** Keeps a return behind the earlier ones (R-LOOK-3, R-SHR-5). */
    private void returns(Instance instance, List<Token> tokens) {
        Returned returned = new Returned(instance, tokens, instance.child.returnValue);
        instance.returns.add(returned);
        tokens.forEach(instance.joined::remove);
        places.lookAfterEntry(instance.parent, instance.place);
        tell(returned);
    }

    /** Tells the value of a return, if it has one, once the work list is empty. */
    void tell(Returned returned) {
        returned.value.ifPresent(value -> world.internal.add(() -> tell(returned, value)));
    }

    /** Tokens leave the child as one return (R-SHR-2). */
    void returnFrom(Visit visit) {
        Mission child = visit.mission;
        Instance instance = child.asChild.orElseThrow();
        List<Copy> copies = child.tokensIn(visit.place).stream()
                .filter(c -> c.visit == visit)
                .toList();
        places.remove(child, copies);
        places.end(visit);
        List<Token> returned = copies.stream()
                .map(c -> c.token)
                .flatMap(token -> instance.toParent(token).stream())
                .toList();
        returns(instance, returned);
    }

    private void tell(Returned returned, Value value) {
        Instance instance = returned.by;
        Mission m = instance.parent;
        if (!m.reacts() || returned.usedUp || instance.visit.map(v -> v.ended).orElse(false)) {
            return;
        }
        for (Transition t : m.outTransitions(instance.place)) {
            for (InputEventSpec event : t.inputs()) {
                boolean asks = world.eventType(event.type()).role() == EventRole.CHECK_RETURN
                        && value.equals(event.fields().get("value"))
                        && (!(event.fields().get("subMission") instanceof PlanReference named)
                                || named.plan().equals(instance.spec.plan()));
                if (asks) {
                    Occurrence o =
                            new Occurrence(event.type(), m.id, Ids.NONE, List.of(), List.of(), Map.of("value", value));
                    Pending pending = new Pending(t, event, o);
                    pending.told = Optional.of(returned);
                    attention.keep(m, pending);
                }
            }
        }
    }

    /** Tells the parent of an aborted child (R-SUB-8). */
    private void postAborted(Instance instance) {
        Mission m = instance.parent;
        if (!m.reacts() || instance.visit.map(v -> v.ended).orElse(false)) {
            return;
        }
        List<Token> starting = startingTokens(instance);
        List<String> proxies = new ArrayList<>();
        List<TaskId> tasks = new ArrayList<>();
        for (Token token : starting) {
            if (token instanceof Token.Proxy boat && !proxies.contains(boat.proxy())) {
                proxies.add(boat.proxy());
            } else if (token instanceof Token.Task task && !tasks.contains(task.task())) {
                tasks.add(task.task());
            }
        }
        boolean wanted = false;
        for (Transition t : m.outTransitions(instance.place)) {
            for (InputEventSpec event : t.inputs()) {
                boolean onlyKeptAway = !(proxies.isEmpty() && tasks.isEmpty())
                        && starting.stream()
                                .filter(token -> !(token instanceof Token.Generic))
                                .allMatch(token -> attention.asksOnlyForAbsence(m, t, instance.place, token, true));
                if (world.eventType(event.type()).role() == EventRole.SUB_MISSION_ABORTED && !onlyKeptAway) {
                    Occurrence o = new Occurrence(event.type(), m.id, Ids.NONE, proxies, tasks, Map.of());
                    Pending pending = new Pending(t, event, o);
                    pending.ofAborted = true;
                    pending.childOf = instance.visit;
                    attention.keep(m, pending);
                    wanted = true;
                }
            }
        }
        if (!wanted) {
            askAboutAborted(instance);
        }
    }

    static List<Token> startingTokens(Instance instance) {
        if (instance.spec.shared()) {
            return instance.joined;
        }
        return instance.parent.tokensIn(instance.place).stream()
                .filter(c -> instance.visit.map(v -> v == c.visit).orElse(true))
                .map(c -> c.token)
                .toList();
    }

    /** Asks the operator where nobody waits for it (R-SUB-9). */
    private void askAboutAborted(Instance instance) {
        Decision decision = new Decision(
                world.nextDecision++,
                instance.parent.id,
                Ids.NONE,
                Decision.ABORTED + instance.place.id(),
                "",
                new Question.Approve(),
                Optional.of(new org.sami.spn.protocol.Answer.YesNo(true)),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of());
        world.questions.add(new World.Question(decision, instance.visit));
        abortedOf.put(decision.id(), instance);
        world.effects.add(new Effect.DecisionOpened(decision));
    }

    private final Map<Long, Instance> abortedOf = new LinkedHashMap<>();

    /** The operator's word about an aborted child: to return its boats is as if they had come back. */
    void decideAboutAborted(long decision, boolean bringBack) {
        Instance instance = abortedOf.remove(decision);
        if (bringBack) {
            instance.state = Instance.State.COMPLETE;
            if (instance.spec.shared()) {
                returns(instance, List.copyOf(instance.joined));
            } else {
                instance.back.addAll(startingTokens(instance));
                completed(instance);
            }
        }
    }

    boolean isAboutAborted(long decision) {
        return abortedOf.containsKey(decision);
    }

    /** Not possible: what an input asked for makes no sense here. */
    void reject(String message) {
        world.note(NoteKind.REJECTED_INPUT, Ids.NONE, message);
    }
}
