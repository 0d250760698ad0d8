package org.sami.crw.gui.map;

import java.util.function.Supplier;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.command.Command;

/** Adds simulated boats to the session, one at a time: to try a plan with more boats, or beside real ones. On the event thread. */
final class SimulatedBoatAdder {
    private final OperatorContext context;
    private final Supplier<GeoPoint> where;
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
        context.tell(
                context.session().fleet().addSimulated(name, where.get(), 1),
                name + " is added in the middle of the map");
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
