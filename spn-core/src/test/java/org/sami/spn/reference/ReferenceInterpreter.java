package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The rules of docs/semantics.md, one by one, with plain lists and linear searches.
 * Slow on purpose; the engine is held against it. Not for use outside tests.
 */
final class ReferenceInterpreter implements Subject, Roles.Operations {
    private final World world;
    private final Enabling enabling;
    private final Attention attention;
    private final Variables variables;
    private final Places places;
    private final Roles roles;
    private final Missions missions;
    private final Firing firing;
    private final Allocating allocating;
    private final Interrupts interrupts;

    ReferenceInterpreter(Vocabulary vocabulary, Project project, int livelockLimit) {
        world = new World(vocabulary, project, livelockLimit);
        enabling = new Enabling(world);
        attention = new Attention(world, enabling);
        variables = new Variables(world);
        places = new Places(world, attention, variables);
        roles = new Roles(world, attention, this);
        missions = new Missions(world, places, attention, variables);
        places.connect(roles, missions);
        firing = new Firing(world, enabling, attention, places);
        allocating = new Allocating(world);
        interrupts = new Interrupts(world, attention, roles);
    }

    // ---- What can be asked from outside

    @Override
    public Map<Long, Map<String, List<Token>>> markings() {
        Map<Long, Map<String, List<Token>>> all = new LinkedHashMap<>();
        for (Mission m : world.missions) {
            if (m.status != Mission.Status.ENDED) {
                Map<String, List<Token>> marking = new LinkedHashMap<>();
                m.marking.forEach((place, copies) -> {
                    if (!copies.isEmpty()) {
                        marking.put(place, copies.stream().map(c -> c.token).toList());
                    }
                });
                all.put(m.id, marking);
            }
        }
        return all;
    }

    @Override
    public Map<Long, Set<String>> visitedByNobody() {
        Map<Long, Set<String>> all = new LinkedHashMap<>();
        for (Mission m : world.missions) {
            if (m.status != Mission.Status.ENDED) {
                Set<String> places = new LinkedHashSet<>();
                m.visits.stream().filter(v -> v.byNobody).forEach(v -> places.add(v.place.id()));
                all.put(m.id, places);
            }
        }
        return all;
    }

    @Override
    public Map<Long, String> statuses() {
        Map<Long, String> all = new LinkedHashMap<>();
        world.missions.stream()
                .filter(m -> m.status != Mission.Status.ENDED)
                .forEach(m -> all.put(m.id, m.status.name()));
        return all;
    }

    @Override
    public Set<Long> openActivations() {
        Set<Long> open = new LinkedHashSet<>();
        world.visitOfActivation.forEach((id, visit) -> {
            if (!visit.ended) {
                open.add(id);
            }
        });
        return open;
    }

    @Override
    public Set<Long> openDecisions() {
        Set<Long> open = new LinkedHashSet<>();
        world.questions.forEach(q -> open.add(q.decision().id()));
        return open;
    }

    @Override
    public OptionalLong nextDueMillis() {
        return world.clocks.stream().mapToLong(World.Clock::dueMillis).min();
    }

    Optional<Value> variable(long mission, String name) {
        return world.mission(mission)
                .map(m -> variables.read(m, name))
                .orElseGet(() -> Optional.ofNullable(world.globals.get(name)));
    }

    // ---- One step

    /** Timers that are due first, each as an input of its own; then the input. */
    @Override
    public List<Effect> step(long nowMillis, Input input) {
        world.effects.clear();
        world.missions.forEach(m -> m.chain = 0);
        while (earliestDue(nowMillis).isPresent()) {
            World.Clock clock = earliestDue(nowMillis).orElseThrow();
            if (clock.dueMillis() > world.now) {
                world.now = clock.dueMillis();
                world.missions.forEach(m -> m.chain = 0);
            }
            roles.ring(clock);
            emptyWorkList();
        }
        world.now = nowMillis;
        world.missions.forEach(m -> m.chain = 0);
        handle(input);
        emptyWorkList();
        new Loading(world).forget();
        return List.copyOf(world.effects);
    }

    private Optional<World.Clock> earliestDue(long nowMillis) {
        World.Clock earliest = null;
        for (World.Clock clock : world.clocks) {
            boolean earlier = earliest == null
                    || clock.dueMillis() < earliest.dueMillis()
                    || (clock.dueMillis() == earliest.dueMillis() && clock.order() < earliest.order());
            if (clock.dueMillis() <= nowMillis && earlier) {
                earliest = clock;
            }
        }
        return Optional.ofNullable(earliest);
    }

    /** Empties the list (R-LOOK-6, R-LOOK-8). */
    private void emptyWorkList() {
        while (!world.work.isEmpty() || !world.internal.isEmpty()) {
            if (world.work.isEmpty()) {
                world.internal.remove().run();
                places.lookAtWithdrawn();
            } else {
                look(world.work.remove());
            }
        }
    }

    /** Looks at a transition in its turn (R-LOOK-7). */
    private void look(World.Look look) {
        Mission m = look.mission();
        Optional<List<Pending>> used = enabling.enabledWith(m, look.transition());
        if (used.isEmpty()) {
            attention.refuseInterrupts(m, look.transition());
        } else if (m.chain >= world.livelockLimit) {
            // R-LOOK-9
            m.status = Mission.Status.HALTED;
            world.note(NoteKind.LIVELOCK, m.id, look.transition().id());
            world.effects.add(new Effect.MissionEnded(m.id, Outcome.HALTED));
        } else {
            m.chain++;
            firing.fire(m, look.transition(), used.get());
            attention.refuseInterrupts(m, look.transition()); // one press, one firing
        }
    }

    // ---- Inputs

    private void handle(Input input) {
        if (input instanceof Input.StartMission start) {
            Optional<Plan> plan = world.project.plan(start.plan());
            if (plan.isPresent()) {
                missions.startRoot(plan.get(), start.name(), start.parameters());
            } else {
                missions.reject("No such plan: " + start.plan());
            }
        } else if (input instanceof Input.Received received) {
            receive(received.occurrence());
        } else if (input instanceof Input.ProxyJoined joined) {
            if (!world.proxies.contains(joined.proxy())) {
                world.proxies.add(joined.proxy());
            }
        } else if (input instanceof Input.ProxyDropped dropped) {
            drop(dropped.proxy(), dropped.mission());
        } else if (input instanceof Input.Interrupt interrupt) {
            interrupts.press(interrupt);
        } else if (input instanceof Input.AbortMission abort) {
            concerned(abort.mission()).forEach(this::abort);
        } else if (input instanceof Input.CompleteMission complete) {
            concerned(complete.mission()).forEach(this::complete);
        } else if (input instanceof Input.AnswerDecision answer) {
            answer(answer);
        } else if (input instanceof Input.HoldDecision hold) {
            hold(hold.decision());
        } else {
            handleData(input);
        }
    }

    private void handleData(Input input) {
        if (input instanceof Input.LoadProject load) {
            new Loading(world).load(load);
        } else if (input instanceof Input.SetVariable set) {
            setVariable(set);
        } else if (input instanceof Input.AllocateTasks allocate) {
            allocating.allocate(allocate.allocation());
        } else if (input instanceof Input.AddTasks add) {
            addTasks(add);
        } else if (input instanceof Input.HandlerFailed failed) {
            world.note(NoteKind.HANDLER_FAILED, Ids.NONE, failed.reason());
        } else if (input instanceof Input.Remember remember && remember.mission() == Ids.NONE) {
            world.memory.put(remember.key(), remember.value());
        } else if (input instanceof Input.Remember remember) {
            world.mission(remember.mission())
                    .ifPresentOrElse(
                            m -> m.memory.put(remember.key(), remember.value()),
                            () -> missions.reject("No such mission"));
        }
        // TimeReached: nothing but what every step does first
    }

    private void receive(Occurrence occurrence) {
        if (world.vocabulary.event(occurrence.type()).isEmpty()) {
            missions.reject("No such event: " + occurrence.type());
        } else {
            attention.receive(occurrence);
        }
    }

    private List<Mission> concerned(long mission) {
        if (mission == Ids.NONE) {
            return world.missions.stream()
                    .filter(m -> m.parent().isEmpty() && m.status != Mission.Status.ENDED)
                    .toList();
        }
        if (world.mission(mission).isEmpty()) {
            missions.reject("No such mission: " + mission);
        }
        return world.mission(mission).stream().toList();
    }

    // ---- Abort, completion (R-END-1)

    @Override
    public void abort(Mission m) {
        m.abortAsked = true;
        if (!intercepted(m, EventRole.ABORT_RECEIVED)) {
            missions.end(m, Outcome.ABORTED);
        }
    }

    @Override
    public void complete(Mission m) {
        m.completionAsked = true;
        if (!intercepted(m, EventRole.COMPLETE_RECEIVED)) {
            missions.end(m, Outcome.COMPLETED);
        }
    }

    /** Whether a transition intercepts it (R-END-1). */
    private boolean intercepted(Mission m, EventRole role) {
        List<Pending> posted = new ArrayList<>();
        if (m.reacts()) {
            for (Transition t : m.plan.transitions()) {
                for (InputEventSpec event : t.inputs()) {
                    if (world.eventType(event.type()).role() == role) {
                        Occurrence o = new Occurrence(event.type(), m.id, Ids.NONE, List.of(), List.of(), Map.of());
                        posted.add(new Pending(t, event, o));
                    }
                }
            }
        }
        posted.stream().filter(p -> attention.isFor(m, p)).forEach(p -> attention.keep(m, p));
        long firingsBefore = world.effects.size();
        while (!world.work.isEmpty()) {
            look(world.work.remove());
        }
        return world.effects.stream()
                .skip(firingsBefore)
                .anyMatch(e -> e instanceof Effect.Fired f
                        && f.mission() == m.id
                        && f.used().stream()
                                .anyMatch(o -> world.eventType(o.type()).role() == role));
    }

    // ---- Dropped boats (R-TOK-5 to R-TOK-7)

    private void drop(String proxy, long root) {
        Token.Proxy boat = new Token.Proxy(proxy);
        if (root == Ids.NONE
                && !world.proxies.remove(proxy)
                && world.missions.stream().noneMatch(m -> m.stands(boat))) {
            missions.reject("No such boat: " + proxy);
            return;
        }
        List<Mission> concerned = world.missions.stream()
                .filter(m -> m.status != Mission.Status.ENDED)
                .filter(m -> root == Ids.NONE
                        || world.mission(root).map(of -> of.root() == m.root()).orElse(false))
                .toList();
        Map<Mission, List<Place>> left = new LinkedHashMap<>();
        for (Mission m : concerned) {
            left.put(
                    m,
                    m.plan.places().stream()
                            .filter(place -> m.stands(boat, place))
                            .toList());
            allocating.release(m, proxy);
        }
        Map<Mission, List<Transition>> struck = new LinkedHashMap<>();
        for (Mission m : concerned) {
            places.removeEverywhere(m, boat);
            struck.put(m, attention.forget(m, boat));
            for (Visit visit : m.visits) {
                visit.instances.forEach(i -> i.back.removeIf(boat::equals));
            }
            m.statics.forEach(i -> places.forget(i, boat));
        }
        for (Mission m : concerned) {
            left.get(m).forEach(place -> places.lookAfterLeaving(m, place));
            struck.get(m).forEach(t -> world.lookAt(m, t));
        }
        Map<Mission, List<String>> without = new LinkedHashMap<>();
        concerned.forEach(m -> without.put(m, List.of(proxy)));
        roles.questions.askWithout(without);
        places.askWithoutWithdrawn();
        places.lookAtWithdrawn();
    }

    // ---- Decisions

    /** R-DEC-9: its clock is taken away. */
    private void hold(long decision) {
        Optional<World.Clock> clock = world.clocks.stream()
                .filter(c -> c.timer().isEmpty() && c.decision() == decision)
                .findFirst();
        if (clock.isEmpty()) {
            missions.reject("No clock runs for " + decision);
            return;
        }
        world.clocks.remove(clock.get());
        world.effects.add(new Effect.DecisionHeld(decision));
    }

    private void answer(Input.AnswerDecision input) {
        Optional<World.Question> question = roles.questions.find(input.decision());
        if (question.isPresent() && roles.questions.namesNobody(question.get(), input.answer())) {
            world.note(NoteKind.NAMES_NOBODY, question.get().decision().mission(), "");
            return;
        }
        if (question.isPresent()
                && input.answer() instanceof Answer.Rejected
                && question.get().decision().activation() == Ids.NONE
                && question.get().decision().question() instanceof Question.ChooseProxies) {
            roles.questions.close(question.get(), Optional.of(input.answer()), Optional.of(input.by())); // R-INT-8
            return;
        }
        if (question.isEmpty() || !Questions.fits(question.get().decision().question(), input.answer())) {
            missions.reject("Not a decision that this answers: " + input.decision());
            return;
        }
        World.Question q = question.get();
        if (missions.isAboutAborted(input.decision())) {
            roles.questions.close(q, Optional.of(input.answer()), Optional.of(input.by()));
            missions.decideAboutAborted(input.decision(), ((Answer.YesNo) input.answer()).yes());
        } else if (input.answer() instanceof Answer.Proxies boats
                && q.decision().activation() == Ids.NONE) {
            roles.questions.close(q, Optional.of(input.answer()), Optional.of(input.by()));
            interrupts.press(
                    world.mission(q.decision().mission()).orElseThrow(),
                    q.decision().prompt(),
                    boats.proxies());
        } else if (q.decision().activation() == Ids.NONE) {
            roles.questions.close(q, Optional.of(input.answer()), Optional.of(input.by()));
            Mission m = world.mission(q.decision().mission()).orElseThrow();
            m.asked.putAll(
                    Questions.withDefaults((Question.FillIn) q.decision().question(), (Answer.Fields) input.answer()));
            missions.mark(m);
        } else {
            roles.questions.answer(q, input.answer(), input.by());
        }
    }

    // ---- Variables and tasks

    private void setVariable(Input.SetVariable set) {
        boolean written = false;
        if (set.mission() == Ids.NONE) {
            written = world.project.globals().stream()
                            .anyMatch(v -> v.name().equals(set.variable())
                                    && TypeCheck.accepts(v.type(), set.value(), world.vocabulary.types()))
                    && variables.writeGlobal(world.project, set.variable(), set.value());
        } else {
            Optional<Mission> m = world.mission(set.mission());
            // R-VAR-3
            written = m.isPresent()
                    && variables
                            .declaration(m.get(), set.variable())
                            .map(v -> TypeCheck.accepts(v.type(), set.value(), world.vocabulary.types()))
                            .orElse(true);
            if (written) {
                variables.write(m.get(), set.variable(), set.value());
            }
        }
        if (!written) {
            missions.reject("Cannot write " + set.variable());
        }
    }

    private void addTasks(Input.AddTasks add) {
        Optional<Mission> m = world.mission(add.mission());
        if (m.isEmpty()) {
            missions.reject("No such mission");
            return;
        }
        for (TaskSpec task : add.tasks()) {
            if (m.get().tasks.putIfAbsent(task.name(), task) != null) {
                missions.reject("A second task of that name");
            }
        }
    }
}
