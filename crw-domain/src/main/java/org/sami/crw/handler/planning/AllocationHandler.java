package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.Allocation;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.handler.activation.Markups;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.PlannedSwaps;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.message.MessageSink;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.allocation.AllocationProblem;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.allocation.Candidate;
import org.sami.crw.service.allocation.Division;
import org.sami.crw.service.allocation.Unallocated;
import org.sami.crw.service.water.Water;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Allocation Request: divides locations or tasks among boats with the algorithm that fits the markup Optimize best, in as many ways as the markup
 * Selection Options asks for. If possible no path is longer than its boat's charge lasts, with the way home. Distances are of ways around areas to
 * avoid. The answer and a message to the operator name work that no boat can do. A boat without a known position gets no work, and the operator is
 * notified.
 */
public final class AllocationHandler implements ActivationHandler {
    public static final String TYPE = "AllocationRequest";

    private final AllocationService service;
    private final BoatPositions positions;
    private final BoatReach reach;
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;

    /**
     * A handler.
     *
     * @param reach how far and how fast each boat gets, and where it returns to
     */
    public AllocationHandler(
            AllocationService service,
            BoatPositions positions,
            BoatReach reach,
            MessageSink messages,
            Computations computations,
            BoatErrors errors) {
        this.service = service;
        this.positions = positions;
        this.reach = reach;
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) throws Exception {
        AllocationQuestion question = AllocationQuestion.of(
                activation, context, positions, reach, PlannedSwaps.keepWaysHome(activation, context));
        if (!question.unknown().isEmpty()) {
            tell(
                    activation,
                    context,
                    Priority.HIGH,
                    "Nothing was allocated to boats whose position is not known yet: "
                            + String.join(", ", question.unknown()),
                    question.unknown());
        }
        AllocationProblem problem = question.problem();
        Candidate first = problem.boats().get(0);
        List<String> boats = problem.boats().stream().map(Candidate::boat).toList();
        Water water = context.query(view -> PlanAreas.water(activation, view, first.at(), errors.of(boats)));
        computations.compute(activation, context, new Computations.Task<AllocationService.Options>() {
            @Override
            public String what() {
                return "the allocation of " + problem.work().size() + " locations";
            }

            @Override
            public AllocationService.Options compute() {
                return service.solve(
                        problem.in(water), Markups.criterion(activation), Markups.requestedOptions(activation));
            }

            @Override
            public void found(AllocationService.Options options) {
                answer(activation, context, question, options);
            }
        });
    }

    private void answer(
            Activation activation,
            HandlerContext context,
            AllocationQuestion question,
            AllocationService.Options options) {
        options.best()
                .shortfall()
                .ifPresent(words -> tell(activation, context, Priority.HIGH, "Allocation: " + words, List.of()));
        List<Unallocated> unallocated = options.best().unallocated();
        if (!unallocated.isEmpty()) {
            String words = String.join(
                    "; ", unallocated.stream().map(Unallocated::words).toList());
            tell(activation, context, Priority.HIGH, words, List.of());
        }
        if (Markups.criterion(activation).isPresent()) {
            tell(activation, context, Priority.LOW, "Allocation: " + options.reason(), List.of());
        }
        List<Value> values = new ArrayList<>();
        for (int i = 0; i < options.divisions().size(); i++) {
            values.add(toValue(options.divisions().get(i), options.reasons().get(i), question));
        }
        context.post(new Input.Received(answer(activation, context, Map.of("allocations", new ListValue(values)))));
    }

    private static Value toValue(Division division, String reason, AllocationQuestion question) {
        Map<TaskId, String> tasks = new LinkedHashMap<>(); // in the order in which each boat is to do them
        division.boatOf()
                .forEach((name, boat) ->
                        Optional.ofNullable(question.tasks().get(name)).ifPresent(task -> tasks.put(task, boat)));
        Allocation allocation = question.anew() ? division.toAllocation(reason) : division.toNewWork(reason);
        return allocation.withTasks(tasks).toValue();
    }

    private void tell(
            Activation activation, HandlerContext context, Priority priority, String text, List<String> boats) {
        messages.tell(ActivationMessages.of(activation, context, priority, text, boats));
    }

    /** Names the boats where their own tokens entered, otherwise the tasks: the named tokens move on. */
    private static Occurrence answer(Activation activation, HandlerContext context, Map<String, Value> values) {
        List<Addressee> addressees = Addressee.of(activation, context);
        List<String> boats = addressees.stream().map(Addressee::boat).toList();
        boolean byProxy = addressees.stream().anyMatch(Addressee::byProxy);
        List<TaskId> tasks = byProxy ? List.of() : activation.tasks();
        return Occurrence.answer(EventNames.ALLOCATION_RESPONSE, activation, boats, tasks, values);
    }
}
