package org.sami.crw.mavlink;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
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
import java.util.stream.Stream;
import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.base.MessagePlan;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.vehicle.CommandedVehicles;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * The MAVLink links of a session with the vehicles that are heard on them, and the base's connections to these. A vehicle on several links is one: the base is
 * told its address on the link on which it was found first. For the gateway's thread.
 */
final class VehicleLinks {
    private static final int EVERY_VEHICLE = 256; // port of an address without a number
    static final long HEARD_MS = 2_000; // a vehicle that was heard within it is there
    private static final int STATUS_TICKS = 10; // a second
    private static final long TRY_MS = 4_000;
    private static final long RECOGNIZED_MS = 8_000; // an autopilot without a number takes longer than one with it

    private final Executor thread;
    private final LongSupplier nowMs;
    private final VehicleFiles files;
    private final SeenTargets seen = new SeenTargets();
    private final MavlinkBase base;
    private final FleetKeyInUse key;
    private final Consumer<VehicleEvent> events = this::heard;
    private final Map<Integer, VehicleBoat> boats = new TreeMap<>(); // by system id
    private final Map<Integer, InetSocketAddress> homes = new HashMap<>(); // where the session reaches each
    private final List<Waiting> waiting = new ArrayList<>();
    private final List<Several> several = new ArrayList<>();
    private final Map<Integer, String> untold = new HashMap<>(); // by system id; for the next base
    private final NumberWait numbers = new NumberWait();
    private final BrokenLinks broken = new BrokenLinks();
    private final OpenedAddresses opened;
    private List<VehicleSnapshot> vehicles = List.of();
    private SessionFence fence = SessionFence.NONE; // that each vehicle is to hold
    private long ticks;
    private boolean asked; // for the vehicles, and not answered

    /** A connection to a vehicle that is not heard yet. */
    private record Waiting(VehicleConnection connection, long untilMs) {}

    /** A connection that asks for all vehicles, and those that were reported to it. */
    private record Several(VehicleConnection connection, Set<Integer> found, long untilMs) {}

    /**
     * No links yet.
     *
     * @param base has no links; closed with these
     * @param key with which it signs
     */
    VehicleLinks(MavlinkBase base, Executor thread, LongSupplier nowMs, VehicleFiles files, FleetKeyInUse key) {
        this.key = key;
        this.thread = thread;
        this.nowMs = nowMs;
        this.files = files;
        this.base = base;
        opened = new OpenedAddresses(base);
        base.addListener(events);
    }

    /** The fence that each vehicle is to hold by itself from now on. */
    void keepTo(SessionFence area) {
        fence = area;
        boats.values().forEach(boat -> boat.keepTo(area));
    }

    /**
     * Begins to reach the vehicle, or all, of a connection's address.
     *
     * @throws IllegalArgumentException where the address is none
     */
    void add(VehicleConnection connection, long now) {
        key.reread();
        opened.ask(named(connection), homes.containsValue(connection.address()), now);
        if (connection.address().getPort() == EVERY_VEHICLE) {
            several.add(new Several(connection, new TreeSet<>(), now + TRY_MS));
        } else {
            waiting.add(new Waiting(connection, now + TRY_MS));
        }
    }

    private static MavlinkAddress named(VehicleConnection connection) {
        return AddressText.parse(connection.address().getHostString());
    }

    /** The link to which a connection leads: that of its address, or the one that has taken its place. */
    private MavlinkAddress linkOf(VehicleConnection connection) {
        return opened.present(named(connection));
    }

    /** The address of a vehicle of a connection on the link to which that leads. */
    private InetSocketAddress addressOf(VehicleConnection connection, int system) {
        MavlinkAddress link = linkOf(connection);
        String text = link.equals(named(connection)) ? connection.address().getHostString() : link.toString();
        return InetSocketAddress.createUnresolved(text, system);
    }

    private boolean isWaited(MavlinkAddress link) {
        return Stream.concat(
                        waiting.stream().map(Waiting::connection),
                        several.stream().map(Several::connection))
                .anyMatch(connection -> linkOf(connection).equals(link));
    }

    /** Called on the thread of the MAVLink base. */
    private void heard(VehicleEvent event) {
        thread.execute(() -> Optional.ofNullable(boats.get(event.vehicle().system()))
                .filter(boat -> boat.is(event.vehicle()))
                .ifPresent(boat -> happened(boat, event)));
    }

    private void happened(VehicleBoat boat, VehicleEvent event) {
        if (event instanceof VehicleEvent.Replaced replaced) {
            replaced(boat, replaced.vehicle(), replaced.now());
        } else {
            boat.happened(event, nowMs.getAsLong());
        }
    }

    /** Another vehicle has the id: it is connected anew, with orders of its kind, or refused for what it is. */
    private void replaced(VehicleBoat boat, VehicleId id, VehicleKind now) {
        boats.remove(id.system());
        boat.replaced(now).ifPresent(words -> untold.put(id.system(), words));
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
        if (ticks++ % STATUS_TICKS == 0) {
            key.reread();
            opened.closeUnused(this::isWaited, nowMs.getAsLong());
            boats.forEach((system, boat) -> key.warning(system, boat.name()).ifPresent(boat::toldOfKey));
            Results.when(base.plans(), thread, plans -> tell(plans, nowMs.getAsLong()), why -> {});
        }
    }

    private void tell(Map<MavlinkAddress, MessagePlan> plans, long atMs) {
        List<MavlinkLinkReport> links = base.links();
        boats.values().forEach(boat -> boat.links(links, plans, atMs));
        links.forEach(link -> link.senders()
                .forEach((system, fault) -> Optional.ofNullable(boats.get(system))
                        .ifPresent(boat -> boat.toldOfSpeech(link.address(), fault))));
        for (MavlinkLinkReport link : broken.found(links)) {
            String why = link.fault().orElse("it cannot be opened");
            var unused =
                    boats.values().stream().anyMatch(boat -> boat.toldBroken(link.address(), why)); // one base has all
        }
    }

    private void take(List<VehicleSnapshot> now, long atMs) {
        vehicles = now;
        for (VehicleSnapshot vehicle : now) {
            if (isCommanded(vehicle)) {
                GuardedWork.run(() -> reported(vehicle, atMs));
            }
        }
        boats.values().forEach(boat -> GuardedWork.run(() -> boat.tick(atMs)));
        List.copyOf(waiting).forEach(one -> GuardedWork.run(() -> look(one, atMs)));
        List.copyOf(several).forEach(one -> GuardedWork.run(() -> look(one, atMs)));
    }

    private void reported(VehicleSnapshot vehicle, long atMs) {
        int system = vehicle.id().system();
        boolean isNumberSettled = numbers.isOver(vehicle, atMs); // at each report, so that a later wait begins anew
        if (isNumberSettled && !boats.containsKey(system)) {
            boats.put(system, boat(vehicle)); // not before: what is kept may be another vehicle's
        }
        Optional<VehicleBoat> known = Optional.ofNullable(boats.get(system)).filter(boat -> boat.is(vehicle.id()));
        if (known.filter(boat -> boat.isAnotherByLateNumber(vehicle)).isPresent()) {
            replaced(known.get(), vehicle.id(), vehicle.kind());
        } else {
            known.ifPresent(boat -> boat.reported(vehicle, atMs));
        }
    }

    private VehicleBoat boat(VehicleSnapshot vehicle) {
        VehicleBoat boat = new VehicleBoat(base, vehicle, thread, files, seen);
        boat.keepTo(fence);
        return boat;
    }

    private static boolean isCommanded(VehicleSnapshot vehicle) {
        return CommandedVehicles.whyNot(vehicle).isEmpty();
    }

    private void look(Waiting one, long atMs) {
        if (one.connection.isOver()) {
            waiting.remove(one);
            return;
        }
        MavlinkAddress link = linkOf(one.connection);
        int system = one.connection.address().getPort();
        Optional<VehicleSnapshot> heard = vehicle(system).filter(known -> isReachedBy(one.connection, known, atMs));
        Optional<VehicleBoat> boat = heard.map(vehicle -> boats.get(system));
        Optional<String> refusal = heard.flatMap(CommandedVehicles::whyNot);
        if (refusal.isPresent()) {
            waiting.remove(one);
            one.connection.refuse(refusal.get());
        } else if (boat.isPresent() && !home(one.connection).equals(one.connection.address())) {
            waiting.remove(one);
            one.connection.found(home(one.connection));
        } else if (boat.filter(VehicleBoat::isKnown).isPresent()
                && numbers.isOver(heard.get(), atMs) // else it may be another one since it was silent
                && fault(heard.get().links().get(0), system).isEmpty()) {
            waiting.remove(one);
            homes.put(system, one.connection.address());
            boat.get().connect(one.connection, atMs);
            Optional.ofNullable(untold.remove(system)).ifPresent(boat.get()::urgent);
        } else if (atMs
                        > one.untilMs
                                + (vehicle(system).isPresent() && (heard.isEmpty() || boat.isEmpty())
                                        ? RECOGNIZED_MS
                                        : 0)
                || isOther(system, link)) {
            waiting.remove(one);
            endUnreached(one.connection, Optional.of(system), atMs);
        }
    }

    /** Where the session reaches the vehicle of a connection: where it was found first. */
    private InetSocketAddress home(VehicleConnection connection) {
        int system = connection.address().getPort();
        return Optional.ofNullable(homes.get(system)).orElseGet(() -> addressOf(connection, system));
    }

    private Optional<VehicleSnapshot> vehicle(int system) {
        return vehicles.stream()
                .filter(vehicle -> vehicle.id().system() == system)
                .findFirst();
    }

    /** Whether a connection leads to a vehicle: it is heard on the link that it names, or anywhere where the session has found it on that link before. */
    private boolean isReachedBy(VehicleConnection connection, VehicleSnapshot vehicle, long atMs) {
        MavlinkAddress link = linkOf(connection);
        boolean isHome = connection.address().equals(homes.get(vehicle.id().system()));
        return vehicle.heardOn().stream()
                .anyMatch(heard -> (isHome || heard.link().equals(link)) && atMs - heard.heardMs() <= HEARD_MS);
    }

    private boolean isOther(int system, MavlinkAddress link) {
        return vehicle(system).filter(known -> known.others().contains(link)).isPresent();
    }

    private void look(Several all, long atMs) {
        if (all.connection.isOver() && all.found.isEmpty()) {
            several.remove(all);
            return;
        }
        MavlinkAddress link = linkOf(all.connection);
        for (VehicleSnapshot vehicle : vehicles) {
            int system = vehicle.id().system();
            if (isCommanded(vehicle) && vehicle.links().contains(link) && all.found.add(system)) {
                all.connection.found(homes.computeIfAbsent(system, first -> addressOf(all.connection, first)));
            }
        }
        boolean isOpen =
                vehicles.stream().anyMatch(vehicle -> vehicle.unsettled().contains(link));
        if (all.found.isEmpty() && atMs > all.untilMs + (isOpen ? RECOGNIZED_MS : 0)) {
            several.remove(all);
            endUnreached(all.connection, Optional.empty(), atMs);
        }
    }

    private Optional<MavlinkLinkReport> report(MavlinkAddress link) {
        return base.links().stream().filter(one -> one.address().equals(link)).findFirst();
    }

    /** What is wrong with a link, such as that only MAVLink 1 is spoken on it. */
    private Optional<String> fault(MavlinkAddress link) {
        return report(link).flatMap(MavlinkLinkReport::fault);
    }

    /** What is wrong with a link, or with how a vehicle speaks on it, so that it cannot be commanded. */
    private Optional<String> fault(MavlinkAddress link, int system) {
        return fault(link)
                .or(() -> report(link)
                        .map(one -> one.senders().get(system))
                        .filter(fault -> !fault.isCommanded())
                        .map(fault -> "vehicle " + system + " " + fault.words()));
    }

    /**
     * Ends a connection for which its link brought no vehicle.
     *
     * @param asked the system id of the vehicle; empty where any was asked for
     */
    private void endUnreached(VehicleConnection connection, Optional<Integer> asked, long atMs) {
        MavlinkAddress link = linkOf(connection);
        List<VehicleSnapshot> there = vehicles.stream()
                .filter(vehicle -> vehicle.heardOn().stream()
                        .anyMatch(on -> on.link().equals(link) && atMs - on.heardMs() <= HEARD_MS))
                .toList();
        Optional<String> refusal = there.stream()
                .filter(vehicle -> asked.isEmpty() || isAsked(asked, vehicle))
                .flatMap(vehicle -> CommandedVehicles.whyNot(vehicle).stream())
                .findFirst()
                .or(() -> another(link));
        Optional<String> fault = asked.map(system -> fault(link, system)).orElseGet(() -> fault(link));
        boolean isSilent = report(link).filter(one -> one.bytes() > 0).isEmpty();
        if (fault.isPresent() && isSilent) {
            connection.end(fault.get());
        } else if (fault.isPresent() || refusal.isPresent()) {
            connection.refuse(fault.or(() -> refusal).get());
        } else {
            connection.end(whyNot(asked, link, there, isSilent));
        }
    }

    private String whyNot(
            Optional<Integer> asked, MavlinkAddress address, List<VehicleSnapshot> there, boolean isSilent) {
        Optional<MavlinkLinkReport> link = report(address);
        String others = there.stream()
                .map(vehicle -> KindWords.of(vehicle.kind()) + " " + vehicle.id())
                .collect(Collectors.joining(", "));
        String refused = link.map(MavlinkLinkReport::refused).orElse(Map.of()).entrySet().stream()
                .map(why -> "; refused " + why.getValue() + " messages "
                        + why.getKey().words())
                .sorted()
                .collect(Collectors.joining());
        String speech = link.map(MavlinkLinkReport::senders).orElse(Map.of()).entrySet().stream()
                .map(one -> "; vehicle " + one.getKey() + " " + one.getValue().words())
                .sorted()
                .collect(Collectors.joining());
        String nothing = isSilent ? "; nothing came: is this the port on which it speaks MAVLink, and is it on?" : "";
        String what = asked.map(system -> "vehicle " + system).orElse(RobotKind.SURFACE_BOAT + " or copter");
        boolean isThere = there.stream().anyMatch(vehicle -> isAsked(asked, vehicle));
        return (isThere
                        ? what + " is heard there, but has not yet answered what it is asked: it is linked once it has"
                        : "no " + what + " is heard there" + nothing + (others.isEmpty() ? "" : ", only " + others))
                + refused
                + speech;
    }

    private static boolean isAsked(Optional<Integer> asked, VehicleSnapshot vehicle) {
        return asked.filter(system -> system == vehicle.id().system()).isPresent();
    }

    private Optional<String> another(MavlinkAddress link) {
        return vehicles.stream()
                .filter(vehicle -> vehicle.others().contains(link))
                .findFirst()
                .map(vehicle -> "the vehicle there has the id " + vehicle.id() + ", as another one on "
                        + vehicle.links().get(0) + ": give each vehicle a system id of its own");
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
