package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.command.Command;

/** Adds simulated boats to the session, one at a time: to try a plan with more boats, or beside real ones. On the event thread. */
final class SimulatedBoatAdder {
    private static final double APART_M = 10;

    private final OperatorContext context;
    private final Supplier<GeoPoint> where;
    private final List<GeoPoint> taken = new ArrayList<>(); // boats that were added say where they are a little later
    private int last;

    /**
     * Adds nothing yet.
     *
     * @param where the next one is to lie
     */
    SimulatedBoatAdder(OperatorContext context, Supplier<GeoPoint> where) {
        this.context = context;
        this.where = where;
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
        taken.add(at);
        context.tell(context.session().fleet().addSimulated(name, at, 1), name + " is added in the middle of the map");
    }

    /** The place that is wanted, or east of it the first at which no boat lies or was added: boats on one spot are in each other's way. */
    private GeoPoint free(GeoPoint wanted) {
        List<GeoPoint> lying = new ArrayList<>(taken);
        context.models().fleet().snapshot().stream()
                .flatMap(boat -> boat.pose().stream())
                .forEach(pose -> lying.add(pose.position()));
        GeoPoint place = wanted;
        while (isTaken(place, lying)) {
            place = Geodesy.offset(place, APART_M, 0);
        }
        return place;
    }

    private static boolean isTaken(GeoPoint place, List<GeoPoint> lying) {
        return lying.stream().anyMatch(other -> Geodesy.distanceM(place, other) < APART_M - 1);
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
