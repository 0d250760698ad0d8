package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.value.TaskId;

/** The moves that are not in a boat's queue yet: they wait for the boats' positions or for the operator. For the fleet's thread. */
final class HeldMoves {
    private final WayQuestions questions;
    private final MovesAwaitingPosition awaitingPosition;

    HeldMoves(WayQuestions questions, MovesAwaitingPosition awaitingPosition) {
        this.questions = questions;
        this.awaitingPosition = awaitingPosition;
    }

    /** The missions that have moves here for a boat. */
    Set<Long> missions(String boat) {
        return all().filter(one -> one.boat().equals(boat))
                .map(HeldMove::mission)
                .collect(Collectors.toSet());
    }

    /** Whether a command is here. */
    boolean has(String commandId) {
        return all().anyMatch(one -> one.move().command().commandId().equals(commandId));
    }

    private Stream<HeldMove> all() {
        return Stream.concat(questions.moves(), awaitingPosition.moves());
    }

    /** Takes moves out. */
    List<HeldMove> take(Predicate<HeldMove> which) {
        return reduce(one -> which.test(one) ? Optional.empty() : Optional.of(one));
    }

    /** Takes out those of a boat that are for tasks of these names alone; those that are for others too stay for those. */
    List<HeldMove> release(String boat, List<TaskId> names) {
        return reduce(one -> one.boat().equals(boat) ? one.without(names) : Optional.of(one));
    }

    private List<HeldMove> reduce(Function<HeldMove, Optional<HeldMove>> left) {
        List<HeldMove> taken = new ArrayList<>(questions.reduce(left));
        taken.addAll(awaitingPosition.reduce(left));
        return taken;
    }
}
