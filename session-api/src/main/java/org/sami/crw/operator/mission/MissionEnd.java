package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Priority;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What the end of a mission takes from boats and from the operator as things stand now: said before it is aborted or completed. Where the
 * plan intercepts it (rule R-END-1), its transition decides what comes first, and this is what comes at the latest.
 *
 * @param boats those that lose a command, in the order of the boats
 * @param decisions those that wait for the operator and are withdrawn
 * @param subMissions those that run and end with it
 */
public record MissionEnd(List<BoatChange> boats, List<PendingDecision> decisions, List<MissionSnapshot> subMissions) {
    /**
     * The losses of one boat.
     *
     * @param inForce the running command that it loses; empty where only waiting commands are withdrawn
     * @param waiting number of waiting commands that are withdrawn
     * @param next its next command; empty where there is none, so that it stops
     */
    public record BoatChange(String boat, Optional<Entry> inForce, int waiting, Optional<Entry> next) {
        public BoatChange {
            Objects.requireNonNull(boat, "boat");
            Objects.requireNonNull(inForce, "inForce");
            Objects.requireNonNull(next, "next");
        }
    }

    public MissionEnd {
        boats = List.copyOf(boats);
        decisions = List.copyOf(decisions);
        subMissions = List.copyOf(subMissions);
    }

    /** What the end of a mission would do now. */
    public static MissionEnd of(
            long mission, MissionsSnapshot missions, List<BoatCommands> commands, List<PendingDecision> decisions) {
        Set<Long> family = new HashSet<>(Set.of(mission));
        List<MissionSnapshot> children = new ArrayList<>();
        for (MissionSnapshot each : missions.running()) { // a child was created after its parent
            if (family.contains(each.parent())) {
                family.add(each.id());
                children.add(each);
            }
        }
        List<BoatChange> boats = new ArrayList<>();
        commands.forEach(each -> of(each, family).ifPresent(boats::add));
        return new MissionEnd(
                boats,
                decisions.stream()
                        .filter(one -> family.contains(one.decision().mission()))
                        .toList(),
                children);
    }

    private static Optional<BoatChange> of(BoatCommands boat, Set<Long> family) {
        CommandQueueSnapshot queue = boat.queue();
        Optional<Entry> lost = queue.current().filter(entry -> isOf(entry, family));
        List<Entry> stays =
                queue.waiting().stream().filter(entry -> !isOf(entry, family)).toList();
        int waiting = queue.waiting().size() - stays.size();
        if (lost.isEmpty() && waiting == 0) {
            return Optional.empty();
        }
        Optional<Entry> next = lost.isPresent()
                ? stays.stream().filter(entry -> passes(entry, queue, family)).findFirst()
                : queue.current();
        return Optional.of(new BoatChange(boat.boat(), lost, waiting, next));
    }

    private static boolean isOf(Entry entry, Set<Long> family) {
        return family.contains(entry.command().mission());
    }

    /** Whether no block keeps a command from its turn once those of the ended missions are gone. */
    private static boolean passes(Entry entry, CommandQueueSnapshot queue, Set<Long> family) {
        return queue.blockedBy().isEmpty()
                || family.contains(queue.blockedBy().getAsLong())
                || queue.blockedBy().getAsLong() == entry.command().mission()
                || entry.command().priority() == Priority.CRITICAL;
    }

    /** The transition of a plan that may intercept an abort (or a completion), and so say what comes first. */
    public static Optional<Transition> interceptor(Plan plan, Vocabulary vocabulary, boolean abort) {
        EventRole role = abort ? EventRole.ABORT_RECEIVED : EventRole.COMPLETE_RECEIVED;
        return plan.transitions().stream()
                .filter(transition -> transition.inputs().stream()
                        .anyMatch(input -> vocabulary
                                .event(input.type())
                                .map(type -> type.role() == role)
                                .orElse(false)))
                .findFirst();
    }
}
