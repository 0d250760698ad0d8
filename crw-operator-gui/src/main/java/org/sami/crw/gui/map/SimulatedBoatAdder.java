package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.command.Command;

/** Adds simulated boats to the session, one at a time: to try a plan with more boats, or together with real ones. On the event thread. */
final class SimulatedBoatAdder {
    private static final double SPACING_M = 10;

    private final OperatorContext context;
    private final Supplier<GeoPoint> where;
    // boats that were added say where they are a little later
    private final Map<String, GeoPoint> awaited = new HashMap<>();
    private int last;

    /**
     * Adds nothing yet.
     *
     * @param where the next one is to lie
     */
    SimulatedBoatAdder(OperatorContext context, Supplier<GeoPoint> where) {
        this.context = context;
        this.where = where;
        context.models().fleet().addListener(this::seen);
    }

    private void seen(List<BoatSnapshot> boats) {
        boats.stream().filter(boat -> boat.pose().isPresent()).forEach(boat -> awaited.remove(boat.boat()));
    }

    /** The command that adds one. */
    Command command() {
        return new Command("boat-add-simulated", "Add a simulated boat", this::add)
                .withKey("ctrl shift I")
                .withIcon("plus");
    }

    private void add() {
        String name = nextName();
        GeoPoint at = free(where.get());
        awaited.put(name, at);
        CompletionStage<List<String>> added = context.session()
                .fleet()
                .addSimulated(name, at, 1)
                .whenComplete((done, fault) -> {
                    if (fault != null) {
                        awaited.remove(name);
                    }
                });
        context.tell(added, name + " is added in the middle of the map");
    }

    /** The requested place, or the first one east of it without a boat: boats on one spot are in each other's way. */
    private GeoPoint free(GeoPoint wanted) {
        List<GeoPoint> lying = new ArrayList<>(awaited.values());
        context.models().fleet().snapshot().stream()
                .flatMap(boat -> boat.pose().stream())
                .forEach(pose -> lying.add(pose.position()));
        GeoPoint place = wanted;
        while (isTaken(place, lying)) {
            place = Geodesy.offset(place, SPACING_M, 0);
        }
        return place;
    }

    private static boolean isTaken(GeoPoint place, List<GeoPoint> lying) {
        return lying.stream().anyMatch(other -> Geodesy.distanceM(place, other) < SPACING_M - 1);
    }

    /** The next of sim-1, sim-2 and so on that no boat has. */
    private String nextName() {
        String name;
        do {
            name = "sim-" + ++last;
        } while (context.models().fleet().boat(name).isPresent());
        return name;
    }
}
