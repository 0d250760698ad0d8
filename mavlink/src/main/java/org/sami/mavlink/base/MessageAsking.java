package org.sami.mavlink.base;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleTable;

/**
 * Asks each vehicle for the messages of its link's plan: when it appears, when others appear on a slow link, when it starts again, when it is reached on
 * another link (autopilots keep these requests for each link), and when it has sent no position for seconds. Used by one thread.
 */
final class MessageAsking {
    private static final long SETTLED_MS =
            2_000; // a slow link is planned once no further vehicle has appeared for so long
    private static final long AGAIN_MS = 5_000; // what was asked for may be lost, or be taken back by somebody else

    private final VehicleTable table;
    private final boolean signed;
    private final Map<VehicleId, Asked> asked = new HashMap<>();
    private final Map<MavlinkAddress, Long> changedMs = new HashMap<>();
    private final Map<MavlinkAddress, MessagePlan> plans = new HashMap<>();

    /** What a vehicle was asked for, where and when. */
    private record Asked(MavlinkAddress link, MessagePlan plan, long atMs) {}

    MessageAsking(VehicleTable table, boolean signed) {
        this.table = table;
        this.signed = signed;
    }

    /** A vehicle has appeared or started again. */
    void renew(VehicleId vehicle, long nowMs) {
        asked.remove(vehicle);
        table.linkOf(vehicle).ifPresent(link -> changedMs.put(link, nowMs));
    }

    /** The plan of a link for the vehicles that are reached on it now. */
    MessagePlan plan(MavlinkAddress link) {
        int vehicles = (int) table.ids().stream()
                .filter(id -> table.linkOf(id).equals(Optional.of(link)))
                .count();
        MessagePlan known = plans.get(link);
        OptionalInt baud = table.radios().speedBaud(link);
        if (known == null || !known.isFor(baud, vehicles)) {
            known = MessagePlan.of(baud, vehicles, signed);
            plans.put(link, known);
        }
        return known;
    }

    /** The plan of each link, in the order given. */
    Map<MavlinkAddress, MessagePlan> plans(List<MavlinkAddress> links) {
        Map<MavlinkAddress, MessagePlan> plans = new LinkedHashMap<>();
        links.forEach(link -> plans.put(link, plan(link)));
        return plans;
    }

    /** Sends the requests of the present plan to the vehicles that have not had them. */
    void tick(long nowMs, BiConsumer<VehicleId, MessagePlan> ask) {
        Map<MavlinkAddress, MessagePlan> present = new HashMap<>();
        for (VehicleId vehicle : List.copyOf(table.ids())) {
            table.linkOf(vehicle).ifPresent(link -> {
                MessagePlan plan = present.computeIfAbsent(link, this::plan);
                Asked before = asked.get(vehicle);
                boolean settled = !plan.isTight() || nowMs >= changedMs.getOrDefault(link, nowMs) + SETTLED_MS;
                boolean other = before == null
                        || !before.link().equals(link)
                        || !before.plan().messages().equals(plan.messages())
                        || before.plan().isTight() != plan.isTight() // a radio has reported itself there
                        || (table.isPositionOld(vehicle) && nowMs - before.atMs() >= AGAIN_MS);
                if (other && settled) {
                    asked.put(vehicle, new Asked(link, plan, nowMs));
                    ask.accept(vehicle, plan);
                }
            });
        }
    }
}
