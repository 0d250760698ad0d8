package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.event.Allocation;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.Candidate;
import org.sami.crw.service.allocation.Reassignment;
import org.sami.crw.service.allocation.WorkItem;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * An Allocation Request as a problem.
 *
 * @param tasks the tasks among the work, by the work's name
 * @param anew whether it divides an earlier allocation again: paths then begin with the work that boats have begun
 * @param unknown boats without a known position, which get no work
 */
record AllocationQuestion(AllocationProblem problem, Map<String, TaskId> tasks, boolean anew, List<String> unknown) {
    private static final String LOCATIONS = "locations";
    private static final String LOCATION = "location";
    private static final String NEEDS = "needs";
    private static final String OFFERS = "offers";
    private static final String PREVIOUS = "previous";

    /**
     * Reads the request. The work is the rest of the field {@code previous}, otherwise the field {@code locations}, otherwise the entering tasks. The
     * boats are those that entered, or those of the mission where only tasks did; robots that fly are left out.
     *
     * @param reach how far and how fast each boat gets, and where it returns to
     * @param keepWaysHome whether charges have to last for the ways home too
     */
    static AllocationQuestion of(
            Activation activation,
            HandlerContext context,
            BoatPositions positions,
            BoatReach reach,
            boolean keepWaysHome) {
        Optional<Allocation> previous = activation.value(PREVIOUS).map(Allocation::of);
        Map<String, TaskId> tasks =
                previous.isPresent() || activation.value(LOCATIONS).isPresent() ? Map.of() : tasks(activation);
        Map<String, List<WorkItem>> left =
                previous.map(one -> left(one, activation, context)).orElse(Map.of());
        List<Candidate> candidates = new ArrayList<>();
        List<String> unknown = new ArrayList<>();
        Set<String> boats = boats(activation, context);
        if (boats.removeIf(reach::isFlying) && boats.isEmpty()) {
            throw new IllegalArgumentException("Only robots that fly are there: nobody to allocate to");
        }
        for (String boat : boats) {
            List<WorkItem> begun = previous.isPresent()
                    ? left.getOrDefault(boat, List.of()).stream().limit(1).toList()
                    : otherTasks(boat, activation, context);
            positions
                    .positionOf(boat)
                    .ifPresentOrElse(
                            at -> candidates.add(new Candidate(
                                    boat,
                                    at,
                                    BoatDemands.offers(offers(boat, activation), reach.capabilities(boat), false),
                                    begun,
                                    reach.rangeM(boat),
                                    keepWaysHome ? reach.home(boat) : Optional.empty(),
                                    reach.cruiseMps(boat),
                                    reach.turningRadiusM(boat))),
                            () -> unknown.add(boat));
        }
        if (candidates.isEmpty()) {
            throw new IllegalStateException("No boat's position is known yet: " + unknown);
        }
        AllocationProblem problem = previous.isPresent()
                ? Reassignment.of(candidates, left)
                : new AllocationProblem(candidates, work(activation, context, tasks));
        return new AllocationQuestion(problem, tasks, previous.isPresent(), unknown);
    }

    private static Set<String> boats(Activation activation, HandlerContext context) {
        List<Addressee> addressees = Addressee.of(activation, context);
        Set<String> boats = new LinkedHashSet<>();
        addressees.forEach(addressee -> boats.add(addressee.boat()));
        if (addressees.stream().noneMatch(Addressee::byProxy)
                && !activation.tasks().isEmpty()) {
            boats.addAll(context.query(view -> ofMission(activation.mission(), view)));
        }
        if (boats.isEmpty()) {
            throw new IllegalArgumentException("No boat entered " + activation.place() + ": nobody to allocate to");
        }
        return boats;
    }

    private static Set<String> ofMission(long mission, EngineView view) {
        Set<String> boats = new LinkedHashSet<>();
        view.mission(mission)
                .ifPresent(one -> one.marking()
                        .values()
                        .forEach(tokens -> tokens.forEach(token -> {
                            if (token instanceof Token.Proxy proxy) {
                                boats.add(proxy.proxy());
                            }
                        })));
        return boats.isEmpty() ? new LinkedHashSet<>(view.proxies()) : boats;
    }

    private static Map<String, TaskId> tasks(Activation activation) {
        Map<String, TaskId> tasks = new LinkedHashMap<>();
        activation.tasks().forEach(task -> tasks.put(name(task, activation), task));
        return tasks;
    }

    private static String name(TaskId task, Activation activation) {
        return task.mission() == activation.mission() ? task.name() : task.name() + " of mission " + task.mission();
    }

    private static List<WorkItem> work(Activation activation, HandlerContext context, Map<String, TaskId> tasks) {
        List<WorkItem> work = new ArrayList<>();
        if (tasks.isEmpty()) {
            for (GeoPoint location :
                    ActivationFields.points(ActivationFields.required(activation, LOCATIONS), LOCATIONS)) {
                work.add(WorkItem.visit("location " + (work.size() + 1), location));
            }
        } else {
            tasks.forEach((name, task) -> work.add(work(name, fields(task, context))));
        }
        return work;
    }

    private static Map<String, Value> fields(TaskId task, HandlerContext context) {
        return context.query(view -> view.task(task)).orElse(Map.of());
    }

    private static WorkItem work(String name, Map<String, Value> fields) {
        Value location = Optional.ofNullable(fields.get(LOCATION))
                .orElseThrow(() -> new IllegalArgumentException("The task " + name + " has no location"));
        Set<String> needs = Optional.ofNullable(fields.get(NEEDS))
                .map(value -> texts(value, NEEDS))
                .orElse(Set.of());
        return new WorkItem(name, ActivationFields.point(location, LOCATION), needs);
    }

    /** The tasks of the mission that a boat has already and that did not enter: it does them first. */
    private static List<WorkItem> otherTasks(String boat, Activation activation, HandlerContext context) {
        Map<TaskId, String> allocation = context.query(EngineView::allocation);
        List<WorkItem> others = new ArrayList<>();
        allocation.forEach((task, whose) -> {
            boolean other = task.mission() == activation.mission()
                    && !activation.tasks().contains(task);
            if (whose.equals(boat) && other && fields(task, context).containsKey(LOCATION)) {
                others.add(work(task.name(), fields(task, context)));
            }
        });
        return others;
    }

    /** What is not visited yet of each boat's path, as far as this mission knows. */
    private static Map<String, List<WorkItem>> left(
            Allocation previous, Activation activation, HandlerContext context) {
        Map<String, List<WorkItem>> left = new LinkedHashMap<>();
        previous.paths().forEach((boat, path) -> left.put(boat, left(boat, path, activation, context)));
        return left;
    }

    private static List<WorkItem> left(String boat, GeoPath path, Activation activation, HandlerContext context) {
        int size = path.points().size();
        int visited = PathProgress.visited(context, activation.mission(), PathProgress.key(boat, path), size);
        List<WorkItem> left = new ArrayList<>();
        for (int i = visited; i < size; i++) {
            left.add(WorkItem.visit(
                    "location " + (i + 1) + " of " + boat, path.points().get(i)));
        }
        return left;
    }

    private static Set<String> offers(String boat, Activation activation) {
        return activation
                .value(OFFERS)
                .map(value -> ProxyMaps.read(value, ListValue.class).get(boat))
                .map(value -> texts(value, OFFERS))
                .orElse(Set.of());
    }

    private static Set<String> texts(Value value, String field) {
        Set<String> texts = new LinkedHashSet<>();
        if (!(value instanceof ListValue list)) {
            throw new IllegalArgumentException("\"" + field + "\" is no list of texts: " + value);
        }
        for (Value item : list.items()) {
            if (!(item instanceof TextValue text)) {
                throw new IllegalArgumentException("\"" + field + "\" is no list of texts: " + value);
            }
            texts.add(text.value());
        }
        return texts;
    }
}
