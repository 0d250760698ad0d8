package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.function.IntPredicate;
import org.sami.petri.net.PetriNet;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNetPlace;
import org.sami.spn.planspace.PlanStateWords;
import org.sami.spn.planspace.StateWords;

/**
 * A net whose graph is to be drawn.
 *
 * @param title of the picture
 * @param isDrawn whether a place is drawn in the picture of the net itself: of a plan those that stand for something of it
 * @param remarks where the net is not exactly the plan that it stands for
 */
record DrawnNet(PetriNet net, String title, StateWords words, IntPredicate isDrawn, List<String> remarks) {
    /** A net of a file or an example. */
    static DrawnNet of(PetriNet net, String name) {
        return new DrawnNet(
                net, net.name().isEmpty() ? name : net.name(), new NetStateWords(net), place -> true, List.of());
    }

    /** The net of a plan. */
    static DrawnNet of(PlanArgument plan) {
        return new DrawnNet(
                plan.net().net(),
                plan.title(),
                new PlanStateWords(plan.net()),
                place -> plan.net().place(place).role() != PlanNetPlace.Role.CONTROL,
                plan.net().abstractions().stream().map(Abstraction::words).toList());
    }
}
