package org.sami.crw.mavlink;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** One MAVLink address with the vehicles that are heard there, and the base's connections to them. For the gateway's thread. */
final class VehicleLink {
    private static final int EVERY_VEHICLE = 256; // port of an address without a number
    private static final String ARDUPILOT = "ArduPilot";
    static final long HEARD_MS = 2_000; // a vehicle that was heard within it is there
    private static final long TRY_MS = 4_000;

    private final String address;
    private final Executor thread;
    private final LongSupplier nowMs;
    private final VehicleFiles files;
    private final SeenTargets seen;
    private final MavlinkBase base;
    private final Consumer<VehicleEvent> events = this::heard;
    private final Map<Integer, VehicleBoat> boats = new TreeMap<>(); // by system id
    private final List<Waiting> waiting = new ArrayList<>();
    private final List<Several> several = new ArrayList<>();
    private List<VehicleSnapshot> vehicles = List.of();
    private SessionFence fence; // that each vehicle is to hold
    private boolean asked; // for the vehicles, and not answered

    /** A connection to a vehicle that is not heard yet. */
    private record Waiting(VehicleConnection connection, long untilMs) {}

    /** A connection that asks for all vehicles, and those that were reported to it. */
    private record Several(VehicleConnection connection, Set<Integer> found, long untilMs) {}

    /**
     * A link.
     *
     * @param address as users write it
     * @param base listens at this address alone; closed with the link
     * @param seen numbers the targets of all vehicles of the session
     */
    VehicleLink(
            String address,
            MavlinkBase base,
            Executor thread,
            LongSupplier nowMs,
            VehicleFiles files,
            SeenTargets seen,
            SessionFence fence) {
        this.address = address;
        this.thread = thread;
        this.nowMs = nowMs;
        this.files = files;
        this.seen = seen;
        this.fence = fence;
        this.base = base;
        base.addListener(events);
    }

    /** The fence that each vehicle is to hold by itself from now on. */
    void keepTo(SessionFence area) {
        fence = area;
        boats.values().forEach(boat -> boat.keepTo(area));
    }

    void add(VehicleConnection connection, long now) {
        if (connection.address().getPort() == EVERY_VEHICLE) {
            several.add(new Several(connection, new TreeSet<>(), now + TRY_MS));
        } else {
            waiting.add(new Waiting(connection, now + TRY_MS));
        }
    }

    /** Called on the thread of the MAVLink base. */
    private void heard(VehicleEvent event) {
        thread.execute(() -> Optional.ofNullable(boats.get(event.vehicle().system()))
                .ifPresent(boat -> boat.happened(event, nowMs.getAsLong())));
    }

    void tick() {
        if (!asked) {
            asked = true;
            Results.when(
                    base.vehicles(),
                    thread,
                    now -> {
                        asked = false;
                        take(now, nowMs.getAsLong());
                    },
                    why -> asked = false);
        }
    }

    private void take(List<VehicleSnapshot> now, long atMs) {
        vehicles = now;
        for (VehicleSnapshot vehicle : now) {
            if (isCommanded(vehicle)) {
                GuardedWork.run(() -> boats.computeIfAbsent(vehicle.id().system(), number -> boat(vehicle))
                        .reported(vehicle, atMs));
            }
        }
        boats.values().forEach(boat -> GuardedWork.run(() -> boat.tick(atMs)));
        List.copyOf(waiting).forEach(one -> GuardedWork.run(() -> look(one, atMs)));
        List.copyOf(several).forEach(one -> GuardedWork.run(() -> look(one, atMs)));
    }

    private VehicleBoat boat(VehicleSnapshot vehicle) {
        VehicleBoat boat = new VehicleBoat(base, vehicle, thread, files, seen);
        boat.keepTo(fence);
        return boat;
    }

    private static boolean isCommanded(VehicleSnapshot vehicle) {
        return whyNot(vehicle).isEmpty();
    }

    /** Why a vehicle is not commanded from here; empty for one that is. */
    private static Optional<String> whyNot(VehicleSnapshot vehicle) {
        boolean isOfKind = switch (vehicle.kind()) {
            case BOAT, ROVER, COPTER -> true;
            default -> false;
        };
        if (!isOfKind) {
            return Optional.of("vehicle " + vehicle.id() + " is a "
                    + vehicle.kind().word() + ", and here only boats and copters are commanded");
        }
        return vehicle.autopilot().equals(ARDUPILOT)
                ? Optional.empty()
                : Optional.of("vehicle " + vehicle.id() + " has the autopilot " + vehicle.autopilot()
                        + ", and here only " + ARDUPILOT + "'s vehicles are commanded: their modes are known");
    }

    private void look(Waiting one, long atMs) {
        if (one.connection.isOver()) {
            waiting.remove(one);
            return;
        }
        Optional<VehicleSnapshot> heard = heard(one.connection.address().getPort(), atMs);
        Optional<VehicleBoat> boat = heard.map(vehicle -> boats.get(vehicle.id().system()));
        if (boat.filter(VehicleBoat::isKnown).isPresent() && fault().isEmpty()) {
            waiting.remove(one);
            boat.get().connect(one.connection, atMs);
        } else if (heard.flatMap(VehicleLink::whyNot).isPresent()) {
            waiting.remove(one);
            one.connection.end(heard.flatMap(VehicleLink::whyNot).get());
        } else if (atMs > one.untilMs) {
            waiting.remove(one);
            one.connection.end(whyNot("vehicle " + one.connection.address().getPort(), atMs));
        }
    }

    private Optional<VehicleSnapshot> heard(int system, long atMs) {
        return vehicles.stream()
                .filter(vehicle -> vehicle.id().system() == system && atMs - vehicle.heardMs() <= HEARD_MS)
                .findFirst();
    }

    private void look(Several all, long atMs) {
        if (all.connection.isOver() && all.found.isEmpty()) {
            several.remove(all);
            return;
        }
        for (VehicleSnapshot vehicle : vehicles) {
            if (isCommanded(vehicle) && all.found.add(vehicle.id().system())) {
                all.connection.found(
                        InetSocketAddress.createUnresolved(address, vehicle.id().system()));
            }
        }
        if (all.found.isEmpty() && atMs > all.untilMs) {
            several.remove(all);
            all.connection.end(whyNot("boat or copter", atMs));
        }
    }

    /** What is wrong with the link, such as that only MAVLink 1 is spoken on it. */
    private Optional<String> fault() {
        return base.links().stream().findFirst().flatMap(MavlinkLinkReport::fault);
    }

    private String whyNot(String what, long atMs) {
        Optional<MavlinkLinkReport> link = base.links().stream().findFirst();
        Optional<String> refusal = vehicles.stream()
                .filter(vehicle -> atMs - vehicle.heardMs() <= HEARD_MS)
                .flatMap(vehicle -> whyNot(vehicle).stream())
                .findFirst();
        if (fault().isPresent() || refusal.isPresent()) {
            return fault().or(() -> refusal).get();
        }
        String others = vehicles.stream()
                .filter(vehicle -> atMs - vehicle.heardMs() <= HEARD_MS)
                .map(vehicle -> vehicle.kind().word() + " " + vehicle.id())
                .collect(Collectors.joining(", "));
        String refused = link.map(MavlinkLinkReport::refused).orElse(Map.of()).entrySet().stream()
                .map(why -> "; refused " + why.getValue() + " messages "
                        + why.getKey().words())
                .sorted()
                .collect(Collectors.joining());
        boolean isSilent = link.filter(one -> one.bytes() > 0).isEmpty();
        String nothing = isSilent ? "; nothing came: is this the port on which it speaks MAVLink, and is it on?" : "";
        return "no " + what + " is heard there" + nothing + (others.isEmpty() ? "" : ", only " + others) + refused;
    }

    /** Whether a vehicle is still carrying out an order. */
    boolean isBusy() {
        return boats.values().stream().anyMatch(VehicleBoat::isBusy);
    }

    void close() {
        base.removeListener(events);
        base.close();
    }
}
