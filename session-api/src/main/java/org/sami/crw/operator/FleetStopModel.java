package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.NaturalOrder;

/** How the fleet stop stands: what this base had done, and what boats say of themselves, whoever stopped them. */
public final class FleetStopModel extends Model<FleetStopState> {
    private final Consumer<Runnable> inbox;
    private final LongSupplier nowMillis;
    private final Map<String, StopLatch> boats = new TreeMap<>(NaturalOrder.INSTANCE);
    private final Set<String> moving = new HashSet<>(); // though they are stopped
    private List<String> unreached = List.of();
    private boolean everyBoat;
    private long sinceMillis;

    FleetStopModel(Consumer<Runnable> inbox, LongSupplier nowMillis) {
        super(FleetStopState.NONE);
        this.inbox = inbox;
        this.nowMillis = nowMillis;
    }

    /** This base stopped the whole fleet, or released it. From any thread. */
    public void commanded(boolean stop) {
        inbox.accept(() -> {
            everyBoat = stop;
            change();
        });
    }

    // ---- on the owner's thread

    void seen(BoatSnapshot boat) {
        boolean moves = boat.stop().where() == StopLatch.Where.OVERRIDDEN
                && boat.speedMps().orElse(0) > FleetStopState.MOVES_MPS;
        boolean another = moves ? moving.add(boat.boat()) : moving.remove(boat.boat());
        if (!boat.stop().equals(boats.put(boat.boat(), boat.stop())) || another) {
            change();
        }
    }

    void unreached(List<UnreachedBoat> now) {
        unreached = now.stream().map(UnreachedBoat::name).toList();
        change();
    }

    void gone(String boat) {
        boats.remove(boat);
        moving.remove(boat);
        change();
    }

    /** Forgets all. */
    void clear() {
        boats.clear();
        moving.clear();
        unreached = List.of();
        everyBoat = false;
        change();
    }

    /** A fault while it lasts: operators must see first that no boat moves. */
    static void report(FleetStopState state, HealthModel health) {
        if (state.isLatched()) {
            health.report(HealthFault.ofSession(
                            HealthKind.FLEET_STOP,
                            state.isOfFleet() || !state.overridden().isEmpty() ? Priority.CRITICAL : Priority.HIGH,
                            state.words(),
                            state.advice())
                    .withDetails(state.details()));
        } else {
            health.over(HealthKind.FLEET_STOP, "");
        }
    }

    @Override
    FleetStopState take() {
        List<String> here = of(StopLatch.Where.HERE);
        List<String> elsewhere = of(StopLatch.Where.ELSEWHERE);
        Map<String, String> by = new TreeMap<>(NaturalOrder.INSTANCE);
        elsewhere.forEach(boat ->
                by.put(boat, Objects.requireNonNull(boats.get(boat), boat).by()));
        by.values().removeIf(String::isEmpty);
        Map<String, String> overridden = overridden();
        boolean latched = everyBoat || !here.isEmpty() || !elsewhere.isEmpty() || !overridden.isEmpty();
        if (!latched) {
            sinceMillis = 0;
        } else if (sinceMillis == 0) {
            sinceMillis = Math.max(1, nowMillis.getAsLong());
        }
        return latched
                ? new FleetStopState(
                        everyBoat,
                        here,
                        elsewhere,
                        by,
                        overridden,
                        of(StopLatch.Where.NOWHERE),
                        neverAnswered(),
                        sinceMillis)
                : FleetStopState.NONE;
    }

    private Map<String, String> overridden() {
        Map<String, String> words = new TreeMap<>(NaturalOrder.INSTANCE);
        boats.forEach((boat, stop) -> {
            if (stop.where() == StopLatch.Where.OVERRIDDEN) {
                words.put(boat, "is armed by " + stop.by() + (moving.contains(boat) ? ", and moves" : ""));
            }
        });
        return words;
    }

    private List<String> neverAnswered() {
        return unreached.stream().filter(name -> !boats.containsKey(name)).toList();
    }

    private List<String> of(StopLatch.Where where) {
        List<String> found = new ArrayList<>();
        boats.forEach((boat, stop) -> {
            if (stop.where() == where) {
                found.add(boat);
            }
        });
        return found;
    }
}
