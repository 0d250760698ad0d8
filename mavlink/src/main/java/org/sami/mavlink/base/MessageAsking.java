package org.sami.mavlink.base;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongSupplier;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.command.CommandVerdict;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleTable;

/**
 * Asks each vehicle for the messages of its link's plan: when it appears, when others appear on a slow link or have left it for a minute, when it starts again, when it is reached on
 * another link (autopilots keep these requests for each link), and when it has sent no position for seconds. Asks again for a single one that it has not
 * confirmed, while it is heard, ever more seldom; not for one that it refuses. Used by one thread.
 */
final class MessageAsking {
    private static final long SETTLED_MS =
            2_000; // a slow link is planned once no further vehicle has appeared for so long
    private static final long AGAIN_MS = 5_000; // what was asked for may be lost, or be taken back by somebody else

    private static final long UNCONFIRMED_MS =
            5_000; // until one that was not confirmed is asked for again; then double
    private static final long SELDOM_MS = 80_000; // at most
    private static final long LEFT_MS = 60_000; // one that is silent for longer needs no room on its link
    private static final long HEARD_MS = 3_000; // within which a vehicle was heard that may answer

    private final VehicleTable table;
    private final boolean signed;
    private final LongSupplier nowMs;
    private final Map<VehicleId, Asked> asked = new HashMap<>();
    private final Map<MavlinkAddress, Long> changedMs = new HashMap<>();
    private final Map<MavlinkAddress, Integer> counted = new HashMap<>(); // vehicles
    private final Map<MavlinkAddress, MessagePlan> plans = new HashMap<>();

    /** Asks vehicles. */
    interface Requests {
        /** Asks for all messages of a plan, in place of what waits to be asked for. */
        void askAll(VehicleId vehicle, MessagePlan plan, Answered answered);

        /** Asks for one message after what waits to be asked for. */
        void askOne(VehicleId vehicle, AskedMessage message, Answered answered);
    }

    /** Receives once what a vehicle has answered to the request for a message. */
    interface Answered {
        void answered(AskedMessage message, CommandVerdict verdict);
    }

    /** What a vehicle was asked for, where and when, and what of that it has not confirmed. */
    private static final class Asked {
        private final MavlinkAddress link;
        private final MessagePlan plan;
        private final long atMs;
        private final Map<AskedMessage, Long> waitMs =
                new HashMap<>(); // before the last time that each was asked for again
        private final Map<AskedMessage, Long> dueMs = new LinkedHashMap<>();

        Asked(MavlinkAddress link, MessagePlan plan, long atMs) {
            this.link = link;
            this.plan = plan;
            this.atMs = atMs;
        }

        void answered(AskedMessage message, CommandVerdict verdict, long nowMs) {
            if (verdict == CommandVerdict.UNANSWERED || verdict == CommandVerdict.NOT_NOW) {
                long wait = waitMs.merge(message, UNCONFIRMED_MS, (last, first) -> Math.min(SELDOM_MS, 2 * last));
                dueMs.put(message, nowMs + wait);
            }
        }

        /** Those to be asked for again now. */
        List<AskedMessage> takeDue(long nowMs) {
            List<AskedMessage> due = dueMs.entrySet().stream()
                    .filter(one -> nowMs >= one.getValue())
                    .map(Map.Entry::getKey)
                    .toList();
            due.forEach(dueMs::remove);
            return due;
        }
    }

    /**
     * Nothing is asked yet.
     *
     * @param nowMs a clock of milliseconds that only goes on
     */
    MessageAsking(VehicleTable table, boolean signed, LongSupplier nowMs) {
        this.table = table;
        this.signed = signed;
        this.nowMs = nowMs;
    }

    /** A vehicle has appeared or started again. */
    void renew(VehicleId vehicle) {
        asked.remove(vehicle);
        table.linkOf(vehicle).ifPresent(link -> changedMs.put(link, nowMs.getAsLong()));
    }

    /** The plan of a link for the vehicles that are reached on it now, and were heard within a minute. */
    MessagePlan plan(MavlinkAddress link) {
        long now = nowMs.getAsLong();
        int vehicles = (int) table.ids().stream()
                .filter(id -> isThere(id, now) && table.linkOf(id).equals(Optional.of(link)))
                .count();
        Integer before = counted.put(link, vehicles);
        if (before != null && before != vehicles) {
            changedMs.put(link, now);
        }
        MessagePlan known = plans.get(link);
        OptionalInt baud = table.radios().speedBaud(link);
        if (known == null || !known.isFor(baud, vehicles)) {
            known = MessagePlan.of(baud, vehicles, signed);
            plans.put(link, known);
        }
        return known;
    }

    private boolean isThere(VehicleId vehicle, long now) {
        return table.isHeard(vehicle, now, LEFT_MS);
    }

    /** The plan of each link, in the order given. */
    Map<MavlinkAddress, MessagePlan> plans(List<MavlinkAddress> links) {
        Map<MavlinkAddress, MessagePlan> plans = new LinkedHashMap<>();
        links.forEach(link -> plans.put(link, plan(link)));
        return plans;
    }

    /** Sends the requests of the present plan to the vehicles that have not had them, or have not confirmed them. */
    void tick(Requests requests) {
        long now = nowMs.getAsLong();
        Map<MavlinkAddress, MessagePlan> present = new HashMap<>();
        for (VehicleId vehicle : List.copyOf(table.ids())) {
            table.linkOf(vehicle).ifPresent(link -> {
                MessagePlan plan = present.computeIfAbsent(link, this::plan);
                Asked before = asked.get(vehicle);
                boolean settled = !plan.isTight() || now >= changedMs.getOrDefault(link, now) + SETTLED_MS;
                boolean other = before == null
                        || !before.link.equals(link)
                        || !before.plan.messages().equals(plan.messages())
                        || before.plan.isTight() != plan.isTight() // a radio has reported itself there
                        || (table.isPositionOld(vehicle) && now - before.atMs >= AGAIN_MS);
                if (other && settled && isThere(vehicle, now)) {
                    Asked all = new Asked(link, plan, now);
                    asked.put(vehicle, all);
                    requests.askAll(vehicle, plan, answered(all));
                } else if (before != null && table.isHeard(vehicle, now, HEARD_MS)) {
                    before.takeDue(now).forEach(message -> requests.askOne(vehicle, message, answered(before)));
                }
            });
        }
    }

    private Answered answered(Asked all) {
        return (message, verdict) -> all.answered(message, verdict, nowMs.getAsLong());
    }
}
