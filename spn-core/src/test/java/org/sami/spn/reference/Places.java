package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;

/** What happens when tokens enter and leave places: visits, activations, and who is looked at then. */
final class Places {
    private record Withdrawn(Mission mission, Place place) {}

    private final World world;
    private final Attention attention;
    private final Variables variables;
    private final List<Withdrawn> withdrawn = new ArrayList<>();
    private final Map<Mission, List<String>> boatsWithdrawn = new LinkedHashMap<>();
    private Roles roles;
    private Missions missions;

    Places(World world, Attention attention, Variables variables) {
        this.world = world;
        this.attention = attention;
        this.variables = variables;
    }

    void connect(Roles engineRoles, Missions lifeOfMissions) {
        this.roles = engineRoles;
        this.missions = lifeOfMissions;
    }

    Variables variables() {
        return variables;
    }

    // ---- Entering

    /** Everything that an entry outside a firing means: the start marking, and what joins a static child. */
    void enter(Mission m, Place place, List<Token> tokens) {
        Visit visit = add(m, place, tokens);
        activate(visit, false);
        startSubMissions(visit);
        lookAfterEntry(m, place);
    }

    /** Tokens, or nobody, enter a place (R-VIS-1). */
    Visit add(Mission m, Place place, List<Token> tokens) {
        Visit visit = new Visit(world.nextVisit++, m, place, tokens.isEmpty());
        m.visits.add(visit);
        visit.entered.addAll(tokens);
        tokens.forEach(token -> m.tokensIn(place).add(new Copy(token, visit)));
        if (m.tokensIn(place).size() > World.MOST_TOKENS) {
            throw new World.TooManyTokens();
        }
        return visit;
    }

    /** Activates the output events of an entered place (R-ACT-1). */
    void activate(Visit visit, boolean ends) {
        List<Token> tokens = visit.mission.tokensIn(visit.place).stream()
                .filter(c -> c.visit == visit)
                .map(c -> c.token)
                .toList();
        for (OutputEventSpec spec : visit.place.outputs()) {
            Activation activation = resolve(visit, spec, tokens);
            visit.activations.add(activation);
            world.visitOfActivation.put(activation.id(), visit);
            world.effects.add(new Effect.Activated(activation));
            writeFields(visit.mission, spec, activation);
            roles.activated(visit, activation, ends);
        }
    }

    /** Resolves fields at entry (R-ACT-2). */
    private Activation resolve(Visit visit, OutputEventSpec spec, List<Token> tokens) {
        Mission m = visit.mission;
        EventType type = world.eventType(spec.type());
        Map<String, Value> values = new LinkedHashMap<>();
        Map<TaskId, Map<String, Value>> taskValues = new LinkedHashMap<>();
        Map<TaskId, String> allocation = new LinkedHashMap<>();
        for (FieldType field : type.fields()) {
            FieldSource source = spec.fields().get(field.name());
            if (source instanceof FieldSource.FromTask) {
                readFromTasks(field.name(), tokens, taskValues);
            } else {
                valueOf(m, spec, field, source).ifPresent(value -> values.put(field.name(), value));
            }
        }
        for (Token token : tokens) {
            if (token instanceof Token.Task task) {
                world.boatOf(task.task()).ifPresent(boat -> allocation.put(task.task(), boat));
            }
        }
        return new Activation(
                world.nextActivation++,
                m.id,
                m.root().id,
                visit.id,
                m.plan.id(),
                visit.place.id(),
                spec.id(),
                spec.type(),
                values,
                taskValues,
                tokens,
                allocation,
                spec.markups(),
                Priority.MEDIUM);
    }

    private Optional<Value> valueOf(Mission m, OutputEventSpec spec, FieldType field, FieldSource source) {
        Optional<Value> value = Optional.empty();
        if (source instanceof FieldSource.Fixed fixed) {
            value = Optional.of(fixed.value());
        } else if (source instanceof FieldSource.Asked) {
            value = Optional.ofNullable(m.asked.get(spec.id() + "." + field.name()));
        } else if (source instanceof FieldSource.FromVariable variable) {
            value = variables.read(m, variable.variable());
        }
        return value.or(field::defaultValue);
    }

    private void readFromTasks(String field, List<Token> tokens, Map<TaskId, Map<String, Value>> taskValues) {
        for (Token token : tokens) {
            if (token instanceof Token.Task task) {
                Value value = world.task(task.task())
                        .map(spec -> spec.fields().get(field))
                        .orElse(null);
                if (value != null) {
                    taskValues
                            .computeIfAbsent(task.task(), key -> new LinkedHashMap<>())
                            .put(field, value);
                }
            }
        }
    }

    /** Writes what output events write (R-ACT-3). */
    private void writeFields(Mission m, OutputEventSpec spec, Activation activation) {
        spec.writes().forEach((field, variable) -> {
            if (spec.fields().get(field) instanceof FieldSource.FromVariable) {
                activation.value(field).ifPresent(value -> variables.write(m, variable, value));
            }
        });
    }

    void startSubMissions(Visit visit) {
        List<Token> tokens = visit.mission.tokensIn(visit.place).stream()
                .filter(c -> c.visit == visit)
                .map(c -> c.token)
                .toList();
        missions.startSubMissions(visit, tokens);
    }

    /** Whether entering these places ends the mission. */
    boolean endsWith(Mission m, List<Visit> entered) {
        return entered.stream().anyMatch(v -> v.place.end() && !returns(m, v.place));
    }

    /** Whether an end place only returns (R-SHR-2). */
    private static boolean returns(Mission m, Place place) {
        return m.asChild.map(i -> i.spec.shared()).orElse(false) && !place.endsSharedInstance();
    }

    /** End places were entered: the mission ends after the firing is complete, or a shared instance returns. */
    void endOrReturn(Mission m, List<Visit> entered) {
        if (endsWith(m, entered)) {
            missions.end(m, Outcome.ENDED);
        } else {
            entered.stream().filter(v -> v.place.end()).forEach(missions::returnFrom);
        }
    }

    // ---- Leaving

    /**
     * Takes copies out of their places. Visits end with their last token; what a running sub-mission was given is withdrawn
     * from it.
     */
    void remove(Mission m, List<Copy> copies) {
        Set<Visit> visits = new LinkedHashSet<>();
        for (Copy copy : copies) {
            m.tokensIn(copy.visit.place).remove(copy);
            visits.add(copy.visit);
        }
        for (Visit visit : visits) {
            boolean empty = m.tokensIn(visit.place).stream().noneMatch(c -> c.visit == visit);
            if (empty) {
                end(visit);
            } else {
                stopTimersOfThoseWhoLeft(visit);
            }
        }
        for (Copy copy : copies) {
            withdraw(m, copy);
        }
    }

    /** Takes a boat out of running instances and their descendants (R-INT-7). */
    private void withdraw(Mission m, Copy copy) {
        if (copy.token instanceof Token.Generic) {
            return;
        }
        if (!m.standsInVisit(copy.token, copy.visit)) {
            copy.visit.instances.stream()
                    .filter(i -> i.state == Instance.State.RUNNING)
                    .forEach(i -> removeEverywhere(i.child, i.toChild(copy.token)));
        }
    }

    /**
     * Copies left otherwise than with a return that brought them back (R-SHR-7); who is still in a shared instance is withdrawn
     * from it.
     */
    void pulled(Mission m, List<Copy> copies, List<Returned> used) {
        Map<Instance, List<Token>> broughtBack = new LinkedHashMap<>();
        used.forEach(
                r -> broughtBack.computeIfAbsent(r.by, key -> new ArrayList<>()).addAll(r.tokens));
        for (Copy copy : copies) {
            for (Instance shared : m.statics) {
                boolean concerned = shared.place.equals(copy.visit.place)
                        && !broughtBack.getOrDefault(shared, new ArrayList<>()).remove(copy.token);
                if (concerned && !voidReturnOf(shared, copy.token)) {
                    shared.joined.remove(copy.token);
                }
                if (concerned && !(copy.token instanceof Token.Generic) && !m.stands(copy.token, copy.visit.place)) {
                    forget(shared, copy.token);
                    if (shared.state == Instance.State.RUNNING) {
                        removeEverywhere(shared.child, shared.toChild(copy.token));
                    }
                }
            }
        }
    }

    /** No copy of a boat or task is there any longer: nothing of it waits to be used. */
    void forget(Instance shared, Token token) {
        boolean struck = true;
        while (struck) {
            struck = voidReturnOf(shared, token);
        }
        shared.joined.removeIf(token::equals);
    }

    private boolean voidReturnOf(Instance shared, Token token) {
        Optional<Returned> oldest =
                shared.returns.stream().filter(r -> r.tokens.contains(token)).findFirst();
        oldest.ifPresent(r -> {
            r.tokens.remove(token);
            world.note(NoteKind.DISCARDED, shared.parent.id, "void return");
            if (r.tokens.isEmpty()) {
                useUp(r);
            }
        });
        return oldest.isPresent();
    }

    /** Some tokens of a return are used; the others stay a return, in its place, and its value is told again. */
    void useUp(Returned returned, List<Token> tokens) {
        List<Token> others = new ArrayList<>(returned.tokens);
        tokens.forEach(others::remove);
        int place = returned.by.returns.indexOf(returned);
        useUp(returned);
        if (!others.isEmpty()) {
            Returned rest = new Returned(returned.by, others, returned.value);
            returned.by.returns.add(place, rest);
            missions.tell(rest);
        }
    }

    /** A return can be used no more, neither what it brought back nor its value. */
    void useUp(Returned returned) {
        returned.usedUp = true;
        returned.by.returns.remove(returned);
        returned.by.parent.pending.removeIf(p -> p.told.equals(Optional.of(returned)));
    }

    void removeEverywhere(Mission m, Token token) {
        m.starting.forEach(waiting -> waiting.removeIf(token::equals));
        m.asChild.ifPresent(
                instance -> instance.toParent(token).ifPresent(theirs -> instance.joined.removeIf(theirs::equals)));
        List<Copy> copies = new ArrayList<>();
        for (Place place : m.plan.places()) {
            m.tokensIn(place).stream().filter(c -> c.token.equals(token)).forEach(copies::add);
        }
        copies.stream().map(c -> new Withdrawn(m, c.visit.place)).distinct().forEach(withdrawn::add);
        if (!copies.isEmpty() && token instanceof Token.Proxy boat) {
            boatsWithdrawn.computeIfAbsent(m, key -> new ArrayList<>()).add(boat.proxy());
        }
        remove(m, copies);
        if (!copies.isEmpty()) {
            world.boatOf(token).ifPresent(boat -> world.effects.add(new Effect.CommandsWithdrawn(m.id, List.of(boat))));
        }
        pulled(m, copies, List.of());
        copies.forEach(c -> c.visit.instances.forEach(i -> i.back.remove(token)));
        attention.strike(m, copies, List.of());
    }

    /** Those who lost tokens in instances are looked at after the firing's own places, from the outside inwards. */
    void lookAtWithdrawn() {
        List<Withdrawn> places = new ArrayList<>(withdrawn);
        withdrawn.clear();
        places.forEach(w -> lookAfterLeaving(w.mission(), w.place()));
    }

    /** Where a filter keeps nobody who is there any longer, all are offered (R-DEC-10). */
    void offerAllWhereFilteredLeft(Mission m) {
        roles.questions.offerAllWhereFilteredLeft(m);
    }

    /** Who was withdrawn from an instance is offered there no longer (R-DEC-8). */
    void askWithoutWithdrawn() {
        roles.questions.askWithout(boatsWithdrawn);
        boatsWithdrawn.clear();
    }

    private void stopTimersOfThoseWhoLeft(Visit visit) {
        world.clocks.removeIf(clock -> clock.timer().isPresent()
                && visit.activations.contains(clock.timer().get())
                && clock.token().isPresent()
                && !visit.mission.standsInVisit(clock.token().get(), visit));
    }

    /** Cancels a visit's timers (R-VIS-5); its questions are no longer open and its instances end with it. */
    void end(Visit visit) {
        if (visit.ended) {
            return;
        }
        visit.ended = true;
        visit.endedAs = ++world.visitsEnded;
        visit.mission.visits.remove(visit);
        world.clocks.removeIf(clock -> clock.timer().isPresent()
                && visit.activations.contains(clock.timer().get()));
        roles.questions.closeQuestions(visit);
        visit.activations.forEach(a -> world.effects.add(new Effect.ActivationEnded(a.id())));
        for (Instance instance : visit.instances) {
            if (instance.state == Instance.State.RUNNING) {
                missions.end(instance.child, Outcome.ABORTED);
            }
        }
    }

    // ---- When a transition is looked at (R-LOOK-1 to R-LOOK-5)

    /** (a) tokens, or nobody, enter; (c) a sub-mission completes or returns; pending ones whenever the place changes. */
    void lookAfterEntry(Mission m, Place place) {
        for (Transition t : m.outTransitions(place)) {
            if (t.inputs().isEmpty() || !m.pendingOf(t).isEmpty()) {
                world.lookAt(m, t);
            }
        }
    }

    /** (b) tokens leave an in place on whose edge it has a requirement that fewer tokens can satisfy. */
    void lookAfterLeaving(Mission m, Place place) {
        for (Transition t : m.outTransitions(place)) {
            boolean fewerCanSatisfy = m.inEdges(t).stream()
                    .filter(e -> e.place().equals(place.id()))
                    .flatMap(e -> e.requirements().stream())
                    .anyMatch(Places::fewerCanSatisfy);
            if (t.inputs().isEmpty() ? fewerCanSatisfy : !m.pendingOf(t).isEmpty()) {
                world.lookAt(m, t);
            }
        }
    }

    private static boolean fewerCanSatisfy(InRequirement r) {
        return r.match() == Match.ZERO || r.match() == Match.LESS_THAN || r.match() == Match.EXACTLY;
    }
}
