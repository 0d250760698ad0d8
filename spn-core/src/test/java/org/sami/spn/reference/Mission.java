package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** A running instance of a plan, root or child. */
final class Mission {
    enum Status {
        WAITING,
        RUNNING,
        HALTED,
        ENDED
    }

    final long id;
    final Plan plan;
    /** That of its root, with which it started. */
    final Project project;

    final int projectVersion;
    final String name;
    /** How the parent sees this mission; empty for a root. */
    final Optional<Instance> asChild;

    Status status = Status.WAITING;
    /** What enters its start place once its parameters have been given: of a shared instance, entry by entry. */
    final List<List<Token>> starting = new ArrayList<>();

    boolean startsWithTokens;
    final Map<String, Value> asked = new LinkedHashMap<>();
    final Map<String, Value> variables = new LinkedHashMap<>();
    final Map<String, Value> memory = new LinkedHashMap<>();
    final Map<String, TaskSpec> tasks = new LinkedHashMap<>();
    /** Of a child: its tasks that stand for ones of its parents. */
    final Map<String, TaskId> standsFor = new LinkedHashMap<>();

    final Map<String, List<Copy>> marking = new LinkedHashMap<>();
    final List<Visit> visits = new ArrayList<>();
    final List<Pending> pending = new ArrayList<>();
    final List<Instance> statics = new ArrayList<>();
    Optional<Value> returnValue = Optional.empty();
    /** Its firing into an end place has withdrawn its commands already. */
    boolean commandsWithdrawn;

    boolean abortAsked;
    boolean completionAsked;
    /** Firings since the last input; a chain that is too long is a livelock. */
    int chain;

    Mission(long id, Plan plan, World world, String name, Optional<Instance> asChild) {
        this.id = id;
        this.plan = plan;
        this.name = name;
        this.asChild = asChild;
        this.project = parent().map(p -> p.project).orElse(world.project);
        this.projectVersion = parent().map(p -> p.projectVersion).orElse(world.projectVersion);
        plan.places().forEach(place -> marking.put(place.id(), new ArrayList<>()));
    }

    Optional<Mission> parent() {
        return asChild.map(instance -> instance.parent);
    }

    Mission root() {
        return parent().map(Mission::root).orElse(this);
    }

    boolean reacts() {
        return status == Status.RUNNING;
    }

    List<Copy> tokensIn(Place place) {
        return marking.get(place.id());
    }

    Place place(String placeId) {
        return plan.place(placeId).orElseThrow();
    }

    /** In places of a transition, each once, in in-edge order. */
    List<Place> inPlaces(Transition t) {
        return plan.inEdgesOf(t.id()).stream()
                .map(InEdge::place)
                .distinct()
                .map(this::place)
                .toList();
    }

    List<InEdge> inEdges(Transition t) {
        return plan.inEdgesOf(t.id());
    }

    List<OutEdge> outEdges(Transition t) {
        return plan.outEdgesOf(t.id());
    }

    /** A place's out-transitions in the plan's order (R-LOOK-6). */
    List<Transition> outTransitions(Place place) {
        List<String> ids = new ArrayList<>(place.transitionOrder());
        for (InEdge edge : plan.inEdges()) {
            if (edge.place().equals(place.id()) && !ids.contains(edge.transition())) {
                ids.add(edge.transition());
            }
        }
        return ids.stream().map(tid -> plan.transition(tid).orElseThrow()).toList();
    }

    boolean visitedByNobody(Place place) {
        return visits.stream().anyMatch(v -> v.byNobody && v.place.equals(place));
    }

    /** Whether a copy of this token stands in this place, whatever else is true of it. */
    boolean stands(Token token, Place place) {
        return tokensIn(place).stream().anyMatch(copy -> copy.token.equals(token));
    }

    boolean stands(Token token) {
        return plan.places().stream().anyMatch(place -> stands(token, place));
    }

    boolean standsInVisit(Token token, Visit visit) {
        return tokensIn(visit.place).stream().anyMatch(copy -> copy.visit == visit && copy.token.equals(token));
    }

    List<Pending> pendingOf(Transition t) {
        return pending.stream().filter(p -> p.transition.equals(t)).toList();
    }

    /** Instances on a place: the shared ones, and those of its visits. */
    List<Instance> instancesOn(Place place) {
        List<Instance> found = new ArrayList<>();
        statics.stream().filter(i -> i.place.equals(place)).forEach(found::add);
        visits.stream().filter(v -> v.place.equals(place)).forEach(v -> found.addAll(v.instances));
        return found;
    }
}
