package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.decision.MessageSink;
import org.sami.crw.decision.OperatorMessage;
import org.sami.crw.service.AllocationAlgorithm;
import org.sami.crw.service.AllocationProblem;
import org.sami.crw.service.BoatPositions;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Allocation Request: divides locations among the boats that entered, once by each algorithm, the best first as the algorithms are
 * ordered. The locations are those of the field, or where it has none those of the tasks that entered. A boat whose position
 * is not known yet gets nothing, and the operator is told.
 */
final class AllocationHandler implements ActivationHandler {
    static final String TYPE = "AllocationRequest";
    private static final String LOCATIONS = "locations";
    private static final String LOCATION = "location";

    private final List<AllocationAlgorithm> algorithms;
    private final BoatPositions positions;
    private final MessageSink messages;

    AllocationHandler(List<AllocationAlgorithm> algorithms, BoatPositions positions, MessageSink messages) {
        this.algorithms = List.copyOf(algorithms);
        this.positions = positions;
        this.messages = messages;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Addressee> addressees = Addressee.of(activation, context);
        if (addressees.isEmpty()) {
            throw new IllegalArgumentException("No boat entered " + activation.place() + ": nobody to allocate to");
        }
        AllocationProblem problem =
                new AllocationProblem(boats(addressees, activation, context), locations(activation, context));
        List<Value> options = new ArrayList<>();
        algorithms.forEach(algorithm -> options.add(algorithm.allocate(problem).toValue()));
        Map<String, Value> values = Map.of("allocations", new ListValue(options));
        context.post(new Input.Received(answer(activation, addressees, values)));
    }

    private Map<String, GeoPoint> boats(List<Addressee> addressees, Activation activation, HandlerContext context) {
        Map<String, GeoPoint> known = new LinkedHashMap<>();
        List<String> unknown = new ArrayList<>();
        for (Addressee addressee : addressees) {
            Optional<GeoPoint> position = positions.positionOf(addressee.boat());
            position.ifPresentOrElse(at -> known.put(addressee.boat(), at), () -> unknown.add(addressee.boat()));
        }
        if (known.isEmpty()) {
            throw new IllegalStateException("No boat's position is known yet: " + unknown);
        }
        if (!unknown.isEmpty()) {
            messages.tell(new OperatorMessage(
                    context.nowMillis(),
                    activation.mission(),
                    OperatorMessage.Source.DOMAIN,
                    Priority.HIGH,
                    "Nothing was allocated to boats whose position is not known yet: " + String.join(", ", unknown),
                    unknown,
                    ""));
        }
        return known;
    }

    private static List<GeoPoint> locations(Activation activation, HandlerContext context) {
        Optional<Value> given = activation.value(LOCATIONS);
        if (given.isPresent()) {
            return Fields.points(given.get(), LOCATIONS);
        }
        List<GeoPoint> locations = new ArrayList<>();
        for (TaskId task : activation.tasks()) {
            Map<String, Value> fields = context.query(view -> view.task(task)).orElse(Map.of());
            Value location = Optional.ofNullable(fields.get(LOCATION))
                    .orElseThrow(() -> new IllegalArgumentException("The task " + task.name() + " has no location"));
            locations.add(Fields.point(location, LOCATION));
        }
        if (locations.isEmpty()) {
            Fields.required(activation, LOCATIONS);
        }
        return locations;
    }

    /** Names the boats where their own tokens entered, else the tasks: whoever is named moves on. */
    private static Occurrence answer(Activation activation, List<Addressee> addressees, Map<String, Value> values) {
        List<String> boats = addressees.stream().map(Addressee::boat).toList();
        boolean byProxy = addressees.stream().anyMatch(Addressee::byProxy);
        List<TaskId> tasks = byProxy ? List.of() : activation.tasks();
        return Occurrence.answer(EventNames.ALLOCATION_RESPONSE, activation, boats, tasks, values);
    }
}
